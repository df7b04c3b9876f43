"""Every door is checked: numbers, time, size, names of files, and who uses a controller at the same time."""

import copy
import io
import json
import math
import os
import pathlib
import pickle
import re
import subprocess
import sys
import threading
import xml.etree.ElementTree as ET
import zipfile

import mujoco
import numpy as np
import pytest
import zmpwalk
from hypothesis import given, settings
from hypothesis import strategies as st
from zmpwalk import InputError, ModelError, Trace, VelocityProfile, WalkingController, WalkSettings, cli
from zmpwalk.files import read_text, together, whole
from zmpwalk.robots import description_from_dict, description_to_dict, robot_file
from zmpwalk.simulation import check_duration, run

MODEL, DESCRIPTION = zmpwalk.load_robot("mahru")
ANY = st.floats(allow_nan=True, allow_infinity=True)
FEW = settings(max_examples=30, deadline=None, derandomize=True)


def placed():
    data = mujoco.MjData(MODEL)
    DESCRIPTION.place(MODEL, data)
    return data


def walking(profile=0.2, steps=20):
    """A controller some cycles into a walk, and the data."""
    controller, data = WalkingController(MODEL, DESCRIPTION, profile=profile), placed()
    controller.reset(data)
    for _ in range(steps):
        controller.update(data)
        mujoco.mj_step(MODEL, data)
    return controller, data


# --- a refused call changes nothing


def test_a_refused_reset_leaves_the_controller_as_it_was():
    controller, upside_down = walking()[0], placed()
    height, cycles = controller.com_height, controller.cycles
    upside_down.qpos[3:7] = [0, 1, 0, 0]
    with pytest.raises(InputError, match="upside down"):
        controller.reset(upside_down)
    assert (controller.com_height, controller.cycles) == (height, cycles)


# --- one clock


@pytest.mark.parametrize(
    ("change", "word"),
    [
        (lambda d: setattr(d, "time", d.time - 0.015), "gone back"),
        (lambda d: setattr(d, "time", d.time + 10.0), "jumped"),
        (lambda d: setattr(d, "time", math.nan), "finite"),
        (lambda d: d.qpos.__setitem__(0, d.qpos[0] + 1.0), "placed elsewhere"),
    ],
)
def test_a_walk_that_was_torn_is_refused_until_it_is_reset(change, word):
    controller, data = walking()
    change(data)
    for _ in range(2):
        with pytest.raises(InputError, match=word):
            controller.update(data)
    data = placed()
    controller.reset(data)
    assert controller.update(data).fresh


@pytest.mark.parametrize("motors", [True, False])
def test_terms_of_another_velocity_are_refused(motors):
    check_terms_of_another("qvel", motors, range(MODEL.nv))


def test_terms_of_another_position_are_refused():
    check_terms_of_another("qpos", True, [0, 1, 2, *range(4, MODEL.nq)])  # a longer quaternion is the same pose


def check_terms_of_another(state, motors, coordinates):
    """Each of `coordinates` is changed by little after `mj_step1`, which the controller has to notice."""
    model = MODEL if motors else without_motors()
    controller, data = WalkingController(model, DESCRIPTION, profile=0.2), mujoco.MjData(model)
    DESCRIPTION.place(model, data)
    controller.reset(data)
    for i in coordinates:
        mujoco.mj_step1(model, data)
        values, kept = getattr(data, state), getattr(data, state)[i]
        values[i] += 1e-4
        with pytest.raises(InputError, match=f"belong to another state than its {state}"):
            controller.update(data, after_step1=True)
        values[i] = kept
        assert controller.update(data, after_step1=True).fresh
        mujoco.mj_step2(model, data)


def without_motors():
    tree = ET.parse(robot_file("mahru"))
    for actuators in tree.getroot().findall("actuator"):
        tree.getroot().remove(actuators)
    return mujoco.MjModel.from_xml_string(ET.tostring(tree.getroot(), encoding="unicode"))


# --- numbers


@FEW
@given(st.tuples(ANY, ANY, ANY))
def test_a_velocity_within_reach_is_finite_and_reached_or_refused(velocity):
    controller = walking.controller
    if not np.isfinite(velocity).all():
        with pytest.raises(InputError):
            controller.within_reach(velocity)
        return
    within = controller.within_reach(velocity)
    assert np.isfinite(within).all()
    assert controller.reach_share(within) <= 1.0


