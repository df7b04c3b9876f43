"""`zmpwalk plot` draws the figures of a walk, or of several beside each other, from their traces alone."""

from __future__ import annotations

from pathlib import Path

import click

from ..errors import InputError
from ..figures import FILES
from ..files import together
from ..trace import Trace
from . import completion
from .options import PathName, format_option
from .terminal import STOOD

__all__ = ["command"]


@click.command("plot", short_help="Draw the figures of a walk, or compare several walks.")
@click.argument("traces", type=PathName(), nargs=-1, required=True, metavar="TRACE...")
@click.option("--out", type=PathName(), help="Folder for the figures.  [default: that of the trace]")
@click.option(
    "--figure",
    "figures",
    multiple=True,
    metavar="NAME",
    shell_complete=completion.figures,
    help=f"Draw only this figure; may be given several times: {', '.join(FILES)}.  [default: all]",
)
@click.option("--compare", is_flag=True, help="Draw all TRACEs over one another in one figure, compare.png.")
@click.option(
    "--quantity",
    "quantities",
    multiple=True,
    metavar="NAME",
    help="With --compare, a panel for this: velocity, sideways, zmp, estimate, torque, or any column of a trace, such "
    "as com_z.  [default: velocity, sideways, estimate, torque]",
)
@click.option(
    "--interactive",
    is_flag=True,
    help="Write a page to zoom into, interactive.html, which needs no network to be read.",
)
@click.option("--rerun", is_flag=True, help="Write a recording for the viewer Rerun, TRACE.rrd (extra rerun).")
@click.option(
    "--table",
    type=click.Choice(["csv", "parquet", "nc"]),
    help="Write every column as a table, TRACE.csv or TRACE.parquet, or as the data set TRACE.nc (NetCDF, HDF5).",
)
@format_option
def command(
    traces: tuple[Path, ...],
    out: Path | None,
    figures: tuple[str, ...],
    compare: bool,
    quantities: tuple[str, ...],
    interactive: bool,
    rerun: bool,
    table: str | None,
    kind: str,
) -> int:
    """Draw the figures of a walk from its TRACE file alone, or compare several walks.

    \b
    zmpwalk plot out/first/trace.npz --figure estimate
    zmpwalk plot --compare out/slow/trace.npz out/fast/trace.npz
    zmpwalk plot --interactive out/first/trace.npz
    zmpwalk plot --table parquet out/first/trace.npz
    """
    from .. import plot  # matplotlib is slow to import

    if quantities and not compare:
        raise InputError("--quantity goes with --compare")
    if figures and compare:
        raise InputError("--figure does not go with --compare, whose panels are named by --quantity")
    if figures and interactive:
        raise InputError("--figure does not go with --interactive, which draws a page of its own")
    if sum((compare or interactive, rerun, table is not None)) > 1:
        raise InputError(
            "--rerun and --table write a file of their own: give one of them, without --compare and --interactive"
        )
    if figures and (rerun or table):
        raise InputError("--figure draws; --rerun and --table do not")
    if len(traces) > 1 and not compare:
        raise InputError(f"{len(traces)} traces: add --compare for one figure of them all, or draw one at a time")
    names = [name for name in figures if name != "all"]
    for name in names:
        plot.figure_function(name)
    walked = {name: Trace.load(path) for name, path in zip(_names(traces), traces)}
    folder = out or traces[0].parent
    with together(folder) as (draft, deliver):
        if rerun or table:
            files = [_written(next(iter(walked.values())), draft / f"{traces[0].stem}.{table or 'rrd'}")]
        elif interactive:
            files = [draft / "interactive.html"]
            shown = walked if compare else next(iter(walked.values()))
            plot.interactive(shown, quantities or plot.COMPARED).write_html(files[0])
        elif compare:
            figure = plot.compare(walked, quantities or plot.COMPARED)
            files = [draft / f"compare.{kind}"]
            figure.savefig(files[0])
        else:
            files = plot.save_all(next(iter(walked.values())), draft, names or None, kind)
        deliver(files)
    for file in files:
        click.echo(str(folder / file.name))
    return STOOD


def _written(trace: Trace, path: Path) -> Path:
    """The trace in the file of another tool, which its suffix names."""
    if path.suffix == ".nc":
        trace.to_xarray().to_netcdf(path, engine="h5netcdf")
    else:
        {".rrd": trace.to_rerun, ".csv": trace.to_csv, ".parquet": trace.to_parquet}[path.suffix](path)
    return path


def _names(paths: tuple[Path, ...]) -> list[str]:
    """What the walks are called: the files' names, with as much of their folders as tells them apart."""
    parts = [path.absolute().with_suffix("").parts for path in paths]
    for depth in range(1, max(map(len, parts)) + 1):
        names = ["/".join(each[-depth:]) for each in parts]
        if len(set(names)) == len(names):
            break
    else:
        raise InputError(f"{paths[0]} is given twice")
    if depth > 1 and len({each[-1] for each in parts}) == 1:
        names = [name.rpartition("/")[0] for name in names]  # all are trace.npz: the folder is the name
    return names
