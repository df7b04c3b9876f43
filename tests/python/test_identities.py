"""Equations 1-13 on the whole robot: identities, the equation of motion, and three routes to one torque.

States are drawn about `stand`; every bound is absolute, on the largest entry.
"""

import mujoco
import numpy as np
import pytest
import zmpwalk
from numpy.testing import assert_allclose
from zmpwalk import _core

SEEDS = range(20)
STANCES = ("left", "right", "both")
EXACT = 1e-9


@pytest.fixture(scope="module", params=["base at the pelvis", "base at the trunk, waist inside the legs' chain"])
def robot(request, mahru_edited):
    if "trunk" in request.param:
        text = mahru_edited.xml(mahru_edited.hang_pelvis_from_torso)
        model, description = zmpwalk.load_robot(mujoco.MjModel.from_xml_string(text))
    else:
        model, description = zmpwalk.load_robot("mahru")
    return model, _core.Robot(model, description), mujoco.MjData(model)


class State:
    """One random instant with its contact Jacobian, its stacked tasks and commanded accelerations for them."""

    def __init__(self, robot, stance, seed, posture=True):
        model, reader, data = robot
        rng = np.random.default_rng([seed, STANCES.index(stance)])
        names = reader.joint_names
        q = model.key("stand").qpos[7:] + rng.uniform(-0.3, 0.3, len(names))
        knees = [names.index("l_knee"), names.index("r_knee")]
        q[knees] = np.maximum(q[knees], 0.3)
        tilt = rng.normal(size=4) * 0.1 + [1, 0, 0, 0]
        data.qpos[:] = np.concatenate([rng.uniform(-1, 1, 3), tilt / np.linalg.norm(tilt), q])
        data.qvel[:] = rng.uniform(-1, 1, model.nv)
        self.dyn = d = reader.read(data)
        self.qpos, self.qvel, self.rng = data.qpos.copy(), data.qvel.copy(), rng
        self.standing = (stance != "right", stance != "left")
        self.support = "right" if stance == "right" else "left"
        soles = [d.left, d.right]
        feet = [sole for sole, stands in zip(soles, self.standing) if stands]
        self.J_c = np.vstack([sole.J for sole in feet])
        self.drift_c = np.concatenate([sole.drift for sole in feet])
        self.legs = reader.leg_joints
        self.free = [j for j in range(len(names)) if j not in self.legs[0] + self.legs[1]]
        self.f_star = _core.TaskAccelerations(*(rng.normal(size=n) for n in (3, 3, 6, len(names))))
        J_trunk = np.zeros((3, d.nv))
        J_trunk[:, 3:6] = d.R_WB  # a free joint turns in its own body's axes; these turn along omega, so no drift
        J, drift, f = [d.J_com, J_trunk], [d.drift_com, np.zeros(3)], [self.f_star.com, self.f_star.trunk]
        if stance != "both":
            swing = soles[stance == "left"]
            J, drift, f = [*J, swing.J], [*drift, swing.drift], [*f, self.f_star.swing]
        if posture:
            rows = np.eye(d.nv)[[6 + j for j in self.free]]
            J, drift, f = [*J, rows], [*drift, np.zeros(len(rows))], [*f, self.f_star.posture[self.free]]
        self.J, self.drift, self.f = np.vstack(J), np.concatenate(drift), np.concatenate(f)
        self.h = d.b + d.g
        self.contact = _core.ContactSpace(A=d.A, b=d.b, g=d.g, J_c=self.J_c, drift_c=self.drift_c)
        self.task = _core.TaskSpace(self.contact, d.b, d.g, self.J, self.drift)

    def motion(self, tau):
        """Acceleration and wrench that `tau` leads to, from the equation of motion and the contact alone."""
        m = len(self.J_c)
        K = np.block([[self.dyn.A, self.J_c.T], [self.J_c, np.zeros((m, m))]])
        x = np.linalg.solve(K, np.concatenate([np.r_[np.zeros(6), tau] - self.h, -self.drift_c]))
        return x[: self.dyn.nv], x[self.dyn.nv :]

    def square_inverse_dynamics(self):
        """Acceleration, and base rows of the equation of motion, from the square system [J_c; J] ddq."""
        K = np.vstack([self.J_c, self.J])
        assert K.shape == (self.dyn.nv, self.dyn.nv)
        ddq = np.linalg.solve(K, np.concatenate([-self.drift_c, self.f - self.drift]))
        return ddq, self.dyn.A @ ddq + self.h

    def whole_body(self, **options):
        controller = _core.WholeBodyController(self.dyn.nv, self.legs, **options)
        controller.prepare(self.dyn, self.standing, self.support, self.f_star)
        return controller, controller.solve(self.f_star.com[:2])

    def wrench_of_standing_feet(self, f_c):
        return f_c.reshape(2, 6)[list(self.standing)].ravel()


@pytest.fixture(params=[(stance, seed) for stance in STANCES for seed in SEEDS], ids=lambda p: f"{p[0]}-{p[1]}")
def stack(request, robot):
    """The full stack: COM, trunk, swing foot, posture."""
    return State(robot, *request.param)


