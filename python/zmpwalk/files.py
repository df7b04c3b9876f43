"""Writes files so that they are there whole or not at all, and says why one cannot be read or written."""

from __future__ import annotations

import csv
import io
import os
import shutil
import tempfile
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Callable, Iterator, Mapping, Sequence

from .errors import InputError

__all__ = ["as_input_error", "cause", "together", "whole", "write_table"]


@contextmanager
def whole(path: str | os.PathLike) -> Iterator[Path]:
    """A hidden draft beside `path`, with the same suffix, that becomes the file when the block ends.

    Where the block raises, the draft is removed and what was at `path` before is still there.

    Raises:
        OSError: the folder does not exist or cannot be written.

    Usage: `with whole("walk.csv") as draft: draft.write_text(table)`
    """
    path = Path(path)
    draft = path.with_name(f".{os.getpid()}-{path.name}")
    try:
        yield draft
        os.replace(draft, path)
    finally:
        if draft.exists():
            draft.unlink()


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
    made = [parent for parent in (folder, *folder.parents) if not parent.exists()]
    try:
        folder.mkdir(parents=True, exist_ok=True)
        draft = Path(tempfile.mkdtemp(prefix=".walk-", dir=folder))
    except OSError as error:
        _remove_empty(made)
        raise _cannot_write(folder, error) from None

    def deliver(files: Sequence[Path]) -> None:
        for file in files:
            os.replace(file, folder / file.name)

    try:
        yield draft, deliver
    finally:
        shutil.rmtree(draft, ignore_errors=True)
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


def _cannot_write(path: str | os.PathLike, error: OSError) -> InputError:
    return InputError(f"{path}: cannot write there: {cause(error)}")


def _remove_empty(folders: Sequence[Path]) -> None:
    for folder in folders:
        try:
            folder.rmdir()
        except OSError:
            return
