"""Random plausible humanoids walk with the defaults alone; docs/random_robots.md lists their limits."""

import mujoco
import numpy as np
import pytest
import random_humanoid as generator
import random_robots
import zmpwalk
from zmpwalk.robots import appraise

SEEDS = range(100)


@pytest.fixture(scope="module")
def rows():
    return [random_robots.walk(seed) for seed in SEEDS]


def test_at_least_95_of_100_walk(rows):
    assert sum(row["result"] == "walks" for row in rows) >= 95


def test_each_that_does_not_walk_is_explained(rows):
    for row in rows:
        assert row["result"] == "walks" or random_robots.explanations(row), row["seed"]


@pytest.fixture(scope="module")
def unsaturated(rows):
    some = [row for row in rows if row["result"] == "walks" and not row["saturated"]]
    assert len(some) >= 75
    return some


def test_speed_is_the_planned_one_within_the_torques(unsaturated):
    assert max(row["speed"] for row in unsaturated) <= 1.0  # percent


def test_estimate_matches_contact_forces_on_soles_that_stand_still(unsaturated):
    steady = [row for row in unsaturated if row["facts"]["feet"] != "mesh"]  # a mesh rocks on its few contact points
    median = np.array([max(row["median_mm"]) for row in steady])
    # Dry friction that the tanh does not know sets a floor, friction / (m g); heavy rotors on soft contacts another.
    floor = np.array([1.5e3 * row["facts"]["friction"] * row["facts"]["leg"] for row in steady])
    assert np.mean(median <= 0.3 + floor) >= 0.95
    assert np.median(median) <= 0.05


@pytest.mark.parametrize("seed", range(0, 300, 7))
def test_robot_is_inside_the_limits(seed):
    xml, facts = generator.random_humanoid(seed)
    assert generator.random_humanoid(seed) == (xml, facts)
    model = mujoco.MjModel.from_xml_string(xml)
    data = mujoco.MjData(model)
    names = ("left_hip_p", "left_knee", "left_ankle_p")
    joint = {name: mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name) for name in names}
    data.qpos[model.jnt_qposadr[joint["left_knee"]]] = 0.73 * model.jnt_range[joint["left_knee"]].sum() / 2.35
    mujoco.mj_forward(model, data)
    hip, knee, ankle = (data.xanchor[j] for j in joint.values())
    thigh, shank = np.linalg.norm(hip - knee), np.linalg.norm(knee - ankle)
    leg = thigh + shank
    lever = np.linalg.norm(np.cross(knee - hip, ankle - hip)) / np.linalg.norm(ankle - hip)
    mass = model.body_subtreemass[1]
    eps = 1e-6
    assert 0.2 - eps <= leg <= 0.9 + eps
    assert 0.4 - eps <= thigh / leg <= 0.6 + eps
    assert 0.5 - eps <= mass / (150 * leg**3) <= 2 + eps
    assert 0.3 - eps <= facts["foot_length"] / leg <= 0.5 + eps
    assert facts["foot_width"] / leg >= 0.12 - eps
    drives, weight = zmpwalk.describe(model).drives(model), 9.81 * mass
    limit = {joint[name]: drives[name][0] for name in names}
    toe = facts["foot_length"] - facts["heel"]
    assert limit[joint["left_ankle_p"]] >= (1.2 - eps) * weight * toe
    assert limit[joint["left_hip_p"]] >= (1.2 - eps) * weight * toe
    assert limit[joint["left_knee"]] >= (1.2 - eps) * weight * max(lever, toe - lever)
    assert 0 <= model.dof_armature[model.jnt_dofadr[joint["left_knee"]]] <= (0.5 + eps) * mass * leg**2


def remarks(change):
    """What is said of the bundled robot after a change of its model."""
    model, description = zmpwalk.load_robot("mahru")
    change(model, lambda name: mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name))
    return [text for text in appraise(model, description).remarks if "torque: " in text or "reach: " in text]


def test_nothing_keeps_the_bundled_robot_from_walking():
    assert remarks(lambda model, joint: None) == []


def test_heavy_rotors_and_weak_hips_are_remarked():
    def heavy(model, joint):
        model.dof_armature[model.jnt_dofadr[joint("l_knee")]] = 30.0

    def weak(model, joint):
        model.actuator_ctrlrange[model.actuator_trnid[:, 0] == joint("r_hip_roll")] = (-50.0, 50.0)

    assert ["swinging knee" in text for text in remarks(heavy)] == [True]
    assert [text.startswith("torque: r_hip_roll is too weak") for text in remarks(weak)] == [True]
