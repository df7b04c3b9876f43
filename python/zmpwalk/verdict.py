"""Whether a walk has come through a disturbance, judged from outside: by the record, not by the controller's word."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from .errors import InputError
from .profiles import VelocityProfile

__all__ = ["BACK", "RECOVERY", "SPEED", "STANDSTILL", "TILT", "Verdict", "judge"]

RECOVERY = 8.0  # after a push, the time at which it is judged [s]
TILT = np.radians(10.0)  # of the base against its start pose [rad]
SPEED = 0.05  # of the commanded speed, by which the last two steps may miss it
BACK = 0.02  # of the COM from the integrated commands, along either axis [m]
STANDSTILL = 0.0125  # mean speed of a robot that is asked to stand [m/s], and the least speed error of one that walks
WINDOW = 1.6  # over which a robot that takes no steps is averaged [s]


class Verdict(NamedTuple):
    """What `judge` found: `survived`, why not (`reason`), and the figures that were compared."""

    survived: bool
    reason: str
    tilt: float
    """Of the base against its start pose at the end [rad]."""
    speed_error: float
    """Mean speed of the last two steps along the heading, less the commanded one [m/s]."""
    offset: tuple[float, float]
    """How far the COM is from the integrated commands, along and across the heading, against before the push [m]."""


def judge(trace: Any, t: float, profile: Any = None) -> Verdict:
    """Whether the robot has come through what disturbed it at `t`.

    It has where, at the end of the record, it is upright (tilt < 10 degrees), the mean speed of the last two steps is
    within 5 % of the commanded one, and the COM is back on the integrated commands within 2 cm in x and y. The COM
    sways with the steps; so its place is the mean over the last two steps, compared with the mean over the two steps
    before `t`. What the controller says of a fall does not count. A robot that is commanded to stand need only stand
    still, where it can.

    Args:
        trace: a walk that goes on to 8 s after the push, or anything with its columns t, com, heading, phase, qpos.
        t: when the push began [s].
        profile: the commanded velocity over time; None takes `trace.profile`.

    Raises:
        InputError: the record does not reach from before `t` to after it.

    Usage:
        >>> judge(simulate(0.25, duration=16, push=[(8, 0.08, None, (0, 100, 0))], on_fall="go_on"), 8.0).survived
    """
    profile = VelocityProfile.of(trace.profile if profile is None else profile)
    times = np.asarray(trace.t)
    if not (len(times) > 2 and times[0] < t < times[-1]):
        raise InputError(f"the walk is judged by a record from before {t:g} s to after it")
    tilt = _tilt(trace.qpos[0, 3:7], trace.qpos[-1, 3:7])
    v = _velocities(trace, profile)
    walks = bool(np.any(v[-1] != 0.0))
    before = _two_steps(trace, times < t, walks)
    after = _two_steps(trace, times >= t, walks)
    nan = float("nan")
    if before is None or after is None:
        return Verdict(False, "it does not step any more", tilt, nan, (nan, nan))
    path = _commanded(trace, v, before)
    miss = np.asarray(trace.com)[:, :2] - path[:, :2]
    heading = path[after, 2].mean()
    axes = np.array([[np.cos(heading), np.sin(heading)], [-np.sin(heading), np.cos(heading)]])
    offset = axes @ (miss[after].mean(axis=0) - miss[before].mean(axis=0))
    moved, commanded = (np.diff(place[[after.start, after.stop - 1], :2], axis=0)[0] for place in (trace.com, path))
    lasted, way = times[after.stop - 1] - times[after.start], np.linalg.norm(commanded)
    wanted = way / lasted
    speed_error = (moved @ commanded / way if way > 0.0 else np.linalg.norm(moved)) / lasted - wanted
    reason = ""
    if not (np.isfinite(tilt) and tilt < TILT):
        reason = f"it is tilted by {np.degrees(tilt):.0f} degrees"
    elif not abs(speed_error) <= max(SPEED * wanted, STANDSTILL if not walks else 0.0):
        reason = f"its speed is {speed_error:+.3f} m/s off"
    elif walks and not np.all(np.abs(offset) <= BACK):
        reason = f"its COM is {100 * offset[0]:+.1f} cm ahead of and {100 * offset[1]:+.1f} cm beside its path"
    return Verdict(not reason, reason, tilt, float(speed_error), (float(offset[0]), float(offset[1])))


def _tilt(start: np.ndarray, end: np.ndarray) -> float:
    """Angle between the world's vertical as the base has it at the start and at the end [rad]."""

    def up(q: np.ndarray) -> np.ndarray:  # third row of the rotation matrix
        w, x, y, z = q
        return np.array([2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)])

    a, b = up(start), up(end)
    return float(np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b))


def _two_steps(trace: Any, rows: np.ndarray, walks: bool) -> slice | None:
    """Rows of the last two steps, from touch-down to touch-down, among `rows`; None where there are not two.

    Of a robot that stands, the rows of the last `WINDOW` seconds.
    """
    inside = np.flatnonzero(rows)
    if not walks:
        count = round(WINDOW / (trace.t[1] - trace.t[0]))
        return slice(max(inside[0], inside[-1] + 1 - count), inside[-1] + 1)
    phase = np.asarray(trace.phase)[inside]
    touch_downs = np.flatnonzero((phase[:-1] == 1) & (phase[1:] == 0)) + 1
    if len(touch_downs) < 3:
        return None
    return slice(inside[touch_downs[-3]], inside[touch_downs[-1]])


def _commanded(trace: Any, v: np.ndarray, start: slice) -> np.ndarray:
    """The integrated commands (T, 3): x, y [m] and heading [rad], from the COM and the heading at `start` on."""
    times = np.asarray(trace.t)
    dt = np.diff(times, append=2 * times[-1] - times[-2])
    turned = np.concatenate([[0.0], np.cumsum(v[:-1, 2] * dt[:-1])])
    heading = trace.heading[start.start] + turned - turned[start.start]
    steps = np.column_stack(
        [
            v[:, 0] * np.cos(heading) - v[:, 1] * np.sin(heading),
            v[:, 0] * np.sin(heading) + v[:, 1] * np.cos(heading),
        ]
    )
    path = np.vstack([[0.0, 0.0], np.cumsum(steps[:-1] * dt[:-1, None], axis=0)])
    path += np.asarray(trace.com)[start.start, :2] - path[start.start]
    return np.column_stack([path, heading])


def _velocities(trace: Any, profile: VelocityProfile) -> np.ndarray:
    """What was commanded in each row (T, 3): the live command, and the profile before the first."""
    t, v, times = np.asarray(profile.t), np.asarray(profile.v), np.asarray(trace.t)
    if profile.interpolation == "linear":
        planned = np.column_stack([np.interp(times, t, column) for column in v.T])
    else:
        planned = v[np.clip(np.searchsorted(t, times + 1e-9, side="right") - 1, 0, None)]
    command = getattr(trace, "command", None)
    return planned if command is None else np.where(np.isnan(command), planned, command)
