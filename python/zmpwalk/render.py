"""Pictures and videos of a robot, drawn off screen: no window and no graphics card needed, in every supported MuJoCo.

The OpenGL backend is MUJOCO_GL if that is set ("egl", "osmesa" or "glfw"); otherwise the first of egl, osmesa and,
with a display, glfw that works.
"""

from __future__ import annotations

import base64
import ctypes.util
import importlib
import os
import sys
import tempfile
from pathlib import Path
from typing import Any, Callable, Mapping, Sequence, Union

import mujoco
import numpy as np

from .analysis import feet_pose, mean_velocity
from .errors import Error, InputError
from .files import whole
from .simulation import set_state
from .trace import Trace

__all__ = ["Film", "OffScreen", "film", "picture", "snapshot", "video"]

LIBRARIES = {"egl": "EGL", "osmesa": "OSMesa", "glfw": "GL"}
MARKS = {"com": (0.0, 0.0, 0.0, 1.0), "zmp_est": (0.84, 0.37, 0.0, 1.0)}  # colours as in `plot`
AZIMUTH, ELEVATION, FILLED = (
    130.0,
    -12.0,
    0.75,
)  # default view: from ahead and the right [deg], share of the height filled
PUSH_COLOUR, PUSH_SHOWN, ARROW = (0.8, 0.1, 0.5, 1.0), 0.25, 0.9  # at least [s]; length for a force of one weight [z_c]
STRIDE = 6.0  # of time constants sqrt(z_c / g): about two steps
GRAVITY = 9.81  # only for that [m/s^2]

Camera = Union[None, str, Mapping[str, Any], "mujoco.MjvCamera"]


class Scene:
    """What is drawn of a model, in a window or off screen; the caller's OpenGL context must be current.

    Args:
        model: what to draw.
        shadows: draw shadows and reflections: half as fast without a graphics card.
    """

    def __init__(self, model: mujoco.MjModel, shadows: bool = True):
        self._model = model
        self._context = mujoco.MjrContext(model, mujoco.mjtFontScale.mjFONTSCALE_100)
        self._scene = mujoco.MjvScene(model, maxgeom=10000)
        for flag in (mujoco.mjtRndFlag.mjRND_SHADOW, mujoco.mjtRndFlag.mjRND_REFLECTION):
            self._scene.flags[flag] = shadows
        self._option = mujoco.MjvOption()

    def draw(
        self,
        viewport: mujoco.MjrRect,
        data: mujoco.MjData,
        view: mujoco.MjvCamera,
        marks: Sequence[Mapping[str, Any]] = (),
        words: Mapping[str, Any] | None = None,
        arrows: Sequence[Mapping[str, Any]] = (),
    ) -> None:
        """Draw into the current buffer; `marks`, `words` and `arrows` as in `OffScreen.draw`."""
        mujoco.mjv_updateScene(
            self._model, data, self._option, None, view, mujoco.mjtCatBit.mjCAT_ALL.value, self._scene
        )
        for mark in marks:
            self._cross(np.asarray(mark["pos"], float), float(mark["arm"]), np.asarray(mark["rgba"], np.float32))
        for arrow in arrows:
            self._arrow(np.asarray(arrow["to"], float), np.asarray(arrow["along"], float))
        mujoco.mjr_render(viewport, self._scene, self._context)
        if words:
            place, font = mujoco.mjtGridPos.mjGRID_TOPLEFT, mujoco.mjtFont.mjFONT_NORMAL
            columns = ("\n".join(map(str, column)) for column in (words.keys(), words.values()))
            mujoco.mjr_overlay(font, place, viewport, *columns, self._context)

    def _cross(self, centre: np.ndarray, arm: float, rgba: np.ndarray) -> None:
        """Two thin bars on the ground, longer than a foot, so that a sole on their crossing does not hide them."""
        for along in (0, 1):
            if self._scene.ngeom < self._scene.maxgeom:
                size = np.full(3, 0.012 * arm)
                size[along] = arm
                box, upright = mujoco.mjtGeom.mjGEOM_BOX, np.eye(3).ravel()
                mujoco.mjv_initGeom(self._scene.geoms[self._scene.ngeom], box, size, centre, upright, rgba)
                self._scene.ngeom += 1

    def _arrow(self, end: np.ndarray, along: np.ndarray) -> None:
        """An arrow as long as `along`, whose point is at `end`."""
        length = float(np.linalg.norm(along))
        if length > 0.0 and self._scene.ngeom < self._scene.maxgeom:
            z = along / length
            x = np.cross(z, [0.0, 0.0, 1.0] if abs(z[2]) < 0.9 else [1.0, 0.0, 0.0])
            x /= np.linalg.norm(x)
            turned = np.column_stack([x, np.cross(z, x), z]).ravel()
            size, rgba = np.array([0.025, 0.025, length]), np.asarray(PUSH_COLOUR, np.float32)
            geom = self._scene.geoms[self._scene.ngeom]
            mujoco.mjv_initGeom(geom, mujoco.mjtGeom.mjGEOM_ARROW, size, end - along, turned, rgba)
            self._scene.ngeom += 1

    def read(self, viewport: mujoco.MjrRect) -> np.ndarray:
        """What was drawn (height, width, 3) uint8, first row on top."""
        image = np.empty((viewport.height, viewport.width, 3), np.uint8)
        mujoco.mjr_readPixels(image, None, viewport, self._context)
        return np.flipud(image).copy()

    def off_screen(self) -> None:
        """Draw into the off-screen buffer from now on."""
        mujoco.mjr_setBuffer(mujoco.mjtFramebuffer.mjFB_OFFSCREEN, self._context)

    def free(self) -> None:
        """Give OpenGL's memory back."""
        self._context.free()


