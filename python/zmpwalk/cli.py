"""The command `zmpwalk`: walk, view, plot, video, inspect, settings, bench.

Exit codes: 0 the robot stood to the end, 3 it fell (everything is written all the same), 2 bad input (one line on
stderr, nothing written), 130 stopped by Ctrl-C (nothing written), 1 a fault of zmpwalk's own.
"""

from __future__ import annotations

import functools
import json
import math
import os
import shutil
import sys
import tempfile
import time
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Iterator

import click

from .errors import Error, InputError, ModelError

if TYPE_CHECKING:
    from .trace import Trace

__all__ = ["cli", "main"]

STOOD, FAULT, BAD_INPUT, FELL, INTERRUPTED = 0, 1, 2, 3, 130
FIGURE_FILES = tuple(
    f"{name}.png"
    for name in ("fig2_iteration", "fig4_tracking", "fig5_switch", "fig6_velocity", "fig7_sagittal", "fig8_lateral")
) + ("footprints.png",)
FOOTSTEPS = ("tied", "absolute", "paper", "printed")
MISMATCH = 0.002  # of footsteps and planned velocity worth a warning [m/s]; 0.004 fells the literal law within 30 s


def main(arguments: list[str] | None = None) -> int:
    """Run the command line.

    Args:
        arguments: words after the command's name; None takes the process's own.

    Returns:
        The exit code; every error has been printed.

    Usage: `zmpwalk.cli.main(["walk", "--duration", "4"])`
    """
    try:
        words = sys.argv[1:] if arguments is None else list(arguments)
        return int(cli.main(args=words or ["--help"], prog_name="zmpwalk", standalone_mode=False) or 0)
    except click.exceptions.Exit as done:
        return done.exit_code
    except (click.Abort, KeyboardInterrupt):
        print("zmpwalk: stopped; nothing was written", file=sys.stderr)
        return INTERRUPTED
    except click.ClickException as error:
        return _complain(error.format_message())
    except Error as error:
        return _complain(str(error))
    except BrokenPipeError:  # the reader of our output went away
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return STOOD
    except Exception:
        import traceback

        traceback.print_exc()
        print("zmpwalk: this is a fault of zmpwalk, please report it with the lines above", file=sys.stderr)
        return FAULT


def _complain(message: str) -> int:
    print(f"zmpwalk: {' '.join(message.split())}", file=sys.stderr)
    return BAD_INPUT


def _print_version(context: click.Context, parameter: click.Parameter, asked: bool) -> None:
    if asked and not context.resilient_parsing:
        import mujoco

        from . import __version__

        click.echo(f"zmpwalk {__version__}, MuJoCo {mujoco.__version__}")
        context.exit()


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
@click.option(
    "--version",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_print_version,
    help="Show versions and exit.",
)
def cli() -> None:
    """Walk humanoids in MuJoCo by whole-body control and estimated ZMP."""


def _settings_options(command: Callable) -> Callable:
    """Options that make `WalkSettings`, which the command gets as `settings`."""

    @click.option(
        "--law",
        type=click.Choice(["default", "paper"]),
        help="The control law's preset.  [default: that of the settings file, else default]",
    )
    @click.option("--settings", "file", type=click.Path(path_type=Path), help="A TOML file of settings.")
    @click.option(
        "--footsteps",
        help='tied, absolute, paper, printed, or lengths "0.1,0.15,0.2" [m]; the law\'s own if not given.',
    )
    @click.option(
        "--set",
        "changes",
        multiple=True,
        metavar="NAME=VALUE",
        help="Change one setting of WalkSettings, such as tracking.gain=3; may be repeated.",
    )
    @functools.wraps(command)
    def with_settings(
        law: str | None, file: Path | None, footsteps: str | None, changes: tuple[str, ...], **options: Any
    ) -> int:
        return command(settings=_settings(law, file, footsteps, changes), **options)

    return with_settings


