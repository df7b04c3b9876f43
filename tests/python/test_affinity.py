"""The estimate as a function of the reference ZMP, and the iteration of III-B that rests on it.

One pass of that loop changes r_ref by r_des - r_est, and r_est is affine in r_ref with slope s, so the error of pass n
is (1 - s)^n of the first: s = rho (k_d dt + k_p dt^2 / 2), and rho (1 + k_d dt + k_p dt^2 / 2) with feed-forward.
rho is what the links' angular momentum makes of a point mass's 1, about 1.14.
"""

import math

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk import WalkSettings, _core

THRESHOLD = 1e-3  # [m], section IV
DT = 1e-3  # [s]
LAWS = {
    "without feed-forward": {"kp": 400.0, "kd": 40.0, "feed_forward": False},  # k_d dt = 0.04
    "with feed-forward": {"kp": 100.0, "kd": 20.0, "feed_forward": True},
}


def contraction_factor(law, rho):
    """s of the docstring: 1 - s is what one pass leaves of the error."""
    return rho * (law["feed_forward"] + law["kd"] * DT + law["kp"] * DT**2 / 2)


def passes(error, s, threshold=THRESHOLD):
    """Estimates that the loop computes, the one that ends it included."""
    return 1 + (math.ceil(math.log(threshold / error) / math.log(abs(1 - s))) if error >= threshold else 0)


class Instant:
    """A moment of a walk, and the estimate as a function of the reference ZMP: (16), (8), (1)-(7), (9)-(15) in full."""

    def __init__(self, model, description, walk, row, law):
        data = mujoco.MjData(model)
        data.qpos[:], data.qvel[:] = walk.qpos[row], walk.qvel[row]
        robot = _core.Robot(model, description)
        self.dyn = robot.read(data)
        self.standing = tuple(np.isfinite(walk.f_c[row].reshape(2, 6)).all(axis=1).tolist())
        self.support = "left" if walk.support[row] > 0 else "right"
        sole = self.dyn.left if self.support == "left" else self.dyn.right
        self.origin, self.law = sole.p_WF[:2], law
        self.pendulum = _core.LinearInvertedPendulum(self.dyn.com[2] - sole.p_WF[2])
        self.com, self.dcom = self.dyn.com[:2] - self.origin, self.dyn.dcom[:2]
        self.slow = _core.WholeBodyController(self.dyn.nv, robot.leg_joints, textbook=True)
        self.fast = _core.WholeBodyController(self.dyn.nv, robot.leg_joints)
        for controller in (self.slow, self.fast):
            tasks = _core.TaskAccelerations(np.zeros(3), np.zeros(3), np.zeros(6), np.zeros(self.dyn.joints))
            controller.prepare(self.dyn, self.standing, self.support, tasks)
        feet = [f for f, stands in zip((self.dyn.left, self.dyn.right), self.standing) if stands]
        self.estimator = _core.ZmpEstimator(self.dyn.nv)
        J_c, drift_c = np.vstack([f.J for f in feet]), np.concatenate([f.drift for f in feet])
        soles = [self.dyn.left.p_WF, self.dyn.right.p_WF]
        self.estimator.update(self.dyn.A, self.dyn.b, self.dyn.g, J_c, drift_c, self.standing, soles, self.support)

    def desired(self, r_ref):
        return np.array([self.pendulum.step(DT, x, v, r) for x, v, r in zip(self.com, self.dcom, r_ref)]).T

    def f_star(self, r_ref):
        x_d, v_d = self.desired(r_ref)
        f = self.law["kp"] * (x_d - self.com) + self.law["kd"] * (v_d - self.dcom)
        if self.law["feed_forward"]:
            f = f + [self.pendulum.acceleration(x, r) for x, r in zip(self.com, r_ref)]
        return f

    def estimate(self, r_ref):
        """From the torque alone."""
        self.out = self.estimator.estimate(self.slow.solve(self.f_star(r_ref)).tau)
        return self.out.zmp - self.origin

    def quick(self, r_ref):
        """From the torque basis that the control cycle uses."""
        return self.fast.zmp(self.f_star(r_ref)) - self.origin

    def slope(self):
        dr = np.array([[0.05, 0.0], [0.0, 0.05]])
        return np.array([(self.estimate(d) - self.estimate(-d)) / 0.1 for d in dr]).T


@pytest.fixture(scope="module")
def walk():
    return zmpwalk.simulate("mahru", duration=3.5)


@pytest.fixture(params=list(LAWS))
def law(request):
    return LAWS[request.param]


@pytest.fixture
def instants(walk, law):
    """Forty moments of a walk: both feet, each foot, the support switch, the bounds reached."""
    model, description = zmpwalk.load_robot("mahru")
    rows = np.linspace(0, len(walk.t) - 1, 40).astype(int)
    assert {(walk.phase[k], walk.support[k]) for k in rows} == {(0, 1), (0, -1), (1, 1), (1, -1)}
    return [Instant(model, description, walk, k, law) for k in rows]


def test_estimate_is_affine_in_the_reference(instants):
    for instant in instants:
        grid = np.linspace(-0.15, 0.15, 7)
        for axis in range(2):
            references = np.full((len(grid), 2), 0.02)
            references[:, axis] = grid
            estimates = np.array([instant.estimate(r) for r in references])
            straight = estimates[0] + (estimates[-1] - estimates[0]) * ((grid - grid[0]) / np.ptp(grid))[:, None]
            assert np.abs(estimates - straight).max() <= 1e-10  # [m]
            assert abs(estimates[-1, axis] - estimates[0, axis]) > 0.01  # and not constant


