"""Walking from Python: the controller, the recorder, and the closed loop that runs in C++."""

from __future__ import annotations

import hashlib
import inspect
import math
import os
import platform
import threading
import warnings
from dataclasses import dataclass, field
from typing import Any, Callable, Iterable, Mapping, Sequence, Union

import mujoco
import numpy as np

from . import _core, tasks
from ._build import VERSION
from .checks import positive
from .disturbances import Push, Pushes, Uncertainty, pushes_of, uncertainty_of
from .errors import InputError
from .given import Settings, settings_of
from .motion import JointMotion
from .profiles import Profile, VelocityProfile, profile_of, three
from .robots import Robot, RobotDescription, describe, description_to_dict
from .robots.source import Given, Source, given_source, model_bytes
from .terrain import GroundLike, KnownGround, Terrain, TerrainLike, known_of, load_scene, scene_model
from .trace import Trace, plain

__all__ = ["Recorder", "WalkingController", "simulate", "simulate_batch"]

Progress = Callable[[float, float], None]
Steer = Callable[[float, Any], Union[float, Sequence[float], None]]
COMMAND_INTERVAL = 0.02  # between calls of `command` [s]
ON_FALL = ("stop", "go_on")
LONGEST = 1e7  # walk [s]
_NO_MOTION = _core.JointMotion([0.0], [], np.zeros((1, 0)))


