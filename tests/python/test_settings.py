"""Settings in groups, by one table; in TOML files what is printed reads back; mistakes are named."""

import copy
import pickle
import re
from pathlib import Path

import pytest
import zmpwalk
from zmpwalk import InputError, ModelError, WalkSettings, cli, load_settings, settings_toml


@pytest.fixture
def toml(tmp_path):
    def write(text):
        path = tmp_path / "walk.toml"
        path.write_text(text)
        return path

    return write


@pytest.fixture(scope="module")
def mahru():
    return zmpwalk.load_robot("mahru")


# --- groups


def test_every_setting_has_a_path_and_one_word_for_the_same_value():
    settings = WalkSettings()
    for path, row in WalkSettings.table().items():
        assert path == f"{row.group}.{row.name}"
        assert WalkSettings.find(path).flat == WalkSettings.find(row.flat).flat == row.flat
        group = getattr(settings, row.group)
        assert repr(getattr(group, row.name)) == repr(getattr(settings, row.flat)) == repr(row.default)
        value = {
            "bool": not row.default,
            "int": 7,
            "float": 0.125,
            "list[float]": [0.25],
            "dict[str, float]": {"a": 2.0},
        }
        new = row.words[-1] if row.words else value.get(row.type, "word")
        setattr(group, row.name, new)
        assert getattr(settings, row.flat) == new
        assert WalkSettings(**{row.flat: new}) == WalkSettings(**{row.group: {row.name: new}})
        assert WalkSettings(**{path: new}) == WalkSettings(**{row.flat: new}) != WalkSettings()
    assert list(settings.to_dict()) == ["law", *(row.flat for row in WalkSettings.table().values())]


def test_groups_are_attributes_that_reach_into_the_settings():
    settings = WalkSettings(tracking={"gain": 3, "law": "bang_bang"}, tracker_time=0.04)
    assert (settings.tracker_gain, settings.tracker, settings.tracking.time) == (3.0, "bang_bang", 0.04)
    settings.tracking.gain = 4.0
    assert settings.tracker_gain == 4.0
    settings.tracking = {"gain": 5.0}  # the others stay
    assert (settings.tracking.gain, settings.tracking.law) == (5.0, "bang_bang")
    other = WalkSettings(tracking=settings.tracking)
    assert other.tracking == settings.tracking
    other.tracking.gain = 6.0  # a copy
    assert settings.tracking.gain == 5.0
    gait = WalkSettings(T_ss=0.5).gait  # outlives the settings that it came from
    assert gait.T_ss == 0.5
    assert WalkSettings(steps={"mode": [0.1, 0.2]}).steps.lengths == [0.1, 0.2]
    assert WalkSettings(steps={"mode": [0.1, 0.2]}).footsteps == "list"


def test_groups_copy_pickle_compare_and_print():
    fall = WalkSettings(fall_tilt=0.5).fall
    for other in (copy.copy(fall), copy.deepcopy(fall), pickle.loads(pickle.dumps(fall))):
        assert other == fall
        other.tilt = 0.6
        assert other != fall
    known = {name: fall.to_dict()[name] for name in ("height", "tilt", "foot_tilt")}
    assert known == {"height": 0.8, "tilt": 0.5, "foot_tilt": 0.45}
    assert repr(fall).startswith("FallSettings({'height': 0.8, 'tilt': 0.5, 'foot_tilt': 0.45")


@pytest.mark.parametrize(
    ("keywords", "message"),
    [
        ({"trackr_gain": 3}, "there is no setting 'trackr_gain'; did you mean tracking.gain (tracker_gain)?"),
        ({"tracking": {"gian": 3}}, "no setting 'tracking.gian'; did you mean tracking.gain (tracker_gain)?"),
        ({"trackng": {"gain": 3}}, "no setting 'trackng'; did you mean the group tracking?"),
        ({"tracking": 3}, "tracking = 3 is of the wrong type; it is a group of settings"),
        ({"tracking": {"gain": "3"}}, "tracking.gain = '3' is of the wrong type; it must be a number [1/s]"),
        ({"tracking": {"law": "smoth"}}, "tracking.law = 'smoth' is unknown; there are: smooth, bang_bang"),
        ({"steps": WalkSettings().fall}, "it is a group of settings"),
        ({"zzz": 1}, "the groups are gait, steps, "),
    ],
)
def test_a_wrong_name_in_a_group_is_answered_with_the_nearest(keywords, message):
    with pytest.raises(InputError) as caught:
        WalkSettings(**keywords)
    assert message in str(caught.value)


