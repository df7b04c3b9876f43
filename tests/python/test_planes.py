"""Soles on ground of different height and tilt: three routes lead to one ZMP, and MuJoCo's contact forces have it too.

The humanoid stands still on two wedges, or on one foot on a wedge, held by the whole-body controller alone.
"""

import xml.etree.ElementTree as ET
from types import SimpleNamespace

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk import Contact, InputError, Plane, _core

EXACT = 1e-9  # [m], between routes
STEADY = 5e-5  # [m], estimate against contact forces
DEGREE = np.pi / 180
FEET = {"left": np.array([0.0, 0.11, 0.0]), "right": np.array([0.0, -0.11, 0.0])}  # [m]

# Roll and pitch [deg] of the ground under the left and the right foot, and how much higher the left one is [m].
GROUNDS = {
    "level": ((0, 0), (0, 0), 0.0),
    "a step of 5 cm": ((0, 0), (0, 0), 0.05),
    "one slope up": ((0, -10), (0, -10), 0.0),
    "rolled inward": ((10, 0), (-10, 0), 0.0),
    "rolled outward, one higher": ((-10, 0), (10, 0), 0.05),
    "pitched apart": ((0, 10), (0, -10), 0.0),
    "tilted about both axes, one higher": ((7, -7), (-5, 8), 0.05),
}


def rotation(roll, pitch):
    """Turned by `pitch` about y and before that by `roll` about x [deg]."""
    (cr, sr), (cp, sp) = ((np.cos(a * DEGREE), np.sin(a * DEGREE)) for a in (roll, pitch))
    return np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]]) @ np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])


def turn(R_des, R):
    """Rotation vector that turns R into R_des, world axes."""
    quat, vector = np.zeros(4), np.zeros(3)
    mujoco.mju_mat2Quat(quat, np.ascontiguousarray(R_des @ R.T).ravel())
    mujoco.mju_quat2Vel(vector, quat, 1.0)
    return vector


def wedges(feet):
    """The bundled robot over a wedge for each foot in place of its floor."""
    root = ET.parse(zmpwalk.robots.load.ROBOTS / "mahru.xml").getroot()
    world = root.find("worldbody")
    world.remove(world.find("geom[@name='floor']"))
    for name, foot in feet.items():
        quat, half = np.zeros(4), [0.17, 0.1, 0.05]
        mujoco.mju_mat2Quat(quat, foot.R.ravel())
        centre = foot.p - half[2] * foot.R[:, 2]
        fields = {"size": half, "pos": centre, "quat": quat, "friction": [1.0, 0.005, 0.0001]}
        text = {key: " ".join(map(repr, map(float, value))) for key, value in fields.items()}
        world.append(ET.Element("geom", name=f"wedge_{name}", type="box", **text))
    return mujoco.MjModel.from_xml_string(ET.tostring(root, encoding="unicode"))


