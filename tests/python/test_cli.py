"""The command line as a user meets it: in a process of its own, by exit code, stdout, stderr and what lies on disk."""

import json
import os
import signal
import subprocess
import sys
import time

import mujoco
import pytest
import zmpwalk
from zmpwalk import InputError, Trace, cli
from zmpwalk.cli import options, terminal

FIGURES = {
    f"fig{name}.png" for name in ("2_iteration", "4_tracking", "5_switch", "6_velocity", "7_sagittal", "8_lateral")
} | {"footprints.png", "estimate.png"}
FALLS = (
    "--set",
    "wrench_distribution=false",
    "--set",
    "contact_damping=0",
)  # is lost within two seconds, and crouches


def lines(text):
    return [line for line in text.splitlines() if line.strip()]


def test_version_names_package_and_mujoco(zmpwalk_command):
    done = zmpwalk_command("--version")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == f"zmpwalk {zmpwalk.__version__}, MuJoCo {mujoco.__version__}\n"


def test_without_words_it_prints_help(zmpwalk_command):
    done = zmpwalk_command()
    assert done.returncode == 0
    for command in ("walk", "plot", "inspect"):
        assert f"\n  {command} " in done.stdout


def test_installed_command_is_the_module(zmpwalk_command):
    assert zmpwalk_command("walk", "--help").stdout.startswith("Usage: zmpwalk walk [OPTIONS]")


def test_walk_writes_trace_summary_and_figures_and_prints_a_table(zmpwalk_command, tmp_path):
    out = tmp_path / "deep" / "walk"
    done = zmpwalk_command("walk", "--duration", 1.7, "--out", out)
    assert done.returncode == 0, done.stderr
    assert {file.name for file in out.iterdir()} == {"trace.npz", "summary.json", *FIGURES}
    summary = json.loads((out / "summary.json").read_text())
    trace = Trace.load(out / "trace.npz")
    assert summary == trace.summary()
    assert (summary["robot"], summary["duration"], summary["fell"]) == ("mahru", 1.7, False)
    for word in (
        "planned",
        "0.0630",
        "0.1560",
        "ZMP error",
        "iterations",
        "control cycle",
        "real-time factor",
        "from [s]",
    ):
        assert word in done.stdout
    assert lines(done.stderr) == ["walking for 1.7 s"]
    assert trace.rerun() == trace