@pytest.fixture(params=[(stance, seed) for stance in STANCES for seed in SEEDS], ids=lambda p: f"{p[0]}-{p[1]}")
def tasks_only(request, robot):
    """The stack without posture, which leaves a null space."""
    return State(robot, *request.param, posture=False)


def assert_tasks_are_met(state, tau):
    ddq, _ = state.motion(tau)
    assert_allclose(state.J @ ddq + state.drift, state.f, rtol=0, atol=EXACT)


# --- the operators


def test_contact_jacobian_times_its_inverse_is_identity(stack):
    assert_allclose(stack.J_c @ stack.contact.Jbar_c, np.eye(len(stack.J_c)), rtol=0, atol=EXACT)
    assert_allclose(stack.contact.N_c @ stack.J_c.T, 0, rtol=0, atol=EXACT)  # contact forces do not pass N_c


def test_task_jacobian_times_its_inverse_is_identity(stack):
    assert_allclose(stack.J @ stack.task.Jbar, np.eye(len(stack.J)), rtol=0, atol=EXACT)


def test_modified_jacobian_gives_the_task_force(stack):
    identity = stack.task.Jbar.T[:, 6:] @ stack.task.J_k.T
    assert_allclose(identity, np.eye(len(stack.J)), rtol=0, atol=EXACT)


# --- what the torque does


def test_tasks_get_the_acceleration_that_is_commanded(stack):
    assert_tasks_are_met(stack, stack.task.torque(stack.task.force(stack.f)))


def test_equation_7_as_printed_misses_the_commanded_acceleration(stack):
    task = stack.task
    printed = task.torque(task.Lambda @ (stack.f + task.mu + task.p))  # Lambda on forces that are forces already
    with pytest.raises(AssertionError):
        assert_tasks_are_met(stack, printed)
    ddq, _ = stack.motion(printed)
    assert np.abs(stack.J @ ddq + stack.drift - stack.f).max() > 1.0  # [m/s^2]: not a rounding error


def test_standing_feet_do_not_accelerate_and_the_equation_of_motion_holds(stack):
    tau = stack.task.torque(stack.task.force(stack.f))
    f_c = stack.contact.wrench(tau)  # eq. 9 knows the wrench before anything moves
    ddq = np.linalg.solve(stack.dyn.A, np.r_[np.zeros(6), tau] - stack.h - stack.J_c.T @ f_c)
    assert_allclose(stack.J_c @ ddq + stack.drift_c, 0, rtol=0, atol=EXACT)
    assert_allclose(stack.motion(tau)[1], f_c, rtol=0, atol=EXACT)


def test_direct_path_keeps_contact_tasks_and_equation_of_motion(stack):
    _, out = stack.whole_body()
    f_c = stack.wrench_of_standing_feet(out.f_c)
    residual = stack.dyn.A @ out.ddq + stack.h + stack.J_c.T @ f_c - np.r_[np.zeros(6), out.tau]
    assert_allclose(residual, 0, rtol=0, atol=EXACT)
    assert_allclose(stack.J_c @ out.ddq + stack.drift_c, 0, rtol=0, atol=EXACT)
    assert_allclose(stack.J @ out.ddq + stack.drift, stack.f, rtol=0, atol=EXACT)
    assert not out.damped


def test_null_space_torque_leaves_the_tasks_alone(tasks_only):
    state = tasks_only
    tau = state.task.torque(state.task.force(state.f))
    extra = state.task.N_k @ state.rng.normal(size=len(tau)) * 20.0
    assert np.linalg.norm(extra) > 1.0  # [N m]
    before, after = state.motion(tau)[0], state.motion(tau + extra)[0]
    assert np.abs(after - before).max() > 1e-3  # it does move the robot
    assert_allclose(state.J @ (after - before), 0, rtol=0, atol=EXACT)
    assert_tasks_are_met(state, tau + extra)


def test_internal_torques_of_double_support_change_the_wrenches_only(robot):
    for seed in SEEDS:
        state = State(robot, "both", seed)
        assert state.task.V_n.shape == (25, 6)
        tau = state.task.torque(state.task.force(state.f))
        before = state.motion(tau)
        after = state.motion(tau + state.task.V_n @ state.rng.normal(size=6) * 20.0)
        assert_allclose(after[0], before[0], rtol=0, atol=EXACT)
        assert np.abs(after[1] - before[1]).max() > 1.0


# --- three routes, one torque: the textbook's equations, the square system, the direct path


def test_square_inverse_dynamics_agrees_with_the_task_space(stack):
    tau = stack.task.torque(stack.task.force(stack.f))
    ddq, w = stack.square_inverse_dynamics()
    assert_allclose(stack.motion(tau)[0], ddq, rtol=0, atol=1e-8)
    # Base rows: they give the wrench of one foot; two share it, and the textbook's minimum-norm torque says how.
    f_c = stack.contact.wrench(tau)
    assert_allclose(-stack.J_c[:, :6].T @ f_c, w[:6], rtol=0, atol=1e-8)
    if len(stack.J_c) == 6:
        f_c = -np.linalg.solve(stack.J_c[:, :6].T, w[:6])
    assert_allclose(w[6:] + stack.J_c[:, 6:].T @ f_c, tau, rtol=0, atol=1e-8)