class Stand:
    """A stand on wedges and the controller that holds it; the left foot carries `load`, 0 and 1 mean one foot."""

    def __init__(self, ground, load=0.5, support="left"):
        left, right, step = GROUNDS[ground]
        self.feet = {
            name: SimpleNamespace(p=FEET[name] + [0, 0, height], R=rotation(*tilt))
            for name, tilt, height in (("left", left, step), ("right", right, 0.0))
        }
        self.model = wedges(self.feet)
        self.description = zmpwalk.describe(self.model)
        self.data = mujoco.MjData(self.model)
        self.robot = _core.Robot(self.model, self.description)
        self.ground = [Plane.through(foot.p, foot.R[:, 2]) for foot in self.feet.values()]
        self.standing, self.support = (load > 0, load < 1), support
        if not all(self.standing):
            air = self.feet["right" if load else "left"]
            air.p, air.R = air.p + [0.02, 0, 0.08], np.eye(3)
        nv = self.model.nv
        self.controller = _core.WholeBodyController(nv, self.robot.leg_joints)
        self.estimator = _core.ZmpEstimator(nv)
        legs = np.concatenate(self.robot.leg_joints)
        self.posture = [j for j in range(nv - 6) if j not in legs]
        self.com = load * self.feet["left"].p + (1 - load) * self.feet["right"].p + [0.01, 0, 0]
        self.pose()

    def pose(self):
        """Soles flat on their wedges, COM over its place, trunk upright: by Newton's method on the pose."""
        self.description.place(self.model, self.data)
        self.stand = self.robot.read(self.data).q
        low = min(foot.p[2] for foot in self.feet.values())
        self.com[2] = low + self.robot.read(self.data).com[2] - 0.04
        for _ in range(30):
            d = self.robot.read(self.data)
            J, error = [], []
            for sole, foot in zip((d.left, d.right), self.feet.values()):
                J.append(sole.J)
                error += [foot.p - sole.p_WF, turn(foot.R, sole.R_WF)]
            trunk = np.zeros((3, d.nv))
            trunk[:, 3:6] = d.R_WB
            J += [d.J_com, trunk, np.eye(d.nv)[[6 + j for j in self.posture]]]
            error += [self.com - d.com, turn(np.eye(3), d.R_WB), (self.stand - d.q)[self.posture]]
            error = np.concatenate(error)
            if np.abs(error).max() < 1e-10:
                break
            mujoco.mj_integratePos(self.model, self.data.qpos, np.linalg.solve(np.vstack(J), error), 1.0)
        assert np.abs(error).max() < 1e-10
        mujoco.mj_forward(self.model, self.data)

    def cycle(self):
        """Torque that holds the stand, and all that is known of its ZMP."""
        self.dyn = d = self.robot.read(self.data)
        com = np.array([100, 100, 200]) * (self.com - d.com) - np.array([20, 20, 28]) * d.dcom
        trunk = 300 * turn(np.eye(3), d.R_WB) - 35 * d.omega_WB
        swing = np.zeros(6)
        for sole, foot, stands in zip((d.left, d.right), self.feet.values(), self.standing):
            if not stands:
                swing = 900 * np.concatenate([foot.p - sole.p_WF, turn(foot.R, sole.R_WF)]) - 60 * sole.velocity
        posture = 100 * (self.stand - d.q) - 20 * d.dq[6:]
        tasks = _core.TaskAccelerations(com, trunk, swing, posture)
        self.controller.prepare(d, self.standing, self.support, tasks, ground=self.ground)
        self.f_xy = com[:2]
        self.out = self.controller.solve(self.f_xy)
        self.data.qfrc_applied[6:] = self.out.tau
        mujoco.mj_step(self.model, self.data)

    def estimate(self):
        """From the torque alone."""
        d = self.dyn
        feet = [sole for sole, stands in zip((d.left, d.right), self.standing) if stands]
        self.estimator.update(
            d.A, d.b, d.g, np.vstack([s.J for s in feet]), np.concatenate([s.drift for s in feet]), self.standing,
            [d.left.p_WF, d.right.p_WF], self.support, ground=self.ground,
        )  # fmt: skip
        return self.estimator.estimate(self.out.tau)

    def contacts(self):
        """The feet as Contact values, with what the model says of soles and friction."""
        feet = zip((self.dyn.left, self.dyn.right), self.standing, self.ground)
        return [Contact(s.p_WF, s.R_WF, stands, plane, 0.25, 0.14, 1.0) for s, stands, plane in feet]

    def of_total(self, f_c):
        """ZMP of the feet's wrenches, summed up here, on the common plane."""
        F, M = np.zeros(3), np.zeros(3)
        for f, sole in zip(f_c.reshape(2, 6), (self.dyn.left, self.dyn.right)):
            if np.isfinite(f).all():
                F += f[:3]
                M += f[3:] + np.cross(sole.p_WF, f[:3])
        n, offset = self.controller.zmp_plane.normal, self.controller.zmp_plane.offset
        return ((np.cross(n, M) + offset * F) / (n @ F))[:2]


def run(stand, settle=2.0, watch=0.2):
    """Lets the stand settle; largest gap between the routes, and of estimate and measured ZMP while it is watched."""
    routes, errors, contact = [], [], None
    while stand.data.time < settle + watch:
        stand.cycle()
        if round(stand.data.time / 0.001) % (10 if stand.data.time > settle else 100):
            continue
        estimate = stand.estimate()
        totals = stand.of_total(stand.out.f_c), stand.of_total(estimate.f_c)
        routes.append([stand.controller.zmp(stand.f_xy) - zmp for zmp in (estimate.zmp, *totals)])
        if stand.data.time <= settle:
            continue
        measured = zmpwalk.measured_zmp(stand.model, stand.data, stand.description, plane=stand.controller.zmp_plane)
        errors.append(estimate.zmp - measured)
        contact = estimate.f_c
    return np.abs(routes).max(), np.abs(errors).max(axis=0), contact


def assert_feet_carry(stand, f_c):
    for foot, stands, f in zip(stand.contacts(), stand.standing, f_c.reshape(2, 6)):
        if stands:
            assert foot.can_carry(f)
            assert np.abs(foot.cop(f)).max() < 0.07
        else:
            assert np.isnan(f).all()


