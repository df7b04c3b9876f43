"""Velocity commands in every direction, faster, through stops and jumps: benchmarks/walk_anywhere.py."""

import math

import numpy as np
import pytest
import walk_anywhere
import zmpwalk
from zmpwalk import InputError, VelocityProfile, analysis

SEEDS = 12  # of the jumps; the benchmark walks 100
STEADY = 6.0  # at each speed of the ladder [s]; the benchmark takes 30
STEP = 0.8  # the longest [s]
FASTEST = 1.0  # [m/s]
THIRD_PARTY = ("unitree_g1", "fourier_n1", "robotis_op3")


def together(runs):
    """Traces by the keys of `runs`."""
    return dict(zip(runs, zmpwalk.simulate_batch(runs.values())))


def all_runs():
    runs = {
        ("ladder", v): {**walk_anywhere.walk(v), "duration": v / walk_anywhere.RAMP + STEADY}
        for v in (*walk_anywhere.LADDER, FASTEST)
    }
    for label, v in walk_anywhere.DIRECTIONS.items():
        runs["direction", label] = {"profile": VelocityProfile.ramp((0, 0, 0), v, 2.0), "duration": 10.0}
    runs["script"] = walk_anywhere.mixed()
    runs["stops"] = walk_anywhere.stops(2)
    for seed in range(SEEDS):
        points = walk_anywhere.jumps(seed)
        by_profile = {"profile": VelocityProfile.piecewise(points)}
        by_command = {"profile": VelocityProfile.constant(0.0), "command": walk_anywhere.live(points)}
        runs["jumps", seed] = {**(by_command if seed % 2 else by_profile), "duration": walk_anywhere.JUMP_DURATION}
    runs["idle"] = {"profile": VelocityProfile.constant(0.0), "duration": 8.0}
    return runs


@pytest.fixture(scope="session")
def walked_anywhere():
    return together(all_runs())


@pytest.mark.parametrize("speed", walk_anywhere.LADDER)
def test_ladder_is_climbed_at_the_commanded_speed_and_the_estimate_holds(walked_anywhere, speed):
    trace = walked_anywhere["ladder", speed]
    assert not trace.meta["fell"], trace.meta["fall_time"]
    m = walk_anywhere.measure(trace, speed / walk_anywhere.RAMP + 1.0)
    assert 100 * abs(m["velocity"][0] / speed - 1) <= walk_anywhere.LARGEST_SPEED_ERROR
    assert m["median"].max() <= walk_anywhere.LARGEST_MEDIAN
    assert m["p95"].max() <= walk_anywhere.LADDER[speed]
    assert (m["torque"] < 100, m["saturated"], m["self_contacts"]) == (True, 0, 0)


def test_a_metre_a_second_is_walked_within_the_torque_limits(walked_anywhere):
    trace = walked_anywhere["ladder", FASTEST]
    assert not trace.meta["fell"], trace.meta["fall_time"]
    m = walk_anywhere.measure(trace, FASTEST / walk_anywhere.RAMP + 1.0)
    assert 100 * abs(m["velocity"][0] / FASTEST - 1) <= walk_anywhere.LARGEST_SPEED_ERROR
    assert (m["torque"] < 100, m["saturated"], m["self_contacts"]) == (True, 0, 0)


@pytest.mark.parametrize("label", walk_anywhere.DIRECTIONS)
def test_every_direction_is_walked_at_its_velocity(walked_anywhere, label):
    trace, v = walked_anywhere["direction", label], np.array(walk_anywhere.DIRECTIONS[label])
    assert not trace.meta["fell"], trace.meta["fall_time"]
    m = walk_anywhere.measure(trace, 4.0)
    assert m["velocity"] == pytest.approx(v, abs=0.02)
    assert (m["torque"] < 100, m["saturated"], m["self_contacts"]) == (True, 0, 0)
    assert m["median"].max() <= walk_anywhere.LARGEST_MEDIAN


def test_mixed_script_ends_where_its_commands_lead(walked_anywhere):
    trace = walked_anywhere["script"]
    assert trace.duration == pytest.approx(60.0) and not trace.meta["fell"]
    percent, _, angle, length = walk_anywhere.miss(trace)
    assert length > 5.0
    assert (percent < walk_anywhere.LARGEST_MISS[0], angle < walk_anywhere.LARGEST_MISS[1]) == (True, True)
    assert trace.at_rest[-1] and not trace.self_contacts.any()


