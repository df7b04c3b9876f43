"""What a walk fell short of: its speed, the ranges of its joints, their torques, the ground that it was to walk on.

One place decides, from the record; summary, table, notebook and exit code of `zmpwalk walk --strict` say what it says.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from .analysis import feet_pose, mean_velocity
from .terrain import START

__all__ = ["shortfalls"]

SPEED = 0.05  # of the planned velocity, by which a walk may miss it
LEAST = np.array([0.003, 0.003, 0.01])  # an error that counts, however slow the walk is [m/s, m/s, rad/s]
SETTLING = 4  # steps after a change of the planned velocity that are not judged
STOP_DEPTH = 1e-3  # beyond the end of its range by this, a joint leans on its stop [rad or m]
STOP_TIME = 0.05  # for so long [s]
CUT = 0.01  # of the walk, in which torques may be cut to their limits: a landing cuts some for an instant


def shortfalls(trace: Any) -> list[str]:
    """What a walk fell short of, a sentence each; empty where there is nothing to say. Of a fall, only
    the joint that leaned longest on its stop is told: it may be the cause.

    - speed: between touch-downs of a planned velocity that stays the same, from the fourth step on, the feet went more
      than 5 % slower, faster or elsewhere;
    - stop: a joint leaned on the end of its range for longer than 0.05 s. The stop's torque is in no estimate;
    - torque: in more than 1 % of the cycles torques were cut to their limits;
    - ground: no foot came to the ground that was given in place of the floor.

    Args:
        trace: a walk; what its columns do not tell is not judged.

    Usage: `shortfalls(zmpwalk.simulate("mahru"))  # -> []`
    """
    if len(trace.t) < 2:
        return []
    fell = trace.meta.get("fell")
    if bool(fell) if fell is not None else bool(np.any(trace.get("fell", 0))):
        return _stops(trace)[:1]
    return [*_speed(trace), *_stops(trace), *_torque(trace), *_ground(trace)]


def _speed(trace: Any) -> list[str]:
    if not {"v_plan", "phase", "foot_left", "foot_right"} <= set(trace):
        return []
    v, t = trace.v_plan, trace.t
    landed = 1 + np.flatnonzero((trace.phase[:-1] == 1) & (trace.phase[1:] == 0))
    changes = 1 + np.flatnonzero((np.abs(np.diff(v, axis=0)) > 1e-9).any(axis=1))
    edges = np.concatenate([[0], changes, [len(t)]])
    worst, said = 1.0, []
    for begin, end in zip(edges[:-1], edges[1:]):
        steps = landed[(landed >= begin) & (landed < end)][SETTLING - 1 :]
        steps = steps[: 1 + 2 * ((len(steps) - 1) // 2)]  # whole strides
        if len(steps) < 3 or not v[begin].any():
            continue
        first, last = int(steps[0]), int(steps[-1])
        before, after = feet_pose(trace.foot_left[[first, last]], trace.foot_right[[first, last]])
        seconds = float(t[last] - t[first])
        walked = mean_velocity(before, after, seconds, float(v[begin][2]) * seconds)
        along = np.array([np.linalg.norm(v[begin][:2])] * 2 + [abs(v[begin][2])])
        off = np.abs(walked - v[begin])
        off = np.array([np.hypot(*off[:2]), 0.0, off[2] if v[begin][2] else 0.0])
        share = float((off / np.maximum(SPEED * along, LEAST)).max())
        if share > worst:
            worst = share
            said = [
                f"speed: it walked ({_velocity(walked)}) from {t[first]:.1f} to {t[last]:.1f} s, where "
                f"({_velocity(v[begin])}) was planned"
            ]
    return said


def _velocity(v: np.ndarray) -> str:
    return f"{v[0]:.3f} m/s, {v[1]:.3f} m/s, {v[2]:.3f} rad/s"


def _stops(trace: Any) -> list[str]:
    names = trace.meta.get("joint_names")
    if "qpos" not in trace or not isinstance(names, list) or trace.qpos.shape != (len(trace.t), 7 + len(names)):
        return []
    ends = _numbers(trace, "joint_ranges", (len(names), 2), (-np.inf, np.inf))
    if ends is None:
        return []
    q: Any = trace.qpos[:, 7:]
    said: list[tuple[float, str]] = []
    for side, beyond in (("lower", ends[:, 0] - q), ("upper", q - ends[:, 1])):
        seconds = (beyond > STOP_DEPTH).sum(axis=0) * trace.control_dt
        for j in np.flatnonzero(seconds > STOP_TIME):
            end = ends[j, 0 if side == "lower" else 1]
            text = f"{names[j]} leaned on the {side} end of its range, {end:+.3f}, for {seconds[j]:.2f} s"
            said.append((-seconds[j], f"stop: {text}; the stop's torque is not in the estimate"))
    return [text for _, text in sorted(said)]


def _torque(trace: Any) -> list[str]:
    if "saturated" not in trace:
        return []
    cut = np.asarray(trace.saturated) > 0
    if not cut.mean() > CUT:
        return []
    names, which = trace.meta.get("joint_names"), ""
    limits = _numbers(trace, "torque_limits", (len(names),), np.inf) if isinstance(names, list) else None
    if limits is not None and "tau" in trace and trace.tau.shape == (len(trace.t), len(limits)):
        full = np.abs(trace.tau[cut]) >= limits * (1 - 1e-9)
        most = sorted(range(len(names)), key=lambda j: -int(full[:, j].sum()))
        which = ", ".join(str(names[j]) for j in most[:3] if full[:, j].any())
    return [
        f"torque: {100 * cut.mean():.0f} % of the cycles asked for more than the joints can give"
        + (f" (most often {which})" if which else "")
    ]


def _ground(trace: Any) -> list[str]:
    kind, _, numbers = str(trace.meta.get("terrain") or "flat").partition(":")
    if kind in ("flat", "soft") or not {"foot_left", "foot_right"} <= set(trace):
        return []
    begins = float(numbers.split(",")[1]) if kind == "step" and "," in numbers else START
    feet = trace.meta.get("description", {})
    ahead = max(
        float(np.nanmax(trace[f"foot_{side}"][:, 0])) + 0.5 * float(feet.get(side, {}).get("length", 0.0))
        for side in ("left", "right")
    )
    if ahead > begins:
        return []
    return [
        f"ground: no foot came to the ground '{trace.meta['terrain']}', which begins at x = {begins:g} m; "
        f"they came to x = {ahead:.2f} m"
    ]


def _numbers(trace: Any, key: str, shape: tuple[int, ...], absent: Any) -> np.ndarray | None:
    """What the meta data keep of each joint, `absent` where there is none; None where a file holds something else."""
    given = trace.meta.get(key)
    try:
        out = np.array([absent if one is None else one for one in given], float)
    except (TypeError, ValueError, OverflowError):
        return None
    return out if out.shape == shape else None
