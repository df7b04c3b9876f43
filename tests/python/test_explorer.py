"""Sliders: moving one walks again and draws that walk; a walk that cannot be says why below them."""

import pytest
import zmpwalk
from zmpwalk import InputError

pytest.importorskip("ipywidgets")


def test_a_slider_that_moves_walks_again_and_draws_that_walk():
    shown = zmpwalk.explore("lateral", duration=1.0, profile=(0.0, 0.5), step_height=(0.02, 0.06))
    before = bytes(shown._picture.value)
    assert before.startswith(b"\x89PNG")
    shown.sliders["profile"].value = 0.4
    assert shown.values["profile"] == 0.4
    assert shown.trace.v_plan[-1, 0] == pytest.approx(0.4, abs=0.2)
    assert bytes(shown._picture.value) != before
    shown.sliders["step_height"].value = 0.05
    assert shown.trace.settings.swing.height == 0.05
    assert shown._words.value == "it stood"
    assert "step_height=0.05" in repr(shown)


def test_what_cannot_walk_is_said_and_the_picture_stays():
    shown = zmpwalk.explore(duration=0.5, profile=(0.1, 90.0))
    picture = bytes(shown._picture.value)
    shown.sliders["profile"].value = 80.0
    assert shown.trace is None and "the profile asks for" in shown._words.value
    assert bytes(shown._picture.value) == picture


def test_a_list_gives_a_choice():
    shown = zmpwalk.explore(duration=0.2, first_swing=["right", "left"])
    assert shown.trace.settings.gait.first_swing == "right"
    shown.sliders["first_swing"].value = "left"
    assert shown.trace.settings.gait.first_swing == "left"


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"figure": "sagital"}, "no figure 'sagital'"),
        ({"speeed": (0, 1)}, "'speeed' is no argument of simulate"),
        ({"profile": (1.0, 0.0)}, "the range of 'profile'"),
        ({"profile": 0.3}, "the range of 'profile'"),
    ],
)
def test_what_makes_no_sense_is_refused(given, words):
    with pytest.raises(InputError, match=words):
        zmpwalk.explore(duration=0.2, **given)