class WalkingController(_core.WalkingController):
    """The walking controller: in each cycle `update` takes the state of the robot and gives the joint torques.

    Args:
        model: MuJoCo's model, of which the robot may be only a part.
        description: where feet and legs are, and how the robot stands; None reads it from the model's own marks
            (`describe`).
        settings: gains, bounds and switches: `WalkSettings`, a dictionary of changes, a law's name or a TOML file;
            None takes `WalkSettings()`.
        profile: planned velocity: a `VelocityProfile`, vx [m/s], (vx, vy, wz), pairs (t, v), a text such as
            "0:0.1,2:0.2" or a CSV file; None takes `VelocityProfile.paper()`.
        source: the file that the model was compiled from, or its text, for traces (`simulate`).
        ground: the ground that the controller knows (`KnownGround.of`): a `Terrain` or its text, a `KnownGround`, an
            hfield of the model, or a function f(x, y) of the height; None: what the feet feel is all that is known.

    Raises:
        ModelError: the model lacks what the description names, or cannot walk.
        InputError: a setting breaks its rule, or the profile is faster than reach, torques or friction
            allow; the message says the limit.

    Usage: `controller = zmpwalk.WalkingController(model); controller.reset(data); out = controller.update(data)`
    """

    def __init__(
        self,
        model: mujoco.MjModel,
        description: RobotDescription | None = None,
        settings: Settings = None,
        profile: Profile = None,
        source: Given = None,
        ground: GroundLike | None = None,
    ):
        super().__init__(
            model,
            describe(model) if description is None else description,
            settings=settings_of(settings),
            profile=profile_of(profile),
        )
        self._model = model
        if ground is not None:
            self.know(ground)
        self._source = given_source(source, model) if source is not None else None
        self._tasks: list[dict[str, Any]] = []  # which task was added in which cycle, and in which it was removed

    def __repr__(self) -> str:
        robot = f"{self.description.name}, {len(self.joint_names)} joints, {self.mass:.1f} kg"
        return f"WalkingController({robot}, law {self.settings.law})"

    @property
    def model(self) -> mujoco.MjModel:
        """The model that was given."""
        return self._model

    @property
    def source(self) -> Source | None:
        """The files that the model was compiled from; None where it was not loaded from a file or was changed since."""
        return self._source or given_source(None, self._model)

    @property
    def profile(self) -> VelocityProfile:
        """The planned velocity."""
        return VelocityProfile.of(super().profile)

    @property
    def motion(self) -> JointMotion | None:  # type: ignore[override]
        """The joint motion that is followed; None where there is none."""
        return JointMotion.of(super().motion) if super().motion.names else None

    def know(self, ground: GroundLike | None) -> None:  # type: ignore[override]
        """Tell the controller the ground that the robot walks on; it counts from the next `reset` on.

        Feet are set on flat places near the planned ones, swing over what lies between, and land with the ground's
        tilt; the COM rises and sinks with the feet. Heights count from those of the soles at `reset`.

        Args:
            ground: what `KnownGround.of` takes; None takes back what was told.

        Raises:
            InputError: it is no ground. `reset` raises it where the robot does not stand on this ground.

        Usage: `controller.know("stairs:12x28")`
        """
        super().know(_core.KnownGround() if ground is None else KnownGround.of(ground, self._model))

    def move(self, motion: _core.JointMotion | None) -> None:
        """Let arms, waist and trunk follow a motion from the last cycle on, while the legs walk.

        The posture and trunk tasks follow position, speed and acceleration of the motion:
        f* = ddq_ref + k_p (q_ref - q) + k_d (dq_ref - dq). Within the setting `motion_blend` the reference goes over
        into the motion without a jump in position, speed or acceleration. Joints that the motion does not name go back
        to the start pose. `reset` begins the motion anew. Call it between cycles.

        Args:
            motion: None takes everything back to the start pose.

        Raises:
            InputError: a name is no joint or is a joint of a leg, a joint goes beyond its range, the trunk turns by
                more than half of the setting `fall_tilt`, or the posture task is off. Nothing is changed then.

        Usage: `controller.move(JointMotion([0, 1], ["l_elbow"], [[-0.3], [-1.5]]))`
        """
        super().move(_NO_MOTION if motion is None else motion)

    def reset(self, data: mujoco.MjData | _core.State) -> None:
        """Start a walk from the state in `data`, and move nothing yet. Tasks that were added begin anew.

        Raises:
            InputError: the state is not finite.

        Usage: `controller.reset(data)`
        """
        super().reset(data)
        self._begin_tasks_anew()

    def add(self, task: Any, blend: float = math.nan) -> None:  # type: ignore[override]
        """Let the robot do something besides walking, with the joints outside the legs, from the next cycle on.

        The walk's own tasks come first: contacts, swing foot, COM, trunk. The added tasks use the motions that these
        leave free, in the order of their `priority` numbers. The posture, with the motion (`move`) and the swinging
        arms (`momentum_arms`), gets the rest. The estimate of the ZMP takes all of it into account. Call it between
        cycles.

        Args:
            task: a `FrameTask`, `JointTask`, `MomentumTask`, or an object of yours with `compute(state)`
                (`zmpwalk.tasks.Task`).
            blend: time within which the task gains its effect [s]; NaN takes the setting `motion_blend`.

        Raises:
            InputError: the robot has no such name, the task was added already, here or to another controller, its
                weight is not above 0 and at most 1, or the settings do not allow tasks (with `textbook`, or without
                `posture_task` or `wrench_distribution`). Whatever the `compute` of your own task raises.

        Usage: `controller.add(zmpwalk.FrameTask("left_hand"))`
        """
        for entry in self._tasks:
            if entry["given"] is task and entry["remove"] is None:
                raise InputError("this task has been added already")
        core = tasks.core_task(task)
        super().add(core, blend)
        self._tasks.append({"given": task, "core": core, "add": [self.cycles, blend], "remove": None})

    def remove(self, task: Any, blend: float = math.nan) -> None:  # type: ignore[override]
        """End a task that was added; its effect fades within `blend`. Call it between cycles.

        Args:
            task: the object that `add` was given.
            blend: [s]; NaN takes the setting `motion_blend`.

        Raises:
            InputError: it has not been added, or was removed since.

        Usage: `controller.remove(task, blend=1.0)`
        """
        for entry in self._tasks:
            if entry["given"] is task and entry["remove"] is None:
                super().remove(entry["core"], blend)
                entry["remove"] = [self.cycles, blend]
                return
        raise InputError("this task has not been added, or has been removed since")

    def _begin_tasks_anew(self) -> None:
        """After a reset: what is still there was added before the first cycle."""
        self._tasks = [{**entry, "add": [0, entry["add"][1]]} for entry in self._tasks if entry["remove"] is None]

    def _task_record(self) -> list[dict[str, Any]]:
        """The tasks as a trace keeps them."""
        given = [id(entry["given"]) for entry in self._tasks]
        return [
            {
                "task": tasks.to_dict(entry["given"]),
                "same_as": given.index(id(entry["given"])),  # a task that came back
                "add": entry["add"],
                "remove": entry["remove"],
            }
            for entry in self._tasks
        ]