def test_normal_force_does_not_depend_on_the_reference(instants):
    for instant in instants:
        loads = []
        for r_ref in ([-0.15, -0.15], [0.0, 0.0], [0.15, 0.15]):
            instant.estimate(np.array(r_ref))
            loads.append(np.nansum(instant.out.f_c[[2, 8]]))
        assert np.ptp(loads) <= 1e-8  # [N]
        assert loads[0] < -100.0


def test_torque_basis_of_the_cycle_is_the_full_computation(instants):
    for instant in instants:
        for r_ref in ([-0.12, 0.0], [0.03, -0.08], [0.15, 0.1]):
            r_ref = np.array(r_ref)
            assert instant.quick(r_ref) == pytest.approx(instant.estimate(r_ref), abs=1e-10)


def test_slope_is_the_one_that_the_gains_give(instants, law):
    for instant in instants:
        rho = -instant.slow.zmp_slope.diagonal() / instant.pendulum.Tc**2
        assert np.all((rho > 1.08) & (rho < 1.2))  # what a point mass does not have
        s = contraction_factor(law, rho)
        assert instant.slope().diagonal() == pytest.approx(s, rel=1e-4)


def test_loop_and_closed_form_agree_to_the_threshold(instants):
    for instant in instants:
        for zmp_des in ([-0.09, 0.0], [0.09, 0.0], [0.05, 0.04]):
            slope = instant.slope()
            loop = _core.iterate_reference(instant.quick, zmp_des, THRESHOLD, 500)
            closed = _core.solve_reference(instant.quick, zmp_des, slope, THRESHOLD)
            assert loop.converged
            assert closed.converged
            assert closed.passes == 2
            assert closed.zmp_est == pytest.approx(zmp_des, abs=1e-9)
            assert np.abs(loop.zmp_est - closed.zmp_est).max() < THRESHOLD
            # One cycle of reference moves the desired speed by sinh(dt / T_c) / T_c, little: the two commands are one.
            between = THRESHOLD * np.abs(np.linalg.inv(slope)).sum(axis=1).max()
            speed = np.sinh(DT / instant.pendulum.Tc) / instant.pendulum.Tc * between
            assert instant.desired(loop.zmp_ref) == pytest.approx(instant.desired(closed.zmp_ref), abs=speed)


def test_loop_takes_the_passes_that_the_contraction_factor_gives(instants, law):
    counts = []
    for instant in instants:
        rho = -instant.slow.zmp_slope.diagonal() / instant.pendulum.Tc**2
        s = contraction_factor(law, rho)[0]
        for x_des in (-0.09, 0.09):
            # along y the loop starts where it ends, so x alone counts
            zmp_des = np.array([x_des, instant.quick(np.array([x_des, 0.0]))[1]])

            def along_x(r, instant=instant, y=zmp_des[1]):
                return np.array([instant.quick(np.array([r[0], 0.0]))[0], y])

            first = abs(x_des - along_x(zmp_des)[0])
            loop = _core.iterate_reference(along_x, zmp_des, THRESHOLD, 500)
            assert abs(loop.passes - passes(first, s)) <= 1
            counts.append(loop.passes)
    assert max(counts) <= (5 if law["feed_forward"] else 130)
    assert max(counts) >= (2 if law["feed_forward"] else 60)  # the slow one is slow


def test_loop_that_cannot_converge_stops_at_its_bound():
    diverging = _core.iterate_reference(lambda r: 2.5 * r, [0.1, 0.0], THRESHOLD, 17)
    assert not diverging.converged
    assert diverging.passes == 17


# --- the same on every cycle of a walk


@pytest.mark.parametrize(
    ("settings", "most"),
    [({"law": "paper"}, 130), ({"iteration": "loop"}, 5)],
    ids=["without feed-forward", "with feed-forward"],
)
def test_walking_loop_takes_the_passes_that_its_slope_gives(settings, most):
    walk = zmpwalk.simulate("mahru", duration=5.0, settings=WalkSettings(**settings))
    assert not walk.meta["fell"]
    modified = np.flatnonzero(walk.iterations > 0)
    assert len(modified) > 200
    for k in modified:
        axes = walk.zmp_modified[k] != 0
        error = np.abs(walk.zmp_des[k] - walk.zmp_first[k])[axes]
        expected = max(passes(e, s) for e, s in zip(error, walk.zmp_slope[k][axes]))
        assert abs(walk.iterations[k] - expected) <= 1
        assert np.abs(walk.zmp_est[k] - walk.zmp_des[k])[axes].max() < THRESHOLD
    assert walk.iterations.max() <= most


def test_walking_by_closed_form_takes_two_passes_and_leaves_no_error(walk):
    modified = walk.zmp_modified != 0
    assert set(np.unique(walk.iterations)) == {0.0, 2.0}
    assert np.abs(walk.zmp_est - walk.zmp_des)[modified].max() <= 1e-10
    loop = zmpwalk.simulate("mahru", duration=3.5, settings=WalkSettings(iteration="loop"))
    assert np.abs(loop.com - walk.com).max() < THRESHOLD  # the two walk the same walk