walking.controller = WalkingController(MODEL, DESCRIPTION)


@pytest.mark.parametrize("fast", [1e13, 1e155, 1e308])
def test_a_huge_velocity_is_cut_to_what_the_legs_reach_and_no_profile_takes_it(fast):
    reach = walking.controller.within_reach([10, 0, 0])[0]
    assert 1 < reach < 3
    assert walking.controller.within_reach([fast, 0, 0])[0] == pytest.approx(reach, rel=1e-6)
    with pytest.raises(InputError, match="too large"):
        VelocityProfile([0, 3], [[0, 0, 0], [fast, 0, 0]])


@pytest.mark.parametrize(("duration", "dt"), [(1e300, 0.01), (1.0, 1e-300), (1e9, 0.01)])
def test_a_plan_without_end_is_refused(duration, dt):
    with pytest.raises(InputError, match="ten million rows"):
        walking.controller.plan(duration, dt)


@pytest.mark.parametrize(("name", "value"), [
    ("sole_fraction", 100.0), ("step_width", 1e308), ("step_height", 1e300), ("T_ds_first", 1e300),
    ("max_iterations", 2_000_000_000), ("com_lead", 1e9),
])  # fmt: skip
def test_a_setting_out_of_all_range_is_refused(name, value):
    with pytest.raises(InputError, match=f"{name}.*at most"):
        WalkingController(MODEL, DESCRIPTION, {name: value})


def test_a_time_step_that_makes_a_start_without_end_is_refused():
    model = copy.copy(MODEL)
    model.opt.timestep = 1e-9
    with pytest.raises(ModelError, match="time step is 1e-09 s"):
        WalkingController(model, DESCRIPTION)


@pytest.mark.parametrize("change", [
    {"length": True}, {"length": math.inf}, {"length": 10**400}, {"length": 1e300}, {"sole_quat_wxyz": [0, 0, 0, 0]},
    {"sole_center": [True, 0, 0]}, {"sole_center": [10**400, 0, 0]}, {"sole_center": [1e300, 0, 0]},
])  # fmt: skip
def test_a_description_with_a_number_that_is_none_is_refused(change):
    plain = description_to_dict(DESCRIPTION)
    plain["left"] = {**plain["left"], **change}
    with pytest.raises((InputError, ModelError)):
        description_from_dict(plain).check(MODEL)


# --- one walk for one controller


def test_a_busy_controller_refuses_whatever_would_mix_two_walks():
    controller, data = WalkingController(MODEL, DESCRIPTION, profile=0.2), placed()
    said = []

    def command(t, out):
        for act in (lambda: controller.reset(data), lambda: controller.update(data), lambda: run(controller, 1.0)):
            with pytest.raises(InputError, match="busy"):
                act()
        controller.move(None)  # between cycles, from the walk's own thread
        other = threading.Thread(target=lambda: said.append(_refused(lambda: controller.move(None))))
        other.start()
        other.join()

    trace = run(controller, 0.1, command=command)
    assert len(trace.t) == 100
    assert said
    assert all("busy" in word for word in said)
    controller.reset(data)


def _refused(act):
    try:
        act()
    except InputError as error:
        return str(error)
    return ""


# --- objects


@pytest.mark.parametrize("protocol", range(pickle.HIGHEST_PROTOCOL + 1))
def test_values_go_through_every_pickle(protocol):
    for value in (WalkSettings(step_height=0.05), VelocityProfile.paper()):
        assert pickle.loads(pickle.dumps(value, protocol)) == value
    again = pickle.loads(pickle.dumps(DESCRIPTION, protocol))
    assert description_to_dict(again) == description_to_dict(DESCRIPTION)


def test_what_does_not_go_into_another_process_says_what_to_send():
    for value in (walking.controller, zmpwalk.Recorder(walking.controller)):
        with pytest.raises(TypeError, match="send what it was made from"):
            pickle.dumps(value)


