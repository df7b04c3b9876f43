"""Kinds of files that hold a robot: MJCF under both of its endings, and URDF, to which is added what it lacks."""

import importlib.util
import json
import re
import shutil
from pathlib import Path

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk.robots import ROBOTS, examine
from zmpwalk.robots.source import source_of

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


def same_model(one, other):
    """Whether two models have the same bodies and meshes; their bytes also hold where the files were."""
    numbers = ("body_mass", "body_inertia", "body_pos", "qpos0", "mesh_vert", "geom_size", "hfield_data")
    return all(np.array_equal(getattr(one, name), getattr(other, name)) for name in numbers)


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
    source = source_of(folder / "urdf" / "r.urdf")
    assert list(source.files) == ["urdf/r.urdf", "the meshes/sole.obj"]
    assert same_model(source.compiled(), model)
    absolute = mesh.replace("package://my_robot", f"file://{folder}")
    (tmp_path / "r.urdf").write_text(mahru_urdf.replace('<box size="0.25 0.14 0.03"/>', absolute))
    source = source_of(tmp_path / "r.urdf")
    assert str(tmp_path).encode() not in source.files["r.urdf"]
    assert same_model(source.compiled(), model)
    (folder / "the meshes" / "sole.obj").unlink()
    with pytest.raises(zmpwalk.ModelError, match=r"the mesh 'package://my_robot/the meshes/sole\.obj' was not found"):
        examine(folder / "urdf" / "r.urdf")


@pytest.fixture
def scattered(tmp_path):
    """The bundled robot in a folder with blanks: a scene that includes it from a folder below, and soles as meshes."""
    folder = tmp_path / "a folder"
    (folder / "the parts" / "of shape").mkdir(parents=True)
    soles = '<asset><mesh name="sole" file="{}"/></asset><worldbody>'
    text = (ROBOTS / "mahru.xml").read_text()
    mjcf = text.replace("<worldbody>", soles.format("of shape/sole.obj"), 1)
    shape = '<geom type="mesh" mesh="sole" mass="0" contype="0" conaffinity="0" pos="0 0 0.01"/>'
    mjcf = re.sub(r'(<body name="[lr]_foot"[^>]*>)', rf"\1{shape}", mjcf)
    mjcf = re.sub(r"<compiler", '<compiler meshdir="the parts"', mjcf, count=1)
    corners = [f"v {x} {y} {z}" for x in (-0.125, 0.125) for y in (-0.07, 0.07) for z in (-0.015, 0.015)]
    sides = ["1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4"]
    (folder / "the parts" / "of shape" / "sole.obj").write_text("\n".join(corners + [f"f {side}" for side in sides]))
    (folder / "the parts" / "my robot.xml").write_text(mjcf)
    scene = folder / "my scene.xml"
    scene.write_text('<mujoco model="scene"><include file="the parts/my robot.xml"/></mujoco>')
    return scene


def test_an_mjcf_with_includes_and_meshes_in_a_folder_with_blanks_walks_and_is_kept_whole(scattered, tmp_path):
    walk = zmpwalk.simulate(scattered, profile=0.1, duration=0.3)
    source = walk._source
    assert list(source.files) == ["my scene.xml", "the parts/my robot.xml", "the parts/of shape/sole.obj"]
    kept = walk.save(tmp_path / "walk.npz")
    shutil.rmtree(scattered.parent)
    again = zmpwalk.Trace.load(kept)
    assert same_model(again._source.compiled(), again.model)


def test_absolute_paths_in_an_mjcf_are_kept_as_relative_ones(scattered, tmp_path):
    inner = scattered.parent / "the parts" / "my robot.xml"
    inner.write_text(inner.read_text().replace("of shape/sole.obj", str(inner.parent / "of shape" / "sole.obj")))
    outer = tmp_path / "elsewhere" / "scene.xml"
    outer.parent.mkdir()
    outer.write_text("<mujoco><include file='../a folder/the parts/my robot.xml'/></mujoco>")
    model = mujoco.MjModel.from_xml_path(str(outer))
    source = source_of(outer)
    assert not any(str(tmp_path).encode() in content for content in source.files.values())
    shutil.rmtree(scattered.parent)
    assert same_model(source.compiled(), model)


def test_a_file_that_is_not_found_leaves_no_source(scattered):
    (scattered.parent / "the parts" / "of shape" / "sole.obj").unlink()
    assert source_of(scattered) is None
    (scattered.parent / "the parts" / "my robot.xml").unlink()
    assert source_of(scattered) is None


def test_what_a_newer_or_an_older_mujoco_reads_is_answered_with_its_version(monkeypatch, tmp_path):
    known = {"geom": {"newest": ["99.1.0", ""], "oldest": ["2.2.0", "2.2.1"]}, "glue": {"": ["98.0.0", ""]}}
    monkeypatch.setattr("zmpwalk.robots.mjcf._attributes", lambda: known)
    ours = re.escape(mujoco.__version__)
    text = "<mujoco><worldbody><geom size='1' {}/></worldbody>{}</mujoco>"
    for attribute, element, words in (
        ("newest='1'", "", rf"'newest' of <geom> needs MuJoCo 99\.1\.0 or later, and this is {ours}: pip install"),
        ("oldest='1'", "", rf"'oldest' of <geom> is read up to MuJoCo 2\.2\.1, and this is {ours}: pip install"),
        ("", "<glue/>", rf"<glue> needs MuJoCo 98\.0\.0 or later, and this is {ours}"),
    ):
        (tmp_path / "inner.xml").write_text(text.format(attribute, element))
        (tmp_path / "scene.xml").write_text("<mujoco><include file='inner.xml'/></mujoco>")
        with pytest.raises(zmpwalk.ModelError, match=words) as refusal:
            zmpwalk.load_robot(tmp_path / "scene.xml")
        assert "\n" not in str(refusal.value)
    (tmp_path / "wrong.xml").write_text(text.format("no_such='1'", ""))
    with pytest.raises(zmpwalk.ModelError, match="MuJoCo cannot load it") as refusal:
        zmpwalk.load_robot(tmp_path / "wrong.xml")
    assert "needs MuJoCo" not in str(refusal.value)


def test_every_mujoco_is_known_by_what_it_reads():
    known = json.loads((ROBOTS / "attributes.json").read_text())
    assert known["compiler"]["autolimits"] == ["2.2.2", ""]  # the bundled robot has it
    assert known["compiler"]["convexhull"] == ["2.2.0", "3.2.4"]


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
