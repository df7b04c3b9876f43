"""The bundled robot and others with the defaults alone: `python benchmarks/robots.py FOLDER... --page docs/robots.md`.

A FOLDER holds a `robot.json`. Each robot walks 60 s at three Froude speeds v / sqrt(g z_c), each reached from a stand
in 3 s, and through a profile that speeds up and slows down between them. Prints a table of all cycles; `--page` writes
that page's part for this MuJoCo.
"""

import argparse
from pathlib import Path

import mujoco
import numpy as np
import zmpwalk
from pages import write_blocks
from rich.console import Console
from rich.progress import track
from zmpwalk import analysis

FROUDE, RAMP, DURATION = (0.03, 0.06, 0.0935), 3.0, 60.0  # speeds; to reach them [s]; of each walk [s]
UP_AND_DOWN = ((0.0, 0.0), (3.0, 0.03), (12.0, 0.03), (15.0, 0.0935), (27.0, 0.0935), (30.0, 0.06), (39.0, 0.06),
               (42.0, 0.0935), (48.0, 0.0935), (52.0, 0.03))  # time [s], Froude speed  # fmt: skip
HEADER = (
    "robot", "Froude speed", "v, m/s", "result", "speed per period, worst %", "largest torque, %",
    "single support, median mm", "p95 mm", "limit of p95", "all cycles, median mm", "p95 mm", "cycle, µs",
)  # fmt: skip


def profiles(speed):
    """(label, profile) of a robot for which Froude number 1 is `speed` [m/s]."""
    for froude in FROUDE:
        yield f"{froude:g}", zmpwalk.VelocityProfile.ramp(0.0, froude * speed, RAMP)
    t, froude = np.array(UP_AND_DOWN).T
    yield "up and down", zmpwalk.VelocityProfile(t, np.outer(froude * speed, (1, 0, 0)), "linear")


def measure(model, description, profile, duration=DURATION):
    """One walk's numbers: fell (time [s] or None), speed_percent (worst period, of the plan, from the sixth on), torque
    [%], single_median, single_p95, all_median, all_p95 (estimated ZMP against contact forces, x and y [mm]), limit [mm]
    of single_p95, cycle_us."""
    trace = zmpwalk.simulate((model, description), profile, duration)
    summary = trace.summary()
    walked, planned = (np.array(summary[f"{kind}_speed_per_step"])[5:] for kind in ("mean", "planned"))
    # Ankle dry friction that the tanh does not know sets a floor: friction / (m g).
    ankles = [
        model.joint(name).dofadr[0] for foot in (description.left, description.right) for name in foot.leg_joints[4:]
    ]
    weight = float(np.linalg.norm(model.opt.gravity) * np.sum(model.body_mass))
    errors = {"single": analysis.zmp_error(trace, single_support=True), "all": analysis.zmp_error(trace)}
    return {
        "fell": summary["fall_time"] if summary["fell"] else None,
        "speed_percent": float(100 * np.abs(walked / planned - 1).max()),
        "torque": float(100 * trace.torque_ratio.max()),
        "limit": 1e3
        * (1e-3 * description.left.length / 0.25 + 1.5 * float(model.dof_frictionloss[ankles].max()) / weight),
        "cycle_us": float(summary["cycle_us"]["median"]),
        **{f"{kind}_median": 1e3 * np.median(error, axis=0) for kind, error in errors.items()},
        **{f"{kind}_p95": 1e3 * np.percentile(error, 95, axis=0) for kind, error in errors.items()},
    }


def rows(robots):
    """Cells of the table, one walk after the other."""
    for robot in robots:
        model, description = zmpwalk.load_robot(robot)
        still = zmpwalk.WalkingController(model, description, profile=zmpwalk.VelocityProfile.constant(0.0))
        speed = float(np.sqrt(np.linalg.norm(model.opt.gravity) * still.com_height))
        for label, profile in profiles(speed):
            m = measure(model, description, profile)
            pairs = {key: f"{m[key][0]:.3g} / {m[key][1]:.3g}" for key in m if key.endswith(("median", "p95"))}
            result = "stands" if m["fell"] is None else f"falls at {m['fell']:.1f} s"
            yield (
                description.name, label, f"{np.max(profile.v):.3f}", result, f"{m['speed_percent']:.2f}",
                f"{m['torque']:.0f}", pairs["single_median"], pairs["single_p95"], f"{m['limit']:.2f}",
                pairs["all_median"], pairs["all_p95"], f"{m['cycle_us']:.1f}",
            )  # fmt: skip


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="*", type=Path, help="folders with a robot.json")
    parser.add_argument("--page", type=Path, metavar="FILE", help="update that page")
    args = parser.parse_args()
    robots = ["mahru", *(str(folder / "robot.json") for folder in args.folders)]
    total = len(robots) * (len(FROUDE) + 1)
    table = list(track(rows(robots), "walking", total=total, console=Console(stderr=True)))
    lines = [f"MuJoCo {mujoco.__version__}; pairs are x / y.", ""]
    lines += ["| " + " | ".join(cells) + " |" for cells in (HEADER, ("---",) * len(HEADER), *table)]
    if args.page:
        write_blocks(args.page, {f"MuJoCo {mujoco.__version__[0]}": lines})
    print("\n".join(lines))


if __name__ == "__main__":
    main()
