"""`zmpwalk plot` draws the figures of a walk from its trace alone."""

from __future__ import annotations

from pathlib import Path

import click

from ..figures import FILES
from ..files import together
from ..trace import Trace
from .terminal import STOOD

__all__ = ["command"]


@click.command("plot")
@click.argument("trace", type=click.Path(path_type=Path))
@click.option("--out", type=click.Path(path_type=Path), help="Folder for the figures.  [default: that of the trace]")
@click.option(
    "--figure",
    "figures",
    multiple=True,
    metavar="NAME",
    help=f"Draw only this figure; may be given several times: {', '.join(FILES)}.  [default: all]",
)
@click.option(
    "--format", "kind", type=click.Choice(["png", "pdf", "svg"]), default="png", show_default=True, help="File format."
)
def command(trace: Path, out: Path | None, figures: tuple[str, ...], kind: str) -> int:
    """Draw the figures of a walk from its TRACE file alone."""
    from .. import plot  # matplotlib is slow to import

    names = [name for name in figures if name != "all"]
    for name in names:
        plot.figure_function(name)
    walked = Trace.load(trace)
    with together(out or trace.parent) as (draft, deliver):
        files = plot.save_all(walked, draft, names or None, kind)
        deliver(files)
    for file in files:
        click.echo(str((out or trace.parent) / file.name))
    return STOOD
