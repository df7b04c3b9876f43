# ruff: noqa: E501  (MJCF in one line)
"""Descriptions proposed for models that carry no marks; robots that cannot walk are refused in one line."""

import json
import re

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk import ModelError, cli
from zmpwalk.figures.robot import draw
from zmpwalk.robots import ROBOTS, appraise, description_to_dict, is_marked, propose, write_description
from zmpwalk.robots.polygon import inscribed_rectangle

SHARED = ("robotis_op3", "unitree_g1", "fourier_n1")
FROUDE = (0.03, 0.06, 0.0935)


def bare_xml(path):
    """The MJCF text without sole sites, the sensors on them and keyframes; an include is put in its place."""
    text = path.read_text()
    include = re.search(r'<include file="([^"]+)"\s*/>', text)
    if include:
        inner = re.sub(r"<!--.*?-->", "", (path.parent / include.group(1)).read_text(), flags=re.DOTALL)
        inner = re.sub(r"^.*?<mujoco[^>]*>|</mujoco>\s*$", "", inner, flags=re.DOTALL)
        text = text.replace(include.group(0), inner)
    text = re.sub(r"<keyframe>.*?</keyframe>", "", text, flags=re.DOTALL)
    text = re.sub(r'<[^<>]*(name|site|objname)="(left|right)_sole"[^<>]*/>', "", text)
    assert "_sole" not in re.sub(r"_link_sole\d|sole_box", "", text)
    return text


@pytest.fixture(scope="module")
def robot(request):
    """A robot's model and its files' description, and the text of the bare model."""

    def load(name):
        if name == "mahru":
            source, scene = "mahru", ROBOTS / "mahru.xml"
        else:
            folder = request.getfixturevalue("test_robots") / name
            source, scene = folder, folder / "scene.xml"
        model, description = zmpwalk.load_robot(source)
        return model, description, bare_xml(scene)

    return load


# --- robots whose answer is known


@pytest.mark.parametrize("name", ["mahru", *SHARED])
def test_proposed_soles_and_pendulum_time_are_those_of_the_files(robot, name):
    model, description, text = robot(name)
    bare = mujoco.MjModel.from_xml_string(text)
    assert not is_marked(bare)
    proposal, truth = propose(bare), appraise(model, description)
    for side in ("left", "right"):
        found, known = getattr(proposal.description, side), getattr(description, side)
        assert (found.body, found.leg_joints) == (known.body, known.leg_joints)
        assert [found.length, found.width] == pytest.approx([known.length, known.width], abs=0.003)
        assert np.asarray(found.sole_pos) == pytest.approx(np.asarray(known.sole_pos), abs=0.003)
        assert abs(np.asarray(found.sole_quat) @ np.asarray(known.sole_quat)) > 1 - 1e-5
    assert proposal.table["T_c_s"] == pytest.approx(truth.table["T_c_s"], rel=0.02)
    assert any("inverse kinematics" in remark for remark in proposal.remarks)


@pytest.mark.parametrize("name", ["mahru", *SHARED])
def test_proposed_stand_has_flat_soles_bent_knees_and_the_com_over_them(robot, name):
    bare = mujoco.MjModel.from_xml_string(robot(name)[2])
    proposal = propose(bare)
    description, data = proposal.description, mujoco.MjData(bare)
    description.place(bare, data)
    soles = []
    for foot in (description.left, description.right):
        body, R_sole = mujoco.mj_name2id(bare, mujoco.mjtObj.mjOBJ_BODY, foot.body), np.zeros(9)
        mujoco.mju_quat2Mat(R_sole, np.asarray(foot.sole_quat))
        R = data.xmat[body].reshape(3, 3)
        assert R @ R_sole.reshape(3, 3) == pytest.approx(np.eye(3), abs=1e-6)
        soles.append(data.xpos[body] + R @ np.asarray(foot.sole_pos))
        assert soles[-1][2] == pytest.approx(0.0, abs=1e-7)
    root = bare.jnt_bodyid[mujoco.mj_name2id(bare, mujoco.mjtObj.mjOBJ_JOINT, description.root_joint)]
    over = np.mean(soles, axis=0) + [description.stand_ahead(bare), 0, 0]  # where the ankles give the ZMP room
    assert data.subtree_com[root][:2] == pytest.approx(over[:2], abs=1e-6)
    assert proposal.table["leg_share"] == pytest.approx(0.915, abs=1e-4)
    for joint, angle in description.stand_joints.items():
        j = mujoco.mj_name2id(bare, mujoco.mjtObj.mjOBJ_JOINT, joint)
        if bare.jnt_limited[j]:
            assert bare.jnt_range[j][0] <= angle <= bare.jnt_range[j][1]


