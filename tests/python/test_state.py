"""A controller that is given numbers alone walks as one that reads the simulator."""

import mujoco
import numpy as np
import pytest
import zmpwalk


@pytest.fixture
def walker():
    model, description = zmpwalk.load_robot("mahru")

    def make(controlled=None, profile=0.2):
        data = mujoco.MjData(model)
        description.place(model, data)
        controller = zmpwalk.WalkingController(controlled or model, description, profile=profile)
        return controller, model, data

    return make


def read(controller, data):
    return zmpwalk.State(data.time, data.qpos.copy(), data.qvel.copy())


def test_update_on_numbers_gives_the_torque_of_update_on_data_bit_for_bit(walker):
    by_data, model, data = walker()
    by_numbers, _, _ = walker()
    by_data.reset(data)
    by_numbers.reset(read(by_numbers, data))
    for _ in range(1500):
        given = by_numbers.update(read(by_numbers, data)).tau.copy()
        out = by_data.update(data)
        np.testing.assert_array_equal(given, out.tau)
        mujoco.mj_step(model, data)


def test_state_of_a_simulator_is_its_position_velocity_and_time(walker):
    controller, _model, data = walker()
    data.time = 1.5
    state = controller.state(data)
    assert state.time == 1.5
    np.testing.assert_array_equal(state.q, data.qpos)
    np.testing.assert_array_equal(state.dq, data.qvel)
    assert np.isnan(state.wrench).all() and np.isnan(state.contact).all()


def test_a_loop_of_ones_own_walks_with_the_simulator_as_nothing_but_physics(walker):
    controller, model, data = walker(profile=[(0, 0), (1, 0.2)])
    controller.reset(read(controller, data))
    while data.time < 6.0:
        out = controller.update(read(controller, data))
        assert not out.fell, out.fall_cause
        data.ctrl[:] = out.tau  # the bundled robot's motors take torques, in the order of its joints
        mujoco.mj_step(model, data)
    assert out.com[0] == pytest.approx(0.2 * 5.0, abs=0.05)


def test_update_on_numbers_writes_nothing_outside_the_controller(walker):
    controller, _model, data = walker()
    controller.reset(read(controller, data))
    state = read(controller, data)
    before = state.q.copy(), state.dq.copy(), data.ctrl.copy(), data.qfrc_applied.copy()
    controller.update(state)
    for kept, now in zip(before, (state.q, state.dq, data.ctrl, data.qfrc_applied)):
        np.testing.assert_array_equal(kept, now)


@pytest.mark.parametrize("factor", [0.9, 1.1])
def test_a_controller_whose_model_is_off_by_a_tenth_in_mass_walks(walker, factor):
    believed, _ = zmpwalk.load_robot("mahru")
    believed.body_mass[:] *= factor
    believed.body_inertia[:] *= factor
    mujoco.mj_setConst(believed, mujoco.MjData(believed))
    controller, model, data = walker(believed, profile=[(0, 0), (1, 0.25)])
    controller.reset(data)
    while data.time < 8.0:
        out = controller.update(data)
        assert not out.fell, out.fall_cause
        mujoco.mj_step(model, data)
    # What is left of the error is what the observer does not count.
    true = model.body_subtreemass[1]
    assert abs(controller.mass / true - 1.0) < 0.025
    assert out.com[0] == pytest.approx(0.25 * 7.0, abs=0.1)


def test_what_is_no_state_is_refused_and_changes_nothing(walker):
    controller, _model, data = walker()
    with pytest.raises(zmpwalk.DimensionError, match="dq"):
        zmpwalk.State(0.0, data.qpos, data.qvel[:-1])
    with pytest.raises(zmpwalk.InputError, match="before reset"):
        controller.update(read(controller, data))
    controller.reset(data)
    good = controller.update(read(controller, data)).tau.copy()
    no_direction = data.qpos.copy()
    no_direction[3:7] = 0.0
    for bad, words in (
        (zmpwalk.State(0.001, np.zeros(5), np.zeros(4)), "state.q"),
        (zmpwalk.State(np.nan, data.qpos, data.qvel), "time"),
        (zmpwalk.State(0.001, data.qpos * np.nan, data.qvel), "finite"),
        (zmpwalk.State(0.001, no_direction, data.qvel), r"quaternion, state\.q\[3:7\], has the length 0\.0+;"),
    ):
        for takes in (controller.update, controller.reset):
            with pytest.raises(zmpwalk.Error, match=words):
                takes(bad)
    with pytest.raises(zmpwalk.InputError, match="gone back"):
        controller.update(zmpwalk.State(-0.1, data.qpos, data.qvel))
    np.testing.assert_array_equal(controller.update(read(controller, data)).tau, good)


def test_the_cycle_goes_by_the_time_of_the_state_whatever_the_rate_of_the_calls(walker):
    often, model, data = walker()
    seldom, _, _ = walker()
    settings = zmpwalk.WalkSettings(control_dt=0.004)
    often = zmpwalk.WalkingController(model, often.description, settings, 0.2)
    seldom = zmpwalk.WalkingController(model, often.description, settings, 0.2)
    often.reset(data)
    seldom.reset(data)
    for step in range(2000):
        out = often.update(data)
        if step % 4 == 0:
            np.testing.assert_array_equal(seldom.update(read(seldom, data)).tau, out.tau)
        assert out.fresh == (step % 4 == 0)
        mujoco.mj_step(model, data)


@pytest.mark.parametrize("factor", [0.7, 1.3])
def test_a_single_support_that_takes_another_time_ends_then_and_the_robot_walks_on(walker, factor):
    controller, model, data = walker(profile=[(0, 0), (1, 0.2)])
    controller.reset(data)
    changed, ends, phase = None, None, 0
    while data.time < 8.0:
        out = controller.update(data)
        assert not out.fell, out.fall_cause
        if changed is None and data.time > 3.0 and out.phase == 1 and out.phase_time > 0.2:
            changed = factor * (controller.settings.T_ss - out.phase_time)
            controller.retime(changed)
            ends = data.time + changed
        if ends is not None and phase == 1 and out.phase == 0:
            assert data.time == pytest.approx(ends, abs=2e-3)
            ends = None
        phase = out.phase
        mujoco.mj_step(model, data)
    assert changed is not None and ends is None
    for bad in (0.0, -1.0, np.nan):
        with pytest.raises(zmpwalk.InputError, match="remaining"):
            controller.retime(bad)


def test_a_walk_that_starts_a_kilometre_away_is_the_same_walk(walker):
    ways = []
    for away in (0.0, 1000.0):
        controller, model, data = walker(profile=[(0, 0), (1, 0.25)])
        data.qpos[:2] += away
        controller.reset(data)
        way = []
        while data.time < 5.0:
            way.append(controller.update(data).com[:2] - away)
            mujoco.mj_step(model, data)
        ways.append(np.array(way))
    assert ways[0][-1, 0] > 0.8
    np.testing.assert_allclose(ways[1], ways[0], atol=1e-8)
