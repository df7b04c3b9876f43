"""Lays the headers of cpp/ out so that Sphinx's reader of C++ (hawkmoth) understands them; `conf.py` calls this.

It reads comments that stand between /** and */ before what they explain; ours are lines of ///, some of them behind it.
"""

from __future__ import annotations

import importlib.util
import os
import re
import shutil
import subprocess
from pathlib import Path

TOP = Path(__file__).parents[1]

_located = importlib.util.spec_from_file_location("wheels", TOP / "cmake" / "wheels.py")
wheels = importlib.util.module_from_spec(_located)
_located.loader.exec_module(wheels)


def lay_out(into: Path) -> Path:
    """A copy of all headers with their comments rewritten, under `into`; returns the folder that holds them."""
    shutil.rmtree(into, ignore_errors=True)
    for header in sorted((TOP / "cpp" / "include").rglob("*.h*")):
        copy = into / header.relative_to(TOP / "cpp" / "include")
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(rewritten(header.read_text(encoding="utf-8")), encoding="utf-8")
    return into / "zmpwalk"


def rewritten(text: str) -> str:
    """A header whose comments of lines `///` are blocks before what they explain."""
    text = re.sub(r"^ *///(?= .*\n(?: *//.*\n)* *namespace )", "//", text, flags=re.M)  # a name space is no entry
    text = text.replace("if constexpr", "if")  # the reader would put constexpr before the function's `template`
    text = re.sub(r"^(?P<space> *)(?P<code>\S.*?) *///< ?(?P<words>.*)$", _before, text, flags=re.M)
    return re.sub(r"(?:^ *///.*\n)+", _block, text, flags=re.M)


def _before(line: re.Match) -> str:
    return f"{line['space']}/// {line['words']}\n{line['space']}{line['code']}"


def _block(lines: re.Match) -> str:
    text = [re.sub(r"^ */// ?", "", line) for line in lines[0].splitlines()]
    space = re.match(" *", lines[0])[0]
    return "".join(f"{space}{line}\n" for line in ("/**", *(f" * {line}".rstrip() for line in text), " */"))


def arguments(folder: Path) -> list[str]:
    """What clang is told: where headers are, ours, Eigen's, eiquadprog's and those of the C++ compiler."""
    eigen = wheels.include_folder("eigen3", "Eigen/Core")
    compiler = os.environ.get("CXX", "c++")
    said = subprocess.run([compiler, "-E", "-v", "-x", "c++", os.devnull], capture_output=True, text=True, check=True)
    searched = re.search(r"#include <\.\.\.> search starts here:\n(.*?)\nEnd of", said.stderr, re.S)[1].split()
    system = [word for path in (eigen, *searched) for word in ("-isystem", path)]
    # Without vector instructions: their headers belong to one compiler.
    return ["-std=c++17", "-DEIGEN_DONT_VECTORIZE", "-nostdinc++", f"-I{folder.parent}", *system]


def shaped(lines: list[str]) -> list[str]:
    """A comment as reStructuredText: code between backticks, `@param` and `@throws` as fields, the rest as it is."""
    text: list[str] = []
    for line in lines:
        for part in re.split(r"(?<=\S) +(?=@(?:param|throws|return)\b)", line.strip()):
            field = re.match(r"@(param|throws|return)\s+(\S+)?\s*(.*)", part)
            if field and field[1] == "param":
                text.append(f":param {field[2].rstrip(',')}: {escaped(field[3])}")
            elif field:
                text.append(f":{field[1]}: {escaped(' '.join(filter(None, field.groups()[1:])))}")
            elif text and text[-1].startswith(":") and part:
                text[-1] += " " + escaped(part)  # a field goes on
            else:
                text.append(escaped(part))
    found: list[str] = []
    for line in text:
        if line.startswith(":") and found and found[-1] and not found[-1].startswith(":"):
            found.append("")  # fields stand apart
        found.append(line)
    return [*found, ""]


def escaped(text: str) -> str:
    """A line whose `code` is marked as code, and whose signs mean themselves."""
    parts = text.replace("``", "`").split("`")
    parts[::2] = [re.sub(r"([*|_\\])", r"\\\1", part) for part in parts[::2]]
    return "``".join(parts)
