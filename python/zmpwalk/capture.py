"""How hard a push a pendulum bears: what no controller of the feet alone can be better than."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, Sequence

import mujoco
import numpy as np

from .errors import InputError
from .given import Settings
from .profiles import VelocityProfile
from .robots import Robot, load_robot
from .simulation import WalkingController

__all__ = ["PendulumWalk", "pendulum_limit"]

LEG = 0.61  # sum of the distances between the joints of a leg of the bundled robot, for which the reaches are given [m]
RESOLUTION = 1e-4  # of the impulse [N s/kg]
LANDINGS = 121  # times of the landing that are tried
LARGEST = 5.0  # impulse that is asked about [N s/kg]


@dataclass(frozen=True)
class PendulumWalk:
    """A linear inverted pendulum that walks, and what its feet may do once it is pushed.

    The divergent component of motion (DCM), xi = x + T_c dx, runs away from the ZMP, d xi = (xi - zmp) / T_c, and an
    impulse per mass J moves it by T_c J. The robot can still be caught as long as the next footholds can bring the DCM
    back over a sole. Lengths are in metres, times in seconds.
    """

    Tc: float
    """time constant, sqrt(z_c / g)"""
    sole: tuple[float, float]
    """length and width"""
    step_width: float
    velocity: float
    """forward [m/s]; 0 stands on both feet"""
    period: float
    """T, from a lift-off to the next"""
    double_support: float
    """part of the period in which both feet carry; the ZMP changes feet in its middle"""
    sole_share: float = 0.95
    """of the sole's length and width that the ZMP may use"""
    reach_forward: float = 0.45
    """how far before or behind the stance foot the swing foot may land"""
    reach_sideways: float = 0.50
    feet_apart: float = math.nan
    """least distance of the swing foot from the stance foot, inwards, where it may not cross; NaN takes `step_width`"""
    shortest: float = 0.30
    """single support"""
    longest: float = 1.5
    """single support"""
    timing: bool = True
    """whether the steps may come early or late; else they keep the period"""
    later_steps: bool = True
    """whether the step after the next may still help; else the robot must be able to stand on the next foot"""
    crossing: bool = False
    """whether the swing foot may land beyond the stance foot"""
    cross_time: float = 0.47
    """from a lift-off to the soonest landing beyond the stance foot, which the swing foot has to go round"""
    reach_across: float = 0.40
    """how far beyond the stance foot it may land then"""
    push_time: float = 0.08
    """how long the push lasts: it acts as an impulse in its middle, so that half of it is lost to the swing"""

    @classmethod
    def of(cls, robot: Robot = "mahru", velocity: float = 0.25, settings: Settings = None, **changes: Any) -> Any:
        """The pendulum of a robot: its height, soles, steps and timing, and a reach scaled by the length of its legs.

        Args:
            robot, settings: as in `simulate`.
            velocity: forward [m/s].
            changes: any of the fields.

        Raises:
            InputError: a field that does not exist.  ModelError: a robot that cannot be used.

        Usage: `PendulumWalk.of("mahru", 0.25, crossing=True)`
        """
        model, description = load_robot(robot)
        walk = WalkingController(model, description, settings, VelocityProfile.constant(0.0))
        set_ = walk.settings
        scale = leg_length(model, description) / LEG
        single, double = (float(set_.T_ss), float(set_.T_ds))
        given = {
            "Tc": float(walk.Tc),
            "sole": (float(description.left.length), float(description.left.width)),
            "step_width": float(set_.step_width),
            "velocity": float(velocity),
            "period": single + double,
            "double_support": double,
            "reach_forward": scale * cls.reach_forward,
            "reach_sideways": scale * cls.reach_sideways,
            "reach_across": scale * cls.reach_across,
            "shortest": min(cls.shortest, single),
        }
        try:
            return cls(**{**given, **changes})
        except TypeError as error:
            raise InputError(f"{error}") from None

    def __post_init__(self) -> None:
        for name in ("Tc", "step_width", "period", "sole_share", "reach_forward", "reach_sideways", "shortest"):
            value = getattr(self, name)
            if not (math.isfinite(value) and value > 0.0):
                raise InputError(f"{name} is {value}; it must be positive and finite")
        if not 0.0 <= self.double_support < self.period:
            raise InputError(f"double_support is {self.double_support} s; it must be from 0 to less than the period")

    def assumptions(self) -> str:
        """In words, for a figure."""
        steps = f"place and time of steps, single support {self.shortest:.2g} to {self.longest:.2g} s"
        if not self.timing:
            steps = f"place of steps, T = {self.period:.2g} s"
        feet = "feet may cross" if self.crossing else "feet never cross"
        return (
            f"pendulum with T_c {self.Tc:.3f} s: {steps}, reach {self.reach_forward:.2f} m forward and "
            f"{self.reach_sideways:.2f} m sideways, {100 * self.sole_share:.0f} % of the sole, {feet}"
        )