_robot_option = click.option(
    "--robot",
    default="mahru",
    show_default=True,
    help="A robot's name, menagerie:NAME, or a path to a robot.json or an .xml.",
)


def _walk_options(command: Callable) -> Callable:
    """What walks, along which velocities, for how long."""
    profile = click.option(
        "--profile",
        default="paper",
        show_default=True,
        help='Planned velocity: paper, a CSV file (FILE:linear joins its rows), "0.2" or "0:0.1,5:0.2/0/0.3".',
    )
    duration = click.option("--duration", type=float, default=8.0, show_default=True, help="Simulated time [s].")
    return _robot_option(profile(duration(_settings_options(command))))


# --- walk


@cli.command()
@_walk_options
@click.option("--motion", type=click.Path(path_type=Path), help="CSV of arm, waist, trunk angles: t,JOINT,...")
@click.option("--out", type=click.Path(path_type=Path), help="Folder to write into.  [default: out/ROBOT-LAW]")
@click.option("--json", "as_json", is_flag=True, help="Print the summary as JSON, and nothing else, on stdout.")
@click.option("--no-figures", is_flag=True, help="Write trace and summary only.")
def walk(
    robot: str,
    profile: str,
    motion: Path | None,
    duration: float,
    settings: Any,
    out: Path | None,
    as_json: bool,
    no_figures: bool,
) -> int:
    """Walk a robot in MuJoCo, then write trace, summary and figures."""
    from .motion import JointMotion
    from .profiles import VelocityProfile
    from .proposal import examine
    from .simulation import WalkingController, check_duration, run

    # Everything that can be wrong is found out before anything is written.
    velocity = VelocityProfile.from_spec(profile)
    duration = check_duration(duration)
    model, found = examine(robot)
    name = robot if robot.isidentifier() else found.description.name
    controller = WalkingController(model, found.description, settings, velocity)
    controller.move(None if motion is None else JointMotion.from_csv(motion))
    mismatch = getattr(controller, "plan_mismatch", lambda duration: 0.0)(duration)
    out = out or Path("out") / f"{name}-{settings.law}"
    with _folder(out) as (draft, deliver):
        for remark in found.remarks:
            print(f"zmpwalk: note: {remark}", file=sys.stderr)
        if abs(mismatch) > MISMATCH:
            kind = "faster" if mismatch > 0 else "slower"
            print(
                f"zmpwalk: warning: the footsteps go {abs(mismatch):.4f} m/s {kind} than the planned velocity",
                file=sys.stderr,
            )
        progress = _Progress(duration)
        try:
            with progress:
                trace = run(controller, duration, progress.at, robot=name)
            files = _write(trace, draft, no_figures)
        except KeyboardInterrupt:
            print(f"zmpwalk: stopped at t = {progress.t:.2f} s of {duration:g} s; nothing was written", file=sys.stderr)
            return INTERRUPTED
        except OSError as error:
            raise InputError(f"{out}: cannot write there: {(error.strerror or str(error)).lower()}") from None
        deliver(files)
        _remove_stale_figures(out, files)

    summary = trace.summary()
    if as_json:
        click.echo(json.dumps(summary, indent=2, allow_nan=False))
    else:
        _print_summary(summary, out, len(files))
    if summary["fell"]:
        print(
            f"zmpwalk: fell at t = {summary['fall_time']:.3f} s: {summary['fall_cause'] or 'cause unknown'}",
            file=sys.stderr,
        )
        return FELL
    return STOOD


