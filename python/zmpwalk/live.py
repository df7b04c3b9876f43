"""A walk that goes on bit by bit and obeys keys: what the window of `zmpwalk.view` shows, without the window."""

from __future__ import annotations

import itertools
import math
import os
from collections import deque
from pathlib import Path
from typing import Any, Sequence

import mujoco
import numpy as np

from ._core import trunk_body
from .analysis import feet_pose, mean_velocity, sole_yaw
from .disturbances import PUSH_DURATION
from .errors import InputError
from .given import Settings
from .render import PUSH_COLOUR, PUSH_SHOWN, crosses, push_arrow, sole_outline, stride, velocity_words
from .robots import Robot
from .robots.polygon import convex_hull
from .simulation import Recorder, WalkingController
from .terrain import TerrainLike, load_scene

__all__ = ["LEGEND", "LiveWalk", "Steering"]

KEYS = {
    "W S, up down": "walk forward, backward",
    "A D": "walk to the left, to the right",
    "left right": "turn",
    "space": "stop",
    "shift + arrow": "push forward, backward, to the left, to the right",
    "1 ... 9": "strength of a push, 0.05 N s/kg each",
    "ctrl + left mouse": "pull the link under the pointer",
    "P, N": "pause; go on by one cycle",
    "- =": "slower, faster",
    "T": "record a trace; again: write it",
    "R": "restart",
    "mouse, wheel": "turn the view, come nearer",
    "H, Esc": "these keys; quit",
}
HELP = "W S A D and arrows walk, space stops, shift + arrow pushes, P pauses, T records, H: all keys"
AXES = {  # of the command, and which way
    "W": (0, 1), "UP": (0, 1), "S": (0, -1), "DOWN": (0, -1), "A": (1, 1), "D": (1, -1), "LEFT": (2, 1),
    "RIGHT": (2, -1),
}  # fmt: skip
PUSHES = {"UP": 0.0, "DOWN": 180.0, "LEFT": 90.0, "RIGHT": -90.0}  # shift + key: direction from the heading [deg]
NOTCH = 0.05  # of a push's strength for a number key [N s/kg]
PACES = tuple(2.0**k for k in range(-6, 3))  # simulated seconds in a second that the keys choose from
AHEAD = 2  # footsteps that are drawn after the one of the foot in the air
PULL_MOST = 0.3  # of the weight, of the mouse

# What is drawn on the ground: its colour and its name in the legend.
LEGEND = {
    "zmp": ((0.84, 0.37, 0.0, 1.0), "ZMP"),
    "com": ((0.0, 0.0, 0.0, 1.0), "COM"),
    "dcm": ((0.45, 0.2, 0.7, 1.0), "DCM"),
    "polygon": ((0.0, 0.45, 0.7, 1.0), "support"),
    "steps": ((0.0, 0.62, 0.45, 1.0), "next steps"),
    "push": (PUSH_COLOUR, "push"),
}