class Recorder:
    """Collects the cycles of your own loop into a `Trace`.

    Args:
        controller: the controller whose cycles are recorded.
        robot: the name that the trace carries; None takes the description's.

    Usage: see `add`.
    """

    def __init__(self, controller: WalkingController, robot: str | None = None):
        self._controller = controller
        self._recorder = _core.Recorder(controller)
        self._robot = robot
        self._cause = ""
        self._foreseen = (math.nan, "")

    def add(self, out: _core.CycleOutput, data: mujoco.MjData) -> None:
        """Record one cycle. Call it right after `mj_step`, because only then are the contact forces of this cycle
        known.

        Args:
            out: what `controller.update(data)` returned before the step.
            data: the simulator's data after the step.

        Usage: `out = controller.update(data); mujoco.mj_step(model, data); recorder.add(out, data)`
        """
        self._recorder.add(out, data)
        self._cause = self._cause or str(getattr(out, "fall_cause", "") or "")
        if out.fall_foreseen and not self._foreseen[1]:
            self._foreseen = (out.foreseen_time, out.foreseen_cause)

    def trace(self) -> Trace:
        """Everything that was recorded so far.

        Returns:
            The trace; its `meta["timing"]` is empty, for only `simulate` measures the time of a cycle.

        Usage: `recorder.trace().save("walk.npz")`
        """
        columns = self._recorder.columns()
        fallen = np.flatnonzero(columns["fell"])
        info = {
            "fell": bool(len(fallen)),
            "fall_time": float(columns["t"][fallen[0]]) if len(fallen) else math.nan,
            "fall_cause": self._cause,
            "alarm_time": self._foreseen[0],
            "alarm_cause": self._foreseen[1],
        }
        model, meta = _describe_run(self._controller, self._robot, info, source="recorder")
        return Trace(columns, meta, model, copy=False, source=self._controller.source)