@pytest.mark.parametrize("name", ["mahru", *SHARED])
def test_robot_that_inspect_wrote_walks(robot, name, tmp_path):
    """10 s each; benchmarks/bare_robots.py walks 60 s and measures more."""
    *_, text = robot(name)
    (tmp_path / "bare.xml").write_text(text)
    assert cli.main(["inspect", str(tmp_path / "bare.xml"), "--write", str(tmp_path / "robot.json")]) == 0
    model, description = zmpwalk.load_robot(tmp_path / "robot.json")
    for froude in FROUDE:
        speed = froude * np.sqrt(9.81 * appraise(model, description).table["com_height_m"])
        profile = zmpwalk.VelocityProfile.ramp(0.0, speed, 3.0)
        trace = zmpwalk.simulate((model, description), profile=profile, duration=10.0)
        assert not trace.meta["fell"], trace.meta["fall_cause"]
        assert trace.torque_ratio.max() < 1.0
        summary = trace.summary()
        walked, planned = (np.array(summary[f"{kind}_speed_per_step"]) for kind in ("mean", "planned"))
        assert walked[6:] == pytest.approx(planned[6:], rel=0.01)


def test_one_controller_tells_all_there_is_to_tell_of_a_bare_model(robot, monkeypatch):
    made, controller = [], zmpwalk._core.WalkingController

    def make(*arguments, **options):
        made.append(controller(*arguments, **options))
        return made[-1]

    monkeypatch.setattr(zmpwalk._core, "WalkingController", make)
    bare = mujoco.MjModel.from_xml_string(robot("mahru")[2])
    description = zmpwalk.describe(bare)
    assert not made
    proposal = propose(bare)
    assert len(made) == 1
    assert description_to_dict(proposal.description) == description_to_dict(description)
    assert proposal.table["speed_limit_mps"] == made[0].speed_limit


def test_marks_and_keyframes_are_taken_where_they_are(robot):
    model, description, _ = robot("mahru")
    assert is_marked(model)
    assert description_to_dict(propose(model).description) == {**description_to_dict(description), "name": "pelvis"}
    text = (ROBOTS / "mahru.xml").read_text()
    unmarked = mujoco.MjModel.from_xml_string(re.sub(r'<[^<>]*"(left|right)_sole"[^<>]*/>', "", text))
    found = zmpwalk.describe(unmarked)
    assert found.stand_keyframe == "stand"
    assert found.stand_joints == description.stand_joints


def test_inspect_writes_a_file_that_walk_reads(tmp_path, capsys):
    (tmp_path / "models").mkdir()
    (tmp_path / "models" / "bare.xml").write_text(bare_xml(ROBOTS / "mahru.xml"))
    words = ["inspect", str(tmp_path / "models" / "bare.xml"), "--write", str(tmp_path / "robot.json")]
    assert cli.main(words) == 0
    shown = capsys.readouterr().out
    for word in ("0.250 × 0.140 m", "forward up to", "inverse kinematics", "robot.json"):
        assert word in shown
    content = json.loads((tmp_path / "robot.json").read_text())
    assert (content["name"], content["model"]) == ("bare", "models/bare.xml")
    model, description = zmpwalk.load_robot(tmp_path / "robot.json")
    expected = description_to_dict(propose(model).description)
    assert description_to_dict(description) == {**expected, "name": "bare"}
    assert cli.main([*words[:2], "--json"]) == 0
    table = json.loads(capsys.readouterr().out)
    assert table["roles"] == {"left leg": 6, "right leg": 6, "waist": 1, "left arm": 6, "right arm": 6}
    assert len(table["remarks"]) == len(set(table["remarks"])) == 1
    assert cli.main([*words[:3], str(tmp_path / "nowhere" / "robot.json")]) == 2
    assert "cannot write there" in capsys.readouterr().err


def test_what_a_walk_is_unsure_of_is_told(tmp_path, capsys):
    (tmp_path / "bare.xml").write_text(bare_xml(ROBOTS / "mahru.xml"))
    words = ["--robot", str(tmp_path / "bare.xml"), "--duration", "0.1", "--no-figures", "--out", str(tmp_path)]
    assert cli.main(["walk", *words]) == 0
    assert "zmpwalk: note: stand pose: by inverse kinematics" in capsys.readouterr().err