@pytest.mark.parametrize("name", ["WalkSettings", "RobotDescription", "WalkingController", "VelocityProfile", "State"])
def test_an_object_without_a_value_says_so(name):
    cls = getattr(zmpwalk, name)
    empty = cls.__new__(cls)
    for use in (lambda: empty.__reduce__(), lambda: empty.mass, lambda: empty.to_dict(), lambda: empty.time):
        with pytest.raises((TypeError, AttributeError)):
            use()


# --- files


def test_what_has_no_end_is_not_read_to_its_end():
    with pytest.raises(InputError, match="larger than 1 MB"):
        read_text("/dev/zero", largest=1_000_000)


def test_a_small_file_does_not_become_a_large_trace(tmp_path):
    path = tmp_path / "bomb.npz"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
        file.writestr("meta.json", '{"format_version": 1}')
        file.writestr("t.npy", bytes(200_000_000))
    with pytest.raises(InputError, match="would become"):
        Trace.load(path)


@pytest.mark.parametrize(
    "meta", ["[]", "5", '{"format_version": 1, "settings": []}', '{"format_version": 1, "versions": 5}']
)
def test_a_trace_with_other_meta_data_is_refused(tmp_path, meta):
    path, t = tmp_path / "t.npz", io.BytesIO()
    np.save(t, np.zeros(3))
    with zipfile.ZipFile(path, "w") as file:
        file.writestr("meta.json", meta)
        file.writestr("t.npy", t.getvalue())
    with pytest.raises(InputError, match=r"t\.npz"):
        Trace.load(path)


@pytest.mark.parametrize("column", [["a", "b"], np.zeros(2, [("a", float)]), np.zeros(2, complex)])
def test_a_column_holds_real_numbers(column):
    with pytest.raises(InputError, match="must hold real numbers"):
        Trace({"t": [0.0, 1.0], "com_z": column})


def test_a_trace_without_a_column_says_which():
    with pytest.raises(InputError, match="'phase'"):
        Trace({"t": [0.0, 1.0]}).summary()


def test_a_walk_too_long_to_record_is_refused():
    with pytest.raises(InputError, match="at most"):
        check_duration(1e9)
    with pytest.raises(InputError, match="walk at most"):
        check_duration(9e6, walking.controller)


@pytest.mark.parametrize("text", ["[" * 1000 + "]" * 1000, '{"name": "\\ud800"}', "1" * 10000, "[]"])
def test_a_robot_json_that_is_no_description_is_refused(tmp_path, text):
    (tmp_path / "robot.json").write_text(text)
    with pytest.raises(InputError, match=r"robot\.json"):
        zmpwalk.load_robot(tmp_path / "robot.json")


def test_a_set_of_files_is_there_whole_or_not_at_all(tmp_path):
    (tmp_path / "b").mkdir()
    with together(tmp_path) as (draft, deliver):
        files = [draft / "a", draft / "b"]
        for file in files:
            file.write_text("new")
        with pytest.raises(InputError, match="is a directory"):
            deliver(files)
    assert [each.name for each in tmp_path.iterdir()] == ["b"]


def test_the_next_run_removes_what_a_killed_one_left(tmp_path):
    code = "import os, signal, pathlib; from zmpwalk.files import whole\n" \
        "with whole('x.txt') as draft: draft.write_text('half'); os.kill(os.getpid(), signal.SIGKILL)"  # fmt: skip
    subprocess.run([sys.executable, "-c", code], cwd=tmp_path, check=False)
    assert len(list(tmp_path.iterdir())) == 1
    with whole(tmp_path / "y.txt") as mine, whole(tmp_path / "z.txt") as other:  # who still writes is let alone
        mine.write_text("1")
        other.write_text("2")
    assert sorted(each.name for each in tmp_path.iterdir()) == ["y.txt", "z.txt"]


# --- the command line


