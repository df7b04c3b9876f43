"""Numbers that say how good a walk was: switch times, ZMP windows, offsets at mid-stance, errors by phase, the path.

Every function takes a `Trace`, or anything with the same columns as attributes.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

__all__ = [
    "Window",
    "bound_excess",
    "feet_pose",
    "in_support_axes",
    "mean_velocity",
    "midstance_offset",
    "planned_path",
    "sole_yaw",
    "switch_times",
    "yaw_moment",
    "zmp_error",
    "zmp_windows",
]


class Window(NamedTuple):
    """A time during which the desired ZMP sat on a bound: start and end [s], bound -1 lower or +1 upper."""

    start: float
    end: float
    bound: int


def switch_times(trace: Any) -> np.ndarray:
    """Time since the double support began at which the ZMP moved to the other foot, one for each switch (III-D).

    Returns:
        (n,) [s].

    Usage:
        >>> switch_times(trace)[5:].ptp()
    """
    at = np.flatnonzero(np.diff(trace.support) != 0) + 1
    return np.asarray(trace.phase_time[at])


def zmp_windows(trace: Any, shortest: float = 0.0) -> list[Window]:
    """Times during which the desired sagittal ZMP was on one of its bounds (section IV), in order.

    Args:
        shortest: windows shorter than this are left out [s].
    """
    windows = []
    for bound in (-1, 1):
        on = np.concatenate([[0], (trace.zmp_modified[:, 0] == bound).astype(int), [0]])
        starts, ends = np.flatnonzero(np.diff(on) == 1), np.flatnonzero(np.diff(on) == -1) - 1
        windows += [Window(float(trace.t[a]), float(trace.t[b]), bound) for a, b in zip(starts, ends)]
    return sorted(w for w in windows if w.end - w.start >= shortest)


def midstance_offset(trace: Any) -> np.ndarray:
    """How far the COM is ahead of the support sole's centre in the middle of each single support, along x (n,) [m]."""
    offsets = []
    for step in range(int(trace.step[-1]) + 1):
        rows = np.flatnonzero((trace.step == step) & (trace.phase == 1))
        if len(rows) < 2 or rows[-1] == len(trace.t) - 1:  # cut off by the end
            continue
        k = rows[len(rows) // 2]
        foot = trace.foot_left if trace.support[k] > 0 else trace.foot_right
        offsets.append(trace.com[k, 0] - foot[k, 0])
    return np.array(offsets)


def zmp_error(trace: Any, single_support: bool = False) -> np.ndarray:
    """|estimated ZMP - centre of pressure of MuJoCo's contact forces|, in cycles with contact only (n, 2) [m].

    Args:
        single_support: only cycles of single support.
    """
    error = np.abs(trace.zmp_est - trace.zmp_meas)
    keep = np.isfinite(error).all(axis=1)
    if single_support:
        keep &= trace.phase == 1
    return np.asarray(error[keep])


def bound_excess(trace: Any, single_support: bool = True) -> np.ndarray:
    """How far the estimated ZMP was beyond its bounds, for each cycle and axis (n, 2) [m]; negative inside.

    The axes are those of the support sole, along which the bounds run.
    """
    above, below = trace.zmp_est - trace.zmp_upper, trace.zmp_lower - trace.zmp_est
    excess = np.maximum(in_support_axes(trace, above), in_support_axes(trace, below))
    return np.asarray(excess[trace.phase == 1] if single_support else excess)


def in_support_axes(trace: Any, v: np.ndarray) -> np.ndarray:
    """Horizontal vectors in W, one a cycle, along the support sole's axes (T, 2)."""
    yaw = sole_yaw(np.where(trace.support[:, None] > 0, trace.foot_left, trace.foot_right))
    c, s = np.cos(yaw), np.sin(yaw)
    return np.stack([c * v[:, 0] + s * v[:, 1], c * v[:, 1] - s * v[:, 0]], axis=-1)


def yaw_moment(trace: Any, about: str = "zmp") -> np.ndarray:
    """Vertical moment of the ground on the robot (n,) [N m], cycles with contact only.

    Args:
        about: "zmp", the measured one: what turns the robot on its soles; or "com": what changes its angular momentum.
    """
    point = {"zmp": trace.zmp_meas, "com": trace.com[:, :2]}[about]
    moment = np.zeros(len(trace.t))
    for i, foot in enumerate((trace.foot_left, trace.foot_right)):
        # contact_wrench is the robot's on the ground, at the sole's centre; NaN in the air
        force, own = -np.nan_to_num(trace.contact_wrench[:, 6 * i : 6 * i + 6]).reshape(-1, 2, 3).swapaxes(0, 1)
        arm = foot[:, :2] - point
        moment += own[:, 2] + arm[:, 0] * force[:, 1] - arm[:, 1] * force[:, 0]
    return moment[np.isfinite(trace.zmp_meas).all(axis=1)]


def sole_yaw(foot: np.ndarray) -> np.ndarray:
    """Direction of a sole's x axis on the ground (...) [rad], of poses (..., 7): position, quaternion (w, x, y, z)."""
    w, x, y, z = np.moveaxis(np.asarray(foot)[..., 3:], -1, 0)
    return np.arctan2(2 * (w * z + x * y), w * w + x * x - y * y - z * z)


def feet_pose(foot_left: np.ndarray, foot_right: np.ndarray) -> np.ndarray:
    """Where the feet stand: the middle of the soles and their mean yaw.

    Args:
        foot_left, foot_right: sole poses (..., 7): position [m], quaternion.

    Returns:
        (..., 3): x, y [m], yaw in (-pi, pi] [rad], W.

    Usage: `feet_pose(trace.foot_left, trace.foot_right)[-1]`
    """
    left, right = np.asarray(foot_left), np.asarray(foot_right)
    yaws = np.stack([sole_yaw(left), sole_yaw(right)])
    yaw = np.arctan2(np.sin(yaws).sum(0), np.cos(yaws).sum(0))
    return np.concatenate([(left[..., :2] + right[..., :2]) / 2, yaw[..., None]], axis=-1)


def planned_path(trace: Any, as_given: bool = False) -> np.ndarray:
    """Where the planned velocity leads from the place where the feet stood first (T, 3): x, y [m], yaw (unwrapped)
    [rad], W.

    Each cycle turns and goes with its own velocity, which is exact while the velocity is constant.

    Args:
        as_given: the velocities of the profile and of live commands instead of v_plan, which changes no faster than
            the robot can.
    """
    start = feet_pose(trace.foot_left[0], trace.foot_right[0])
    v = trace.v_plan
    if as_given:
        profile = np.array([trace.profile.velocity(t) for t in trace.t - trace.t[0]])
        v = np.where(np.isnan(trace.command), profile, trace.command)
    turn = v[:-1, 2] * np.diff(trace.t)
    yaw = start[2] + np.concatenate([[0.0], np.cumsum(turn)])
    middle = yaw[:-1] + turn / 2  # the chord of an arc of `turn`
    step = v[:-1, :2] * (np.diff(trace.t) * np.sinc(turn / 2 / np.pi))[:, None]
    c, s = np.cos(middle), np.sin(middle)
    world = np.stack([c * step[:, 0] - s * step[:, 1], s * step[:, 0] + c * step[:, 1]], axis=-1)
    return np.column_stack([start[:2] + np.vstack([np.zeros(2), np.cumsum(world, axis=0)]), yaw])


def mean_velocity(before: np.ndarray, after: np.ndarray, seconds: float, planned_turn: float = 0.0) -> np.ndarray:
    """The constant (vx, vy, wz) in the heading frame that leads from one pose to another (3,) [m/s, m/s, rad/s].

    Args:
        before, after: (x, y, yaw) [m, rad], W.
        seconds: between them [s].
        planned_turn: of the ways round, the one nearest to this is taken [rad].

    Usage: `mean_velocity(poses[0], poses[1600], 1.6)`
    """
    turn = planned_turn + (after[2] - before[2] - planned_turn + np.pi) % (2 * np.pi) - np.pi
    middle = before[2] + turn / 2
    c, s = np.cos(middle), np.sin(middle)
    dx, dy = (np.asarray(after[:2]) - before[:2]) / np.sinc(turn / 2 / np.pi)  # the arc of that chord
    return np.array([c * dx + s * dy, -s * dx + c * dy, turn]) / seconds
