"""The type stub knows every setting: a wrong name does not pass the type checker, where one is installed."""

import ast
import importlib.util
import subprocess
import sys
from pathlib import Path

import pytest
import zmpwalk
from zmpwalk import WalkSettings

SOURCE = Path(__file__).parents[2]
SPEC = importlib.util.spec_from_file_location("stubs", SOURCE / "bindings" / "stubs.py")
stubs = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(stubs)

# What pybind11-stubgen writes, as far as it matters here.
MEMBERS = """
    def __init__(self, law: str = 'default', **kwargs) -> None: ...
    def to_dict(self) -> dict: ...
"""
PLAIN = "import typing\n\n\nclass Setting:\n    name: str\n\n\n" + "".join(
    f"class {name}:{MEMBERS}" for name in [*map(stubs.class_name, stubs.groups()), "WalkSettings"]
)
RIGHT = """
settings = WalkSettings("paper", tracker_gain=3, tracking={"gain": 3}, footsteps=[0.1], steps={"mode": "tied"})
settings.tracking.gain = 3
settings.tracker = "smooth"
settings.tracking = settings.tracking
settings.update(fall={"tilt": 1.0}, torque_limits={"l_knee": 3.0})
names: dict = settings.to_dict()
"""
WRONG = [
    "WalkSettings(trackr_gain=3)",
    "WalkSettings(tracker_gain='3')",
    "WalkSettings(tracking={'gian': 3})",
    "WalkSettings(footsteps='tide')",
    "WalkSettings().trackng",
    "WalkSettings().tracking.gian",
    "WalkSettings().update(trackr_gain=3)",
]


def test_corrected_stub_is_python_and_keeps_what_the_table_does_not_know():
    tree = ast.parse(stubs.corrected(PLAIN))
    members = {node.name: {m.name for m in node.body if isinstance(m, ast.FunctionDef)} for node in tree.body[2:]}
    assert {"__init__", "to_dict", "update", "table", "T_ss", "tracking"} <= members["WalkSettings"]
    assert {"to_dict", "gain", "law"} <= members["TrackingSettings"]
    assert stubs.corrected(stubs.corrected(PLAIN)).count("class WalkSettings:") == 1


def test_the_package_has_the_stub_of_its_own_table():
    stub = (Path(zmpwalk.__file__).parent / "_core.pyi").read_text(encoding="utf-8")
    tree = {node.name: node for node in ast.parse(stub).body if isinstance(node, ast.ClassDef)}
    for row in WalkSettings.table().values():
        assert row.name in {m.name for m in tree[stubs.class_name(row.group)].body if isinstance(m, ast.FunctionDef)}
    init = next(m for m in tree["WalkSettings"].body if getattr(m, "name", "") == "__init__")
    assert [a.arg for a in init.args.kwonlyargs] == [name for name, _ in stubs.keywords()], "run `make stubs`"


if importlib.util.find_spec("mypy"):

    @pytest.fixture(scope="module")
    def complaints(tmp_path_factory):
        """{line: message} of mypy on the right and the wrong uses, a wrong one a line."""
        folder = tmp_path_factory.mktemp("stubs")
        (folder / "core.pyi").write_text(stubs.corrected(PLAIN))
        (folder / "uses.py").write_text("from core import WalkSettings\n" + "\n".join(WRONG) + "\n" + RIGHT)
        command = [sys.executable, "-m", "mypy", "--config-file=", "--no-color-output", "uses.py"]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
        found = [line.split(":", 3) for line in done.stdout.splitlines() if ": error:" in line]
        assert all(file == "uses.py" for file, *_ in found), done.stdout
        return {int(number): message for _, number, _, message in found}

    def test_a_wrong_setting_does_not_pass_mypy(complaints):
        for number, wrong in enumerate(WRONG, start=2):
            assert number in complaints, wrong

    def test_a_right_setting_passes_mypy(complaints):
        assert [number for number in complaints if number >= 2 + len(WRONG)] == []