def _settings(law: str | None, file: Path | None, footsteps: str | None, changes: tuple[str, ...]) -> Any:
    """WalkSettings from a file, the preset's name, --footsteps and the --set words; the later ones win.

    Raises:
        InputError: an unknown setting, or a value it cannot have.
    """
    from . import WalkSettings
    from .settings import load_settings

    values: dict[str, Any] = {}
    if footsteps is not None:
        values["footsteps"] = footsteps if footsteps in FOOTSTEPS else _lengths(footsteps)
    for change in changes:
        name, equals, text = change.partition("=")
        name = name.strip()
        if not equals:
            raise InputError(f"--set {change}: write it as NAME=VALUE")
        try:
            like = "" if name == "law" else WalkSettings.find(name).default
        except InputError as error:
            raise InputError(f"--set {change}: {error}") from None
        values[name] = _parse(text.strip(), like, change)
    law = values.pop("law", law)
    return load_settings(file, law, **values) if file else WalkSettings(law=law or "default", **values)


def _lengths(text: str) -> list[float]:
    try:
        lengths = [float(word) for word in text.split(",")]
    except ValueError:
        lengths = []
    if not lengths or not all(map(math.isfinite, lengths)):
        raise InputError(f'--footsteps "{text}": it is {", ".join(FOOTSTEPS)}, or lengths "0.1,0.15,0.2" [m]')
    return lengths


def _parse(text: str, like: Any, change: str) -> Any:
    """A value of the kind of `like`."""
    words = {"true": True, "on": True, "yes": True, "false": False, "off": False, "no": False}
    try:
        if isinstance(like, bool):
            return words[text.lower()] if text.lower() in words else bool(("0", "1").index(text))
        if isinstance(like, int):
            return int(text)
        if isinstance(like, float):
            return float(text)
        if isinstance(like, (list, tuple)):
            return [float(word) for word in text.split(",") if word.strip()]
        if isinstance(like, dict):
            return {key.strip(): float(word) for key, word in (pair.split(":") for pair in text.split(","))}
    except ValueError:
        kinds = {bool: "true or false", int: "an integer", dict: 'written as "l_knee:100,r_knee:100"'}
        kind = kinds.get(type(like), "a number")
        raise InputError(f"--set {change}: '{text}' is not {kind}") from None
    return text


@contextmanager
def _folder(out: Path) -> Iterator[tuple[Path, Callable[[list[Path]], None]]]:
    """A hidden folder in `out` to write into, and how to move its files out of it once they are all there.

    Leaves `out` as it was, or absent, if they never are.

    Raises:
        InputError: `out` cannot be made or written.
    """
    made = [folder for folder in (out, *out.parents) if not folder.exists()]
    try:
        out.mkdir(parents=True, exist_ok=True)
        draft = Path(tempfile.mkdtemp(prefix=".walk-", dir=out))
    except OSError as error:
        _remove_empty(made)
        raise InputError(f"{out}: cannot write there: {(error.strerror or str(error)).lower()}") from None

    def deliver(files: list[Path]) -> None:
        for file in files:
            os.replace(file, out / file.name)

    try:
        yield draft, deliver
    finally:
        shutil.rmtree(draft, ignore_errors=True)
        _remove_empty(made)


def _remove_empty(folders: list[Path]) -> None:
    for folder in folders:
        try:
            folder.rmdir()
        except OSError:
            return


def _write(trace: Trace, folder: Path, no_figures: bool) -> list[Path]:
    files = [trace.save(folder / "trace.npz"), folder / "summary.json"]
    files[1].write_text(json.dumps(trace.summary(), indent=2, allow_nan=False) + "\n", encoding="utf-8")
    if not no_figures:
        from . import plot

        files += plot.save_all(trace, folder)
    return files


def _remove_stale_figures(out: Path, files: list[Path]) -> None:
    """Figures of an earlier walk would tell lies beside the trace of this one."""
    new = {file.name for file in files}
    for old in FIGURE_FILES:
        if old not in new and (out / old).exists():
            (out / old).unlink()


