"""The forms in which settings may be given: the settings themselves, a few changes, a law's name or a file."""

from __future__ import annotations

import os
import reprlib
from pathlib import Path
from typing import Any, Mapping, Union

from ._core import WalkSettings
from .errors import InputError
from .settings import load_settings

__all__ = ["Settings", "settings_of"]

Settings = Union[WalkSettings, Mapping[str, Any], str, "os.PathLike[str]", None]


def settings_of(settings: Settings) -> WalkSettings:
    """Makes the settings that were given in one of these forms.

    Args:
        settings: None takes `WalkSettings()`; a mapping of names to values changes these, of the preset that its key
            "law" names; a string is a law's name ("paper") or a TOML file's path; a path is a TOML file's.

    Raises:
        InputError: an unknown name or law, a value of the wrong kind, a file that cannot be read, or something else.

    Usage: `settings_of({"tracker_gain": 3.0})`, `settings_of("paper")`, `settings_of("walk.toml")`
    """
    if settings is None:
        return WalkSettings()
    if isinstance(settings, WalkSettings):
        return settings
    if isinstance(settings, Mapping):
        return WalkSettings(**{str(name): value for name, value in settings.items()})
    if isinstance(settings, os.PathLike):
        return load_settings(settings)
    if not isinstance(settings, str):
        raise InputError(
            f"settings is {reprlib.repr(settings)}; it must be WalkSettings, a dict {{name: value}}, "
            'a law such as "paper", or a TOML file'
        )
    if settings.endswith(".toml") or Path(settings).is_file():
        return load_settings(settings)
    try:
        return WalkSettings(law=settings)
    except InputError as error:
        raise InputError(f"settings is '{settings}', which is no .toml file, and {error}") from None
