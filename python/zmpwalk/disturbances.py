"""What a simulated walk has to bear: pushes from outside, and that the controller does not know everything exactly."""

from __future__ import annotations

import copy
import dataclasses
import math
import reprlib
from dataclasses import dataclass
from typing import Any, Iterable, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import mujoco
import numpy as np

from . import _core
from .checks import MOST, is_number
from .errors import InputError, nearest

__all__ = ["Push", "Pushes", "Uncertainty", "pushes_of", "uncertainty_of"]

# Sensor noise x 1: standard deviations, white and Gaussian, fresh in each cycle.
ENCODER = math.radians(0.05)  # joint positions [rad]
JOINT_SPEED = 0.02  # [rad/s]
GYRO = math.radians(0.5)  # [rad/s]
ATTITUDE = math.radians(0.5)  # about each axis of the base [rad]
BASE_SPEED = 0.03  # along each axis [m/s]
PUSH_DURATION = 0.08  # of a push that is given by its impulse [s]


class Push(NamedTuple):
    """A constant force on a body for a while: neither the controller nor its model is told.

    `t` and `duration` are in seconds, `force` is (fx, fy, fz) [N] in the world's axes, or six numbers where a torque
    [N m] comes after it. It acts at the centre of mass of `body`; None takes the trunk: the first body whose name
    holds "torso" or "trunk", else the root body.
    """

    t: float
    duration: float
    body: str | None
    force: Sequence[float]

    @classmethod
    def impulse(
        cls, t: float, impulse: Sequence[float], duration: float = PUSH_DURATION, body: str | None = None
    ) -> Push:
        """The push that gives an impulse (jx, jy, jz) [N s] within `duration`: a force of `impulse / duration`.

        Divided by the robot's mass it is the change of the COM's velocity that the push causes.

        Raises:
            InputError: `duration` is not positive, or `impulse` has another size.

        Usage: `zmpwalk.simulate(push=zmpwalk.Push.impulse(4.0, (0, 20, 0)))`
        """
        if not (math.isfinite(duration) and duration > 0.0):
            raise InputError(f"duration is {duration:g} s; it must be positive and finite")
        if len(impulse) not in (3, 6):
            raise InputError(f"the impulse is {reprlib.repr(impulse)}; it must be three numbers (jx, jy, jz) [N s]")
        return cls(t, duration, body, tuple(float(value) / duration for value in impulse))


OnePush = Union[Push, Tuple[float, float, Optional[str], Sequence[float]], str]
Pushes = Union[OnePush, Iterable[OnePush]]


def pushes_of(push: Pushes) -> list[Push]:
    """The pushes that were given in one of these forms.

    Args:
        push: one or several, each (t, duration, body, force), or a text "T:DURATION:BODY:FX,FY,FZ" whose BODY may be
            empty; three more numbers are a torque.

    Raises:
        InputError: something else, or a number without measure. Whether the body exists, the simulation says.

    Usage: `pushes_of([(3.0, 0.08, "torso", (0, 50, 0)), "5:0.08::100,0,0"])`
    """
    given: Any = push
    alone = isinstance(given, (str, Push)) or (
        isinstance(given, tuple) and len(given) == 4 and isinstance(given[0], (int, float))
    )  # fmt: skip
    return [_push_of(each) for each in ([given] if alone else given)]


def _push_of(push: Any) -> Push:
    words: Any = push
    if isinstance(push, str):
        words = push.split(":")
        words = [*words[:3], words[3].split(",")] if len(words) == 4 else ()
    try:
        t, duration, body, force = words
        wrench = [float(value) for value in force]
        numbers = [float(t), float(duration), *wrench]
        if len(wrench) in (3, 6) and (body is None or isinstance(body, str)):
            if not all(abs(number) <= MOST for number in numbers):  # nor is not-a-number
                raise InputError(f"the push {reprlib.repr(push)} has a number that is not finite or beyond {MOST:g}")
            return Push(numbers[0], numbers[1], body or None, tuple(wrench))
    except InputError:
        raise
    except (OverflowError, TypeError, ValueError):
        pass
    raise InputError(
        f"the push {reprlib.repr(push)} is not one: it is (t, duration, body, (fx, fy, fz)) [s, s, -, N] with a body's "
        'name or None for the trunk, or the text "T:DURATION:BODY:FX,FY,FZ"; Push.impulse(t, (jx, jy, jz)) makes one '
        "of an impulse [N s]"
    )


