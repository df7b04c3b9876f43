"""Writes what is known of the recorded columns where people and type checkers read it: `python docs/make_columns.py`.

The table stands once, in cpp/include/zmpwalk/walk/record.hpp. From it come the table of docs/columns.md and the
attributes of a Trace in python/zmpwalk/_columns.py.
"""

import sys
import textwrap
from pathlib import Path

from zmpwalk import Trace

sys.path.append(str(Path(__file__).parents[1] / "benchmarks"))
from pages import write_blocks

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "columns.md"
ATTRIBUTES = ROOT / "python" / "zmpwalk" / "_columns.py"

HEAD = '''"""The columns of a Trace as attributes that editors and type checkers know; written by `make columns`."""

from __future__ import annotations

import numpy as np


class RecordedColumns:
    """Every column that zmpwalk records; `Trace.columns()` tells more of each."""
'''


def page_rows():
    """The lines of the table in docs/columns.md."""
    rows = ["| column | a row holds | unit | frame | meaning |", "|---|---|---|---|---|"]
    for column in Trace.columns().values():
        numbers = ", ".join(column.parts) or column.size
        name = f"`{column.name}`" + ("" if column.decided else " *")
        rows.append(f"| {name} | {numbers} | {column.unit} | {column.frame} | {column.meaning} |")
    return rows


def attributes():
    """The text of python/zmpwalk/_columns.py."""
    lines = [HEAD]
    for column in Trace.columns().values():
        shape = "(T,)" if column.size == "1" else f"(T, {column.size})"
        unit = f" [{column.unit}]" if column.unit else ""
        text = textwrap.fill(f'"""{shape}{unit}. {column.meaning}"""', 116)
        lines.append(textwrap.indent(f"{column.name}: np.ndarray\n{text}\n", "    "))
    return "\n".join(lines)


if __name__ == "__main__":
    write_blocks(PAGE, {"columns": page_rows()})
    ATTRIBUTES.write_text(attributes(), encoding="utf-8")
