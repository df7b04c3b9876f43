# ruff: noqa: E501  (MJCF in one line)
"""The rules of a model stand once, in C++: inspect, load and controller tell the same sentences, all of them."""

import ast
import re
from pathlib import Path

import mujoco
import pytest
import zmpwalk
from mahru_text import TEXT, bare, edited
from zmpwalk import ModelError, _core, cli
from zmpwalk.robots import description_from_dict, description_to_dict

CPP = Path(__file__).parents[2] / "cpp"
PYTHON = Path(__file__).parents[2] / "python"


def add(section):
    return ("<actuator>", section + "<actuator>")


SIDEWAYS = ("<option ", '<option gravity="1 0 -9.81" ')
CLASP = add('<equality><connect name="clasp" body1="l_hand" body2="r_hand" anchor="0 0 0"/></equality>')
CAM = add('<equality><joint name="cam" joint1="l_knee" joint2="r_elbow"/></equality>')
BAND = add('<tendon><fixed name="band" limited="true" range="0 1"><joint joint="l_knee" coef="1"/></fixed></tendon>')
PUSH = ("</actuator>", '<motor name="push" joint="root" gear="0 0 1 0 0 0"/></actuator>')

BROKEN = {
    "one rule": ([CLASP], ["equality"]),
    "three rules": ([SIDEWAYS, CLASP, PUSH], ["equality", "actuator", "gravity"]),
    "two of one rule": ([CLASP, CAM], ["equality", "equality"]),
    "a tendon at a leg": ([BAND], ["tendon"]),
}


@pytest.fixture(scope="module")
def description():
    return zmpwalk.load_robot("mahru")[1]


@pytest.mark.parametrize("form", ["marked", "bare"])
@pytest.mark.parametrize("kind", BROKEN)
def test_inspect_tells_the_reasons_of_the_core_and_all_of_them(kind, form, description, tmp_path, capsys):
    changes, rules = BROKEN[kind]
    text = edited(*changes)
    reasons = _core.model_reasons(mujoco.MjModel.from_xml_string(text), description)
    assert [rule for rule, _ in reasons] == rules
    file = tmp_path / "robot.xml"
    file.write_text(text if form == "marked" else bare(text))
    assert cli.main(["inspect", str(file)]) == 2
    assert capsys.readouterr().err.splitlines() == [f"zmpwalk: {sentence}" for _, sentence in reasons]
    with pytest.raises(ModelError) as caught:
        zmpwalk.load_robot(file)
    assert list(caught.value.reasons) == [sentence for _, sentence in reasons]


def test_an_error_of_the_core_keeps_its_reasons_and_is_one_line(description):
    model = mujoco.MjModel.from_xml_string(edited(SIDEWAYS, CLASP, PUSH))
    with pytest.raises(ModelError) as caught:
        zmpwalk.WalkingController(model, description)
    first, *more = caught.value.reasons
    assert len(more) == 2
    assert str(caught.value) == f"{first} (and 2 more reasons: zmpwalk inspect lists all)"


@pytest.mark.parametrize("name", ["mahru", "robotis_op3", "unitree_g1", "fourier_n1"])
def test_robots_that_walk_break_no_rule(name, request):
    robot = name if name == "mahru" else request.getfixturevalue("test_robots") / name
    model, description = zmpwalk.load_robot(robot)
    assert _core.model_reasons(model) == _core.model_reasons(model, description) == []
    zmpwalk.Robot(model, description)


def test_a_start_pose_that_breaks_two_rules_is_told_twice(description):
    plain = description_to_dict(description)
    plain["stand_base_pos"][2] += 0.1
    broken = description_from_dict(plain)
    remarks = zmpwalk.robots.proposal.appraise(zmpwalk.load_robot("mahru")[0], broken).remarks
    assert [re.sub(r" is tilted.*", "", text) for text in remarks if "refuses" in text] == [
        f"the walking controller refuses it: at the start pose the {side} sole" for side in ("left", "right")
    ]


# --- a base on slides, balls and hinges

