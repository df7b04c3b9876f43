"""A live window on a robot that keyboard and mouse walk and push, in every supported MuJoCo."""

from __future__ import annotations

import math
import os
import sys
from typing import Any, Callable

import mujoco
import numpy as np

from .errors import Error
from .given import Settings
from .live import AXES, KEYS, LEGEND, LiveWalk, Steering
from .render import Scene, default_camera
from .robots import Robot
from .terrain import TerrainLike

__all__ = ["LiveWalk", "Steering", "view"]

LONGEST_FRAME = 0.1  # what a frame may simulate: a slow machine shows slow motion instead of a standstill [s]
CAMERA_LAG = 0.5  # time constant with which the camera goes after the robot [s]
AZIMUTH, ELEVATION = 20.0, -22.0  # from behind, so that left is left [deg]
ZOOM = 0.05  # of the distance's logarithm for a notch of the wheel
LINE, CHIP = 24, (96, 24)  # height of a status line; size of an entry of the legend [pixels]
OTHER_KEYS = ("SPACE", "R", "ESCAPE", "P", "N", "MINUS", "EQUAL", "T", "H", *"123456789")


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
        self._names = {getattr(glfw, f"KEY_{name}"): name for name in (*AXES, *OTHER_KEYS)}
        self._held: tuple[int, float] | None = None  # the body under the mouse, and how far it is from the eye [m]
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
        glfw.set_mouse_button_callback(self._window, self.button)
        glfw.set_scroll_callback(self._window, self.scroll)

    def key(self, window: Any, key: int, scancode: int, action: int, mods: int) -> None:
        """GLFW's key callback: a key held down repeats."""
        if action != self._glfw.RELEASE and key in self._names:
            self._walk.press(self._names[key], bool(mods & self._glfw.MOD_SHIFT))

    def button(self, window: Any, button: int, action: int, mods: int) -> None:
        """GLFW's mouse button callback: with ctrl the left button takes hold of a link, until it is released."""
        if button != self._glfw.MOUSE_BUTTON_LEFT:
            return
        if action == self._glfw.PRESS and mods & self._glfw.MOD_CONTROL:
            eye, along = self._ray(*self._glfw.get_cursor_pos(self._window))
            self.hold(eye, along)
        elif action == self._glfw.RELEASE and self._held is not None:
            self._held = None
            self._walk.pull(None)

    def hold(self, eye: np.ndarray, along: np.ndarray) -> None:
        """Take hold of the link that is nearest to a ray, if one is near."""
        body = self._walk.pick(eye, along)
        if body is not None:
            place = self._walk.data.xipos[body]
            self._held = body, float((place - eye) @ along)
            self._walk.pull(body, place)

    def _ray(self, x: float, y: float) -> tuple[np.ndarray, np.ndarray]:
        """Where the eye is, and the direction in which it sees a point of the window; W (3,) [m], unit length."""
        width, height = self._glfw.get_window_size(self._window)
        shown = height * self._picture().height / max(1, self._glfw.get_framebuffer_size(self._window)[1])
        return ray(self._camera, self._walk.model.vis.global_.fovy, width, shown, x, y)

    def cursor(self, window: Any, x: float, y: float) -> None:
        """GLFW's cursor callback: the left button turns the view, the right one comes nearer or goes away."""
        (x0, y0), self._mouse = self._mouse, (x, y)
        glfw, view = self._glfw, self._camera
        if self._held is not None:
            body, depth = self._held
            eye, along = self._ray(x, y)
            self._walk.pull(body, eye + depth * along)
            return
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
        walk.advance(min(walk.pace * seconds, LONGEST_FRAME))
        catch_up = 1 - math.exp(-seconds / CAMERA_LAG)
        x, y = self._camera.lookat[:2]
        self._camera.lookat[:2] = (x, y) + catch_up * (walk.out.com[:2] - (x, y))
        self._draw()
        self._glfw.swap_buffers(self._window)
        self._glfw.poll_events()
        walk.closed = walk.closed or bool(self._glfw.window_should_close(self._window))

    def picture(self) -> np.ndarray:
        """What the window shows (height, width, 3) uint8."""
        self._draw()
        return self._scene.read(mujoco.MjrRect(0, 0, *self._glfw.get_framebuffer_size(self._window)))

    def _draw(self) -> None:
        """The walk above, and under it what there is to say, so that no word covers the robot."""
        walk, shown = self._walk, self._picture()
        keys = KEYS if walk.help else None
        self._scene.draw(shown, walk.data, self._camera, walk.marks, keys, walk.arrows, walk.outlines)
        self._scene.panel(mujoco.MjrRect(0, 0, shown.width, shown.bottom), walk.words, list(LEGEND.values()), CHIP)

    def _picture(self) -> mujoco.MjrRect:
        """The part of the window in which the robot is; the status lines are below."""
        width, height = self._glfw.get_framebuffer_size(self._window)
        bar = min(LINE * len(self._walk.words) + LINE // 2, height // 2)
        return mujoco.MjrRect(0, bar, width, height - bar)

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
    record: str | os.PathLike = "walk.npz",
    terrain: TerrainLike | None = None,
) -> LiveWalk:
    """Open a window on a robot and let keyboard and mouse walk and push it, in real time, until Esc or the window's own
    cross. The key H shows all keys.

    Args:
        robot: what `load_robot` takes.
        settings: as for `simulate`; None takes `WalkSettings()`.
        speed: simulated seconds in a second at first; the keys - and = change it.
        width, height: of the window [screen units].
        shadows: draw shadows and reflections.
        on_frame: called after each frame; may press keys.
        record: the `.npz` file that the key T records into; a number is put before its ending where the file is there.
        terrain: ground in place of the floor, as for `simulate`.

    Returns:
        The walk as it was when the window closed; `recorded` are the files that were written.

    Raises:
        Error: no window can be opened.  InputError: `speed` is not positive.  ModelError: a robot that cannot walk.

    Usage: `zmpwalk.view.view("mahru")`
    """
    walk = LiveWalk(robot, settings, pace=speed, record=record, terrain=terrain)
    window = Window(walk, width, height, shadows)
    try:
        import glfw

        last = glfw.get_time()
        while not walk.closed:
            now = glfw.get_time()
            window.frame(now - last)
            last = now
            if on_frame:
                on_frame(window, walk)
    finally:
        window.close()
        walk.stop_recording()
    return walk


def ray(
    camera: mujoco.MjvCamera, fovy: float, width: float, height: float, x: float, y: float
) -> tuple[np.ndarray, np.ndarray]:
    """Where a free camera's eye is, and the direction in which it sees a point of its picture.

    Args:
        camera: a free one.
        fovy: its field of view from bottom to top [deg].
        width, height: of the picture [pixels].
        x, y: the point, from the picture's upper left corner [pixels].

    Returns:
        Place (3,) [m] and direction (3,) of unit length, W.
    """
    azimuth, elevation = math.radians(camera.azimuth), math.radians(camera.elevation)
    level = np.array([math.cos(azimuth), math.sin(azimuth), 0.0])
    ahead = math.cos(elevation) * level + [0.0, 0.0, math.sin(elevation)]
    right = np.array([level[1], -level[0], 0.0])
    up = np.cross(right, ahead)
    half = math.tan(math.radians(fovy) / 2)
    along = ahead + half * ((2 * x - width) / height * right + (1 - 2 * y / height) * up)
    return np.array(camera.lookat) - camera.distance * ahead, along / np.linalg.norm(along)
