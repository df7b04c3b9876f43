"""How Sphinx makes the site of these pages: `make docs`. Warnings are errors, and the build needs no network."""

from __future__ import annotations

import re
from typing import Any

import zmpwalk

project, author, version = "zmpwalk", "the zmpwalk authors", zmpwalk.__version__
extensions = ["myst_parser", "sphinx.ext.autodoc"]
source_suffix = {".md": "markdown"}
master_doc = "index"
html_theme = "alabaster"
html_theme_options = {
    "page_width": "1300px",
    "body_max_width": "auto",
    "description": "Humanoids walk in MuJoCo, with a ZMP known beforehand",
}
html_title = "zmpwalk"
exclude_patterns = ["images"]
myst_heading_anchors = 3
suppress_warnings = [
    "myst.header"
]  # pages are also read without a site, where a heading may follow one of two levels up
autodoc_member_order = "bysource"
autodoc_typehints = "none"
autodoc_docstring_signature = True


def shape_docstring(app: Any, what: str, name: str, of: Any, options: Any, lines: list[str]) -> None:
    """First paragraphs of docstrings become text; arguments, results and usage stay as they are laid out."""
    text, end = [], 0
    for end, line in enumerate([*lines, "Args:"]):  # noqa: B007
        if re.match(r"(\w+)( \w+)?:( |$)|\s|- |\|", line):
            break
        parts = line.replace("``", "`").split("`")  # every second one is code
        parts[::2] = [re.sub(r"([*|_\\])", r"\\\1", part) for part in parts[::2]]
        text.append("``".join(parts))
    rest = lines[end:]
    lines[:] = text
    if any(line.strip() for line in rest):
        lines += ["", ".. code-block:: none", "", *(f"   {line}" if line.strip() else "" for line in rest), ""]


def skip_foreign(app: Any, what: str, name: str, of: Any, skip: bool, options: Any) -> bool | None:
    """What another package gave to a class of ours, such as Matplotlib to its figures, is explained there."""
    return True if not (getattr(of, "__module__", None) or "zmpwalk").startswith("zmpwalk") else None


def setup(app: Any) -> None:
    """Called by Sphinx."""
    app.connect("autodoc-skip-member", skip_foreign)
    app.connect("autodoc-process-docstring", shape_docstring)