class _Progress:
    """How far the walk is: a bar on a terminal, otherwise a line now and then; always on stderr."""

    EVERY = 5.0  # lines apart in a file or pipe [s of wall time]

    def __init__(self, duration: float, verb: str = "walk"):
        self.t, self._duration, self._bar, self._next = 0.0, duration, None, 0.0  # type: float, float, Any, float
        self._verb = verb

    def __enter__(self) -> _Progress:
        if sys.stderr.isatty():
            from rich.console import Console
            from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

            self._bar = Progress(
                TextColumn(f"{self._verb}ing"),
                BarColumn(),
                TextColumn("{task.completed:5.1f} of {task.total:g} s"),
                TimeRemainingColumn(),
                console=Console(stderr=True),
            )
            self._bar.start()
            self._task = self._bar.add_task(self._verb, total=self._duration)
        else:
            print(f"{self._verb}ing for {self._duration:g} s", file=sys.stderr, flush=True)
            self._next = time.monotonic() + self.EVERY
        return self

    def at(self, t: float, duration: float) -> None:
        self.t = t
        if self._bar is not None:
            self._bar.update(self._task, completed=t)
        elif time.monotonic() >= self._next:
            print(f"{self._verb}ed {t:.1f} of {duration:g} s", file=sys.stderr, flush=True)
            self._next = time.monotonic() + self.EVERY

    def __exit__(self, kind: Any, *rest: Any) -> None:
        if self._bar is not None:
            if kind is None:
                self._bar.update(self._task, completed=self._duration)
            self._bar.stop()


class _Parts:
    """Which part is being measured: a bar on a terminal, otherwise a line each; always on stderr."""

    def __init__(self) -> None:
        self._bar: Any = None
        self._tasks: dict[str, Any] = {}

    def __enter__(self) -> _Parts:
        if sys.stderr.isatty():
            from rich.console import Console
            from rich.progress import Progress

            self._bar = Progress(console=Console(stderr=True))
            self._bar.start()
        return self

    def at(self, part: str, share: float) -> None:
        new = part not in self._tasks
        if self._bar is not None:
            if new:
                self._tasks[part] = self._bar.add_task(part, total=1.0)
            self._bar.update(self._tasks[part], completed=share)
        elif new:
            self._tasks[part] = None
            print(f"measuring {part}", file=sys.stderr, flush=True)

    def __exit__(self, *rest: Any) -> None:
        if self._bar is not None:
            self._bar.stop()


def _console() -> Any:
    from rich.console import Console

    width = None if sys.stdout.isatty() else 100
    return Console(width=width, highlight=False, markup=False)


def _print_summary(summary: dict[str, Any], out: Path, count: int) -> None:
    from rich.table import Table

    console, error = _console(), summary["zmp_error_mm"]
    steps = Table(title="mean speed per step [m/s]", title_justify="left", box=None, pad_edge=False)
    for heading in ("from [s]", "planned", "walked", "off by"):
        steps.add_column(heading, justify="right")
    speeds = list(zip(summary["planned_speed_per_step"], summary["mean_speed_per_step"]))
    period = summary["step_period"]
    shown = range(len(speeds)) if len(speeds) <= 12 else (*range(6), None, *range(len(speeds) - 3, len(speeds)))
    for k in shown:
        if k is None:
            steps.add_row("...", "", "", "")
            continue
        plan, speed = speeds[k]
        off = f"{100 * (speed / plan - 1):+.2f} %" if plan else f"{speed - plan:+.4f}"
        steps.add_row(f"{k * period:.1f}", f"{plan:.4f}", f"{speed:.4f}", off)

    facts = Table(box=None, show_header=False, pad_edge=False)
    facts.add_column()
    facts.add_column(justify="right")
    facts.add_column()
    end = f"fell at {summary['fall_time']:.3f} s" if summary["fell"] else "stood to the end"
    facts.add_row("walk", f"{summary['duration']:g} s", f"{summary['step_count']} steps, {end}")
    for label, key in (
        ("median", "median"),
        ("95th percentile", "p95"),
        ("same, single support", "single_support_p95"),
    ):
        facts.add_row("ZMP error, " + label, " / ".join(_number(e, 4) for e in error[key]), "mm, x / y")
    iterations, cycle = summary["iterations"], summary["cycle_us"]
    facts.add_row(
        "iterations",
        f"{_number(iterations['mean'], 1)} / {_number(iterations['max'], 0)}",
        "mean / max where the ZMP was modified",
    )
    facts.add_row("peak torque", _number(100 * (summary["peak_torque_ratio"] or math.nan), 0), "% of the limit")
    facts.add_row(
        "control cycle", f"{_number(cycle['median'], 0)} / {_number(cycle['p99'], 0)}", "µs, median / 99th percentile"
    )
    facts.add_row("real-time factor", _number(summary["real_time_factor"], 1), "× real time")
    console.print(steps, "", facts, sep="\n")
    console.print(f"\n{count} files in {out}", soft_wrap=True)


