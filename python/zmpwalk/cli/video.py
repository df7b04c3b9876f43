"""`zmpwalk video` makes a film of a walk."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from .. import render
from ..errors import InputError
from ..files import as_input_error
from ..simulation import simulate
from ..trace import Trace
from .options import PathName, known_option, push_option, size_of, terrain_option, walk_options
from .terminal import STOOD, Progress

__all__ = ["command"]


@click.command("video", short_help="Make a film of a recorded walk, or of a new one.")
@click.argument("trace", type=PathName(), required=False)
@walk_options
@push_option
@terrain_option
@known_option
@click.option(
    "--out",
    type=PathName(),
    default="walk.mp4",
    show_default=True,
    help="File to write, a .mp4 or .gif.",
)
@click.option(
    "--speed",
    type=float,
    default=1.0,
    show_default=True,
    help="Seconds of the walk in a second of the film; 0.5 is slow motion.",
)
@click.option("--fps", type=int, default=25, show_default=True, help="Pictures per second of the film.")
@click.option("--size", default="640x480", show_default=True, help="Width x height of the film [pixels].")
@click.option("--azimuth", type=float, help="Direction in which the camera looks: 0 is along x, 90 along y [deg].")
@click.option("--shadows", is_flag=True, help="Draw shadows and reflections, which takes twice as long.")
def command(
    trace: Path | None,
    robot: str,
    profile: str,
    duration: float,
    settings: Any,
    push: tuple[str, ...],
    terrain: str | None,
    known: bool,
    out: Path,
    speed: float,
    fps: int,
    size: str,
    azimuth: float | None,
    shadows: bool,
) -> int:
    """Make a film of the walk in a TRACE file, or of a new walk by the options of `zmpwalk walk`.

    An arrow shows a push while it acts and a moment longer. A recovery in slow motion:

    \b
    zmpwalk video --profile 0.25 --push 4.0:0.08::0,400,0 --speed 0.5 --out push.mp4
    """
    if out.suffix.lower() not in (".mp4", ".gif"):
        raise InputError(f"--out {out}: give a .mp4 or .gif")
    if not out.absolute().parent.is_dir():
        raise InputError(f"'{out.absolute().parent}' is not a folder, {out.name} cannot be written there")
    width, height = size_of(size)
    camera = None if azimuth is None else {"azimuth": azimuth}
    if trace is not None:
        given = _given(
            "robot", "profile", "duration", "law", "file", "footsteps", "changes", "push", "terrain", "known"
        )
        if given:
            raise InputError(f"{given[0]} is for a new walk; {trace} is one already")
        walked = Trace.load(trace)
    else:
        with Progress(duration) as progress:
            walked = simulate(
                robot,
                profile,
                duration,
                settings,
                progress.at,
                push=push,
                on_fall="go_on",
                terrain=terrain,
                known=known,
            )
    with Progress(walked.duration, "film") as progress:
        try:
            with as_input_error(out):
                render.video(walked, out, fps, width, height, speed, camera, shadows=shadows, on_progress=progress.at)
        except ImportError as error:
            raise InputError(str(error)) from None
    click.echo(str(out))
    return STOOD


def _given(*names: str) -> list[str]:
    """Options among `names` that stand on the command line."""
    context = click.get_current_context()
    return [
        parameter.opts[0]
        for parameter in context.command.params
        if parameter.name in names
        and context.get_parameter_source(parameter.name) is click.core.ParameterSource.COMMANDLINE
    ]