def simulate(
    robot: Robot = "mahru",
    profile: Profile = None,
    duration: float = 8.0,
    settings: Settings = None,
    on_progress: Progress | None = None,
    seed: int = 0,
    motion: _core.JointMotion | None = None,
    command: Steer | None = None,
    tasks: Sequence[Any] = (),
    push: Pushes = (),
    on_fall: str = "stop",
    uncertainty: Uncertainty | Mapping[str, Any] | None = None,
    simulated: Robot | None = None,
    terrain: TerrainLike | None = None,
    source: Given = None,
    known: bool = False,
    ground: GroundLike | None = None,
) -> Trace:
    """Walk a robot in MuJoCo, wholly in C++, and return what was recorded.

    The robot starts in the pose of its description. The run ends after `duration`, or when the robot falls. A fall is
    no error: `trace.meta` says when and why it happened.

    Args:
        robot: what `load_robot` takes: a name, a path, a model, or (model, description).
        profile: planned velocity: a `VelocityProfile`, vx [m/s], (vx, vy, wz), pairs (t, v), a text such as
            "0:0.1,2:0.2" or a CSV file; None takes `VelocityProfile.paper()`.
        duration: simulated time [s], positive.
        settings: `WalkSettings`, a dictionary of changes, a law's name or a TOML file; None takes `WalkSettings()`.
        on_progress: called about ten times a second with (t, duration) [s]; what it raises stops the run and passes on.
        seed: of all that is random: the noise of the sensors, the links that `uncertainty` changes.
        motion: what arms, waist and trunk do meanwhile (`WalkingController.move`); None keeps them in the start pose.
        command: called as f(t [s], out) with the `CycleOutput` of the first cycle and then every 0.02 s of simulated
            time. It returns the velocity to walk with from the next cycle on (`WalkingController.command`): vx or
            (vx, vy, wz) in the heading frame [m/s, m/s, rad/s]. None leaves the command as it is; until the first
            command the profile leads. StopIteration ends the walk; any other exception stops the run and passes on.
        tasks: tasks that the robot fulfils besides walking, from the start (`WalkingController.add`).
        push: a force from outside, or several, each (t [s], duration [s], body, force [N]): a constant force
            (fx, fy, fz) in the world's axes, or with a torque (fx, fy, fz, tx, ty, tz) [N m], at the centre of mass of
            a body during [t, t + duration). The body None is the trunk: the first body whose name holds "torso" or
            "trunk", else the root body. `Push.impulse` makes one from its impulse. The controller is not told.
        on_fall: "stop" ends the walk where the controller says that the robot has fallen. "go_on" takes this for an
            alarm and ends only where the robot lies on the ground (something beside
            its legs touches it, or the COM has come down to 30 % of its height) or is not finite: these alone are
            falls then. `trace.fall` keeps the fall, and since when it was foreseen; a fall that is only foreseen ends
            no walk.
        uncertainty: what the controller does not know, or not in time: an `Uncertainty`, or a dictionary of its fields.
        simulated: the robot that is simulated, where it is not the one that the controller knows: it must have the
            bodies that the description names, and the same joints in the same order. `uncertainty` changes this one.
        terrain: ground in place of the floor of the robot's scene: a `Terrain` or a text such as "slope:5",
            "blocks:2,7" or "stairs:12x28" (`Terrain.of`). The controller is not told, unless `known` says so.
        source: what `robot` was compiled from where it is an `MjModel`: the path of its MJCF or URDF, the text of an
            MJCF, or (text, {file name: content}). The trace keeps it, so that it can be filmed and run again under any
            MuJoCo. A robot that is given by name or path brings its own.
        known: whether the controller knows the `terrain` (`WalkingController.know`).
        ground: what it knows of the ground, where that is something else than the terrain (`KnownGround.of`).

    Returns:
        The trace, one row per control cycle.

    Raises:
        InputError: a duration, setting, speed, command, push or uncertainty breaks its rule.
        ModelError: the robot cannot walk, or the simulated one does not fit the controller's.
        KeyboardInterrupt: Ctrl-C, within 0.1 s.

    Usage: `trace = zmpwalk.simulate("mahru", profile=0.2, duration=10, settings={"step_height": 0.05})`
        `zmpwalk.simulate(profile=0.0, command=lambda t, out: (0.2, 0.0, 0.3 - out.heading))`
        `zmpwalk.simulate(duration=12, push=[(4.0, 0.08, None, (0, 100, 0))], on_fall="go_on")`
        `zmpwalk.simulate(uncertainty={"noise": 1, "torque_delay": 0.004}, seed=3)`
        `zmpwalk.simulate(profile=0.25, terrain="blocks:1", duration=30)`
        `zmpwalk.simulate(profile=0.25, terrain="stairs:12x28", known=True, duration=20)`
    """
    model, description = load_scene(robot, _as_seen(terrain), source)
    knows = known_of(known, ground, terrain)
    controller = WalkingController(model, description, settings, profile, source, knows)
    controller.move(motion)
    for task in tasks:
        controller.add(task)
    simulated = _simulated(robot, terrain, simulated)
    outside = Outside.of(controller, seed, push, on_fall, uncertainty, simulated, terrain)
    return run(controller, duration, on_progress, seed, name_of(robot), command, outside=outside)


