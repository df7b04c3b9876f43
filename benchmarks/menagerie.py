"""Which humanoids of MuJoCo Menagerie walk: `python benchmarks/menagerie.py [NAME...]`, Python 3.11 or later.

Needs the package mujoco-menagerie (`pip install mujoco-menagerie`) and its downloads, or a checkout in MENAGERIE_ROOT.
Each robot is described by `zmpwalk.robots` and walks with the defaults. Prints the table of docs/menagerie.md.
"""

import argparse

import mujoco
import numpy as np
import zmpwalk
from zmpwalk.robots import examine
from zmpwalk.robots.menagerie import PREFIX, menagerie_humanoids

FROUDE = 0.06
RAMP = 3.0  # to full speed [s]


def verdict(name, duration):
    """Walks, stands or cannot; and why."""
    try:
        model, proposal = examine(PREFIX + name)
        robot = model, proposal.description
        speed = FROUDE * np.sqrt(9.81 * proposal.table["com_height_m"])
        trace = zmpwalk.simulate(robot, zmpwalk.VelocityProfile.ramp(0.0, speed, RAMP), duration)
        remarks = "; ".join(proposal.remarks)
        if not trace.meta["fell"]:
            return f"walks {duration:g} s at {speed:.3f} m/s, {100 * trace.torque_ratio.max():.0f} % torque", remarks
        why = f"falls at {trace.meta['fall_time']:.1f} s, {trace.meta['fall_cause']}; {remarks}"
        still = zmpwalk.simulate(robot, zmpwalk.VelocityProfile.constant(0.0), duration)
        return ("cannot" if still.meta["fell"] else f"stands {duration:g} s", why)
    except zmpwalk.ModelError as error:
        return "cannot", "; ".join(error.reasons)
    except zmpwalk.InputError as error:
        return "not to be had here", str(error)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("name", nargs="*", help="of Menagerie's robots; all humanoids if none is given")
    parser.add_argument("--duration", type=float, default=20.0, help="of each walk [s]")
    options = parser.parse_args()
    print(f"MuJoCo {mujoco.__version__}\n\n| robot | what it does | why, or what is unsure |\n|---|---|---|")
    for name in options.name or menagerie_humanoids():
        print("| " + " | ".join([name, *verdict(name, options.duration)]) + " |", flush=True)


if __name__ == "__main__":
    main()
