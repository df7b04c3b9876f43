"""`zmpwalk bench`: how fast the controller is on this machine."""

from __future__ import annotations

import contextlib
import json
from pathlib import Path

import click

from .. import bench
from ..errors import InputError
from ..files import as_input_error, whole
from .options import PathName
from .terminal import STOOD, Parts, new_console

__all__ = ["command"]


@click.command("bench", short_help="Measure how fast the controller is on this machine.")
@click.option(
    "--robot", default="mahru", show_default=True, help="A robot's name, a path to a robot.json, or an MJCF file."
)
@click.option(
    "--duration", type=float, default=120.0, show_default=True, help="Length of the walk whose cycles are timed [s]."
)
@click.option(
    "--part", "parts", multiple=True, help="Measure only this part; may be given several times.  [default: all]"
)
@click.option("--json", "file", type=PathName(), metavar="FILE", help="Write every number as JSON into FILE.")
def command(robot: str, duration: float, parts: tuple[str, ...], file: Path | None) -> int:
    """Measure how fast the controller is on this machine."""
    from rich.table import Table

    if file is not None and not file.absolute().parent.is_dir():
        raise InputError(f"'{file.absolute().parent}' is not a folder, {file.name} cannot be written there")
    with contextlib.ExitStack() as stack:
        if file is not None:  # before measuring, it is known that it can be written
            stack.enter_context(as_input_error(file))
            draft = stack.enter_context(whole(file))
            draft.write_text("\n", encoding="utf-8")
        with Parts() as parts_done:
            result = bench.bench(robot, duration, parts or None, parts_done.at)
        if file is not None:
            draft.write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
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
        console.print(f"written: {file}", soft_wrap=True)
    return STOOD