def simulate_batch(
    runs: Iterable[Mapping[str, Any]],
    threads: int | None = None,
    on_progress: Progress | None = None,
) -> list[Trace]:
    """Walk many times, side by side on threads. Each walk has its own controller and data; equal robots share a model.

    The interpreter's lock is free while walks run. A trace has the same bits whatever the number of threads.

    Args:
        runs: one mapping for each walk, with the arguments of `simulate` except on_progress.
        threads: how many walk at a time; None takes the processors this process may use.
        on_progress: called now and then with (t, duration) [s], simulated time of all walks together.

    Returns:
        The traces, in the order of `runs`.

    Raises:
        What `simulate` raises for any of the runs, before the first begins where it can be known; then no trace is
        returned. InputError: an argument that `simulate` does not have, threads < 1. KeyboardInterrupt: Ctrl-C.

    Usage: `simulate_batch([{"profile": v, "seed": i} for i, v in enumerate(speeds)])`
    """
    if threads is None:
        threads = processors()
    if isinstance(threads, bool) or not isinstance(threads, (int, np.integer)) or threads < 1:
        raise InputError(f"threads is {threads!r}; it must be an integer of at least 1")
    known = tuple(name for name in inspect.signature(simulate).parameters if name != "on_progress")
    robots: dict[Any, tuple[mujoco.MjModel, RobotDescription]] = {}
    jobs = []
    runs = list(runs)  # keeps models alive that are told apart by their id
    for i, given in enumerate(runs):
        for name in given:
            if name not in known:
                raise InputError(f"run {i} has '{name}'; a run has only {', '.join(known)}")
        robot, terrain = given.get("robot", "mahru"), given.get("terrain")
        key = tuple(each if isinstance(each, (str, os.PathLike)) else id(each) for each in (robot, terrain))
        if key not in robots:
            robots[key] = load_scene(robot, _as_seen(terrain), given.get("source"))
        knows = known_of(given.get("known", False), given.get("ground"), terrain)
        controller = WalkingController(
            *robots[key], given.get("settings"), given.get("profile"), given.get("source"), knows
        )
        controller.move(given.get("motion"))
        for task in given.get("tasks", ()):
            controller.add(task)
        duration, seed = check_duration(given.get("duration", 8.0), controller), _check_seed(given.get("seed", 0))
        outside = Outside.of(
            controller, seed, given.get("push", ()), given.get("on_fall", "stop"), given.get("uncertainty"),
            _simulated(robot, terrain, given.get("simulated")), terrain,
        )  # fmt: skip
        outside.simulation(controller)  # what is wrong with it is said before the first walk begins
        jobs.append((controller, duration, seed, name_of(robot), given.get("command"), outside))

    done, total = [0.0] * len(jobs), sum(job[1] for job in jobs)
    stop = threading.Event()

    def walk(i: int) -> Trace:
        def at(t: float, duration: float) -> None:
            done[i] = t
            if stop.is_set():
                raise _Stopped

        controller, duration, seed, label, command, outside = jobs[i]
        at(0.0, duration)
        trace = run(controller, duration, at, seed, label, command, outside=outside)
        done[i] = duration
        return trace

    from concurrent import futures as threaded

    with threaded.ThreadPoolExecutor(threads, thread_name_prefix="zmpwalk") as pool:
        futures: list[Any] = []
        try:  # Ctrl-C may come while jobs are handed over, too
            for i in range(len(jobs)):
                futures.append(pool.submit(walk, i))
            waiting = set(futures)
            while waiting:
                finished, _ = threaded.wait(waiting, timeout=0.05, return_when=threaded.FIRST_EXCEPTION)
                for future in finished:
                    future.result()
                    waiting.discard(future)
                if on_progress:
                    on_progress(sum(done), total)
        finally:
            stop.set()
            for future in futures:
                future.cancel()
    return [future.result() for future in futures]


