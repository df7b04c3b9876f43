"""What the fast paths promise besides speed: the same numbers, the same bits, bounded memory. No time is asserted."""

import json
import subprocess
import sys

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk import _core, bench
from zmpwalk.cli import main


def froude(model, description, number):
    """The speed of a Froude number, from a ramp out of the stand."""
    controller = zmpwalk.WalkingController(model, description)
    speed = number * np.sqrt(9.81 * controller.com_height)
    return zmpwalk.VelocityProfile.ramp(0.0, speed, 2.0)


@pytest.mark.parametrize("robot", ["mahru", "unitree_g1", "fourier_n1", "robotis_op3"])
def test_fast_path_is_the_textbook_on_every_robot(robot, request):
    if robot != "mahru":
        robot = str(request.getfixturevalue("test_robots") / robot / "robot.json")
    model, description = zmpwalk.load_robot(robot)
    columns = _core.benchmark_cycle(
        model, description, zmpwalk.WalkSettings(), froude(model, description, 0.06), 3.0, textbook_every=10
    )
    compared = np.isfinite(columns["difference"])
    for phase in (0, 1):
        assert np.count_nonzero(compared & (columns["phase"] == phase)) > 20
    assert columns["difference"][compared].max() < 1e-9


def test_update_after_step1_is_the_update_from_scratch():
    model, description = zmpwalk.load_robot("mahru")
    data = mujoco.MjData(model)
    description.place(model, data)
    both = [zmpwalk.WalkingController(model, description) for _ in range(2)]
    for controller in both:
        controller.reset(data)
    while data.time < 1.0:
        from_scratch = both[0].update(data)
        mujoco.mj_step1(model, data)
        in_loop = both[1].update(data, after_step1=True)
        assert np.array_equal(from_scratch.tau, in_loop.tau)
        assert np.array_equal(from_scratch.zmp_est, in_loop.zmp_est)
        mujoco.mj_step2(model, data)


def test_terms_of_an_older_state_are_refused():
    model, description = zmpwalk.load_robot("mahru")
    data = mujoco.MjData(model)
    description.place(model, data)
    controller = zmpwalk.WalkingController(model, description)
    controller.reset(data)
    controller.update(data)
    mujoco.mj_step(model, data)
    before = data.ctrl.copy()
    with pytest.raises(zmpwalk.InputError, match="mj_step1"):
        controller.update(data, after_step1=True)
    assert np.array_equal(data.ctrl, before)
    mujoco.mj_forward(model, data)
    controller.update(data, after_step1=True)


def test_kernels_give_the_same_torque():
    names = zmpwalk.build_info()["kernels"]
    assert zmpwalk.build_info()["kernel"] == names[-1]
    model, description = zmpwalk.load_robot("mahru")
    data = mujoco.MjData(model)
    description.place(model, data)
    all_of_them = [zmpwalk.WalkingController(model, description, zmpwalk.WalkSettings(kernel=name)) for name in names]
    for controller in all_of_them:
        controller.reset(data)
    while data.time < 1.0:
        torques = [controller.update(data).tau for controller in all_of_them]
        for tau in torques[1:]:
            assert np.linalg.norm(tau - torques[0]) < 1e-9 * np.linalg.norm(torques[0])
        mujoco.mj_step(model, data)


def test_unknown_kernel_names_those_there_are():
    with pytest.raises(zmpwalk.InputError, match=r"itanium.*auto"):
        zmpwalk.WalkingController(*zmpwalk.load_robot("mahru"), zmpwalk.WalkSettings(kernel="itanium"))


RUNS = [
    {"profile": zmpwalk.VelocityProfile.constant(0.1), "duration": 1.5, "seed": 7},
    {"settings": zmpwalk.WalkSettings(law="paper"), "duration": 1.0},
    {"duration": 0.5},
]


def test_batch_has_the_same_bits_on_any_number_of_threads():
    seen = []
    batches = [zmpwalk.simulate_batch(RUNS, threads, lambda t, total: seen.append((t, total))) for threads in (1, 2, 5)]
    for traces in zip(*batches):
        assert traces[0].identical(traces[1]) and traces[0].identical(traces[2])
    assert batches[0][0].identical(zmpwalk.simulate("mahru", **RUNS[0]))
    assert [trace.meta["seed"] for trace in batches[1]] == [7, 0, 0]
    assert seen[-1][1] == 3.0 and max(t for t, _ in seen) <= 3.0 + 1e-9


def test_batch_shares_one_model_and_takes_objects():
    robot = zmpwalk.load_robot("mahru")
    first, second = zmpwalk.simulate_batch([{"robot": robot, "duration": 0.1}, {"robot": robot, "duration": 0.1}], 2)
    assert first.identical(second)
    assert zmpwalk.simulate_batch([]) == []