@pytest.mark.parametrize("renders", [True, False])
def test_figure_shows_both_soles_and_the_com(robot, renders, monkeypatch):
    def broken(*size):
        raise zmpwalk.Error("cannot draw off screen")

    if not renders:
        monkeypatch.setattr("zmpwalk.render.OffScreen", broken)
    model, description, _ = robot("mahru")
    figure = draw(model, appraise(model, description))
    above = figure.axes[-1]
    labels = above.get_legend_handles_labels()[1]
    sole = "rectangle taken as the sole, 250 × 140 mm"
    assert labels == ["can touch the ground", sole, "bounds of the ZMP", "ankle axes", "COM"]
    outlines = [patch.get_xy()[:-1] for patch in above.patches]
    assert np.ptp(outlines[2], axis=0) == pytest.approx([0.25, 0.14])
    assert np.mean(outlines[2], axis=0) == pytest.approx([0.0, 0.11])
    assert np.mean(outlines[6], axis=0) == pytest.approx([0.0, -0.11])
    told = [text.get_text() for ax in figure.axes[:2] for text in ax.texts]
    if renders and told:
        pytest.skip(told[0])
    assert told == ([] if renders else ["cannot draw off screen"])


def test_figure_is_written_by_inspect(tmp_path, capsys):
    assert cli.main(["inspect", "mahru", "--figure", str(tmp_path / "mahru.png")]) == 0
    assert (tmp_path / "mahru.png").read_bytes().startswith(b"\x89PNG")
    assert cli.main(["inspect", "mahru", "--figure", str(tmp_path / "no" / "mahru.png")]) == 2
    assert cli.main(["inspect", "mahru", "--figure", "mahru.jpeg"]) == 2
    assert "give a .png, .pdf or .svg" in capsys.readouterr().err


# --- soles


def rectangle(x0, x1, y0, y1):
    return np.array([[x, y] for x in (x0, x1) for y in (y0, y1)], float)


def test_rectangle_of_four_corners_is_itself():
    assert inscribed_rectangle(rectangle(-0.1, 0.15, -0.07, 0.05)) == pytest.approx((-0.1, 0.15, -0.07, 0.05))


def test_rectangle_in_a_trapezoid_keeps_its_length():
    points = np.array([[-0.05, -0.025], [-0.05, 0.025], [0.12, -0.03], [0.12, 0.03]])
    assert inscribed_rectangle(points) == pytest.approx((-0.05, 0.12, -0.025, 0.025))


def test_rectangle_in_a_rounded_outline_lies_inside_it():
    a = np.linspace(0, 2 * np.pi, 60, endpoint=False)
    x0, x1, y0, y1 = inscribed_rectangle(np.stack([0.12 * np.cos(a), 0.05 * np.sin(a)], axis=1))
    for x, y in rectangle(x0, x1, y0, y1):
        assert (x / 0.12) ** 2 + (y / 0.05) ** 2 < 1 + 1e-9
    assert (x1 - x0) * (y1 - y0) > 0.74 * 2 * 0.12 * 0.05


@pytest.mark.parametrize("points", [np.zeros((0, 2)), np.zeros((1, 2)), np.array([[0, 0], [0.1, 0.0]])])
def test_points_without_area_give_no_rectangle(points):
    x0, x1, y0, y1 = inscribed_rectangle(points)
    assert (x1 - x0) * (y1 - y0) == 0


# --- small robots written here

AXES = {"yaw": "0 0 1", "roll": "1 0 0", "pitch": "0 1 0"}
FOOT = '<geom type="box" size="0.1 0.05 0.01" pos="0.03 0 -0.05"/>'


def leg(side, joints, foot=FOOT, extra="", kind="hinge"):
    y = {"l": 0.1, "r": -0.1}[side]
    text, end = "", ""
    for i, role in enumerate(joints):
        pos = f"0 {y} -0.05" if i == 0 else "0 0 -0.3" if role in ("knee", "ankle_pitch") else "0 0 0"
        axis = AXES.get(role.split("_")[-1], AXES["pitch"])  # a knee pitches
        shape = foot if i == len(joints) - 1 else '<geom type="sphere" size="0.04" mass="1.5"/>'
        joint = (
            f'<joint name="{side}_{role}" type="{kind}" axis="{axis}"/>'
            if kind == "hinge"
            else f'<joint name="{side}_{role}" type="{kind}"/>'
        )
        text += f'<body name="{side}_{role}" pos="{pos}">{joint}{shape}{extra if i == len(joints) - 1 else ""}'
        end += "</body>"
    return text + end


