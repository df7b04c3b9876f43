"""Robots of several makers walk with the defaults alone; only the description differs: benchmarks/robots.py."""

import numpy as np
import pytest
import robots
import zmpwalk

ROBOTS = ("mahru", "unitree_g1", "fourier_n1", "robotis_op3")


@pytest.fixture(scope="module", params=[(name, k) for name in ROBOTS for k in range(len(robots.FROUDE) + 1)], ids=str)
def walk(request):
    """60 s at a Froude speed, reached in 3 s, or up and down between all of them."""
    name, k = request.param
    path = name if name == "mahru" else str(request.getfixturevalue("test_robots") / name / "robot.json")
    model, description = zmpwalk.load_robot(path)
    still = zmpwalk.WalkingController(model, description, profile=zmpwalk.VelocityProfile.constant(0.0))
    _, profile = list(robots.profiles(np.sqrt(9.81 * still.com_height)))[k]
    return robots.measure(model, description, profile)


def test_robot_walks_at_the_planned_speed(walk):
    assert walk["fell"] is None
    assert walk["speed_percent"] <= 1.0


def test_robot_stays_within_its_torques(walk):
    assert walk["torque"] < 100.0


def test_estimate_matches_contact_forces_in_single_support(walk):
    assert (walk["single_median"] <= 0.3).all()  # mm
    assert (walk["single_p95"] <= walk["limit"]).all()
