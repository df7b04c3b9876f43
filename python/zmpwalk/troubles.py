"""What a walk bears of each kind of trouble, in one table: pushes, forces, and what the controller does not know."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, Callable, Sequence

import numpy as np

from .disturbances import Push, Uncertainty
from .errors import InputError
from .files import write_table
from .given import Settings, settings_of
from .profiles import VelocityProfile
from .pushes import push_map
from .robots import Robot, load_robot
from .simulation import WalkingController, name_of, processors, simulate_batch
from .trace import ABOVE, Trace
from .verdict import RECOVERY, TILT, judge

__all__ = ["Robustness", "Trouble", "robustness"]

GRAVITY = 9.81  # to state forces as shares of the weight [m/s^2]
ACCELERATION = 0.2  # at which the walk gains its speed [m/s^2]
SETTLE = 4.0  # of walking at full speed before a force [s]
FORCE_TIME = 3.0  # how long a steady force acts [s]
SPEED = 0.02  # of the commanded speed, by which a walk may miss it on the way
SEEDS = 4  # of whatever is random, for each level
DIRECTIONS = {0.0: ("forward", 0.45), 90.0: ("outwards", 0.25), 180.0: ("backward", 0.45), 270.0: ("inwards", 0.35)}
"""of pushes [degrees], with the impulse that should be borne [N s/kg]"""
PHASES = (0.0, 0.25, 0.5, 0.75)


@dataclass(frozen=True)
class Trouble:
    """One kind of trouble: levels from mild to hard, and which of them the walk bore."""

    name: str
    unit: str
    levels: tuple[float, ...]
    stood: tuple[float, ...]
    """share of the walks at that level that stood: 1 is all of them"""
    bar: float
    """the level that it should bear; NaN where none is set"""

    @property
    def borne(self) -> float:
        """The hardest level up to which every walk stood; NaN where not even the mildest was borne."""
        count = next((i for i, share in enumerate(self.stood) if share < 1.0), len(self.stood))
        return self.levels[count - 1] if count else math.nan

    @property
    def passes(self) -> bool | None:
        """Whether the bar is borne, and all that is milder; None without a bar."""
        if math.isnan(self.bar):
            return None
        harder = -1.0 if len(self.levels) > 1 and self.levels[1] < self.levels[0] else 1.0
        return not math.isnan(self.borne) and harder * self.borne >= harder * self.bar - 1e-9


@dataclass(frozen=True)
class Robustness:
    """What `robustness` found: a `Trouble` for each line of the table."""

    robot: str
    velocity: float
    duration: float
    """of each walk [s]"""
    troubles: tuple[Trouble, ...]

    def __getitem__(self, name: str) -> Trouble:
        for trouble in self.troubles:
            if trouble.name == name:
                return trouble
        raise KeyError(name)

    def rows(self) -> list[dict[str, Any]]:
        """One row for each level of each trouble, as it stands in the CSV file."""
        return [
            {"trouble": trouble.name, "unit": trouble.unit, "level": level, "stood": share, "bar": trouble.bar}
            for trouble in self.troubles
            for level, share in zip(trouble.levels, trouble.stood)
        ]

    def to_csv(self, path: str | os.PathLike) -> Path:
        """Write `rows` as a table, whole or not at all.

        Raises:
            InputError: the file cannot be written.

        Usage: `robustness().to_csv("robustness.csv")`
        """
        return write_table(path, self.rows())

    def plot(self, axes: Any = None) -> Any:
        """A line of cells for each trouble, from mild to hard: filled where the walk stood.

        Args:
            axes: one Axes to draw on, or None for a figure of its own.

        Returns:
            A matplotlib Figure, which a notebook shows.

        Usage: `robustness().plot().savefig("robustness.png")`
        """
        return ABOVE["plot_robustness"](self, axes)

    def __str__(self) -> str:
        lines = [f"{'trouble':28s} {'borne':>8s} {'bar':>8s}  levels, and where fewer than all walks stood"]
        for trouble in self.troubles:
            bar = "" if math.isnan(trouble.bar) else f"{trouble.bar:g}"
            borne = "–" if math.isnan(trouble.borne) else f"{trouble.borne:.3g}"
            levels = " ".join(
                f"{level:.3g}" + ("" if share == 1.0 else "✗" if share == 0.0 else f"({100 * share:.0f}%)")
                for level, share in zip(trouble.levels, trouble.stood)
            )
            verdict = {True: "✓", False: "✗", None: " "}[trouble.passes]
            lines.append(f"{trouble.name + ' [' + trouble.unit + ']':28s} {borne:>8s} {bar:>7s}{verdict}  {levels}")
        return "\n".join(lines)


@dataclass(frozen=True)
class _Kind:
    """A kind of trouble, and what a walk at one of its levels is given."""

    name: str
    unit: str
    levels: Sequence[float]
    bar: float
    given: Callable[[float], dict[str, Any]]
    seeds: int = 1


def robustness(
    robot: Robot = "mahru",
    velocity: float = 0.25,
    settings: Settings = None,
    duration: float = 20.0,
    only: Sequence[str] = (),
    threads: int | None = None,
    on_progress: Callable[[float, float], None] | None = None,
) -> Robustness:
    """Try everything that a walk may have to bear, from mild to hard.

    A walk stands where it does not fall, is upright at its end, and keeps its speed within 2 %; after a steady
    force, a torque or a push it must be back on its path as well (`zmpwalk.judge`).

    Args:
        robot, settings: as in `simulate`.
        velocity: forward [m/s], not 0.
        duration: of each walk [s]; those with a force last until they can be judged.
        only: names of troubles, or how they begin; empty is all.
        threads: as in `simulate_batch`.
        on_progress: called with (walks done, walks) now and then; what it raises stops everything and passes on.

    Returns:
        The table: `print` shows it.

    Raises:
        InputError: an argument that makes no sense.  ModelError: a robot that cannot be used.
        KeyboardInterrupt: Ctrl-C.

    Usage: `print(zmpwalk.robustness(duration=10, only=["noise", "mass"]))`
    """
    if not (math.isfinite(velocity) and velocity > 0.0):
        raise InputError(f"velocity is {velocity} m/s; it must be positive and finite")
    if not (math.isfinite(duration) and duration >= 4.0):
        raise InputError(f"duration is {duration} s; it must be at least 4 s, for the mean speed to mean something")
    model, description = load_robot(robot)
    gain = max(velocity / ACCELERATION, 1.0)
    profile = VelocityProfile.ramp(0.0, velocity, gain)
    controller = WalkingController(model, description, settings, profile)
    chosen = settings_of(settings)
    every = _kinds(controller.mass * GRAVITY, gain + SETTLE, chosen)
    kinds = [kind for kind in every if not only or any(kind.name.startswith(name) for name in only)]
    pushed = not only or any("push".startswith(name) or name.startswith("push") for name in only)
    if not kinds and not pushed:
        raise InputError(f"only is {list(only)}; there are push, {', '.join(kind.name for kind in every)}")
    walks = sum(len(kind.levels) * kind.seeds for kind in kinds)
    total = walks + (len(PHASES) * len(DIRECTIONS) if pushed else 0)

    def report(done: float) -> None:
        if on_progress:
            on_progress(done, total)

    base = {"robot": (model, description), "profile": profile, "settings": chosen, "on_fall": "go_on"}
    troubles = _tried(kinds, base, duration, velocity, threads, report)
    if pushed:
        found = push_map(
            (model, description), velocity, list(DIRECTIONS), PHASES, ["left"], chosen, processes=threads,
            on_progress=lambda cells, _: report(walks + cells),
        )  # fmt: skip
        pushes = zip(DIRECTIONS.values(), found.by_direction())
        troubles = [_push_trouble(f"push {name}", felling, bar) for (name, bar), felling in pushes] + troubles
    return Robustness(name_of(robot) or description.name, velocity, duration, tuple(troubles))


def _tried(
    kinds: Sequence[_Kind],
    base: dict[str, Any],
    duration: float,
    velocity: float,
    threads: int | None,
    report: Callable[[float], None],
) -> list[Trouble]:
    """Walks at every level of every kind, some at a time, since each leaves a large trace."""
    jobs = [(kind, level, seed) for kind in kinds for level in kind.levels for seed in range(kind.seeds)]
    at_once = 2 * (threads or processors())
    stood: dict[tuple[str, float], list[bool]] = {}
    for start in range(0, len(jobs), at_once):
        some = jobs[start : start + at_once]
        given = [kind.given(level) for kind, level, _ in some]
        after = [one["push"][0].t if "push" in one else None for one in given]  # when a force begins
        runs = [
            {**base, "duration": duration if t is None else t + one["push"][0].duration + RECOVERY, "seed": seed, **one}
            for one, t, (_, _, seed) in zip(given, after, some)
        ]
        traces = simulate_batch(runs, threads, partial(_report_share, report, start, len(some)))
        for (kind, level, _), trace, t in zip(some, traces, after):
            stood.setdefault((kind.name, level), []).append(_stands(trace, velocity, t))
        report(start + len(some))
    return [
        Trouble(
            kind.name, kind.unit, tuple(kind.levels),
            tuple(float(np.mean(stood[kind.name, level])) for level in kind.levels), kind.bar,
        )
        for kind in kinds
    ]  # fmt: skip


def _report_share(report: Callable[[float], None], start: int, walks: int, t: float, all_of_it: float) -> None:
    report(start + walks * t / all_of_it)


def _push_trouble(name: str, felling: float, bar: float) -> Trouble:
    """The smallest impulse that fells, as levels of 0.05 N s/kg."""
    top = 0.05 * math.ceil(min(max(felling, bar), 2.0) / 0.05 - 1e-9) + 0.05
    levels = tuple(round(level, 2) for level in np.arange(0.05, top + 1e-9, 0.05).tolist())
    return Trouble(name, "N s/kg", levels, tuple(float(level < felling - 1e-9) for level in levels), bar)


def _stands(trace: Trace, velocity: float, forced: float | None) -> bool:
    """Whether a walk stood: by the judge after a force, else by its fall, its tilt and its speed."""
    if trace.meta["fell"]:
        return False
    if forced is not None:
        return judge(trace, forced).survived
    half = len(trace.t) // 2
    phase = trace.phase[half:]
    touch_downs = half + 1 + np.flatnonzero((phase[:-1] == 1) & (phase[1:] == 0))
    if len(touch_downs) < 3:
        return False
    first, last = touch_downs[[0, (len(touch_downs) - 1) // 2 * 2]]  # whole strides
    speed = np.linalg.norm(trace.com[last, :2] - trace.com[first, :2]) / (trace.t[last] - trace.t[first])
    return judge(trace, float(trace.t[half])).tilt < TILT and abs(speed / velocity - 1.0) <= SPEED


def _kinds(weight: float, start: float, settings: Any) -> list[_Kind]:
    """Every kind of trouble but the pushes. Forces are shares of the weight [N] that is given."""
    unit = weight / 617.0  # the bars are those of a robot of 617 N

    def force(x: float, y: float) -> Callable[[float], dict[str, Any]]:
        return lambda level: {"push": [Push(start, FORCE_TIME, None, (x * level, y * level, 0.0))]}

    def unsure(name: str, sign: float = 1.0) -> Callable[[float], dict[str, Any]]:
        return lambda level: {"uncertainty": Uncertainty(**{name: sign * level})}

    def degrees(name: str, sign: float) -> Callable[[float], dict[str, Any]]:
        return lambda level: {"uncertainty": Uncertainty(**{name: sign * math.radians(level)})}

    def rate(level: float) -> dict[str, Any]:
        return {"settings": _with_rate(settings, level)}

    def together(level: float) -> dict[str, Any]:
        all_of_them = Uncertainty(
            noise=2.0, roll_bias=math.radians(2.0), torque_delay=0.008, lag=0.010, mass=1.2, links=0.2,
            ground_friction=0.2,
        )  # fmt: skip
        return {"uncertainty": all_of_them.scaled(level)}

    newton = [round(unit * level, 2) for level in (10, 20, 30, 40, 50, 60, 80)]
    newton_metre = [round(unit * level, 3) for level in (1, 2, 4, 8)]
    return [
        _Kind("steady force, left", "N", newton, round(unit * 40, 2), force(0, 1)),
        _Kind("steady force, forward", "N", newton, round(unit * 60, 2), force(1, 0)),
        _Kind("steady force, backward", "N", newton, round(unit * 60, 2), force(-1, 0)),
        _Kind(
            "yaw torque, 0.1 s", "N m", [round(unit * level, 1) for level in (50, 100, 150, 200, 300)],
            round(unit * 200, 1), lambda level: {"push": [Push(start, 0.1, None, (0, 0, 0, 0, 0, level))]},
        ),
        _Kind("noise", "times that of usual sensors", [0.5, 1.0, 1.5, 2.0, 3.0], 2.0, unsure("noise"), SEEDS),
        _Kind("roll bias, to the right", "degrees", [0.5, 1.0, 2.0, 3.0], 2.0, degrees("roll_bias", 1.0)),
        _Kind("pitch bias, forward", "degrees", [0.5, 1.0, 2.0, 3.0], 2.0, degrees("pitch_bias", 1.0)),
        _Kind("pitch bias, backward", "degrees", [0.5, 1.0, 2.0, 3.0], 2.0, degrees("pitch_bias", -1.0)),
        _Kind("torque delay", "s", [0.002, 0.004, 0.008, 0.012, 0.016, 0.024], 0.008, unsure("torque_delay")),
        _Kind("state delay", "s", [0.002, 0.004, 0.008, 0.012, 0.016, 0.024], 0.008, unsure("state_delay")),
        _Kind("drive lag", "s", [0.002, 0.005, 0.010, 0.015, 0.020, 0.030], 0.010, unsure("lag")),
        _Kind("control rate", "Hz", [500.0, 250.0, 200.0, 125.0, 100.0], 250.0, rate),
        _Kind("heavier than known", "times its mass", [1.1, 1.2, 1.3, 1.4], 1.2, unsure("mass")),
        _Kind("lighter than known", "times its mass", [0.9, 0.8, 0.7, 0.6], 0.8, unsure("mass")),
        _Kind("each link, at random", "± of its mass", [0.1, 0.2, 0.3, 0.4], 0.2, unsure("links"), SEEDS),
        _Kind("each COM, at random", "m", [0.01, 0.02, 0.03, 0.04], 0.02, unsure("com"), SEEDS),
        _Kind("dry friction, joints", "N m", newton_metre, math.nan, unsure("dry_friction")),
        _Kind("ground friction", "", [0.6, 0.4, 0.3, 0.2, 0.15, 0.1], 0.2, unsure("ground_friction")),
        _Kind("all of it together", "share of its full strength", [0.25, 0.5, 0.75, 1.0], 0.5, together, SEEDS),
    ]  # fmt: skip


def _with_rate(settings: Any, rate: float) -> Any:
    values = settings.to_dict()
    values["control_dt"] = 1.0 / rate
    return type(settings)(**values)