FREE = '<freejoint name="root"/>'
SLIDES = "".join(f'<joint name="{a}" type="slide" axis="{v}"/>' for a, v in (("x", "1 0 0"), ("y", "0 1 0"), ("z", "0 0 1")))  # fmt: skip
BASES = {
    "slides and a ball": (SLIDES + '<joint name="turn" type="ball"/>', "'x' (slide), 'y' (slide), 'z' (slide), 'turn' (ball)"),
    "slides and a hinge": (SLIDES + '<joint name="pitch" axis="0 1 0"/>', "'x' (slide), 'y' (slide), 'z' (slide), 'pitch' (hinge)"),
    "a ball": ('<joint name="turn" type="ball"/>', "'turn' (ball)"),
    "a hinge": ('<joint name="pitch" axis="0 1 0"/>', "'pitch' (hinge)"),
}  # fmt: skip
CRATE = (
    "<worldbody>",
    '<worldbody><body name="crate" pos="3 0 1"><freejoint/><inertial mass="1" pos="0 0 0" diaginertia="0.1 0.1 0.1"/><geom size="0.2"/></body>',
)


@pytest.mark.parametrize("scene", ["alone", "beside a free crate"])
@pytest.mark.parametrize("kind", BASES)
def test_joints_that_hold_the_base_are_named_with_what_to_put_in_their_place(kind, scene, tmp_path, capsys):
    joints, names = BASES[kind]
    changes = [(FREE, joints)] + [CRATE] * (scene != "alone")
    file = tmp_path / "held.xml"
    file.write_text(bare(edited(*changes)))
    assert cli.main(["inspect", str(file)]) == 2
    told = capsys.readouterr().err
    assert told.count("\n") == 1
    assert f"body 'pelvis' hangs from the world by {names} and has no free joint" in told
    written = re.search(r"write (<freejoint.*?/>) in body 'pelvis' in place of", told).group(1)
    zmpwalk.propose(mujoco.MjModel.from_xml_string(bare(edited(*changes)).replace(joints, written)))  # so it is found


# --- a sole on the wrong link of the ankle


def on_the_pitch_link(text):
    for side in "lr":
        joint = f'<joint class="ankle_pitch" name="{side}_ankle_pitch"/>'
        geom = f'<geom class="sole_box" name="{side}_foot"/>'
        assert joint in text
        assert geom in text
        text = text.replace(geom, "").replace(joint, joint + geom)
    return text


def test_sole_on_the_ankles_other_link_is_told_with_the_joint_below_and_the_right_link(tmp_path, capsys):
    file = tmp_path / "pitch.xml"
    file.write_text(bare(on_the_pitch_link(TEXT)))
    assert cli.main(["inspect", str(file)]) == 2
    told = capsys.readouterr().err.splitlines()
    assert len(told) == 2
    for side, line in zip("lr", told):
        assert "has 5 joints" in line
        assert f"below body '{side}_ankle' hangs joint '{side}_ankle_roll'" in line
        assert f"the sole's geoms and site belong to body '{side}_foot'" in line


# --- one wording, in one language

WORDS = 6  # in a row that two texts may not share


def runs(text):
    """All runs of so many words in a text."""
    words = re.findall(r"[\w-]+", text.lower())
    return {" ".join(words[i : i + WORDS]) for i in range(len(words) - WORDS + 1)}


def texts_of_cpp(path):
    """String literals, those that follow each other as one; what is put in between them cuts."""
    code = re.sub(r"//.*", "", path.read_text())
    for text in re.findall(r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*', code):
        yield re.sub(r'"\s*"', "", text)


def texts_of_python(path):
    """String literals without docstrings."""
    tree = ast.parse(path.read_text())
    docs = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in docs:
            yield node.value


def test_no_rule_is_worded_in_both_languages():
    in_cpp = {
        run for path in (CPP / "src" / "robot").rglob("*.cpp") for text in texts_of_cpp(path) for run in runs(text)
    }
    in_python = {run for path in (PYTHON / "zmpwalk").rglob("*.py") for text in texts_of_python(path) for run in runs(text)}  # fmt: skip
    assert len(in_cpp) > 200
    assert len(in_python) > 500
    assert in_cpp & in_python == set()