def test_json_prints_the_summary_and_nothing_else_on_stdout(zmpwalk_command, tmp_path):
    done = zmpwalk_command("walk", "--duration", 0.3, "--json", "--no-figures", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    out = tmp_path / "out" / "mahru-default"
    assert json.loads(done.stdout) == json.loads((out / "summary.json").read_text())
    assert {file.name for file in out.iterdir()} == {"trace.npz", "summary.json"}


def test_options_reach_the_walk(zmpwalk_command, tmp_path):
    (tmp_path / "v.csv").write_text("t,vx\n0,0.1\n0.2,0.12\n")
    options = ("--law", "paper", "--footsteps", "0.1,0.15", "--profile", "v.csv", "--set", "zmp.threshold=0.002")
    done = zmpwalk_command("walk", "--duration", 0.3, "--no-figures", *options, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    trace = Trace.load(tmp_path / "out" / "mahru-paper" / "trace.npz")
    assert trace.meta["settings"]["law"] == "paper"
    assert trace.meta["settings"]["zmp_threshold"] == 0.002
    assert trace.meta["settings"]["step_lengths"] == [0.1, 0.15]
    assert trace.profile.velocity(0.25)[0] == 0.12


def test_robot_by_path_gives_the_same_walk(zmpwalk_command, tmp_path, walked):
    from zmpwalk.robots import ROBOTS

    done = zmpwalk_command(
        "walk", "--robot", ROBOTS / "mahru.xml", "--duration", 0.2, "--no-figures", "--out", tmp_path
    )
    assert done.returncode == 0, done.stderr
    assert (Trace.load(tmp_path / "trace.npz").com == walked.com[:200]).all()


def test_fall_is_named_and_everything_is_written(zmpwalk_command, tmp_path):
    done = zmpwalk_command("walk", "--duration", 4, "--out", tmp_path, *FALLS)
    assert done.returncode == 3, done.stderr
    assert {file.name for file in tmp_path.iterdir()} == {"trace.npz", "summary.json", *FIGURES}
    summary = json.loads((tmp_path / "summary.json").read_text())
    assert summary["fell"] is True
    assert 0 < summary["foreseen_time"] < 2
    assert summary["foreseen_time"] < summary["fall_time"]
    assert f"fell at t = {summary['fall_time']:.3f} s: {summary['fall_cause']}" in done.stderr
    assert "fell at" in done.stdout


def test_mismatch_of_footsteps_and_plan_is_told_beforehand(zmpwalk_command, tmp_path):
    options = ("--law", "paper", "--footsteps", "printed", "--duration", 4.9, "--no-figures", "--out", tmp_path)
    done = zmpwalk_command("walk", *options)
    assert lines(done.stderr)[0] == "zmpwalk: warning: the footsteps go 0.0625 m/s faster than the planned velocity"
    assert done.returncode == 3


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("walk", "--robot", "nao"), "unknown robot 'nao': there is mahru; a path"),
        (("walk", "--robot", "no.xml"), "no.xml: no such file"),
        (("walk", "--robot", "bad.xml"), "bad.xml: MuJoCo cannot load it"),
        (("walk", "--robot", "bare.xml"), "sole"),
        (("walk", "--profile", "fast"), 'profile "fast"'),
        (("walk", "--profile", "gap.csv"), "gap.csv, line 2: vx is empty"),
        (("walk", "--profile", "0:nan"), "nan"),
        (("walk", "--profile", "9.0"), "9"),
        (("walk", "--duration", "-1"), "duration is -1 s"),
        (("walk", "--duration", "nan"), "duration is nan s"),
        (("walk", "--duration", "soon"), "'soon' is not a valid float"),
        (("walk", "--law", "mine"), "'mine' is not one of"),
        (("walk", "--footsteps", "long"), '--footsteps "long"'),
        (("walk", "--footsteps", "0.1,nan"), '--footsteps "0.1,nan"'),
        (("walk", "--set", "T_sss=1"), "no setting 'T_sss'; did you mean gait.T_ss"),
        (("walk", "--set", "T_ss"), "NAME=VALUE"),
        (("walk", "--set", "T_ss=long"), "'long' is not a number"),
        (("walk", "--set", "posture_task=perhaps"), "'perhaps' is not true or false"),
        (("walk", "--set", "T_ss=-1"), "T_ss"),
        (("walk", "--set", "tracker=psychic"), "psychic"),
        (("walk", "--out", "gap.csv"), "gap.csv: cannot write there"),
        (("walk", "--out", "gap.csv/deeper"), "cannot write there"),
        (("walk", "--speed", "1"), "No such option"),
        (("run",), "No such command 'run'"),
        (("plot",), "Missing argument 'TRACE...'"),
        (("plot", "no.npz"), "no.npz: no such file"),
        (("plot", "gap.csv"), "gap.csv: not a trace"),
        (("plot", "no.npz", "--figure", "fig3"), "no figure 'fig3'; there are estimate"),
        (("plot", "no.npz", "other.npz"), "2 traces: add --compare"),
        (("plot", "no.npz", "--quantity", "com_z"), "--quantity goes with --compare"),
        (("inspect", "nao"), "unknown robot 'nao'"),
        (("inspect", "bare.xml"), "sole"),
    ],
)
def test_bad_input_is_one_line_exit_2_and_nothing_written(zmpwalk_command, tmp_path, words, message):
    (tmp_path / "gap.csv").write_text("0,0.1\n1,\n")
    (tmp_path / "bad.xml").write_text("<mujoco><worldbody>")
    (tmp_path / "bare.xml").write_text(
        '<mujoco><worldbody><body><freejoint/><geom size="1"/></body></worldbody></mujoco>'
    )
    before = sorted(tmp_path.rglob("*"))
    done = zmpwalk_command(*words, cwd=tmp_path)
    assert done.returncode == 2, done.stderr
    assert done.stdout == ""
    assert len(lines(done.stderr)) == 1, done.stderr
    assert done.stderr.startswith("zmpwalk: ")
    assert message in done.stderr
    assert sorted(tmp_path.rglob("*")) == before


