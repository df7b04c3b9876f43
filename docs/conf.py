"""How Sphinx makes the site of these pages: `make docs`. Warnings are errors, and the build needs no network.

The notebooks are pages of `course/`, a copy that is made here. They are executed, but for `-D nb_execution_mode=off`.
"""

from __future__ import annotations

import re
import shutil
import sys
from pathlib import Path
from typing import Any

import zmpwalk
from docutils import nodes
from latex2mathml.converter import convert

project, author, version = "zmpwalk", "the zmpwalk authors", zmpwalk.__version__
extensions = ["myst_nb", "sphinx.ext.autodoc", "hawkmoth"]
source_suffix = {".md": "myst-nb", ".ipynb": "myst-nb"}
myst_enable_extensions = ["dollarmath", "amsmath"]
nb_execution_timeout = 300
nb_execution_raise_on_error = True
master_doc = "index"
html_theme = "alabaster"
html_theme_options = {
    "page_width": "1300px",
    "body_max_width": "auto",
    "description": "Humanoids walk in MuJoCo, with a ZMP known beforehand",
}
html_title = "zmpwalk"
html_static_path, html_css_files = ["_static"], ["math.css"]
html_math_renderer = "mathml"  # browsers draw it themselves, without a script from the network
exclude_patterns = ["images"]
myst_heading_anchors = 3
suppress_warnings = [
    "myst.header"
]  # pages are also read without a site, where a heading may follow one of two levels up
autodoc_member_order = "bysource"
autodoc_typehints = "none"
autodoc_docstring_signature = True


HERE = Path(__file__).parent


def copy_course(into: Path) -> None:
    """Lays the notebooks among the pages, where links to pages are shorter."""
    shutil.rmtree(into, ignore_errors=True)
    into.mkdir()
    for notebook in sorted((HERE.parent / "notebooks").glob("*.ipynb")):
        text = notebook.read_text(encoding="utf-8")
        (into / notebook.name).write_text(text.replace("(../docs/", "(../"), encoding="utf-8")


copy_course(HERE / "course")

sys.path.insert(0, str(HERE))
import headers  # noqa: E402

hawkmoth_root = str(headers.lay_out(HERE / "headers"))
hawkmoth_clang = headers.arguments(Path(hawkmoth_root))
hawkmoth_autoconf: list[str] = []


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


def shape_comment(app: Any, lines: list[str], transform: Any, options: Any) -> None:
    """Comments of C++ become text and fields."""
    lines[:] = headers.shaped(lines)


def skip_foreign(app: Any, what: str, name: str, of: Any, skip: bool, options: Any) -> bool | None:
    """What another package gave to a class of ours, such as Matplotlib to its figures, is explained there."""
    return True if not (getattr(of, "__module__", None) or "zmpwalk").startswith("zmpwalk") else None


def draw_math(writer: Any, node: Any) -> None:
    """An equation as MathML."""
    text = node.astext().replace(r"\begin{aligned}", r"\begin{array}{rll}").replace(r"\end{aligned}", r"\end{array}")
    writer.body.append(convert(text, display="block" if isinstance(node, nodes.math_block) else "inline"))
    raise nodes.SkipNode


def setup(app: Any) -> None:
    """Called by Sphinx."""
    app.add_html_math_renderer("mathml", (draw_math, None), (draw_math, None))
    app.connect("autodoc-skip-member", skip_foreign)
    app.connect("hawkmoth-process-docstring", shape_comment)
    app.connect("autodoc-process-docstring", shape_docstring)
