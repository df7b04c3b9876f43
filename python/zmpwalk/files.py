"""Writes files so that they are there whole or not at all, and says why one cannot be read or written."""

from __future__ import annotations

import contextlib
import csv
import errno
import io
import os
import shutil
import signal
import tempfile
import threading
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Callable, Iterator, Mapping, Sequence

from .errors import InputError

try:
    import fcntl
except ImportError:  # only Unix has it
    fcntl = None  # type: ignore[assignment]

__all__ = ["as_input_error", "cause", "read_text", "together", "whole", "write_table"]

DRAFT = ".walk-"  # how the names of draft folders begin
LARGEST = 64_000_000  # bytes of a text file, which is read whole


def read_text(path: str | os.PathLike, kind: str = "a text file", largest: int = LARGEST) -> str:
    """The text of a file in UTF-8. A byte order mark is left out.

    Args:
        kind: what it has to be, in words.
        largest: size that is read [bytes]; what has no end, such as a device, is not read further.

    Raises:
        InputError: it cannot be read, is larger, or is no text.

    Usage: `read_text("walk.toml")`
    """
    try:
        with open(path, "rb") as file:
            raw = file.read(largest + 1)
    except OSError as error:
        raise InputError(f"{path}: {cause(error)}") from None
    except ValueError:
        raise InputError(f"{path!r} is no name of a file") from None
    if len(raw) > largest:
        raise InputError(f"{path}: it is larger than {largest / 1e6:g} MB, the most that is read of such a file")
    try:
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: not {kind} ({error})") from None


@contextmanager
def whole(path: str | os.PathLike) -> Iterator[Path]:
    """A hidden draft beside `path`, of the same name, that becomes the file when the block ends.

    Where the block raises, the draft is removed and what was at `path` before is still there. What is no file, such as
    /dev/stdout, is written at once.

    Raises:
        OSError: the folder does not exist or cannot be written, or `path` is a folder.

    Usage: `with whole("walk.csv") as draft: draft.write_text(table)`
    """
    path = Path(path)
    _require_no_folder(path)
    if path.exists() and not path.is_file():
        yield path
        return
    with _draft_folder(path.parent) as folder:
        yield folder / path.name
        os.replace(folder / path.name, path)


def write_table(path: str | os.PathLike, rows: Sequence[Mapping[str, Any]]) -> Path:
    """Write `rows`, which have the same keys, as a CSV table with these keys as its head, whole or not at all.

    Raises:
        InputError: the file cannot be written.

    Usage: `write_table("walks.csv", [{"speed": 0.25, "stood": True}])`
    """
    path, text = Path(path), io.StringIO()
    table = csv.DictWriter(text, list(rows[0]), lineterminator="\n")
    table.writeheader()
    table.writerows(rows)
    with as_input_error(path), whole(path) as draft:
        draft.write_text(text.getvalue(), encoding="utf-8")
    return path


@contextmanager
def together(folder: Path) -> Iterator[tuple[Path, Callable[[Sequence[Path]], None]]]:
    """A hidden draft folder in `folder`, and the function that moves finished files from it into `folder`.

    Several outputs appear together in this way: the block writes them all into the draft folder and then delivers
    them. Where it never does, `folder` is left as it was, or absent.

    Raises:
        InputError: `folder` cannot be made or written.

    Usage: `with together(out) as (draft, deliver): deliver([trace.save(draft / "trace.npz")])`
    """

    def deliver(files: Sequence[Path]) -> None:
        with as_input_error(folder):
            for file in files:  # a folder in the way of the last file must not part the set
                _require_no_folder(folder / file.name)
            with _undisturbed():
                for file in files:
                    os.replace(file, folder / file.name)

    made: list[Path] = []
    try:
        with as_input_error(folder):
            made += [parent for parent in (folder, *folder.parents) if not parent.exists()]
            folder.mkdir(parents=True, exist_ok=True)
        with contextlib.ExitStack() as stack:
            with as_input_error(folder):
                draft = stack.enter_context(_draft_folder(folder))
            yield draft, deliver
    finally:
        _remove_empty(made)


@contextmanager
def as_input_error(path: str | os.PathLike) -> Iterator[None]:
    """Turns the OSError of a block that cannot write `path` into an InputError that says so.

    Usage: `with as_input_error(path), whole(path) as draft: draft.write_text(text)`
    """
    try:
        yield
    except OSError as error:
        raise _cannot_write(path, error) from None


def cause(error: OSError) -> str:
    """What the system says went wrong, such as "no such file or directory".

    Usage: `raise InputError(f"{path}: {cause(error)}")`
    """
    return (error.strerror or str(error)).lower()


def _require_no_folder(path: Path) -> None:
    if path.is_dir():
        raise IsADirectoryError(errno.EISDIR, f"'{path.name or path}' is a directory")


@contextmanager
def _draft_folder(parent: Path) -> Iterator[Path]:
    """A new hidden folder in `parent`, gone when the block ends; those that killed processes have left go now.

    Whoever works in a draft folder holds a lock on it, which the system takes away from a process that dies. To make
    and lock one, and to look for unlocked ones, takes the lock of `parent`, so that no folder is seen before its lock.
    A draft folder has its lock already, by whoever writes in it, and nobody else does.
    """
    is_draft = parent.name.startswith(DRAFT)
    with contextlib.ExitStack() as held:
        with _undisturbed(), contextlib.nullcontext(False) if is_draft else _locked(parent) as alone:
            if alone:
                for left in parent.glob(f"{DRAFT}*"):
                    with _locked(left, wait=False) as unused:
                        if unused:
                            shutil.rmtree(left, ignore_errors=True)
            draft = Path(tempfile.mkdtemp(prefix=DRAFT, dir=parent))
            held.callback(_remove, draft)
            held.enter_context(_locked(draft))
        yield draft


def _remove(folder: Path) -> None:
    with _undisturbed():
        shutil.rmtree(folder, ignore_errors=True)


@contextmanager
def _undisturbed() -> Iterator[None]:
    """Signals that end a program wait until the block is over, where the main thread runs it."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    came: list[int] = []
    numbers = [getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)]
    before = {n: signal.getsignal(n) for n in numbers if signal.getsignal(n) not in (None, signal.SIG_IGN)}
    try:
        for n in before:
            signal.signal(n, lambda number, frame: came.append(number))
        yield
    finally:
        for n, handler in before.items():
            signal.signal(n, handler)
        for n in came:
            os.kill(os.getpid(), n)


@contextmanager
def _locked(folder: Path, wait: bool = True) -> Iterator[bool]:
    """Holds the lock of a folder; False where another process does, or where the system or disk has no such locks."""
    if fcntl is None:
        yield False
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | (0 if wait else fcntl.LOCK_NB))
            got = True
        except OSError:
            got = False
        yield got
    finally:
        os.close(handle)


def _cannot_write(path: str | os.PathLike, error: OSError) -> InputError:
    return InputError(f"{path}: cannot write there: {cause(error)}")


def _remove_empty(folders: Sequence[Path]) -> None:
    for folder in folders:
        try:
            folder.rmdir()
        except OSError:
            return
