"""`zmpwalk bench`: how fast the controller is on this machine."""

from __future__ import annotations

import json
from pathlib import Path

import click

from .. import bench
from ..errors import InputError
from .terminal import STOOD, Parts, new_console

__all__ = ["command"]


@click.command("bench")
@click.option(
    "--robot", default="mahru", show_default=True, help="A robot's name, a path to a robot.json, or an MJCF file."
)
@click.option(
    "--duration", type=float, default=120.0, show_default=True, help="Length of the walk whose cycles are timed [s]."
)
@click.option(
    "--part", "parts", multiple=True, help="Measure only this part; may be given several times.  [default: all]"
)
@click.option(
    "--json", "file", type=click.Path(path_type=Path), metavar="FILE", help="Write every number as JSON into FILE."
)
def command(robot: str, duration: float, parts: tuple[str, ...], file: Path | None) -> int:
    """Measure how fast the controller is on this machine."""
    from rich.table import Table

    if file is not None and not file.absolute().parent.is_dir():
        raise InputError(f"'{file.absolute().parent}' is not a folder, {file.name} cannot be written there")
    with Parts() as parts_done:
        result = bench.bench(robot, duration, parts or None, parts_done.at)
    console, info = new_console(), result["machine"]
    console.print(
        f"{info['cpu']}, {info['cores']} cores; MuJoCo {info['mujoco']}; kernel {result['build']['kernel']}\n"
    )
    for title, headings, rows in bench.tables(result):
        table = Table(title=title, title_justify="left", box=None, pad_edge=False, show_header=any(headings))
        for i, heading in enumerate(headings):
            table.add_column(heading, justify="right" if i else "left")
        for row in rows:
            table.add_row(*row)
        console.print(table, "", sep="\n")
    if file is not None:
        file.write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
        console.print(f"written: {file}", soft_wrap=True)
    return STOOD