@dataclass(frozen=True)
class Uncertainty:
    """What the controller does not know, or not in time. By default it knows everything, and the walk keeps its bits.

    What is random is drawn anew from the `seed` of `simulate`: equal seeds give equal walks.
    """

    noise: float = 0.0
    """scale of the sensors' noise; 1 is 0.05 degrees of the joints, 0.02 rad/s of their speeds, 0.5 degrees/s of the
    gyro, 0.5 degrees of the attitude and 0.03 m/s of the base's speed: standard deviations, white, fresh each cycle"""
    roll_bias: float = 0.0
    """of the measured attitude about the base's x [rad]"""
    pitch_bias: float = 0.0
    """the same about its y [rad]"""
    state_delay: float = 0.0
    """age of the measured positions and velocities [s]"""
    torque_delay: float = 0.0
    """from a torque's decision to its effect [s]"""
    lag: float = 0.0
    """time constant with which a drive takes a torque up [s]"""
    mass: float = 1.0
    """of every link of the simulated robot, with its inertia, as a factor"""
    inertia: float = 1.0
    """moments of inertia of every link, besides, as a factor"""
    links: float = 0.0
    """mass and inertia of each link by itself are changed by up to this share, at random"""
    com: float = 0.0
    """the COM of each link is moved by up to this along each of its axes, at random [m]"""
    dry_friction: float = 0.0
    """that every joint of the simulated robot has besides [N m]"""
    ground_friction: float | None = None
    """sliding friction of all contacts; None leaves the model's"""

    def __post_init__(self) -> None:
        for field in dataclasses.fields(self):
            value = getattr(self, field.name)
            if field.name == "ground_friction" and value is None:
                continue
            if not is_number(value):
                raise InputError(f"{field.name} is {reprlib.repr(value)}; it must be a finite number")
            if field.name in ("mass", "inertia", "ground_friction") and value <= 0.0:
                raise InputError(f"{field.name} is {value:g}; it must be positive")
            if field.name not in ("roll_bias", "pitch_bias") and value < 0.0:
                raise InputError(f"{field.name} is {value:g}; it must be at least 0")
        if self.links >= 1.0:
            raise InputError(f"links is {self.links:g}; a link's mass can be changed by less than all of it")

    def scaled(self, share: float) -> Uncertainty:
        """The same at `share` of its strength: 0 is none, 0.5 half; a factor's distance from 1 is what is scaled.

        The ground's friction goes the same share of the way from 1.

        Usage: `Uncertainty(noise=2, torque_delay=0.008).scaled(0.5)`
        """
        values: dict[str, Any] = {}
        for field in dataclasses.fields(self):
            value, neutral = getattr(self, field.name), 1.0 if field.name in ("mass", "inertia") else 0.0
            if field.name == "ground_friction":
                neutral = 1.0
            values[field.name] = None if value is None else neutral + share * (value - neutral)
        return Uncertainty(**values)

    def to_dict(self) -> dict[str, float | None]:
        """Plain numbers; `Uncertainty(**d)` reads them."""
        return dataclasses.asdict(self)

    def signals(self, seed: int) -> _core.SignalUncertainty:
        """What lies between robot and controller."""
        out = _core.SignalUncertainty()
        out.noise.joint, out.noise.joint_speed = self.noise * ENCODER, self.noise * JOINT_SPEED
        out.noise.gyro, out.noise.attitude = self.noise * GYRO, self.noise * ATTITUDE
        out.noise.base_speed = self.noise * BASE_SPEED
        out.roll_bias, out.pitch_bias = self.roll_bias, self.pitch_bias
        out.state_delay, out.torque_delay, out.lag = self.state_delay, self.torque_delay, self.lag
        out.seed = seed % 2**64
        return out

    @property
    def changes_model(self) -> bool:
        """Whether the simulated robot differs from the one that the controller knows."""
        own = (self.mass, self.inertia, self.links, self.com, self.dry_friction, self.ground_friction)
        return own != (1.0, 1.0, 0.0, 0.0, 0.0, None)

    @staticmethod
    def root_of(model: mujoco.MjModel, description: _core.RobotDescription) -> int:
        """The body at the root of the tree that the robot is."""
        foot = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, description.left.body)
        return int(model.body_rootid[max(foot, 0)])

    def changed(self, model: mujoco.MjModel, root: int, seed: int) -> mujoco.MjModel:
        """A copy of `model` whose robot, the tree under the body `root`, is what it is in truth."""
        out, random = copy.copy(model), np.random.default_rng(seed % 2**64)
        bodies = np.flatnonzero(np.asarray(out.body_rootid) == root)
        masses = self.mass * (1.0 + self.links * random.uniform(-1.0, 1.0, len(bodies)))
        moments = self.inertia * masses
        moves = self.com * random.uniform(-1.0, 1.0, (len(bodies), 3))
        out.body_mass[bodies] *= masses
        out.body_inertia[bodies] *= moments[:, None]
        if self.com:
            out.body_ipos[bodies] += moves
            out.body_sameframe[bodies] = 0
            out.body_simple[bodies] = 0
        joints = np.flatnonzero(np.isin(np.asarray(out.dof_bodyid), bodies))
        joints = joints[np.asarray(out.jnt_type)[np.asarray(out.dof_jntid)[joints]] != mujoco.mjtJoint.mjJNT_FREE]
        out.dof_frictionloss[joints] += self.dry_friction
        if self.ground_friction is not None:
            out.geom_friction[:, 0] = self.ground_friction
            out.pair_friction[:, :2] = self.ground_friction
        mujoco.mj_setConst(out, mujoco.MjData(out))
        return out


def uncertainty_of(given: Uncertainty | Mapping[str, Any] | None) -> Uncertainty:
    """None knows everything; a mapping names the fields that differ.

    Raises:
        InputError: an unknown name, or a value it cannot have.

    Usage: `uncertainty_of({"noise": 1})`
    """
    if isinstance(given, Uncertainty):
        return given
    if given is not None and not isinstance(given, Mapping):
        raise InputError(f"uncertainty is {reprlib.repr(given)}; it must be an Uncertainty or a dict {{name: value}}")
    known = [field.name for field in dataclasses.fields(Uncertainty)]
    for name in given or ():
        if name not in known:
            near = ", ".join(nearest(str(name), known))
            raise InputError(f"there is no uncertainty '{name}'; the nearest names are {near}")
    return Uncertainty(**(given or {}))
