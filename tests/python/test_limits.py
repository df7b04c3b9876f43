"""Where limits bite, the torque that is sent keeps them, the estimate knows it, and the walk goes on."""

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk import VelocityProfile, WalkSettings, simulate

WEAK = {"l_knee": 60.0, "r_knee": 60.0}


def held(trace):
    return (trace.limit_soles > 0) | (trace.limit_torques > 0) | (trace.limit_ranges > 0)


@pytest.fixture(scope="module")
def weak():
    return simulate(duration=5.0, settings=WalkSettings(torque_limits=WEAK))


def test_walk_with_weak_knees_goes_on_within_their_torque(weak):
    knees = [weak.meta["joint_names"].index(name) for name in WEAK]
    assert not weak.fell.any() and weak.t[-1] > 4.9
    assert held(weak).sum() > 300
    assert weak.torque_ratio.max() > 1.2  # what the closed form asks for
    assert np.abs(weak.tau[:, knees]).max() <= 60.0
    assert not weak.saturated.any()
    assert set(weak.limit_torques[held(weak)]) <= {
        float(sum(1 << k for k in some)) for some in (knees[:1], knees[1:], knees)
    }


def test_estimate_is_that_of_the_torque_that_is_sent(weak):
    error = np.abs(weak.zmp_est - weak.zmp_meas)[held(weak) & (weak.phase == 1)]
    assert np.nanmedian(error) < 1e-4


def test_the_same_walk_with_cut_torques_falls():
    trace = simulate(duration=5.0, settings=WalkSettings(torque_limits=WEAK, keep_limits=False))
    assert trace.fell[-1] and trace.saturated.any() and not held(trace).any()


def test_forces_stay_within_the_friction_that_is_told():
    trace = simulate(duration=4.0, settings=WalkSettings(friction=0.18))
    assert not trace.fell.any()
    assert (trace.limit_soles > 0).any()
    for side in (0, 6):
        f = trace.f_c[:, side : side + 3]
        assert (
            np.nanmax(np.hypot(f[:, 0], f[:, 1]) + 0.18 * f[:, 2]) < 0.2
        )  # N; the soles are level but for their contact


def test_controller_names_the_limits_that_hold_it_back():
    model, description = zmpwalk.load_robot("mahru")
    data = mujoco.MjData(model)
    description.place(model, data)
    controller = zmpwalk.WalkingController(model, description, WalkSettings(torque_limits=WEAK))
    controller.reset(data)
    names = set()
    while data.time < 2.0:
        out = controller.update(data)
        assert bool(controller.active_limits) == bool(out.limit_torques or out.limit_soles or out.limit_ranges)
        names.update(controller.active_limits)
        mujoco.mj_step(model, data)
    assert names & {"torque of l_knee", "torque of r_knee"}


def test_paper_law_cuts_and_the_default_keeps():
    assert WalkSettings().keep_limits and not WalkSettings("paper").keep_limits


def shoulders(trace):
    names = trace.meta["joint_names"]
    return np.abs(np.diff([trace.qpos[:, 7 + names.index(f"{side}_shoulder_pitch")] for side in "lr"], axis=0)[0])


def test_arms_help_while_a_sole_cannot_hold_the_yaw_moment_and_come_home():
    """The floor is as rough as ever; only the controller thinks that it is slippery."""
    profile = VelocityProfile.piecewise([(0, 0), (1, 0.3), (4, 0.3), (5, 0)])
    helped, alone = (
        simulate(profile=profile, duration=9.0, settings=WalkSettings(friction=0.2, arms_reserve=share))
        for share in (1.0, 0.0)
    )
    yaw = (helped.limit_soles.astype(int) & 0x88) > 0
    assert yaw.any() and not helped.fell.any()
    first = np.flatnonzero(yaw)[0]
    assert np.array_equal(helped.tau[:first], alone.tau[:first])  # until then nothing is different
    assert shoulders(helped).max() > 0.1 and shoulders(alone).max() < 0.02  # rad
    assert shoulders(helped)[-1] < 0.02
    assert yaw.sum() < ((alone.limit_soles.astype(int) & 0x88) > 0).sum()


@pytest.mark.parametrize("seed", [0, 1])
def test_noise_of_real_sensors_never_cuts_a_torque(seed):
    trace = simulate(profile=0.25, duration=12.0, seed=seed, uncertainty={"noise": 1.0})
    assert not trace.fell.any() and not trace.saturated.any()


def test_walk_on_a_slippery_floor_that_nobody_told_goes_on_for_a_minute():
    trace = simulate(profile=VelocityProfile.ramp(0, 0.25, 2), duration=60.0, uncertainty={"ground_friction": 0.2})
    assert not trace.fell.any() and trace.t[-1] > 59.9
    late = trace.t > 10.0
    speed = (trace.com[-1, 0] - trace.com[late][0, 0]) / (trace.t[-1] - trace.t[late][0])
    assert speed == pytest.approx(0.25, rel=0.02)