class OffScreen:
    """A drawing surface for one model; close it (or use `with`) before the program ends.

    Args:
        model: what to draw.
        width, height: of the picture [pixels].
        shadows: draw shadows and reflections: half as fast without a graphics card.

    Raises:
        Error: no OpenGL backend works here; says what was tried and what to install.

    Usage: `with OffScreen(model, 640, 480) as screen: image = screen.draw(data)`
    """

    def __init__(self, model: mujoco.MjModel, width: int = 640, height: int = 480, shadows: bool = True):
        if not (0 < int(width) <= 8192 and 0 < int(height) <= 8192):
            raise InputError(f"a picture of {width} x {height} pixels: both must be 1 to 8192")
        self._model, self._width, self._height = model, int(width), int(height)
        self._gl = _gl_context(self._width, self._height)
        self._gl.make_current()
        screen = model.vis.global_
        kept = screen.offwidth, screen.offheight
        screen.offwidth, screen.offheight = max(kept[0], self._width), max(kept[1], self._height)
        try:
            self._scene: Scene | None = Scene(model, shadows)
        finally:
            screen.offwidth, screen.offheight = kept
        self._scene.off_screen()

    def draw(
        self,
        data: mujoco.MjData,
        camera: Camera = None,
        marks: Sequence[Mapping[str, Any]] = (),
        words: Mapping[str, Any] | None = None,
        arrows: Sequence[Mapping[str, Any]] = (),
    ) -> np.ndarray:
        """The scene as it stands in `data`, whose kinematics must be up to date (`mj_forward`).

        Args:
            data: of the same model.
            camera: None looks at the robot from ahead and the right; a name is a camera of the model; a dictionary
                changes the default view: lookat (3) [m], distance [m], azimuth, elevation [deg]; or an MjvCamera.
            marks: crosses to lay on the ground, each {"pos": (3) [m], "arm": half length [m], "rgba": (4)}.
            words: a caption above on the left, what -> its value, a line each; ASCII.
            arrows: each {"to": where its point is (3) [m], "along": how it lies and how long it is (3) [m]}.

        Returns:
            (height, width, 3) uint8, first row on top.

        Raises:
            InputError: the model has no camera of that name.
            Error: it was closed.

        Usage: `image = screen.draw(data, camera={"azimuth": 90})`
        """
        if self._scene is None:
            raise Error("the surface was closed; make another to draw on")
        self._gl.make_current()
        viewport = mujoco.MjrRect(0, 0, self._width, self._height)
        self._scene.draw(viewport, data, _camera(self._model, data, camera), marks, words, arrows)
        return self._scene.read(viewport)

    def close(self) -> None:
        """Give the surface back; drawing afterwards is an error."""
        if self._scene is not None:
            self._gl.make_current()
            self._scene.free()
            self._gl.free()
            self._scene = None

    def __enter__(self) -> OffScreen:
        return self

    def __exit__(self, *exception: Any) -> None:
        self.close()


