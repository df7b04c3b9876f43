"""What depends on MuJoCo, in short: `make smoke` runs it under versions between the two that the whole suite runs with.

ZMPWALK_REFERENCE names the trace of a walk under another MuJoCo, which is then repeated here; without it the walk is
this MuJoCo's own.
"""

import os
import warnings

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk import Error, Trace, WalkSettings, render

SAME = 1e-8  # distance of the COM between MuJoCo versions [m]


@pytest.fixture(scope="module")
def recorded():
    """A walk under this MuJoCo or another."""
    reference = os.environ.get("ZMPWALK_REFERENCE")
    if reference:
        return Trace.load(reference)
    return zmpwalk.simulate("mahru", duration=2.4, settings=WalkSettings(kernel="x86-64"))


@pytest.fixture(scope="module")
def again(recorded):
    """That walk once more, here."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # another MuJoCo may have walked it
        return recorded.rerun()


def test_the_walk_is_that_of_every_mujoco(recorded, again):
    assert not again.meta["fell"]
    assert again.meta["versions"]["mujoco"] == mujoco.__version__
    assert np.abs(again.com - recorded.com).max() < SAME
    assert np.nanmax(np.abs(again.zmp_est - recorded.zmp_est)) < 1e-6


def test_estimate_is_what_the_contacts_of_this_mujoco_say(again):
    error = np.abs(again.zmp_est - again.zmp_meas)[again.phase == 1]
    assert np.percentile(error, 95) < 3e-4


def test_trace_of_another_mujoco_is_filmed(recorded):
    try:
        image = render.snapshot(recorded, t=1.0, width=64, height=48)
    except Error as error:
        if "off screen" not in str(error):
            raise
        pytest.skip(str(error))  # there is no OpenGL at all
    assert image.std() > 5.0  # the robot, not one colour


def test_a_walk_is_inspected_pushed_and_unsure():
    _, proposal = zmpwalk.robots.examine("mahru")
    assert proposal.table["zmp_bounds_m"]
    trace = zmpwalk.simulate(
        "mahru", 0.1, 1.0, push=[(0.5, 0.05, None, (0, 30, 0))], uncertainty={"noise": 1, "mass": 1.02}, on_fall="go_on"
    )
    assert not trace.meta["fell"]
    assert trace.rerun() == trace


def test_arms_move_and_a_task_is_met():
    motion = zmpwalk.JointMotion([0, 1], ["l_elbow"], [[-0.3], [-0.8]])
    task = zmpwalk.FrameTask("right_hand")
    trace = zmpwalk.simulate("mahru", 0.1, 1.2, motion=motion, tasks=[task])
    assert not trace.meta["fell"]
    assert trace.qpos[-1, trace.model.joint("l_elbow").qposadr[0]] < -0.5
