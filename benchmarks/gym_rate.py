"""How many walks the vector environment walks beside `simulate_batch`: `python benchmarks/gym_rate.py`.

Both walk the same commands on all cores: four walks for each core, each of some seconds. They take turns, and
the ratio of their times in each turn is what counts; the table gives the median and the range of the turns.
"""

import argparse
import time

import gymnasium
import numpy as np
import zmpwalk
import zmpwalk.gym


def batch(walks, seconds, command):
    """Seconds that `simulate_batch` takes."""
    runs = [{"profile": 0.0, "command": lambda t, out: command, "duration": seconds} for _ in range(walks)]
    start = time.perf_counter()
    zmpwalk.simulate_batch(runs)
    return time.perf_counter() - start


def vector(envs, seconds, command):
    """Seconds that the vector environment takes for the same walks."""
    walk = envs.envs[0]
    actions = np.tile(np.array(command) / walk.reach, (envs.num_envs, 1))
    start = time.perf_counter()
    envs.reset(seed=0)
    for _ in range(round(seconds / walk.period)):
        envs.step(actions)
    return time.perf_counter() - start


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seconds", type=float, default=10.0, help="of each walk")
    parser.add_argument("--walks", type=int, default=4, help="for each core")
    parser.add_argument("--turns", type=int, default=7)
    options = parser.parse_args()
    cores, command = zmpwalk.simulation.processors(), (0.25, 0.0, 0.0)
    walks = options.walks * cores
    envs = gymnasium.make_vec(zmpwalk.gym.ID, num_envs=walks, duration=options.seconds + 1.0)
    ratios, rates = [], []
    for _ in range(options.turns):
        together = vector(envs, options.seconds, command)
        ratios.append(batch(walks, options.seconds, command) / together)
        rates.append(walks * options.seconds / together / cores)
    envs.close()
    low, middle, high = np.quantile(ratios, (0.0, 0.5, 1.0))
    print(f"{walks} walks of {options.seconds:g} s on {cores} cores, {options.turns} turns")
    print(f"vector environment: {np.median(rates):.1f} s of walking in a second of one core")
    print(f"beside simulate_batch: {middle:.2f} times as many ({low:.2f} to {high:.2f})")


if __name__ == "__main__":
    main()
