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
    monkeypatch.setattr("zmpwalk.robots.menagerie.sys", SimpleNamespace(version_info=(3, 11)))


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


@pytest.mark.parametrize(("version", "words"), [((3, 10), "Python 3.11 or later"), ((3, 11), r"zmpwalk\[robots\]")])
def test_missing_package_is_told_with_what_to_install(monkeypatch, version, words):
    monkeypatch.setitem(sys.modules, "mujoco_menagerie", None)
    monkeypatch.setattr("zmpwalk.robots.menagerie.sys", SimpleNamespace(version_info=version))
    with pytest.raises(InputError, match=words):
        zmpwalk.load_robot("menagerie:unitree_g1")