def _number(value: float | None, digits: int) -> str:
    if value is None or not math.isfinite(value):
        return "–"
    return f"{value:.{digits}f}" if abs(value) < 1e5 else f"{value:.1e}"


# --- bench


@cli.command()
@click.option("--robot", default="mahru", show_default=True, help="A name, a robot.json, or an MJCF file.")
@click.option(
    "--duration", type=float, default=120.0, show_default=True, help="Of the walk whose cycles are timed [s]."
)
@click.option("--part", "parts", multiple=True, help="Measure only this; may be given several times.  [default: all]")
@click.option("--json", "file", type=click.Path(path_type=Path), metavar="FILE", help="Write every figure as JSON.")
def bench(robot: str, duration: float, parts: tuple[str, ...], file: Path | None) -> int:
    """Measure how fast the controller is on this machine."""
    from rich.table import Table

    from . import bench as measure

    if file is not None and not file.absolute().parent.is_dir():
        raise InputError(f"'{file.absolute().parent}' is not a folder, {file.name} cannot be written there")
    with _Parts() as parts_done:
        result = measure.bench(robot, duration, parts or None, parts_done.at)
    console, info = _console(), result["machine"]
    console.print(
        f"{info['cpu']}, {info['cores']} cores; MuJoCo {info['mujoco']}; kernel {result['build']['kernel']}\n"
    )
    for title, headings, rows in measure.tables(result):
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


# --- settings


@cli.command()
@click.argument("robot")
@_settings_options
def settings(robot: str, settings: Any) -> int:
    """Print every setting of a walk of ROBOT as TOML: value, unit, meaning; defaults behind a #.

    Change the file and give it to `zmpwalk walk --settings FILE`.
    """
    from .description import load_robot
    from .profiles import VelocityProfile
    from .settings import settings_toml
    from .simulation import WalkingController

    controller = WalkingController(*load_robot(robot), settings, VelocityProfile.constant(0.0))
    click.echo(settings_toml(controller, settings), nl=False)
    return STOOD


# --- view


@cli.command()
@_robot_option
@_settings_options
@click.option("--speed", type=float, default=1.0, show_default=True, help="Simulated seconds in a second.")
@click.option("--size", default="1280x800", show_default=True, help="Width x height of the window.")
@click.option("--no-shadows", is_flag=True, help="Draw no shadows and reflections: faster without a graphics card.")
def view(robot: str, settings: Any, speed: float, size: str, no_shadows: bool) -> int:
    """Open a window on a robot that the keyboard walks: W S A D, arrows, space; R restarts, Esc quits."""
    from .view import view as show

    width, height = _size(size)
    show(robot, settings, speed, width, height, shadows=not no_shadows)
    return STOOD


# --- plot