SIX = ("hip_yaw", "hip_roll", "hip_pitch", "knee", "ankle_pitch", "ankle_roll")


def biped(
    left=None,
    right=None,
    base='<freejoint name="root"/>',
    more="",
    trunk="",
    actuators=None,
    joints=SIX,
    head="",
    turn="",
):
    left = leg("l", joints) if left is None else left
    right = leg("r", joints) if right is None else right
    names = re.findall(r'<joint name="(\w+)"', left + right + trunk)
    motors = "".join(f'<motor joint="{name}" ctrlrange="-200 200"/>' for name in names)
    return (
        f'<mujoco><compiler angle="radian" autolimits="true"/><option timestep="0.001"/>{head}'
        f'<worldbody><geom name="floor" type="plane" size="0 0 1"/>'
        f'<body name="trunk" pos="0 0 1" {turn}>{base}'
        f'<geom type="box" size="0.1 0.12 0.2" pos="0 0 0.15" mass="20"/>{left}{right}{trunk}</body></worldbody>'
        f"<actuator>{motors if actuators is None else actuators}</actuator>{more}</mujoco>"
    )


def describe(xml):
    return propose(mujoco.MjModel.from_xml_string(xml))


def test_smallest_biped_is_found():
    found = describe(biped()).description
    assert (found.left.body, found.right.body, found.root_joint) == ("l_ankle_roll", "r_ankle_roll", "root")
    assert found.left.leg_joints == [f"l_{role}" for role in SIX]
    assert (found.left.length, found.left.width) == pytest.approx((0.2, 0.1))
    assert np.asarray(found.left.sole_pos) == pytest.approx([0.03, 0, -0.06])


MESH = "".join(f" {x} {y} {z}" for x in (-0.07, 0.13) for y in (-0.05, 0.05) for z in (-0.06, -0.03))
FEET = {
    "spheres": "".join(
        f'<geom type="sphere" size="0.01" pos="{x} {y} -0.05"/>' for x in (-0.07, 0.13) for y in (-0.05, 0.05)
    ),
    "capsules": "".join(
        f'<geom type="capsule" size="0.01" fromto="-0.07 {y} -0.05 0.13 {y} -0.05"/>' for y in (-0.05, 0.05)
    ),
    "cylinders": "".join(
        f'<geom type="cylinder" size="0.01" fromto="{x} -0.05 -0.05 {x} 0.05 -0.05"/>' for x in (-0.07, 0.13)
    ),
    "a mesh": '<geom type="mesh" mesh="sole"/>',
    "a box on a welded body": f'<body name="SIDE_plate">{FOOT}</body>',
    "a box in pictures only": FOOT
    + '<geom type="box" size="0.2 0.1 0.01" pos="0 0 -0.1" contype="0" conaffinity="0"/>',
}


@pytest.mark.parametrize("kind", FEET)
def test_soles_of_every_geom(kind):
    feet = [leg(side, SIX, FEET[kind].replace("SIDE", side)) for side in "lr"]
    xml = biped(*feet, head=f'<asset><mesh name="sole" vertex="{MESH}"/></asset>')
    sole = describe(xml).description.left
    assert (sole.length, sole.width) == pytest.approx((0.2, 0.1), abs=1e-6)
    assert np.asarray(sole.sole_pos) == pytest.approx([0.03, 0, -0.06], abs=1e-6)


def test_waist_inside_the_leg_chain_belongs_to_no_leg():
    waist = f'<body name="pelvis" pos="0 0 -0.05"><joint name="waist" axis="0 0 1"/><geom size="0.05"/>{leg("l", SIX)}{leg("r", SIX)}</body>'
    found = describe(biped("", "", trunk=waist)).description
    assert found.left.leg_joints == [f"l_{role}" for role in SIX]
    assert found.stand_joints["waist"] == 0.0


def test_robot_that_faces_elsewhere_keeps_its_heading_and_its_left():
    found = describe(biped(turn='quat="1 0 0 1"')).description
    assert found.left.body == "l_ankle_roll"
    assert np.asarray(found.left.sole_quat) == pytest.approx([1, 0, 0, 0], abs=1e-6)
    assert np.asarray(found.stand_base_quat) == pytest.approx([np.sqrt(0.5), 0, 0, np.sqrt(0.5)])


