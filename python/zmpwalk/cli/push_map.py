"""`zmpwalk push-map`: how hard a push fells a robot, from every side at every phase."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import click

from ..files import as_input_error, together
from ..profiles import profile_of
from ..pushes import STANCES, push_map
from .options import PathName, format_option, robot_option, settings_options
from .terminal import INTERRUPTED, STOOD, Share, new_console

__all__ = ["command"]


@click.command("push-map", short_help="Say how hard a push fells a robot, from every side.")
@robot_option
@click.option("--velocity", default="0.25", show_default=True, help='vx or "vx/vy/wz" [m/s, rad/s]; 0 stands.')
@click.option("--directions", type=int, default=12, show_default=True, help="How many, evenly spaced from forward.")
@click.option("--phases", type=int, default=8, show_default=True, help="How many, from a lift-off to the next.")
@click.option("--stance", "stances", multiple=True, type=click.Choice(STANCES), help="Only this.  [default: both]")
@click.option("--body", help="Which is pushed.  [default: the trunk]")
@click.option("--limit", type=float, default=2.0, show_default=True, help="Largest impulse tried [N s/kg].")
@click.option("--processes", type=int, help="Trials at a time.  [default: all processors]")
@settings_options
@click.option("--out", type=PathName(), help="Folder to write into.  [default: out/pushes-ROBOT]")
@click.option("--json", "as_json", is_flag=True, help="Print the map as JSON, and nothing else, on stdout.")
@click.option("--no-figures", is_flag=True, help="Write the tables only.")
@format_option
def command(
    robot: str,
    velocity: str,
    directions: int,
    phases: int,
    stances: tuple[str, ...],
    body: str | None,
    limit: float,
    processes: int | None,
    settings: Any,
    out: Path | None,
    as_json: bool,
    no_figures: bool,
    kind: str,
) -> int:
    """Push a walking or standing robot from every side until it falls, then write map, table and figure.

    A force of 0.08 s acts on the trunk at each phase of the step; impulses grow by 0.05 N s/kg to the first that fells,
    then by 0.01 between. Direction 0 pushes forward, 90 degrees to the side of the stance foot. The pendulum's limit
    stands beside.
    """
    v = profile_of(velocity).v[0]
    name = robot if robot.isidentifier() else Path(robot).stem
    out = out or Path("out") / f"pushes-{name}"
    with together(out) as (draft, deliver):
        share = Share("pushing")
        try:
            with share:
                found = push_map(
                    robot, v, directions, phases, stances or STANCES, settings, body, limit=limit, processes=processes,
                    on_progress=share.at,
                )  # fmt: skip
        except KeyboardInterrupt:
            print("zmpwalk: stopped; nothing was written", file=sys.stderr)
            return INTERRUPTED
        with as_input_error(out):
            files = [found.to_csv(draft / "pushes.csv"), draft / "pushes.json"]
            files[1].write_text(json.dumps(found.to_dict(), indent=1, allow_nan=False) + "\n", encoding="utf-8")
            if not no_figures:
                files.append(draft / f"pushes.{kind}")
                found.plot().savefig(files[-1])
        deliver(files)
    if as_json:
        click.echo(json.dumps(found.to_dict(), indent=1, allow_nan=False))
    else:
        console = new_console()
        console.print("Smallest impulse that fells [N s/kg]; nan: nothing up to the limit does.", soft_wrap=True)
        console.print(str(found), soft_wrap=True)
        console.print(
            f"\n{found.trials} trials in {found.wall_time:.0f} s; {len(files)} files in {out}", soft_wrap=True
        )
    return STOOD
