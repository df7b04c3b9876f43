"""One place that looks at the numbers a caller gives: finite, in range, and few enough to be computed."""

from __future__ import annotations

import math
from numbers import Real
from typing import Any

from .errors import InputError

__all__ = ["MOST", "is_number", "positive", "samples"]

MOST_SAMPLES = 1_000_000  # of a function of time
MOST = 1e9  # of any quantity in SI units


def is_number(x: Any) -> bool:
    """Whether `x` is a finite number, and neither true nor false nor too long to be one of a computer's.

    Usage: `is_number(0.25)`
    """
    if isinstance(x, bool) or not isinstance(x, Real):
        return False
    try:
        return math.isfinite(x)
    except OverflowError:
        return False


def positive(name: str, value: Any, unit: str = "s", most: float = MOST) -> float:
    """The number `value`, which has to be positive.

    Args:
        name: what messages call it.
        most: the largest that makes sense.

    Raises:
        InputError: not a number, not positive, or larger than `most`.

    Usage: `duration = positive("duration", duration)`
    """
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    except (TypeError, ValueError):
        raise InputError(f"{name} is {value!r}; it must be a number [{unit}]") from None
    if not (math.isfinite(number) and number > 0):
        raise InputError(f"{name} is {number:g} {unit}; it must be positive and finite")
    if number > most:
        raise InputError(f"{name} is {number:g} {unit}; it must be at most {most:g} {unit}")
    return number


def samples(duration: float, dt: float) -> int:
    """How many steps of `dt` [s] make `duration` [s], at least 1.

    Raises:
        InputError: more than a million.

    Usage: `samples(8.0, 0.01)  # -> 800`
    """
    if not duration / dt <= MOST_SAMPLES:
        raise InputError(
            f"{duration:g} s in steps of {dt:g} s make more than {MOST_SAMPLES:g} samples; "
            "take longer steps or a shorter duration"
        )
    return max(1, math.ceil(duration / dt - 1e-9))
