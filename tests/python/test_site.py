"""docs/ as a site: it builds without a warning, and its reference holds every public name."""

import importlib.util
import re
import subprocess
import sys
from pathlib import Path

import pytest
import zmpwalk

DOCS = Path(__file__).parents[2] / "docs"


def test_the_reference_holds_every_public_name():
    spec = importlib.util.spec_from_file_location("make_api", DOCS / "make_api.py")
    make_api = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(make_api)
    written = (DOCS / "api.md").read_text(encoding="utf-8")
    assert written == make_api.page(), "run `python docs/make_api.py`"
    named = set(re.findall(r":: zmpwalk\.(\w+)", written))
    assert named == {name for name in zmpwalk.__all__ if not name.startswith("__")}


def test_every_page_is_reached_from_the_first():
    listed = set(re.findall(r"^([\w/]+)$", (DOCS / "index.md").read_text(encoding="utf-8"), re.M))
    pages = {page.relative_to(DOCS).with_suffix("").as_posix() for page in DOCS.rglob("*.md")}
    assert listed == pages - {"index"}


def test_the_site_builds_without_a_warning(tmp_path):
    pytest.importorskip("sphinx")
    pytest.importorskip("myst_parser")
    command = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-b", "html", "-d", str(tmp_path / "read")]
    done = subprocess.run(
        [*command, str(DOCS), str(tmp_path / "site")],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout
    reference = (tmp_path / "site" / "api.html").read_text(encoding="utf-8")
    for name in zmpwalk.__all__:
        if not name.startswith("__"):
            assert re.search(rf'id="(module-)?zmpwalk\.{name}"', reference), name
