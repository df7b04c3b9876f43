"""law="paper": what section IV says of the walk, read from the trace; the numbers are in tests/data."""

import json
from pathlib import Path

import numpy as np
import pytest
import zmpwalk
from zmpwalk import VelocityProfile, WalkSettings, analysis

PAPER = json.loads((Path(__file__).parents[1] / "data" / "paper_section_iv.json").read_text())
CHATTER = 0.003  # [s]: windows shorter than this do not count; tests/data/README.md says why
LOWER, UPPER = -1, 1
PERIOD = 0.8  # [s]


@pytest.fixture(scope="module")
def walk():
    return zmpwalk.simulate("mahru", duration=30.0, settings=WalkSettings(law="paper"))


@pytest.fixture(scope="module")
def windows(walk):
    return analysis.zmp_windows(walk, shortest=CHATTER)


def overlap(window, paper):
    return min(window.end, paper[1]) - max(window.start, paper[0])


def test_setting_is_the_papers(walk):
    settings = walk.meta["settings"]
    assert (settings["tracker"], settings["iteration"], settings["com_state"]) == ("bang_bang", "loop", "desired")
    assert (settings["feed_forward"], settings["lateral_law"]) == (False, "paper")
    assert settings["zmp_threshold"] == PAPER["iteration_threshold"]["value"]
    assert settings["T_ss"] == pytest.approx(PAPER["support_times"]["single"])
    assert settings["T_ds"] == pytest.approx(PAPER["support_times"]["double"])
    assert settings["step_width"] == pytest.approx(PAPER["foot_distance"]["lateral"])
    assert settings["step_lengths"] == PAPER["step_lengths"]["printed"][:3]  # 0.2 m repeats: the erratum of section IV
    profile = VelocityProfile.paper()
    assert profile.t == PAPER["planned_velocity"]["time"]
    assert profile.v[:, 0].tolist() == PAPER["planned_velocity"]["velocity"]
    model, description = zmpwalk.load_robot("mahru")
    assert model.nu == PAPER["robot"]["joints"]
    foot = description.left
    assert (foot.length, foot.width) == (PAPER["robot"]["foot_length"], PAPER["robot"]["foot_width"])


def test_walks_30_seconds(walk):
    assert not walk.meta["fell"]
    assert len(walk.t) == 30000
    assert walk.step[-1] >= 36


def test_com_follows_the_plan(walk):
    moved = np.diff(walk.com[::800, 0])
    planned = [walk.profile.displacement(PERIOD * k, PERIOD * (k + 1))[0] for k in range(len(moved))]
    assert moved == pytest.approx(planned, rel=0.01)


def test_at_0_8_s_it_stays_on_the_lower_bound_until_the_integral_is_zero(walk, windows):
    paper = PAPER["velocity_change_at_0_8"]
    window = next(w for w in windows if w.start >= paper["start"] - 1e-6)
    assert window.bound == LOWER
    assert window.start == pytest.approx(paper["start"], abs=0.002)
    assert window.end == pytest.approx(paper["end"], abs=0.03)
    integral = walk.v_error_integral[:, 0]
    during = (walk.t >= window.start) & (walk.t < window.end - 1e-6)
    assert np.all(integral[during] < 0)
    after = integral[np.searchsorted(walk.t, window.end - 1e-6)]
    assert after == pytest.approx(0.0, abs=2e-4)  # what one cycle adds
    above = analysis.in_support_axes(walk, walk.zmp_des - walk.zmp_lower)[during, 0]
    assert np.allclose(above, 0.0, rtol=0, atol=1e-12)


def test_at_2_4_s_it_does_not_reach_the_lower_bound(walk, windows):
    """The change itself asks for little; a lower window later in that step is the tail of an upper one."""
    change = PAPER["velocity_change_at_2_4"]["time"]
    response = (walk.t >= change - 1e-6) & (walk.t < change + 0.1)
    assert not np.any(walk.zmp_modified[response, 0] == LOWER)
    for before, window in zip(windows, windows[1:]):
        if window.bound == LOWER and change <= window.start < change + PERIOD:
            assert before.bound == UPPER
            assert window.start - before.end <= 0.002


@pytest.mark.parametrize("k", range(4))
def test_from_4_s_on_it_is_on_the_upper_bound_when_the_papers_is_then_at_once_on_the_lower(windows, k):
    paper = PAPER["upper_bound_windows"]["windows"][k]
    upper = [i for i, w in enumerate(windows) if w.bound == UPPER and overlap(w, paper) > 0]
    assert len(upper) == 1
    window, after = windows[upper[0]], windows[upper[0] + 1]
    assert window.end == pytest.approx(paper[1], abs=0.08)
    assert after.bound == LOWER
    assert after.start - window.end <= 0.002


