"""A model as files: the MJCF or URDF that it was compiled from, with all that this names.

A compiled model is only good for the MuJoCo that compiled it; its source is good for all. `load_robot` remembers the
source of each model that it reads, so that a trace can keep it.
"""

from __future__ import annotations

import hashlib
import os
import weakref
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Iterable, Mapping, Union

import mujoco
import numpy as np

from ..errors import InputError

__all__ = ["Source", "given_source", "model_bytes", "remember", "source_of"]

# What a model was compiled from, and the hash of what came out: a model that was changed since has no source.
_KNOWN: weakref.WeakKeyDictionary[mujoco.MjModel, tuple[Source, str]] = weakref.WeakKeyDictionary()


@dataclass(frozen=True)
class Source:
    """Files by their paths below a common folder; the first is the model's own, an MJCF or a URDF."""

    files: Mapping[str, bytes]

    @property
    def main(self) -> str:
        """The path of the model's own file."""
        return next(iter(self.files))

    def compiled(self) -> mujoco.MjModel:
        """The model, compiled by the MuJoCo that is here.

        Raises:
            ModelError: this MuJoCo refuses it.

        Usage: `trace_source.compiled()`
        """
        from .source_files import compiled  # what reads XML is slow to import

        return compiled(self.files)

    def on_ground(self, geoms: Callable[[Mapping[str, str]], Iterable[Mapping[str, str]]]) -> Source:
        """The same scene with other geoms in place of its floor, which are all geoms of type plane.

        Args:
            geoms: the attributes of each geom of the new ground, from those of the floor.

        Raises:
            ModelError: the scene has no floor.

        Usage: `source.on_ground(lambda floor: [{"type": "box", "size": "9 9 1", "pos": "0 0 -1"}])`
        """
        from .source_files import on_ground

        return Source(on_ground(self.files, geoms))


Given = Union[str, os.PathLike, "tuple[str, Mapping[str, bytes]]", Source, None]


def given_source(given: Given, model: mujoco.MjModel) -> Source | None:
    """The source that a user gives for a model that was not loaded from a file.

    Args:
        given: path of an MJCF or URDF, the text of an MJCF, or (text, {file name: content}); None takes what
            `load_robot` remembers of the model.
        model: what it is the source of.

    Returns:
        The source; None where the model has none, or was changed since it was loaded.

    Raises:
        InputError: the source names files that are not there, or makes another model.
        ModelError: MuJoCo refuses it.

    Usage: `given_source("robot.xml", model)`
    """
    if given is None:
        known = _KNOWN.get(model)
        return known[0] if known and known[1] == hashlib.sha256(model_bytes(model)).hexdigest() else None
    if isinstance(given, Source):
        source: Source | None = given
    elif isinstance(given, tuple) or (isinstance(given, str) and given.lstrip().startswith("<")):
        text, files = given if isinstance(given, tuple) else (given, {})
        source = Source({"model.xml": text.encode(), **files})
    else:
        path = Path(given).expanduser()
        if not path.is_file():
            raise InputError(f"{path}: no such file")
        source = source_of(path)
    if source is None:
        raise InputError(f"the source {given} names files that are not there")
    _compare(source.compiled(), model)
    return source


def source_of(path: Path) -> Source | None:
    """A model's file and all files that it names; None where one of them is not found.

    Usage: `source_of(Path("scene.xml"))`
    """
    from .source_files import contents

    files = contents(path)
    return None if files is None else Source(files)


def remember(model: mujoco.MjModel, source: Source | None) -> None:
    """Note what a model was compiled from, if that is known.

    Usage: `remember(model, source_of(Path("robot.xml")))`
    """
    if source is not None:
        _KNOWN[model] = source, hashlib.sha256(model_bytes(model)).hexdigest()


def model_bytes(model: mujoco.MjModel) -> bytes:
    """The compiled model as MuJoCo writes it: its hash names it, and `Trace.model` reads it."""
    buffer = np.zeros(mujoco.mj_sizeModel(model), np.uint8)
    mujoco.mj_saveModel(model, None, buffer)
    return buffer.tobytes()


def _compare(made: mujoco.MjModel, model: mujoco.MjModel) -> None:
    """Refuse a source that makes another robot."""
    for count, what in (("nbody", "bodies"), ("njnt", "joints"), ("nq", "positions"), ("nu", "controls")):
        ours, theirs = int(getattr(made, count)), int(getattr(model, count))
        if ours != theirs:
            raise InputError(f"the source makes another model: it has {ours} {what}, the model has {theirs}")
    for name in ("body_mass", "body_pos", "qpos0"):
        away: Any = np.abs(np.asarray(getattr(made, name)) - np.asarray(getattr(model, name))).max(initial=0.0)
        if away > 1e-6:
            raise InputError(f"the source makes another model: {name} differs by up to {away:.2g}")
