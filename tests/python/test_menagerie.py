"""Robots of MuJoCo Menagerie by name: with a stand-in for its package, which downloads."""

import sys
from types import SimpleNamespace

import pytest
import zmpwalk
from zmpwalk import InputError
from zmpwalk.robots import ROBOTS


class MenagerieError(Exception):
    pass


class UnknownRobotError(MenagerieError):
    pass


class DownloadError(MenagerieError):
    pass


class Humanoid:
    name = "walker"

    def entry(self, name):
        if name not in (None, "scene"):
            raise MenagerieError(f"'walker' has no entry point '{name}'; available: scene")

    def xml(self, name):
        return ROBOTS / "mahru.xml"


class Elsewhere(Humanoid):
    def xml(self, name):
        raise DownloadError("no route")


@pytest.fixture
def package(monkeypatch):
    robots = {"walker": Humanoid(), "elsewhere": Elsewhere()}

    def get(name):
        if name not in robots:
            raise UnknownRobotError(f"Unknown robot '{name}'.")
        return robots[name]

    known = SimpleNamespace(
        get=get,
        robots=lambda kind: [Humanoid] if kind == "humanoid" else [],
        MenagerieError=MenagerieError,
        UnknownRobotError=UnknownRobotError,
        DownloadError=DownloadError,
    )
    monkeypatch.setitem(sys.modules, "mujoco_menagerie", known)


@pytest.mark.parametrize("robot", ["menagerie:walker", "menagerie:walker/scene"])
def test_robot_of_menagerie_is_loaded_and_carries_its_name(package, robot):
    _, description = zmpwalk.load_robot(robot)
    assert description.name == "walker"


@pytest.mark.parametrize(
    ("robot", "words"),
    [
        ("menagerie:nao", "Unknown robot 'nao'. Its humanoids are walker"),
        ("menagerie:walker/hands", "no entry point 'hands'"),
        ("menagerie:elsewhere", r"cannot be downloaded \(no route\); set MENAGERIE_ROOT"),
    ],
)
def test_robot_that_menagerie_does_not_give_is_bad_input(package, robot, words):
    with pytest.raises(InputError, match=words):
        zmpwalk.load_robot(robot)


def test_missing_package_is_told_with_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "mujoco_menagerie", None)
    with pytest.raises(InputError, match=r"pip install mujoco-menagerie .*MuJoCo 3\.2 or later"):
        zmpwalk.load_robot("menagerie:unitree_g1")
    monkeypatch.setitem(sys.modules, "robot_descriptions", None)
    with pytest.raises(InputError, match="pip install robot_descriptions"):
        zmpwalk.load_robot("robot_descriptions:g1_mj")


@pytest.fixture
def descriptions(monkeypatch, tmp_path):
    """A stand-in for the package robot_descriptions, which clones a repository when a robot is imported."""
    folder = tmp_path / "robot_descriptions"
    folder.mkdir()
    names = ["walker_mj_description", "arm_description", "far_mj_description", "odd_description"]
    (folder / "__init__.py").write_text(f"DESCRIPTIONS = dict.fromkeys({names})")
    (folder / "walker_mj_description.py").write_text(f"MJCF_PATH = {str(ROBOTS / 'mahru.xml')!r}")
    (folder / "arm_description.py").write_text("URDF_PATH = '/nowhere/arm.urdf'")
    (folder / "far_mj_description.py").write_text("raise OSError('git clone failed:\\nno route to host')")
    (folder / "odd_description.py").write_text("")
    for name in [name for name in sys.modules if name.split(".")[0] == "robot_descriptions"]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.syspath_prepend(tmp_path)
    yield
    for name in [name for name in sys.modules if name.split(".")[0] == "robot_descriptions"]:
        del sys.modules[name]


@pytest.mark.parametrize("robot", ["robot_descriptions:walker_mj", "robot_descriptions:walker_mj_description"])
def test_robot_of_robot_descriptions_is_loaded_and_carries_its_name(descriptions, robot):
    _, description = zmpwalk.load_robot(robot)
    assert description.name == robot.partition(":")[2]
    assert zmpwalk.simulate(robot, duration=0.01).model_kept.startswith("the files of mahru.xml")


@pytest.mark.parametrize(
    ("robot", "words"),
    [
        ("robot_descriptions:walkr_mj", "no 'walkr_mj_description'; the nearest names are walker_mj_description"),
        ("robot_descriptions:far_mj", r"cannot be downloaded \(git clone failed: no route to host\)"),
        ("robot_descriptions:arm", r"/nowhere/arm\.urdf: no such file"),
        ("robot_descriptions:odd", "neither an MJCF nor a URDF"),
    ],
)
def test_robot_that_robot_descriptions_does_not_give_is_bad_input(descriptions, robot, words):
    with pytest.raises(InputError, match=words):
        zmpwalk.load_robot(robot)
