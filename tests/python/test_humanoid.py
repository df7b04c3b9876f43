"""robots/humanoid.py: a humanoid has the measures that were asked for, walks, or is refused with the reason."""

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk import cli

SMALL = {"height": 1.2, "mass": 40.0, "foot": (0.2, 0.1)}


def of(model, kind, name):
    found = mujoco.mj_name2id(model, kind, name)
    assert found >= 0, name
    return found


def test_the_model_has_the_measures_that_were_asked_for():
    made = zmpwalk.humanoid(**SMALL, leg=0.6, thigh=0.45, hips=0.2)
    model, description = made.robot
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    assert model.body_subtreemass[1] == pytest.approx(40.0, abs=1e-6)
    assert (description.left.length, description.left.width) == pytest.approx((0.2, 0.1), abs=1e-6)
    joint = mujoco.mjtObj.mjOBJ_JOINT
    hip, knee, ankle = (data.xanchor[of(model, joint, f"left_{j}")] for j in ("hip_p", "knee", "ankle_p"))
    assert np.linalg.norm(hip - knee) == pytest.approx(0.45 * 0.6, abs=1e-9)
    assert np.linalg.norm(knee - ankle) == pytest.approx(0.55 * 0.6, abs=1e-9)
    right = data.xanchor[of(model, joint, "right_hip_p")]
    assert hip[1] - right[1] == pytest.approx(0.2, abs=1e-9)
    head = max(data.geom_xpos[i, 2] + model.geom_size[i, 2] for i in range(model.ngeom) if model.geom_bodyid[i])
    assert head == pytest.approx(1.2, abs=1e-6)


@pytest.mark.parametrize("height", [0.5, 1.2, 2.0])
def test_humanoids_of_every_height_walk_with_the_defaults_alone(height):
    made = zmpwalk.humanoid(height=height)
    speed = 0.06 * np.sqrt(9.81 * made.measures["leg"])
    trace = zmpwalk.simulate(made.robot, zmpwalk.VelocityProfile.ramp(0.0, speed, 3.0), duration=8.0)
    assert not trace.meta["fell"]
    assert trace.torque_ratio.max() < 1.0
    assert trace.summary()["mean_speed_per_step"][-1] == pytest.approx(speed, rel=0.01)


@pytest.mark.parametrize(
    ("measures", "says"),
    [
        ({"height": 5.0}, r"height is 5; it must be 0\.3 to 3 m"),
        ({"height": float("nan")}, "height is nan"),
        ({"height": "tall"}, "height is 'tall'; it must be a number"),
        ({"height": 1.2, "leg": 0.72, "ankle": 0.15}, "for the torso, which needs"),
        ({"height": 1.2, "leg": 0.9}, "leg is 0.9"),
        ({"foot": (0.2, 0.5)}, "the feet touch each other"),
        ({"foot": (0.2,)}, "length and width"),
        ({"mass": 1.0}, "mass is 1; it must be"),
        ({"waist": "z"}, "waist is 'z'"),
        ({"arms": 1}, "arms is 1; it must be 0, or 2 to 7"),
        ({"neck": 3}, "neck is 3"),
    ],
)
def test_a_measure_that_no_such_robot_has_is_refused_with_the_rule(measures, says):
    with pytest.raises(zmpwalk.InputError, match=says):
        zmpwalk.humanoid(**measures)


def test_a_humanoid_that_cannot_walk_is_refused_with_the_reason():
    with pytest.raises(zmpwalk.ModelError, match=r"cannot walk: left_knee cannot hold the robot on one foot: limit"):
        zmpwalk.humanoid(torque=0.5)


def test_the_command_writes_an_mjcf_that_walks(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    words = ["humanoid", "--height", "1.2", "--mass", "40", "--foot", "0.2,0.1", "--out", "small.xml"]
    assert cli.main(words) == 0
    assert "written: small.xml" in capsys.readouterr().out
    assert (tmp_path / "small.xml").read_text() == zmpwalk.humanoid(**SMALL).xml
    walk = ["walk", "--robot", "small.xml", "--profile", "0:0,1:0.2", "--duration", "3", "--no-figures", "--out", "w"]
    assert cli.main(walk) == 0


@pytest.mark.parametrize("words", [["--torque", "0.5"], ["--height", "9"], ["--foot", "long"]])
def test_the_command_refuses_in_one_line(words, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert cli.main(["humanoid", *words]) == 2
    said = capsys.readouterr().err.strip().splitlines()
    assert len(said) == 1 and said[0].startswith("zmpwalk: ")
    assert not list(tmp_path.iterdir())
