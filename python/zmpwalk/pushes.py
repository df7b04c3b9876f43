"""How hard a push it takes to fell a robot: every direction, every phase of the step, smallest impulse first."""

from __future__ import annotations

import json
import math
import os
import pickle
import signal
import subprocess
import sys
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Callable, Iterator, Sequence

import numpy as np

from ._core import trunk_body
from .capture import PendulumWalk, pendulum_limit
from .errors import InputError, ModelError
from .files import write_table
from .given import Settings
from .profiles import VelocityProfile, three
from .robots import Robot, description_to_dict, load_robot
from .robots.source import model_bytes
from .simulation import WalkingController, name_of, processors
from .trace import ABOVE, plain
from .verdict import RECOVERY

__all__ = ["PUSH_TIME", "PushMap", "push_map"]

PUSH_TIME = 0.08  # how long a push lasts [s]
ACCELERATION = 0.2  # at which the walk before the pushes gains its speed [m/s^2, rad/s^2]
SETTLE = 8.0  # of walking at the full speed before the first push [s]
STANCES = ("left", "right")


@dataclass(frozen=True)
class PushMap:
    """The smallest impulse that fells the robot, by stance, phase and direction.

    `felling[s, i, k]` [N s/kg] belongs to the stance `stances[s]`, the phase `phases[i]` and the direction
    `directions[k]`; it is NaN where nothing up to `limit` fells. A phase is the share of the way from the lift-off
    after which the stance foot stands alone to the next lift-off. A direction is an angle from the heading: 0 pushes
    forward and 90 degrees outwards, to the side of the stance foot. A step's stance keeps its name until the next
    lift-off, so that in double support 270 degrees are outwards for the foot that carries next.
    """

    robot: str
    mass: float
    """[kg]"""
    velocity: tuple[float, float, float]
    """(vx, vy, wz) [m/s, m/s, rad/s]"""
    body: str
    """which is pushed"""
    duration: float
    """of a push [s]"""
    stances: tuple[str, ...]
    phases: np.ndarray
    directions: np.ndarray
    """[degrees]"""
    felling: np.ndarray
    period: float
    """from one lift-off to the next [s]; NaN of a robot that stands"""
    single_support: float
    """share of the period in single support; phases below it begin there"""
    limit: float
    """up to which was pushed [N s/kg]"""
    pendulum: np.ndarray
    """the pendulum's limit (phases, directions) [N s/kg], see `zmpwalk.pendulum_limit`"""
    pendulum_assumptions: str
    trials: int
    wall_time: float
    """[s]"""

    @property
    def worst(self) -> float:
        """Smallest impulse that fells [N s/kg]."""
        return float(np.nanmin(self.felling)) if np.isfinite(self.felling).any() else math.nan

    @property
    def mean(self) -> float:
        """Mean over the map [N s/kg]; where nothing up to the limit fells, the limit counts."""
        return float(np.where(np.isnan(self.felling), self.limit, self.felling).mean())

    def support(self, phase: float) -> str:
        """ "single" or "double": what a push at this phase finds the robot in."""
        return "single" if phase < self.single_support - 1e-9 else "double"

    def by_direction(self, support: str | None = None) -> np.ndarray:
        """The worst of every direction (directions,) [N s/kg]; infinite where nothing fells.

        Args:
            support: "single" or "double" takes only the phases in which a push begins there; None takes all.

        Usage: `push_map().by_direction("single")`
        """
        taken = np.array([support in (None, self.support(phase)) for phase in self.phases])
        felling = np.where(np.isnan(self.felling), np.inf, self.felling)[:, taken]
        return felling.min(axis=(0, 1), initial=np.inf)

    def rows(self) -> list[dict[str, Any]]:
        """One row for each stance, phase and direction, as it stands in the CSV file."""
        return [
            {
                "stance": stance,
                "phase": float(phase),
                "support": self.support(phase),
                "direction_deg": float(direction),
                "felling_Ns_per_kg": float(self.felling[s, i, k]),
                "felling_Ns": float(self.felling[s, i, k]) * self.mass,
                "pendulum_Ns_per_kg": float(self.pendulum[i, k]),
            }
            for s, stance in enumerate(self.stances)
            for i, phase in enumerate(self.phases)
            for k, direction in enumerate(self.directions)
        ]

    def to_csv(self, path: str | os.PathLike) -> Path:
        """Write `rows` as a table, whole or not at all.

        Raises:
            InputError: the file cannot be written.

        Usage: `push_map().to_csv("pushes.csv")`
        """
        return write_table(path, [{key: _short(value) for key, value in row.items()} for row in self.rows()])

    def plot(self, axes: Any = None) -> Any:
        """A polar figure for each phase, with the pendulum's limit beside.

        Args:
            axes: a polar Axes for each phase, or None for a figure of its own.

        Returns:
            A matplotlib Figure, which a notebook shows.

        Usage: `push_map().plot().savefig("pushes.png")`
        """
        return ABOVE["plot_pushes"](self, axes)

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers and words that JSON can hold; NaN becomes None."""
        return plain({**self.__dict__, "worst": self.worst, "mean": self.mean}, finite=True)

    def __str__(self) -> str:
        lines = [f"{'direction [deg]':>18s} " + "".join(f"{d:7.0f}" for d in self.directions)]
        for s, stance in enumerate(self.stances):
            for i, phase in enumerate(self.phases):
                label = f"{stance} {phase:.3f} {self.support(phase)}" if math.isfinite(self.period) else "standing"
                lines.append(f"{label:>18s} " + "".join(f"{f:7.2f}" for f in self.felling[s, i]))
        for support in ("single", "double"):
            if math.isfinite(self.period) and any(self.support(phase) == support for phase in self.phases):
                label = f"worst, {support}"
                lines.append(f"{label:>18s} " + "".join(f"{f:7.2f}" for f in self.by_direction(support)))
        lines.append(f"{'worst':>18s} " + "".join(f"{f:7.2f}" for f in self.by_direction()))
        lines.append(f"{'pendulum, worst':>18s} " + "".join(f"{p:7.2f}" for p in self.pendulum.min(axis=0)))
        lines.append(f"worst {self.worst:.2f} N s/kg ({self.worst * self.mass:.1f} N s), mean {self.mean:.3f} N s/kg")
        return "\n".join(lines)


def _short(value: Any) -> Any:
    return f"{value:.6g}" if isinstance(value, float) else value


def push_map(
    robot: Robot = "mahru",
    velocity: float | Sequence[float] = 0.25,
    directions: int | Sequence[float] = 12,
    phases: int | Sequence[float] = 8,
    stances: Sequence[str] = STANCES,
    settings: Settings = None,
    body: str | None = None,
    step: float = 0.05,
    fine_step: float = 0.01,
    limit: float = 2.0,
    processes: int | None = None,
    on_progress: Callable[[float, float], None] | None = None,
) -> PushMap:
    """Push a walking or standing robot until it falls, from every side and at every phase of its step.

    The robot walks at a constant velocity. At each phase a constant force acts for 0.08 s on its trunk. Impulses
    grow in steps of `step` to the first that fells, then between this and the one before in steps of `fine_step`; the
    smallest that fells counts. Whether it fell is judged 8 s later (`zmpwalk.judge`). The walk up to the push is
    walked once, and every trial goes on from it in a process of its own, so that equal arguments give equal maps.

    Args:
        robot: what `load_robot` takes.
        velocity: vx [m/s] or (vx, vy, wz); 0 pushes a robot that stands, whose only phase is 0.
        directions: how many, evenly spaced from 0 on; or angles from the heading [degrees], 0 forward, 90 outwards:
            to the side of the foot that stands alone after the last lift-off. Of a robot that stands, 90 is leftward.
        phases: how many, i / n of the way from a lift-off to the next; or these shares, each from 0 to less than 1.
        stances: of "left" and "right", the foot that stands alone after the lift-off.
        settings: as in `simulate`.
        body: which is pushed; None takes the trunk.
        step, fine_step: of the impulse [N s/kg].
        limit: largest impulse that is tried [N s/kg].
        processes: how many trials at a time; None takes the processors this process may use.
        on_progress: called with (cells done, cells) now and then; what it raises stops everything and passes on.

    Returns:
        The map: `print` shows it, `worst`, `mean`, `to_csv`.

    Raises:
        InputError: an argument that makes no sense; a velocity at which the robot falls without a push.
        ModelError: a robot that cannot be used.  KeyboardInterrupt: Ctrl-C.

    Usage: `print(zmpwalk.push_map(velocity=0.25, directions=[0, 90, 180, 270], phases=4))`
    """
    model, description = load_robot(robot)
    v = three(velocity)
    walks = bool(np.any(v != 0.0))
    gain = max(float(np.abs(v).max()) / ACCELERATION, 1.0)
    profile = VelocityProfile.ramp(0.0, v.tolist(), gain) if walks else VelocityProfile.constant(0.0)
    controller = WalkingController(model, description, settings, profile)  # says what is wrong before anything begins
    body = body or trunk_body(controller)
    angles = _evenly("directions", directions, 360.0)
    shares = _evenly("phases", phases, 1.0) if walks else np.zeros(1)
    if not len(angles) or not len(shares) or not np.all((shares >= 0.0) & (shares < 1.0)):
        raise InputError(f"phases are {shares.tolist()}; they must be shares from 0 to less than 1")
    stances = tuple(stances) if walks else STANCES[:1]
    for stance in stances:
        if stance not in STANCES:
            raise InputError(f"stances hold {stance!r}; they must be left or right")
    for name, value in (("step", step), ("fine_step", fine_step), ("limit", limit)):
        if not (math.isfinite(value) and value > 0.0):
            raise InputError(f"{name} is {value:g} N s/kg; it must be positive and finite")
    if processes is None:
        processes = processors()
    if processes < 1:
        raise InputError(f"processes is {processes}; it must be at least 1")
    job = {
        "model": model_bytes(model),
        "description": description_to_dict(controller.description),
        "settings": controller.settings.to_dict(),
        "profile": profile.to_dict(),
        "settled": gain + SETTLE,
        "angles": np.radians(angles),
        "shares": shares,
        "stances": stances,
        "body": body,
        "mass": controller.mass,
        "push_time": PUSH_TIME,
        "recovery": RECOVERY,
        "ladder": (step, fine_step, limit),
        "processes": int(processes),
    }
    felling = np.full((len(stances), len(shares), len(angles)), math.nan)
    period, single, trials, wall_time, done = math.nan, 0.0, 0, 0.0, 0
    for line in _serve(job):
        if "period" in line:
            period, single = line["period"] or math.nan, line["single_support"] or 0.0
        elif "cell" in line:
            s, i, k = line["cell"]
            felling[s, i, k] = math.nan if line["felling"] is None else line["felling"]
            trials += line["trials"]
            done += 1
        else:
            wall_time = line["wall_time"]
        if on_progress:
            on_progress(done, felling.size)
    pendulum = PendulumWalk.of((model, description), float(v[0]), controller.settings)
    if math.isfinite(period):
        pendulum = replace(pendulum, period=period, double_support=(1.0 - single) * period)
    bound = pendulum_limit(pendulum, angles.tolist(), shares.tolist())
    return PushMap(
        robot=name_of(robot) or description.name, mass=float(controller.mass), velocity=tuple(v.tolist()), body=body,
        duration=PUSH_TIME, stances=stances, phases=shares, directions=angles, felling=felling, period=period,
        single_support=single, limit=limit,
        pendulum=bound, pendulum_assumptions=pendulum.assumptions(), trials=trials, wall_time=wall_time,
    )  # fmt: skip


def _evenly(name: str, given: int | Sequence[float], whole_way: float) -> np.ndarray:
    if isinstance(given, (int, np.integer)) and not isinstance(given, bool):
        if given < 1:
            raise InputError(f"{name} is {given}; it must be at least 1")
        return whole_way * np.arange(int(given)) / int(given)
    values = np.asarray(given, float).ravel()
    if not len(values) or not np.isfinite(values).all():
        raise InputError(f"{name} are {values.tolist()}; they must be a number of them, or finite numbers")
    return values


def _serve(job: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Lines of the process that walks, as they come; it and all its children end with this generator."""
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    environment["PYTHONPATH"] = os.pathsep.join(
        [str(Path(__file__).parents[1]), *filter(None, [os.environ.get("PYTHONPATH")])]
    )
    process: Any = subprocess.Popen(
        [sys.executable, "-W", "ignore", "-m", "zmpwalk.trials"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        env=environment,
        start_new_session=True,
    )
    finished = False
    try:
        process.stdin.write(pickle.dumps(job))
        process.stdin.close()
        for text in process.stdout:
            line = json.loads(text)
            if "error" in line:
                raise {"InputError": InputError, "ModelError": ModelError}.get(line["error"], RuntimeError)(
                    line["text"]
                )
            finished = finished or "wall_time" in line
            yield line
        if not finished:
            raise RuntimeError(f"the process of the trials has ended early, with code {process.wait()}")
    finally:
        if process.poll() is None and not finished:
            os.killpg(process.pid, signal.SIGKILL)
        with suppress(BrokenPipeError):
            process.stdin.close()
        process.stdout.close()
        process.wait()
