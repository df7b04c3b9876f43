"""_check_mujoco.py and _adapters.py: what does not work together is refused in one line that says what would work."""

import importlib.metadata
import json
import re
import subprocess
import sys
from pathlib import Path

import mujoco
import pytest
import zmpwalk
from zmpwalk import InputError, VersionError, _adapters, _core, build_info
from zmpwalk._check_mujoco import check_layout, check_versions, installed_mujoco

SWAP = (
    "import sys, mujoco; mujoco.__version__ = {loaded!r}; sys.path.insert(0, {folder!r})\n"
    "sys.argv = ['zmpwalk', 'inspect']; import zmpwalk"
)
BARE = (
    "import os, sys; has = lambda folder: os.path.isdir(os.path.join(folder, 'mujoco'))\n"
    "sys.path[:] = [folder for folder in sys.path if not has(folder)] + [{folder!r}]\n"
)


def refusal(folder, installed, loaded="", numpy="1.26.4"):
    """What the command line says where these versions are installed and loaded."""
    for package, version in (("mujoco", installed), ("numpy", numpy)):
        (folder / f"{package}-{version}.dist-info").mkdir()
    return said_by(SWAP.format(folder=str(folder), loaded=loaded))


def said_by(script):
    done = subprocess.run([sys.executable, "-c", script], stderr=subprocess.PIPE, text=True, check=False)
    assert done.returncode == 2, done.stderr
    said = done.stderr.strip().splitlines()
    assert len(said) == 1, done.stderr
    return said[0]


def test_an_unknown_mujoco_is_one_line_with_the_way_out(tmp_path):
    said = refusal(tmp_path, "9.9.9", "9.9.9")
    for part in ("no adapter to MuJoCo 9.9.9", "zmpwalk build-adapter", "C++17 compiler", mujoco.__version__):
        assert part in said


def test_a_missing_mujoco_is_one_line(tmp_path):
    (tmp_path / "zmpwalk").symlink_to(Path(zmpwalk.__file__).parent)
    said = said_by(BARE.format(folder=str(tmp_path)) + "sys.argv = ['zmpwalk', 'inspect']; import zmpwalk")
    assert "no mujoco is installed: pip install mujoco" in said


def test_a_version_without_a_folder_of_its_own_is_found_all_the_same(monkeypatch):
    monkeypatch.setattr(sys, "path", [])
    monkeypatch.setattr(importlib.metadata, "version", lambda package: {"mujoco": "9.9.9"}[package])
    assert installed_mujoco() == "9.9.9"


def test_a_mujoco_that_was_swapped_under_the_environment_is_one_line(tmp_path):
    said = refusal(tmp_path, "3.3.6", "3.3.7")
    assert "MuJoCo 3.3.7 is loaded" in said
    assert "MuJoCo 3.3.6 is installed" in said


def test_numpy_2_with_the_reference_is_one_line(tmp_path):
    assert 'pip install "numpy<2"' in refusal(tmp_path, "2.2.2", "2.2.2", "2.0.2")


@pytest.mark.parametrize(
    ("mujoco", "numpy"),
    [("2.2.0", "1.26.4"), ("2.3.1.post1", "1.26.4"), ("3.1.3", "1.26.4"), ("3.1.4", "2.0.0"), ("3.10.0", "2.2.6"),
     ("4.0.0", "2.5.5"), ("4.0.0", None)],
)  # fmt: skip
def test_versions_that_work_together_pass(mujoco, numpy):
    check_versions(mujoco, numpy)


@pytest.mark.parametrize("version", ["2.2.2", "2.3.7", "3.0.1", "3.1.3"])
def test_numpy_2_is_refused_where_contacts_would_have_stride_0(version):
    with pytest.raises(VersionError, match="wrong contact positions"):
        check_versions(version, "2.0.2")


def test_a_mujoco_that_is_too_old_is_refused():
    with pytest.raises(VersionError, match=r"2\.2 or later, but 2\.1\.5"):
        check_versions("2.1.5", "1.26.4")


def test_the_core_is_connected_with_the_mujoco_that_is_loaded():
    assert build_info()["mujoco"] == mujoco.__version__
    assert mujoco.__version__ in _adapters.adapter_versions()
    _core.connect("no file", "no file either", "9.9.9")  # a second time changes nothing
    assert _core.mujoco_version() == mujoco.__version__


def test_the_layout_is_that_of_the_mujoco_that_is_loaded():
    check_layout()


@pytest.mark.parametrize(("part", "name"), [("model", "body_pos"), ("data", "qfrc_bias"), ("numbers", "nv")])
def test_a_layout_that_differs_is_named(monkeypatch, part, name):
    honest = _core.seen

    def wrong(model, data):
        seen = honest(model, data)
        seen[part][name] += 8
        return seen

    monkeypatch.setattr(_core, "seen", wrong)
    with pytest.raises(InputError, match=f"^{name} lies in another place"):
        check_layout()


def test_an_adapter_is_built_for_the_installed_mujoco(monkeypatch, tmp_path):
    monkeypatch.setattr(_adapters, "_cache", lambda: tmp_path)
    monkeypatch.setattr(_adapters, "OWN", tmp_path / "file" / "below")
    (tmp_path / "file").write_text("no folder")
    built = _adapters.build_adapter("9.9.9")
    assert built == tmp_path / "adapter-9.9.9.so"
    assert built.stat().st_size < 100_000
    assert _adapters.adapter_file("9.9.9") == built


def test_a_compiler_that_is_missing_or_fails_is_an_error_with_the_way_out():
    with pytest.raises(InputError, match=r"no C\+\+17 compiler was found as no-such-compiler: install one"):
        _adapters.build_adapter("9.9.9", "no-such-compiler")
    with pytest.raises(InputError, match=r"does not compile against MuJoCo 9\.9\.9"):
        _adapters.build_adapter("9.9.9", "false")


def test_versions_of_one_layout_share_an_adapter(monkeypatch, tmp_path):
    layouts = json.loads((Path(_adapters.__file__).parent / "adapters" / "layouts.json").read_text())
    assert layouts["2.2.2"] == "2.2.2"
    assert layouts["3.1.3"] == layouts["3.1.2"]
    (tmp_path / "adapter-3.1.2.so").touch()
    monkeypatch.setattr(_adapters, "_folders", lambda: [tmp_path])
    assert _adapters.adapter_file("3.1.3") == tmp_path / "adapter-3.1.2.so"
    assert _adapters.adapter_versions() == ["3.1.2", "3.1.3"]
    assert _adapters.adapter_file("3.1.4") is None


def test_the_interface_is_that_of_the_header():
    _, include = _adapters._sources()
    header = (include / "zmpwalk" / "robot" / "mujoco_adapter.h").read_text()
    assert int(re.search(r"ZMPWALK_ADAPTER_INTERFACE (\d+)", header).group(1)) == _adapters.INTERFACE
