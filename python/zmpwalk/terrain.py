"""Ground to walk on, and ground that a controller knows.

Slopes, blocks, plates, steps, stairs and waves that take the place of a robot's floor."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass, field
from typing import Any, Callable, Mapping, NamedTuple, Sequence, Union

import mujoco
import numpy as np

from . import _core
from .errors import InputError, ModelError, nearest
from .robots import Robot, RobotDescription, load_robot, robot_file
from .robots.load import read_robot
from .robots.source import Given, remember, source_of

__all__ = ["KnownGround", "Patch", "Terrain", "known_of", "load_scene", "scene_model"]

START = 0.5  # where the ground begins to differ from the floor, along x from the start [m]
BEHIND, AHEAD, ASIDE = 3.0, 40.0, 20.0  # how far the ground goes on around that place [m]
FIELD = (12.0, 1.6)  # length and width of a field of blocks or plates, where the robot walks [m]
BLOCK = 0.2  # side of a block or plate [m]
STRIP = 0.05  # width of the strips that make up a curved ground [m]
TILTS_WITHIN = 1.0  # way along which a ground begins to lean sideways [m]
THICK = 0.5  # of a patch [m]
WAVE = 1.0  # length of a wave [m]
DARKEST = 0.6  # brightness of the lowest patch beside that of the highest, so that heights are seen


class Patch(NamedTuple):
    """A plane piece of ground, a rectangle seen from above.

    `x` and `y` are its ranges [m], `height` is the height of its middle over the floor [m], and `rise` is how much
    higher it becomes per metre along x and along y. `friction` is that of the patch, whatever the soles have; None is
    as the floor. `terrain=` of `simulate` tells the controller nothing of it; one that is given the model of this
    ground takes its least friction.
    """

    x: tuple[float, float]
    y: tuple[float, float]
    height: float = 0.0
    rise: tuple[float, float] = (0.0, 0.0)
    friction: float | None = None

    @property
    def middle(self) -> np.ndarray:
        """The point of the ground in its middle (3,) [m]."""
        return np.array([0.5 * sum(self.x), 0.5 * sum(self.y), self.height])

    @property
    def axes(self) -> np.ndarray:
        """Rotation (3, 3) whose columns are along its x, its y and its normal."""
        along = np.array([1.0, 0.0, self.rise[0]])
        normal = np.array([-self.rise[0], -self.rise[1], 1.0])
        along, normal = along / np.linalg.norm(along), normal / np.linalg.norm(normal)
        return np.column_stack([along, np.cross(normal, along), normal])


@dataclass(frozen=True)
class Terrain:
    """A ground that takes the place of the floor of a robot's scene.

    The robot starts on the floor and walks along x; 0.5 m ahead the ground begins. It is made of boxes that touch as
    the floor does (friction, stiffness). The controller is not told of it, unless it is given as `KnownGround` too.

    Args:
        text: how it was asked for, as `Terrain.of` takes it and a trace records it.
        patches: pieces of ground, which cover all that the robot may step on.
        solref: time constant with which the ground gives way [s]; None leaves it as the floor has it.

    Usage: `zmpwalk.simulate(profile=0.25, terrain=zmpwalk.Terrain.blocks(2.0, seed=3), duration=30)`
    """

    text: str
    patches: Sequence[Patch] = field(repr=False)
    solref: float | None = None

    @classmethod
    def of(cls, terrain: TerrainLike) -> Terrain:
        """The terrain that was given as such, or by one of these words.

        Args:
            terrain: a `Terrain`, or a text:
                "flat"; "soft:SECONDS", flat ground that gives way with this time constant;
                "slope:DEG" or "slope:DEG,AZIMUTH", which rises towards the azimuth [deg], 0 ahead and 90 to the left;
                "blocks:CM" or "blocks:CM,SEED", blocks of 0.2 m with random heights between 0 and CM;
                "plates:DEG" or "plates:DEG,SEED", plates of 0.2 m, each tilted at random by up to DEG about both axes;
                "step:CM" or "step:CM,AT", a single step, up or down where CM < 0, at x = AT [m];
                "stairs:RISExTREAD" [cm], ten steps up, a landing and ten steps down; down first where RISE < 0;
                "waves" or "waves:CM", waves of 1 m that go up and down by CM.

        Raises:
            InputError: something else.

        Usage: `Terrain.of("slope:5,90")`
        """
        if isinstance(terrain, Terrain):
            return terrain
        kind, _, rest = str(terrain).partition(":")
        if kind not in _KINDS:
            raise InputError(f"the terrain '{terrain}' is unknown; did you mean {' or '.join(nearest(kind, _KINDS))}?")
        make, forms = _KINDS[kind]
        try:
            numbers = [float(word) for word in rest.replace("x" if kind == "stairs" else ",", ",").split(",") if rest]
            if not all(map(math.isfinite, numbers)):
                raise ValueError
            return make(*numbers)
        except InputError:
            raise
        except (TypeError, ValueError):
            raise InputError(f"the terrain '{terrain}' is not one: write it as {forms}") from None

    @classmethod
    def flat(cls) -> Terrain:
        """The floor, as a box. Usage: `Terrain.flat()`"""
        return cls("flat", [_rest(-BEHIND, AHEAD)])

    @classmethod
    def soft(cls, solref: float = 0.02) -> Terrain:
        """Flat ground that gives way with the time constant `solref` [s]. Usage: `Terrain.soft(0.02)`"""
        return cls(f"soft:{solref:g}", [_rest(-BEHIND, AHEAD)], float(solref))

    @classmethod
    def slope(cls, degrees: float, azimuth: float = 0.0) -> Terrain:
        """A plane that rises by `degrees` towards `azimuth` [deg]: 0 is ahead, 90 to the left.

        Along the line walked the flat ends in the ramp at once. Across it, the ground begins to lean over a way of
        1 m, in strips of 5 cm.

        Usage: `Terrain.slope(-5)` goes down, `Terrain.slope(5, 90)` is higher on the left.
        """
        _require(abs(degrees) < 60.0, "slope", degrees, "less than 60 degrees")
        rise = math.tan(math.radians(degrees))
        along, across = rise * math.cos(math.radians(azimuth)), rise * math.sin(math.radians(azimuth))
        along, across = (0.0 if abs(each) < 1e-12 else each for each in (along, across))
        patches, x = [_rest(-BEHIND, START)], START
        if across:
            for k in range(round(TILTS_WITHIN / STRIP)):
                share = (k + 0.5) * STRIP / TILTS_WITHIN
                height = along * (x + 0.5 * STRIP - START)
                patches.append(Patch((x, x + STRIP), (-ASIDE, ASIDE), height, (along, share * across)))
                x += STRIP
        middle = 0.5 * (x + AHEAD)
        patches.append(Patch((x, AHEAD), (-ASIDE, ASIDE), along * (middle - START), (along, across)))
        return cls(f"slope:{degrees:g},{azimuth:g}", patches)

    @classmethod
    def blocks(cls, cm: float, seed: float = 0) -> Terrain:
        """Blocks of 0.2 m whose heights are random, evenly spread between 0 and `cm` [cm].

        Usage: `Terrain.blocks(2.0, seed=3)`
        """
        rng = _random("blocks", seed)
        lower, upper = sorted((0.0, 0.01 * cm))
        return cls(f"blocks:{cm:g},{seed:g}", _field(lambda: (rng.uniform(lower, upper), (0.0, 0.0))))

    @classmethod
    def plates(cls, degrees: float, seed: float = 0) -> Terrain:
        """Plates of 0.2 m, each tilted at random by up to `degrees` about both axes; middles are at floor height.

        Usage: `Terrain.plates(3.0, seed=1)`
        """
        rng = _random("plates", seed)
        _require(abs(degrees) < 30.0, "plates", degrees, "less than 30 degrees")
        most = math.radians(abs(degrees))
        tilt = lambda: (0.0, tuple(np.tan(rng.uniform(-most, most, 2)).tolist()))  # noqa: E731
        return cls(f"plates:{degrees:g},{seed:g}", _field(tilt))

    @classmethod
    def step(cls, cm: float, at: float = 1.0) -> Terrain:
        """A single step of `cm` [cm] at x = `at` [m], up, or down where it is negative.

        Usage: `Terrain.step(-2.0, 1.05)`
        """
        _require(-BEHIND < at < AHEAD, "step", at, "on the ground there is")
        return cls(f"step:{cm:g},{at:g}", [_rest(-BEHIND, at), _rest(at, AHEAD, 0.01 * cm)])

    @classmethod
    def stairs(cls, rise: float, tread: float) -> Terrain:
        """Ten steps of `rise` by `tread` [cm], a landing of 1 m, and ten steps back. Usage: `Terrain.stairs(12, 28)`"""
        _require(tread > 0.0, "stairs", tread, "a tread longer than 0")
        count, x, patches = 10, START, [_rest(-BEHIND, START)]
        for k in [*range(1, count + 1), *range(count - 1, -1, -1)]:
            length = 1.0 if k == count else 0.01 * tread
            patches.append(_rest(x, x + length if k else AHEAD, 0.01 * rise * k))
            x += length
        return cls(f"stairs:{rise:g}x{tread:g}", patches)

    @classmethod
    def waves(cls, cm: float = 2.0) -> Terrain:
        """Waves of 1 m along x that rise and fall by `cm` [cm]. Usage: `Terrain.waves(3)`"""
        half, turns = 0.005 * cm, 2.0 * math.pi / WAVE
        patches, count = [_rest(-BEHIND, START)], round(FIELD[0] / STRIP)
        for k in range(count):
            height = [half * (1.0 - math.cos(turns * (k + i) * STRIP)) for i in (0, 1)]
            x = START + k * STRIP
            rise = (height[1] - height[0]) / STRIP
            patches.append(Patch((x, x + STRIP), (-ASIDE, ASIDE), 0.5 * sum(height), (rise, 0.0)))
        patches.append(_rest(START + count * STRIP, AHEAD))
        return cls(f"waves:{cm:g}", patches)

    def height(self, x: float, y: float) -> float:
        """Height of the ground over the floor at a place [m]; not-a-number where there is none.

        Usage: `terrain.height(1.0, 0.0)`
        """
        tops = [
            p.height + p.rise[0] * (x - p.middle[0]) + p.rise[1] * (y - p.middle[1])
            for p in self.patches
            if p.x[0] <= x < p.x[1] and p.y[0] <= y < p.y[1]
        ]
        return max(tops, default=math.nan)

    def as_floor(self) -> Terrain:
        """The same ground, all of it as slippery as the floor.

        Usage: `Terrain.of("blocks:2").as_floor()`
        """
        return Terrain(self.text, [each._replace(friction=None) for each in self.patches], self.solref)

    def model(self, robot: str | os.PathLike) -> mujoco.MjModel:
        """The robot's scene with this ground in place of its floor.

        Args:
            robot: a name, "menagerie:NAME", or a path to a robot.json or an MJCF, whose floor is a plane.

        Raises:
            InputError: the robot is given as a model or a URDF, in which no floor can be replaced.
            ModelError: its scene has no floor, or MuJoCo refuses it.

        Usage: `model = Terrain.slope(3).model("mahru")`
        """
        path = robot_file(robot)
        if path.suffix.lower() == ".urdf":
            raise InputError(f"{path}: a terrain takes the place of the floor of an MJCF; a URDF has none")
        source = source_of(path)
        if source is None:
            raise ModelError(f"{path}: it names files that are not there")
        try:
            source = source.on_ground(lambda floor: [self._box(k, each, floor) for k, each in enumerate(self.patches)])
        except ModelError as error:
            raise ModelError(f"{path}: {error}") from None
        model = source.compiled()
        remember(model, source)  # a trace keeps the ground with the robot
        return model

    def _box(self, k: int, patch: Patch, like: Mapping[str, str]) -> dict[str, str]:
        """Attributes of a box whose upper side is the patch, with what `like` says of its contact and looks."""
        keep = {name: value for name, value in like.items() if name not in _SHAPE}
        floor = float((like.get("pos") or "0 0 0").split()[2])
        axes = patch.axes
        half = np.array([0.5 * (patch.x[1] - patch.x[0]), 0.5 * (patch.y[1] - patch.y[0]), 0.5 * THICK])
        half[:2] /= axes[0, 0], math.hypot(*axes[:2, 1])  # it is as wide as that, seen from above
        centre = patch.middle + [0.0, 0.0, floor] - half[2] * axes[:, 2]
        low, high = min(p.height for p in self.patches), max(p.height for p in self.patches)
        if high > low:
            shade = DARKEST + (1.0 - DARKEST) * (patch.height - low) / (high - low)
            keep.setdefault("rgba", _text([shade, shade, shade, 1.0]))
        if self.solref is not None:
            keep.update(solref=f"{self.solref!r} 1", priority="1")
        if patch.friction is not None:
            keep.update(friction=f"{patch.friction!r} 0.005 0.0001", priority="1")
        return {
            **keep, "name": f"terrain_{k}", "type": "box", "size": _text(half), "pos": _text(centre),
            "xyaxes": _text([*axes[:, 0], *axes[:, 1]]),
        }  # fmt: skip


TerrainLike = Union[Terrain, str]


class KnownGround(_core.KnownGround):
    """Ground that a controller knows: a height for each place.

    Usage: `controller.know(KnownGround.of_function(lambda x, y: 0.02 * x, x=(-1, 9), y=(-1, 1)))`
    """

    @staticmethod
    def of(ground: GroundLike, model: mujoco.MjModel | None = None) -> _core.KnownGround:
        """The ground that was given as such, or by one of these.

        Args:
            ground: a `KnownGround`; a `Terrain`, or its text such as "stairs:12x28"; a list of `Patch`; or the name of
                a geom of `model` that is an hfield.
            model: in which that geom is.

        Raises:
            InputError: something else.

        Usage: `KnownGround.of("slope:15")`
        """
        if isinstance(ground, _core.KnownGround):
            return ground
        if isinstance(ground, str):
            geom = -1 if model is None else mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_GEOM, ground)
            if geom >= 0:
                return KnownGround.of_hfield(model, ground)  # type: ignore[arg-type]
            ground = Terrain.of(ground)
        patches = ground.patches if isinstance(ground, Terrain) else ground
        try:
            rows = np.array([[*p.x, *p.y, p.height, *p.rise] for p in patches], dtype=float)
        except (AttributeError, TypeError, ValueError):
            raise InputError(
                f"{ground!r} is no ground; give a KnownGround, a Terrain or its text, patches, or an hfield's name"
            ) from None
        return _core.KnownGround.of_patches(rows.reshape(-1, 7))

    @staticmethod
    def of_function(
        height: Callable[[float, float], float],
        x: tuple[float, float],
        y: tuple[float, float],
        spacing: float = 0.02,
    ) -> _core.KnownGround:
        """Heights of a function, taken on a grid.

        Args:
            height: f(x, y) [m] of world x and y [m].
            x, y: ranges that the robot may step on [m].
            spacing: of the grid [m]; between its points heights are bilinear, so that an edge becomes a ramp of this
                length.

        Raises:
            InputError: a range that is empty, a height that is not finite.

        Usage: `KnownGround.of_function(lambda x, y: 0.1 * (x > 1), x=(-1, 5), y=(-1, 1))`
        """
        if not (spacing > 0.0 and x[0] < x[1] and y[0] < y[1]):
            raise InputError(f"x is {x}, y is {y}, spacing is {spacing!r}: ranges must go upwards, spacing must be > 0")
        along, across = (np.arange(r[0], r[1] + spacing, spacing) for r in (x, y))
        heights = np.array([[float(height(float(a), float(b))) for b in across] for a in along])
        return _core.KnownGround.of_grid(np.array([x[0], y[0]]), spacing, heights)

    @staticmethod
    def of_hfield(model: mujoco.MjModel, geom: str) -> _core.KnownGround:
        """The heights of a geom of type hfield that lies level, its axes along the world's.

        Raises:
            InputError: the model has no such geom, or it is turned.

        Usage: `KnownGround.of_hfield(model, "terrain")`
        """
        g = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_GEOM, geom)
        if g < 0 or model.geom_type[g] != mujoco.mjtGeom.mjGEOM_HFIELD:
            raise InputError(f"the model has no hfield geom '{geom}'")
        data = mujoco.MjData(model)
        mujoco.mj_kinematics(model, data)
        if not np.allclose(data.geom_xmat[g].reshape(3, 3), np.eye(3), atol=1e-9):
            raise InputError(f"the hfield '{geom}' is turned; its axes must be those of the world")
        f = model.geom_dataid[g]
        rows, columns, start = model.hfield_nrow[f], model.hfield_ncol[f], model.hfield_adr[f]
        size, at = model.hfield_size[f], data.geom_xpos[g]
        heights = at[2] + size[2] * model.hfield_data[start : start + rows * columns].reshape(rows, columns).T
        spacing = 2.0 * size[0] / (columns - 1)
        if not math.isclose(spacing, 2.0 * size[1] / (rows - 1), rel_tol=1e-6):
            across = np.arange(0.0, 2.0 * size[1] + 0.5 * spacing, spacing)
            own = np.linspace(0.0, 2.0 * size[1], rows)
            heights = np.array([np.interp(across, own, row) for row in heights])
        return _core.KnownGround.of_grid(at[:2] - size[:2], spacing, np.asarray(heights, dtype=float))

    @staticmethod
    def to_dict(ground: _core.KnownGround) -> dict[str, Any]:
        """The ground as plain numbers, for JSON. Usage: `KnownGround.to_dict(controller.ground)`"""
        if len(ground.patches):
            return {"patches": ground.patches.tolist()}
        return {"corner": ground.corner.tolist(), "spacing": ground.spacing, "heights": ground.heights.tolist()}

    @staticmethod
    def from_dict(values: Mapping[str, Any]) -> _core.KnownGround:
        """The ground of such a dictionary. Usage: `KnownGround.from_dict(trace.meta["known_ground"])`"""
        if "patches" in values:
            return _core.KnownGround.of_patches(np.array(values["patches"]))
        return _core.KnownGround.of_grid(
            np.array(values["corner"]), float(values["spacing"]), np.array(values["heights"])
        )


GroundLike = Union[_core.KnownGround, TerrainLike, Sequence[Patch]]


def known_of(known: bool, ground: GroundLike | None, terrain: TerrainLike | None) -> GroundLike | None:
    """What a controller knows of the ground: `ground`, or the `terrain` where it is `known`; None: nothing.

    Raises:
        InputError: `known` without a terrain, or beside `ground`.

    Usage: `known_of(True, None, "stairs:12x28")`
    """
    if not known:
        return ground
    if terrain is None or ground is not None:
        raise InputError(
            "known=True says that the controller knows the terrain: give a terrain, and no ground beside it"
        )
    return Terrain.of(terrain)


_SHAPE = ("name", "type", "size", "pos", "quat", "euler", "axisangle", "xyaxes", "zaxis", "fromto")
_KINDS: dict[str, Any] = {
    "flat": (Terrain.flat, "flat"),
    "soft": (Terrain.soft, "soft:SECONDS"),
    "slope": (Terrain.slope, "slope:DEG or slope:DEG,AZIMUTH"),
    "blocks": (Terrain.blocks, "blocks:CM or blocks:CM,SEED"),
    "plates": (Terrain.plates, "plates:DEG or plates:DEG,SEED"),
    "step": (Terrain.step, "step:CM or step:CM,AT"),
    "stairs": (Terrain.stairs, "stairs:RISExTREAD"),
    "waves": (Terrain.waves, "waves or waves:CM"),
}
FORMS = {kind: form for kind, (_, form) in _KINDS.items()}  # how each is written


def load_scene(
    robot: Robot, terrain: TerrainLike | None, source: Given = None
) -> tuple[mujoco.MjModel, RobotDescription]:
    """What `load_robot` loads, on `terrain` in place of its floor; None leaves the floor.

    Raises:
        InputError, ModelError: as `load_robot`, `Terrain.of` and `Terrain.model`; a `source` besides a terrain.

    Usage: `model, description = load_scene("mahru", "blocks:2,7")`
    """
    if terrain is None:
        return load_robot(robot)
    if source is not None:
        raise InputError("a source is for a robot that is given as a model; on a terrain it brings its own")
    model = scene_model(robot, terrain)
    _, description = load_robot(robot)
    description.check(model)
    return model, description


def scene_model(robot: Robot, terrain: TerrainLike | None) -> mujoco.MjModel:
    """What `read_robot` reads, on `terrain` in place of its floor; None leaves the floor.

    Raises:
        InputError, ModelError: as `load_scene`.

    Usage: `model = scene_model("mahru", "slope:3")`
    """
    if terrain is None:
        return read_robot(robot)[0]
    ground = Terrain.of(terrain)
    file = robot[0] if isinstance(robot, (tuple, list)) and len(robot) == 2 else robot
    if not isinstance(file, (str, os.PathLike)):
        raise InputError("a terrain takes the place of the floor in a robot's file; give a name or a path, not a model")
    return ground.model(file)


def _require(good: bool, kind: str, value: float, rule: str) -> None:
    if not good:
        raise InputError(f"the terrain '{kind}' with {value:g}: it must be {rule}")


def _random(kind: str, seed: float) -> np.random.Generator:
    _require(seed == int(seed) and seed >= 0, kind, seed, "seeded by an integer of at least 0")
    return np.random.default_rng(int(seed))


def _rest(x_0: float, x_1: float, height: float = 0.0) -> Patch:
    """Level ground across all that there is."""
    return Patch((x_0, x_1), (-ASIDE, ASIDE), height)


def _field(piece: Any) -> list[Patch]:
    """A field of squares, `piece()` says height and rise of each, and level ground around it."""
    length, width = FIELD
    patches = [_rest(-BEHIND, START), _rest(START + length, AHEAD)]
    patches += [Patch((START, START + length), side) for side in ((-ASIDE, -0.5 * width), (0.5 * width, ASIDE))]
    for i in range(round(length / BLOCK)):
        for j in range(round(width / BLOCK)):
            height, rise = piece()
            x, y = START + i * BLOCK, -0.5 * width + j * BLOCK
            patches.append(Patch((x, x + BLOCK), (y, y + BLOCK), height, rise))
    return patches


def _text(numbers: Any) -> str:
    return " ".join(repr(float(number)) for number in numbers)
