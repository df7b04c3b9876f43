"""Robots by name or by file: those that come with zmpwalk, those of MuJoCo Menagerie, and a user's own."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Tuple, Union

import mujoco

from .._core import RobotDescription
from ..errors import Error, InputError
from .description import description_from_dict, model_file, read_description, read_json, renamed
from .menagerie import PREFIX, menagerie_file
from .proposal import Proposal, appraise, describe, propose
from .robot_descriptions import DESCRIPTIONS_PREFIX, described_file
from .source import remember, source_of

__all__ = ["ROBOTS", "Robot", "available_robots", "examine", "load_robot", "read_robot", "robot_file"]

ROBOTS = Path(__file__).resolve().parent
MODELS = (".xml", ".mjcf", ".urdf")  # kinds of files that hold a model

Robot = Union[str, os.PathLike, "mujoco.MjModel", Tuple[Any, Any]]


def available_robots() -> list[str]:
    """Names of the robots that come with zmpwalk.

    Returns:
        Sorted names, each good for `load_robot` and `zmpwalk walk --robot`.

    Usage: `zmpwalk.available_robots()  # -> ["mahru"]`
    """
    return sorted(_bundled())


def _bundled() -> dict[str, Path]:
    files = {path.parent.name: path for path in ROBOTS.glob("*/robot.json")}
    files.update({path.stem: path for path in ROBOTS.glob("*.xml")})
    return files


def load_robot(robot: Robot) -> tuple[mujoco.MjModel, RobotDescription]:
    """A robot's model and where its feet are.

    Args:
        robot: one of
            - a name of `available_robots()`;
            - a path to a `robot.json` (or the folder that holds one): its "scene" is loaded, or its "model" where it
              has no scene;
            - "menagerie:NAME", a robot of MuJoCo Menagerie (see `zmpwalk.robots.menagerie`);
            - "robot_descriptions:NAME", a robot of the package robot_descriptions;
            - a path to an MJCF (`.xml`, `.mjcf`) or a `.urdf`, or an `MjModel`, in which `describe` finds a robot;
            - a pair (path of a model or `MjModel`, `RobotDescription` or `robot.json` path or None).

    Returns:
        model: the compiled model.
        description: checked against the model: `description.place(model, data)` works.

    Raises:
        InputError: unknown name, missing file, or a `robot.json` without a key it needs (named).
        ModelError: MuJoCo refuses the model, or the model lacks what the description names.

    Usage: `model, description = zmpwalk.load_robot("mahru")`
    """
    model, description, name = read_robot(robot)
    if description is None:
        description = renamed(describe(model), name)
    description.check(model)
    return model, description


def examine(robot: Robot) -> tuple[mujoco.MjModel, Proposal]:
    """What `load_robot` loads, with the table and remarks of `propose`.

    Args:
        robot: see `load_robot`.

    Raises:
        InputError, ModelError: as `load_robot`.

    Usage: `model, proposal = examine("bare.xml")`
    """
    model, description, name = read_robot(robot)
    if description is not None:
        description.check(model)
        return model, appraise(model, description)
    found = propose(model)
    remarks = _said_of_urdf(robot) + found.remarks
    table = {**found.table, "name": name or found.table["name"]}
    return model, Proposal(renamed(found.description, name), remarks, {**table, "remarks": remarks})


def read_robot(robot: Robot) -> tuple[mujoco.MjModel, RobotDescription | None, str]:
    """A robot's model, the description that comes with it, if one does, and what its file is called.

    Args:
        robot: see `load_robot`.

    Raises:
        InputError, ModelError: as `load_robot`; the description is not compared with the model.

    Usage: `model, description, name = read_robot("bare.xml")`
    """
    description, name = None, ""
    if isinstance(robot, (tuple, list)):
        if len(robot) != 2:
            raise InputError(
                f"a robot given as a pair is (model or xml path, description); this has {len(robot)} parts"
            )
        robot, description = robot
        if isinstance(description, (str, os.PathLike)):
            description = read_description(description)
    if isinstance(robot, mujoco.MjModel):
        model = robot
    elif isinstance(robot, (str, os.PathLike)):
        path = _find(robot)
        if path.suffix.lower() == ".json":
            plain = read_json(path)
            description = description or description_from_dict(plain, str(path))
            path = model_file(plain, path)
        name = _name_of(str(robot), path)
        model = _read(path)
        remember(model, source_of(path))
    else:
        raise InputError(
            f"a robot is a name, a path, a model or a pair (model, description), not {type(robot).__name__}"
        )
    return model, description, name


def robot_file(robot: str | os.PathLike) -> Path:
    """The MJCF that `load_robot` loads for a name or a path.

    Raises:
        InputError: as `load_robot`.

    Usage: `robot_file("mahru").parent`
    """
    path = _find(robot)
    if path.suffix.lower() != ".json":
        return path
    return model_file(read_json(path), path)


def _name_of(robot: str, path: Path) -> str:
    """What the robot at `path`, given as `robot`, is called."""
    collection, _, name = robot.partition(":")
    if f"{collection}:" in (PREFIX, DESCRIPTIONS_PREFIX):
        return name.partition("/")[0]
    return path.absolute().parent.name if path.stem == "scene" and path.absolute().parent.name else path.stem


def _find(robot: str | os.PathLike) -> Path:
    try:
        return _look_for(robot)
    except Error:
        raise
    except (OSError, RuntimeError, ValueError) as error:  # too long, no such user, no name at all
        raise InputError(f"{str(robot)[:60]!r} is no robot's name and no path of a file ({error})") from None


def _look_for(robot: str | os.PathLike) -> Path:
    bundled = _bundled()
    if robot in bundled:
        return bundled[str(robot)]
    if str(robot).startswith(PREFIX):
        return menagerie_file(str(robot))
    if str(robot).startswith(DESCRIPTIONS_PREFIX):
        return described_file(str(robot))
    path = Path(robot).expanduser()
    if path.is_dir() and (path / "robot.json").is_file():
        return path / "robot.json"
    if path.is_file() and path.suffix.lower() in (".json", *MODELS):
        return path
    if path.exists():
        raise InputError(f"{path}: not a robot; give a robot.json, a folder with one, an MJCF (.xml, .mjcf) or a .urdf")
    if path.suffix or len(path.parts) > 1:
        raise InputError(f"{path}: no such file")
    raise InputError(
        f"unknown robot '{robot}': there is {', '.join(sorted(bundled))}; "
        "a path to a robot.json, an MJCF or a URDF works too"
    )


def _read(path: Path) -> mujoco.MjModel:
    from .mjcf import read_model  # what reads XML is slow to import

    return read_model(path)


def _from_urdf(path: Path) -> tuple[mujoco.MjModel, list[str]]:
    from .urdf import read_urdf  # what reads XML is slow to import

    return read_urdf(path)


def _said_of_urdf(robot: Robot) -> list[str]:
    """What was added to a URDF so that it can walk."""
    is_path = isinstance(robot, (str, os.PathLike)) and Path(robot).suffix.lower() == ".urdf"
    return _from_urdf(Path(robot).expanduser())[1] if is_path else []  # type: ignore[arg-type]