def test_a_refused_change_changes_nothing():
    settings = WalkSettings(tracker_gain=3.0)
    before = settings.to_dict()
    with pytest.raises(InputError, match=r"steps\.width = 'x'"):
        settings.update(tracking={"gain": 4.0}, steps={"width": "x"})
    with pytest.raises(InputError, match="did you mean"):
        settings.tracking = {"gain": 4.0, "tme": 1.0}
    with pytest.raises(AttributeError):
        settings.tracking.gian = 3.0
    with pytest.raises(AttributeError):
        settings.trackng = 3.0
    assert repr(settings.to_dict()) == repr(before)
    settings.update(tracking={"gain": 4.0}, T_ss=0.6)
    assert (settings.tracking.gain, settings.gait.T_ss) == (4.0, 0.6)


def test_every_text_stands_alone_with_unit_and_default():
    for path, row in WalkSettings.table().items():
        assert row.meaning.endswith("."), path
        assert row.text.startswith(row.meaning)
        assert "Default: " in row.text
        assert (row.default != row.default) == bool(row.rule)  # NaN: from the robot
        assert path + ":" in getattr(WalkSettings, row.flat).__doc__
        assert row.text in getattr(type(getattr(WalkSettings(), row.group)), row.name).__doc__
        names = row.name if row.name == row.flat else f"{row.name} ({row.flat})"
        assert f"    {names}: {row.text}\n" in WalkSettings.__init__.__doc__


def test_notation_names_settings_that_exist_and_no_values():
    text = (Path(__file__).parents[2] / "cpp" / "NOTATION.md").read_text(encoding="utf-8")
    numbers = text.split("## Numbers")[1].split("## ")[0]
    rows = [line.split("|")[1] for line in numbers.splitlines() if line.startswith("| `")]
    assert len(rows) > 5
    for name in re.findall(r"`(\w+\.\w+)`", "".join(rows)):
        assert WalkSettings.find(name)
    assert not re.search(r"\d", "".join(rows))


def test_the_laws_are_words_and_the_help_says_what_each_does():
    for path, words in (("zmp.lateral_law", ["orbit", "paper"]), ("tracking.law", ["smooth", "bang_bang"])):
        row = WalkSettings.find(path)
        assert row.words[:2] == words
        assert row.default == words[0]
        for word in row.words:
            assert re.search(rf"'{word}', which \w+", row.text), row.text
    with pytest.raises(
        InputError, match=r"lateral_law = 'orbt' is unknown; there are: orbit, paper.*; did you mean 'orbit'"
    ):
        WalkSettings(lateral_law="orbt")


@pytest.mark.parametrize(("was", "law"), [(True, "orbit"), (False, "paper")])
def test_lateral_feedback_is_still_taken_for_the_law_that_it_stands_for(toml, capsys, was, law):
    word = str(was).lower()
    for settings in (
        WalkSettings(lateral_feedback=was),
        WalkSettings(zmp={"lateral_feedback": was}),
        WalkSettings(**{"zmp.lateral_feedback": was}),
        load_settings(toml(f"lateral_feedback = {word}")),
        load_settings(toml(f"[zmp]\nlateral_feedback = {word}")),
    ):
        assert settings == WalkSettings(lateral_law=law)
        assert settings.lateral_feedback is was
    settings = WalkSettings(law="paper")
    settings.lateral_feedback = was
    assert settings.zmp.lateral_law == law
    for name in ("lateral_feedback", "zmp.lateral_feedback"):
        assert cli.main(["settings", "mahru", "--law", "paper", "--set", f"{name}={word}"]) == 0
        assert f'lateral_law = "{law}"' in capsys.readouterr().out
    with pytest.raises(InputError, match="lateral_feedback = 'orbit' is of the wrong type; it must be true or false"):
        WalkSettings(lateral_feedback="orbit")
    assert "lateral_feedback" not in settings.to_dict()
    assert "zmp.lateral_law now" in WalkSettings.find("lateral_feedback").text


# --- files


def test_a_file_is_its_settings(toml):
    flat = toml(
        'law = "paper"\nstep_height = 0.03\nfeed_forward = true\nfootsteps = [0.1, 0.12]\n[torque_limits]\nl_knee = 90'
    )
    expected = WalkSettings(
        law="paper", step_height=0.03, feed_forward=True, footsteps=[0.1, 0.12], torque_limits={"l_knee": 90.0}
    )
    assert load_settings(flat) == expected
    assert load_settings(flat, law="default", step_height=0.05).step_height == 0.05
    assert load_settings(flat, law="default").tracker == "smooth"
    groups = toml(
        'law = "paper"\n[swing]\nheight = 0.03\n[com]\nfeed_forward = true\n[steps]\nmode = [0.1, 0.12]\n'
        "[control.torque_limits]\nl_knee = 90"
    )
    assert load_settings(groups) == expected
    assert load_settings(groups, swing={"kp": 9.0}).swing.height == 0.03  # of a table only what is named changes
    assert load_settings(groups, step_height=0.05).swing.height == 0.05
    assert load_settings(toml("")) == WalkSettings()