def test_other_free_bodies_in_the_scene_do_not_matter():
    ball = '<worldbody><body name="ball" pos="2 0 0.1"><freejoint name="ball"/><geom size="0.1"/></body></worldbody>'
    mocap = (
        '<worldbody><body name="target" mocap="true"><geom size="0.1" contype="0" conaffinity="0"/></body></worldbody>'
    )
    assert describe(biped(more=ball + mocap)).description.root_joint == "root"


def test_toes_that_stick_out_and_missing_torque_limits_are_remarked():
    toe = '<body name="SIDE_toe" pos="0.13 0 -0.05"><joint name="SIDE_toe" axis="0 1 0"/><geom type="box" size="0.03 0.05 0.01" pos="0.03 0 0"/></body>'
    feet = [leg(side, SIX, extra=toe.replace("SIDE", side)) for side in "lr"]
    motors = "".join(f'<motor joint="{s}_{role}"/>' for s in "lr" for role in (*SIX, "toe"))
    proposal = describe(biped(*feet, actuators=motors))
    assert proposal.description.left.body == "l_ankle_roll"
    assert proposal.description.left.length == pytest.approx(0.26)
    assert any("toe" in remark for remark in proposal.remarks)
    assert any("torque limit" in remark for remark in proposal.remarks)


def test_arms_held_out_are_let_down():
    arms = "".join(
        f'<body name="{s}_arm" pos="0 {y} 0.3"><joint name="{s}_shoulder" axis="1 0 0" range="-2 2"/><geom type="capsule" size="0.03" fromto="0 {y / 3} 0 0 {2 * y} 0"/>'
        f'<body name="{s}_forearm" pos="0 {2 * y} 0"><joint name="{s}_elbow" axis="0 0 1" range="-2 2"/><geom type="capsule" size="0.03" fromto="0 {y / 3} 0 0 {y} 0"/></body></body>'
        for s, y in (("l", 0.2), ("r", -0.2))
    )
    proposal = describe(biped(trunk=arms))
    joints = proposal.description.stand_joints
    assert joints["l_shoulder"] == pytest.approx(-joints["r_shoulder"])
    assert joints["l_shoulder"] == pytest.approx(0.3 - np.pi / 2, abs=0.05)
    assert sum("let down" in remark for remark in proposal.remarks) == 2


@pytest.mark.parametrize("base", ['<freejoint name="root"/>', "<freejoint/>"])
def test_zero_speed_stand_of_the_proposal_holds(base):
    model = mujoco.MjModel.from_xml_string(biped(base=base))
    still = zmpwalk.VelocityProfile.constant(0.0)
    trace = zmpwalk.simulate((model, zmpwalk.describe(model)), profile=still, duration=4.0)
    assert not trace.meta["fell"]


# --- robots that cannot walk