def pendulum_limit(
    walk: PendulumWalk | None = None,
    directions: int | Sequence[float] = 12,
    phases: int | Sequence[float] = 8,
    **changes: Any,
) -> np.ndarray:
    """The largest impulse from which some sequence of steps recovers, by phase and direction.

    Both axes share the time of the landing. Until then the DCM may be held back by the edge of the sole; at the landing
    it must be within what the sole of the new foot and the steps after it can hold, with the new foot within reach. A
    push in double support is judged at the lift-off that follows, for the foot that carries then.

    Args:
        walk: the pendulum and its assumptions; None takes `PendulumWalk.of()`, the bundled robot at 0.25 m/s.
        directions: how many, evenly spaced from 0 on, or angles [degrees]: 0 forward, 90 outwards for the stance foot.
        phases: how many, i / n of the way from a lift-off to the next, or such shares. A robot that stands has one.
        changes: fields of `walk` to change, such as crossing=True.

    Returns:
        (phases, directions) [N s/kg]. `.min(axis=0)` is the worst phase of each direction.

    Raises:
        InputError: an assumption that makes no sense.

    Usage: `pendulum_limit(directions=[90], timing=False).min()`
    """
    walk = replace(PendulumWalk.of() if walk is None else walk, **changes)
    angles = 360.0 * np.arange(directions) / directions if isinstance(directions, int) else np.asarray(directions)
    shares = np.arange(phases) / phases if isinstance(phases, int) else np.asarray(phases)
    if walk.velocity == 0.0:
        shares = shares[:1]
    return np.array([[_largest(walk, float(share), math.radians(angle)) for angle in angles] for share in shares])


def _largest(walk: PendulumWalk, share: float, angle: float) -> float:
    t = share * walk.period
    if walk.velocity == 0.0:
        angle, t = math.atan2(abs(math.sin(angle)), math.cos(angle)), 0.0  # both sides are outwards
    elif t > walk.period - walk.double_support + 1e-9:
        angle, t = -angle, 0.0  # the other foot is the next to stand alone
    low, high = 0.0, LARGEST
    if _recovers(walk, t, angle, high):
        return high
    while high - low > RESOLUTION:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _recovers(walk, t, angle, middle) else (low, middle)
    return low


def _recovers(walk: PendulumWalk, t: float, angle: float, impulse: float) -> bool:
    """Whether a push `t` after a lift-off can be caught: both axes must hold for some time of the landing.

    x is forward of the stance foot and u inwards, towards the swing foot.
    """
    omega, exchange = 1.0 / walk.Tc, 0.5 * walk.double_support
    a, w = 0.5 * walk.sole_share * np.asarray(walk.sole)
    apart = walk.step_width if math.isnan(walk.feet_apart) else walk.feet_apart
    grown = math.exp(omega * walk.period)
    if walk.velocity == 0.0:
        x, u = 0.0, 0.5 * walk.step_width
    else:  # the DCM of steady walking, its feet changed half a double support before the lift-off
        now = math.exp(omega * (t + exchange))
        x, u = walk.velocity * walk.period / (grown - 1.0) * now, walk.step_width / (grown + 1.0) * now
    x, u = x + walk.Tc * impulse * math.cos(angle), u - walk.Tc * impulse * math.sin(angle)

    lost = 0.5 * walk.push_time
    if walk.timing:
        growth = math.exp(omega * walk.shortest)  # of a later step
        first = max(walk.shortest - t, 0.0)
        left = np.linspace(first, max(walk.longest - t, first), LANDINGS)
    else:
        growth = grown
        left = np.array([walk.period - exchange - t])
    left = np.maximum(left - lost, 0.0)
    shrink = np.exp(-omega * left)

    # How far beyond the edge of the next sole the DCM may be when it lands, by what later steps can do.
    ahead = walk.reach_forward / (growth - 1.0) if walk.later_steps else 0.0
    outside = 0.0
    if walk.crossing:
        outside = (growth * walk.reach_across + walk.reach_sideways) / (growth**2 - 1.0)
    inside = (walk.reach_sideways + outside) / growth
    holds = np.abs(x) <= a + (walk.reach_forward + ahead) * shrink
    inwards = u <= w + (walk.reach_sideways + outside) * shrink
    outwards = u >= -w + np.maximum(apart - inside, 0.0) * shrink
    if walk.crossing:
        across = u >= -w - (walk.reach_across + inside) * shrink
        outwards |= across & (left >= max(walk.cross_time - t, 0.0) - lost - 1e-9)
    return bool(np.any(holds & inwards & outwards))


def leg_length(model: mujoco.MjModel, description: Any) -> float:
    """From the hip to the knee and on to the ankle of the left leg [m]."""
    data = mujoco.MjData(model)
    description.place(model, data)
    *hip, knee, ankle, _ = (
        data.xanchor[mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name)] for name in description.left.leg_joints
    )
    return float(max(np.linalg.norm(knee - joint) for joint in hip) + np.linalg.norm(ankle - knee))
