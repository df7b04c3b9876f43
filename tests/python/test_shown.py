"""How values show themselves: one line in a terminal, a table with a picture in a notebook."""

import base64
import re

import pytest
import zmpwalk
from zmpwalk import Trace, VelocityProfile, WalkSettings
from zmpwalk.shown import settings_changes


@pytest.fixture(scope="module")
def robot():
    return zmpwalk.load_robot("mahru")


@pytest.fixture(scope="module")
def controller(robot):
    return zmpwalk.WalkingController(*robot, {"tracker_gain": 3.0}, [(0, 0.1), (2, (0.2, 0, 0.1))])


def test_every_value_is_one_short_line_in_a_terminal(walked, robot, controller):
    for value in (walked, walked.profile, robot[1], WalkSettings(tracker_gain=3.0), controller):
        assert "object at 0x" not in repr(value)
        assert "\n" not in repr(value)
        assert len(repr(value)) < 200


def test_settings_print_the_call_that_makes_them_again():
    settings = WalkSettings(law="paper", tracker_gain=3.0, step_height=0.03)
    assert eval(repr(settings), {"WalkSettings": WalkSettings}) == settings
    assert settings_changes(settings) == {"tracker_gain": 3.0, "step_height": 0.03}
    assert repr(WalkSettings()) == "WalkSettings(law='default')"


def test_description_prints_its_feet(robot):
    assert repr(robot[1]) == (
        "RobotDescription(mahru, feet 'l_foot', 'r_foot', soles 0.250 × 0.140 m, 12 leg joints)"
    )  # fmt: skip


def cells(page):
    return re.findall(r"<t[dh][^>]*>(.*?)</t[dh]>", page)


def test_every_value_is_a_table_in_a_notebook(walked, robot, controller):
    for value in (walked, walked.profile, robot[1], WalkSettings(tracker_gain=3.0), controller):
        assert len(cells(value._repr_html_())) >= 4


@pytest.mark.parametrize("kind", ["trace", "profile", "controller"])
def test_what_goes_over_time_shows_a_picture(walked, controller, kind):
    page = {"trace": walked, "profile": walked.profile, "controller": controller}[kind]._repr_html_()
    (picture,) = re.findall(r"src='data:image/png;base64,([^']+)'", page)
    assert base64.b64decode(picture).startswith(b"\x89PNG")


def test_page_of_a_trace_says_what_its_summary_says(walked):
    said = dict(zip(*[iter(cells(walked._repr_html_()))] * 2))
    summary = walked.summary()
    assert said["walk"] == f"{walked.duration:g} s, stood"
    assert f"{summary['zmp_error_mm']['median'][0]:.2g}" in said["|estimated − measured ZMP|"]
    assert f"{summary['step_count']} steps" in said["went"]


def test_page_of_a_fall_says_when_and_why(made_up_columns, made_up):
    page = Trace(made_up_columns, made_up.meta(fell=True, fall_time=3.5, fall_cause="tilt & more"))._repr_html_()
    assert "fell at 3.50 s: tilt &amp; more" in page


def test_page_of_a_trace_with_few_columns_is_shown(made_up_columns):
    assert "2 of 1000 ms" in Trace({"t": [0.0, 1.0]})._repr_html_()


def test_page_of_settings_has_what_was_changed_with_its_meaning():
    assert cells(WalkSettings(tracker_gain=3.0)._repr_html_())[4:6] == ["tracker_gain", "3.0"]
    assert "default" in WalkSettings()._repr_html_()


def test_page_of_a_long_profile_is_short():
    page = VelocityProfile.from_function(lambda t: 0.1, 100.0)._repr_html_()
    assert cells(page).count("…") == 4
    assert len(cells(page)) < 50


@pytest.mark.parametrize("arguments", [("inspect", "mahru"), ("settings", "mahru"), ("walk", "--help"), ("plot", "-h")])
def test_nothing_on_a_terminal_is_wider_than_80_columns_or_cut_off(zmpwalk_command, arguments, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    done = zmpwalk_command(*arguments)
    assert done.returncode == 0, done.stderr
    assert max(map(len, done.stdout.splitlines())) <= 80
    assert "…" not in done.stdout


def test_film_shows_and_saves_itself(walked, tmp_path):
    pytest.importorskip("imageio")
    try:
        film = walked.video(fps=2, width=64, height=48, speed=2.0)
    except zmpwalk.Error as error:
        pytest.skip(str(error))
    assert film._repr_html_().startswith("<video ")
    assert film.save(tmp_path / "walk.mp4").read_bytes()[4:8] == b"ftyp"
    with pytest.raises(zmpwalk.InputError, match=r"this film is a \.mp4"):
        film.save(tmp_path / "walk.gif")
    gif = walked.video(tmp_path / "walk.gif", fps=2, width=64, height=48, speed=2.0)
    assert gif.path.read_bytes().startswith(b"GIF8")
    assert gif._repr_html_().startswith("<img ")
