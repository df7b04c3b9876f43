"""What a shell offers when the Tab key is pressed: names of robots, settings, grounds, figures and uncertainties.

`docs/start.md` says how a shell learns of it.
"""

from __future__ import annotations

from dataclasses import fields
from typing import Any, Iterable

from click.shell_completion import CompletionItem

from .._core import WalkSettings
from ..disturbances import Uncertainty
from ..figures import FILES
from ..robots import available_robots
from ..terrain import FORMS

__all__ = ["figures", "files", "grounds", "profiles", "robots", "settings", "uncertainties"]


def _those(words: Iterable[str], begun: str) -> list[CompletionItem]:
    return [CompletionItem(word) for word in words if word.startswith(begun)]


def files(context: Any, parameter: Any, begun: str) -> list[CompletionItem]:
    """Files and folders, as the shell finds them."""
    return [CompletionItem(begun, type="file")]


def robots(context: Any, parameter: Any, begun: str) -> list[CompletionItem]:
    """Bundled robots, collections, and files."""
    known = [*available_robots(), "menagerie:", "robot_descriptions:"]
    return [*_those(known, begun), *files(context, parameter, begun)]


def profiles(context: Any, parameter: Any, begun: str) -> list[CompletionItem]:
    """The profile that has a name, and files."""
    return [*_those(["paper"], begun), *files(context, parameter, begun)]


def settings(context: Any, parameter: Any, begun: str) -> list[CompletionItem]:
    """`group.name=` of every setting, and after it the values of those that have words or are true or false."""
    name, equals, _ = begun.partition("=")
    rows = WalkSettings.table().values()
    if not equals:
        return _those([*(f"{row.group}.{row.name}=" for row in rows), *(f"{row.flat}=" for row in rows)], begun)
    for row in rows:
        if name in (row.flat, f"{row.group}.{row.name}"):
            words = ["true", "false"] if isinstance(row.default, bool) else row.words
            return _those([f"{name}={word}" for word in words], begun)
    return []


def grounds(context: Any, parameter: Any, begun: str) -> list[CompletionItem]:
    """Kinds of ground, with the sign that their numbers follow."""
    return _those([kind + (":" if ":" in form else "") for kind, form in FORMS.items()], begun)


def figures(context: Any, parameter: Any, begun: str) -> list[CompletionItem]:
    """Figures of a walk."""
    return _those([*FILES, "all"], begun)


def uncertainties(context: Any, parameter: Any, begun: str) -> list[CompletionItem]:
    """What a controller may not know."""
    return _those([f"{field.name}=" for field in fields(Uncertainty)], begun)