@pytest.mark.parametrize("words", [
    ["walk", "--out", "a" * 300], ["walk", "--out", ""], ["walk", "--out", "~nouser/x"],
    ["walk", "--robot", "~nouser/x"], ["walk", "--robot", "a" * 300], ["inspect", ""],
    ["inspect", "mahru", "--write", ""], ["inspect", "mahru", "--write", "/"],
    ["plot", ""], ["video", "--out", "a" * 300 + ".mp4"], ["walk", "--duration", "1e300"],
    ["bench", "--part", "cycle", "--duration", "0.05"],
])  # fmt: skip
def test_a_name_or_number_that_cannot_be_is_one_line(words, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert cli.main(words) == 2
    assert [line for line in capsys.readouterr().err.splitlines() if line.startswith("zmpwalk: ")][-1]
    assert list(tmp_path.iterdir()) == []


def test_inspect_writes_both_of_its_files_or_none(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert cli.main(["inspect", "mahru", "--write", "ok.json", "--figure", "nodir/f.png"]) == 2
    assert os.listdir(tmp_path) == []
    assert cli.main(["inspect", "mahru", "--write", "ok.json", "--figure", "f.png"]) == 0
    assert sorted(os.listdir(tmp_path)) == ["f.png", "ok.json"]
    assert json.loads((tmp_path / "ok.json").read_text())["name"]


@FEW
@given(st.binary(max_size=200))
def test_any_bytes_as_a_table_of_velocities_are_read_or_refused(tmp_path_factory, raw):
    path = tmp_path_factory.mktemp("csv") / "v.csv"
    path.write_bytes(raw)
    try:
        profile = VelocityProfile.from_csv(path)
    except InputError:
        return
    assert np.isfinite(profile.v).all()


# --- what the fuzzer found, and a short run of it


@pytest.mark.parametrize("act", [
    lambda: zmpwalk.disturbances.pushes_of([(1.0, 0.1, None, (0, math.nan, 0))]),
    lambda: zmpwalk.disturbances.pushes_of([(1.0, 0.1, None, (0, math.inf, 0))]),
    lambda: zmpwalk.disturbances.pushes_of([(10**400, 0.1, None, (0, 1, 0))]),
    lambda: zmpwalk.Uncertainty(mass=10**400),
    lambda: walking.controller.plan(2000.0, 17.7),
])  # fmt: skip
def test_a_number_without_measure_is_refused(act):
    with pytest.raises(InputError):
        act()


def test_a_short_plan_has_a_row():
    assert len(walking.controller.plan(5e-324, 0.01)["t"]) == 1


def test_a_message_is_one_line_whatever_it_quotes(tmp_path):
    (tmp_path / "v.csv").write_text('t,"v\nx\u2028\x85y"\n0,0\n')
    for act in (lambda: VelocityProfile.from_csv(tmp_path / "v.csv"), lambda: zmpwalk.Terrain.of("a\nb")):
        with pytest.raises(InputError) as caught:
            act()
        assert len(str(caught.value).splitlines()) == 1
    assert ModelError("a\nb", "c\nd").reasons == ("a b", "c d")


def test_a_trace_whose_joints_say_something_else_still_has_a_summary(walked):
    for key, value in (("joint_ranges", [1, [2]]), ("joint_ranges", 5), ("joint_names", ["a"])):
        Trace(dict(walked), {**walked.meta, key: value}).summary()


def test_a_short_run_of_the_fuzzer_finds_nothing():
    fuzz = str(pathlib.Path(__file__).resolve().parents[2] / "benchmarks" / "fuzz.py")
    done = subprocess.run(
        [sys.executable, fuzz, "--seed", "1", "--inputs", "300", "--seconds", "4"],
        capture_output=True, text=True, timeout=100, check=False, env={**os.environ, "MPLBACKEND": "Agg"},
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    assert re.search(r"^\d+ inputs, 0 findings", done.stdout, re.M)
    assert done.stdout.startswith("seed 1, ")


def test_signals_wait_while_a_set_of_files_is_delivered(tmp_path):
    code = (
        "import os, signal, pathlib\nfrom zmpwalk import files\n"
        "def stop(*a): raise KeyboardInterrupt\n"
        "signal.signal(signal.SIGTERM, stop)\nreplace = os.replace\n"
        "def slow(a, b):\n    os.kill(os.getpid(), signal.SIGTERM)\n    replace(a, b)\n"
        "os.replace = slow\n"
        "try:\n"
        "    with files.together(pathlib.Path('out')) as (draft, deliver):\n"
        "        for name in 'ab': (draft / name).write_text(name)\n"
        "        deliver([draft / 'a', draft / 'b'])\n"
        "except KeyboardInterrupt: print('ended')\n"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.stdout == "ended\n", done.stderr
    assert sorted(os.listdir(tmp_path / "out")) == ["a", "b"]
