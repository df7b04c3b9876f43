"""Robots by name, path and pair; what a robot.json must hold."""

import json
import shutil

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk import InputError, ModelError
from zmpwalk.robots import ROBOTS, description_from_dict, description_to_dict
from zmpwalk.robots.proposal.table import inspect_robot

MAHRU = ROBOTS / "mahru.xml"


@pytest.fixture(scope="module")
def mahru():
    return zmpwalk.load_robot("mahru")


@pytest.fixture
def robot_json(tmp_path, mahru):
    """Writes a robot.json for the bundled robot, with changes; returns its path."""

    def write(change=lambda plain: None):
        plain = {"model": str(MAHRU), **description_to_dict(mahru[1])}
        change(plain)
        path = tmp_path / "robot.json"
        path.write_text(json.dumps(plain))
        return path

    return write


def test_bundled_robot_stands_with_flat_soles_on_the_ground(mahru):
    assert zmpwalk.available_robots() == ["mahru"]
    model, description = mahru
    data = mujoco.MjData(model)
    description.place(model, data)
    for side in ("left", "right"):
        foot = getattr(description, side)
        body = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, foot.body)
        rotation = data.xmat[body].reshape(3, 3)
        assert (data.xpos[body] + rotation @ np.asarray(foot.sole_pos))[2] == pytest.approx(0.0, abs=1e-6)
        assert (foot.length, foot.width) == pytest.approx((0.25, 0.14))
        assert len(foot.leg_joints) == 6


def test_a_model_or_an_xml_with_its_own_marks_needs_no_description(mahru):
    expected = description_to_dict(mahru[1])
    assert expected["name"] == "mahru"
    for robot in (MAHRU, str(MAHRU), (MAHRU, None)):
        assert description_to_dict(zmpwalk.load_robot(robot)[1]) == expected
    found = description_to_dict(zmpwalk.load_robot(mahru[0])[1])
    assert {**found, "name": "mahru"} == expected


def test_a_pair_takes_the_description_that_is_given(mahru, robot_json):
    path = robot_json(lambda plain: plain.update(name="mine"))
    for description in (zmpwalk.read_description(path), path, str(path)):
        assert zmpwalk.load_robot((MAHRU, description))[1].name == "mine"


def test_robot_json_gives_back_exactly_what_was_written(mahru, robot_json):
    path = robot_json()
    for robot in (path, str(path), path.parent):
        model, description = zmpwalk.load_robot(robot)
        assert model.nq == mahru[0].nq
        assert description_to_dict(description) == description_to_dict(mahru[1])


def test_rectangle_form_means_the_same_as_centre_and_size(mahru, robot_json):
    def use_rectangles(plain):
        for side in ("left", "right"):
            foot = plain[side]
            (x, y, z), length, width = foot.pop("sole_center"), foot.pop("length"), foot.pop("width")
            foot["rect_x"], foot["rect_y"] = [x - length / 2, x + length / 2], [y - width / 2, y + width / 2]
            foot["sole_z"] = z

    foot, other = zmpwalk.read_description(robot_json(use_rectangles)).left, mahru[1].left
    assert (foot.length, foot.width) == pytest.approx((other.length, other.width))
    assert np.asarray(foot.sole_pos) == pytest.approx(np.asarray(other.sole_pos))


def test_polygon_gives_the_rectangle_inside_it(mahru, robot_json):
    def use_polygons(plain):
        for side in ("left", "right"):
            foot = plain[side]
            (x, y, z), a, b = foot.pop("sole_center"), foot.pop("length") / 2, foot.pop("width") / 2
            corners = [(a, b), (a + 0.01, 0), (a, -b), (-a, -b), (-a, b)]  # a pointed toe
            foot["polygon"] = [[x + dx, y + dy] for dx, dy in corners]
            foot["sole_z"] = z

    foot, other = zmpwalk.read_description(robot_json(use_polygons)).left, mahru[1].left
    assert foot.length >= other.length - 1e-9  # what it gains at the toe is length at the cost of width
    assert foot.length <= other.length + 0.01
    assert 0.8 * other.width < foot.width <= other.width + 1e-9


@pytest.mark.parametrize("polygon", [[[0, 0], [1, 1]], [[0, 0], [1, 1], [2, 2]], [[0, 0], [1, "a"], [2, 0]], 3])
def test_polygon_without_area_is_refused(robot_json, polygon):
    def use_polygon(plain):
        plain["left"].pop("length"), plain["left"].pop("width")
        plain["left"].update(polygon=polygon, sole_z=0.0)

    with pytest.raises(zmpwalk.InputError, match=r"left\.polygon.*corners"):
        zmpwalk.read_description(robot_json(use_polygon))


def test_scene_is_preferred_to_model(robot_json, tmp_path):
    scene = tmp_path / "scene.xml"
    shutil.copy(MAHRU, tmp_path)
    scene.write_text('<mujoco><include file="mahru.xml"/><worldbody><body name="crate"/></worldbody></mujoco>')
    model, _ = zmpwalk.load_robot(robot_json(lambda plain: plain.update(scene="scene.xml")))
    assert mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, "crate") > 0


