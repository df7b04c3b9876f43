"""Settings as TOML files: read, and written with every value in force, its unit and where it comes from."""

from __future__ import annotations

import difflib
import json
import math
import os
import sys
from pathlib import Path
from typing import Any, Iterable

from ._core import WalkingController, WalkSettings
from .errors import InputError

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

__all__ = ["load_settings", "settings_toml"]


def load_settings(path: str | os.PathLike, law: str | None = None, **changes: Any) -> WalkSettings:
    """Settings from a TOML file.

    Args:
        path: the file: `name = value` for any setting of `WalkSettings`, `law` for the preset that the others change,
            and a table `[torque_limits]` of joint name = N m. `zmpwalk settings ROBOT` prints one with every value.
        law: preset in place of the file's.
        changes: settings in place of the file's.

    Returns:
        The settings; what neither names stays the preset's.

    Raises:
        InputError: no such file, not TOML, an unknown name (names the nearest), a value of the wrong kind. Values
            out of range are refused by `WalkingController`, which knows the robot.

    Usage: `zmpwalk.simulate("mahru", settings=zmpwalk.load_settings("walk.toml"))`
    """
    try:
        values = tomllib.loads(Path(path).read_text(encoding="utf-8"))
    except OSError as error:
        raise InputError(f"{path}: {(error.strerror or str(error)).lower()}") from None
    except ValueError as error:  # TOML and encoding
        raise InputError(f"{path}: not TOML: {error}") from None
    values.update(changes)
    known = WalkSettings.table()
    for name in values:
        if name not in known and name != "law":
            raise InputError(f"{path}: no setting '{name}'; there is {', '.join(nearest(name, known))}")
    preset = values.pop("law", "default")
    if not isinstance(preset, str):
        raise InputError(f"{path}: law = {preset!r}; it must be 'default' or 'paper'")
    try:
        return WalkSettings(law=law or preset, **values)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None


def nearest(name: str, known: Iterable[str]) -> list[str]:
    """Up to three names that look like `name`, or all.

    Usage: `nearest("T_sss", WalkSettings.table())  # -> ["T_ss"]`
    """
    names = list(known)
    return difflib.get_close_matches(name, names, 3, 0.5) or sorted(names)


def settings_toml(controller: WalkingController, given: WalkSettings) -> str:
    """Every setting in force on a robot, as a TOML file that `load_settings` reads back to `given`.

    What was changed stands as it is, every default behind a `#`, with its value on this robot, unit and meaning.

    Args:
        controller: made with `given`; its settings are the resolved ones.
        given: the settings before the robot filled them in.

    Usage: `print(settings_toml(WalkingController(model, description, given), given))`
    """
    in_force, changed, preset = (s.to_dict() for s in (controller.settings, given, WalkSettings(law=given.law)))
    lines = [
        f"# Settings of a walk of {controller.description.name}: every value in force. A line behind # is a",
        "# default, which may depend on the robot and on other settings; take the # away to set it.",
        f"law = {_toml(given.law)}",
    ]
    for name, (unit, meaning) in WalkSettings.table().items():
        if name == "torque_limits":
            continue
        value, is_default = in_force[name], _same(changed[name], preset[name])
        if not is_default:
            value = changed[name]
        lines.append(f"{'# ' if is_default else ''}{name} = {_toml(value)}  # {f'[{unit}] ' if unit else ''}{meaning}")
    lines += ["", "[torque_limits]  # [N m] " + WalkSettings.table()["torque_limits"][1]]
    for joint, limit in zip(controller.joint_names, controller.torque_limit):
        own = joint not in given.torque_limits
        path = controller.torque_path[joint]
        limit = float(limit) if own else given.torque_limits[joint]
        lines.append(f"{'# ' if own else ''}{_key(joint)} = {_toml(limit)}  # {path}")
    return "\n".join(lines) + "\n"


def _same(a: Any, b: Any) -> bool:
    return a == b or (isinstance(a, float) and isinstance(b, float) and math.isnan(a) and math.isnan(b))


def _toml(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_toml(item) for item in value) + "]"
    if isinstance(value, str):
        return json.dumps(value)  # a TOML basic string
    return repr(value)  # inf, nan and all digits, as TOML has them


def _key(name: str) -> str:
    bare = name.replace("-", "a").replace("_", "a")
    return name if bare.isascii() and bare.isalnum() else json.dumps(name)
