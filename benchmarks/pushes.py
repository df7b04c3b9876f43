"""Push maps of the bundled robot and others: `python benchmarks/pushes.py FOLDER... --page docs/pushes.md`.

The bundled robot is pushed at three speeds and while it stands; each FOLDER holds a `robot.json`, and its robot is
pushed at Froude number 0.08. Prints the worst of every direction; `--page` writes that page's part for this MuJoCo, and
`--figure` the bundled robot's polar figure at 0.25 m/s. All of it takes most of an hour on two cores.
"""

import argparse
import sys
from pathlib import Path

import mujoco
import numpy as np
import zmpwalk
from pages import write_blocks

SPEEDS = (0.25, 0.6, 1.0, 0.0)  # of the bundled robot [m/s]
FROUDE = 0.08  # speed over sqrt(g z_c) of the others


def maps(folders, directions, phases):
    """One push map after the other."""
    for speed in SPEEDS:
        yield push("mahru", speed, directions, phases)
    for folder in folders:
        robot = str(folder / "robot.json")
        still = zmpwalk.WalkingController(*zmpwalk.load_robot(robot), profile=0.0)
        speed = round(FROUDE * float(np.sqrt(9.81 * still.com_height)), 3)
        yield push(robot, speed, directions, phases)


def push(robot, speed, directions, phases):
    """The push map of one robot at one speed [m/s]; both stances where a robot walks."""

    def at(done, total):
        print(f"\r{robot} at {speed:g} m/s: {done:.0f} of {total:.0f} ", end="", file=sys.stderr, flush=True)

    found = zmpwalk.push_map(robot, speed, directions, phases, on_progress=at)
    print(f"in {found.wall_time:.0f} s", file=sys.stderr)
    return found


def row(found):
    """Cells of the table: robot, speed, worst of every direction, worst, mean, share of the pendulum's limit."""
    worst = found.by_direction()
    share = np.nanmin(found.felling / found.pendulum[None])
    cells = [found.robot, f"{found.velocity[0]:g}"]
    cells += [f"> {found.limit:g}" if np.isinf(value) else f"{value:.2f}" for value in worst]
    return [*cells, f"**{found.worst:.2f}**", f"{found.mean:.2f}", f"{100 * share:.0f} %"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="*", type=Path, help="folders with a robot.json")
    parser.add_argument("--directions", type=int, default=12)
    parser.add_argument("--phases", type=int, default=8)
    parser.add_argument("--page", type=Path, metavar="FILE", help="update that page")
    parser.add_argument("--figure", type=Path, metavar="FILE", help="draw the first map")
    args = parser.parse_args()
    found = list(maps(args.folders, args.directions, args.phases))
    header = ["robot", "m/s", *(f"{d:.0f}°" for d in found[0].directions), "worst", "mean", "least share of the limit"]
    lines = [f"MuJoCo {mujoco.__version__}; N s/kg, the worst over {args.phases} phases and both stances.", ""]
    lines += ["| " + " | ".join(cells) + " |" for cells in (header, ["---"] * len(header), *map(row, found))]
    if args.page:
        write_blocks(args.page, {f"MuJoCo {mujoco.__version__[0]}": lines})
    if args.figure:
        found[0].plot().savefig(args.figure)
    print("\n".join(lines))


if __name__ == "__main__":
    main()