class Steering:
    """Turns keys into a velocity command. It knows of no window.

    Args:
        step: what a key adds (3,): vx, vy, wz [m/s, m/s, rad/s].
        limit: how far the command goes (3,), same units, both ways.

    Raises:
        InputError: not three positive numbers, or a step beyond its limit.

    Usage: `steering = Steering((0.05, 0.03, 0.1), (0.6, 0.15, 0.5)); steering.press("W"); steering.command`
    """

    def __init__(self, step: Sequence[float], limit: Sequence[float]):
        self._step, self._limit = np.array(step, float), np.array(limit, float)
        for name, values in (("step", self._step), ("limit", self._limit)):
            if values.shape != (3,) or not (np.isfinite(values) & (values > 0)).all():
                raise InputError(f"{name} is {values.tolist()}; it must be three positive numbers (vx, vy, wz)")
        if (self._step > self._limit).any():
            raise InputError(f"step {self._step.tolist()} is beyond the limit {self._limit.tolist()}")
        self._presses = np.zeros(3)  # whole steps, so that as many back end at zero

    @classmethod
    def of(cls, controller: WalkingController) -> Steering:
        """Steps and limits for a robot: 0.6 m/s, 0.15 m/s and 0.5 rad/s for mahru in ten and five steps, where its legs
        reach so far.

        Args:
            controller: of which COM height and reach are taken.
        """
        limit = np.array([0.22 * controller.com_height, 0.055 * controller.com_height, 0.14]) / controller.Tc
        limit = np.array([controller.within_reach(axis)[i] for i, axis in enumerate(np.diag(limit))])
        return cls((limit / (10, 5, 5)).tolist(), limit.tolist())

    @property
    def command(self) -> tuple[float, float, float]:
        """(vx, vy, wz), heading frame [m/s, m/s, rad/s]."""
        vx, vy, wz = np.clip(self._presses * self._step, -self._limit, self._limit) + 0.0
        return float(vx), float(vy), float(wz)

    def press(self, key: str) -> bool:
        """Take a key.

        Args:
            key: "W", "A", "S", "D", "UP", "DOWN", "LEFT", "RIGHT", "SPACE"; others do nothing.

        Returns:
            Whether the command changed.

        Usage: `steering.press("LEFT")`
        """
        before = self.command
        if key == "SPACE":
            self._presses[:] = 0
        elif key in AXES:
            axis, sign = AXES[key]
            most = math.ceil(self._limit[axis] / self._step[axis] - 1e-9)
            self._presses[axis] = max(-most, min(most, self._presses[axis] + sign))
        return self.command != before


