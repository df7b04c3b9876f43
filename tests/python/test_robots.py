"""Third-party robots walk with the defaults alone; only the description differs."""

import numpy as np
import pytest
import zmpwalk
from zmpwalk import analysis

ROBOTS = ("unitree_g1", "fourier_n1", "robotis_op3")


@pytest.fixture(scope="module", params=ROBOTS)
def walk(request, test_robots):
    """20 s of each robot at Froude number v / sqrt(g z_c) = 0.06, reached in 3 s."""
    model, description = zmpwalk.load_robot(str(test_robots / request.param / "robot.json"))
    com_height = zmpwalk.WalkingController(model, description, profile=zmpwalk.VelocityProfile.constant(0.0)).com_height
    speed = 0.06 * np.sqrt(9.81 * com_height)
    trace = zmpwalk.simulate((model, description), profile=zmpwalk.VelocityProfile.ramp(0.0, speed, 3.0), duration=20.0)
    return model, description, speed, trace


def test_robot_walks_at_the_planned_speed(walk):
    _, _, speed, trace = walk
    summary = trace.summary()
    assert not summary["fell"]
    walked = np.array(summary["mean_speed_per_step"])
    planned = np.array(summary["planned_speed_per_step"])
    assert np.abs(walked - planned)[5:].max() <= 0.01 * speed


def test_robot_stays_within_its_torques(walk):
    assert walk[3].torque_ratio.max() < 1.0


def test_estimate_matches_contact_forces_in_single_support(walk):
    model, description, _, trace = walk
    error = analysis.zmp_error(trace, single_support=True)
    # Ankle dry friction that the tanh does not know sets a floor: friction / (m g).
    weight = 9.81 * np.sum(model.body_mass)
    limit = 1e-3 * description.left.length / 0.25 + 1.5 * np.max(model.dof_frictionloss) / weight
    assert (np.median(error, axis=0) <= 3e-4).all()
    assert (np.percentile(error, 95, axis=0) <= limit).all()
