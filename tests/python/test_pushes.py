"""Pushes, the walk that goes on after an alarm, the judge, and the map of what fells."""

import csv
import json
import math
import os
import signal
import subprocess

import numpy as np
import pytest
import zmpwalk
from matplotlib.figure import Figure
from zmpwalk import InputError, VelocityProfile, judge, push_map, simulate
from zmpwalk.verdict import Verdict

PROFILE = VelocityProfile.ramp(0.0, 0.25, 1.25)


def pushed(impulse, direction=(0.0, 1.0, 0.0), t=6.0, after=8.0, **more):
    """The bundled robot at 0.25 m/s, pushed for 0.08 s by an impulse in N s/kg."""
    force = tuple(62.9 * impulse / 0.08 * d for d in direction)
    push = [(t, 0.08, None, force)] if impulse else []
    return simulate(profile=PROFILE, duration=t + 0.08 + after, push=push, on_fall="go_on", **more)


@pytest.fixture(scope="module")
def survivor():
    return pushed(0.1)


@pytest.fixture(scope="module")
def fallen():
    return pushed(1.0)


# ---- the push


def test_nothing_changes_before_the_push_and_everything_after(survivor):
    quiet = simulate(profile=PROFILE, duration=7.0)
    before = survivor.t[: len(quiet.t)] < 6.0 + 1e-9  # the row at 6.0 s is read before the force acts
    np.testing.assert_array_equal(survivor.qpos[: len(quiet.t)][before], quiet.qpos[before])
    assert not np.array_equal(survivor.qvel[6002], quiet.qvel[6002])


def test_momentum_grows_by_the_impulse_of_push_and_ground():
    walk = pushed(0.1, direction=(0.6, 0.8, 0.0), after=0.4)
    rows = slice(6000, 6100)
    ground = np.nansum(walk.contact_wrench.reshape(-1, 2, 6)[rows, :, :3], axis=(0, 1)) * walk.control_dt
    gained = 62.9 * (walk.dcom[rows.stop] - walk.dcom[rows.start])[:2]
    np.testing.assert_allclose(gained, (62.9 * 0.1 * np.array([0.6, 0.8]) - ground[:2]), atol=0.02)


def test_pushes_are_recorded_and_repeated(survivor):
    assert survivor.meta["push"] == [[6.0, 0.08, "torso", [0.0, pytest.approx(62.9 * 0.1 / 0.08), 0.0]]]
    assert survivor.rerun() == survivor


def test_no_body_is_the_first_torso_or_trunk():
    named, unnamed = (
        simulate(profile=0.0, duration=0.3, push=[(0.1, 0.1, body, (20, 0, 0))]) for body in ("torso", None)
    )
    assert named == unnamed


def test_a_text_is_a_push():
    tuple_, text = (
        simulate(profile=0.0, duration=0.3, push=push) for push in ([(0.1, 0.1, None, (20, 0, 5))], "0.1:0.1::20,0,5")
    )
    assert tuple_ == text


def test_one_push_needs_no_list_and_may_be_given_by_its_impulse():
    by_impulse = zmpwalk.Push.impulse(0.2, (0.0, 8.0, 0.0))
    assert by_impulse == (0.2, 0.08, None, (0.0, 100.0, 0.0))
    alone = (0.2, 0.08, None, (0.0, 100.0, 0.0))
    walks = [simulate(duration=0.4, push=push) for push in (by_impulse, alone, [alone], "0.2:0.08::0,100,0")]
    assert all(walk.identical(walks[0]) for walk in walks)
    with pytest.raises(InputError, match="duration is 0 s; it must be positive"):
        zmpwalk.Push.impulse(0.2, (0.0, 8.0, 0.0), duration=0.0)


def test_two_pushes_at_once_add_up():
    one = simulate(profile=0.0, duration=0.3, push=[(0.1, 0.1, None, (20, 10, 0))])
    two = simulate(profile=0.0, duration=0.3, push=[(0.1, 0.1, None, (20, 0, 0)), (0.1, 0.1, None, (0, 10, 0))])
    assert one == two


@pytest.mark.parametrize(
    ("push", "words"),
    [
        ("3", "T:DURATION:BODY"),
        ([(1, 0.1, None, (1, 2))], "T:DURATION:BODY"),
        ([(-1, 0.1, None, (1, 2, 3))], "begins at -1 s"),
        ([(1, 0, None, (1, 2, 3))], "at least a timestep"),
        ([(1, 0.1, None, (1, math.nan, 3))], "finite"),
        ([(1, 0.1, "tail", (1, 2, 3))], "'tail'.*pelvis"),
    ],
)
def test_a_push_that_makes_no_sense_is_refused(push, words):
    with pytest.raises(InputError, match=words):
        simulate(duration=0.1, push=push)
    with pytest.raises(InputError, match=words):
        zmpwalk.simulate_batch([{"duration": 0.1, "push": push}])


# ---- going on