class LiveWalk:
    """A walk that goes on bit by bit and obeys keys: what the window shows, without the window.

    Args:
        robot: what `load_robot` takes.
        settings: as for `simulate`; None takes `WalkSettings()`.
        steering: None takes `Steering.of`.
        pace: simulated seconds in a second.
        record: the `.npz` file that a recording is written into; a number is put before its ending where the file is
            there already.
        terrain: ground in place of the floor, as for `simulate`.

    Fields: `model`, `data`, `controller`, `steering`, `out` (the last cycle's), `pace`, `paused`, `strength` of a push
    [N s/kg], `help` (whether all keys are shown), `recorded` (the files written), `closed`.

    Raises:
        ModelError, InputError: as `WalkingController`; a pace that is not positive.

    Usage: `walk = LiveWalk("mahru"); walk.press("W"); walk.advance(0.5); walk.press("LEFT", shift=True)`
    """

    def __init__(
        self,
        robot: Robot = "mahru",
        settings: Settings = None,
        steering: Steering | None = None,
        pace: float = 1.0,
        record: str | os.PathLike = "walk.npz",
        terrain: TerrainLike | None = None,
    ):
        if not (math.isfinite(pace) and pace > 0):
            raise InputError(f"speed is {pace:g}; it must be positive and finite")
        self._file = Path(record)
        if self._file.suffix.lower() != ".npz":
            raise InputError(f"{self._file}: a recorded walk is a .npz file")
        self.model, self._description = load_scene(robot, terrain)
        self.data = mujoco.MjData(self.model)
        self.controller = WalkingController(self.model, self._description, settings, profile=0.0)
        self.steering = steering or Steering.of(self.controller)
        self.pace, self.strength = pace, 3 * NOTCH
        self.paused = self.closed = self.help = False
        self.recorded: list[Path] = []
        self._recorder: Recorder | None = None
        trunk = mujoco.mj_name2id(self.model, mujoco.mjtObj.mjOBJ_BODY, trunk_body(self.controller))
        self._trunk = int(trunk)
        self.restart()

    def restart(self) -> None:
        """Back to the start pose, standing. What is being recorded is written first."""
        self.stop_recording()
        mujoco.mj_resetData(self.model, self.data)
        self._description.place(self.model, self.data)
        self.controller.reset(self.data)
        self.steering.press("SPACE")
        self.out = self.controller.update(self.data)
        self._owed = 0.0
        self._poses: deque = deque([self._pose()])
        self._pushes: list[tuple[float, int, np.ndarray]] = []  # when each began [s], on which body, its force [N]
        self._pull: tuple[int, np.ndarray] | None = None
        self._lift_off, self._period = math.nan, math.nan
        if self.paused:
            self._forward()

    def press(self, key: str, shift: bool = False) -> None:
        """Take a key: those of `Steering`, and those that `KEYS` lists, by their names in GLFW.

        Args:
            key: such as "SPACE", "P", "MINUS", "3".
            shift: whether it is held; an arrow then pushes the trunk.

        Usage: `walk.press("RIGHT", shift=True)`
        """
        if shift and key in PUSHES:
            self.push(PUSHES[key])
        elif key == "ESCAPE":
            self.closed = True
        elif key == "R":
            self.restart()
        elif key == "P":
            self.paused = not self.paused
        elif key == "N":
            self.paused = True
            self._cycle()
            self._forward()
        elif key in ("MINUS", "EQUAL"):
            nearest = min(range(len(PACES)), key=lambda k: abs(math.log(PACES[k] / self.pace)))
            self.pace = PACES[max(0, min(len(PACES) - 1, nearest + (1 if key == "EQUAL" else -1)))]
        elif key == "T":
            if not self.stop_recording():
                self._recorder = Recorder(self.controller)
                self._recorded_pushes: list = []
                self._begun = float(self.data.time)
        elif key == "H":
            self.help = not self.help
        elif len(key) == 1 and key in "123456789":
            self.strength = int(key) * NOTCH
        elif self.steering.press(key):
            self.controller.command(*self.steering.command)

    def push(self, direction: float) -> None:
        """Push the trunk for a moment, with the impulse `strength`; the controller is not told.

        Args:
            direction: from the robot's heading; 0 is forward, 90 to the left [deg].
        """
        angle = self.out.heading + math.radians(direction)
        size = self.strength * self.controller.mass / PUSH_DURATION
        force = size * np.array([math.cos(angle), math.sin(angle), 0.0])
        self._pushes = [push for push in self._pushes if self.data.time < push[0] + PUSH_SHOWN]
        self._pushes.append((float(self.data.time), self._trunk, force))
        if self._recorder is not None:
            name = mujoco.mj_id2name(self.model, mujoco.mjtObj.mjOBJ_BODY, self._trunk)
            self._recorded_pushes.append([float(self.data.time), PUSH_DURATION, name, [*force.tolist(), 0.0, 0.0, 0.0]])

    def pull(self, body: int | None, towards: Sequence[float] = (0.0, 0.0, 0.0)) -> None:
        """Pull a body towards a point as long as nothing else is said; the controller is not told.

        Args:
            body: its number in the model; None lets go.
            towards: in W (3,) [m]. A body that is z_c away from it is pulled with the robot's weight, at most with 0.3
                of that.
        """
        self._pull = None if body is None else (body, np.array(towards, float))

    def pick(self, origin: np.ndarray, along: np.ndarray) -> int | None:
        """The robot's body whose centre of mass is nearest to a ray, or None where all are far from it.

        Args:
            origin, along: of the ray, in W (3,) [m].
        """
        base = self.model.body_rootid[self._trunk]
        bodies = np.flatnonzero((self.model.body_rootid == base) & (self.model.body_mass > 0))
        from_eye = self.data.xipos[bodies] - origin
        along = along / np.linalg.norm(along)
        miss = np.linalg.norm(from_eye - (from_eye @ along)[:, None] * along, axis=1)
        k = int(np.argmin(miss))
        return int(bodies[k]) if miss[k] < 0.15 * self.controller.com_height else None

    def advance(self, seconds: float) -> None:
        """Simulate; what is less than a time step is kept for the next call. A robot that fell stays as it is, and so
        does one that is paused.

        Args:
            seconds: of simulated time [s].
        """
        if self.paused:
            return
        dt = self.model.opt.timestep
        self._owed += seconds
        while self._owed >= dt and not self.out.fell:
            self._owed -= dt
            self._cycle()

    def _cycle(self) -> None:
        """One control cycle and one step of the physics."""
        if self.out.fell:
            return
        phase = self.out.phase
        self.out = self.controller.update(self.data)
        if phase == 0 and self.out.phase == 1:
            self._period, self._lift_off = self.out.t - self._lift_off, self.out.t
        forces = [(body, force) for t, body, force in self._pushes if self.data.time < t + PUSH_DURATION - 1e-9]
        if self._pull is not None:
            forces.append((self._pull[0], self._pulling()))
        for body, force in forces:
            self.data.xfrc_applied[body, :3] += force
        mujoco.mj_step(self.model, self.data)
        for body, _ in forces:
            self.data.xfrc_applied[body, :3] = 0.0
        if self._recorder is not None:
            self._recorder.add(self.out, self.data)
        if self.out.t > self._poses[-1][0] + 0.01:
            self._poses.append(self._pose())
        while len(self._poses) > 2 and self._poses[-1][0] - self._poses[1][0] > stride(self.controller.com_height):
            self._poses.popleft()

    def _forward(self) -> None:
        """So that a paused picture is of the state that is shown."""
        mujoco.mj_kinematics(self.model, self.data)
        mujoco.mj_comPos(self.model, self.data)

    def _pulling(self) -> np.ndarray:
        assert self._pull is not None
        body, towards = self._pull
        weight = self.controller.mass * 9.81
        force = (towards - self.data.xipos[body]) * weight / self.controller.com_height
        return force * min(1.0, PULL_MOST * weight / max(float(np.linalg.norm(force)), 1e-9))

    def _pose(self) -> tuple[float, np.ndarray]:
        return self.out.t, feet_pose(self.out.foot_left, self.out.foot_right)

    def stop_recording(self) -> bool:
        """Write what was recorded; `recorded` holds the file.

        Returns:
            Whether something was being recorded.

        Raises:
            InputError: the file cannot be written.
        """
        if self._recorder is None:
            return False
        recorder, self._recorder = self._recorder, None
        if self.data.time <= self._begun:
            return True
        trace = recorder.trace()
        trace.meta["push"] = self._recorded_pushes
        path = self._file
        for k in itertools.count(2):
            if not path.exists():
                break
            path = self._file.with_name(f"{self._file.stem}-{k}.npz")
        self.recorded.append(trace.save(path))
        return True

    @property
    def velocity(self) -> np.ndarray:
        """(vx, vy, wz) of the feet over about the last two steps, heading frame [m/s, m/s, rad/s]."""
        (t0, before), (t1, after) = self._poses[0], self._poses[-1]
        return mean_velocity(before, after, t1 - t0) if t1 > t0 else np.zeros(3)

    @property
    def dcm(self) -> np.ndarray:
        """COM + T_c times its velocity, on the ground (2,) [m]."""
        return np.asarray(self.out.com[:2] + self.controller.Tc * self.out.dcom[:2])

    @property
    def words(self) -> dict[str, str]:
        """What the status lines say."""
        out = self.out
        foot = out.foot_left if out.support > 0 else out.foot_right
        yaw = sole_yaw(foot)
        x, y = np.array([[np.cos(yaw), np.sin(yaw)], [-np.sin(yaw), np.cos(yaw)]]) @ (out.zmp_est - foot[:2]) * 1e3
        side = "left" if out.support > 0 else "right"
        words = {
            self._description.name: f"{out.t:.2f} s{self._state()}",
            **velocity_words(np.array(self.steering.command), self.velocity),
            "ZMP": f"{abs(x):.0f} mm {'ahead' if x >= 0 else 'behind'}, "
            f"{abs(y):.0f} mm {'left' if y >= 0 else 'right'} "
            f"of the {side} sole's centre"
            if math.isfinite(x + y)
            else "no foot carries",
            "push": f"{self.strength:.2f} N s/kg, {self.strength * self.controller.mass:.0f} N s",
            "keys": HELP,
        }
        if out.fall_foreseen:
            words["foreseen"] = out.foreseen_cause
        if out.fell:
            words["fell"] = f"{out.fall_cause}; R restarts"
        return words

    def _state(self) -> str:
        parts = []
        if self.paused:
            parts.append("paused")
        if self.pace != 1.0:
            parts.append(f"{self.pace:g} x real time")
        if self._recorder is not None:
            parts.append(f"recording, {self.data.time - self._begun:.1f} s")
        elif self.recorded:
            parts.append(f"written: {self.recorded[-1].name}")
        return "".join(f"   {part}" for part in parts)

    @property
    def marks(self) -> list[dict[str, Any]]:
        """Crosses on the ground: ZMP, DCM and the point under the COM."""
        out = self.out
        marks = crosses(out.com, out.zmp_est, out.foot_left, out.foot_right)
        ground = min(out.foot_left[2], out.foot_right[2])
        if marks:
            marks.append({"pos": (*self.dcm, ground), "arm": 0.6 * marks[0]["arm"], "rgba": LEGEND["dcm"][0]})
        return [{**mark, "thick": 2.0} for mark in marks]

    @property
    def outlines(self) -> list[dict[str, Any]]:
        """Polygons on the ground: the support polygon, and the footsteps that are to come."""
        out, soles = self.out, (self._description.left, self._description.right)
        feet = (out.foot_left, out.foot_right)
        ground = float(min(foot[2] for foot in feet))
        standing = (0, 1) if out.phase == 0 else (0,) if out.support > 0 else (1,)
        corners = np.vstack(
            [
                sole_outline(feet[i][0], feet[i][1], float(sole_yaw(feet[i])), soles[i].length, soles[i].width)
                for i in standing
            ]
        )
        found = [{"corners": convex_hull(corners), "height": ground, "rgba": LEGEND["polygon"][0]}]
        for side, (x, y, yaw) in self._next_steps():
            outline = sole_outline(x, y, yaw, soles[side].length, soles[side].width)
            found.append({"corners": outline, "height": ground, "rgba": LEGEND["steps"][0]})
        return found

    def _next_steps(self) -> list[tuple[int, tuple[float, float, float]]]:
        """The foothold of the foot in the air, and those to which the planned velocity leads from there; 0 is left."""
        out, gait = self.out, self.controller.settings.gait
        if out.at_rest or out.fell:
            return []
        steps: list[tuple[int, tuple[float, float, float]]] = []
        if out.phase == 1 and np.isfinite(out.foothold).all():
            side = 1 if out.support > 0 else 0
            place = np.array(out.foothold, float)
            steps.append((side, (float(place[0]), float(place[1]), float(place[2]))))
        else:  # the foot that has landed, or is about to carry alone
            side = 0 if (out.support > 0) == bool(np.isnan(out.w_T)) else 1
            foot = (out.foot_left, out.foot_right)[side]
            place = np.array([foot[0], foot[1], float(sole_yaw(foot))])
        apart = self.controller.settings.steps.width
        usual = gait.T_ds + gait.T_ss
        period = self._period if self._period < 1.5 * usual else usual  # NaN at first
        for _ in range(AHEAD):
            side = 1 - side
            vx, vy, wz = np.asarray(out.v_plan) * period
            dx, dy = vx, vy + (apart if side == 0 else -apart)
            c, s = math.cos(place[2]), math.sin(place[2])
            place = place + (c * dx - s * dy, s * dx + c * dy, wz)
            steps.append((side, (float(place[0]), float(place[1]), float(place[2]))))
        return steps

    @property
    def arrows(self) -> list[dict[str, Any]]:
        """The pushes of now and of a moment ago, and the pull of the mouse."""
        acting = [(body, force) for t, body, force in self._pushes if t <= self.data.time < t + PUSH_SHOWN]
        if self._pull is not None:
            acting.append((self._pull[0], self._pulling()))
        weight = self.controller.mass * 9.81
        return [push_arrow(self.data.xipos[body], force, weight, self.controller.com_height) for body, force in acting]
