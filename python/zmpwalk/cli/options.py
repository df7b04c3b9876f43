"""Options that several commands share, and how their words become settings."""

from __future__ import annotations

import functools
import math
import os
from pathlib import Path
from typing import Any, Callable

import click

from .._core import WalkSettings
from ..errors import InputError
from ..figures import FORMATS
from ..settings import load_settings
from . import completion

__all__ = [
    "PathName",
    "RobotName",
    "format_option",
    "known_option",
    "parse",
    "push_option",
    "robot_option",
    "settings_options",
    "size_of",
    "terrain_option",
    "unsure",
    "walk_options",
]

MOST_BYTES = 255  # of a name in a path


def checked_name(text: str) -> str:
    """A path as it was typed, with a ~ that the shell has left resolved.

    Raises:
        InputError: it is empty, or no file can be called so.
    """
    if not text.strip():
        raise InputError("the name is empty")
    try:
        path = Path(text).expanduser()
        longest = max((len(os.fsencode(part)) for part in path.parts), default=0)
    except RuntimeError:
        raise InputError(f"{text}: there is no such user") from None
    except ValueError:
        raise InputError(f"{text!r} is no name of a file") from None
    if longest > MOST_BYTES or "\0" in text:
        raise InputError(f"{text[:40]!r}...: no file has a name like this; a name has at most {MOST_BYTES} bytes")
    return str(path) if text.startswith("~") else text


class PathName(click.ParamType):
    """A path to read or to write, checked before anything is done."""

    name = "path"

    def convert(self, value: Any, parameter: click.Parameter | None, context: click.Context | None) -> Path:
        if isinstance(value, Path):
            return value
        try:
            return Path(checked_name(value))
        except InputError as error:
            self.fail(str(error), parameter, context)

    def shell_complete(self, context: Any, parameter: Any, begun: str) -> Any:
        return completion.files(context, parameter, begun)


class RobotName(click.ParamType):
    """A robot's name, or a path that is checked as such."""

    name = "text"

    def convert(self, value: Any, parameter: click.Parameter | None, context: click.Context | None) -> str:
        try:
            return checked_name(value)
        except InputError as error:
            self.fail(str(error), parameter, context)

    def shell_complete(self, context: Any, parameter: Any, begun: str) -> Any:
        return completion.robots(context, parameter, begun)


FOOTSTEPS = ("tied", "absolute", "paper", "printed")


def settings_options(command: Callable) -> Callable:
    """Options that make `WalkSettings`, which the command gets as `settings`."""

    @click.option(
        "--law",
        type=click.Choice(["default", "paper"]),
        help="Preset of the settings: 'paper' is the law that the paper prints.  "
        "[default: that of the settings file, else default]",
    )
    @click.option(
        "--settings",
        "file",
        type=PathName(),
        help="Read settings from this TOML file; `zmpwalk settings ROBOT` prints one.",
    )
    @click.option(
        "--footsteps",
        shell_complete=lambda context, parameter, begun: [word for word in FOOTSTEPS if word.startswith(begun)],
        help="What decides where feet land: tied (to the COM), absolute, paper, printed, or the lengths of the steps "
        '"0.1,0.15,0.2" [m].  [default: that of the law]',
    )
    @click.option(
        "--set",
        "changes",
        multiple=True,
        metavar="NAME=VALUE",
        shell_complete=completion.settings,
        help="Change one setting, such as tracking.gain=3; may be repeated. `zmpwalk settings ROBOT` lists them.",
    )
    @functools.wraps(command)
    def with_settings(
        law: str | None, file: Path | None, footsteps: str | None, changes: tuple[str, ...], **options: Any
    ) -> int:
        return command(settings=_settings(law, file, footsteps, changes), **options)

    return with_settings


format_option = click.option(
    "--format",
    "kind",
    type=click.Choice(FORMATS),
    default="png",
    show_default=True,
    help="File format of figures; pdf and svg are vector graphics.",
)

robot_option = click.option(
    "--robot",
    type=RobotName(),
    default="mahru",
    show_default=True,
    help="A robot's name, menagerie:NAME, or a path to a robot.json, an MJCF (.xml, .mjcf) or a .urdf.",
)


push_option = click.option(
    "--push",
    multiple=True,
    metavar="T:DURATION:BODY:FX,FY,FZ",
    help="Force [N] on a body from T for DURATION [s]: 3.0:0.08:torso:0,50,0; no BODY is the trunk. Repeatable.",
)

known_option = click.option("--known", is_flag=True, help="The controller knows the --terrain, as stairs need it.")

terrain_option = click.option(
    "--terrain",
    metavar="GROUND",
    shell_complete=completion.grounds,
    help="Ground in place of the floor: flat, slope:DEG[,AZIMUTH], blocks:CM[,SEED], plates:DEG[,SEED], step:CM[,AT], "
    "stairs:RISExTREAD (cm), waves[:CM], soft:SECONDS. The controller is told only with --known.",
)


def walk_options(command: Callable) -> Callable:
    """Options that say which robot walks, with which velocity, and for how long."""
    profile = click.option(
        "--profile",
        default="paper",
        show_default=True,
        shell_complete=completion.profiles,
        help='Velocity to walk with: "0.2" [m/s]; "0:0.1,5:0.2/0/0.3", which is time:vx/vy/wz; a CSV file (FILE:linear '
        "joins its rows by lines); or paper, the profile of the paper.",
    )
    duration = click.option(
        "--duration", type=float, default=8.0, show_default=True, help="Simulated time of the walk [s]."
    )
    return robot_option(profile(duration(settings_options(command))))


def _settings(law: str | None, file: Path | None, footsteps: str | None, changes: tuple[str, ...]) -> Any:
    """WalkSettings from a file, the preset's name, --footsteps and the --set words; the later ones win.

    Raises:
        InputError: an unknown setting, or a value it cannot have.
    """
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
        values[name] = parse(text.strip(), like, f"--set {change}")
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


def parse(text: str, like: Any, change: str) -> Any:
    """A value of the kind of `like`; `change` is how messages begin."""
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
        raise InputError(f"{change}: '{text}' is not {kind}") from None
    return text


def unsure(words: tuple[str, ...]) -> dict[str, float]:
    """Fields of `Uncertainty` from words NAME=VALUE.

    Raises:
        InputError: not such words. Whether the fields exist, `Uncertainty` says.
    """
    fields = {}
    for word in words:
        name, equals, text = word.partition("=")
        if not equals:
            raise InputError(f"--uncertain {word}: write it as NAME=VALUE")
        fields[name.strip()] = parse(text.strip(), 0.0, f"--uncertain {word}")
    return fields


def size_of(text: str) -> tuple[int, int]:
    """Width and height of a picture.

    Raises:
        InputError: not WIDTHxHEIGHT.
    """
    try:
        width, height = map(int, text.lower().split("x"))
    except ValueError:
        raise InputError(f"--size {text}: give width x height, such as 1280x720") from None
    return width, height
