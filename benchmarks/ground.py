"""What ground the default walk bears, mostly without being told of it.

`python benchmarks/ground.py --page docs/ground.md`.

Each row of the table walks at 0.25 m/s over one kind of ground in all its seeds, azimuths or places. Folders may
follow, each with a `robot.json` whose robot walks slopes of 3° and blocks of
2 % of its COM's height at Froude number 0.055. `--page` writes that page's part
for this MuJoCo. All of it takes some minutes on two cores.
"""

import argparse
import math
import sys
from pathlib import Path

import mujoco
import zmpwalk
from pages import write_blocks

SPEED = 0.25  # of the bundled robot [m/s]
FROUDE = 0.055  # speed over sqrt(g z_c) of the others
AZIMUTHS = range(0, 360, 45)  # [deg]
PLACES = [round(1.0 + 0.05 * i, 2) for i in range(9)]  # of a single step along the way [m]


def rows(blocks, plates):
    """(what the ground is, its runs): `blocks` and `plates` are how many seeds."""
    slippery = {"uncertainty": {"ground_friction": 0.3}}
    yield "slopes of 5°, 8 azimuths", runs(30, [f"slope:5,{a}" for a in AZIMUTHS])
    yield "slopes of 7°, 8 azimuths", runs(30, [f"slope:7,{a}" for a in AZIMUTHS])
    yield "standing on slopes of 10°, 8 azimuths", runs(10, [f"slope:10,{a}" for a in AZIMUTHS], profile=0.0)
    for cm in (2, -2, 3, -3):
        way = "up" if cm > 0 else "down"
        yield f"a step of {abs(cm)} cm {way}, 9 places", runs(10, [f"step:{cm},{x}" for x in PLACES])
    yield "blocks of up to 2 cm, by seed", runs(30, [f"blocks:2,{seed}" for seed in range(blocks)])
    yield "plates tilted by up to 3°, by seed", runs(30, [f"plates:3,{seed}" for seed in range(plates)])
    yield "blocks of up to 1 cm, friction 0.3", runs(30, ["blocks:1,0", "blocks:1,1"], **slippery)
    yield "soft ground, time constant 0.02 s", runs(30, ["soft:0.02"])
    yield "waves of 1 m that rise 3 cm", runs(30, ["waves:3"])
    for feet in ("one foot", "both feet"):
        for friction in (0.1,) if feet == "one foot" else (0.1, 0.15):
            patches = [ice(0.5 + 0.035 * i, friction, feet) for i in range(9)]
            what = f"with `feel_slip`: 0.5 m of ice, friction {friction}, under {feet}, 9 places, 0.15 m/s"
            yield what, runs(10, patches, 0.15, settings={"feel_slip": True})
    stairs = [shifted("stairs:12x28", 0.028 * i) for i in range(10)]
    yield "known: stairs of 12 × 28 cm up and down, 10 starts", runs(22, stairs, known=True)
    slopes = [f"slope:15,{a}" for a in AZIMUTHS]
    yield "known: slopes of 15°, 8 azimuths", runs(30, slopes, known=True)


def ice(begin, friction, feet):
    """Slippery ground from `begin` on for half a metre, under the left foot or both [m]."""
    everywhere, patch = (-20.0, 20.0), (begin, begin + 0.5)
    patches = [zmpwalk.Patch((-3.0, begin), everywhere), zmpwalk.Patch((patch[1], 40.0), everywhere)]
    if feet == "one foot":
        patches += [zmpwalk.Patch(patch, (0.0, 20.0), friction=friction), zmpwalk.Patch(patch, (-20.0, 0.0))]
    else:
        patches.append(zmpwalk.Patch(patch, everywhere, friction=friction))
    return zmpwalk.Terrain(f"ice:{begin:g}", patches)


def shifted(terrain, by):
    """The same ground, by so much further ahead [m]."""
    ground = zmpwalk.Terrain.of(terrain)
    patches = [p._replace(x=(p.x[0] + by, p.x[1] + by)) for p in ground.patches]
    return zmpwalk.Terrain(f"{ground.text}+{by:g}", patches)


def runs(duration, terrains, profile=SPEED, **more):
    """Arguments of the walks over `terrains`."""
    return [{"terrain": each, "duration": duration, "profile": profile, **more} for each in terrains]


def others(folders):
    """The same of other robots: slopes of 3°, and blocks of 2 % of the COM's height."""
    for folder in folders:
        robot = str(folder / "robot.json")
        still = zmpwalk.WalkingController(*zmpwalk.load_robot(robot), profile=0.0)
        speed = round(FROUDE * math.sqrt(9.81 * still.com_height), 3)
        walk = {"profile": zmpwalk.VelocityProfile.ramp(0.0, speed, 2.0), "robot": robot}
        name = f"{still.description.name}, {speed:g} m/s"
        yield f"{name}, slopes of 3°, 8 azimuths", runs(20, [f"slope:3,{a}" for a in AZIMUTHS], **walk)
        cm = round(2.0 * still.com_height, 1)
        yield f"{name}, blocks of up to {cm:g} cm, by seed", runs(20, [f"blocks:{cm:g},{i}" for i in range(8)], **walk)


def line(what, walks):
    """One line of the table: the ground, how many stood to the end, and which fell when."""
    traces = zmpwalk.simulate_batch(walks)
    fell = [f"{t.meta['terrain']} ({t.meta['fall_time']:.1f} s)" for t in traces if t.meta["fell"]]
    print(f"{what}: {len(walks) - len(fell)} of {len(walks)}", file=sys.stderr)
    return f"| {what} | {walks[0]['duration']} | {len(walks) - len(fell)} of {len(walks)} | {', '.join(fell) or '-'} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="*", type=Path, help="folders with a robot.json")
    parser.add_argument("--blocks", type=int, default=20, help="seeds of the blocks")
    parser.add_argument("--plates", type=int, default=10, help="seeds of the plates")
    parser.add_argument("--page", type=Path, metavar="FILE", help="update that page")
    args = parser.parse_args()
    lines = [f"MuJoCo {mujoco.__version__}, default settings.", ""]
    lines += ["| ground | s | stood | fell |", "| --- | --- | --- | --- |"]
    lines += [line(*row) for row in (*rows(args.blocks, args.plates), *others(args.folders))]
    if args.page:
        write_blocks(args.page, {f"MuJoCo {mujoco.__version__[0]}": lines})
    print("\n".join(lines))


if __name__ == "__main__":
    main()
