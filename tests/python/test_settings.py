"""Settings in TOML files: what is printed reads back, mistakes are named."""

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


def test_a_file_is_its_settings(toml):
    path = toml(
        'law = "paper"\nstep_height = 0.03\nfeed_forward = true\nfootsteps = [0.1, 0.12]\n[torque_limits]\nl_knee = 90'
    )
    expected = WalkSettings(
        law="paper", step_height=0.03, feed_forward=True, footsteps=[0.1, 0.12], torque_limits={"l_knee": 90.0}
    )
    assert load_settings(path) == expected
    assert load_settings(path, law="default", step_height=0.05).step_height == 0.05
    assert load_settings(path, law="default").tracker == "smooth"
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
    for name in WalkSettings.table():
        assert f"\n{name} = " in text or f"\n# {name} = " in text or name == "torque_limits"
    for joint in controller.joint_names:
        assert f"\n{joint} = " in text or f"\n# {joint} = " in text
    # With every # taken away the file holds all values in force, and walks as before.
    bare = toml("\n".join(line[2:] if line.startswith("# ") and " = " in line else line for line in text.splitlines()))
    full = zmpwalk.WalkingController(*mahru, load_settings(bare), zmpwalk.VelocityProfile.constant(0.05))
    in_force, before = full.settings.to_dict(), controller.settings.to_dict()
    in_force.pop("torque_limits"), before.pop("torque_limits")
    assert in_force == before
    assert list(full.torque_limit) == list(controller.torque_limit)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("step_hieght = 0.03", "no setting 'step_hieght'; there is step_height"),
        ('step_height = "3 cm"', "step_height = '3 cm' is of the wrong type; it must be a number [m]"),
        ("step_height = true", "step_height = True is of the wrong type"),
        ("max_iterations = 2.5", "max_iterations = 2.5 is of the wrong type; it must be an integer"),
        ("textbook = 1", "it must be true or false"),
        ("step_lengths = 3", "it must be a list of numbers [m]"),
        ("torque_limits = 3", "it must be a table, joint name = number [N m]"),
        ('tracker = "psychic"', "tracker = 'psychic' is unknown; there are: smooth"),
        ("law = 3", "law = 3; it must be 'default' or 'paper'"),
        ('law = "modern"', "law = 'modern' is unknown"),
        ("step_height = ", "not TOML"),
        ("[soles]\nleft = 1", "no setting 'soles'"),
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
    assert cli.main(["settings", "mahru", "--set", "step_height=0.03", "--set", "torque_limits=l_knee:120"]) == 0
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
