"""`zmpwalk walk` walks a robot in MuJoCo, and writes trace, summary and figures into a folder."""

from __future__ import annotations

import json
import math
import sys
from pathlib import Path
from typing import Any

import click

from ..figures import FILES, FORMATS
from ..files import as_input_error, together
from ..motion import JointMotion
from ..profiles import profile_of
from ..robots import examine
from ..simulation import ON_FALL, Outside, WalkingController, check_duration, run
from ..terrain import known_of, load_scene
from ..trace import Trace
from . import completion
from .options import PathName, format_option, known_option, push_option, terrain_option, unsure, walk_options
from .terminal import FELL, INTERRUPTED, STOOD, Progress, listened, new_console, number

__all__ = ["command"]

MISMATCH = 0.002  # feet off the planned velocity by this are worth a warning [m/s]; 0.004 lets the paper's law fall


@click.command("walk", short_help="Walk a robot; write trace, summary and figures.")
@walk_options
@click.option(
    "--motion",
    type=PathName(),
    help="CSV file with angles of arms, waist and trunk over time, headed t,JOINT,...",
)
@push_option
@click.option(
    "--uncertain",
    multiple=True,
    metavar="NAME=VALUE",
    shell_complete=completion.uncertainties,
    help="What the controller does not know, a field of zmpwalk.Uncertainty such as noise=1 or torque_delay=0.008; "
    "may be repeated.",
)
@click.option("--simulated", help="The robot that is simulated, where the controller's --robot is not the true one.")
@terrain_option
@known_option
@click.option("--seed", type=int, default=0, show_default=True, help="Of all that is random.")
@click.option(
    "--on-fall",
    type=click.Choice(ON_FALL),
    default="stop",
    show_default=True,
    help="go_on: walk on until the robot lies on the ground, whatever the controller says.",
)
@click.option("--out", type=PathName(), help="Folder for trace, summary and figures.  [default: out/ROBOT-LAW]")
@click.option("--json", "as_json", is_flag=True, help="Print nothing but the summary, as JSON, on stdout.")
@click.option(
    "--strict",
    is_flag=True,
    help="Exit with 3, as after a fall, if the robot stood but fell short: missed its speed by more than 5 %, leaned "
    "on the stop of a joint, or asked for more torque than there is.",
)
@click.option("--no-figures", is_flag=True, help="Write only trace and summary, which is faster.")
@format_option
def command(
    robot: str,
    profile: str,
    motion: Path | None,
    duration: float,
    settings: Any,
    push: tuple[str, ...],
    uncertain: tuple[str, ...],
    simulated: str | None,
    terrain: str | None,
    known: bool,
    seed: int,
    on_fall: str,
    out: Path | None,
    as_json: bool,
    strict: bool,
    no_figures: bool,
    kind: str,
) -> int:
    """Walk a robot in MuJoCo, then write trace, summary and figures into a folder."""
    # Everything that can be wrong is found out before anything is written.
    velocity = profile_of(profile)
    check_duration(duration)
    model, found = examine(robot)
    if terrain is not None:
        model, _ = load_scene(robot, terrain)
    name = robot if robot.isidentifier() else found.description.name
    ground = known_of(known, None, terrain)
    controller = WalkingController(model, found.description, settings, velocity, ground=ground)
    controller.move(None if motion is None else JointMotion.from_csv(motion))
    outside = Outside.of(controller, seed, push, on_fall, unsure(uncertain), simulated, terrain)
    outside.simulation(controller)
    duration = check_duration(duration, controller)
    mismatch = controller.plan_mismatch(duration)
    out = out or Path("out") / f"{name}-{settings.law}"
    with together(out) as (draft, deliver):
        for remark in found.remarks:
            print(f"zmpwalk: note: {remark}", file=sys.stderr)
        if abs(mismatch) > MISMATCH:
            pace = "faster" if mismatch > 0 else "slower"
            print(
                f"zmpwalk: warning: the footsteps go {abs(mismatch):.4f} m/s {pace} than the planned velocity",
                file=sys.stderr,
            )
        progress = Progress(duration)
        try:
            with as_input_error(out):
                with progress:
                    trace = run(controller, duration, progress.at, seed, name, outside=outside)
                files = _write(trace, draft, None if no_figures else kind)
        except KeyboardInterrupt:
            print(f"zmpwalk: stopped at t = {progress.t:.2f} s of {duration:g} s; nothing was written", file=sys.stderr)
            return INTERRUPTED
        deliver(files)
        _remove_stale_figures(out, files)

    summary = trace.summary()
    with listened():
        if as_json:
            click.echo(json.dumps(summary, indent=2, allow_nan=False))
        else:
            _print_summary(summary, out, len(files))
    if summary["foreseen_time"] is not None:
        print(
            f"zmpwalk: a fall was foreseen at t = {summary['foreseen_time']:.3f} s: {summary['foreseen_cause']}",
            file=sys.stderr,
        )
    if summary["fell"]:
        print(
            f"zmpwalk: fell at t = {summary['fall_time']:.3f} s: {summary['fall_cause'] or 'cause unknown'}",
            file=sys.stderr,
        )
    for shortfall in summary["shortfalls"]:
        print(
            f"zmpwalk: {'before it fell' if summary['fell'] else 'it stood, but fell short'}: {shortfall}",
            file=sys.stderr,
        )
    if summary["fell"]:
        return FELL
    return FELL if strict and summary["shortfalls"] else STOOD


def _write(trace: Trace, folder: Path, kind: str | None) -> list[Path]:
    files = [trace.save(folder / "trace.npz"), folder / "summary.json"]
    files[1].write_text(json.dumps(trace.summary(), indent=2, allow_nan=False) + "\n", encoding="utf-8")
    if kind is not None:
        from .. import plot  # matplotlib is slow to import

        files += plot.save_all(trace, folder, format=kind)
    return files


def _remove_stale_figures(out: Path, files: list[Path]) -> None:
    """Removes figures of an earlier walk, which would be wrong beside the trace of this one."""
    new = {file.name for file in files}
    for old in (f"{stem}.{kind}" for stem in FILES.values() for kind in FORMATS):
        if old not in new and (out / old).exists():
            (out / old).unlink()


def _print_summary(summary: dict[str, Any], out: Path, count: int) -> None:
    from rich.table import Table

    console, error = new_console(), summary["zmp_error_mm"]
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
        facts.add_row("ZMP error, " + label, " / ".join(number(e, 4) for e in error[key]), "mm, x / y")
    iterations, cycle = summary["iterations"], summary["cycle_us"]
    facts.add_row(
        "iterations",
        f"{number(iterations['mean'], 1)} / {number(iterations['max'], 0)}",
        "mean / max where the ZMP was modified",
    )
    facts.add_row("peak torque", number(100 * (summary["peak_torque_ratio"] or math.nan), 0), "% of the limit")
    facts.add_row(
        "control cycle", f"{number(cycle['median'], 0)} / {number(cycle['p99'], 0)}", "µs, median / 99th percentile"
    )
    for shortfall in summary["shortfalls"]:
        what, _, _ = shortfall.partition(":")
        facts.add_row("fell short of", what, "see below")
    facts.add_row("real-time factor", number(summary["real_time_factor"], 1), "× real time")
    console.print(steps, "", facts, sep="\n")
    console.print(f"\n{count} files in {out}", soft_wrap=True)
