"""What disturbs a simulated walk from outside: pushes."""

from __future__ import annotations

import reprlib
from typing import Any, Iterable, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from .errors import InputError

__all__ = ["Push", "Pushes", "pushes_of"]


class Push(NamedTuple):
    """A constant force on a body for a while: neither the controller nor its model is told.

    `t` and `duration` are in seconds, `force` (3,) in newtons and the world's axes; it acts at the centre of mass of
    `body`, and None takes the trunk: the first body whose name holds "torso" or "trunk", else the root body.
    """

    t: float
    duration: float
    body: str | None
    force: Sequence[float]


Pushes = Iterable[Union[Push, Tuple[float, float, Optional[str], Sequence[float]], str]]


def pushes_of(push: Pushes) -> list[Push]:
    """The pushes that were given in one of these forms.

    Args:
        push: of (t, duration, body, force), or of texts "T:DURATION:BODY:FX,FY,FZ" whose BODY may be empty.

    Raises:
        InputError: something else. Whether the numbers make sense and the body exists, the simulation says.

    Usage: `pushes_of([(3.0, 0.08, "torso", (0, 50, 0)), "5:0.08::100,0,0"])`
    """
    if isinstance(push, str):
        push = [push]
    return [_push_of(each) for each in push]


def _push_of(push: Any) -> Push:
    words: Any = push
    if isinstance(push, str):
        words = push.split(":")
        words = [*words[:3], words[3].split(",")] if len(words) == 4 else ()
    try:
        t, duration, body, force = words
        three = np.asarray([float(value) for value in force])
        if three.shape == (3,) and (body is None or isinstance(body, str)):
            return Push(float(t), float(duration), body or None, tuple(three.tolist()))
    except (TypeError, ValueError):
        pass
    raise InputError(
        f"the push {reprlib.repr(push)} is not one: it is (t, duration, body, (fx, fy, fz)) [s, s, -, N] with a body's "
        'name or None for the trunk, or the text "T:DURATION:BODY:FX,FY,FZ"'
    )
