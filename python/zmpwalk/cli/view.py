"""`zmpwalk view` opens a window on a robot that keyboard and mouse walk and push."""

from __future__ import annotations

from typing import Any

import click

from .. import view
from .options import robot_option, settings_options, size_of, terrain_option
from .terminal import STOOD

__all__ = ["command"]


@click.command("view", short_help="Walk and push a robot in a window, by keyboard and mouse.")
@robot_option
@settings_options
@terrain_option
@click.option("--speed", type=float, default=1.0, show_default=True, help="Simulated seconds in a second of real time.")
@click.option("--size", default="1280x800", show_default=True, help="Width x height of the window [pixels].")
@click.option("--record", default="walk.npz", show_default=True, help="File that the key T records a walk into.")
@click.option("--no-shadows", is_flag=True, help="Draw no shadows and reflections: faster without a graphics card.")
def command(
    robot: str, settings: Any, terrain: str | None, speed: float, size: str, record: str, no_shadows: bool
) -> int:
    """Open a window on a robot that keyboard and mouse walk and push.

    W S A D and the arrows change the velocity, space stops the robot, shift and an arrow push it, P pauses, - and =
    change the pace, T records, R restarts, H shows all keys, Esc quits.
    """
    width, height = size_of(size)
    walk = view.view(robot, settings, speed, width, height, shadows=not no_shadows, record=record, terrain=terrain)
    for path in walk.recorded:
        click.echo(path)
    return STOOD