def processors() -> int:
    """How many processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class _Stopped(Exception):
    """Ends a walk whose batch has ended."""


def run(
    controller: WalkingController,
    duration: float,
    on_progress: Progress | None = None,
    seed: int = 0,
    robot: str | None = None,
    command: Steer | None = None,
    command_interval: float = COMMAND_INTERVAL,
    outside: Outside | None = None,
) -> Trace:
    """`simulate` with a controller that exists already; `robot` is the name that the trace carries.

    Usage: `run(zmpwalk.WalkingController(*zmpwalk.load_robot("mahru")), 8.0)`
    """
    duration = check_duration(duration, controller)
    seed = _check_seed(seed)
    # Always with a callback: running Python now and then is what lets Ctrl-C through.
    progress = on_progress or (lambda t, duration: None)
    steer: Any = None if command is None else lambda t, out: _velocity(command(t, out))
    controller._begin_tasks_anew()
    outside = outside or Outside()
    columns, info = outside.simulation(controller).run(duration, progress, steer, command_interval, outside.on_fall)
    if info["stopped"]:
        duration = len(columns["t"]) * float(controller.settings.control_dt)
    model, meta = _describe_run(
        controller, robot, info, source="simulate", seed=seed, requested_duration=duration, **outside.to_dict()
    )
    simulated = None if outside.simulated is None else model_bytes(outside.simulated)
    return Trace(columns, meta, model, False, simulated, controller.source, outside.source)


@dataclass(frozen=True)
class Outside:
    """What acts on a walk from outside the controller, ready to be simulated and to be told by a trace."""

    push: Sequence[Push] = ()
    on_fall: str = "stop"
    uncertainty: Uncertainty = field(default_factory=Uncertainty)
    simulated: mujoco.MjModel | None = None
    """in truth, `uncertainty` included; None where it is the controller's model"""
    seed: int = 0
    given: bool = False
    """whether the simulated robot was given, as another than the controller's"""
    source: Source | None = None
    """what that robot was compiled from"""
    terrain: str | None = None
    """the ground that was given, in words"""

    @classmethod
    def of(
        cls,
        controller: WalkingController,
        seed: int = 0,
        push: Pushes = (),
        on_fall: str = "stop",
        uncertainty: Uncertainty | Mapping[str, Any] | None = None,
        simulated: Robot | None = None,
        terrain: TerrainLike | None = None,
    ) -> Outside:
        """From the arguments of `simulate`, checked as far as can be without a simulation."""
        if on_fall not in ON_FALL:
            raise InputError(f"on_fall is {on_fall!r}; it must be {' or '.join(ON_FALL)}")
        pushes = [each._replace(body=each.body or _core.trunk_body(controller)) for each in pushes_of(push)]
        unsure = uncertainty_of(uncertainty)
        given = model = None if simulated is None else scene_model(simulated, terrain)
        source = None if given is None else given_source(None, given)
        if unsure.changes_model:
            known = controller.model if model is None else model
            model = unsure.changed(known, unsure.root_of(known, controller.description), _check_seed(seed))
        ground = None if terrain is None else Terrain.of(terrain).text
        return cls(pushes, on_fall, unsure, model, _check_seed(seed), given is not None, source, ground)

    @classmethod
    def again(cls, trace: Trace) -> Outside:
        """What acted on the walk of a trace."""
        meta = trace.meta
        return cls(
            pushes_of(meta.get("push", ())), meta.get("on_fall", "stop"), uncertainty_of(meta.get("uncertainty")),
            trace.simulated_model if meta.get("simulated_sha256") else None, meta.get("seed", 0),
            meta.get("simulated_given", False), trace._simulated_source, meta.get("terrain"),
        )  # fmt: skip

    def simulation(self, controller: WalkingController) -> _core.Simulation:
        """A new one with all of this."""
        simulation = _core.Simulation(controller, self.uncertainty.signals(self.seed), self.simulated)
        for each in self.push:
            simulation.push(each.t, each.duration, each.body or "", [*each.force, 0.0, 0.0, 0.0][:6])
        return simulation

    def to_dict(self) -> dict[str, Any]:
        """As the meta data of a trace keep it."""
        sha = None if self.simulated is None else hashlib.sha256(model_bytes(self.simulated)).hexdigest()
        return {
            "push": [list(each) for each in self.push],
            "on_fall": self.on_fall,
            "uncertainty": self.uncertainty.to_dict(),
            "simulated_sha256": sha,
            "terrain": self.terrain,
            "simulated_given": self.given,
        }


def _as_seen(terrain: TerrainLike | None) -> TerrainLike | None:
    """The ground as the controller's model has it: how slippery its patches are has to be felt."""
    return None if terrain is None else Terrain.of(terrain).as_floor()


def _simulated(robot: Robot, terrain: TerrainLike | None, simulated: Robot | None) -> Robot | None:
    """The robot that is simulated; None where it is the controller's, on ground that is as the controller's."""
    hidden = terrain is not None and any(each.friction is not None for each in Terrain.of(terrain).patches)
    return robot if simulated is None and hidden else simulated


def _velocity(v: float | Sequence[float] | None) -> np.ndarray | None:
    return None if v is None else three(v)


def name_of(robot: Robot) -> str | None:
    """The name by which a trace calls `robot`: the one that was given, None for a path or a model."""
    return robot if isinstance(robot, str) and robot.isidentifier() else None