@cli.command()
@click.argument("trace", type=click.Path(path_type=Path))
@click.option("--out", type=click.Path(path_type=Path), help="Folder to write into.  [default: beside the trace]")
@click.option(
    "--figure",
    "figures",
    multiple=True,
    metavar="NAME",
    help="iteration, tracking, switch, velocity, sagittal, lateral, footprints; all if not given.",
)
@click.option(
    "--format", "kind", type=click.Choice(["png", "pdf", "svg"]), default="png", show_default=True, help="File format."
)
def plot(trace: Path, out: Path | None, figures: tuple[str, ...], kind: str) -> int:
    """Draw the figures of a walk from its TRACE file alone."""
    from . import plot as plots
    from .trace import Trace

    names = [name for name in figures if name != "all"]
    for name in names:
        plots.figure_function(name)
    walked = Trace.load(trace)
    with _folder(out or trace.parent) as (draft, deliver):
        files = plots.save_all(walked, draft, names or None, kind)
        deliver(files)
    for file in files:
        click.echo(str((out or trace.parent) / file.name))
    return STOOD


# --- video


@cli.command()
@click.argument("trace", type=click.Path(path_type=Path), required=False)
@_walk_options
@click.option("--out", type=click.Path(path_type=Path), default="walk.mp4", show_default=True, help=".mp4 or .gif.")
@click.option("--speed", type=float, default=1.0, show_default=True, help="0.5 is slow motion.")
@click.option("--fps", type=int, default=25, show_default=True, help="Pictures per second of the film.")
@click.option("--size", default="640x480", show_default=True, help="Width x height [pixels].")
@click.option("--azimuth", type=float, help="Direction to look in: 0 along x, 90 along y [deg].")
@click.option("--shadows", is_flag=True, help="Draw shadows and reflections; takes twice as long.")
def video(
    trace: Path | None,
    robot: str,
    profile: str,
    duration: float,
    settings: Any,
    out: Path,
    speed: float,
    fps: int,
    size: str,
    azimuth: float | None,
    shadows: bool,
) -> int:
    """Film a walk: that of a TRACE file, or a new one by the options of `zmpwalk walk`."""
    from . import render
    from .profiles import VelocityProfile
    from .simulation import simulate
    from .trace import Trace

    if out.suffix.lower() not in (".mp4", ".gif"):
        raise InputError(f"--out {out}: give a .mp4 or .gif")
    if not out.absolute().parent.is_dir():
        raise InputError(f"'{out.absolute().parent}' is not a folder, {out.name} cannot be written there")
    width, height = _size(size)
    camera = None if azimuth is None else {"azimuth": azimuth}
    if trace is not None:
        given = _given("robot", "profile", "duration", "law", "file", "footsteps", "changes")
        if given:
            raise InputError(f"{given[0]} is for a new walk; {trace} is one already")
        walked = Trace.load(trace)
    else:
        with _Progress(duration) as progress:
            walked = simulate(robot, VelocityProfile.from_spec(profile), duration, settings, progress.at)
    with _Progress(walked.duration, "film") as progress:
        try:
            render.video(walked, out, fps, width, height, speed, camera, shadows=shadows, on_progress=progress.at)
        except ImportError as error:
            raise InputError(str(error)) from None
        except OSError as error:
            raise InputError(f"{out}: cannot write there: {(error.strerror or str(error)).lower()}") from None
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


def _size(text: str) -> tuple[int, int]:
    try:
        width, height = map(int, text.lower().split("x"))
    except ValueError:
        raise InputError(f"--size {text}: give width x height, such as 1280x720") from None
    return width, height


# --- inspect


@cli.command()
@click.argument("model")
@click.option("--json", "as_json", is_flag=True, help="Print what was found as JSON.")
@click.option("--write", type=click.Path(path_type=Path), metavar="FILE", help="Write it as a robot.json.")
@click.option(
    "--figure", type=click.Path(path_type=Path), metavar="FILE", help="Draw robot, soles and COM: .png, .pdf or .svg."
)
def inspect(model: str, as_json: bool, write: Path | None, figure: Path | None) -> int:
    """Show what is found in MODEL: a robot's name, menagerie:NAME, a robot.json, or any .xml with a robot on two legs.

    Where it cannot walk: why, a line for each reason.
    """
    from .description import robot_file
    from .proposal import examine, write_description

    if figure is not None and figure.suffix.lower() not in (".png", ".pdf", ".svg"):
        raise InputError(f"--figure {figure}: give a .png, .pdf or .svg")
    try:
        loaded, proposal = examine(model)
    except ModelError as error:
        for reason in error.reasons:
            _complain(reason)
        return BAD_INPUT
    if write is not None:
        write_description(write, robot_file(model), proposal)
    if figure is not None:
        _draw(figure, loaded, proposal)
    if as_json:
        click.echo(json.dumps(proposal.table, indent=2, allow_nan=False))
    else:
        _print_inspection(proposal.table)
        for written in filter(None, (write, figure)):
            click.echo(f"\nwritten: {written}")
    return STOOD


