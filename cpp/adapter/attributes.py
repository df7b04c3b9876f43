"""Which MuJoCo versions know which elements and attributes of MJCF, asked of every release's own library.

`python/zmpwalk/robots/attributes.json` keeps what not every version knows, so that a model that the installed MuJoCo
refuses can be answered with the version that reads it: {element: {attribute: [first, last]}}. The attribute "" is the
element itself, and an empty `last` means that the newest version still has it.

Usage:
    python cpp/adapter/attributes.py build/mujoco      # the folder that layouts.py has filled
"""

from __future__ import annotations

import argparse
import ctypes
import json
import re
from pathlib import Path

from layouts import LAYOUTS, numbers

RESULT = LAYOUTS.parents[1] / "robots" / "attributes.json"


def schema(library: Path) -> set[tuple[str, str]]:
    """(element, attribute) of all that a release reads."""
    text = ctypes.create_string_buffer(1 << 20)
    ctypes.CDLL(str(library)).mj_printSchema(None, text, len(text), 0, 0)
    found, element = set(), ""
    for line in text.value.decode().splitlines():
        head = re.match(r" *(\w+) \([!?*R]\)(.*)", line)
        element, words = head.groups() if head else (element, line)
        found |= {(element, word) for word in ["", *words.split()]}
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("releases", type=Path, help="folder with VERSION/mujoco/libmujoco.so.VERSION")
    folder = parser.parse_args().releases
    versions = sorted(json.loads(LAYOUTS.read_text()), key=numbers)
    known = [schema(next((folder / version / "mujoco").glob("libmujoco.so*"))) for version in versions]
    result: dict[str, dict[str, list[str]]] = {}
    for element, attribute in sorted(set().union(*known)):
        having = [version for version, has in zip(versions, known) if (element, attribute) in has]
        span = [having[0], "" if having[-1] == versions[-1] else having[-1]]
        if having != versions and result.get(element, {}).get("") != span:  # as its element: said already
            result.setdefault(element, {})[attribute] = span
    lines = (f'"{element}": {json.dumps(attributes)}' for element, attributes in result.items())
    RESULT.write_text("{\n" + ",\n".join(lines) + "\n}\n")
    print(f"{sum(map(len, result.values()))} elements and attributes that not every version reads")


if __name__ == "__main__":
    main()