def test_the_walk_goes_on_after_an_alarm_until_the_robot_lies(fallen):
    stops = simulate(profile=PROFILE, duration=14.0, push=fallen.meta["push"])
    assert stops.fall.foreseen == fallen.fall.foreseen < stops.fall.time < fallen.fall.time
    assert fallen.meta["fall_cause"] == "the robot lay on the ground"
    common = len(stops.t) - 1
    np.testing.assert_array_equal(stops.qpos[:common], fallen.qpos[:common])
    assert fallen.rerun() == fallen


def test_on_fall_is_stop_or_go_on():
    with pytest.raises(InputError, match="stop or go_on"):
        simulate(duration=0.1, on_fall="dance")


# ---- the judge


def test_a_quiet_walk_is_back_where_it_was(survivor):
    verdict = judge(pushed(0.0), 6.0)
    assert verdict.survived
    assert verdict.tilt < 1e-3
    assert abs(verdict.speed_error) < 1e-3
    assert np.all(np.abs(verdict.offset) < 1e-3)


def test_the_judge_tells_who_came_through(survivor, fallen):
    assert judge(survivor, 6.0).survived
    verdict = judge(fallen, 6.0)
    assert (verdict.survived, verdict.reason != "") == (False, True)


def test_the_judge_asks_for_the_path_in_both_axes_and_for_the_speed(survivor, made_up):
    columns = {name: np.array(values) for name, values in survivor.items()}
    for axis in (0, 1):
        moved = {**columns, "com": columns["com"] + 0.03 * np.eye(3)[axis] * (columns["t"] > 7.0)[:, None]}
        verdict = judge(zmpwalk.Trace(moved, survivor.meta), 6.0)
        assert not verdict.survived
        assert abs(verdict.offset[axis]) == pytest.approx(0.03, abs=2e-3)
    drift = {**columns, "com": columns["com"] + 0.015 * np.eye(3)[0] * np.maximum(columns["t"] - 7.0, 0.0)[:, None]}
    assert "speed" in judge(zmpwalk.Trace(drift, survivor.meta), 6.0).reason


def test_the_judge_follows_a_command_that_turns():
    turning = simulate(profile=VelocityProfile.ramp(0.0, (0.2, 0.0, 0.2), 1.0), duration=20.0)
    verdict = judge(turning, 10.0)
    assert isinstance(verdict, Verdict)
    assert np.all(np.abs(verdict.offset) < 0.02)


def test_a_record_that_does_not_span_the_push_is_refused(survivor):
    with pytest.raises(InputError, match="from before 99 s"):
        judge(survivor, 99.0)


# ---- the map


@pytest.fixture(scope="module")
def small_map():
    return push_map(directions=[90, 270], phases=[0.0, 0.9], stances=["left"], step=0.1, fine_step=0.02, limit=0.4)


def test_a_symmetrical_robot_falls_alike_on_both_stances():
    both = push_map(directions=[90], phases=[0.0], step=0.1, fine_step=0.02, limit=0.4).felling
    np.testing.assert_allclose(both[0], both[1], atol=0.021)


def test_the_map_is_what_a_whole_walk_gives(small_map):
    """A cell again, by `simulate` and `judge` from the start: the impulse fells, the one below does not."""
    felling = small_map.felling[0, 0, 0]
    walk = simulate(profile=PROFILE, duration=15.0)
    lift_offs = 1 + np.flatnonzero((walk.phase[:-1] == 0) & (walk.phase[1:] == 1))
    row = next(row for row in lift_offs if walk.t[row] > 9.25 and walk.support[row] > 0)
    for impulse, survived in ((felling, False), (felling - 0.02, True)):
        assert judge(pushed(impulse, t=float(walk.t[row])), float(walk.t[row])).survived == survived


def test_in_double_support_inwards_is_outwards_for_the_next_foot(small_map):
    assert small_map.support(0.9) == "double"
    assert small_map.felling[0, 1, 1] < small_map.felling[0, 1, 0] or np.isnan(small_map.felling[0, 1, 0])


def test_worst_and_mean_count_what_nothing_fells_as_the_limit(small_map):
    known = np.where(np.isnan(small_map.felling), 0.4, small_map.felling)
    assert small_map.worst == known.min()
    assert small_map.mean == known.mean()


def test_the_map_as_csv_and_json(small_map, tmp_path):
    with open(small_map.to_csv(tmp_path / "map.csv"), encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == small_map.felling.size
    assert float(rows[0]["felling_Ns"]) == pytest.approx(62.9 * float(rows[0]["felling_Ns_per_kg"]), rel=1e-3)
    assert json.loads(json.dumps(small_map.to_dict(), allow_nan=False))["worst"] == small_map.worst


def test_the_figure_draws_on_polar_axes_that_are_given(small_map):
    figure = Figure()
    axes = figure.subplots(1, len(small_map.phases), subplot_kw={"projection": "polar"}, squeeze=False)
    assert small_map.plot(axes) is figure
    assert all(ax.get_lines() for ax in axes.ravel())
    with pytest.raises(InputError, match="needs polar axes"):
        small_map.plot(figure.subplots(1, len(small_map.phases)))


def test_the_figure_has_a_polar_axes_for_each_phase(small_map):
    assert [ax.name for ax in small_map.plot().axes] == ["polar", "polar"]


def test_a_standing_robot_has_one_phase():
    found = push_map(velocity=0.0, directions=[90], step=0.2, fine_step=0.1, limit=0.8)
    assert found.felling.shape == (1, 1, 1)
    assert 0.5 < found.worst <= 0.8


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"phases": [1.5]}, "phases are"),
        ({"directions": 0}, "directions is 0"),
        ({"stances": ["middle"]}, "left or right"),
        ({"limit": -1.0}, "limit is -1"),
        ({"processes": 0}, "processes is 0"),
        ({"body": "tail"}, "'tail'"),
    ],
)
def test_arguments_that_make_no_sense_are_refused(wrong, words):
    with pytest.raises(InputError, match=words):
        push_map(**{"directions": [90], "phases": [0.0], "stances": ["left"], "limit": 0.1, **wrong})