def _check_seed(seed: int) -> int:
    if isinstance(seed, bool) or not isinstance(seed, (int, np.integer)):
        raise InputError(f"seed is {seed!r}; it must be an integer")
    return int(seed)


def check_duration(duration: float, controller: WalkingController | None = None) -> float:
    """Returns `duration` [s] as a number.

    Args:
        controller: of the walk, whose record has to find room in the memory of this machine.

    Raises:
        InputError: not a positive, finite number, or longer than can be recorded.
    """
    duration = positive("duration", duration, most=LONGEST)
    if controller is not None:
        row = 8 * sum(int(np.prod(column.shape[1:])) for column in _core.Recorder(controller).columns().values())
        room, dt = _memory(), float(controller.settings.control_dt)
        if duration / dt * row > room:
            raise InputError(
                f"duration is {duration:g} s; the record of such a walk takes {duration / dt * row / 1e9:.3g} GB, and "
                f"there is room for {room / 1e9:.3g} GB: walk at most {room * dt / row:.0f} s at a time"
            )
    return duration


def _memory() -> float:
    """How much a record may take: half of the memory of this machine [bytes]."""
    try:
        return 0.5 * os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    except (AttributeError, OSError, ValueError):
        return 4e9


def rerun(trace: Trace, on_progress: Progress | None = None) -> Trace:
    """See `Trace.rerun`: the same loop from the trace's own model, description, settings and profile."""
    again = _rerun(trace, on_progress)
    walked_by = trace.meta.get("versions", {}).get("mujoco")
    if walked_by != mujoco.__version__:
        rows = min(len(again.t), len(trace.t))
        away = float(np.abs(again.com[:rows] - trace.com[:rows]).max(initial=0.0))
        again.meta["rerun_of"] = {"mujoco": walked_by, "com_away": away, "rows": rows}
        warnings.warn(
            f"MuJoCo {walked_by} walked this and MuJoCo {mujoco.__version__} repeated it, so the two may part: within "
            f"{rows * trace.control_dt:g} s the COM went up to {away:.1e} m away from the recorded one",
            stacklevel=3,
        )
    return again


def _rerun(trace: Trace, on_progress: Progress | None) -> Trace:
    model = trace.model
    known = trace.meta.get("known_ground")
    ground = None if known is None else KnownGround.from_dict(known)
    controller = WalkingController(model, trace.description, trace.settings, trace.profile, ground=ground)
    controller._source = trace._source
    controller.move(trace.motion)
    change_tasks = _tasks_again(controller, trace)
    change_tasks(0)
    robot = trace.meta.get("robot")
    commands = trace.get("command", np.full((len(trace.t), 3), math.nan))
    changed = set(
        np.flatnonzero(~((commands[1:] == commands[:-1]) | np.isnan(commands[1:])).all(axis=1)).tolist()
    )  # rows before
    if trace.meta.get("source") != "recorder":
        given = {float(trace.t[k]): commands[k + 1] for k in changed}
        duration, seed = trace.meta["requested_duration"], trace.meta.get("seed", 0)

        def command(t: float, out: Any) -> Any:
            change_tasks(controller.cycles)
            return given.get(t)

        steer = command if given or trace.meta.get("tasks") else None
        return run(controller, duration, on_progress, seed, robot, steer, 0.0, Outside.again(trace))
    data = mujoco.MjData(model)
    set_state(trace, model, data, 0)
    data.time = trace.t[0]
    controller.reset(data)
    recorder = Recorder(controller, robot)
    for k in range(len(trace.t)):
        if k - 1 in changed:
            controller.command(*commands[k])
        if k > 0:
            change_tasks(k)
        for _ in range(max(1, round(trace.control_dt / model.opt.timestep))):
            out = controller.update(data)
            mujoco.mj_step(model, data)
            recorder.add(out, data)
        if on_progress and k % 100 == 0:
            on_progress(data.time - trace.t[0], trace.duration)
    return recorder.trace()


