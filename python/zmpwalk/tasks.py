"""Tasks that the robot fulfils while it walks: hands hold a pose, joints or the angular momentum follow, or yours."""

from __future__ import annotations

import math
from typing import Any, Callable, Mapping, Protocol, Sequence, Union

import numpy as np

from . import _core
from .errors import InputError
from .motion import JointMotion

__all__ = ["FrameTask", "JointTask", "MomentumTask", "Task"]

DIFFERENCE = 1e-3  # between the poses of which velocity and acceleration are the differences [s]
Pose = Union[Sequence[float], Mapping[str, Any], "_core.PoseReference"]


class Task(Protocol):
    """A task in Python: any object with this method.

    `compute` runs once when the task is added, which tells its number of rows and the frames that it asks for, and
    then in every cycle. A `priority` and a `weight` may be its attributes, as those of `FrameTask`. What it raises ends
    the cycle and passes on; the controller then needs a `reset`.
    """

    def compute(self, state: _core.TaskState) -> tuple[Any, Any, Any]:
        """Rows of the task at this instant: J ddq + drift = f_star.

        Args:
            state: `state.t` [s], `state.heading` [rad], `state.dynamics` (q, dq, com, J_com, A, ...) and
                `state.frame(name)`: p_WF, R_WF, velocity, J (6, nv), drift (6,) of a body or site.

        Returns:
            J (m, nv), drift (m,) = Jdot dq, f_star (m,): the commanded acceleration.
        """
        ...


class _Described:
    """Remembers how a task was made, so that a trace can hold it."""

    _made: dict[str, Any]
    _changed = ""

    def to_dict(self) -> dict[str, Any]:
        """How the task was made, in plain values.

        Raises:
            InputError: a reference that only Python code knows, or that was set while the robot walked.

        Usage: `zmpwalk.tasks.from_dict(task.to_dict())`
        """
        if self._changed:
            raise InputError(self._changed)
        return {"type": type(self).__name__, **self._made}