def picture(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    width: int = 640,
    height: int = 480,
    camera: Camera = None,
    shadows: bool = True,
) -> np.ndarray:
    """One picture of a simulation as it stands.

    Args:
        model, data: kinematics up to date (`mj_forward`, or any `mj_step` before).
        width, height: [pixels].
        camera: see `OffScreen.draw`.
        shadows: draw shadows and reflections.

    Returns:
        (height, width, 3) uint8, first row on top.

    Raises:
        Error: no OpenGL backend works here.  InputError: no such camera.

    Usage: `matplotlib.image.imsave("robot.png", zmpwalk.render.picture(model, data))`
    """
    with OffScreen(model, width, height, shadows) as screen:
        return screen.draw(data, camera)


def snapshot(
    trace: Trace,
    t: float | None = None,
    width: int = 640,
    height: int = 480,
    camera: Camera = None,
    show_zmp: bool = True,
) -> np.ndarray:
    """The robot of a trace at one instant.

    Args:
        trace: a walk that carries its model.
        t: instant [s]; None is the last.
        width, height: [pixels].
        camera: see `OffScreen.draw`.
        show_zmp: mark on the ground the estimated ZMP (red) and the point under the COM (black).

    Returns:
        (height, width, 3) uint8, first row on top.

    Raises:
        InputError: `t` is outside the walk.  ModelError: the trace's model cannot be used.  Error: no OpenGL backend
        works here.

    Usage: `zmpwalk.render.snapshot(trace, t=2.0, camera={"azimuth": 90})`
    """
    model, k = trace.model, _row(trace, t)
    with OffScreen(model, width, height) as screen:
        return screen.draw(_pose(model, trace, k), camera, _marks(trace, k) if show_zmp else ())


def video(
    trace: Trace,
    path: str | os.PathLike,
    fps: int = 25,
    width: int = 640,
    height: int = 480,
    speed: float = 1.0,
    camera: Camera = None,
    show_zmp: bool = True,
    shadows: bool = False,
    caption: bool = True,
    on_progress: Callable[[float, float], None] | None = None,
) -> Path:
    """A film of a trace, written whole or not at all.

    The default camera goes with the walk, but not with the sway of its steps. An arrow shows a push while it acts, and
    for a quarter of a second at least.

    Args:
        trace: a walk that carries its model.
        path: `.mp4` or `.gif`.
        fps: pictures per second of the film.
        width, height: [pixels], even numbers for `.mp4`.
        speed: 0.5 is slow motion.
        camera: see `OffScreen.draw`; what is left out of a dictionary goes with the walk.
        show_zmp: mark the estimated ZMP (red) and the point under the COM (black) on the ground.
        shadows: draw shadows and reflections, at half the speed.
        caption: write robot, time, and planned and walked velocity above.
        on_progress: called at each picture with (t, duration) [s]; what it raises stops the film and passes on.

    Returns:
        The path written.

    Raises:
        ImportError: imageio is not installed.  OSError: cannot write there.  InputError: `fps` or `speed` not
        positive.  ModelError, Error: as `snapshot`.

    Usage: `zmpwalk.render.video(trace, "walk.mp4", speed=0.5)`
    """
    try:
        import imageio.v2 as imageio
    except ImportError:
        raise ImportError("videos need imageio: pip install imageio imageio-ffmpeg") from None
    if not (fps > 0 and speed > 0):
        raise InputError(f"fps is {fps:g} and speed {speed:g}; both must be positive")
    path, model = Path(path), trace.model
    camera = {} if camera is None else camera
    centre = _smooth_path(trace)
    times = np.arange(trace.t[0], trace.t[-1] + 1e-9, speed / fps)
    options: dict[str, Any] = (
        {"duration": 1000.0 / fps, "loop": 0} if path.suffix.lower() == ".gif" else {"fps": fps, "macro_block_size": 2}
    )
    with whole(path) as draft, OffScreen(model, width, height, shadows) as screen:
        film: Any = imageio.get_writer(draft, **options)
        with film:
            for t in times:
                k = _row(trace, t)
                moving = {"lookat": centre[k], **camera} if isinstance(camera, Mapping) else camera
                marks, words = _marks(trace, k) if show_zmp else (), _caption(trace, k) if caption else None
                data = _pose(model, trace, k)
                film.append_data(screen.draw(data, moving, marks, words, _arrows(model, data, trace, t)))
                if on_progress:
                    on_progress(t - trace.t[0], trace.duration)
    return path


