"""The default law over the paper's profile: two minutes of it, and what MuJoCo's contacts say of the estimate."""

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk import WalkSettings, analysis
from zmpwalk.robots import ROBOTS

MM = 1e-3
PERIOD = 0.8  # [s]
SETTLED = 5  # steps after which the gait repeats itself


@pytest.fixture(scope="session")
def long_walk():
    """120 s, walked once for every test that reads it."""
    return zmpwalk.simulate("mahru", duration=120.0)


def walk(duration, edit=None, **settings):
    """A walk of the bundled robot after `edit(model)`."""
    model, description = zmpwalk.load_robot("mahru")
    if edit:
        edit(model)
    return zmpwalk.simulate((model, description), duration=duration, settings=WalkSettings(**settings))


# --- it stands, keeps its pace and its feet


def test_stands_to_the_end_of_120_seconds_and_149_steps(long_walk):
    assert not long_walk.meta["fell"]
    assert not long_walk.fell.any()
    assert len(long_walk.t) == 120000
    assert long_walk.step[-1] >= 149
    assert long_walk.meta["settings"]["law"] == "default"
    assert long_walk.com[-1, 0] > 29.0  # and it went somewhere [m]


def test_com_moves_as_planned_in_every_step_from_the_first(long_walk):
    x = np.append(long_walk.com[:, 0], long_walk.com[-1, 0] + 0.001 * long_walk.dcom[-1, 0])
    k = np.arange(150)
    moved = x[800 * (k + 1)] - x[800 * k]
    planned = [long_walk.profile.displacement(PERIOD * i, PERIOD * (i + 1))[0] for i in k]
    assert np.abs(moved / planned - 1).max() <= 0.002


def test_steps_become_20_centimetres_long(long_walk):
    landed = long_walk.foot_left[:, 0] - long_walk.foot_right[:, 0]
    middle_of_double_support = np.flatnonzero((long_walk.phase == 0) & (np.abs(long_walk.phase_time - 0.08) < 5e-4))
    leads = np.abs(landed[middle_of_double_support])
    assert len(leads) > 140
    assert leads[SETTLED:] == pytest.approx(0.2, abs=1 * MM)


def test_lateral_switch_settles_to_one_time(long_walk):
    times = analysis.switch_times(long_walk)
    assert len(times) == 150
    assert np.ptp(times[SETTLED:]) <= 2e-3  # [s]
    assert np.all((times > 0) & (times < 0.18))


def test_com_stays_with_the_feet(long_walk):
    offset = analysis.midstance_offset(long_walk)[SETTLED:]
    assert len(offset) > 140
    assert np.abs(np.diff(offset)).max() <= 0.05 * MM  # step by step
    assert abs(np.polyfit(np.arange(len(offset)), offset, 1)[0]) <= 0.05 * MM
    assert offset == pytest.approx(long_walk.meta["settings"]["com_lead"], abs=0.5 * MM)  # and where it is wanted


def test_no_limit_is_reached(long_walk):
    assert long_walk.joint_margin.min() > 0
    assert long_walk.torque_ratio.max() < 1
    assert not long_walk.saturated.any()
    assert not long_walk.self_contacts.any()
    assert not long_walk.damped.any()


def test_robot_has_limits_to_reach():
    model, _ = zmpwalk.load_robot("mahru")
    assert model.jnt_limited[1:].all()
    assert model.actuator_ctrllimited.all()


# --- the estimate


@pytest.mark.parametrize("axis", [0, 1], ids="xy")
def test_estimate_is_the_cop_of_the_contacts(long_walk, axis):
    every, single = analysis.zmp_error(long_walk)[:, axis], analysis.zmp_error(long_walk, single_support=True)[:, axis]
    assert len(every) >= len(long_walk.t) - 1  # contact in every cycle but, level with the floor, the first
    assert len(single) == int(long_walk.phase.sum()) > 90000
    assert np.median(every) <= 0.01 * MM
    assert np.percentile(single, 95) <= 0.05 * MM
    assert np.percentile(every, 95) <= 1.0 * MM


def test_contact_of_that_walk_is_stiff_but_not_rigid(long_walk):
    assert long_walk.model.geom_solref[:, 0].min() >= 0.005


def test_estimate_stays_inside_its_bounds_in_single_support(long_walk):
    assert analysis.bound_excess(long_walk).max() <= 0.001


def test_zmp_does_reach_its_bounds(long_walk):
    assert (long_walk.zmp_modified[:, 0] != 0).mean() > 0.05
    bounds = analysis.in_support_axes(long_walk, long_walk.zmp_upper - long_walk.zmp_lower)
    assert bounds[long_walk.phase == 1, 0] == pytest.approx(0.18, abs=1e-9)


def test_expected_wrenches_carry_the_weight(long_walk):
    weight = long_walk.model.body_subtreemass[1] * 9.81
    for name in ("f_c", "contact_wrench"):
        load = np.nansum(long_walk[name][:, [2, 8]], axis=1)
        assert load.mean() == pytest.approx(-weight, rel=2e-3), name
    single = long_walk.phase == 1
    error = np.nansum(long_walk.f_c[:, [2, 8]] - long_walk.contact_wrench[:, [2, 8]], axis=1)[single]
    assert np.median(np.abs(error)) < 0.05  # [N]


# --- other contacts and cycle times


def test_soft_contact_walks_and_keeps_the_estimate():
    soft = walk(9.0, lambda model: model.geom_solref.__setitem__((slice(None), 0), 0.02))
    assert not soft.meta["fell"]
    assert np.percentile(analysis.zmp_error(soft), 95, axis=0).max() <= 5 * MM


@pytest.mark.parametrize("dt", [0.0005, 0.002, 0.004])
def test_other_cycle_times_walk(dt):
    other = walk(9.0, lambda model: setattr(model.opt, "timestep", dt))
    assert not other.meta["fell"]
    assert len(other.t) == round(9.0 / dt)
    assert other.meta["settings"]["control_dt"] == dt


@pytest.mark.parametrize("dt", [0.002, 0.004])
def test_control_slower_than_the_physics_walks(dt):
    held = walk(9.0, control_dt=dt)
    assert not held.meta["fell"]
    assert len(held.t) == round(9.0 / dt)


# --- other things in the scene


def test_free_box_before_the_robot_changes_nothing():
    """Position and velocity addresses, body and contact numbers of the robot all move; the walk does not."""
    xml = (ROBOTS / "mahru.xml").read_text()
    box = (
        '<body name="box" pos="30 30 0.1"><freejoint name="box_free"/><geom type="box" size="0.2 0.2 0.1"/>'
        '<inertial pos="0 0 0" mass="3" diaginertia="0.05 0.05 0.08"/></body>'
    )
    assert xml.count("<worldbody>") == xml.count('name="stand" qpos="') == 1
    scene = xml.replace("<worldbody>", f"<worldbody>{box}")
    scene = scene.replace('name="stand" qpos="', 'name="stand" qpos="30 30 0.1 1 0 0 0 ')
    model = mujoco.MjModel.from_xml_string(scene)
    assert model.joint("box_free").qposadr[0] == 0
    with_box = zmpwalk.simulate(model, duration=6.0)
    alone = zmpwalk.simulate("mahru", duration=6.0)
    assert not with_box.meta["fell"]
    assert set(with_box) == set(alone)
    for name in alone:
        difference = np.abs(with_box[name] - alone[name])
        assert np.array_equal(np.isnan(with_box[name]), np.isnan(alone[name])), name
        assert np.all(difference[~np.isnan(difference)] <= 1e-9), name
