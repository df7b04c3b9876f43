"""The files that a model is compiled from: found by what an MJCF or URDF names, and compiled again elsewhere."""

from __future__ import annotations

import os
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Callable, Iterable, Mapping

import mujoco

from ..errors import ModelError
from .mjcf import parts, read_model
from .urdf import mesh_file

__all__ = ["compiled", "contents", "on_ground"]

FILES = ("file", "fileright", "fileleft", "fileup", "filedown", "filefront", "fileback")  # attributes that name a file
COMPILER_FOLDERS = ("meshdir", "texturedir", "assetdir")
DIRECTORIES = {"mesh": "meshdir", "hfield": "meshdir", "skin": "meshdir", "texture": "texturedir"}


def contents(path: Path) -> dict[str, bytes] | None:
    """A model's file and all files that it names, by their paths below a common folder; None where one is not found.

    Absolute paths inside them have become relative ones, so that they can be put anywhere.

    Usage: `contents(Path("scene.xml"))`
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
    return {Path(os.path.relpath(place, common)).as_posix(): content[place] for place in places}


def compiled(files: Mapping[str, bytes]) -> mujoco.MjModel:
    """The model of such files, the first of which is its own.

    Raises:
        ModelError: this MuJoCo refuses it.

    Usage: `compiled(contents(Path("scene.xml")))`
    """
    with tempfile.TemporaryDirectory(prefix="zmpwalk-") as folder:
        main = Path(folder, next(iter(files)))
        for name, content in files.items():
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


def on_ground(
    files: Mapping[str, bytes], geoms: Callable[[Mapping[str, str]], Iterable[Mapping[str, str]]]
) -> dict[str, bytes]:
    """The files of a scene with other geoms in place of its floor: see `Source.on_ground`.

    Usage: `on_ground(contents(Path("scene.xml")), lambda floor: [])`
    """
    changed, floor = dict(files), None
    for name in files:
        root = ET.fromstring(files[name]) if name.lower().endswith((".xml", ".mjcf")) else ET.Element("none")
        planes = [
            (parent, geom)
            for world in root.iter("worldbody")
            for parent in (world, *world.iter("body"))
            for geom in parent.findall("geom")
            if geom.get("type") == "plane"
        ]
        for parent, geom in planes:
            parent.remove(geom)
            floor = geom.attrib if floor is None else floor
        if planes:
            changed[name] = ET.tostring(root)
    if floor is None:
        raise ModelError("its scene has no floor, a geom of type plane, that a terrain could replace")
    main = next(iter(files))
    root = ET.fromstring(changed[main])
    world = ET.SubElement(root, "worldbody")
    for attributes in geoms(floor):
        ET.SubElement(world, "geom", dict(attributes))
    changed[main] = ET.tostring(root)
    return changed


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
