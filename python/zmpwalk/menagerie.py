"""Robots of MuJoCo Menagerie by name, where its package is installed: `menagerie:unitree_g1`."""

from __future__ import annotations

import sys
from pathlib import Path

import mujoco

from .errors import InputError

PREFIX = "menagerie:"


def menagerie_file(robot: str) -> Path:
    """The MJCF of a robot of MuJoCo Menagerie, downloaded by its package where it is not in the package's cache.

    Args:
        robot: "menagerie:NAME" (its scene) or "menagerie:NAME/ENTRY".

    Returns:
        The file.

    Raises:
        InputError: the package is not installed, knows no such robot or entry, or cannot download it; says which.

    Usage: `menagerie_file("menagerie:unitree_g1/scene")`
    """
    if sys.version_info < (3, 11):
        raise InputError(
            f"{robot}: MuJoCo Menagerie needs MuJoCo 3.2 or later, which zmpwalk has under Python 3.11 or later; "
            f"this is MuJoCo {mujoco.__version__}"
        )
    try:
        import mujoco_menagerie
    except ImportError:
        raise InputError(
            f'{robot}: the package mujoco-menagerie is not installed: pip install "zmpwalk[robots]"'
        ) from None
    name, _, entry = robot[len(PREFIX) :].partition("/")
    try:
        return Path(mujoco_menagerie.get(name).xml(entry or None))
    except (mujoco_menagerie.MenagerieError, OSError) as error:
        raise InputError(f"{robot}: {' '.join(str(error).split())}{_humanoids(error, mujoco_menagerie)}") from None


def _humanoids(error: Exception, package: object) -> str:
    if not isinstance(error, package.UnknownRobotError):  # type: ignore[attr-defined]
        return ""
    known = [robot.name for kind in ("humanoid", "biped") for robot in package.robots(kind)]  # type: ignore[attr-defined]
    return f" Its humanoids are {', '.join(known)}"
