"""Robots of the package robot_descriptions by name, where it is installed: `robot_descriptions:g1_mj`."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path

from ..errors import InputError, nearest

DESCRIPTIONS_PREFIX = "robot_descriptions:"


def described_file(robot: str) -> Path:
    """The MJCF or URDF of a robot of that package, which downloads it where it is not in its cache.

    Args:
        robot: "robot_descriptions:NAME"; the suffix `_description` may be left out.

    Returns:
        The file: the MJCF where the robot has one.

    Raises:
        InputError: the package is not installed, knows no such robot, or cannot download it; says which.

    Usage: `described_file("robot_descriptions:g1_mj")`
    """
    try:
        package = import_module("robot_descriptions")
    except ImportError:
        raise InputError(
            f"{robot}: the package robot_descriptions is not installed: pip install robot_descriptions"
        ) from None
    name = robot[len(DESCRIPTIONS_PREFIX) :]
    full = name if name.endswith("_description") else f"{name}_description"
    known = sorted(getattr(package, "DESCRIPTIONS", ()))
    if known and full not in known:
        near = ", ".join(nearest(full, known)[:5])
        raise InputError(f"{robot}: robot_descriptions has no '{full}'; the nearest names are {near}")
    try:
        found = import_module(f"robot_descriptions.{full}")
    except ModuleNotFoundError:
        raise InputError(f"{robot}: robot_descriptions has no '{full}'") from None
    except Exception as error:  # the download is made at import and fails in the ways of git
        raise InputError(f"{robot}: cannot be downloaded ({' '.join(str(error).split())[:200]})") from None
    file = getattr(found, "MJCF_PATH", None) or getattr(found, "URDF_PATH", None)
    if file is None:
        raise InputError(f"{robot}: robot_descriptions gives neither an MJCF nor a URDF of it")
    return Path(file)