def test_from_4_s_on_that_happens_once_per_step(walk, windows):
    late = [w for w in windows if w.end > 4.0 and w.start < walk.t[-1] - PERIOD]  # the last pair may be cut by the end
    assert [w.bound for w in late] == [UPPER, LOWER] * (len(late) // 2)
    # Steps counted from the middle of one single support to the next.
    first_double = walk.meta["settings"]["T_ds_first"]
    steps = [int((w.end - first_double - 0.32) // PERIOD) for w in late if w.bound == UPPER]
    assert steps == list(range(steps[0], steps[0] + len(steps)))
    assert len(steps) >= 31


def test_estimate_is_on_the_desired_zmp_to_the_threshold(walk):
    on_bound = walk.zmp_modified[:, 0] != 0
    assert np.abs(walk.zmp_est - walk.zmp_des)[on_bound].max() < PAPER["iteration_threshold"]["value"]
    assert not walk.zmp_modified[:, 1].any()  # the paper bounds the sagittal ZMP only


def test_lateral_zmp_switches_in_double_support_where_w_of_T_is_zero(walk):
    """Fig. 5: w(T) falls to zero, and the ZMP moves to the other foot."""
    times = analysis.switch_times(walk)
    assert np.all((times > 0) & (times < 0.19))
    for at in np.flatnonzero(np.diff(walk.support) != 0)[:20]:
        before = np.abs(walk.w_T[at - 20 : at + 1])
        assert np.all(np.diff(before[:-1]) < 0)
        assert before[-1] <= before[-3] - before[-2]  # within one cycle of zero


def spread(walk):
    return np.ptp(analysis.switch_times(walk)[5:])


def test_switch_wanders_and_orbit_feedback_holds_it(walk):
    """What ends the literal law after a minute or three: docs/paper_law.md."""
    held = zmpwalk.simulate("mahru", duration=30.0, settings=WalkSettings(law="paper", lateral_law="orbit"))
    assert spread(walk) > 0.03
    assert spread(held) < 0.002
    drift = np.diff(analysis.midstance_offset(held)[5:])
    # the other, slower one: COM and feet part; 1.65e-4 with swing_kp=900, swing_kd=60
    assert drift.mean() == pytest.approx(1.0e-4, abs=5e-5)


# --- the list of steps as printed


def controller(profile=None, **settings):
    return zmpwalk.WalkingController(*zmpwalk.load_robot("mahru"), WalkSettings(**settings), profile)


def leads(walk):
    """How far each landed foot stands ahead of the other, in mid double support [m]."""
    rows = np.flatnonzero((walk.phase == 0) & (np.abs(walk.phase_time - 0.08) < 5e-4) & (walk.step > 0))
    return np.abs(walk.foot_left[rows, 0] - walk.foot_right[rows, 0])


def test_printed_steps_are_reported_as_a_mismatch_and_fall():
    printed = PAPER["step_lengths"]["printed"]
    feet, plan = printed[-1] / PERIOD, PAPER["planned_velocity"]["velocity"][-1]
    settings = {"law": "paper", "footsteps": "printed"}
    assert controller(**settings).plan_mismatch(12.0) == pytest.approx(feet - plan, abs=1e-9)
    assert feet - plan == pytest.approx(0.0625)  # [m/s]
    walk = zmpwalk.simulate("mahru", duration=12.0, settings=WalkSettings(**settings))
    assert walk.meta["fell"]
    assert walk.meta["fall_cause"]
    assert 3.0 < walk.meta["fall_time"] < 6.0  # after the fourth step, the first that is too long
    assert walk.t[-1] == pytest.approx(walk.meta["fall_time"], abs=0.0011)
    assert walk.fell[-1] == 1


def test_corrected_steps_are_no_mismatch():
    assert abs(controller(law="paper").plan_mismatch(12.0)) < 1e-3  # the paper's velocities are rounded to mm/s


@pytest.mark.parametrize("law", ["paper", "default"])
def test_steps_of_a_quarter_metre_walk_at_the_speed_that_fits_them(law):
    """So it is the mismatch that fells the printed list, not the length.

    The literal law with orbit feedback: without, its wandering switch ends it after 9 to 45 s, by chance.
    """
    printed = PAPER["step_lengths"]["printed"]
    before, after = [0.0, *printed], [*printed, printed[-1]]
    fits = [0.5 * (a + b) / PERIOD for a, b in zip(before, after)]
    assert fits[-1] == pytest.approx(0.3125)
    profile = VelocityProfile.piecewise([(PERIOD * k, v) for k, v in enumerate(fits)])
    assert controller(profile, law=law, footsteps=printed).plan_mismatch(12.0) == pytest.approx(0.0, abs=1e-12)
    settings = WalkSettings(law=law, footsteps=printed, lateral_law="orbit")
    # Whole periods: the bang-bang tracker brings the integral of the velocity error to zero once in each.
    walk = zmpwalk.simulate("mahru", profile, 15 * PERIOD, settings)
    assert not walk.meta["fell"]
    assert leads(walk)[4:] == pytest.approx(0.25, abs=0.003)
    speed = (walk.com[-1, 0] - walk.com[-1 - 4000, 0]) / 4.0
    assert speed == pytest.approx(0.3125, rel=0.005)


def test_default_takes_the_printed_steps_no_longer_than_its_plan():
    """Footholds tied to the COM: steps follow the planned velocity by themselves, so there is nothing to mismatch."""
    assert controller().plan_mismatch(12.0) == 0.0
