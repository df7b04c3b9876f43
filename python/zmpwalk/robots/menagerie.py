"""Robots of MuJoCo Menagerie by name, where its package is installed: `menagerie:unitree_g1`."""

from __future__ import annotations

from pathlib import Path

from ..errors import InputError

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
    try:
        import mujoco_menagerie
    except ImportError:
        raise InputError(
            f"{robot}: the package mujoco-menagerie is not installed: pip install mujoco-menagerie "
            "(it needs Python 3.10.12 and MuJoCo 3.2 or later)"
        ) from None
    name, _, entry = robot[len(PREFIX) :].partition("/")
    try:
        found = mujoco_menagerie.get(name)
        found.entry(entry or None)  # an unknown one is told without a download
        return Path(found.xml(entry or None))
    except mujoco_menagerie.UnknownRobotError as error:
        raise InputError(f"{robot}: {error} Its humanoids are {', '.join(menagerie_humanoids())}") from None
    except mujoco_menagerie.DownloadError as error:
        help = "set MENAGERIE_ROOT to a checkout of MuJoCo Menagerie to do without"
        raise InputError(f"{robot}: cannot be downloaded ({error}); {help}") from None
    except (mujoco_menagerie.MenagerieError, OSError) as error:
        raise InputError(f"{robot}: {error}") from None


def menagerie_humanoids() -> list[str]:
    """Names of Menagerie's robots on two legs, each good after `PREFIX`.

    Raises:
        ImportError: the package mujoco-menagerie is not installed.

    Usage: `[load_robot(PREFIX + name) for name in menagerie_humanoids()]`
    """
    import mujoco_menagerie

    return [robot.name for kind in ("humanoid", "biped") for robot in mujoco_menagerie.robots(kind)]
