"""Trains something small with the Gymnasium environment: three gains that bring a pushed robot back to its point.

The command is the point's velocity plus a gain times the distance from the point, forward, sideways and in heading. The
cross-entropy method draws gains, walks with them side by side, and goes on from the best third. It ends with walks
whose pushes the training has not seen, for the gains that were found and for no gains at all.
`--seconds` is the time to train; `python benchmarks/train_gains.py` takes a minute on two cores.
"""

import argparse
import time

import gymnasium
import numpy as np
import zmpwalk.gym

WIDTH = np.array([0.5, 0.5, 0.5])  # of the first draw [1/s]
CANDIDATES, BEST, DURATION = 12, 4, 12.0
PUSHES = (3.0, 0.2)  # a push of 0.2 N s/kg every 3 s, in the mean


def returns(envs, gains, seed):
    """Mean reward of an episode with each of the gains (n, 3), all with the same point and the same pushes."""
    first = envs.unwrapped.envs[0]
    observations, _ = envs.reset(seed=[seed] * envs.num_envs)
    total, walking = np.zeros(envs.num_envs), np.ones(envs.num_envs, bool)
    steps = round(DURATION / first.period)
    for _ in range(steps):
        far, point = observations[:, :3], observations[:, 3:6]
        actions = np.clip((point + gains * far) / first.reach, -1.0, 1.0).astype(np.float32)
        observations, rewards, fell, _, _ = envs.step(actions)
        total += np.where(walking, rewards, 0.0)
        walking &= ~fell
    return total / steps


def train(seconds, seed=0, say=print):
    """Gains (3,) [1/s] that were found within a time."""
    random, mean, width = np.random.default_rng(seed), np.zeros(3), WIDTH.copy()
    envs = gymnasium.make_vec(zmpwalk.gym.ID, num_envs=CANDIDATES, pushes=PUSHES, duration=DURATION)
    end, generation = time.monotonic() + seconds, 0
    while time.monotonic() < end:
        gains = mean + width * random.standard_normal((CANDIDATES, 3))
        score = returns(envs, gains, 1000 + generation)
        best = gains[np.argsort(score)[-BEST:]]
        mean, width = 0.5 * mean + 0.5 * best.mean(axis=0), 0.5 * width + 0.5 * (best.std(axis=0) + 0.02)
        generation += 1
        say(f"{generation:3d}: reward {score.mean():.3f}, gains {np.round(mean, 2)}")
    envs.close()
    return mean


def compare(gains, episodes=12):
    """Mean reward of episodes that nobody trained on: with the gains, and with none."""
    envs = gymnasium.make_vec(zmpwalk.gym.ID, num_envs=2, pushes=PUSHES, duration=DURATION)
    found = [returns(envs, np.array([gains, np.zeros(3)]), seed) for seed in range(episodes)]
    envs.close()
    return np.mean(found, axis=0), np.std(np.diff(found, axis=1)) / np.sqrt(episodes)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seconds", type=float, default=60.0, help="time to train")
    gains = train(parser.parse_args().seconds)
    (trained, plain), spread = compare(gains)
    print(f"reward of a step: {trained:.3f} with these gains, {plain:.3f} with none, difference ± {spread:.3f}")


if __name__ == "__main__":
    main()
