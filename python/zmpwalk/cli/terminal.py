"""What all commands share: exit codes, complaints and progress on stderr, tables on stdout."""

from __future__ import annotations

import math
import os
import sys
import time
from contextlib import contextmanager, suppress
from typing import Any, Iterator

__all__ = [
    "BAD_INPUT",
    "FAULT",
    "FELL",
    "INTERRUPTED",
    "STOOD",
    "Parts",
    "Progress",
    "Share",
    "complain",
    "listened",
    "new_console",
    "number",
    "say_no_more",
]

STOOD, FAULT, BAD_INPUT, FELL, INTERRUPTED = 0, 1, 2, 3, 130


def complain(message: str) -> int:
    """Print a complaint as one line on stderr.

    Returns:
        The exit code for bad input.
    """
    print(f"zmpwalk: {' '.join(message.split())}", file=sys.stderr)
    return BAD_INPUT


def say_no_more() -> None:
    """What is still in the buffer of stdout goes nowhere, so that the end of Python says nothing about it."""
    with suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


@contextmanager
def listened() -> Iterator[None]:
    """For what is printed after all is done: a reader who has gone away changes nothing about the exit code."""
    try:
        yield
        sys.stdout.flush()
    except BrokenPipeError:
        say_no_more()


class Progress:
    """Shows on stderr how far the walk is: by a bar on a terminal, otherwise by a line now and then."""

    EVERY = 5.0  # lines apart in a file or pipe [s of wall time]

    def __init__(self, duration: float, verb: str = "walk"):
        self.t, self._duration, self._bar, self._next = 0.0, duration, None, 0.0  # type: float, float, Any, float
        self._verb = verb

    def __enter__(self) -> Progress:
        if sys.stderr.isatty():
            from rich.console import Console
            from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

            self._bar = Progress(
                TextColumn(f"{self._verb}ing"),
                BarColumn(),
                TextColumn("{task.completed:5.1f} of {task.total:g} s"),
                TimeRemainingColumn(),
                console=Console(stderr=True),
            )
            self._bar.start()
            self._task = self._bar.add_task(self._verb, total=self._duration)
        else:
            print(f"{self._verb}ing for {self._duration:g} s", file=sys.stderr, flush=True)
            self._next = time.monotonic() + self.EVERY
        return self

    def at(self, t: float, duration: float) -> None:
        self.t = t
        if self._bar is not None:
            self._bar.update(self._task, completed=t)
        elif time.monotonic() >= self._next:
            print(f"{self._verb}ed {t:.1f} of {duration:g} s", file=sys.stderr, flush=True)
            self._next = time.monotonic() + self.EVERY

    def __exit__(self, kind: Any, *rest: Any) -> None:
        if self._bar is not None:
            if kind is None:
                self._bar.update(self._task, completed=self._duration)
            self._bar.stop()


class Share:
    """How much of a long work is done: a bar on a terminal, otherwise a line now and then; always on stderr."""

    EVERY = 10.0  # between lines in a file or pipe [s of wall time]

    def __init__(self, what: str):
        self._what, self._bar, self._task = what, None, None  # type: str, Any, Any
        self._next = 0.0

    def __enter__(self) -> Share:
        if sys.stderr.isatty():
            from rich.console import Console
            from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

            self._bar = Progress(
                TextColumn(self._what),
                BarColumn(),
                MofNCompleteColumn(),
                TimeRemainingColumn(),
                console=Console(stderr=True),
            )
            self._bar.start()
            self._task = self._bar.add_task(self._what, total=None)
        return self

    def at(self, done: float, total: float) -> None:
        if self._bar is not None:
            self._bar.update(self._task, completed=done, total=total)
        elif time.monotonic() >= self._next:
            self._next = time.monotonic() + self.EVERY
            print(f"{self._what}: {done:g} of {total:g}", file=sys.stderr, flush=True)

    def __exit__(self, *rest: Any) -> None:
        if self._bar is not None:
            self._bar.stop()


class Parts:
    """Shows on stderr which part is being measured: by a bar on a terminal, otherwise by a line for each part."""

    def __init__(self) -> None:
        self._bar: Any = None
        self._tasks: dict[str, Any] = {}

    def __enter__(self) -> Parts:
        if sys.stderr.isatty():
            from rich.console import Console
            from rich.progress import Progress

            self._bar = Progress(console=Console(stderr=True))
            self._bar.start()
        return self

    def at(self, part: str, share: float) -> None:
        new = part not in self._tasks
        if self._bar is not None:
            if new:
                self._tasks[part] = self._bar.add_task(part, total=1.0)
            self._bar.update(self._tasks[part], completed=share)
        elif new:
            self._tasks[part] = None
            print(f"measuring {part}", file=sys.stderr, flush=True)

    def __exit__(self, *rest: Any) -> None:
        if self._bar is not None:
            self._bar.stop()


def new_console() -> Any:
    """A console for tables, as wide as the terminal; 100 columns wide into a file or pipe."""
    from rich.console import Console

    width = None if sys.stdout.isatty() else 100
    return Console(width=width, highlight=False, markup=False)


def number(value: float | None, digits: int) -> str:
    """A number for a table, a dash where there is none."""
    if value is None or not math.isfinite(value):
        return "–"
    return f"{value:.{digits}f}" if abs(value) < 1e5 else f"{value:.1e}"