@pytest.mark.parametrize(
    ("runs", "threads", "words"),
    [
        ([{"speed": 1.0}], 1, "speed.*profile"),
        ([{"duration": -1.0}], 1, "duration is -1"),
        ([{"seed": 0.5}], 1, "seed is 0.5"),
        ([{}], 0, "threads is 0"),
        ([{"duration": 0.1}, {"profile": zmpwalk.VelocityProfile.constant(9.0)}], 2, "9 m/s"),
    ],
)
def test_bad_batches_are_refused_before_the_first_step(runs, threads, words):
    with pytest.raises(zmpwalk.InputError, match=words):
        zmpwalk.simulate_batch(runs, threads)


def test_error_in_the_progress_callback_ends_the_batch():
    def fail(t, total):
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        zmpwalk.simulate_batch([{"duration": 600.0}] * 3, 2, fail)


def test_simulate_takes_little_more_memory_than_its_trace():
    code = """
import resource, zmpwalk
def peak(): return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
zmpwalk.simulate("mahru", duration=0.1)
before = peak()
trace = zmpwalk.simulate("mahru", duration=40.0)
print(peak() - before - sum(trace[name].nbytes for name in trace))
"""
    out = subprocess.run([sys.executable, "-c", code], check=True, stdout=subprocess.PIPE)
    assert float(out.stdout) < 50e6


@pytest.mark.parametrize("dt", [0.01, 0.002])
def test_plan_is_where_the_robot_walks(dt):
    model, description = zmpwalk.load_robot("mahru")
    controller = zmpwalk.WalkingController(model, description)
    plan = controller.plan(6.4, dt)
    trace = zmpwalk.simulate("mahru", duration=6.4)
    rows = np.round(plan["t"] / 0.001).astype(int)
    assert np.abs(plan["com"] - trace.com[rows, :2]).max() < 0.006
    lower, upper = trace.zmp_lower[rows], trace.zmp_upper[rows]
    single = trace.phase[rows] == 1
    assert np.all(plan["zmp"][single] < upper[single] + 0.005) and np.all(plan["zmp"][single] > lower[single] - 0.005)
    steps = plan["steps"]
    assert len(steps) == 7 and [step["foot"] for step in steps[:2]] == ["right", "left"]
    for step in steps:
        foot = trace["foot_" + step["foot"]][round((step["touch_down"] + 0.05) / 0.001)]
        assert np.abs(foot[:2] - step["place"][:2]).max() < 0.006


@pytest.mark.parametrize(("duration", "dt"), [(0.0, 0.01), (1.0, -0.01), (float("nan"), 0.01)])
def test_plan_refuses_what_is_no_time(duration, dt):
    with pytest.raises(zmpwalk.InputError):
        zmpwalk.WalkingController(*zmpwalk.load_robot("mahru")).plan(duration, dt)


@pytest.mark.parametrize("joints", bench.JOINTS)
def test_robots_of_the_growth_table_have_their_joints_and_walk(joints):
    model = mujoco.MjModel.from_xml_string(bench.with_joints(joints))
    assert model.nv == 6 + joints and model.nu == joints
    trace = zmpwalk.simulate((model, _core.describe(model)), duration=2.0)
    assert not trace.meta["fell"]


def test_bench_writes_every_figure(tmp_path, capsys):
    file = tmp_path / "bench.json"
    parts = ["--part", "cycle", "--part", "plan", "--part", "physics"]
    assert main(["bench", "--duration", "1", *parts, "--json", str(file)]) == 0
    result = json.loads(file.read_text())
    assert result["machine"]["cpu"] and result["build"]["kernel"]
    assert result["cycle"]["cycles"] == 1000
    assert result["cycle"]["largest_difference_to_textbook"] < 1e-9
    for phase in ("double", "single", "all"):
        for stage in ("in_loop", "from_scratch", "step", "algebra", "textbook"):
            of = result["cycle"][phase][stage]
            assert 0 < of["min"] <= of["median"] <= of["p99"] <= of["p99.9"] <= of["max"]
    physics = result["physics"]
    assert physics["same_states"]
    assert physics["speed_ratio"]["median"] == physics["mj_step"]["median"] / physics["walk"]["median"]
    printed = capsys.readouterr().out
    for words in ("one cycle in double support", "mj_step alone", "plan of 3.2 s", result["machine"]["cpu"]):
        assert words in printed


def test_bench_refuses_unknown_parts(capsys):
    assert main(["bench", "--part", "colour"]) == 2
    assert "colour" in capsys.readouterr().err