def test_stops_within_three_steps_stands_still_and_starts_again(walked_anywhere):
    trace = walked_anywhere["stops"]
    assert not trace.meta["fell"], trace.meta["fall_time"]
    for steps, _, moved in walk_anywhere.stop_numbers(trace):
        assert steps <= walk_anywhere.LARGEST_STEPS
        assert moved < walk_anywhere.LARGEST_IDLE
    left, right = trace.foot_left[-1], trace.foot_right[-1]  # side by side, the ZMP in the middle
    assert abs(left[0] - right[0]) < 0.01
    assert np.linalg.norm(trace.zmp_meas[-1] - analysis.feet_pose(left, right)[:2]) < 0.02


@pytest.mark.parametrize("seed", range(SEEDS))
def test_jumps_of_the_command_do_not_fell_it(walked_anywhere, seed):
    trace = walked_anywhere["jumps", seed]
    assert not trace.meta["fell"], trace.meta["fall_time"]
    # the command's last value is what it walks
    last = trace.t > trace.t[-1] - 0.5
    assert trace.v_plan[last, 0] == pytest.approx(walk_anywhere.jumps(seed)[-1][1], abs=0.02)


def test_idle_standing_is_quiet(walked_anywhere):
    trace = walked_anywhere["idle"]
    still = trace.com[trace.t >= walk_anywhere.IDLE_FROM]
    assert 1e3 * np.ptp(still, axis=0).max() < walk_anywhere.LARGEST_IDLE
    assert trace.at_rest.all() and not np.diff(trace.phase).any()


def test_command_takes_effect_within_one_step():
    walk = {"profile": VelocityProfile.constant(0.2), "duration": 5.0}
    changed = zmpwalk.simulate(**walk, command=lambda t, out: 0.25 if t >= 3.0 else None)
    assert np.isnan(changed.command[changed.t < 3.0]).all()
    assert changed.v_plan[(changed.t > 2.0) & (changed.t < 3.0), 0] == pytest.approx(0.2)
    later = changed.t >= 3.0 + STEP
    assert changed.v_plan[later, 0] == pytest.approx(0.25)
    assert changed.rerun() == changed


def test_command_function_is_called_every_20_ms_and_may_end_the_walk():
    called = []

    def command(t, out):
        called.append(t)
        assert out.t == t
        if t > 0.51:
            raise StopIteration
        return 9.0, 0.0, 0.0  # as fast as the robot can

    trace = zmpwalk.simulate(profile=VelocityProfile.constant(0.0), duration=4.0, command=command)
    assert called == pytest.approx(0.02 * np.arange(27))
    assert len(trace.t) == 521 and trace.meta["requested_duration"] == pytest.approx(0.521)
    limit = zmpwalk.WalkingController(*zmpwalk.load_robot("mahru")).speed_limit
    assert trace.command[-1] == pytest.approx([limit, 0, 0])
    assert trace.command_limit[-1] == 2  # torque of a hip
    assert trace.rerun() == trace


@pytest.mark.parametrize(
    ("value", "error"), [(math.nan, InputError), ("fast", InputError), ((1, 2), zmpwalk.DimensionError)]
)
def test_what_a_command_function_gets_wrong_is_raised(value, error):
    with pytest.raises(error):
        zmpwalk.simulate(profile=VelocityProfile.constant(0.0), duration=1.0, command=lambda t, out: value)
    with pytest.raises(ZeroDivisionError):
        zmpwalk.simulate(profile=VelocityProfile.constant(0.0), duration=1.0, command=lambda t, out: 1 / 0)


@pytest.mark.parametrize("name", THIRD_PARTY)
def test_other_robots_follow_a_mix_of_commands(test_robots, name):
    trace = zmpwalk.simulate(**walk_anywhere.robot_walk(str(test_robots / name / "robot.json")))
    assert not trace.meta["fell"], trace.meta["fall_time"]
    percent, _, angle, _ = walk_anywhere.miss(trace)
    assert (percent < walk_anywhere.LARGEST_MISS[0], angle < walk_anywhere.LARGEST_MISS[1]) == (True, True)
    assert trace.torque_ratio.max() < 1