def _draw(path: Path, model: Any, proposal: Any) -> None:
    from .proposal.figure import draw

    figure = draw(model, proposal)
    try:
        figure.savefig(path)
    except OSError as error:
        raise InputError(f"{path}: cannot write there: {(error.strerror or str(error)).lower()}") from None


def _print_inspection(found: dict[str, Any]) -> None:
    from rich.table import Table

    console = _console()
    facts = Table(box=None, show_header=False, pad_edge=False)
    facts.add_column(no_wrap=True)
    facts.add_column()
    base, bounds = found["base"], found["zmp_bounds_m"]
    facts.add_row("robot", found["name"])
    facts.add_row("base", f"body {base['body']}, free joint {base['joint'] or 'without a name'}")
    facts.add_row("mass", f"{found['mass_kg']:.2f} kg")
    facts.add_row("COM height", f"{found['com_height_m']:.3f} m over the soles; T_c = {found['T_c_s']:.4f} s")
    for side in ("left", "right"):
        foot = found["feet"][side]
        site = f", site {foot['sole_site']}" if foot["sole_site"] else ""
        x, y, _ = (round(number, 3) + 0.0 for number in foot["sole_center_m"])  # + 0.0: no minus before a zero
        facts.add_row(f"{side} foot", f"body {foot['body']}{site}")
        size = f"{foot['length_m']:.3f} × {foot['width_m']:.3f} m"
        facts.add_row(f"{side} sole", f"{size}, stands at x {x:+.3f}, y {y:+.3f} m")
        if bounds:
            (x0, y0), (x1, y1) = bounds[side]
            facts.add_row("  ZMP within", f"x {x0:+.3f} .. {x1:+.3f}, y {y0:+.3f} .. {y1:+.3f} m of its centre")
    share = f"at the stand {100 * found['leg_share']:.0f} % of both"
    facts.add_row("legs", f"thigh {found['thigh_m']:.3f} m, shank {found['shank_m']:.3f} m, {share}")
    limit = found["speed_limit_mps"]
    facts.add_row("speed in reach", f"up to {limit:.3f} m/s" if limit is not None else "none: see below")
    facts.add_row(
        "stand pose", (found["stand_keyframe"] and f"keyframe {found['stand_keyframe']}") or "from the description"
    )
    facts.add_row("joints", ", ".join(f"{role} {count}" for role, count in found["roles"].items()))
    console.print(facts)
    console.print()
    joints = Table(box=None, pad_edge=False)
    for words in ("joint", "part of", "turns"):
        joints.add_column(words, no_wrap=True)
    for numbers in ("stand [rad]", "range [rad]", "torque limit [N m]"):
        joints.add_column(numbers, justify="right", no_wrap=True)
    for joint in found["joints"]:
        low_high = joint["range_rad"]
        joints.add_row(
            joint["name"],
            joint["role"],
            joint["turns"],
            f"{joint['stand_rad']:+.3f}",
            f"{low_high[0]:+.2f} .. {low_high[1]:+.2f}" if low_high else "–",
            _number(joint["torque_limit_Nm"], 1),
        )
    console.print(joints)
    if found["remarks"]:
        console.print("\nunsure, or worth knowing:")
    for remark in found["remarks"]:
        console.print(f"- {remark}")
