"""A short walk that `zmpwalk inspect` tries, so that it can say beforehand, with numbers, what would go wrong."""

from __future__ import annotations

from typing import Any

import mujoco
import numpy as np

from . import analysis
from .errors import Error
from .profiles import VelocityProfile
from .robots import RobotDescription
from .robots.proposal.remarks import usual_speed
from .simulation import WalkingController, run

__all__ = ["try_out"]

STANDS, GAINS, WALKS = 1.0, 2.0, 4.0  # how long the robot stands, comes up to speed, and walks at it [s]
SHARE = 0.7  # of the highest speed that the controller believes in: no trial goes faster
NEAR = 0.02  # to the end of its range, a joint that comes so near has no room [rad]
ERROR = 0.004  # of the COM's height: an estimate that is off by more in single support is worth a word
TWIST = 0.8  # share of what the soles hold against turning from which it is worth a word


def try_out(
    model: mujoco.MjModel, description: RobotDescription, table: dict[str, Any]
) -> tuple[dict[str, Any], list[str]]:
    """Walk a robot at a usual speed for some seconds and look at what it took.

    Args:
        model, description: as `load_robot` returns them.
        table: what `inspect_robot` and `appraise` found.

    Returns:
        Plain values, and remarks, one line each, of what went wrong or nearly did: speed_mps, stood, fall_cause;
        torque_stand, torque_walk: (joint, share of its limit), None where no joint has a limit; range_left: (joint,
        nearest end, how near it came [rad]), None without ranges; zmp_error_mm (95th percentile of single support, x
        and y); yaw_moment_Nm and yaw_friction_Nm (the largest moment about the vertical on one sole, and what friction
        holds of it with the load at the sole's middle); floor_m (height of the floor under the start pose).

    Usage: `try_out(model, proposal.description, proposal.table)[0]["torque_walk"]`
    """
    speed = min(usual_speed(model, table["com_height_m"]), SHARE * (table["speed_limit_mps"] or 0.0))
    speeds = np.array([[0.0, 0, 0], [0, 0, 0], [speed, 0, 0]])
    profile = VelocityProfile([0.0, STANDS, STANDS + GAINS], speeds, "linear")
    try:
        controller = WalkingController(model, description, None, profile)
        trace = run(controller, STANDS + GAINS + WALKS)
    except Error as error:
        return {"speed_mps": speed, "stood": False, "fall_cause": str(error)}, [f"tried: {error}"]
    summary = trace.summary()
    standing, walking = trace.t < STANDS, trace.t >= STANDS
    found: dict[str, Any] = {
        "speed_mps": speed,
        "stood": not summary["fell"],
        "fall_cause": summary["fall_cause"],
        "torque_stand": _torque(trace, standing),
        "torque_walk": _torque(trace, walking),
        "range_left": _range_left(trace),
        "zmp_error_mm": summary["zmp_error_mm"]["single_support_p95"],
        "floor_m": float(min(trace.foot_left[0, 2], trace.foot_right[0, 2])),
        **_twist(trace, model, description, table["mass_kg"]),
    }
    return found, _remarks(found, summary, trace, table)


def _torque(trace: Any, rows: np.ndarray) -> tuple[str, float] | None:
    """The joint that used most of its torque in these rows, and how much of it."""
    limits = np.array([np.inf if one is None else one for one in trace.meta["torque_limits"]], float)
    if not rows.any() or not np.isfinite(limits).any():
        return None
    share = (np.abs(trace.tau[rows]) / limits).max(axis=0)
    j = int(np.argmax(share))
    return trace.meta["joint_names"][j], float(share[j])


def _range_left(trace: Any) -> tuple[str, float, float] | None:
    """The leg's joint that came nearest to an end of its range, that end, and how near it came."""
    legs = {*trace.description.left.leg_joints, *trace.description.right.leg_joints}
    nearest: tuple[str, float, float] | None = None
    for j, (name, pair) in enumerate(zip(trace.meta["joint_names"], trace.meta["joint_ranges"])):
        if pair is None or name not in legs:
            continue
        q = trace.qpos[:, 7 + j]
        for end, left in ((pair[0], float(q.min() - pair[0])), (pair[1], float(pair[1] - q.max()))):
            if nearest is None or left < nearest[2]:
                nearest = (name, float(end), left)
    return nearest


def _twist(trace: Any, model: mujoco.MjModel, description: RobotDescription, mass: float) -> dict[str, Any]:
    """The largest yaw moment that one sole had to hold, and what its friction holds."""
    single = trace.phase[np.isfinite(trace.zmp_meas).all(axis=1)] == 1
    moment = np.abs(analysis.yaw_moment(trace))[single]
    foot = description.left
    weight = mass * float(np.linalg.norm(model.opt.gravity))
    friction = float(trace.meta["settings"]["friction"]) if "friction" in trace.meta["settings"] else np.nan
    holds = friction * weight * 0.5 * float(np.hypot(foot.length, foot.width))
    return {
        "yaw_moment_Nm": float(moment.max()) if len(moment) else None,
        "yaw_friction_Nm": holds if np.isfinite(holds) else None,
    }


def _remarks(found: dict[str, Any], summary: dict[str, Any], trace: Any, table: dict[str, Any]) -> list[str]:
    said = []
    where = f"tried at {found['speed_mps']:.3f} m/s"
    if not found["stood"]:
        said.append(f"{where}: it fell at {summary['fall_time']:.1f} s: {summary['fall_cause'] or 'cause unknown'}")
    said += [f"{where}: {shortfall}" for shortfall in summary["shortfalls"]]
    left = found["range_left"]
    if left is not None and left[2] < NEAR and not any(left[0] in shortfall for shortfall in summary["shortfalls"]):
        said.append(
            f"{where}: {left[0]} came to {max(left[2], 0.0):.3f} rad from the end of its range, {left[1]:+.3f} rad"
        )
    error, height = found["zmp_error_mm"], table["com_height_m"]
    if all(e is not None for e in error) and max(error) > 1e3 * ERROR * height:
        said.append(
            f"{where}: the estimate of the ZMP is off by {error[0]:.1f} mm forward and {error[1]:.1f} mm sideways "
            "(95th percentile of single support): the contacts of the soles are not what a flat sole has"
        )
    twist, holds = found["yaw_moment_Nm"], found["yaw_friction_Nm"]
    if twist is not None and holds is not None and twist > TWIST * holds:
        said.append(f"{where}: a sole had to hold {twist:.1f} N m against turning; its friction holds {holds:.1f} N m")
    if found["floor_m"] > 1e-3:
        said.append(
            f"floor: it lies {1e3 * found['floor_m']:.0f} mm above the soles of the start pose; the robot is set on it"
        )
    return said
