"""benchmarks/peers without the peers: the exported robot is our robot, and the report names what it must."""

import importlib.util
from pathlib import Path

import mujoco
import numpy as np
import pytest
import zmpwalk

BENCHMARKS = Path(__file__).resolve().parents[2] / "benchmarks"


def load(path):
    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


urdf = load(BENCHMARKS / "peers" / "urdf.py")
report = load(BENCHMARKS / "report.py")


@pytest.fixture(scope="module")
def robot():
    model, description = zmpwalk.load_robot("mahru")
    return model, description, zmpwalk.Robot(model, description)


def test_exported_robot_has_the_inertia_and_gravity_of_ours(robot):
    model, description, ours = robot
    root = description.root_joint
    text = urdf.export(model, root, ours.torque_limit, {"left_sole": ("l_foot", np.zeros(3), [1.0, 0, 0, 0])})
    exported = mujoco.MjModel.from_xml_string(text)  # MuJoCo reads URDF too; its root stands fixed
    names = [mujoco.mj_id2name(exported, mujoco.mjtObj.mjOBJ_JOINT, j) for j in range(exported.njnt)]
    order = [names.index(name) for name in urdf.joint_names(model, root)]
    mine, theirs, random = mujoco.MjData(model), mujoco.MjData(exported), np.random.default_rng(0)
    for _ in range(5):
        q, dq = random.uniform(-1, 1, (2, len(order)))
        description.place(model, mine)
        mine.qpos[7:], mine.qvel[6:] = q, dq
        theirs.qpos[order], theirs.qvel[order] = q, dq
        mujoco.mj_forward(model, mine)
        mujoco.mj_forward(exported, theirs)
        A = np.zeros((exported.nv, exported.nv))
        if hasattr(theirs, "qM"):
            mujoco.mj_fullM(exported, A, theirs.qM)
        else:
            mujoco.mj_fullM(exported, theirs, A)
        dynamics = ours.read(mine)
        expected = dynamics.A[6:, 6:] - np.diag(urdf.armature(model, root))
        assert np.allclose(A[np.ix_(order, order)], expected, rtol=0, atol=1e-12)
        assert np.allclose(theirs.qfrc_bias[order], (dynamics.b + dynamics.g)[6:], rtol=0, atol=1e-10)


def test_states_come_back_from_the_convention_of_pinocchio(robot):
    model = robot[0]
    random = np.random.default_rng(0)
    qpos, qvel = random.normal(size=model.nq), random.normal(size=model.nv)
    qpos[3:7] /= np.linalg.norm(qpos[3:7])
    q, v = urdf.to_pinocchio(qpos, qvel)
    assert np.array_equal(q[[6, 3, 4, 5]], qpos[3:7])
    # A point mass on the base: kinetic energy and momentum rate are the same numbers in both.
    M = np.diag(np.concatenate([[3.0] * 3, np.zeros(len(v) - 3)]))
    h = np.zeros(len(v))
    h[:3] = 3.0 * np.cross(v[3:6], v[:3])  # m omega x v in base axes
    A, h_world = urdf.from_pinocchio(qpos, qvel, M, h)
    assert np.isclose(qvel @ A @ qvel, v @ M @ v, rtol=1e-14)
    assert np.allclose(h_world, 0.0, atol=1e-14)  # nothing pulls at it


def test_every_ratio_stands_beside_what_the_peers_do_more_and_the_cpu_is_named():
    times = {"min": 10.0, "median": 12.0}
    slow = {"min": 60.0, "median": 84.0}
    peers = {"tsid_cpp": slow, "tsid_python": slow, "placo_python": slow}
    ours = {"zmpwalk_cpp": times, "zmpwalk_python": times, "zmpwalk_cpp_in_loop": times, "mj_step_cpp": times}
    answers = {"acceleration": 1e-5, "zmp_mm": 1e-4, "torque_motion": 1e-4, "torque": 40.0}
    agreement = {who: dict.fromkeys(("ss", "ds", "stand"), answers) for who in peers}
    size = {"variables": 1, "equalities": 2, "inequalities": 3}
    table = report.peers_table(
        {
            "cpu": "Some CPU",
            "python": "3.10",
            "peers_python": "3.10",
            "compiler": "c++ 1",
            "kernel": "v3",
            "versions": {"tsid": "1"},
            "rounds": 1,
            "ticks": 1,
            "states": {"ss": 1, "ds": 1},
            "size": {"ss": size, "ds": size},
            "active": {"ss": [0], "ds": [3], "stand": [0]},
            "agreement": {"model": {"inertia": 1e-15}, **agreement},
            "ss": {**ours, **peers},
            "ds": {**ours, **peers},
            "stand": peers,
            "plan": {"placo_python": {"10": {"min": 1e3, "median": 2e3, "planned_s": 3.2}}},
        }
    )
    ratios = [line for line in table.splitlines() if "**" in line]
    assert len(ratios) == len(peers)
    assert all("6.0 × / 7.0 ×" in line and report.INEQUALITIES in line for line in ratios)
    assert "Some CPU" in table.splitlines()[0]


def test_a_section_is_filled_once_and_a_page_without_it_is_refused():
    page = "# A\n\n<!-- peers -->\nold\n<!-- /peers -->\nend\n"
    filled = report.fill(page, "peers", "new")
    assert filled == "# A\n\n<!-- peers -->\n\nnew\n\n<!-- /peers -->\nend\n"
    assert report.fill(filled, "peers", "new") == filled
    with pytest.raises(ValueError, match="peers"):
        report.fill("# A\n", "peers", "new")
