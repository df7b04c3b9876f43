"""Type stubs of the settings, from their table: `python bindings/stubs.py FILE.pyi` corrects what stubgen wrote.

The constructor of `WalkSettings` takes keywords, and its properties take any object: that is all that pybind11-stubgen
can see. The table knows every name and type, so that a type checker finds `WalkSettings(trackr_gain=3)`.
"""

from __future__ import annotations

import ast
import sys
import textwrap
from pathlib import Path
from typing import Iterable

from zmpwalk._core import Setting, WalkSettings

ACCEPTS = {"list[float]": "typing.Sequence[float]", "dict[str, float]": "typing.Mapping[str, float]"}


def groups() -> dict[str, list[Setting]]:
    """The rows of each group, by its name."""
    out: dict[str, list[Setting]] = {}
    for row in WalkSettings.table().values():
        out.setdefault(row.group, []).append(row)
    return out


def class_name(group: str) -> str:
    return f"{group.capitalize()}Settings"


def gives(row: Setting) -> str:
    """The type that the setting is read as."""
    return f"typing.Literal[{', '.join(map(repr, row.words))}]" if row.words else row.type


def takes(row: Setting) -> str:
    """The type that may be assigned to it."""
    accepted = ACCEPTS.get(row.type, gives(row))
    return f"{accepted} | typing.Sequence[float]" if row.flat == "footsteps" else accepted


def quoted(text: str) -> str:
    """A docstring of a method, without the signature that pybind11 puts above it."""
    lines = text.strip().splitlines()
    if "->" in lines[0]:
        lines = lines[2:]
    return textwrap.indent("\n".join(['"""' + lines[0], *lines[1:]]) + ('\n"""' if len(lines) > 1 else '"""'), 8 * " ")


def method_of(name: str, first: list[str], text: str) -> list[str]:
    """A method that takes every setting as a keyword, after `first`."""
    given = ", ".join([*first, "*", *(f"{keyword}: {accepted} = ..." for keyword, accepted in keywords())])
    return [f"    def {name}(self, {given}) -> None:", quoted(text)]


def property_of(name: str, got: str, taken: str, text: str) -> list[str]:
    return [
        "    @property",
        f"    def {name}(self) -> {got}:",
        quoted(text),
        f"    @{name}.setter",
        f"    def {name}(self, value: {taken}) -> None: ...",
    ]


def keywords() -> Iterable[tuple[str, str]]:
    """Name and type of every keyword of `WalkSettings` but `law`."""
    for group, rows in groups().items():
        yield group, f"{class_name(group)} | {class_name(group)}Dict"
        for row in rows:
            yield row.flat, takes(row)


def dicts() -> list[str]:
    """What may be given for a group: a dict of some of its settings."""
    lines = []
    for group, rows in groups().items():
        lines += [f"class {class_name(group)}Dict(typing.TypedDict, total=False):"]
        lines += [f"    {row.name}: {takes(row)}" for row in rows]
    return lines


def body_of(cls: str) -> list[str]:
    """The members of a class of settings that the table knows."""
    lines = []
    if cls == "WalkSettings":
        lines += method_of("__init__", ['law: str = "default"'], WalkSettings.__init__.__doc__)
        lines += method_of("update", [], WalkSettings.update.__doc__)
        lines += ["    @staticmethod", "    def table() -> dict[str, Setting]:", quoted(WalkSettings.table.__doc__)]
        for group in groups():
            text = getattr(WalkSettings, group).__doc__
            lines += property_of(group, class_name(group), f"{class_name(group)} | {class_name(group)}Dict", text)
    for group, rows in groups().items():
        for row in rows:
            if cls == "WalkSettings":
                lines += property_of(row.flat, gives(row), takes(row), f"{group}.{row.name}: {row.text}")
            elif cls == class_name(group):
                lines += property_of(row.name, gives(row), takes(row), row.text)
    return lines


def corrected(stub: str) -> str:
    """A stub of `_core` with the settings' classes as the table has them."""
    source, out, at = stub.splitlines(), [], 0
    classes = {class_name(group) for group in groups()} | {"WalkSettings"}
    first = True
    for node in ast.parse(stub).body:
        if not isinstance(node, ast.ClassDef) or node.name not in classes:
            continue
        out += source[at : node.lineno - 1]
        if first:
            out += dicts()
            first = False
        body = body_of(node.name)
        ours = {line.split("def ")[1].split("(")[0] for line in body if line.startswith("    def ")}
        start = node.lineno
        out += source[node.lineno - 1 : start]
        for member in node.body:
            begin = min([member.lineno, *(d.lineno for d in getattr(member, "decorator_list", []))])
            if getattr(member, "name", None) not in ours:
                out += source[begin - 1 : member.end_lineno]
        out += body
        at = node.end_lineno
    return "\n".join([*out, *source[at:]]) + "\n"


if __name__ == "__main__":
    path = Path(sys.argv[1])
    path.write_text(corrected(path.read_text(encoding="utf-8")), encoding="utf-8")