FIVE = ("hip_yaw", "hip_roll", "hip_pitch", "knee", "ankle_pitch")
NO_ROLL = ("hip_yaw", "hip_roll", "hip_pitch", "knee", "ankle_pitch", "ankle_yaw")
WHEEL = '<geom type="cylinder" size="0.1 0.02" euler="1.5708 0 0"/>'
LOOP = '<equality><connect name="bar" body1="l_knee" body2="l_ankle_roll" anchor="0 0 0"/></equality>'
HELD = '<equality><weld name="hook" body1="trunk"/></equality>'
COUPLED = '<equality><joint name="cam" joint1="l_knee" joint2="l_hip_pitch"/></equality>'
TENDON = '<tendon><fixed name="cable"><joint joint="l_knee" coef="1"/></fixed></tendon>'
MOTORS = "".join(f'<motor joint="{s}_{role}" ctrlrange="-200 200"/>' for s in "lr" for role in SIX)
NO_KNEE = MOTORS.replace('<motor joint="l_knee" ctrlrange="-200 200"/>', "")
BOX = '<mujoco><worldbody><body name="crate"><freejoint name="root"/><geom size="1"/></body></worldbody></mujoco>'
CANNOT = {
    "an empty world": ("<mujoco/>", "no free joint"),
    "a free box": (BOX, "no legs"),
    "nothing that touches": (BOX.replace('size="1"', 'size="1" contype="0" conaffinity="0"'), "touch nothing"),
    "a fixed base": (biped(base=""), "fixed base: body 'trunk' has no free joint and is fixed to the world"),
    "one leg": (biped(right=""), "one leg: only body 'l_ankle_"),
    "three legs": (biped(trunk=leg("l", SIX).replace("l_", "third_").replace("0 0.1 ", "-0.3 0 ")), "3 links reach the ground"),
    "five joints a leg": (biped(joints=FIVE), "has 5 joints"),
    "seven joints a leg": (biped(joints=(*SIX[:3], "thigh_yaw", *SIX[3:])), "has 7 joints"),
    "no ankle roll": (biped(joints=NO_ROLL), "no ankle roll"),
    "no knee in fourth place": (biped(joints=("hip_pitch", "knee", "hip_yaw", "hip_roll", "ankle_pitch", "ankle_roll")), "knee"),
    "wheels": (biped(*(leg(s, (*FIVE[:4], "wheel_pitch"), WHEEL) for s in "lr")), "wheels: body 'l_wheel_pitch'"),
    "point feet": (biped(*(leg(s, SIX, '<geom size="0.02" pos="0 0 -0.05"/>') for s in "lr")), "point foot"),
    "short soles": (biped(*(leg(s, SIX, '<geom type="box" size="0.02 0.05 0.01" pos="0 0 -0.05"/>') for s in "lr")), "point foot"),
    "a ball joint": (biped(*(leg(s, ("hip", *SIX[3:4], "ankle"), kind="ball") for s in "lr"), actuators=""), "ball joint"),
    "a slide joint": (biped(left=leg("l", SIX).replace('name="l_knee" type="hinge"', 'name="l_knee" type="slide"')), "slide joint"),
    "a closed loop": (biped(more=LOOP), "closed loop: equality 'bar'"),
    "a base held by a weld": (biped(more=HELD), "equality 'hook' ties body 'trunk'"),
    "a coupled knee": (biped(more=COUPLED), "equality 'cam' couples leg joint"),
    "a knee on a tendon": (biped(more=TENDON, actuators=NO_KNEE + '<motor tendon="cable" name="winch"/>'), "'winch' drives leg joint 'l_knee' through a tendon"),
    "a foot without a name": (biped().replace('<body name="l_ankle_roll"', "<body"), "has no name"),
    "two robots": (
        biped(more="<worldbody>" + re.search(r'<body name="trunk".*</body>(?=</worldbody>)', biped(), re.DOTALL).group(0).replace('"0 0 1"', '"0 3 1"', 1).replace('="l_', '="b_l_').replace('="r_', '="b_r_').replace('"trunk"', '"other"').replace('"root"', '"b_root"') + "</worldbody>", actuators=MOTORS + MOTORS.replace('"l_', '"b_l_').replace('"r_', '"b_r_')),
        "2 robots with two legs",
    ),
}  # fmt: skip


@pytest.mark.parametrize("kind", CANNOT)
def test_robot_that_cannot_walk_is_told_why_in_one_line(kind):
    xml, words = CANNOT[kind]
    with pytest.raises(ModelError) as caught:
        describe(xml)
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


def test_all_reasons_are_told_a_line_each(tmp_path, capsys):
    feet = [leg(side, NO_ROLL) for side in "lr"]
    (tmp_path / "lame.xml").write_text(biped(*feet, actuators="", more=LOOP.replace("l_ankle_roll", "l_ankle_yaw")))
    assert cli.main(["inspect", str(tmp_path / "lame.xml")]) == 2
    told = capsys.readouterr().err.splitlines()
    for words in ("closed loop", "'l_ankle_yaw') has no ankle roll"):
        assert sum(words in line for line in told) == 1
    assert len(told) == 3  # the right ankle too
    with pytest.raises(ModelError, match=r"no ankle roll.*and 2 more reasons") as caught:
        zmpwalk.load_robot(tmp_path / "lame.xml")
    assert [f"zmpwalk: {reason}" for reason in caught.value.reasons] == told


def test_inactive_equality_is_no_loop():
    describe(biped(more=LOOP.replace("name=", 'active="false" name=')))


def test_knees_that_cannot_bend_are_named():
    stiff = leg("l", SIX).replace('name="l_knee" type="hinge"', 'name="l_knee" type="hinge" range="-0.02 0.1"')
    with pytest.raises(ModelError, match="l_knee is at the end of its range"):
        describe(biped(left=stiff))


def test_description_that_cannot_be_written_is_bad_input(tmp_path):
    with pytest.raises(zmpwalk.InputError, match="cannot write"):
        write_description(tmp_path / "no" / "robot.json", "bare.xml", describe(biped()))
