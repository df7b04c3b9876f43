"""What each ingredient is for: taken out, where it matters, the walk ends or the estimate leaves its bounds.

Every test first walks with the ingredient in place, so that what fails is its absence.
"""

import numpy as np
import pytest
import zmpwalk
from zmpwalk import RobotDescription, WalkSettings, analysis

MM = 1e-3


def walk(duration=9.0, robot="mahru", **settings):
    """A walk without the crouch, which would put off the fall that shows what an ingredient is for."""
    return zmpwalk.simulate(robot, duration=duration, settings=WalkSettings(fall_crouch=False, **settings))


def assert_stands(trace):
    assert not trace.meta["fell"], (trace.meta["fall_time"], trace.meta["fall_cause"])


def assert_falls(trace, before):
    """It falls, and is lost before that time, whether the fall is foreseen or has come."""
    assert trace.meta["fell"]
    assert trace.meta["fall_cause"]
    assert min(trace.fall.foreseen or trace.fall.time, trace.fall.time) < before


# --- sharing the load of two feet


def test_wrench_distribution_holds_the_default_up():
    """Minimum-norm torque knows nothing of feet that can only push."""
    assert_stands(walk(contact_damping=0.0))
    assert_falls(walk(contact_damping=0.0, wrench_distribution=False, fall_foot_tilt=0.3), before=0.5)


def test_wrench_distribution_holds_the_paper_law_up():
    assert_falls(walk(law="paper", wrench_distribution=False), before=0.5)


def double_support_cop(trace):
    """|CoP| that the torque asks of each foot in double support, about its sole centre; NaN without load."""
    f = trace.f_c[trace.phase == 0].reshape(-1, 2, 6)
    f = np.where(np.abs(f[..., 2:3]) > 1.0, f, np.nan)
    return np.abs(np.stack([-f[..., 4] / f[..., 2], f[..., 3] / f[..., 2]], axis=-1))


def test_wrench_distribution_asks_of_each_foot_what_its_sole_can_give():
    """The damping of the idle foot, an addition of ours, holds the default up without; but the estimate is lost."""
    shared, alone = walk(5.0), walk(5.0, wrench_distribution=False)
    sole = np.array([0.125, 0.07])  # half of it [m]
    error = []
    for trace in (shared, alone):
        double = (trace.phase == 0) & np.isfinite(trace.zmp_meas).all(axis=1)
        error.append(np.median(np.abs(trace.zmp_est - trace.zmp_meas)[double], axis=0))
    assert not np.any(double_support_cop(shared) > sole)
    assert np.mean(np.any(double_support_cop(alone) > sole, axis=(1, 2))) > 0.9
    assert error[0].max() < 0.1 * MM
    assert error[1].min() > 5 * MM


# --- posture


def arms_up(angle):
    """The robot with its arms raised forward by `angle` [rad] at the start pose."""
    model, d = zmpwalk.load_robot("mahru")
    joints = dict(d.stand_joints)
    for side, sign in (("l", 1), ("r", -1)):
        joints.update({f"{side}_shoulder_pitch": -angle, f"{side}_shoulder_roll": 0.15 * sign, f"{side}_elbow": -0.05})
    pose = {"stand_joints": joints, "stand_base_pos": d.stand_base_pos, "stand_base_quat": d.stand_base_quat}
    return model, RobotDescription(name="arms up", root_joint=d.root_joint, left=d.left, right=d.right, **pose)


def waist_and_arms(trace):
    names = trace.meta["joint_names"]
    upper = [i for i, name in enumerate(names) if not any(part in name for part in ("hip", "knee", "ankle"))]
    assert len(upper) == 13
    return trace.qpos[:, 7:][:, upper]


def test_posture_task_keeps_raised_arms_and_the_walk():
    for angle in (2.5, 3.1):
        robot = arms_up(angle)
        held = walk(20.0, robot)
        assert_stands(held)
        assert np.abs(waist_and_arms(held) - waist_and_arms(held)[0]).max() < 0.02
        assert_falls(walk(20.0, robot, posture_task=False), before=20.0)


def test_without_posture_task_hanging_arms_swing_into_their_limits():
    """Arms that hang are stable by their weight: the walk goes on, while they swing further until they hit."""
    held, loose = walk(8.0), walk(8.0, posture_task=False)
    assert np.abs(waist_and_arms(held) - waist_and_arms(held)[0]).max() < 0.02
    swing = np.abs(waist_and_arms(loose) - waist_and_arms(loose)[0]).max(axis=1)
    assert swing[2000] < 0.1 < 0.2 < swing[:5500].max() < swing.max()
    assert held.joint_margin.min() > 0
    assert loose.joint_margin.min() < 0
    assert loose.t[np.argmax(loose.joint_margin < 0)] == pytest.approx(6.5, abs=1.5)


# --- the first double support


def test_computed_first_double_support_starts_the_orbit():
    """Without the lateral feedback an error of the start never decays; with it, 0.16 s walks too."""
    assert_stands(walk(lateral_law="paper"))
    assert_falls(walk(lateral_law="paper", T_ds_first=0.16), before=3.0)
    assert_stands(walk(T_ds_first=0.16))
    assert_falls(walk(law="paper", T_ds_first=0.16), before=3.0)


# --- what (8) is given


def test_measured_state_without_feed_forward_falls_within_half_a_second():
    """(16) from the measured state is one cycle ahead, so (8) asks for k_d dt of what is wanted.

    Torques are cut here: where limits are kept, they hold the robot up a little longer.
    """
    setting = {"tracker": "bang_bang", "bound_lateral": False, "keep_limits": False}
    assert_falls(walk(feed_forward=False, **setting), before=0.5)
    assert walk(2.0, **setting).meta["fell"] is False  # the same with feed-forward is still up then
    assert_stands(walk(law="paper"))  # and so is the desired state without it


# --- the ZMP part


def test_tracker_keeps_the_estimate_inside_its_bounds():
    """Staying up does not prove the ZMP part; this does."""
    on, off = walk(), walk(zmp_modification=False)
    assert_stands(on)
    assert_stands(off)
    assert not off.iterations.any()
    beyond = (analysis.bound_excess(off, single_support=False) > 10 * MM).any(axis=1)
    assert beyond.sum() > 100
    assert analysis.bound_excess(on, single_support=False).max() <= 1 * MM


# --- footholds


def test_footholds_tied_to_the_com_bring_the_feet_under_it():
    tied, placed = (np.abs(analysis.midstance_offset(walk(footsteps=name)))[5:] for name in ("tied", "paper"))
    assert tied.max() < 15 * MM
    assert placed.min() > 25 * MM


# --- the swing foot's feed-forward


def test_swing_feed_forward_lands_the_foot_where_it_was_sent():
    error = []
    for on in (True, False):
        # Soft enough to need it; by time, since a foot that felt the ground early would stay where it touched.
        trace = walk(5.0, swing_feed_forward=on, swing_kp=900.0, swing_kd=60.0, touch_down="time")
        assert_stands(trace)
        last = np.flatnonzero((trace.phase[:-1] == 1) & (trace.phase[1:] == 0))
        landed = np.where(trace.support[last, None] > 0, trace.foot_right[last], trace.foot_left[last])
        error.append(np.abs(landed[:, :2] - trace.foothold[last, :2]).max())
    assert error[0] < 2 * MM < error[1]
