"""`zmpwalk robustness`: what a walk bears of each kind of trouble."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import click

from ..files import as_input_error, together
from ..troubles import robustness
from .options import PathName, format_option, robot_option, settings_options
from .terminal import INTERRUPTED, STOOD, Share, new_console

__all__ = ["command"]


@click.command("robustness", short_help="Say what a walk bears: pushes, noise, delay, wrong masses.")
@robot_option
@click.option("--velocity", type=float, default=0.25, show_default=True, help="Forward [m/s].")
@click.option("--duration", type=float, default=20.0, show_default=True, help="Of each walk [s].")
@click.option("--only", multiple=True, metavar="NAME", help="A trouble, or how its name begins; may be repeated.")
@click.option("--threads", type=int, help="Walks at a time.  [default: all processors]")
@settings_options
@click.option("--out", type=PathName(), help="Folder to write into.  [default: out/robustness-ROBOT]")
@click.option("--no-figures", is_flag=True, help="Write the table only.")
@format_option
def command(
    robot: str,
    velocity: float,
    duration: float,
    only: tuple[str, ...],
    threads: int | None,
    settings: Any,
    out: Path | None,
    no_figures: bool,
    kind: str,
) -> int:
    """Try everything that a walk may have to bear, from mild to hard: one table and one figure.

    Pushes, steady forces, sensor noise and bias, delays, wrong masses, friction. Each kind has a bar, the level that a
    walk should bear.
    """
    name = robot if robot.isidentifier() else Path(robot).stem
    out = out or Path("out") / f"robustness-{name}"
    with together(out) as (draft, deliver):
        share = Share("walking")
        try:
            with share:
                found = robustness(robot, velocity, settings, duration, only, threads, share.at)
        except KeyboardInterrupt:
            print("zmpwalk: stopped; nothing was written", file=sys.stderr)
            return INTERRUPTED
        with as_input_error(out):
            files = [found.to_csv(draft / "robustness.csv")]
            if not no_figures:
                files.append(draft / f"robustness.{kind}")
                found.plot().savefig(files[-1])
        deliver(files)
    console = new_console()
    console.print(str(found), soft_wrap=True)
    console.print(f"\n{len(files)} files in {out}", soft_wrap=True)
    return STOOD
