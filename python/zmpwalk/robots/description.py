"""Descriptions of robots as values: read from a `robot.json`, written as plain dictionaries, compared with a model."""

from __future__ import annotations

import json
import os
import reprlib
from pathlib import Path
from typing import Any

import mujoco
import numpy as np

from .._core import Foot, RobotDescription
from ..checks import is_number
from ..errors import InputError, ModelError
from ..files import read_text
from .polygon import inscribed_rectangle

__all__ = [
    "Foot",
    "RobotDescription",
    "description_from_dict",
    "description_to_dict",
    "model_file",
    "read_description",
    "read_json",
    "renamed",
    "sole_pose",
]


def renamed(description: RobotDescription, name: str) -> RobotDescription:
    """The same with another name, unless that is empty.

    Usage: `renamed(description, "nao")`
    """
    return description_from_dict({**description_to_dict(description), "name": name}) if name else description


def read_description(path: str | os.PathLike) -> RobotDescription:
    """Read the description in a `robot.json`.

    Args:
        path: the file. Required keys: root_joint, left, right (each foot_body, leg_joints, and the sole in the foot's
            body: rect_x, rect_y [m], or a convex polygon of corners [x, y] [m], or length, width [m]; and sole_center
            [m], or sole_z where a rectangle or a polygon is given; of a polygon the rectangle inside it is used),
            stand_joints [rad], stand_base_pos [m]. Optional: name, sole_site, sole_quat_wxyz, stand_base_quat_wxyz,
            stand_keyframe, torque_limits (joint name -> N m, in place of the model's).

    Returns:
        The description, not yet compared with a model: `description.check(model)` does that.

    Raises:
        InputError: no such file, not JSON, a key missing or of the wrong kind; names the key and the file.

    Usage: `zmpwalk.load_robot(("my_scene.xml", zmpwalk.read_description("robot.json")))`
    """
    return description_from_dict(read_json(Path(path)), str(path))


def read_json(path: Path) -> dict[str, Any]:
    """The object that a `robot.json` holds.

    Raises:
        InputError: no such file, not JSON, or no object.

    Usage: `read_json(Path("robot.json"))["name"]`
    """
    try:
        plain = json.loads(read_text(path, "JSON"))
    except InputError:
        raise
    except ValueError as error:
        raise InputError(f"{path}: not JSON: {error}") from None
    except RecursionError:
        raise InputError(f"{path}: not a robot description: it is nested too deep") from None
    _require_utf8(plain, path)
    if not isinstance(plain, dict):
        raise InputError(f"{path}: a robot description is an object {{...}}, this is a {type(plain).__name__}")
    return plain


def _require_utf8(plain: Any, path: Path) -> None:
    """JSON's escapes can spell halves of a character, which no name of a file, body or joint has."""
    try:
        json.dumps(plain, ensure_ascii=False).encode("utf-8")
    except UnicodeEncodeError:
        raise InputError(f"{path}: a word in it is no text: it holds half a surrogate pair") from None
    except ValueError:  # an integer of more digits than Python writes
        raise InputError(f"{path}: a number in it has thousands of digits") from None


def model_file(plain: dict[str, Any], path: Path) -> Path:
    """The MJCF that a `robot.json` at `path` names: its scene, or its model where it has no scene.

    Raises:
        InputError: it names none.

    Usage: `model_file(read_json(path), path)`
    """
    file = plain.get("scene") or plain.get("model")
    if not isinstance(file, str):
        raise InputError(f"{path}: key 'model' is missing: the MJCF file's name, relative to this file")
    return path.parent / file


