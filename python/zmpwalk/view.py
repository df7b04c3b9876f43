"""A live window on a robot that the keyboard walks, in every supported MuJoCo."""

from __future__ import annotations

import math
import os
import sys
from collections import deque
from typing import Any, Callable, Sequence

import mujoco
import numpy as np

from .analysis import feet_pose, mean_velocity, sole_yaw
from .errors import Error, InputError
from .given import Settings
from .render import Scene, crosses, default_camera, stride, velocity_words
from .robots import Robot
from .simulation import WalkingController
from .terrain import TerrainLike, load_scene

__all__ = ["LiveWalk", "Steering", "view"]

HELP = "W S forward, A D sideways, arrows too (left, right: turn), space stop, R restart, Esc quit"
LONGEST_FRAME = 0.1  # what a frame may simulate: a slow machine shows slow motion instead of a standstill [s]
CAMERA_LAG = 0.5  # time constant with which the camera goes after the robot [s]
AZIMUTH, ELEVATION = 20.0, -15.0  # from behind, so that left is left [deg]
ZOOM = 0.05  # of the distance's logarithm for a notch of the wheel

AXES = {  # of the command, and which way
    "W": (0, 1), "UP": (0, 1), "S": (0, -1), "DOWN": (0, -1), "A": (1, 1), "D": (1, -1), "LEFT": (2, 1),
    "RIGHT": (2, -1),
}  # fmt: skip


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
        terrain: ground in place of the floor, as for `simulate`.

    Fields: `model`, `data`, `controller`, `steering`, `out` (the last cycle's), `closed`.

    Raises:
        ModelError, InputError: as `WalkingController`.

    Usage: `walk = LiveWalk("mahru"); walk.press("W"); walk.advance(0.5)`
    """

    def __init__(
        self,
        robot: Robot = "mahru",
        settings: Settings = None,
        steering: Steering | None = None,
        terrain: TerrainLike | None = None,
    ):
        self.model, self._description = load_scene(robot, terrain)
        self.data = mujoco.MjData(self.model)
        self.controller = WalkingController(self.model, self._description, settings, profile=0.0)
        self.steering = steering or Steering.of(self.controller)
        self.closed = False
        self.restart()

    def restart(self) -> None:
        """Back to the start pose, standing."""
        mujoco.mj_resetData(self.model, self.data)
        self._description.place(self.model, self.data)
        self.controller.reset(self.data)
        self.steering.press("SPACE")
        self.out = self.controller.update(self.data)
        self._owed = 0.0
        self._poses: deque = deque([self._pose()])

    def press(self, key: str) -> None:
        """Take a key: those of `Steering`, "R" restarts, "ESCAPE" closes.

        Usage: `walk.press("SPACE")`
        """
        if key == "ESCAPE":
            self.closed = True
        elif key == "R":
            self.restart()
        elif self.steering.press(key):
            self.controller.command(*self.steering.command)

    def advance(self, seconds: float) -> None:
        """Simulate; what is less than a time step is kept for the next call. A robot that fell stays as it is.

        Args:
            seconds: of simulated time [s].
        """
        dt = self.model.opt.timestep
        self._owed += seconds
        while self._owed >= dt and not self.out.fell:
            self._owed -= dt
            self.out = self.controller.update(self.data)
            mujoco.mj_step(self.model, self.data)
        if self.out.t > self._poses[-1][0]:
            self._poses.append(self._pose())
        while len(self._poses) > 2 and self._poses[-1][0] - self._poses[1][0] > stride(self.controller.com_height):
            self._poses.popleft()

    def _pose(self) -> tuple[float, np.ndarray]:
        return self.out.t, feet_pose(self.out.foot_left, self.out.foot_right)

    @property
    def velocity(self) -> np.ndarray:
        """(vx, vy, wz) of the feet over about the last two steps, heading frame [m/s, m/s, rad/s]."""
        (t0, before), (t1, after) = self._poses[0], self._poses[-1]
        return mean_velocity(before, after, t1 - t0) if t1 > t0 else np.zeros(3)

    @property
    def words(self) -> dict[str, str]:
        """What is written in the window."""
        out = self.out
        foot = out.foot_left if out.support > 0 else out.foot_right
        yaw = sole_yaw(foot)
        x, y = np.array([[np.cos(yaw), np.sin(yaw)], [-np.sin(yaw), np.cos(yaw)]]) @ (out.zmp_est - foot[:2]) * 1e3
        side = "left" if out.support > 0 else "right"
        words = {
            self._description.name: f"{out.t:.2f} s",
            **velocity_words(np.array(self.steering.command), self.velocity),
            "ZMP": f"{x:+.0f} mm ahead, {y:+.0f} mm left of the {side} sole's centre",
            "keys": HELP,
        }
        if out.fall_foreseen:
            words["foreseen"] = out.foreseen_cause
        if out.fell:
            words["fell"] = f"{out.fall_cause}; R restarts"
        return words

    @property
    def marks(self) -> list[dict[str, Any]]:
        """Crosses on the ground: ZMP and the point under the COM."""
        out = self.out
        return crosses(out.com, out.zmp_est, out.foot_left, out.foot_right)


class Window:
    """A window with its OpenGL context, its camera under the mouse, and a walk's keys.

    Args:
        walk: what it shows.
        width, height: [screen units].
        shadows: draw shadows and reflections.

    Raises:
        Error: no window can be opened here; says why.
    """

    def __init__(self, walk: LiveWalk, width: int = 1280, height: int = 800, shadows: bool = True):
        import glfw

        self._glfw, self._walk, said = glfw, walk, []
        if sys.platform.startswith("linux") and not any(map(os.environ.get, ("DISPLAY", "WAYLAND_DISPLAY"))):
            raise Error("cannot open a window: there is no display (DISPLAY is not set); zmpwalk video films a walk")

        def hear(code: int, text: Any) -> None:
            said.append(text.decode(errors="replace"))

        glfw.set_error_callback(hear)
        self._window: Any = None
        if glfw.init():
            glfw.window_hint(glfw.SAMPLES, 4)
            self._window = glfw.create_window(width, height, "zmpwalk", None, None)
        if not self._window:
            glfw.terminate()
            raise Error(f"cannot open a window: {'; '.join(said) or 'GLFW does not say why'}")
        glfw.make_context_current(self._window)
        glfw.swap_interval(1)
        self._names = {getattr(glfw, f"KEY_{name}"): name for name in (*AXES, "SPACE", "R", "ESCAPE")}
        try:
            self._scene = Scene(walk.model, shadows)
        except mujoco.FatalError as error:
            glfw.terminate()
            raise Error(f"cannot draw in a window: {error}") from None
        self._camera = default_camera(walk.model, walk.data)
        self._camera.azimuth, self._camera.elevation = AZIMUTH, ELEVATION
        self._mouse = glfw.get_cursor_pos(self._window)
        glfw.set_key_callback(self._window, self.key)
        glfw.set_cursor_pos_callback(self._window, self.cursor)
        glfw.set_scroll_callback(self._window, self.scroll)

    def key(self, window: Any, key: int, scancode: int, action: int, mods: int) -> None:
        """GLFW's key callback: a key held down repeats."""
        if action != self._glfw.RELEASE and key in self._names:
            self._walk.press(self._names[key])

    def cursor(self, window: Any, x: float, y: float) -> None:
        """GLFW's cursor callback: the left button turns the view, the right one comes nearer or goes away."""
        (x0, y0), self._mouse = self._mouse, (x, y)
        glfw, view = self._glfw, self._camera
        across, down = (np.array([x - x0, y - y0]) / max(1, glfw.get_window_size(self._window)[1])).tolist()
        if glfw.get_mouse_button(self._window, glfw.MOUSE_BUTTON_LEFT) == glfw.PRESS:
            view.azimuth -= 180 * across
            view.elevation = max(-90.0, min(90.0, view.elevation - 180 * down))
        elif glfw.get_mouse_button(self._window, glfw.MOUSE_BUTTON_RIGHT) == glfw.PRESS:
            view.distance *= math.exp(down)

    def scroll(self, window: Any, dx: float, dy: float) -> None:
        """GLFW's scroll callback: up comes nearer."""
        self._camera.distance *= math.exp(-ZOOM * dy)

    def frame(self, seconds: float) -> None:
        """Let the walk go on, draw it, and take what keyboard and mouse did.

        Args:
            seconds: since the last frame [s].
        """
        walk = self._walk
        walk.advance(min(seconds, LONGEST_FRAME))
        catch_up = 1 - math.exp(-seconds / CAMERA_LAG)
        x, y = self._camera.lookat[:2]
        self._camera.lookat[:2] = (x, y) + catch_up * (walk.out.com[:2] - (x, y))
        self._scene.draw(self._viewport(), walk.data, self._camera, walk.marks, walk.words)
        self._glfw.swap_buffers(self._window)
        self._glfw.poll_events()
        walk.closed = walk.closed or bool(self._glfw.window_should_close(self._window))

    def picture(self) -> np.ndarray:
        """What the window shows (height, width, 3) uint8."""
        walk = self._walk
        self._scene.draw(self._viewport(), walk.data, self._camera, walk.marks, walk.words)
        return self._scene.read(self._viewport())

    def _viewport(self) -> mujoco.MjrRect:
        return mujoco.MjrRect(0, 0, *self._glfw.get_framebuffer_size(self._window))

    def close(self) -> None:
        """Take the window away."""
        self._scene.free()
        self._glfw.destroy_window(self._window)
        self._glfw.terminate()


def view(
    robot: Robot = "mahru",
    settings: Settings = None,
    speed: float = 1.0,
    width: int = 1280,
    height: int = 800,
    shadows: bool = True,
    on_frame: Callable[[Window, LiveWalk], None] | None = None,
    terrain: TerrainLike | None = None,
) -> None:
    """Open a window on a robot and let the keyboard walk it, in real time, until Esc or the window's own cross.

    Args:
        robot: what `load_robot` takes.
        settings: as for `simulate`; None takes `WalkSettings()`.
        speed: simulated seconds in a second.
        width, height: of the window [screen units].
        shadows: draw shadows and reflections.
        on_frame: called after each frame; may press keys.
        terrain: ground in place of the floor, as for `simulate`.

    Raises:
        Error: no window can be opened.  InputError: `speed` is not positive.  ModelError: a robot that cannot walk.

    Usage: `zmpwalk.view.view("mahru")`
    """
    if not (math.isfinite(speed) and speed > 0):
        raise InputError(f"speed is {speed:g}; it must be positive and finite")
    walk = LiveWalk(robot, settings, terrain=terrain)
    window = Window(walk, width, height, shadows)
    try:
        import glfw

        last = glfw.get_time()
        while not walk.closed:
            now = glfw.get_time()
            window.frame(speed * (now - last))
            last = now
            if on_frame:
                on_frame(window, walk)
    finally:
        window.close()
