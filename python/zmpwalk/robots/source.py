"""A model as files: the MJCF or URDF that it was compiled from, with all that this names.

A compiled model is only good for the MuJoCo that compiled it; its source is good for all. `load_robot` remembers the
source of each model that it reads, so that a trace can keep it.
"""

from __future__ import annotations

import hashlib
import os
import tempfile
import weakref
import xml.etree.ElementTree as ET
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Mapping, Union

import mujoco
import numpy as np

from ..errors import InputError, ModelError
from .mjcf import parts, read_model
from .urdf import mesh_file

__all__ = ["Source", "given_source", "model_bytes", "remember", "source_of"]

FILES = ("file", "fileright", "fileleft", "fileup", "filedown", "filefront", "fileback")  # attributes that name a file
COMPILER_FOLDERS = ("meshdir", "texturedir", "assetdir")
DIRECTORIES = {"mesh": "meshdir", "hfield": "meshdir", "skin": "meshdir", "texture": "texturedir"}

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
        with tempfile.TemporaryDirectory(prefix="zmpwalk-") as folder:
            main = Path(folder, self.main)
            for name, content in self.files.items():
                file = Path(folder, *(part for part in name.split("/") if part not in ("", ".", "..")))
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_bytes(content)
            for name in (_compiler(main).get(key, "") for key in COMPILER_FOLDERS):
                searched = (main.parent / name).resolve()  # `..` in a path asks for what stands before it
                if Path(folder).resolve() in searched.parents:
                    searched.mkdir(parents=True, exist_ok=True)
            try:
                return read_model(main)
            except ModelError as error:
                raise ModelError(str(error).replace(f"{folder}{os.sep}", "")) from None


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
    files = _named_by_urdf(path) if path.suffix.lower() == ".urdf" else _named_by_mjcf(path)
    if files is None:
        return None
    places = [Path(os.path.abspath(file)) for file in files]
    common = os.path.commonpath([place.parent for place in places])
    content = {place: place.read_bytes() for place in places}
    for place in places:
        if place.suffix.lower() == ".urdf":
            content[place] = _beside_urdf(place)
        elif place.suffix.lower() in (".xml", ".mjcf"):
            content[place] = _relative(content[place], places[0].parent, _compiler(path))
    return Source({Path(os.path.relpath(place, common)).as_posix(): content[place] for place in places})


def remember(model: mujoco.MjModel, path: Path) -> None:
    """Note what a model was compiled from.

    Usage: `remember(model, Path("robot.xml"))`
    """
    source = source_of(path)
    if source is not None:
        _KNOWN[model] = source, hashlib.sha256(model_bytes(model)).hexdigest()


def model_bytes(model: mujoco.MjModel) -> bytes:
    """The compiled model as MuJoCo writes it: its hash names it, and `Trace.model` reads it."""
    buffer = np.zeros(mujoco.mj_sizeModel(model), np.uint8)
    mujoco.mj_saveModel(model, None, buffer)
    return buffer.tobytes()


def _named_by_mjcf(path: Path) -> list[Path] | None:
    """The files of an MJCF, itself first: those that it includes, meshes, textures, height fields, other models."""
    texts = [(file, root) for file, root in parts(path) if root is not None]
    if len(texts) != len(list(parts(path))):
        return None
    compiler = _compiler(path)
    found = {file: None for file, _ in texts}
    for file, root in texts:
        for element in root.iter():
            names = [element.attrib[name] for name in FILES if name in element.attrib]
            for name in names if element.tag != "include" else []:
                folders = [_directory(element.tag, compiler), ""]
                asset = _asset(name, [base / folder for base in (path.parent, file.parent) for folder in folders])
                if asset is None:
                    return None
                inner = _named_by_mjcf(asset) if element.tag == "model" else [asset]
                if inner is None:
                    return None
                found.update(dict.fromkeys(inner))
    return list(found)


def _compiler(path: Path) -> dict[str, str]:
    """The attributes of all <compiler> elements of an MJCF and of what it includes."""
    found: dict[str, str] = {}
    for _, root in parts(path):
        for element in root.iter("compiler") if root is not None else ():
            found.update(element.attrib)
    return found


def _directory(tag: str, compiler: Mapping[str, str]) -> str:
    """The folder, from that of the main file, in which MuJoCo looks for the files of such elements."""
    if tag == "include":
        return ""
    return compiler.get(DIRECTORIES.get(tag, "meshdir"), compiler.get("assetdir", ""))


def _asset(name: str, folders: list[Path]) -> Path | None:
    tails = (name, Path(name).name)  # the second by the compiler's strippath
    return next((folder / tail for tail in tails for folder in folders if (folder / tail).is_file()), None)


def _named_by_urdf(path: Path) -> list[Path] | None:
    robot = ET.parse(path).getroot()
    meshes = [mesh_file(mesh.get("filename", ""), path, robot) for mesh in robot.findall("link/collision//mesh")]
    return None if None in meshes else list(dict.fromkeys([path, *(mesh for mesh in meshes if mesh)]))


def _beside_urdf(path: Path) -> bytes:
    """The same URDF, whose collision meshes are named by their paths from its folder."""
    robot = ET.parse(path).getroot()
    for mesh in robot.findall("link/collision//mesh"):
        file = mesh_file(mesh.get("filename", ""), path, robot)
        mesh.set("filename", Path(os.path.relpath(file or "", os.path.abspath(path.parent))).as_posix())
    return ET.tostring(robot)


def _relative(text: bytes, folder: Path, compiler: Mapping[str, str]) -> bytes:
    """The same MJCF, where absolute paths have become those from the folder in which MuJoCo looks for them."""
    found = {}
    for element in ET.fromstring(text).iter():
        for key, value in element.attrib.items():
            if key in (*FILES, *COMPILER_FOLDERS) and os.path.isabs(value):
                start = folder if key in COMPILER_FOLDERS else folder / _directory(element.tag, compiler)
                found[value] = Path(os.path.relpath(value, start)).as_posix()
    for name in sorted(found, key=len, reverse=True):
        for quote in ('"', "'"):
            text = text.replace(f"{quote}{name}{quote}".encode(), f"{quote}{found[name]}{quote}".encode())
    return text


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