class _Reader:
    """Takes values out of a robot.json, naming key and file where one is missing or wrong."""

    def __init__(self, plain: dict[str, Any], source: str, prefix: str = ""):
        self.plain, self.source, self.prefix = plain, source, prefix

    def value(self, key: str, kind: type | tuple[type, ...], what: str, default: Any = None) -> Any:
        if key not in self.plain:
            if default is None:
                raise InputError(f"{self.source}: key '{self.prefix}{key}' is missing: {what}")
            return default
        given = self.plain[key]
        if not isinstance(given, kind) or (isinstance(given, bool) and kind is not bool):
            raise InputError(
                f"{self.source}: key '{self.prefix}{key}' is {reprlib.repr(self.plain[key])}; it must be {what}"
            )
        return self.plain[key]

    def numbers(self, key: str, count: int, what: str, default: Any = None) -> np.ndarray:
        raw = self.value(key, (list, tuple), what, default)
        array = self._array(raw)
        if array.shape != (count,) or not np.isfinite(array).all():
            raise InputError(f"{self.source}: key '{self.prefix}{key}' is {reprlib.repr(raw)}; it must be {what}")
        return array

    @staticmethod
    def _array(raw: Any) -> np.ndarray:
        """What is no array of numbers is empty."""
        try:
            good = all(map(is_number, np.asarray(raw, object).ravel()))
            return np.asarray(raw, float) if good else np.empty(0)
        except (OverflowError, TypeError, ValueError):
            return np.empty(0)

    def table(self, key: str, what: str, default: Any = None) -> dict[str, float]:
        numbers = self.value(key, dict, what, default)
        for name, number in numbers.items():
            if not is_number(number):
                raise InputError(
                    f"{self.source}: key '{key}.{name}' is {reprlib.repr(number)}; it must be a number: {what}"
                )
        return {name: float(number) for name, number in numbers.items()}

    def inside_polygon(self, key: str) -> tuple[np.ndarray, np.ndarray]:
        """x and y ranges of the sole's rectangle inside a convex polygon."""
        what = "three or more corners [x, y] of the sole in the foot's body [m] that span an area"
        raw = self.value(key, (list, tuple), what)
        corners = self._array(raw)
        good = corners.ndim == 2 and corners.shape[0] >= 3 and corners.shape[1] == 2 and np.isfinite(corners).all()
        ends = np.array(inscribed_rectangle(corners) if good else np.zeros(4))
        if not (ends[1] > ends[0] and ends[3] > ends[2]):
            raise InputError(f"{self.source}: key '{self.prefix}{key}' is {reprlib.repr(raw)}; it must be {what}")
        return ends[:2], ends[2:]

    def length(self, key: str) -> float:
        number = self.value(key, (int, float), "a length [m], more than 0")
        if not (is_number(number) and number > 0):
            shown = reprlib.repr(number)
            raise InputError(
                f"{self.source}: key '{self.prefix}{key}' is {shown}; it must be a length [m], more than 0"
            )
        return float(number)


def description_from_dict(plain: dict[str, Any], source: str = "description") -> RobotDescription:
    """The description in a dictionary of the form of a `robot.json`, the inverse of `description_to_dict`.

    Args:
        plain: keys as `read_description` lists them.
        source: where it comes from, named in messages.

    Raises:
        InputError: a key is missing or of the wrong kind.

    Usage: `description_from_dict(json.load(file), "robot.json")`
    """
    reader = _Reader(plain, source)
    feet = [_foot(reader.value(side, dict, f"the {side} foot's object"), source, side) for side in ("left", "right")]
    joints = reader.table("stand_joints", "joint name -> angle [rad] of the start pose")
    return RobotDescription(
        name=reader.value("name", str, "a name", Path(source).parent.name or "robot"),
        root_joint=reader.value("root_joint", str, "the name of the free joint, or empty"),
        left=feet[0],
        right=feet[1],
        stand_joints=joints,
        stand_base_pos=reader.numbers("stand_base_pos", 3, "three numbers [m]"),
        stand_base_quat=reader.numbers("stand_base_quat_wxyz", 4, "a quaternion [w, x, y, z]", [1.0, 0.0, 0.0, 0.0]),
        stand_keyframe=reader.value("stand_keyframe", str, "a keyframe's name", ""),
        torque_limits=reader.table("torque_limits", "joint name -> torque limit [N m]", {}),
    )


