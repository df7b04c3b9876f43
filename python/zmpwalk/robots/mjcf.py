"""MJCF files: MuJoCo reads them. Where its version does not know what stands there, one that does is named."""

from __future__ import annotations

import json
import xml.etree.ElementTree as ET
from functools import lru_cache
from pathlib import Path
from typing import Iterator

import mujoco

from ..errors import InputError, ModelError
from .urdf import read_urdf

__all__ = ["ATTRIBUTES", "numbers", "parts", "read_model"]

# What not every version reads: {element: {attribute: [first version, last version]}}, written by
# `cpp/adapter/attributes.py`. The attribute "" is the element itself; an empty last version is the newest.
ATTRIBUTES = Path(__file__).resolve().parent / "attributes.json"


def read_model(path: Path) -> mujoco.MjModel:
    """The model in an MJCF or URDF file.

    Raises:
        InputError: there is no such file.
        ModelError: MuJoCo refuses the model. Where it does so for its version, the message names one that reads it.

    Usage: `model = read_model(Path("robot.xml"))`
    """
    if not path.is_file():
        raise InputError(f"{path}: no such file")
    if path.suffix.lower() == ".urdf":
        return read_urdf(path)[0]
    try:
        return mujoco.MjModel.from_xml_path(str(path))
    except Exception as error:  # MuJoCo raises ValueError, or its own FatalError
        said = f"{path}: MuJoCo cannot load it: {' '.join(str(error).split())}"
        needed = _needed(path)
        raise ModelError(f"{said}; {needed}" if needed else said) from None


def parts(path: Path) -> Iterator[tuple[Path, ET.Element | None]]:
    """An MJCF file and those that it includes, each with its outermost element; None for one that cannot be read.

    Usage: `for file, root in parts(Path("scene.xml")): ...`
    """
    todo, seen = [path], set()
    while todo:
        file = todo.pop(0)
        if file.resolve() in seen:
            continue
        seen.add(file.resolve())
        try:
            root = ET.parse(file).getroot()
        except (OSError, ET.ParseError, UnicodeDecodeError):
            yield file, None
            continue
        yield file, root
        for name in (each.get("file", "") for each in root.iter("include")):
            beside = file.parent / name  # the main file's folder comes first
            todo.append(beside if not (path.parent / name).is_file() and beside.is_file() else path.parent / name)


def _needed(path: Path) -> str:
    """Which version reads what this one does not, in words; "" where that is not why the model is refused."""
    ours, newer, older = numbers(mujoco.__version__), [], []
    for _, root in parts(path):
        for element in root.iter() if root is not None else ():
            known = _attributes().get(element.tag, {})
            for name in ["", *element.attrib]:
                first, last = known.get(name, known.get("", ["", ""]))
                what = f"'{name}' of <{element.tag}>" if name in known and name else f"<{element.tag}>"
                if first and numbers(first) > ours:
                    newer.append((numbers(first), first, what))
                elif last and numbers(last) < ours:
                    older.append((numbers(last), last, what))
    if newer:
        _, first, what = max(newer)
        return f"{what} needs MuJoCo {first} or later, and this is {mujoco.__version__}: pip install -U mujoco"
    if older:
        _, last, what = min(older)
        return f'{what} is read up to MuJoCo {last}, and this is {mujoco.__version__}: pip install "mujoco<={last}"'
    return ""


@lru_cache(maxsize=None)
def _attributes() -> dict[str, dict[str, list[str]]]:
    return json.loads(ATTRIBUTES.read_text(encoding="utf-8"))


def numbers(version: str) -> tuple[int, ...]:
    """The three leading numbers of a version, to compare.

    Usage: `numbers("2.3.1.post1")  # -> (2, 3, 1)`
    """
    return tuple(int(part) for part in version.split(".")[:3] if part.isdigit())