def test_direct_path_agrees_with_the_task_space(stack):
    _, out = stack.whole_body()
    tau = stack.task.torque(stack.task.force(stack.f))
    ddq, _ = stack.motion(tau)
    assert_allclose(out.ddq, ddq, rtol=0, atol=1e-8)
    f_c = stack.wrench_of_standing_feet(out.f_c)
    if len(stack.J_c) == 12:  # add the internal torque that makes the textbook's wrenches the distributed ones
        G = stack.contact.Jbar_c.T[:, 6:] @ stack.task.V_n
        z, *_ = np.linalg.lstsq(G, f_c - stack.contact.wrench(tau), rcond=None)
        tau = tau + stack.task.V_n @ z
    assert_allclose(out.tau, tau, rtol=0, atol=1e-8)
    assert_allclose(stack.contact.wrench(out.tau), f_c, rtol=0, atol=1e-8)


def test_textbook_path_of_the_controller_is_the_direct_one(stack):
    direct, out = stack.whole_body()
    textbook, same = stack.whole_body(textbook=True)
    for name in ("tau", "ddq", "f_c"):
        assert_allclose(getattr(out, name), getattr(same, name), rtol=0, atol=1e-8, err_msg=name)
    assert_allclose(direct.zmp_slope, textbook.zmp_slope, rtol=0, atol=1e-8)
    assert_allclose(direct.zmp([0.3, -0.2]), textbook.zmp([0.3, -0.2]), rtol=0, atol=1e-8)


# --- what is read out of MuJoCo


def momentary(robot, qpos, qvel):
    _, reader, data = robot
    data.qpos[:], data.qvel[:] = qpos, qvel
    return reader.read(data)


@pytest.mark.parametrize("seed", SEEDS)
def test_drifts_are_central_differences_of_the_velocities(robot, seed):
    state, h = State(robot, "both", seed), 1e-5
    qpos = [state.qpos.copy(), state.qpos.copy()]
    for sign, q in zip((-1, 1), qpos):
        mujoco.mj_integratePos(robot[0], q, state.qvel, sign * h)
    back, ahead = (momentary(robot, q, state.qvel) for q in qpos)
    differences = {
        "com": ((ahead.dcom - back.dcom) / (2 * h), state.dyn.drift_com),
        "left": ((ahead.left.velocity - back.left.velocity) / (2 * h), state.dyn.left.drift),
        "right": ((ahead.right.velocity - back.right.velocity) / (2 * h), state.dyn.right.drift),
    }
    for name, (numeric, exact) in differences.items():
        assert_allclose(exact, numeric, rtol=0, atol=1e-7, err_msg=name)
    assert max(np.abs(exact).max() for _, exact in differences.values()) > 0.1  # not zero against zero


@pytest.mark.parametrize("seed", SEEDS)
def test_jacobians_give_the_velocities_and_are_mujocos(robot, seed):
    model, _, data = robot
    d = State(robot, "both", seed).dyn
    mujoco.mj_forward(model, data)
    J, J_rot = np.zeros((3, model.nv)), np.zeros((3, model.nv))
    mujoco.mj_jacSubtreeCom(model, data, J, 1)  # the root
    assert_allclose(d.J_com, J, rtol=0, atol=1e-12)
    assert_allclose(d.com, data.subtree_com[1], rtol=0, atol=1e-12)
    assert_allclose(d.dcom, J @ data.qvel, rtol=0, atol=1e-12)
    for sole, site in ((d.left, "left_sole"), (d.right, "right_sole")):
        site = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SITE, site)
        mujoco.mj_jacSite(model, data, J, J_rot, site)
        assert_allclose(sole.J, np.vstack([J, J_rot]), rtol=0, atol=1e-12)
        assert_allclose(sole.velocity, sole.J @ data.qvel, rtol=0, atol=1e-12)
        assert_allclose(sole.p_WF, data.site_xpos[site], rtol=0, atol=1e-12)


@pytest.mark.parametrize("seed", SEEDS)
def test_equation_of_motion_is_mujocos(seed):
    model, description = zmpwalk.load_robot("mahru")
    robot = (model, _core.Robot(model, description), mujoco.MjData(model))
    model.opt.disableflags = mujoco.mjtDisableBit.mjDSBL_CONSTRAINT  # in the air
    state = State(robot, "both", seed)
    data = robot[2]
    data.ctrl[:] = state.rng.uniform(-10, 10, model.nu)
    mujoco.mj_forward(model, data)
    ddq = np.linalg.solve(state.dyn.A, np.r_[np.zeros(6), data.ctrl] - state.h)
    assert_allclose(ddq, data.qacc, rtol=0, atol=1e-7)
    assert_allclose(state.dyn.A, state.dyn.A.T, rtol=0, atol=1e-12)
    assert state.dyn.mass == pytest.approx(model.body_subtreemass[1], abs=1e-12)
