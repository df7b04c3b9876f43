"""A long walk with random commands and pushes: `python benchmarks/soak.py --hours 1`, or `make soak`.

Each 1.5 to 4 s another velocity is commanded; every 5 s a push of 0.08 s hits the trunk from any side. After each
minute of simulated time the script prints the median time of a control cycle and the memory of the process. It ends
with what both did over the walk, and with exit code 1 where the robot fell.
"""

import argparse
import resource
import sys
import time

import mujoco
import numpy as np
import zmpwalk
from zmpwalk._core import trunk_body

PUSH = 0.08  # length of a push [s]
MINUTE = 60.0


def memory() -> float:
    """Memory of this process now [MB]."""
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * resource.getpagesize() / 1e6


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--robot", default="mahru")
    parser.add_argument("--hours", type=float, default=1.0, help="of simulated time")
    parser.add_argument("--impulse", type=float, default=0.1, help="of a push [N s/kg]")
    parser.add_argument("--forward", type=float, default=0.4, help="largest forward speed [m/s]")
    parser.add_argument("--sideways", type=float, default=0.1, help="largest sideways speed [m/s]")
    parser.add_argument("--turning", type=float, default=0.3, help="largest turning speed [rad/s]")
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    random = np.random.default_rng(args.seed)
    model, description = zmpwalk.load_robot(args.robot)
    controller = zmpwalk.WalkingController(model, description, profile=0.0)
    data = mujoco.MjData(model)
    description.place(model, data)
    controller.reset(data)
    trunk = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, trunk_body(controller))
    mass = model.body_subtreemass[model.body_rootid[trunk]]

    next_command, next_push = 1.0, 5.0
    end_of_push, cycles, medians, memories = 0.0, [], [], []
    for minute in range(1, 1 + round(60 * args.hours)):
        cycles.clear()
        while data.time < MINUTE * minute:
            if data.time >= next_command:
                most = np.array([args.forward, args.sideways, args.turning])
                controller.command(*(most * random.uniform((-0.3, -1, -1), 1)))
                next_command += random.uniform(1.5, 4.0)
            if data.time >= next_push:
                angle = random.uniform(0, 2 * np.pi)
                data.xfrc_applied[trunk, :2] = mass * args.impulse / PUSH * np.array([np.cos(angle), np.sin(angle)])
                end_of_push, next_push = data.time + PUSH, next_push + 5.0
            elif data.time >= end_of_push:
                data.xfrc_applied[trunk] = 0.0
            began = time.perf_counter_ns()
            out = controller.update(data)
            cycles.append(time.perf_counter_ns() - began)
            if out.fell:
                print(f"\nfell at {data.time:.3f} s: {out.fell}")
                return 1
            mujoco.mj_step(model, data)
        medians.append(np.median(cycles) / 1e3)
        memories.append(memory())
        print(f"\r{minute} min: cycle {medians[-1]:.1f} us, {memories[-1]:.0f} MB ", end="", flush=True)
    print(f"\nstood {args.hours:g} h; cycle {medians[0]:.1f} us in the first minute, {medians[-1]:.1f} in the last; "
          f"memory {memories[0]:.1f} and {memories[-1]:.1f} MB")  # fmt: skip
    return 0


if __name__ == "__main__":
    sys.exit(main())