@pytest.mark.parametrize("support", ["left", "right"])
@pytest.mark.parametrize("ground", list(GROUNDS))
def test_double_support_on_two_wedges(ground, support):
    stand = Stand(ground, 0.6 if support == "left" else 0.4, support)
    routes, errors, f_c = run(stand)
    assert routes <= EXACT
    assert np.abs(stand.dyn.dcom).max() < 1e-3  # it stands
    assert errors.max() <= STEADY
    assert_feet_carry(stand, f_c)
    # The ZMP of a robot at rest is below its COM, on whatever plane it is taken.
    assert stand.controller.zmp(stand.f_xy) == pytest.approx(stand.dyn.com[:2], abs=1e-3)


@pytest.mark.parametrize("support", ["left", "right"])
@pytest.mark.parametrize("tilt", ["one slope up", "rolled inward", "tilted about both axes, one higher"])
def test_single_support_on_a_wedge(tilt, support):
    stand = Stand(tilt, 1.0 if support == "left" else 0.0, support)
    routes, errors, f_c = run(stand)
    assert routes <= EXACT
    assert errors.max() <= STEADY
    assert_feet_carry(stand, f_c)
    normal = stand.ground[support == "right"].normal
    assert stand.controller.zmp_plane.normal == pytest.approx(normal, abs=0)


@pytest.mark.parametrize("load", [0.5, 1.0], ids=["both feet", "left foot"])
def test_estimate_stays_true_on_its_own_plane_while_the_robot_sways_on_a_slope(load):
    stand = Stand("one slope up", load)
    run(stand, settle=0.5, watch=0.01)
    centre, start, errors, level = stand.com, stand.data.time, [], []
    while stand.data.time < start + 1.0:
        stand.com = centre + [0.01 * np.sin(2 * np.pi * (stand.data.time - start)), 0, 0]
        stand.cycle()
        if round(stand.data.time / 0.001) % 10 == 0:
            args, estimate = (stand.model, stand.data, stand.description), stand.estimate().zmp
            errors.append(estimate - zmpwalk.measured_zmp(*args, plane=stand.controller.zmp_plane))
            level.append(estimate - zmpwalk.measured_zmp(*args))
    assert np.abs(errors).max() <= STEADY
    assert np.abs(level).max() > 2 * STEADY  # the force leans: on another plane it has another ZMP


# --- the values at the border


def test_walk_on_the_floor_says_that_its_plane_is_the_level_one_through_the_support_sole(scene_of_a_walk):
    out, foot = scene_of_a_walk
    assert out.zmp_plane.tolist() == [0.0, 0.0, 1.0, foot[2]]


@pytest.fixture
def scene_of_a_walk():
    model, description = zmpwalk.load_robot("mahru")
    data = mujoco.MjData(model)
    description.place(model, data)
    controller = zmpwalk.WalkingController(model, description)
    controller.reset(data)
    for _ in range(700):
        out = controller.update(data)
        mujoco.mj_step(model, data)
    return out, out.foot_left if out.support > 0 else out.foot_right


def test_planes_are_normalised_and_refuse_what_is_no_ground():
    plane = Plane([0, 0.6, 1.6], 2.0)
    assert np.linalg.norm(plane.normal) == pytest.approx(1.0, abs=1e-15)
    assert plane.distance([0, 0, 1.25]) == pytest.approx(0.0, abs=1e-15)
    assert Plane() == Plane([0, 0, 1], 0.0)
    assert Plane.through([1, 2, 3]).offset == 3.0
    assert repr(Plane()) == "Plane(normal=[0, 0, 1], offset=0)"
    for normal, offset in (([1, 0, 0], 0.0), ([0, 0, -1], 0.0), ([0, 0, np.nan], 0.0), ([0, 0, 1], np.inf)):
        with pytest.raises(InputError, match="is no ground"):
            Plane(normal, offset)


def test_common_plane_names_the_feet():
    feet = [Contact([0, 0.1, 0.05], np.eye(3)), Contact([0, -0.1, 0.0], np.eye(3))]
    assert zmpwalk.common_plane(feet, "left") == Plane.through([0, 0.1, 0.05])
    with pytest.raises(InputError, match="support = 'middle' is unknown; there are: left, right"):
        zmpwalk.common_plane(feet, "middle")


def test_bounds_of_a_tilted_sole_are_recorded_in_world_x_and_y():
    lower, upper = _core.zmp_bounds(0.25, 0.14, [-0.02, 0.0], np.inf, np.inf, 600.0)
    foot = Contact([0.3, 0.1, 0.02], rotation(0, 10))
    assert foot.to_world(upper) == pytest.approx([0.3 + 0.09 * np.cos(10 * DEGREE), 0.1 + 0.0504], abs=1e-15)
    assert foot.to_sole(foot.to_world(lower)) == pytest.approx(lower, abs=1e-15)
