"""Joint motions say what arms, waist and trunk do while the legs walk."""

from __future__ import annotations

import csv
import io
import math
import os
from typing import Any, Callable, Mapping, Protocol, Sequence

import mujoco
import numpy as np

from . import _core
from .checks import positive, samples
from .errors import InputError
from .files import read_text

__all__ = ["JointMotion"]

UNLIMITED = math.pi / 2  # how far from its stand a random motion takes a joint without limits [rad]


class OfRobot(Protocol):
    """What a random motion asks of a controller: the robot, and the names of its joints."""

    @property
    def model(self) -> mujoco.MjModel: ...

    @property
    def description(self) -> _core.RobotDescription: ...

    @property
    def joint_names(self) -> list[str]: ...

    @property
    def arm_joints(self) -> list[str]: ...


class JointMotion(_core.JointMotion):
    """A motion of joints that is known beforehand: a cubic spline through knots, with continuous acceleration.

    It starts and ends at rest, and keeps its last value. Besides the model's joints it may name `trunk_roll`,
    `trunk_pitch` and `trunk_yaw` [rad]. They turn the trunk from its orientation at the start by
    R_z(yaw) R_y(pitch) R_x(roll), in the heading frame.

    Args:
        t: (n,) [s] knots, the first 0, strictly increasing.
        names: (m,) the joint of each column, each once.
        q: (n, m) [rad or m] positions at the knots.

    Raises:
        InputError: NaN or infinity, no knots, first t not 0, t not increasing, a name twice.
        DimensionError: `q` is not (n, m).

    Usage: `controller.move(JointMotion([0, 2], ["l_shoulder_pitch", "l_elbow"], [[0, -0.3], [-1.2, -1.0]]))`
    """

    @classmethod
    def from_function(
        cls,
        f: Callable[[float], Sequence[float]],
        names: Sequence[str],
        duration: float,
        dt: float = 0.02,
        ease: float = 0.5,
    ) -> JointMotion:
        """Sample a function of time. Its clock starts and stops gently, so that any function starts and ends at rest.

        Args:
            f: time [s], 0 to duration - ease, -> (m,) positions [rad or m].
            names: (m,) joints.
            duration: [s] of the motion, more than 2 ease.
            dt: [s] between knots.
            ease: [s] in which the clock comes up to speed, and stops again; more than 0.

        Raises:
            InputError: as the class; durations that are not positive or too short.

        Usage: `JointMotion.from_function(lambda t: [0.3 * math.sin(3 * t)], ["waist_yaw"], duration=20)`
        """
        duration, dt, ease = positive("duration", duration), positive("dt", dt), positive("ease", ease)
        if duration <= 2 * ease:
            raise InputError(f"duration is {duration:g} s; it must be more than twice ease, {ease:g} s")
        t = np.linspace(0.0, duration, samples(duration, dt) + 1)
        # Clock rate 3 s^2 - 2 s^3 within `ease` of either end, s = 0 at the end itself.
        begun, left = (np.clip(x / ease, 0, 1) for x in (t, duration - t))
        lost = ease * (begun - begun**3 + begun**4 / 2 - left + left**3 - left**4 / 2 + 0.5)
        return cls(t, list(names), np.array([f(s) for s in (t - lost).tolist()], float).reshape(len(t), -1))

    @classmethod
    def sine(
        cls,
        amplitude: Mapping[str, float],
        frequency: float,
        duration: float,
        centre: Mapping[str, float] | None = None,
        phase: Mapping[str, float] | None = None,
    ) -> JointMotion:
        """centre + amplitude sin(2 pi frequency t + phase), eased in and out over one period.

        Args:
            amplitude: [rad or m] by joint; a negative one swings against the others.
            frequency: [Hz].
            duration: [s], more than two periods.
            centre: [rad or m] by joint, 0 where not given.
            phase: [rad] by joint, 0 where not given.

        Raises:
            InputError: as `from_function`.

        Usage: `JointMotion.sine({"l_shoulder_pitch": 0.5, "r_shoulder_pitch": -0.5}, frequency=1.0, duration=10)`
        """
        frequency = positive("frequency", frequency, "Hz")
        a = np.array(list(amplitude.values()), float)
        c, p = (np.array([(given or {}).get(name, 0.0) for name in amplitude], float) for given in (centre, phase))
        omega = 2 * math.pi * frequency
        return cls.from_function(
            lambda t: c + a * np.sin(omega * t + p), list(amplitude), duration, 0.04 / frequency, 1 / frequency
        )

    @classmethod
    def random(
        cls,
        controller: OfRobot,
        seed: int,
        max_speed: float = 3.0,
        duration: float = 30.0,
        spacing: float = 0.5,
        names: Sequence[str] | None = None,
    ) -> JointMotion:
        """Go to random targets within the joints' limits, from the start pose and back to it.

        Args:
            controller: the `WalkingController` of the robot that it is for.
            seed: of the generator.
            max_speed: [rad/s or m/s] that no joint exceeds: its excursions are scaled down to it.
            duration: [s].
            spacing: [s] between targets.
            names: joints; None takes the arms'.

        Raises:
            InputError: a name that is no joint; numbers that are not positive.

        Usage: `controller.move(JointMotion.random(controller, seed=3))`
        """
        max_speed = positive("max_speed", max_speed, "rad/s")
        duration, spacing = positive("duration", duration), positive("spacing", spacing)
        names = list(controller.arm_joints if names is None else names)
        for name in names:
            if name not in controller.joint_names:
                raise InputError(f"'{name}' is no joint; there are {', '.join(controller.joint_names)}")
        model, rng = controller.model, np.random.default_rng(seed)
        stand = np.array([controller.description.stand_joints[name] for name in names])
        joints = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name) for name in names]
        limited = model.jnt_limited[joints] != 0
        low = np.where(limited, model.jnt_range[joints, 0], stand - UNLIMITED)
        high = np.where(limited, model.jnt_range[joints, 1], stand + UNLIMITED)
        t = np.linspace(0.0, duration, max(2, samples(duration, spacing) + 1))
        q = np.tile(stand, (len(t), 1))
        for k in range(1, len(t) - 1):
            q[k] = rng.uniform(low, high)
        # The spline is linear in its knots: scaling a joint's way from the stand scales its speed and its overshoot.
        fine = np.linspace(0.0, duration, 20 * len(t))
        motion = cls(t, names, q)
        sampled = np.array([motion.at(s) for s in fine])
        away, speed = sampled[:, 0] - stand, np.abs(sampled[:, 1])
        up, down, fast = (np.maximum(x.max(axis=0), 1e-9) for x in (away, -away, speed))
        share = np.minimum.reduce([np.ones(len(names)), (high - stand) / up, (stand - low) / down, max_speed / fast])
        return cls(t, names, stand + 0.99 * share * (q - stand))

    @classmethod
    def from_csv(cls, path: str | os.PathLike) -> JointMotion:
        """Read a table whose header is t and the joints' names; one knot a line.

        Args:
            path: the CSV file; t [s], then [rad or m].

        Raises:
            InputError: no such file, or a value that is missing or no number; the message names file, line and rule.

        Usage: `JointMotion.from_csv("wave.csv")`
        """
        name = os.fspath(path)
        table = csv.reader(io.StringIO(read_text(path, "a CSV text file"), newline=""))
        try:
            rows = [(number, [cell.strip() for cell in row]) for number, row in enumerate(table, 1)]
        except csv.Error as error:
            raise InputError(f"{name}: not a CSV text file ({error})") from None
        rows = [(number, row) for number, row in rows if any(row) and not row[0].startswith("#")]
        if len(rows) < 2 or rows[0][1][0] != "t":
            raise InputError(f"{name}: a motion needs the header 't,JOINT,...' and a line for each knot, from t = 0 on")
        names, values = rows[0][1][1:], []
        for number, row in rows[1:]:
            try:
                values.append([float(cell) for cell in row])
            except ValueError as error:
                raise InputError(f"{name}, line {number}: {error}; every value must be a number") from None
            if len(row) != len(names) + 1:
                raise InputError(f"{name}, line {number}: {len(row)} values where the header has {len(names) + 1}")
        knots = np.array(values)
        try:
            return cls(knots[:, 0], names, knots[:, 1:])
        except InputError as error:
            raise InputError(f"{name}: {error}") from None

    @classmethod
    def of(cls, motion: _core.JointMotion) -> JointMotion:
        """The same motion as this class, which can be saved and printed.

        Usage: `JointMotion.of(controller.motion)`
        """
        return motion if isinstance(motion, cls) else cls(motion.t, motion.names, motion.q)

    def to_dict(self) -> dict[str, Any]:
        """Plain lists, as they are stored in a trace.

        Returns:
            {"t": [...], "names": [...], "q": [[...], ...]}.

        Usage: `json.dumps(motion.to_dict())`
        """
        return {"t": self.t.tolist(), "names": list(self.names), "q": self.q.tolist()}

    @classmethod
    def from_dict(cls, plain: Mapping[str, Any]) -> JointMotion:
        """The inverse of `to_dict`.

        Raises:
            InputError: a key is missing.

        Usage: `JointMotion.from_dict(trace.meta["motion"])`
        """
        for key in ("t", "names", "q"):
            if key not in plain:
                raise InputError(f"a motion needs the key '{key}'; it has {', '.join(map(repr, plain)) or 'none'}")
        return cls(plain["t"], list(plain["names"]), np.asarray(plain["q"], float).reshape(len(plain["t"]), -1))

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (np.array(self.t), list(self.names), np.array(self.q))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _core.JointMotion) and self.to_dict() == JointMotion.of(other).to_dict()

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"JointMotion({', '.join(self.names) or 'nothing'}; {len(self.t)} knots to {self.duration:g} s)"
