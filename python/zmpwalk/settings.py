"""Settings as TOML files: read, and written with every value in force, what it is for and where it comes from."""

from __future__ import annotations

import math
import os
import textwrap
from typing import Any

from ._core import WalkingController, WalkSettings
from .errors import InputError
from .files import read_text

__all__ = ["load_settings", "read_toml", "settings_toml"]


def load_settings(path: str | os.PathLike, law: str | None = None, **changes: Any) -> WalkSettings:
    """Settings from a TOML file.

    Args:
        path: the file: a table per group of settings, such as `[tracking]` with `gain = 3.0`; a setting's one word does
            the same outside of all tables (`tracker_gain = 3.0`); `law` is the preset that they change.
            `zmpwalk settings ROBOT` prints a file with every setting.
        law: preset in place of the file's.
        changes: settings in place of the file's, named as for `WalkSettings`.

    Returns:
        The settings; what neither names stays the preset's.

    Raises:
        InputError: no such file, not TOML, an unknown name (names the nearest), a value of the wrong kind. Values
            out of range are refused by `WalkingController`, which knows the robot.

    Usage: `zmpwalk.simulate("mahru", settings=zmpwalk.load_settings("walk.toml"))`
    """
    values = read_toml(path)
    preset = values.pop("law", "default")
    if not isinstance(preset, str):
        raise InputError(f"{path}: law = {preset!r}; it must be 'default' or 'paper'")
    try:
        settings = WalkSettings(law=law or preset, **values)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None
    settings.update(**changes)
    return settings


def read_toml(path: str | os.PathLike) -> dict[str, Any]:
    """What a TOML file holds.

    Raises:
        InputError: no such file, or not TOML.

    Usage: `read_toml("walk.toml")["law"]`
    """
    try:
        import tomllib
    except ImportError:  # before Python 3.11
        import tomli as tomllib

    try:
        return tomllib.loads(read_text(path, "TOML"))
    except InputError:
        raise
    except ValueError as error:
        raise InputError(f"{path}: not TOML: {error}") from None
    except RecursionError:
        raise InputError(f"{path}: not TOML that makes sense: it is nested too deep") from None


def settings_toml(controller: WalkingController, given: WalkSettings) -> str:
    """Every setting in force on a robot, as a TOML file that `load_settings` reads back to `given`.

    Each group is a table, and above each setting stands what it is for. A setting that was changed stands as it is;
    every default stands behind a `#`, with its value on this robot.

    Args:
        controller: made with `given`; its settings are the resolved ones.
        given: the settings before the robot filled them in.

    Usage: `print(settings_toml(WalkingController(model, description, given), given))`
    """
    in_force, changed, preset = (s.to_dict() for s in (controller.settings, given, WalkSettings(law=given.law)))
    lines = [
        f"# Settings of a walk of {controller.description.name}: every value in force.",
        *_comment(
            "Where a # stands before a name, the value is a default, which may depend on the robot and on other "
            "settings. Take the # away to set it. In the rules, z_c is the height of the COM over the soles at the "
            "start, g is gravity, and T_c = sqrt(z_c / g)."
        ),
        "",
        *_comment("Preset that the settings below change: 'default', or 'paper' for the literal law of the paper."),
        f"law = {_toml(given.law)}",
    ]
    group = ""
    for row in WalkSettings.table().values():
        if row.group != group:
            group = row.group
            lines += ["", "", *_comment(getattr(WalkSettings, group).__doc__), f"[{group}]"]
        lines += ["", *_comment(row.text)]
        if row.flat == "torque_limits":
            lines += [f"[{row.group}.{row.name}]", *_torque_limits(controller, given)]
            continue
        is_default = _same(changed[row.flat], preset[row.flat])
        value = in_force[row.flat] if is_default else changed[row.flat]
        lines.append(f"{'#' if is_default else ''}{row.name} = {_toml(value)}")
    return "\n".join(lines) + "\n"


def _comment(text: str) -> list[str]:
    return textwrap.wrap(text, 79, initial_indent="# ", subsequent_indent="# ", break_on_hyphens=False)


def _torque_limits(controller: WalkingController, given: WalkSettings) -> list[str]:
    import tomlkit

    lines = []
    for joint, limit in zip(controller.joint_names, controller.torque_limit):
        own = joint not in given.torque_limits
        value = float(limit) if own else given.torque_limits[joint]
        lines += _comment(controller.torque_path[joint])
        lines.append(f"{'#' if own else ''}{tomlkit.key(joint).as_string()} = {_toml(value)}")
    return lines


def _same(a: Any, b: Any) -> bool:
    return a == b or (isinstance(a, float) and isinstance(b, float) and math.isnan(a) and math.isnan(b))


def _toml(value: Any) -> str:
    """A value as TOML writes it, with all its digits."""
    import tomlkit

    return tomlkit.item(list(value) if isinstance(value, tuple) else value).as_string()
