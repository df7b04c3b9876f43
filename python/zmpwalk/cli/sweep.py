"""`zmpwalk sweep` walks over a grid of values that a TOML file names, and writes table and chart."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from typing import Any

import click
import numpy as np

from ..errors import InputError
from ..files import as_input_error, whole
from ..settings import read_toml
from ..sweeps import sweep
from .options import PathName, format_option
from .terminal import INTERRUPTED, STOOD, Share, new_console

__all__ = ["command"]


@click.command("sweep", short_help="Walk over a grid of values: a table and a chart.")
@click.argument("file", type=PathName())
@click.option("--out", type=PathName(), help="Folder to write into.  [default: out/FILE's name]")
@click.option("--processes", type=int, help="Walks at a time.  [default: all processors]")
@click.option("--cluster", metavar="ADDRESS", help="Dask scheduler whose workers walk, such as tcp://host:8786.")
@click.option("--y", multiple=True, metavar="COLUMN", help="What the chart shows; may be repeated.")
@click.option("--no-figures", is_flag=True, help="Write the table only.")
@format_option
def command(
    file: Path,
    out: Path | None,
    processes: int | None,
    cluster: str | None,
    y: tuple[str, ...],
    no_figures: bool,
    kind: str,
) -> int:
    """Walk over a grid of values that a TOML FILE names; stopped and called again, it goes on.

    \b
    duration = 10.0               # of every walk: arguments of zmpwalk.simulate,
    tracker_gain = 3.0            # and settings
    [grid]                        # every combination is walked
    profile = [0.1, 0.2, 0.3]
    step_height = { from = 0.02, to = 0.06, count = 5 }
    """
    common = read_toml(file)
    grid = common.pop("grid", None)
    if not isinstance(grid, dict) or not grid:
        raise InputError(f"{file}: it has no table [grid] that names what is tried, such as profile = [0.1, 0.2]")
    grid = {name: _values(file, name, given) for name, given in grid.items()}
    out = out or Path("out") / file.stem
    table = out / ("sweep.parquet" if importlib.util.find_spec("pyarrow") else "sweep.csv")
    with as_input_error(out):
        out.mkdir(parents=True, exist_ok=True)
    share = Share("walking")
    try:
        with share:
            found = sweep(grid, table, processes, cluster, on_progress=share.at, **common)
    except KeyboardInterrupt:
        print(f"zmpwalk: stopped; the same command goes on, {out} keeps what was walked", file=sys.stderr)
        return INTERRUPTED
    except ImportError as error:
        raise InputError(str(error)) from None
    files = [table]
    if not no_figures:
        files.append(out / f"sweep.{kind}")
        figure = found.plot(y) if y else found.plot()
        with as_input_error(files[1]), whole(files[1]) as draft:
            figure.savefig(draft)
    console = new_console()
    console.print(repr(found), soft_wrap=True)
    for row in found.failures:
        point = ", ".join(f"{name} {row[name]}" for name in found.axes)
        console.print(f"could not begin: {point}: {row['error']}", soft_wrap=True)
    console.print("written: " + ", ".join(map(str, files)), soft_wrap=True)
    return STOOD


def _values(file: Path, name: str, given: Any) -> list[Any]:
    if isinstance(given, dict):
        if set(given) != {"from", "to", "count"}:
            raise InputError(f"{file}: [grid] {name}: it is a list, or {{ from = 0.1, to = 0.3, count = 5 }}")
        return np.linspace(given["from"], given["to"], int(given["count"])).tolist()
    if not isinstance(given, list):
        raise InputError(f"{file}: [grid] {name} is {given!r}; it is a list of values")
    return given
