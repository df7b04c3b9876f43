"""`zmpwalk humanoid` writes the MJCF of a humanoid of given measures."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from ..errors import InputError
from ..robots.humanoid import ARM, FEET, NECK, WAISTS, humanoid
from .terminal import STOOD

__all__ = ["command"]


def _foot(context: click.Context, parameter: click.Parameter, text: str | None) -> tuple[float, ...] | None:
    if text is None:
        return None
    try:
        return tuple(float(part) for part in text.replace("x", ",").split(","))
    except ValueError:
        raise InputError(f"--foot {text}: give length and width [m], such as 0.2,0.1") from None


@click.command("humanoid", short_help="Write the MJCF of a humanoid of your measures.")
@click.option("--height", type=float, default=1.6, show_default=True, help="From the soles to the crown [m].")
@click.option("--mass", type=float, help="Of the whole robot [kg].  [default: follows from the leg]")
@click.option("--foot", callback=_foot, metavar="LENGTH,WIDTH", help="Of a sole [m].  [default: follows from the leg]")
@click.option("--leg", type=float, help="Thigh and shank [m].  [default: the share of the height that people have]")
@click.option("--thigh", type=float, default=0.5, show_default=True, help="Of the leg, 0.4 to 0.6.")
@click.option("--hips", type=float, help="Distance between the hips [m].  [default: 0.3 of the leg]")
@click.option("--ankle", type=float, help="Its height over the sole [m].  [default: 0.1 of the leg]")
@click.option("--heel", type=float, default=0.35, show_default=True, help="From heel to ankle, of the foot's length.")
@click.option(
    "--torque",
    type=float,
    default=2.0,
    show_default=True,
    help="Limit of each joint; 1 just holds the robot on one bent leg with its weight over the toe.",
)
@click.option("--armature", type=float, default=0.01, show_default=True, help="Rotor inertia, of mass times leg^2.")
@click.option("--damping", type=float, default=0.0, show_default=True, help="Of mass g leg sqrt(leg / g).")
@click.option("--waist", type=click.Choice(WAISTS), default="y", show_default=True, help="Axes of its joints.")
@click.option("--arms", type=click.IntRange(0, len(ARM)), default=4, show_default=True, help="Joints in each arm.")
@click.option("--neck", type=click.IntRange(0, len(NECK)), default=0, show_default=True, help="Joints of the neck.")
@click.option("--soles", type=click.Choice(FEET), default="box", show_default=True, help="What touches the ground.")
@click.option("--timestep", type=float, default=0.001, show_default=True, help="Of the simulation [s].")
@click.option("--name", default="humanoid", show_default=True, help="Of the model.")
@click.option(
    "--out", type=click.Path(path_type=Path), default=Path("humanoid.xml"), show_default=True, help="MJCF to write."
)
def command(out: Path, **measures: Any) -> int:
    """Write the MJCF of a humanoid of your measures, or say why it could not walk.

    zmpwalk humanoid --height 1.2 --mass 40 --foot 0.2,0.1 --out small.xml

    zmpwalk walk --robot small.xml --profile 0:0,1:0.2
    """
    made = humanoid(**measures)
    for label, key, unit in (
        ("height", "height", "m"), ("leg", "leg", "m"), ("mass", "mass", "kg"), ("hips", "hip_distance", "m"),
        ("foot's length", "foot_length", "m"), ("foot's width", "foot_width", "m"),
    ):  # fmt: skip
        click.echo(f"{label:14s} {made.measures[key]:8.3f} {unit}")
    click.echo(f"\nwritten: {made.save(out)}")
    return STOOD