class FrameTask(_Described, _core.FrameTask):
    """Lets the frame of a body or a site follow a pose: a hand points, holds something, or carries a tray.

    Without a reference the frame stays where it is when the task begins. With a reference it goes there within the
    blend time of `add`, without a jump in position or speed, and then follows it. f* = a_ref + k_p (x_ref - x) + k_d
    (v_ref - v).

    Args:
        frame: name of a body or a site of the robot.
        part: which rows the task takes: "position", "orientation" or "pose", both.
        position: (3,) [m] reference.
        orientation: reference: a quaternion (w, x, y, z) or a matrix (3, 3).
        reference: instead of both, a function of the time since the task began [s] that returns what `set` takes:
            a position, or a dictionary of `position`, `orientation`, `velocity` and `acceleration`. Where it gives no
            velocity and acceleration, differences of the poses a millisecond apart take their place.
        relative_to: the frame that the reference is given in: "world"; "walk": origin at the COM, x along the walk's
            heading, z up; "trunk": the base's.
        kp, kd: gains [1/s^2, 1/s].
        priority: tasks of smaller numbers come first; of equal ones, that which was added first.
        weight: share of the task's correction that is applied, more than 0 and at most 1; the rest is left to the
            tasks after it, and to the posture.

    Raises:
        InputError: an unknown part or relative_to, a negative gain, something that is not finite or no rotation.

    Usage: `controller.add(FrameTask("left_hand", "orientation", relative_to="walk"))`
    """

    def __init__(
        self,
        frame: str,
        part: str = "pose",
        *,
        position: Sequence[float] | None = None,
        orientation: Any = None,
        reference: Callable[[float], Pose] | None = None,
        relative_to: str = "world",
        kp: float = 400.0,
        kd: float = 40.0,
        priority: int = 0,
        weight: float = 1.0,
    ):
        super().__init__(frame, part, relative_to, kp, kd)
        self.priority, self.weight, self._part = priority, weight, part
        given = {"position": position, "orientation": orientation}
        self._made = {
            "frame": frame,
            "part": part,
            **{name: None if value is None else np.asarray(value, float).tolist() for name, value in given.items()},
            "relative_to": relative_to,
            "kp": float(kp),
            "kd": float(kd),
            "priority": int(priority),
            "weight": float(weight),
        }
        if reference is not None:
            if position is not None or orientation is not None:
                raise InputError("a frame task has a position and an orientation, or a reference that gives them")
            self.follow(reference)
        elif position is not None or orientation is not None:
            super().set(self._pose(position, orientation))

    def set(  # type: ignore[override]
        self,
        position: Sequence[float] | None = None,
        orientation: Any = None,
        velocity: Sequence[float] | None = None,
        acceleration: Sequence[float] | None = None,
    ) -> None:
        """From the next cycle on, the reference is this one; call it as often as every cycle.

        The task follows at once: a reference that jumps makes it pull. Velocity and acceleration are fed forward.

        Args:
            position: (3,) [m]; a task on the orientation alone needs none.
            orientation: quaternion (w, x, y, z) or matrix (3, 3); a task on the position alone needs none.
            velocity: (3,) linear, or (6,) linear and angular [m/s, rad/s]; None is at rest.
            acceleration: the same [m/s^2, rad/s^2].

        Raises:
            InputError: something is missing, is not finite, or is no rotation.

        Usage: `task.set(position=[0.4, 0.2, 1.0], velocity=[0.1, 0, 0])`
        """
        super().set(self._pose(position, orientation, velocity, acceleration))
        self._changed = "its reference was set by Python code"

    def follow(self, reference: Callable[[float], Pose]) -> None:  # type: ignore[override]
        """Let the reference be a function of the time since the task began [s]; see the class.

        Usage: `task.follow(lambda t: [0.4, 0.2 + 0.05 * math.sin(3 * t), 1.0])`
        """
        super().follow(lambda t: self._sample(reference, t))
        self._changed = "its reference is a Python function"

    def _pose(
        self, position: Any = None, orientation: Any = None, velocity: Any = None, acceleration: Any = None
    ) -> _core.PoseReference:
        if position is None and self._part != "orientation":
            raise InputError(f"a frame task on the {self._part} needs a position")
        if orientation is None and self._part != "position":
            raise InputError(f"a frame task on the {self._part} needs an orientation")
        return _core.PoseReference(
            p=np.zeros(3) if position is None else np.asarray(position, float),
            R=np.eye(3) if orientation is None else _rotation(orientation),
            velocity=_six("velocity", velocity),
            acceleration=_six("acceleration", acceleration),
        )

    def _sample(self, reference: Callable[[float], Pose], t: float) -> _core.PoseReference:
        now = reference(t)
        if isinstance(now, _core.PoseReference):
            return now
        if isinstance(now, Mapping):
            out = self._pose(**now)
            if "velocity" in now:
                return out
        else:
            out = self._pose(position=now)
        h = DIFFERENCE
        before, after = (
            self._pose(**value) if isinstance(value, Mapping) else self._pose(position=value)
            for value in (reference(t - h), reference(t + h))
        )
        out.velocity = np.concatenate([after.p - before.p, _turn(before.R, after.R)]) / (2 * h)
        out.acceleration = (
            np.concatenate([after.p - 2 * out.p + before.p, _turn(out.R, after.R) - _turn(before.R, out.R)]) / h**2
        )
        return out


class JointTask(_Described, _core.JointTask):
    """Lets joints outside the legs follow references.

    Args:
        joints: {name: position [rad or m]}; or names, which stay where they are when the task begins; or a
            `JointMotion`, followed from then on.
        kp, kd, priority, weight: as those of `FrameTask`.

    Raises:
        InputError: no joint, a name twice, a negative gain; by `add`: a joint that is not there or is a leg's, a
            reference beyond its range.

    Usage: `controller.add(JointTask({"l_elbow": -1.2, "l_wrist_yaw": 0.5}))`
    """

    def __init__(
        self,
        joints: Mapping[str, float] | Sequence[str] | JointMotion,
        *,
        kp: float = 400.0,
        kd: float = 40.0,
        priority: int = 0,
        weight: float = 1.0,
    ):
        names = list(joints.names if isinstance(joints, JointMotion) else joints)
        super().__init__(names, kp, kd)
        self.priority, self.weight, self._names = priority, weight, names
        described: Any = names
        if isinstance(joints, JointMotion):
            super().follow(joints)
            described = {"motion": joints.to_dict()}
        elif isinstance(joints, Mapping):
            described = {name: float(value) for name, value in joints.items()}
            super().set(np.array(list(described.values())), np.zeros(len(names)), np.zeros(len(names)))
        self._made = {
            "joints": described,
            "kp": float(kp),
            "kd": float(kd),
            "priority": int(priority),
            "weight": float(weight),
        }

    def set(  # type: ignore[override]
        self, q: Sequence[float], dq: Sequence[float] | None = None, ddq: Sequence[float] | None = None
    ) -> None:
        """From the next cycle on, the references are these; call it as often as every cycle.

        Args:
            q: (m,) [rad or m], in the order of the names.
            dq: (m,) fed forward; None is at rest.
            ddq: (m,) fed forward; None is zero.

        Raises:
            DimensionError; InputError: not finite, or beyond a joint's range.

        Usage: `task.set([-1.2, 0.5])`
        """
        zero = np.zeros(len(self._names))
        super().set(*(zero if value is None else np.asarray(value, float) for value in (q, dq, ddq)))
        self._changed = "its reference was set by Python code"