@pytest.mark.parametrize(
    "given",
    [
        WalkSettings(),
        WalkSettings(law="paper"),
        WalkSettings(step_height=0.031, footsteps=[0.1, 0.15], torque_limits={"l_knee": 100.0, "waist_yaw": 1.0 / 3.0}),
        WalkSettings(tracker="bang_bang", bound_lateral=False, max_iterations=7, first_swing="left"),
    ],
    ids=["default", "paper", "lists and tables", "words"],
)
def test_what_is_printed_reads_back_and_names_every_setting(toml, mahru, given):
    controller = zmpwalk.WalkingController(*mahru, given, zmpwalk.VelocityProfile.constant(0.05))
    text = settings_toml(controller, given)
    assert load_settings(toml(text)) == given
    assert max(map(len, text.splitlines())) <= 100
    for row in WalkSettings.table().values():
        rest = text.split(f"\n[{row.group}]\n")[1].split("\n\n\n")[0]
        assert re.search(rf"\n(#?{row.name} = |\[control.{row.name}\])", rest), row
        assert row.text in " ".join(rest.replace("\n# ", " ").split("\n"))
    for joint in controller.joint_names:
        assert f"\n{joint} = " in text or f"\n#{joint} = " in text
    # With every # taken away the file holds all values in force, and walks as before.
    bare = toml(re.sub(r"^#(?=\S)", "", text, flags=re.MULTILINE))
    full = zmpwalk.WalkingController(*mahru, load_settings(bare), zmpwalk.VelocityProfile.constant(0.05))
    in_force, before = full.settings.to_dict(), controller.settings.to_dict()
    in_force.pop("torque_limits"), before.pop("torque_limits")
    assert in_force == before
    assert list(full.torque_limit) == list(controller.torque_limit)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("step_hieght = 0.03", "no setting 'step_hieght'; did you mean swing.height (step_height)?"),
        ('step_height = "3 cm"', "step_height = '3 cm' is of the wrong type; it must be a number [m]"),
        ("step_height = true", "step_height = True is of the wrong type"),
        ("max_iterations = 2.5", "max_iterations = 2.5 is of the wrong type; it must be an integer"),
        ("textbook = 1", "it must be true or false"),
        ("step_lengths = 3", "it must be a list of numbers [m]"),
        ("torque_limits = 3", "it must be a table, joint name = number [N m]"),
        ('tracker = "psychic"', "tracker = 'psychic' is unknown; there are: smooth"),
        ("law = 3", "law = 3; it must be 'default' or 'paper'"),
        ('law = "modern"', "law = 'modern' is unknown"),
        ('lateral_law = "papr"', "did you mean 'paper'?"),
        ("step_height = ", "not TOML"),
        ("[soles]\nleft = 1", "no setting 'soles'"),
        ("[tracking]\ngian = 1", "no setting 'tracking.gian'; did you mean tracking.gain (tracker_gain)?"),
        ("[control]\ntorque_limits = 3", "control.torque_limits = 3 is of the wrong type"),
        ("gait = 3", "gait = 3 is of the wrong type; it is a group of settings"),
    ],
)
def test_mistakes_are_named_in_one_line(toml, text, words):
    path = toml(text)
    with pytest.raises(InputError) as caught:
        load_settings(path)
    assert words in str(caught.value)
    assert str(path) in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_file_that_is_not_there_is_named(tmp_path):
    with pytest.raises(InputError, match=r"none\.toml: no such file"):
        load_settings(tmp_path / "none.toml")


@pytest.mark.parametrize(
    ("text", "words"),
    [("T_ss = -1", "T_ss"), ("sole_fraction = 0", "sole_fraction"), ("[torque_limits]\nl_nee = 3", "'l_nee'")],
)
def test_values_out_of_range_are_refused_with_the_robot(toml, mahru, text, words):
    with pytest.raises((InputError, ModelError), match=words):
        zmpwalk.WalkingController(*mahru, load_settings(toml(text)))


def test_command_prints_a_file_that_the_walk_takes(toml, tmp_path, capsys):
    assert cli.main(["settings", "mahru", "--set", "swing.height=0.03", "--set", "torque_limits=l_knee:120"]) == 0
    path = toml(capsys.readouterr().out)
    assert load_settings(path) == WalkSettings(step_height=0.03, torque_limits={"l_knee": 120.0})
    out = tmp_path / "out"
    words = ["walk", "--settings", path, "--set", "step_height=0.04", "--duration", "0.3", "--no-figures", "--out", out]
    assert cli.main(list(map(str, words))) == 0
    trace = zmpwalk.Trace.load(out / "trace.npz")
    assert trace.settings.step_height == 0.04
    assert trace.meta["torque_limits"][trace.meta["joint_names"].index("l_knee")] == 120.0
    assert cli.main(["walk", "--settings", str(toml("stp_height = 1")), "--out", str(tmp_path / "no")]) == 2
    assert "step_height" in capsys.readouterr().err
    assert not (tmp_path / "no").exists()