def _tasks_again(controller: WalkingController, trace: Trace) -> Callable[[int], None]:
    """Adds and removes the tasks of a trace; the result is to be called between cycles with the number of the next.

    Raises:
        InputError: a task that is in the trace by its name only.
    """
    recorded = trace.meta.get("tasks") or []
    made = [tasks.from_dict(entry["task"]) for entry in recorded]
    again = [made[entry["same_as"]] for entry in recorded]
    changes = [(entry["add"], controller.add, task) for entry, task in zip(recorded, again)]
    changes += [(entry["remove"], controller.remove, task) for entry, task in zip(recorded, again) if entry["remove"]]
    changes.sort(key=lambda change: change[0][0])

    def change(cycle: int) -> None:
        while changes and changes[0][0][0] <= cycle:
            (_, blend), act, task = changes.pop(0)
            act(task, blend)

    return change


def set_state(trace: Trace, model: mujoco.MjModel, data: mujoco.MjData, k: int) -> None:
    """Put the robot of row `k` into `data`, by name, whatever else is in the scene; then `mj_forward`."""
    foot = trace.meta["description"]["left"]["foot_body"]
    base = model.body_rootid[mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, foot)]
    root = model.body_jntadr[base]
    q, v = int(model.jnt_qposadr[root]), int(model.jnt_dofadr[root])
    data.qpos[q : q + trace.qpos.shape[1]] = trace.qpos[k]
    data.qvel[v : v + trace.qvel.shape[1]] = trace.qvel[k]
    mujoco.mj_forward(model, data)


def _describe_run(
    controller: WalkingController, robot: str | None, info: dict[str, Any], source: str, **more: Any
) -> tuple[bytes, dict[str, Any]]:
    """The compiled model's bytes and the meta data of a trace."""
    model, settings = controller.model, controller.settings
    compiled = model_bytes(model)
    control_dt = float(settings.control_dt)
    fell = bool(info["fell"])
    meta = {
        "robot": robot or controller.description.name,
        "source": source,
        "seed": 0,
        **more,
        "settings": settings.to_dict(),
        "description": description_to_dict(controller.description),
        "profile": VelocityProfile.of(controller.profile).to_dict(),
        "motion": controller.motion and controller.motion.to_dict(),
        "tasks": controller._task_record(),
        "known_ground": KnownGround.to_dict(controller.ground) if controller.ground.known else None,
        "versions": _versions(),
        "model_sha256": hashlib.sha256(compiled).hexdigest(),
        "timestep": model.opt.timestep,
        "control_dt": control_dt,
        "joint_names": list(controller.joint_names),
        "torque_limits": np.asarray(controller.torque_limit),
        "joint_ranges": _joint_ranges(model, controller.joint_names),
        "fell": fell,
        "fall_time": float(info["fall_time"]) if fell else None,
        "fall_cause": str(info["fall_cause"] or "") if fell else "",
        "alarm_time": info.get("alarm_time") if info.get("alarm_cause") else None,
        "alarm_cause": info.get("alarm_cause", ""),
        "timing": _timing(info, control_dt),
    }
    return compiled, plain(meta)


def _joint_ranges(model: mujoco.MjModel, names: Iterable[str]) -> list[list[float] | None]:
    """Ends of the range of each joint [rad or m]; None for a joint that has none."""
    joints = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name) for name in names]
    return [model.jnt_range[j].tolist() if model.jnt_limited[j] else None for j in joints]


def _versions() -> dict[str, str]:
    return {
        "zmpwalk": VERSION,
        "mujoco": mujoco.__version__,
        "numpy": np.__version__,
        "python": platform.python_version(),
        "machine": platform.machine(),
    }


def _timing(info: dict[str, Any], control_dt: float) -> dict[str, Any]:
    cycle_us = np.asarray(info.get("cycle_us", ()), float)
    if not len(cycle_us):
        return {}
    wall_time = float(info["wall_time"])
    return {
        "cycle_us": {
            "median": np.median(cycle_us),
            "p99": np.percentile(cycle_us, 99),
            "mean": cycle_us.mean(),
            "max": cycle_us.max(),
        },
        "wall_time": wall_time,
        "real_time_factor": len(cycle_us) * control_dt / wall_time if wall_time > 0 else None,
    }
