"""The process of `push_map`: one walk, and a child for each trial that goes on from where the walk has come to.

A child is a copy of the whole process (`os.fork`), so the controller in the middle of a walk need not know how to be
copied. This process has one thread, which is what makes a fork safe; the caller's process is left as it is.
"""

from __future__ import annotations

import json
import math
import os
import pickle
import sys
import time
import traceback
from types import SimpleNamespace
from typing import Any

import mujoco
import numpy as np

from . import _core
from .errors import Error, InputError
from .profiles import VelocityProfile
from .robots import description_from_dict
from .simulation import WalkingController
from .verdict import judge

__all__ = ["main"]

JUDGED = ("t", "com", "heading", "phase", "support", "qpos", "command")  # columns that the judge and the phases need
CHUNK = 0.1  # in which the walk is walked on until it has shown two steps [s]


class Walk:
    """A walk in stretches, and what the judge needs of them."""

    def __init__(self, job: dict[str, Any]):
        model = mujoco.MjModel.from_binary_path("trials.mjb", {"trials.mjb": job["model"]})
        self.profile = VelocityProfile.from_dict(job["profile"])
        description = description_from_dict(job["description"], "the trials' description")
        self.controller = WalkingController(model, description, _core.WalkSettings(**job["settings"]), self.profile)
        self.simulation = _core.Simulation(self.controller)
        self.columns: dict[str, np.ndarray] = {}
        self.fell = False

    @property
    def time(self) -> float:
        return self.simulation.time

    def on(self, until: float, on_fall: str = "stop") -> None:
        """Walk on to that time [s]."""
        if until - self.time < 0.5 * self.controller.model.opt.timestep:
            return
        columns, info = self.simulation.run(until - self.time, on_fall=on_fall)
        self.fell = self.fell or bool(info["fell"])
        for name in JUDGED:
            old = self.columns.get(name)
            self.columns[name] = columns[name] if old is None else np.concatenate([old, columns[name]])

    def require_standing(self) -> None:
        if self.fell:
            raise InputError(f"the robot falls at {self.time:.2f} s, before it is pushed")

    def lift_offs(self) -> list[tuple[float, str]]:
        """When a foot left the ground [s], and which stayed."""
        phase, support, t = (self.columns[name] for name in ("phase", "support", "t"))
        rows = np.flatnonzero((phase[:-1] == 0) & (phase[1:] == 1)) + 1
        return [(float(t[row]), "left" if support[row] > 0 else "right") for row in rows]


def main() -> None:
    """Read a job from stdin, write what comes of it to stdout, a line of JSON each."""
    job = pickle.load(sys.stdin.buffer)
    start = time.monotonic()
    try:
        _run(job)
    except Error as error:
        _say({"error": type(error).__name__, "text": str(error)})
        return
    _say({"wall_time": time.monotonic() - start})


def _say(line: dict[str, Any]) -> None:
    os.write(1, (json.dumps(line) + "\n").encode())  # one write: lines of several processes do not mix


def _run(job: dict[str, Any]) -> None:
    walk = Walk(job)
    walk.on(job["settled"])
    walk.require_standing()
    instants, period, single_support = _instants(walk, job)
    _say({"period": period, "single_support": single_support})
    children = 0
    for t, s, i in instants:
        walk.on(t)
        walk.require_standing()
        for k in range(len(job["angles"])):
            while children >= job["processes"]:
                children -= _wait()
            if os.fork() == 0:
                _in_child(lambda cell=(s, i, k): _ladder(walk, job, cell))
            children += 1
    while children:
        children -= _wait()


def _in_child(work: Any) -> None:
    """Does the work and ends the process with what it returns; never comes back."""
    code = 70
    try:
        code = work()
    except Error as error:
        _say({"error": type(error).__name__, "text": str(error)})
    except BaseException:
        code = 71
        traceback.print_exc()
    finally:
        os._exit(code)


def _wait() -> int:
    """Waits for a child. Its trouble has been told by itself, but where it had no time to."""
    _, status = os.wait()
    if status and not (os.WIFEXITED(status) and os.WEXITSTATUS(status) == 70):
        raise RuntimeError(f"a trial has ended with status {status}")
    return 1


def _instants(walk: Walk, job: dict[str, Any]) -> tuple[list[tuple[float, int, int]], float | None, float | None]:
    """When to push: (t [s], number of the stance, number of the phase), in order; the time between lift-offs, and its
    share in single support."""
    if not np.any(walk.profile.velocity(walk.time)):
        return [(walk.time, 0, 0)], None, None
    while len(walk.lift_offs()) < 3:
        walk.on(walk.time + CHUNK)
        walk.require_standing()
    (before, _), _, (last, stance) = walk.lift_offs()[-3:]
    period = 0.5 * (last - before)
    within = (walk.columns["t"] >= before - 1e-9) & (walk.columns["t"] < last - 1e-9)
    single_support = float(np.mean(walk.columns["phase"][within] == 1))
    instants = []
    for s, wanted in enumerate(job["stances"]):
        steps = 1 if wanted != stance else 2
        while last + steps * period < walk.time + 1e-9:
            steps += 2
        for i, share in enumerate(job["shares"]):
            instants.append((_rounded(last + (steps + share) * period, walk), s, i))
    return sorted(instants), period, single_support


def _rounded(t: float, walk: Walk) -> float:
    dt = walk.controller.model.opt.timestep
    return dt * round(t / dt)


def _ladder(walk: Walk, job: dict[str, Any], cell: tuple[int, int, int]) -> int:
    """The smallest impulse that fells: coarse steps to the first fall, then fine ones between."""
    step, fine, limit = job["ladder"]
    s, _, k = cell
    stance = job["stances"][s]
    trials, felling, safe = 0, None, 0.0
    for rungs in (step * np.arange(1, math.floor(limit / step + 1e-9) + 1), None):
        if rungs is None:  # between the last that stood and the first that fell
            if felling is None:
                break
            rungs = safe + fine * np.arange(1, math.ceil((felling - safe) / fine - 1e-9))
        for impulse in rungs:
            trials += 1
            if _falls(walk, job, stance, job["angles"][k], float(impulse)):
                felling = round(float(impulse), 9)
                break
            safe = float(impulse)
    _say({"cell": cell, "felling": felling, "trials": trials})
    return 0


def _falls(walk: Walk, job: dict[str, Any], stance: str, angle: float, impulse: float) -> bool:
    child = os.fork()
    if child == 0:
        _in_child(lambda: 0 if _stands(walk, job, stance, angle, impulse) else 1)
    _, status = os.waitpid(child, 0)
    code = os.WEXITSTATUS(status) if os.WIFEXITED(status) else -1
    if code not in (0, 1):
        os._exit(70 if code == 70 else 71)
    return code == 1


def _stands(walk: Walk, job: dict[str, Any], stance: str, angle: float, impulse: float) -> bool:
    """One trial: push, walk on for 8 s, judge."""
    t = walk.time
    side = -1.0 if stance == "right" else 1.0
    towards = float(walk.columns["heading"][-1]) + side * angle
    force = impulse * job["mass"] / job["push_time"]
    wrench = [force * math.cos(towards), force * math.sin(towards), 0.0, 0.0, 0.0, 0.0]
    walk.simulation.push(t, job["push_time"], job["body"], wrench)
    walk.on(t + job["push_time"] + job["recovery"], on_fall="go_on")
    return not walk.fell and judge(SimpleNamespace(**walk.columns), t, walk.profile).survived


if __name__ == "__main__":
    main()