class MomentumTask(_Described, _core.MomentumTask):
    """Keeps the angular momentum L about the COM small, by moving arms and waist.

    f* = k_d (L_ref - L), where L_ref is that of one body which turns as the walk turns. The task does not bring the
    arms home. With a weight below 1 it leaves a share to the posture, which does.

    Args:
        axes: "yaw": about the vertical; "all": about all three axes.
        kd: gain [1/s].
        priority, weight: as those of `FrameTask`.

    Raises:
        InputError: unknown axes, a negative gain.

    Usage: `controller.add(MomentumTask("yaw", weight=0.9))`
    """

    def __init__(self, axes: str = "yaw", *, kd: float = 20.0, priority: int = 0, weight: float = 1.0):
        super().__init__(axes, kd)
        self.priority, self.weight = priority, weight
        self._made = {"axes": axes, "kd": float(kd), "priority": int(priority), "weight": float(weight)}


def core_task(task: Any) -> _core.Task:
    """The task in the form that the core takes: `task` itself, or a wrapper of a Python object with `compute`.

    Raises:
        InputError: neither.

    Usage: `controller.add(...)` calls it.
    """
    if isinstance(task, _core.Task):
        return task
    if not callable(getattr(task, "compute", None)):
        raise InputError(f"{task!r} is no task: it needs a method compute(state) that returns J, drift, f_star")
    wrapped = _core.PythonTask(task)
    wrapped.priority, wrapped.weight = int(getattr(task, "priority", 0)), float(getattr(task, "weight", 1.0))
    return wrapped


def to_dict(task: Any) -> dict[str, Any]:
    """What a trace keeps of a task: how it was made, or the reason why that cannot be told (`cannot_rerun`).

    Usage: `to_dict(FrameTask("left_hand"))["type"]`
    """
    name = type(task).__name__
    try:
        return (
            task.to_dict() if isinstance(task, _Described) else {"type": name, "cannot_rerun": f"{name} is Python code"}
        )
    except InputError as error:
        return {"type": name, "cannot_rerun": str(error)}


def from_dict(made: Mapping[str, Any]) -> Any:
    """The task that `to_dict` describes.

    Raises:
        InputError: it cannot be made from numbers alone; says why.

    Usage: `from_dict(trace.meta["tasks"][0]["task"])`
    """
    arguments = dict(made)
    name = arguments.pop("type")
    if "cannot_rerun" in arguments:
        raise InputError(f"the task '{name}' of this trace is not in it: {arguments['cannot_rerun']}")
    if name == "JointTask" and "motion" in arguments["joints"]:
        arguments["joints"] = JointMotion.from_dict(arguments["joints"]["motion"])
    if name == "MomentumTask":
        return MomentumTask(**arguments)
    return (FrameTask if name == "FrameTask" else JointTask)(**arguments)


def _rotation(orientation: Any) -> np.ndarray:
    """A quaternion (w, x, y, z) or a matrix (3, 3) as a matrix."""
    value = np.asarray(orientation, float)
    if value.shape == (3, 3):
        return value
    norm = float(np.linalg.norm(value)) if value.shape == (4,) else 0.0
    if not (math.isfinite(norm) and norm > 0):
        raise InputError(f"orientation is {orientation!r}; it must be a quaternion (w, x, y, z) or a matrix (3, 3)")
    w, x, y, z = value / norm
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def _turn(R: np.ndarray, R_to: np.ndarray) -> np.ndarray:
    """Rotation vector that turns `R` into `R_to`, for turns well below half a revolution [rad]."""
    D = R_to @ R.T
    axis = 0.5 * np.array([D[2, 1] - D[1, 2], D[0, 2] - D[2, 0], D[1, 0] - D[0, 1]])
    sine = float(np.linalg.norm(axis))
    return axis if sine < 1e-12 else axis * math.atan2(sine, 0.5 * (np.trace(D) - 1.0)) / sine


def _six(name: str, value: Any) -> np.ndarray:
    """Linear and angular parts (6,) of what was given as (3,), (6,) or None."""
    array = np.zeros(6) if value is None else np.asarray(value, float)
    if array.shape not in ((3,), (6,)):
        raise InputError(f"{name} has shape {array.shape}; it must be (3,), linear, or (6,), linear and angular")
    return np.concatenate([array, np.zeros(3)]) if len(array) == 3 else array