def test_a_robot_that_falls_by_itself_is_told():
    with pytest.raises(InputError, match="before it is pushed"):
        push_map(directions=[90], phases=[0.0], settings={"wrench_distribution": False, "contact_damping": 0.0})


def test_ctrl_c_ends_all_processes(ctrl_c):
    with pytest.raises(KeyboardInterrupt):
        push_map(on_progress=lambda done, cells: os.kill(os.getpid(), signal.SIGINT))
    listed = subprocess.run(["ps", "--ppid", str(os.getpid()), "-o", "args="], stdout=subprocess.PIPE, check=False)
    assert b"zmpwalk.trials" not in listed.stdout


def test_the_command_writes_map_and_figure(zmpwalk_command, tmp_path):
    done = zmpwalk_command("push-map", "--directions", 1, "--phases", 1, "--stance", "left", "--limit", 0.1,
                           "--out", tmp_path / "map")  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert {file.name for file in (tmp_path / "map").iterdir()} == {"pushes.csv", "pushes.json", "pushes.png"}
    assert "N s/kg" in done.stdout


def test_the_walk_command_pushes(zmpwalk_command, tmp_path):
    words = ("walk", "--duration", 1.0, "--no-figures", "--out", tmp_path, "--push", "0.5:0.08::0,10,0", "--push",
             "0.6:0.08:pelvis:5,0,0", "--on-fall", "go_on", "--uncertain", "noise=1", "--seed", 3)  # fmt: skip
    done = zmpwalk_command(*words)
    assert done.returncode == 0, done.stderr
    trace = zmpwalk.Trace.load(tmp_path / "trace.npz")
    assert [push[2] for push in trace.meta["push"]] == ["torso", "pelvis"]
    assert (trace.meta["uncertainty"]["noise"], trace.meta["seed"]) == (1.0, 3)
    assert trace.rerun() == trace
    assert zmpwalk_command("walk", "--push", "now").returncode == 2


# ---- how the robot catches itself

FIXED = {"step_timing": False}


def lift_off(support=1):
    """The first lift-off after 6 s by which the foot of that side stands alone [s]."""
    quiet = simulate(profile=PROFILE, duration=8.0)
    lifts = np.flatnonzero((np.diff(quiet.phase) == 1) & (quiet.t[1:] > 6.0) & (quiet.support[1:] == support))
    return float(quiet.t[lifts[0] + 1])


def test_a_robot_that_changes_the_time_of_its_step_bears_more_outwards():
    t = lift_off()
    assert not judge(pushed(0.22, t=t, settings=FIXED), t).survived
    assert judge(pushed(0.22, t=t), t).survived


def test_a_trunk_that_yields_bears_more_backward():
    t = lift_off() + 0.7  # in the double support that follows
    assert judge(pushed(0.51, (-1.0, 0.0, 0.0), t), t).survived
    assert not judge(pushed(0.51, (-1.0, 0.0, 0.0), t, settings={"trunk_yields": False}), t).survived


def test_what_catches_the_robot_leaves_a_quiet_walk_as_it_is_to_the_bit():
    """Starts, turns, jumps of the command and stops are no pushes."""
    profile = VelocityProfile.piecewise([(0, 0), (0.5, (0.3, 0, 0.3)), (3, (0.1, 0.1, 0)), (6, 0)])
    walk, without = (
        simulate(profile=profile, duration=8.0, settings=more) for more in ({}, {**FIXED, "trunk_yields": False})
    )
    for column in ("qpos", "qvel", "tau", "zmp_est"):
        np.testing.assert_array_equal(walk[column], without[column])


def test_a_standing_robot_steps_when_it_must_and_stands_again():
    def stand(**more):
        push = [(1.0, 0.08, None, (62.9 * 0.45 / 0.08, 0.0, 0.0))]
        return simulate(profile=VelocityProfile.constant(0.0), duration=9.0, push=push, on_fall="go_on", **more)

    caught = stand()
    assert judge(caught, 1.0).survived
    assert caught.phase[:900].max() == 0 and caught.phase.max() == 1 and caught.phase[-500:].max() == 0
    assert not judge(stand(settings=FIXED), 1.0).survived
