"""A fall that is seen coming: in time, for a reason in words, and never where the robot walks on."""

import json
import os

import numpy as np
import pytest
import zmpwalk
from zmpwalk import VelocityProfile, WalkSettings, simulate

PROFILE = VelocityProfile.ramp(0.0, 0.25, 1.25)
MASS = 62.9  # of the bundled robot [kg]
LIFT_OFF = 4.981  # of the right foot [s]


def pushed(impulse, settings=None, after=3.0, on_fall="go_on"):
    """Pushed outwards just after a lift-off, the worst of all pushes, by an impulse in N s/kg."""
    push = [(LIFT_OFF, 0.08, None, (0, MASS * impulse / 0.08, 0))]
    return simulate(profile=PROFILE, duration=LIFT_OFF + after, push=push, on_fall=on_fall, settings=settings)


@pytest.fixture(scope="module")
def lost():
    return pushed(0.3)


def tilt(trace):
    _, x, y, _ = trace.qpos[:, 3:7].T
    return np.degrees(np.arccos(1 - 2 * (x**2 + y**2)))


@pytest.mark.parametrize("impulse", [0.27, 0.4, 0.5])
def test_the_fall_is_foreseen_before_the_trunk_tilts_and_no_joint_is_whirled(impulse):
    trace = pushed(impulse)
    assert trace.fall.foreseen < trace.t[tilt(trace) > 10][0] - 0.2
    assert np.abs(trace.qvel[trace.t > trace.fall.foreseen + 0.002, 6:]).max() < 10.0


def test_the_announcement_says_when_and_why(lost):
    assert lost.fall.foreseen < lost.t[tilt(lost) > 10][0] - 0.2
    assert "m beyond what any foothold within reach can catch" in lost.fall.foreseen_cause
    assert lost.fall.foreseen < lost.fall.time == lost.meta["fall_time"]
    assert lost.fall.cause == "the robot lay on the ground"
    assert lost.t[lost.fall_foreseen > 0][0] == pytest.approx(lost.fall.foreseen, abs=0.002)


def test_the_crouch_keeps_torques_and_speeds_low_until_the_robot_lies(lost):
    crouching = lost.t > lost.fall.foreseen + 0.002
    assert np.all(np.abs(lost.tau) <= np.array(lost.meta["torque_limits"]) + 1e-9)
    assert np.abs(lost.qvel[crouching, 6:]).max() < 10.0
    assert lost.com[-1, 2] < lost.com[crouching, 2][0] < 0.76


def test_where_a_walk_ends_by_the_word_of_the_controller_everything_is_written(tmp_path):
    trace = pushed(0.3, on_fall="stop")
    assert trace.meta["fell"] and trace.fell[-1] == 1 and trace.fell.sum() == 1
    assert trace.fall.foreseen < trace.fall.time
    summary = json.loads(json.dumps(trace.summary(), allow_nan=False))
    assert summary["foreseen_time"] == trace.fall.foreseen
    assert trace.rerun() == trace
    assert zmpwalk.Trace.load(trace.save(tmp_path / "walk.npz")).fall == trace.fall


def test_a_robot_that_catches_itself_has_no_fall():
    trace = pushed(0.25)
    assert trace.fall is None
    assert trace.fall_gap.max() == 0.0


def test_a_fall_that_may_not_be_foreseen_is_told_when_it_has_come():
    trace = pushed(0.3, WalkSettings(fall_foresee=False), on_fall="stop")
    assert trace.fall.foreseen is None and trace.fall.time is not None
    assert np.isnan(trace.fall_gap).all()


@pytest.mark.skipif(not os.environ.get("ZMPWALK_BIG"), reason="ZMPWALK_BIG is not set: whole push maps take minutes")
@pytest.mark.parametrize("velocity", [0.25, 0.0])
def test_no_push_that_is_survived_is_called_a_fall(velocity):
    """With the crouch, a false alarm would be a fall: the map would be smaller than without."""
    maps = [
        zmpwalk.push_map(velocity=velocity, directions=8, phases=8, stances=["left"], settings={"fall_crouch": crouch})
        for crouch in (True, False)
    ]
    np.testing.assert_array_equal(*(each.felling for each in maps))
