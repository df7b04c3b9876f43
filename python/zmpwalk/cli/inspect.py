"""`zmpwalk inspect` says what it finds in a robot's model, or why that robot cannot walk."""

from __future__ import annotations

import contextlib
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import click

from ..errors import InputError, ModelError
from ..files import as_input_error, whole
from ..robots import examine, robot_file, write_description
from ..tryout import try_out
from .options import PathName, RobotName
from .terminal import BAD_INPUT, STOOD, complain, new_console, number

__all__ = ["command"]


@click.command("inspect", short_help="Say what is found in a robot's model, and whether it walks.")
@click.argument("model", type=RobotName())
@click.option("--json", "as_json", is_flag=True, help="Print what was found as JSON.")
@click.option(
    "--write",
    type=PathName(),
    metavar="FILE",
    help="Write the description that was found into FILE, a robot.json.",
)
@click.option(
    "--figure",
    type=PathName(),
    metavar="FILE",
    help="Draw the robot, its soles and its COM into FILE, a .png, .pdf or .svg.",
)
def command(model: str, as_json: bool, write: Path | None, figure: Path | None) -> int:
    """Show what is found in MODEL: base, feet, legs, start pose, joints, and what is unsure.

    MODEL is a robot's name, menagerie:NAME, a robot.json, or any MJCF or URDF with a robot on two legs. If it cannot
    walk, the command says why, a line for each reason.
    """
    if figure is not None and figure.suffix.lower() not in (".png", ".pdf", ".svg"):
        raise InputError(f"--figure {figure}: give a .png, .pdf or .svg")
    try:
        loaded, proposal = examine(model)
    except ModelError as error:
        for reason in error.reasons:
            complain(reason)
        return BAD_INPUT
    tried, remarks = try_out(loaded, proposal.description, proposal.table)
    remarks = [*proposal.remarks, *remarks]
    proposal = replace(proposal, remarks=remarks, table={**proposal.table, "tried": tried, "remarks": remarks})
    _deliver(model, loaded, proposal, write, figure)
    if as_json:
        click.echo(json.dumps(proposal.table, indent=2, allow_nan=False))
    else:
        _print_inspection(proposal.table)
        for written in filter(None, (write, figure)):
            click.echo(f"\nwritten: {written}")
    return STOOD


def _deliver(name: str, model: Any, proposal: Any, description: Path | None, figure: Path | None) -> None:
    """Writes what was asked for: both files, or none where one of them cannot be written."""
    with contextlib.ExitStack() as drafts:
        if figure is not None:
            from ..figures.robot import draw  # matplotlib is slow to import

            drafts.enter_context(as_input_error(figure))
            draw(model, proposal).savefig(drafts.enter_context(whole(figure)))
        if description is not None:
            write_description(description, robot_file(name), proposal)


def _add_trial(facts: Any, tried: dict[str, Any]) -> None:
    """Rows about the walk that was tried."""
    end = "stood" if tried["stood"] else "did not walk: see below"
    facts.add_row("tried", f"{tried['speed_mps']:.3f} m/s: {end}")
    for row, key in (("  torque, stand", "torque_stand"), ("  torque, walk", "torque_walk")):
        if tried.get(key):
            joint, share = tried[key]
            facts.add_row(row, f"{100 * share:.0f} % of the limit of {joint}")
    if tried.get("range_left"):
        joint, end_of_range, left = tried["range_left"]
        facts.add_row("  range", f"{joint} came to {max(left, 0.0):.3f} rad from its end at {end_of_range:+.3f}")
    if tried.get("yaw_moment_Nm") is not None and tried.get("yaw_friction_Nm") is not None:
        facts.add_row(
            "  yaw moment", f"{tried['yaw_moment_Nm']:.1f} N m, friction holds {tried['yaw_friction_Nm']:.1f} N m"
        )
    if tried.get("zmp_error_mm"):
        x, y = (number(error, 2) for error in tried["zmp_error_mm"])
        facts.add_row("  ZMP error", f"{x} / {y} mm, x / y, 95 % of single support")


def _print_inspection(found: dict[str, Any]) -> None:
    from rich.table import Table

    console = new_console()
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
    for way, axis in (found["speed_limits"] or {}).items():
        unit = "rad/s" if way == "turning" else "m/s"
        facts.add_row(f"{way} up to", f"{axis['most']:.3f} {unit}: {axis['limit']}")
    if not found["speed_limits"]:
        facts.add_row("speed", "none: see below")
    _add_trial(facts, found["tried"])
    facts.add_row(
        "stand pose", (found["stand_keyframe"] and f"keyframe {found['stand_keyframe']}") or "from the description"
    )
    facts.add_row("joints", ", ".join(f"{role} {count}" for role, count in found["roles"].items()))
    console.print(facts)
    console.print()
    joints = Table(box=None, pad_edge=False, padding=(0, 1, 0, 0))
    for words in ("\n\njoint", "\n\npart of", "\n\nturns"):
        joints.add_column(words, overflow="fold")  # a long name goes on in the next line, nothing is cut off
    for numbers in ("\nstand\n[rad]", "\nrange\n[rad]", "torque\nlimit\n[N m]"):
        joints.add_column(numbers, justify="right", no_wrap=True)
    for joint in found["joints"]:
        low_high = joint["range_rad"]
        joints.add_row(
            joint["name"],
            joint["role"],
            joint["turns"],
            f"{joint['stand_rad']:+.3f}",
            f"{low_high[0]:+.2f} .. {low_high[1]:+.2f}" if low_high else "–",
            number(joint["torque_limit_Nm"], 1),
        )
    console.print(joints)
    if found["remarks"]:
        console.print("\nunsure, or worth knowing:")
    for remark in found["remarks"]:
        console.print(f"- {remark}")