class Film:
    """A film that was made; a notebook plays it.

    Args:
        path: its file, or None where `content` is all there is.
        content: the file's bytes.
        kind: "mp4" or "gif".

    Fields: path, as given.

    Usage: `trace.video(speed=0.5).save("walk.mp4")`
    """

    def __init__(self, path: Path | None, content: bytes, kind: str):
        self.path, self._content, self._kind = path, content, kind

    def save(self, path: str | os.PathLike) -> Path:
        """Write the film into a file of the same kind, whole or not at all.

        Raises:
            InputError: another suffix.  OSError: cannot write there.
        """
        path = Path(path)
        if path.suffix.lower() != f".{self._kind}":
            raise InputError(f"{path}: this film is a .{self._kind}; make another by trace.video('{path}')")
        with whole(path) as draft:
            draft.write_bytes(self._content)
        return path

    def __repr__(self) -> str:
        return f"Film({self.path or 'in memory'}, {self._kind}, {len(self._content) / 1e6:.2f} MB)"

    def _repr_html_(self) -> str:
        content = base64.b64encode(self._content).decode()
        if self._kind == "gif":
            return f"<img alt='a walk' src='data:image/gif;base64,{content}'>"
        return f"<video controls loop autoplay muted src='data:video/mp4;base64,{content}'></video>"


def film(trace: Trace, path: str | os.PathLike | None = None, **options: Any) -> Film:
    """See `Trace.video`."""
    if path is not None:
        written = video(trace, path, **options)
        return Film(written, written.read_bytes(), written.suffix.lower().lstrip("."))
    with tempfile.TemporaryDirectory(prefix="zmpwalk-") as folder:
        return Film(None, video(trace, Path(folder) / "walk.mp4", **options).read_bytes(), "mp4")


def _smooth_path(trace: Trace) -> np.ndarray:
    """The COM without the sway of the steps: its mean over a stride about each instant (T, 3) [m]."""
    half = min(round(stride(trace.com[0, 2]) / trace.control_dt), len(trace.t)) // 2
    padded = np.pad(trace.com, ((half + 1, half), (0, 0)), mode="edge").cumsum(axis=0)
    return (padded[2 * half + 1 :] - padded[: -2 * half - 1]) / (2 * half + 1)


def stride(com_height: float) -> float:
    """About the time of two steps of a robot [s], for means that shall not show them."""
    return STRIDE * float(np.sqrt(com_height / GRAVITY))


def velocity_words(planned: np.ndarray, walked: np.ndarray) -> dict[str, str]:
    """Lines of a caption: (vx, vy, wz) [m/s, m/s, rad/s] planned and walked."""
    form = "forward {:+.2f} m/s   left {:+.2f} m/s   turning {:+.2f} rad/s"
    return {name: form.format(*np.round(v, 2) + 0.0) for name, v in (("asked", planned), ("walks", walked))}


def _caption(trace: Trace, k: int) -> dict[str, str]:
    before = max(0, k - round(stride(trace.com[0, 2]) / trace.control_dt))
    start, now = feet_pose(trace.foot_left[[before, k]], trace.foot_right[[before, k]])
    walked = mean_velocity(start, now, float(trace.t[k] - trace.t[before])) if k > before else np.zeros(3)
    return {str(trace.meta.get("robot", "robot")): f"{trace.t[k]:.2f} s", **velocity_words(trace.v_plan[k], walked)}


def _row(trace: Trace, t: float | None) -> int:
    if t is None:
        return len(trace.t) - 1
    if not trace.t[0] - 1e-9 <= t <= trace.t[-1] + trace.control_dt + 1e-9:
        raise InputError(f"t is {t:g} s; the walk goes from {trace.t[0]:g} to {trace.t[-1]:g} s")
    return int(np.clip(np.searchsorted(trace.t, t + 1e-9, side="right") - 1, 0, len(trace.t) - 1))


def _pose(model: mujoco.MjModel, trace: Trace, k: int) -> mujoco.MjData:
    data = mujoco.MjData(model)
    set_state(trace, model, data, k)
    return data


def _arrows(model: mujoco.MjModel, data: mujoco.MjData, trace: Trace, t: float) -> list[dict[str, Any]]:
    """The pushes that act on the walk at `t`, or did until a moment ago; longer where they are harder."""
    arrows = []
    for start, duration, name, wrench in trace.meta.get("push") or ():
        force = np.asarray(wrench[:3], float)
        body = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, name)
        if body >= 0 and force.any() and start <= t < start + max(duration, PUSH_SHOWN):
            weight = float(model.body_subtreemass[0]) * GRAVITY
            size = float(np.linalg.norm(force))
            length = ARROW * float(trace.com[0, 2]) * min(max(size / weight, 0.3), 1.5)
            arrows.append({"to": data.xipos[body].copy(), "along": length / size * force})
    return arrows


