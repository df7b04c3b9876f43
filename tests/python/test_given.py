"""What may be given where a profile or settings go, and the one sentence that answers everything else."""

import numpy as np
import pytest
import zmpwalk
from zmpwalk import Error, VelocityProfile, WalkSettings, _core
from zmpwalk.given import settings_of
from zmpwalk.profiles import profile_of
from zmpwalk.view import LiveWalk

STEPS = VelocityProfile.piecewise([(0, 0.1), (2, (0.2, 0, 0.1))])
LONGEST = 200  # characters of a message


@pytest.fixture(scope="module")
def robot():
    return zmpwalk.load_robot("mahru")


@pytest.mark.parametrize(
    ("given", "profile"),
    [
        (None, VelocityProfile.paper()),
        ("paper", VelocityProfile.paper()),
        (0.2, VelocityProfile.constant(0.2)),
        (0, VelocityProfile.constant(0.0)),
        (np.float32(0.25), VelocityProfile.constant(0.25)),
        ("0.2", VelocityProfile.constant(0.2)),
        ((0.1, 0, 0.3), VelocityProfile.constant((0.1, 0, 0.3))),
        (np.array([0.1, 0, 0.3]), VelocityProfile.constant((0.1, 0, 0.3))),
        ([(0, 0.1), (2, (0.2, 0, 0.1))], STEPS),
        (((0, 0.1), (2, [0.2, 0, 0.1])), STEPS),
        (np.array([[0, 0.1], [2, 0.2]]), VelocityProfile.piecewise([(0, 0.1), (2, 0.2)])),
        ([(0, 0.1), (1, 0.2), (2, 0.3)], VelocityProfile.piecewise([(0, 0.1), (1, 0.2), (2, 0.3)])),
        ({0: 0.1, 2: (0.2, 0, 0.1)}, STEPS),
        ("0:0.1,2:0.2/0/0.1", STEPS),
        (STEPS, STEPS),
        (STEPS.to_dict(), STEPS),
        (_core.VelocityProfile(STEPS.t, STEPS.v, "hold"), STEPS),
    ],
)
def test_a_profile_may_be_given_in_any_of_its_forms(given, profile):
    assert profile_of(given) == profile
    assert isinstance(profile_of(given), VelocityProfile)


def test_a_profile_may_be_a_file(tmp_path):
    path = tmp_path / "walk.csv"
    path.write_text("t,vx\n0,0.1\n2,0.2\n")
    steps = VelocityProfile.piecewise([(0, 0.1), (2, 0.2)])
    assert profile_of(path) == profile_of(str(path)) == steps
    assert profile_of(f"{path}:linear").interpolation == "linear"


@pytest.mark.parametrize(
    ("given", "value"),
    [
        ("fast", '"fast"'),
        (True, "True"),
        (object(), "object"),
        ([], r"\[\]"),
        ((0.1, 0.2), r"\(0.1, 0.2\)"),
        ([0.1] * 1000, r"\[0.1, "),
        ([(0, 0.1), (2,)], r"\(2,\)"),
        ([(0, 0.1), ("soon", 0.2)], "'soon'"),
        ([(0, "fast")], "'fast'"),
        ([(0, (1, 2))], r"\(2,\)"),
        ({"a": 0.1}, "'a'"),
        ({}, "no knots"),
        (float("nan"), "nan"),
        (lambda t: 0.1, r"from_function\(f, duration\)"),
        ("no.csv", "no.csv"),
    ],
)
def test_anything_else_is_answered_in_a_sentence_with_the_value(given, value):
    with pytest.raises(Error, match=value) as caught:
        profile_of(given)
    assert len(str(caught.value)) < LONGEST and "\n" not in str(caught.value)


def test_settings_may_be_given_in_any_of_their_forms(tmp_path):
    path = tmp_path / "walk.toml"
    path.write_text('law = "paper"\ntracker_gain = 3.0\n')
    paper = WalkSettings(law="paper", tracker_gain=3.0)
    assert settings_of(None) == settings_of("default") == settings_of({}) == WalkSettings()
    assert settings_of("paper") == WalkSettings(law="paper")
    assert settings_of(path) == settings_of(str(path)) == settings_of({"law": "paper", "tracker_gain": 3}) == paper
    assert settings_of(paper) is paper


@pytest.mark.parametrize(
    ("given", "value"),
    [
        ("papr", "'papr'.*default, paper"),
        ("no.toml", "no.toml: no such file"),
        (3, "settings is 3; it must be WalkSettings"),
        ([("tracker_gain", 3)], "settings is .*tracker_gain"),
        ({"trackr_gain": 3}, "trackr_gain"),
        ({"tracker_gain": "much"}, "tracker_gain = 'much'"),
    ],
)
def test_other_settings_are_answered_with_the_value(given, value):
    with pytest.raises(Error, match=value) as caught:
        settings_of(given)
    assert "\n" not in str(caught.value)


def test_every_door_takes_them(robot, tmp_path):
    few = {"step_height": 0.03}
    expected = zmpwalk.simulate(robot, VelocityProfile.constant(0.1), 0.05, WalkSettings(step_height=0.03))
    assert zmpwalk.simulate(robot, profile=0.1, duration=0.05, settings=few) == expected
    run = {"robot": robot, "profile": "0.1", "duration": 0.05, "settings": few}
    assert zmpwalk.simulate_batch([run]) == [expected]
    controller = zmpwalk.WalkingController(*robot, few, 0.1)
    assert controller.profile == VelocityProfile.constant(0.1)
    assert controller.settings.step_height == 0.03
    assert zmpwalk.WalkingController(*robot, "paper", 0.0).settings.law == "paper"
    assert zmpwalk.walk_to([(1.0, 0.0)], robot, few, timeout=0.05).settings.step_height == 0.03
    assert LiveWalk(robot, few).controller.settings.step_height == 0.03


@pytest.mark.parametrize("given", [{"profile": object()}, {"settings": object()}])
def test_every_door_refuses_in_one_sentence(robot, given):
    for call in (
        lambda: zmpwalk.simulate(robot, **given),
        lambda: zmpwalk.simulate_batch([{"robot": robot, **given}]),
        lambda: zmpwalk.WalkingController(*robot, **given),
    ):
        with pytest.raises(zmpwalk.InputError, match="object") as caught:
            call()
        assert len(str(caught.value)) < LONGEST


@pytest.mark.parametrize(
    ("points", "limits", "said"),
    [
        (3, {}, "waypoints are 3; they are a list of"),
        ((1.0, 0.0), {}, "waypoint 0 is 1.0; it is"),
        ([(1, 0)], {"speed": "fast"}, "speed is 'fast'; it must be a number"),
        ([(1, 0)], {"pause": "long"}, "pause is 'long'; it must be a number"),
    ],
)
def test_waypoints_answer_in_a_sentence_too(points, limits, said):
    with pytest.raises(zmpwalk.InputError, match=said):
        zmpwalk.Waypoints(points, **limits)


def test_a_controller_says_what_it_is(robot):
    assert repr(zmpwalk.WalkingController(*robot, "paper")) == (
        "WalkingController(mahru, 25 joints, 62.9 kg, law paper)"
    )