@pytest.mark.parametrize(
    ("robot", "words"),
    [
        ("nao", ["unknown robot 'nao'", "mahru", "path"]),
        ("nowhere/robot.json", ["nowhere/robot.json", "no such file"]),
        ("robot.xml", ["robot.xml", "no such file"]),
        (3, ["name, a path", "int"]),
        ((1, 2, 3), ["pair", "3"]),
    ],
)
def test_robots_that_do_not_exist_are_named(robot, words):
    with pytest.raises(InputError) as caught:
        zmpwalk.load_robot(robot)
    for word in words:
        assert word in str(caught.value)


@pytest.mark.parametrize("text", ["<mujoco><worldbody>", "<mujoco><option nonsense='1'/></mujoco>", "<a/>", ""])
def test_malformed_xml_gives_mujocos_words_in_one_line(tmp_path, text):
    file = tmp_path / "bad.xml"
    file.write_text(text)
    with pytest.raises(ModelError, match=r"bad\.xml: MuJoCo cannot load it: \S") as caught:
        zmpwalk.load_robot(file)
    assert "\n" not in str(caught.value)


def test_model_without_marks_says_what_is_missing(tmp_path):
    file = tmp_path / "box.xml"
    file.write_text('<mujoco><worldbody><body><freejoint/><geom size="1"/></body></worldbody></mujoco>')
    with pytest.raises(ModelError, match="sole"):
        zmpwalk.load_robot(file)


@pytest.mark.parametrize(
    "key",
    ["root_joint", "left", "stand_joints", "stand_base_pos", "right.foot_body", "left.leg_joints", "left.sole_center"],
)
def test_missing_key_is_named_with_its_file(robot_json, key):
    def remove(plain):
        *where, last = key.split(".")
        (plain[where[0]] if where else plain).pop(last)

    with pytest.raises(InputError, match=f"robot.json: key '{key}' is missing: "):
        zmpwalk.load_robot(robot_json(remove))


def test_model_key_is_needed_to_load_but_not_to_read(robot_json):
    path = robot_json(lambda plain: plain.pop("model"))
    zmpwalk.read_description(path)
    with pytest.raises(InputError, match="'model' is missing"):
        zmpwalk.load_robot(path)


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("root_joint", 3),
        ("stand_base_pos", [0, 1]),
        ("stand_base_pos", [0, 1, float("nan")]),
        ("stand_joints", {"l_knee": "bent"}),
        ("left.length", 0),
        ("left.length", "long"),
        ("left.sole_center", ["a", "b", "c"]),
    ],
)
def test_value_of_the_wrong_kind_is_named(robot_json, key, value):
    def change(plain):
        *where, last = key.split(".")
        (plain[where[0]] if where else plain)[last] = value

    with pytest.raises(InputError, match=f"robot.json: key '{key}"):
        zmpwalk.load_robot(robot_json(change))


@pytest.mark.parametrize(("text", "word"), [("{", "not JSON"), ("[1]", "object"), ("", "not JSON")])
def test_file_that_is_no_json_object_is_named(tmp_path, text, word):
    file = tmp_path / "robot.json"
    file.write_text(text)
    with pytest.raises(InputError, match=rf"robot\.json: .*{word}"):
        zmpwalk.load_robot(file)


def test_description_of_another_robot_is_refused(robot_json):
    with pytest.raises(ModelError, match="nobody"):
        zmpwalk.load_robot(robot_json(lambda plain: plain["left"].update(foot_body="nobody")))


def test_dictionary_form_is_exact(mahru):
    plain = description_to_dict(mahru[1])
    assert description_to_dict(description_from_dict(json.loads(json.dumps(plain)))) == plain


def test_inspection_counts_the_paper_s_25_joints(mahru):
    found = inspect_robot(*mahru)
    assert found["roles"] == {"left leg": 6, "right leg": 6, "waist": 1, "left arm": 6, "right arm": 6}
    assert found["mass_kg"] == pytest.approx(mahru[0].body_mass.sum())
    assert found["T_c_s"] == pytest.approx(np.sqrt(found["com_height_m"] / 9.81), rel=1e-3)
    assert [joint["turns"] for joint in found["joints"] if joint["name"] == "l_knee"] == ["knee pitch"]
    json.dumps(found, allow_nan=False)


@pytest.mark.parametrize("name", ["robotis_op3", "unitree_g1", "fourier_n1"])
def test_third_party_robots_load_and_stand(test_robots, name):
    found = inspect_robot(*zmpwalk.load_robot(test_robots / name))
    facts = json.loads((test_robots / name / "robot.json").read_text())
    assert found["mass_kg"] == pytest.approx(facts["mass_kg"], rel=1e-3)
    assert found["com_height_m"] == pytest.approx(facts["com_height_m"], abs=2e-3)
    left, right = (found["feet"][side]["sole_center_m"] for side in ("left", "right"))
    assert left[1] - right[1] == pytest.approx(facts["foot_separation_m"], abs=2e-3)
