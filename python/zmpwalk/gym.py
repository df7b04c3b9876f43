"""The walk as a Gymnasium environment, `zmpwalk/Walk-v0`: a robot that follows a point which goes at a given velocity.

What acts is a velocity command, or a torque besides the controller's. The environment needs the extra `gym`.

Usage:
    import gymnasium
    import zmpwalk.gym  # registers it
    env = gymnasium.make("zmpwalk/Walk-v0", pushes=(4.0, 0.15))
    envs = gymnasium.make_vec("zmpwalk/Walk-v0", num_envs=8)  # walks in C++, on all cores
"""

from __future__ import annotations

import math
from concurrent.futures import ThreadPoolExecutor
from typing import Any, Sequence

import mujoco
import numpy as np

from . import _core, render
from .analysis import feet_pose
from .disturbances import PUSH_DURATION
from .errors import InputError
from .given import Settings
from .robots import Robot, load_robot
from .simulation import WalkingController, processors

try:
    import gymnasium
    from gymnasium import spaces
except ImportError:
    raise ImportError("zmpwalk.gym needs Gymnasium: pip install gymnasium") from None

__all__ = ["ID", "Walk", "WalkVector"]

ID = "zmpwalk/Walk-v0"
ACTIONS = ("velocity", "torque")
# Largest command: forward and leftward as a share of sqrt(g z_c), turning as a share of 1 / T_c.
REACH = np.array([0.22, 0.06, 0.14])
PERIODS = {"velocity": 0.1, "torque": 0.02}  # between two actions [s]
CLOSE = 0.2  # distance from the point at which the reward has come down to 1 / e [m]
COLUMNS = (
    "com", "dcom", "foot_left", "foot_right", "zmp_est", "v_plan", "heading", "phase", "support", "phase_time", "qpos",
    "qvel",
)  # fmt: skip


