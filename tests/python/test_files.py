"""Kinds of files that hold a robot: MJCF under both of its endings, and URDF, to which is added what it lacks."""

import importlib.util
import shutil
from pathlib import Path

import numpy as np
import pytest
import zmpwalk
from zmpwalk.robots import ROBOTS, examine

PEERS = Path(__file__).resolve().parents[2] / "benchmarks" / "peers"
SOLE = (
    '<collision><origin xyz="0.02 0 -0.075"/><geometry><box size="0.25 0.14 0.03"/></geometry></collision>'
    '<visual><geometry><mesh filename="package://nowhere/skin.dae"/></geometry></visual></link>'
)


@pytest.fixture(scope="module")
def mahru_urdf():
    """The bundled robot as URDF, with boxes under its feet."""
    spec = importlib.util.spec_from_file_location("urdf", PEERS / "urdf.py")
    urdf = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(urdf)
    model, description = zmpwalk.load_robot("mahru")
    text = urdf.export(model, description.root_joint, zmpwalk.Robot(model, description).torque_limit, {})
    for foot in ("l_foot", "r_foot"):
        start = text.index(f'<link name="{foot}">')
        end = text.index("</link>", start)
        text = text[:end] + SOLE + text[end + len("</link>") :]
    return text


def test_mjcf_is_read_under_both_of_its_endings(tmp_path):
    shutil.copy(ROBOTS / "mahru.xml", tmp_path / "a robot.mjcf")
    model, description = zmpwalk.load_robot(tmp_path / "a robot.mjcf")
    same, _ = zmpwalk.load_robot("mahru")
    assert description.name == "a robot"
    assert np.array_equal(model.body_mass, same.body_mass)


def test_a_urdf_gets_a_free_joint_a_floor_and_motors_and_walks(mahru_urdf, tmp_path):
    file = tmp_path / "some robot.urdf"
    file.write_text(mahru_urdf)
    model, proposal = examine(file)
    said = "\n".join(proposal.remarks)
    assert "a free joint 'floating_base' was added" in said
    assert f"a floor at z = 0 and {model.nu} motors" in said
    assert model.nu == model.nv - 6
    assert model.body_mass.sum() == pytest.approx(zmpwalk.load_robot("mahru")[0].body_mass.sum(), rel=1e-5)
    walk = zmpwalk.simulate(file, profile=zmpwalk.VelocityProfile.constant(0.1), duration=2.0)
    assert not walk.meta["fell"]


def test_a_free_joint_of_the_urdf_is_kept(mahru_urdf, tmp_path):
    free = '<link name="ground"/><joint name="mine" type="floating"><parent link="ground"/><child link="{}"/></joint>'
    root = mahru_urdf.split('<link name="')[1].split('"')[0]
    (tmp_path / "r.urdf").write_text(mahru_urdf.replace("</robot>", free.format(root) + "</robot>"))
    _, proposal = examine(tmp_path / "r.urdf")
    assert not any("free joint" in remark for remark in proposal.remarks)
    assert proposal.description.root_joint == "mine"


def test_meshes_of_a_urdf_are_found_in_folders_with_blanks(mahru_urdf, tmp_path):
    corners = [f"v {x} {y} {z}" for x in (-0.125, 0.125) for y in (-0.07, 0.07) for z in (-0.015, 0.015)]
    sides = ["1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4"]
    folder = tmp_path / "my robot"
    (folder / "the meshes").mkdir(parents=True)
    (folder / "urdf").mkdir()
    (folder / "the meshes" / "sole.obj").write_text("\n".join(corners + [f"f {side}" for side in sides]))
    mesh = '<mesh filename="package://my_robot/the meshes/sole.obj"/>'
    (folder / "urdf" / "r.urdf").write_text(mahru_urdf.replace('<box size="0.25 0.14 0.03"/>', mesh))
    model, _ = examine(folder / "urdf" / "r.urdf")
    assert model.nmesh == 1
    (folder / "the meshes" / "sole.obj").unlink()
    with pytest.raises(zmpwalk.ModelError, match=r"the mesh 'package://my_robot/the meshes/sole\.obj' was not found"):
        examine(folder / "urdf" / "r.urdf")


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("<robot", "it is not XML"), ("<mujoco/>", "its outermost element is <mujoco>"),
        ("<robot name='r'/>", "has one root link, this has 0"),
        ("<robot name='r'><link name='a'/><link name='b'/></robot>", "has one root link, this has 2: a, b"),
    ],
)  # fmt: skip
def test_what_is_no_robot_is_refused_in_a_line(tmp_path, text, words):
    (tmp_path / "r.urdf").write_text(text)
    with pytest.raises(zmpwalk.ModelError) as refusal:
        zmpwalk.load_robot(tmp_path / "r.urdf")
    assert words in str(refusal.value)
    assert "\n" not in str(refusal.value)


def test_another_ending_is_refused_with_those_that_work(tmp_path):
    (tmp_path / "robot.sdf").touch()
    with pytest.raises(zmpwalk.InputError, match=r"an MJCF \(\.xml, \.mjcf\) or a \.urdf"):
        zmpwalk.load_robot(tmp_path / "robot.sdf")
