"""The exceptions that zmpwalk raises when a caller makes a mistake: a few types under one :class:`Error`.

A physical event, such as a fall or a clamped ZMP, is never an error: it is a flag in the output.
"""

from __future__ import annotations

import importlib
from typing import Any, Iterable

__all__ = ["ColumnError", "DimensionError", "Error", "InputError", "ModelError", "VersionError", "nearest", "needed"]


class Error(Exception):
    """Base class of everything that zmpwalk raises on purpose. Its text is one line, whatever the input that it quotes.

    Example:
        >>> try:
        ...     zmpwalk.load_robot("marhu")
        ... except zmpwalk.Error as error:
        ...     print(error)
    """

    def __str__(self) -> str:
        return _one_line(super().__str__())


class InputError(Error, ValueError):
    """A value breaks a rule: it is NaN, infinite or out of its range, a name is unknown, or a file cannot be read."""


class ColumnError(InputError, AttributeError):
    """A trace does not hold a column that was asked for: it was recorded without it, or its file lacks it."""


class DimensionError(Error, ValueError):
    """An array has the wrong shape; the message gives both shapes."""


class ModelError(Error, ValueError):
    """A model or a robot description cannot walk: it has no free joint, feet or motors, or names do not exist.

    Args:
        reasons: one line each; the message is the first and says how many there are.

    Fields: reasons, as given.
    """

    def __init__(self, *reasons: str):
        more = len(reasons) - 1
        also = f" (and {more} more reason{'s' if more > 1 else ''}: zmpwalk inspect lists all)" if more > 0 else ""
        super().__init__("".join(reasons[:1]) + also)
        self.reasons = tuple(map(_one_line, reasons))


class VersionError(Error, ImportError):
    """The installed MuJoCo or NumPy is not one that this copy of zmpwalk can run with; raised by the import."""


def _one_line(text: str) -> str:
    return " ".join(text.splitlines())


def needed(package: str, purpose: str, install: str) -> Any:
    """A package that only some users install; `purpose` is what needs it, and `install` names what brings it.

    Raises:
        ImportError: it is not installed; says how to install it.

    Usage: `needed("pandas", "to_dataframe", "pandas").DataFrame(columns)`
    """
    try:
        return importlib.import_module(package)
    except ImportError:
        raise ImportError(f"{purpose} needs {package}: pip install {install}") from None


def nearest(name: str, known: Iterable[str]) -> list[str]:
    """Up to three of `known` that look like `name`, or all of them. A message offers them in place of a wrong name.

    Usage: `nearest("comm", ["com", "dcom", "tau"])  # -> ["com", "dcom"]`
    """
    import difflib

    names = list(known)
    return difflib.get_close_matches(name, names, 3, 0.5) or sorted(names)