def _foot(plain: dict[str, Any], source: str, side: str) -> Foot:
    reader = _Reader(plain, source, f"{side}.")
    joints = reader.value("leg_joints", list, "the leg's joint names from hip to ankle")
    if "length" in plain or "width" in plain:
        length, width = reader.length("length"), reader.length("width")
        centre = reader.numbers("sole_center", 3, "three numbers [m] in the foot's body")
    else:
        if "polygon" in plain:
            x, y = reader.inside_polygon("polygon")
        else:
            x, y = (
                reader.numbers(key, 2, "[from, to] of the sole's rectangle in the foot's body [m]")
                for key in ("rect_x", "rect_y")
            )
        length, width = x[1] - x[0], y[1] - y[0]
        if not (length > 0 and width > 0):
            raise InputError(
                f"{source}: keys '{side}.rect_x', '{side}.rect_y' are {x.tolist()}, {y.tolist()}; "
                "each must be [from, to]"
            )
        if "sole_center" in plain and "polygon" not in plain:
            centre = reader.numbers("sole_center", 3, "three numbers [m] in the foot's body")
        else:
            z = reader.value(
                "sole_z", (int, float), "the sole plane's height in the foot's body [m] (or give sole_center)"
            )
            if not is_number(z):
                raise InputError(f"{source}: key '{side}.sole_z' is {z!r}; it must be a number [m]")
            centre = np.array([x.mean(), y.mean(), float(z)])
    return Foot(
        body=reader.value("foot_body", str, "the name of the foot's body"),
        sole_site=reader.value("sole_site", str, "a site's name", ""),
        sole_pos=centre,
        sole_quat=reader.numbers("sole_quat_wxyz", 4, "a quaternion [w, x, y, z]", [1.0, 0.0, 0.0, 0.0]),
        length=float(length),
        width=float(width),
        leg_joints=[str(joint) for joint in joints],
    )


def description_to_dict(description: RobotDescription) -> dict[str, Any]:
    """A description as plain lists and strings, in the form of a `robot.json`.

    Returns:
        What `read_description` reads, lengths in m, angles in rad; exact: reading it gives the same numbers.

    Usage: `json.dump(description_to_dict(description), file)`
    """

    def foot(f: Foot) -> dict[str, Any]:
        return {
            "leg_joints": list(f.leg_joints), "foot_body": f.body, "sole_site": f.sole_site,
            "sole_center": np.asarray(f.sole_pos).tolist(), "sole_quat_wxyz": np.asarray(f.sole_quat).tolist(),
            "length": float(f.length), "width": float(f.width),
        }  # fmt: skip

    return {
        "name": description.name, "root_joint": description.root_joint,
        "left": foot(description.left), "right": foot(description.right),
        "stand_joints": {joint: float(angle) for joint, angle in dict(description.stand_joints).items()},
        "stand_base_pos": np.asarray(description.stand_base_pos).tolist(),
        "stand_base_quat_wxyz": np.asarray(description.stand_base_quat).tolist(),
        "stand_keyframe": description.stand_keyframe,
        "torque_limits": dict(description.torque_limits),
    }  # fmt: skip


def _id(model: mujoco.MjModel, kind: str, name: str) -> int:
    found = mujoco.mj_name2id(model, getattr(mujoco.mjtObj, f"mjOBJ_{kind}"), name)
    if found < 0:
        raise ModelError(f"the model has no {kind.lower()} '{name}'")
    return int(found)


def sole_pose(model: mujoco.MjModel, data: mujoco.MjData, foot: Foot) -> tuple[np.ndarray, np.ndarray]:
    """Where a sole is: centre (3,) [m] and axes (3, 3), columns forward, left, up, both in the world.

    Raises:
        ModelError: the model lacks the foot's body.

    Usage: `sole_pose(model, data, description.left)[0]`
    """
    body, R_BF = _id(model, "BODY", foot.body), np.zeros(9)
    mujoco.mju_quat2Mat(R_BF, np.asarray(foot.sole_quat, float))
    R_WB = data.xmat[body].reshape(3, 3)
    return data.xpos[body] + R_WB @ np.asarray(foot.sole_pos), R_WB @ R_BF.reshape(3, 3)