def _marks(trace: Trace, k: int) -> list[dict[str, Any]]:
    return crosses(trace.com[k], trace.zmp_est[k], trace.foot_left[k], trace.foot_right[k])


def crosses(
    com: np.ndarray, zmp_est: np.ndarray, foot_left: np.ndarray, foot_right: np.ndarray
) -> list[dict[str, Any]]:
    """Crosses where the estimated ZMP and the point under the COM are, at the lower sole's height."""
    ground = min(foot_left[2], foot_right[2])
    arm = 0.28 * (com[2] - ground)
    return [
        {"pos": (*point[:2], ground), "arm": arm, "rgba": MARKS[name]}
        for name, point in (("com", com), ("zmp_est", zmp_est))
        if np.isfinite(point[:2]).all()
    ]


def _camera(model: mujoco.MjModel, data: mujoco.MjData, camera: Camera) -> mujoco.MjvCamera:
    if isinstance(camera, mujoco.MjvCamera):
        return camera
    if isinstance(camera, str):
        view = mujoco.MjvCamera()
        view.fixedcamid = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera)
        if view.fixedcamid < 0:
            names = [mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_CAMERA, i) for i in range(model.ncam)]
            raise InputError(f"no camera '{camera}'; the model has {', '.join(filter(None, names)) or 'none'}")
        view.type = mujoco.mjtCamera.mjCAMERA_FIXED
        return view
    view = default_camera(model, data)
    for key, value in dict(camera or {}).items():
        if key not in ("lookat", "distance", "azimuth", "elevation"):
            raise InputError(f"a camera has no '{key}'; it has lookat, distance, azimuth, elevation")
        if key == "lookat":
            view.lookat[:] = value
        else:
            setattr(view, key, value)
    return view


def default_camera(model: mujoco.MjModel, data: mujoco.MjData) -> mujoco.MjvCamera:
    """A free camera that looks at the heaviest tree from ahead and the right."""
    view = mujoco.MjvCamera()
    view.type = mujoco.mjtCamera.mjCAMERA_FREE
    free = np.flatnonzero(model.jnt_type == mujoco.mjtJoint.mjJNT_FREE)
    heaviest = max(free, key=lambda j: model.body_subtreemass[model.jnt_bodyid[j]]) if len(free) else None
    body = int(model.jnt_bodyid[heaviest]) if heaviest is not None else 0
    com = np.array(data.subtree_com[body])
    view.lookat[:] = com
    view.azimuth, view.elevation = AZIMUTH, ELEVATION
    robot_height = 1.9 * max(com[2], 0.1)  # the COM of humanoids is a little above the half
    view.distance = robot_height / FILLED / 2 / np.tan(np.radians(model.vis.global_.fovy) / 2)
    return view


def _gl_context(width: int, height: int) -> Any:
    """A context of the first OpenGL backend that works."""
    asked = os.environ.get("MUJOCO_GL", "").lower().strip()
    display = not sys.platform.startswith("linux") or any(map(os.environ.get, ("DISPLAY", "WAYLAND_DISPLAY")))
    if asked in LIBRARIES:
        order = [asked]
    elif sys.platform.startswith("linux"):
        order = ["egl", "osmesa"] + ["glfw"] * display
    else:
        order = ["glfw"]
    tried = []
    for backend in order:
        if backend == "glfw" and not display:  # its context would be made, and be none
            tried.append("glfw: no display")
            continue
        if backend != "glfw" and not ctypes.util.find_library(LIBRARIES[backend]):
            tried.append(f"{backend}: no lib{LIBRARIES[backend]}")
            continue
        try:
            return importlib.import_module(f"mujoco.{backend}").GLContext(width, height)
        except Exception as error:  # each backend fails in its own way
            tried.append(f"{backend}: {' '.join(str(error).split())[:100] or type(error).__name__}")
    raise Error(
        f"cannot draw off screen ({'; '.join(tried)}): install EGL (Debian: libegl1 libegl-mesa0 libgl1-mesa-dri) or "
        "OSMesa (libosmesa6), or set MUJOCO_GL=glfw where there is a display"
    )
