"""`zmpwalk settings` prints every setting of a walk as TOML."""

from __future__ import annotations

from typing import Any

import click

from ..robots import load_robot
from ..settings import settings_toml
from ..simulation import WalkingController
from .options import settings_options
from .terminal import STOOD

__all__ = ["command"]


@click.command("settings", short_help="Print every setting with its value, unit and meaning.")
@click.argument("robot")
@settings_options
def command(robot: str, settings: Any) -> int:
    """Print every setting of a walk of ROBOT as TOML, each with its value, unit and meaning.

    Defaults stand behind a #. Change the file and give it to `zmpwalk walk --settings FILE`.
    """
    controller = WalkingController(*load_robot(robot), settings, profile=0.0)
    click.echo(settings_toml(controller, settings), nl=False)
    return STOOD