def test_ctrl_c_stops_at_once_and_leaves_nothing(tmp_path, ctrl_c):
    out = tmp_path / "deep" / "walk"
    command = [sys.executable, "-m", "zmpwalk", "walk", "--duration", "600", "--out", str(out)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
    assert process.stderr.readline() == "walking for 600 s\n"  # the walk begins
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    start = time.monotonic()
    stdout, stderr = process.communicate(timeout=20)
    assert time.monotonic() - start < 1.0  # 0.1 s to stop, the rest to leave Python
    assert process.returncode == 130
    assert stdout == ""
    assert len(lines(stderr)) == 1
    assert stderr.startswith("zmpwalk: stopped at t = ")
    assert "nothing was written" in stderr
    assert not list(tmp_path.iterdir())


def test_next_walk_replaces_files_and_removes_figures_of_the_last(zmpwalk_command, tmp_path):
    (tmp_path / "fig8_lateral.png").write_text("of an earlier walk")
    (tmp_path / "notes.txt").write_text("mine")
    done = zmpwalk_command("walk", "--duration", 0.2, "--no-figures", "--out", tmp_path)
    assert done.returncode == 0, done.stderr
    assert {file.name for file in tmp_path.iterdir()} == {"trace.npz", "summary.json", "notes.txt"}


def test_long_walk_into_a_pipe_reports_now_and_then(capsys, monkeypatch):
    monkeypatch.setattr(sys.stderr, "isatty", lambda: False, raising=False)
    with terminal.Progress(60.0) as progress:
        progress._next = 0.0
        progress.at(12.34, 60.0)
        progress.at(12.35, 60.0)
    assert capsys.readouterr().err == "walking for 60 s\nwalked 12.3 of 60 s\n"


def test_plot_compares_walks_that_are_called_by_their_folders(zmpwalk_command, tmp_path, walked):
    for name in ("slow", "fast"):
        (tmp_path / name).mkdir()
        walked.save(tmp_path / name / "trace.npz")
    paths = [tmp_path / name / "trace.npz" for name in ("slow", "fast")]
    done = zmpwalk_command("plot", "--compare", *paths, "--out", tmp_path / "both", "--format", "svg")
    assert done.returncode == 0, done.stderr
    assert lines(done.stdout) == [str(tmp_path / "both" / "compare.svg")]
    assert "<!-- slow -->" in (tmp_path / "both" / "compare.svg").read_text()


def test_plot_draws_from_the_trace_alone(zmpwalk_command, tmp_path, walked):
    trace = walked.save(tmp_path / "walk.npz")
    done = zmpwalk_command("plot", trace, "--figure", "switch", "--figure", "fig8_lateral", "--format", "pdf")
    assert done.returncode == 0, done.stderr
    assert lines(done.stdout) == [str(tmp_path / "fig5_switch.pdf"), str(tmp_path / "fig8_lateral.pdf")]
    assert (tmp_path / "fig5_switch.pdf").read_bytes().startswith(b"%PDF")
    done = zmpwalk_command("plot", trace, "--out", tmp_path / "all")
    assert {file.name for file in (tmp_path / "all").iterdir()} == FIGURES


def test_video_films_a_trace_or_a_new_walk(zmpwalk_command, tmp_path, walked):
    pytest.importorskip("imageio")
    trace, film = walked.save(tmp_path / "walk.npz"), tmp_path / "walk.gif"
    small = ("--fps", 4, "--size", "64x48", "--out", film)
    done = zmpwalk_command("video", trace, *small, "--azimuth", 90, "--speed", 2)
    if "cannot draw off screen" in done.stderr:
        pytest.skip(done.stderr)
    assert (done.returncode, done.stdout) == (0, f"{film}\n"), done.stderr
    first = film.read_bytes()
    done = zmpwalk_command("video", "--duration", 0.5, "--profile", "0.1", *small)
    assert lines(done.stderr) == ["walking for 0.5 s", "filming for 0.5 s"]
    assert film.read_bytes() != first


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--out", "walk.avi"), "--out walk.avi: give a .mp4 or .gif"),
        (("--out", "no/walk.mp4"), "is not a folder, walk.mp4 cannot be written there"),
        (("--size", "big"), "--size big: give width x height"),
        (("walk.npz",), "walk.npz: no such file"),
        (("walk.npz", "--law", "paper"), "--law is for a new walk; walk.npz is one already"),
        (("walk.npz", "--profile", "0.1"), "--profile is for a new walk"),
    ],
)
def test_video_refuses_in_one_line(zmpwalk_command, tmp_path, words, said):
    done = zmpwalk_command("video", *words, cwd=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert len(lines(done.stderr)) == 1 and said in done.stderr
    assert not list(tmp_path.iterdir())


def test_inspect_shows_what_was_found(zmpwalk_command):
    done = zmpwalk_command("inspect", "mahru")
    assert done.returncode == 0, done.stderr
    for word in (
        "base",
        "pelvis",
        "mass",
        "T_c",
        "left foot",
        "0.250 × 0.140 m",
        "[N m]",
        "l_knee",
        "pitch",
    ):
        assert word in done.stdout
    found = json.loads(zmpwalk_command("inspect", "mahru", "--json").stdout)
    assert found["roles"] == {"left leg": 6, "right leg": 6, "waist": 1, "left arm": 6, "right arm": 6}


def test_our_own_fault_is_exit_1_and_says_so(monkeypatch, capsys):
    def broken(robot):
        raise ZeroDivisionError("inside")

    monkeypatch.setattr("zmpwalk.cli.inspect.examine", broken)
    assert cli.main(["inspect", "mahru"]) == 1
    error = capsys.readouterr().err
    assert "ZeroDivisionError: inside" in error
    assert "fault of zmpwalk" in error


@pytest.mark.parametrize(("name", "code"), [("zmpwalk", 2), ("notebook", 1)])
def test_wrong_mujoco_is_one_line_for_the_command_and_an_error_for_others(name, code, tmp_path):
    (tmp_path / "mujoco-9.9.9.dist-info").mkdir()
    script = (
        f"import sys, mujoco; sys.path.insert(0, {str(tmp_path)!r});"
        f"mujoco.__version__ = '9.9.9'; sys.argv = ['/somewhere/bin/{name}']; import zmpwalk"
    )
    done = subprocess.run([sys.executable, "-c", script], stderr=subprocess.PIPE, text=True, check=False)
    assert done.returncode == code, done.stderr
    assert "9.9.9" in lines(done.stderr)[-1]
    assert ("Traceback" in done.stderr) == (code == 1)
    assert code == 1 or len(lines(done.stderr)) == 1


@pytest.mark.parametrize(
    ("like", "text", "value"),
    [
        (True, "off", False), (False, "1", True), (3, "7", 7), (0.5, "1e-3", 1e-3),
        ("smooth", "bang_bang", "bang_bang"), ([0.1], "0.2,0.3", [0.2, 0.3]), ([], "", []),
    ],
)  # fmt: skip
def test_settings_take_the_kind_that_they_have(like, text, value):
    parsed = options.parse(text, like, f"name={text}")
    assert parsed == value
    assert type(parsed) is type(value)


def test_settings_of_another_kind_are_refused():
    for like, text in ((True, "2"), (3, "1.5"), (0.5, "x"), ([0.1], "0.1;0.2")):
        with pytest.raises(InputError, match="is not"):
            options.parse(text, like, "name")


def test_import_is_quick_because_it_leaves_out_what_is_slow():
    code = (
        "import sys, mujoco, numpy, time; start = time.perf_counter(); import zmpwalk;"
        "print(time.perf_counter() - start);"
        "print([name for name in ('matplotlib', 'pandas', 'click', 'rich', 'imageio') if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True, check=True)
    seconds, slow = done.stdout.splitlines()
    assert slow == "[]"
    assert float(seconds) < (3.0 if os.environ.get("CI") else 1.0)  # 0.1 s on an idle machine