class Walk(gymnasium.Env):
    """A robot that is to follow a point which goes at a velocity, while it may be pushed.

    The action is scaled to [-1, 1]. With action="velocity" it is (vx, vy, wz) in the heading frame, as a share of
    `reach`: the controller chooses the steps. With action="torque" the controller walks at the point's velocity, and
    the action is a torque for each joint besides the controller's, as a share of `residual` times its limit.

    An observation is, in the heading frame where it has a direction: how far the point is away (x, y, yaw), the point's
    velocity (vx, vy, wz), the planned velocity (vx, vy, wz), down in the trunk's axes (3), angular velocity of the
    trunk (3), velocity of the COM (3), COM from the support foot (3), the other foot from it (3), estimated ZMP from it
    (2), phase, support (1 left, -1 right), time since the phase began; then angles of the joints from the start pose
    and their speeds. SI units.

    The info of a reset holds the point's velocity and the number of pushes to come, that of a fall its "fall_cause".

    The reward of a step is exp(-(d / 0.2 m)^2) at the distance d from the point, at most 1. An episode ends at a fall,
    and is cut off after `duration`.

    Args:
        robot: what `load_robot` takes.
        action: "velocity" or "torque".
        duration: of an episode [s].
        velocity: of the point, (vx, vy, wz) or vx [m/s, rad/s]; None draws another at each reset.
        pushes: (mean time between pushes [s], their impulse [N s/kg]): pushes on the trunk of 0.08 s, from random
            sides; None for none.
        settings: of the controller, as for `simulate`.
        period: between two actions [s]; None takes 0.1 s for velocities and 0.02 s for torques.
        residual: share of each joint's limit that a torque of 1 is.
        render_mode: "rgb_array" or None.

    Raises:
        InputError: an argument breaks its rule.  ModelError: the robot cannot walk.

    Usage: `env = Walk(velocity=0.25); observation, info = env.reset(seed=0); env.step(env.action_space.sample())`
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": 10}  # noqa: RUF012  Gymnasium's name

    def __init__(
        self,
        robot: Robot = "mahru",
        action: str = "velocity",
        duration: float = 20.0,
        velocity: float | Sequence[float] | None = None,
        pushes: tuple[float, float] | None = None,
        settings: Settings = None,
        period: float | None = None,
        residual: float = 0.05,
        render_mode: str | None = None,
    ):
        if action not in ACTIONS:
            raise InputError(f"action is {action!r}; it must be {' or '.join(ACTIONS)}")
        if render_mode not in (None, "rgb_array"):
            raise InputError(f"render_mode is {render_mode!r}; it must be 'rgb_array' or None")
        if pushes is not None and not (len(pushes) == 2 and pushes[0] > 0 and pushes[1] >= 0):
            raise InputError(f"pushes is {pushes!r}; it must be (seconds between them, N s/kg)")
        self.render_mode, self._action, self._pushes = render_mode, action, pushes
        self._model, description = load_robot(robot)
        self.controller = WalkingController(self._model, description, settings, 0.0)
        dt = float(self.controller.settings.control_dt)
        self.period = dt * max(1, round((PERIODS[action] if period is None else period) / dt))
        self._steps = max(1, round(duration / self.period))
        self._given = None if velocity is None else np.append(np.atleast_1d(np.asarray(velocity, float)), [0, 0])[:3]
        c = self.controller
        gravity = c.com_height / c.Tc**2
        speed = math.sqrt(gravity * c.com_height)
        self.reach = REACH * [speed, speed, 1 / c.Tc]
        joints = [mujoco.mj_name2id(self._model, mujoco.mjtObj.mjOBJ_JOINT, name) for name in c.joint_names]
        self._dofs = self._model.jnt_dofadr[joints]
        stand = description.stand_joints
        self._stand = np.array([stand.get(name, 0.0) for name in c.joint_names])
        limits = np.asarray(c.torque_limit, float)
        self._residual = residual * np.where(np.isfinite(limits), limits, 0.1 * c.mass * gravity * c.com_height)
        self._free = np.array([str(c.torque_path[name]).startswith("qfrc_applied") for name in c.joint_names])
        self._simulation: Any = None
        self._data: Any = None
        self._screen: render.OffScreen | None = None
        size = 3 if action == "velocity" else len(c.joint_names)
        self.action_space = spaces.Box(-1.0, 1.0, (size,), np.float32)
        self.observation_space = spaces.Box(-np.inf, np.inf, (29 + 2 * len(c.joint_names),), np.float32)
        self.metadata = {**self.metadata, "render_fps": round(1 / self.period)}

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[np.ndarray, dict]:
        """Stand at the start pose, and draw the point's velocity and the pushes.

        Args:
            options: {"velocity": (vx, vy, wz)} for this episode.
        """
        super().reset(seed=seed)
        drawn = self.np_random.uniform([-0.3, -0.7, -0.7], [0.7, 0.7, 0.7]) * self.reach
        given = (options or {}).get("velocity", self._given)
        self.velocity = drawn if given is None else np.append(np.atleast_1d(np.asarray(given, float)), [0, 0])[:3]
        duration = self._steps * self.period
        self._schedule = self._draw_pushes(duration)
        self._count = 0
        if self._action == "velocity":
            self._simulation = _core.Simulation(self.controller)
            for t, wrench in self._schedule:
                self._simulation.push(t, PUSH_DURATION, "", wrench)
        else:
            self._data = mujoco.MjData(self._model)
            self.controller.description.place(self._model, self._data)
            self.controller.reset(self._data)
            trunk = _core.trunk_body(self.controller)
            self._trunk = mujoco.mj_name2id(self._model, mujoco.mjtObj.mjOBJ_BODY, trunk)
        self._advance(np.zeros(self.action_space.shape), first=True)
        start = feet_pose(self._row["foot_left"], self._row["foot_right"])
        self._point, self._far = start, np.zeros(3)
        return self._observation(), {"velocity": self.velocity.copy(), "pushes": len(self._schedule)}

    def step(self, action: np.ndarray) -> tuple[np.ndarray, float, bool, bool, dict]:
        """Walk on for `period` with an action."""
        self._advance(np.clip(np.asarray(action, float), -1.0, 1.0))
        self._point = moved(self._point, self.velocity, self.period)
        self._count += 1
        self._far = self._away()
        distance = math.hypot(self._far[0], self._far[1])
        reward = 0.0 if self._fell else math.exp(-((distance / CLOSE) ** 2))
        info = {"fall_cause": self._cause} if self._fell else {}
        return self._observation(), reward, self._fell, not self._fell and self._count >= self._steps, info

    def render(self) -> np.ndarray | None:
        """The robot as it stands (480, 640, 3) uint8, where render_mode is "rgb_array"."""
        if self.render_mode is None:
            return None
        if self._screen is None:
            self._screen = render.OffScreen(self._model, 640, 480)
        data = mujoco.MjData(self._model)
        data.qpos[:] = self._row["qpos"]
        mujoco.mj_forward(self._model, data)
        return self._screen.draw(data)

    def close(self) -> None:
        """Give the drawing surface back."""
        if self._screen is not None:
            self._screen.close()
            self._screen = None

    # --- the walk

    def _draw_pushes(self, duration: float) -> list[tuple[float, np.ndarray]]:
        """When the trunk is pushed, and by which wrench (6,) [N]."""
        found: list[tuple[float, np.ndarray]] = []
        if self._pushes is None:
            return found
        between, impulse = self._pushes
        t = 1.0 + self.np_random.exponential(between)
        while t < duration:
            side = self.np_random.uniform(0.0, 2.0 * np.pi)
            force = impulse * self.controller.mass / PUSH_DURATION * np.array([math.cos(side), math.sin(side)])
            found.append((float(t), np.append(force, [0.0, 0.0, 0.0, 0.0])))
            t += PUSH_DURATION + self.np_random.exponential(between)
        return found

    def _advance(self, action: np.ndarray, first: bool = False) -> None:
        dt = float(self.controller.settings.control_dt)
        if self._action == "velocity":
            if not first:
                self.controller.command(*(action * self.reach).tolist())
            columns, info = self._simulation.run(dt if first else self.period, only_last=True)
            self._row = {name: columns[name][-1] for name in COLUMNS}
            self._fell, self._cause = bool(info["fell"]), str(info["fall_cause"] or "")
            return
        if not first:
            self.controller.command(*self.velocity.tolist())
        for _ in range(1 if first else round(self.period / dt)):
            self._torque_cycle(action * self._residual, dt)
            if self._fell:
                break

    def _torque_cycle(self, torque: np.ndarray, dt: float) -> None:
        data, model = self._data, self._model
        state = {"qpos": data.qpos.copy(), "qvel": data.qvel.copy()}
        out = self.controller.update(data)
        data.qfrc_applied[self._dofs] = np.where(self._free, data.qfrc_applied[self._dofs], 0.0) + torque
        data.xfrc_applied[self._trunk] = sum(
            (wrench for t, wrench in self._schedule if t <= data.time < t + PUSH_DURATION), np.zeros(6)
        )  # fmt: skip
        for _ in range(max(1, round(dt / model.opt.timestep))):
            mujoco.mj_step(model, data)
        self._row = {**state, **{name: getattr(out, name) for name in COLUMNS if name not in state}}
        self._row = {
            name: float(value) if np.ndim(value) == 0 else np.array(value) for name, value in self._row.items()
        }
        self._fell, self._cause = bool(out.fell), str(out.fall_cause or "")

    # --- what is told

    def _away(self) -> np.ndarray:
        """The point from the middle of the feet: (x, y) in the heading frame [m], and its heading [rad]."""
        x, y, yaw = feet_pose(self._row["foot_left"], self._row["foot_right"])
        turn = (self._point[2] - yaw + np.pi) % (2 * np.pi) - np.pi
        return np.append(self._in_heading(self._point[:2] - [x, y]), turn)

    def _in_heading(self, v: np.ndarray) -> np.ndarray:
        """A vector of the world, its horizontal part turned into the heading frame."""
        c, s = math.cos(self._row["heading"]), math.sin(self._row["heading"])
        return np.array([c * v[0] + s * v[1], -s * v[0] + c * v[1], *v[2:]])

    def _observation(self) -> np.ndarray:
        row, left = self._row, self._row["support"] > 0
        own, other = (row["foot_left"], row["foot_right"]) if left else (row["foot_right"], row["foot_left"])
        w, x, y, z = row["qpos"][3:7]
        down = -np.array([2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)])
        zmp = row["zmp_est"] if np.isfinite(row["zmp_est"]).all() else own[:2]
        numbers = (
            self._far, self.velocity, row["v_plan"], down, row["qvel"][3:6], self._in_heading(row["dcom"]),
            self._in_heading(row["com"] - own[:3]), self._in_heading(other[:3] - own[:3]),
            self._in_heading(zmp - own[:2]), [row["phase"], row["support"], row["phase_time"]],
            row["qpos"][7:] - self._stand, row["qvel"][6:],
        )  # fmt: skip
        return np.concatenate(numbers).astype(np.float32)


class WalkVector(gymnasium.vector.VectorEnv):
    """Several `Walk` side by side on threads: the walks run in C++, without the interpreter's lock.

    An episode that has ended begins anew with the next step, whose action then has no effect.

    Args:
        num_envs: how many.
        threads: how many walk at a time; None takes the processors this process may use.
        options: those of `Walk`; with action="torque" the loop is Python's, and threads gain nothing.

    Usage: `envs = gymnasium.make_vec("zmpwalk/Walk-v0", num_envs=8); envs.reset(seed=0)`
    """

    def __init__(self, num_envs: int = 1, threads: int | None = None, **options: Any):
        self.num_envs = num_envs
        robot = options.pop("robot", "mahru")
        robot = load_robot(robot)  # one model for all
        self.envs = [Walk(robot, **options) for _ in range(num_envs)]
        self._pool = ThreadPoolExecutor(threads or processors(), thread_name_prefix="zmpwalk-gym")
        self.render_mode = self.envs[0].render_mode
        self.metadata = {**self.envs[0].metadata, "autoreset_mode": AUTORESET}
        self.single_action_space = self.envs[0].action_space
        self.single_observation_space = self.envs[0].observation_space
        self.action_space = gymnasium.vector.utils.batch_space(self.single_action_space, num_envs)
        self.observation_space = gymnasium.vector.utils.batch_space(self.single_observation_space, num_envs)
        self._ended = np.zeros(num_envs, bool)

    def reset(
        self, *, seed: int | Sequence[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[np.ndarray, dict[str, Any]]:
        """All anew; a single seed gives environment i the seed + i."""
        seeds: Any = seed
        if seed is None or isinstance(seed, (int, np.integer)):
            seeds = [None if seed is None else int(seed) + i for i in range(self.num_envs)]
        found = list(self._pool.map(lambda pair: pair[0].reset(seed=pair[1], options=options), zip(self.envs, seeds)))
        self._ended[:] = False
        return np.stack([observation for observation, _ in found]), self._infos([info for _, info in found])

    def step(self, actions: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, dict[str, Any]]:
        """One step of each, side by side."""

        def go(i: int) -> tuple:
            if self._ended[i]:
                observation, info = self.envs[i].reset()
                return observation, 0.0, False, False, info
            return self.envs[i].step(actions[i])

        observations, rewards, terminated, truncated, infos = zip(*self._pool.map(go, range(self.num_envs)))
        fell, cut = np.array(terminated, bool), np.array(truncated, bool)
        self._ended = fell | cut
        return np.stack(observations), np.array(rewards), fell, cut, self._infos(infos)

    def render(self) -> tuple[np.ndarray | None, ...]:
        """A picture of each."""
        return tuple(env.render() for env in self.envs)

    def close_extras(self, **options: Any) -> None:
        """End the threads."""
        self._pool.shutdown()
        for env in self.envs:
            env.close()

    def _infos(self, infos: Sequence[dict[str, Any]]) -> dict[str, Any]:
        found: dict[str, Any] = {}
        for i, info in enumerate(infos):
            found = self._add_info(found, info, i)
        return found


def moved(pose: np.ndarray, velocity: np.ndarray, seconds: float) -> np.ndarray:
    """Where a pose (x, y, yaw) is after it has gone at (vx, vy, wz) in its own axes.

    Usage: `moved(np.zeros(3), np.array([0.25, 0.0, 0.1]), 2.0)`
    """
    vx, vy, wz = map(float, velocity)
    half = 0.5 * wz * seconds
    chord, middle = seconds * (math.sin(half) / half if half else 1.0), float(pose[2]) + half
    c, s = chord * math.cos(middle), chord * math.sin(middle)
    return np.array([pose[0] + c * vx - s * vy, pose[1] + s * vx + c * vy, pose[2] + 2.0 * half])


_modes = getattr(gymnasium.vector, "AutoresetMode", None)
AUTORESET = None if _modes is None else _modes.NEXT_STEP

gymnasium.register(ID, entry_point="zmpwalk.gym:Walk", vector_entry_point="zmpwalk.gym:WalkVector")
