"""The border between Python and C++: views and copies, lifetimes, shapes and messages, keywords, the lock."""

import _thread
import copy
import gc
import pickle
import subprocess
import sys
import threading
import time
import weakref

import mujoco
import numpy as np
import pytest
import zmpwalk
from numpy.testing import assert_array_equal
from zmpwalk import DimensionError, InputError, ModelError, VelocityProfile, WalkSettings, _core


@pytest.fixture
def scene():
    """A fresh model, its description, and data in the start pose."""
    model, description = zmpwalk.load_robot("mahru")
    data = mujoco.MjData(model)
    description.place(model, data)
    return model, description, data


@pytest.fixture
def dynamics(scene):
    model, description, data = scene
    data.qvel[:] = np.linspace(-0.5, 0.5, model.nv)
    return _core.Robot(model, description).read(data)


@pytest.fixture
def whole_body(scene):
    model, description, _ = scene
    return _core.WholeBodyController(model.nv, _core.Robot(model, description).leg_joints)


@pytest.fixture
def accelerations():
    return _core.TaskAccelerations(np.zeros(3), np.zeros(3), np.zeros(6), np.zeros(25))


# --- arrays: views of their owner, read-only, alive as long as they are looked at

ARRAYS = {
    "A": (31, 31), "b": (31,), "g": (31,), "q": (25,), "dq": (31,), "J_com": (3, 31), "com": (3,), "dcom": (3,),
    "drift_com": (3,), "p_WB": (3,), "R_WB": (3, 3), "omega_WB": (3,), "gravity": (3,),
}  # fmt: skip


def test_dynamics_arrays_are_read_only_views_of_their_owner(dynamics):
    for name, shape in ARRAYS.items():
        array = getattr(dynamics, name)
        assert array.shape == shape, name
        assert array.dtype == np.float64
        assert not array.flags.owndata, name
        assert not array.flags.writeable, name
        assert np.shares_memory(array, getattr(dynamics, name)), name
        with pytest.raises(ValueError, match="read-only"):
            array[...] = 0.0
    assert dynamics.A.flags.c_contiguous  # row-major in C++ too, so no copy crosses


def test_arrays_keep_their_owner_alive(scene):
    model, description, data = scene

    def read():
        return _core.Robot(model, description).read(data)

    kept, same = read(), read()
    views = {name: getattr(read(), name) for name in ARRAYS}  # each the only hold on its Dynamics
    sole = read().left.J
    gc.collect()
    rubbish = [np.full((31, 31), np.nan) for _ in range(200)]  # what a freed block would be filled with
    for name, view in views.items():
        assert_array_equal(view, getattr(kept, name))
    assert_array_equal(sole, same.left.J)
    assert len(rubbish) == 200


def test_dynamics_is_a_copy_of_the_robots_state(scene):
    model, description, data = scene
    robot = _core.Robot(model, description)
    before = robot.read(data)
    com = before.com.copy()
    data.qpos[2] += 0.1
    after = robot.read(data)
    assert_array_equal(before.com, com)
    assert after.com[2] == pytest.approx(com[2] + 0.1)


def test_setters_copy(dynamics):
    A = np.eye(31)
    dynamics.A = A
    A[0, 0] = 7.0
    assert dynamics.A[0, 0] == 1.0


def test_copy_of_dynamics_is_its_own(dynamics):
    other = copy.copy(dynamics)
    other.com = np.zeros(3)
    assert np.any(dynamics.com != 0)


@pytest.mark.parametrize("order", ["C", "F"])
@pytest.mark.parametrize("kind", [np.float64, np.float32, list])
def test_any_order_and_number_type_gives_the_same_numbers(dynamics, order, kind):
    d = dynamics

    def cast(array):
        return array.tolist() if kind is list else np.array(array, dtype=kind, order=order)

    exact = _core.ContactSpace(d.A, d.b, d.g, d.left.J, d.left.drift)
    given = _core.ContactSpace(cast(d.A), cast(d.b), cast(d.g), cast(d.left.J), cast(d.left.drift))
    tolerance = {"rtol": 1e-3, "atol": 1e-2} if kind is np.float32 else {"rtol": 0, "atol": 0}
    np.testing.assert_allclose(given.Lambda_c, exact.Lambda_c, **tolerance)
    np.testing.assert_allclose(given.Jbar_c, exact.Jbar_c, **tolerance)


def test_slices_that_are_not_contiguous_are_read_right(dynamics):
    d = dynamics
    wide = np.zeros((62, 62))
    wide[::2, ::2] = d.A
    exact = _core.ContactSpace(d.A, d.b, d.g, d.left.J, d.left.drift)
    assert_array_equal(_core.ContactSpace(wide[::2, ::2], d.b, d.g, d.left.J, d.left.drift).Lambda_c, exact.Lambda_c)


def test_cycle_output_is_a_copy_that_cannot_be_written(scene):
    model, description, data = scene
    controller = zmpwalk.WalkingController(model, description)
    controller.reset(data)
    out = controller.update(data)
    tau, kept = out.tau, out.tau.copy()
    for _ in range(5):
        mujoco.mj_step(model, data)
        controller.update(data)
    assert_array_equal(out.tau, kept)
    assert out.t == 0.0
    with pytest.raises(AttributeError):
        out.com = np.zeros(3)
    with pytest.raises(ValueError, match="read-only"):
        tau[0] = 0.0
    twin = copy.copy(out)
    del out, controller
    gc.collect()
    assert_array_equal(tau, kept)
    assert_array_equal(twin.tau, kept)
    assert repr(twin).startswith("CycleOutput(t=0, phase=double, support=right, com=[")


# --- who keeps whom alive


def test_controller_robot_and_recorder_keep_what_they_point_into():
    def controller():
        model, description = zmpwalk.load_robot("mahru")
        return _core.WalkingController(model, description)  # nothing else holds the model now

    kept = controller()
    gc.collect()
    columns, info = _core.simulate(kept, 0.05)
    assert not info["fell"]
    recorder = _core.Recorder(controller())
    gc.collect()
    assert len(recorder) == 0
    assert set(recorder.columns()) == set(columns)
    assert all(len(column) == 0 for column in recorder.columns().values())


def test_model_dies_with_its_controller():
    model, description = zmpwalk.load_robot("mahru")
    controller = _core.WalkingController(model, description)
    refs = sys.getrefcount(model)
    del controller
    gc.collect()
    assert sys.getrefcount(model) == refs - 1


def test_whole_body_controller_lets_go_of_dynamics_it_no_longer_needs(scene, whole_body, accelerations):
    model, description, data = scene
    robot = _core.Robot(model, description)
    old, new = robot.read(data), robot.read(data)
    watch = weakref.ref(old)
    whole_body.prepare(old, (True, True), "left", accelerations)
    torque = whole_body.solve([0.1, 0.0]).tau.copy()
    del old
    gc.collect()
    assert_array_equal(whole_body.solve([0.1, 0.0]).tau, torque)  # alive while it is needed
    whole_body.prepare(new, (True, True), "left", accelerations)
    gc.collect()
    assert watch() is None  # or a loop of one's own would keep every instant of the walk


def test_columns_outlive_the_recorder(scene):
    columns, _ = _core.simulate(zmpwalk.WalkingController(*scene[:2]), 0.02)
    com = columns["com"]
    first = com[0].copy()
    del columns
    gc.collect()
    assert_array_equal(com[0], first)
    com[0] = 0.0  # the caller's own


# --- shapes and messages


def test_wrong_shapes_are_named_with_both_sizes(dynamics):
    d = dynamics
    with pytest.raises(DimensionError, match=r"A is \(3, 3\); it must be \(31, 31\)"):
        d.A = np.eye(3)
    with pytest.raises(DimensionError, match=r"A is \(3, 3\); it must be \(31, 31\)"):
        _core.ContactSpace(np.eye(3), d.b, d.g, d.left.J, d.left.drift)
    with pytest.raises(DimensionError, match="drift_c has 5 entries; it must have 6"):
        _core.ContactSpace(d.A, d.b, d.g, d.left.J, np.zeros(5))
    contact = _core.ContactSpace(d.A, d.b, d.g, d.left.J, d.left.drift)
    with pytest.raises(DimensionError, match="tau has 2 entries; it must have 25"):
        contact.wrench(np.zeros(2))
    with pytest.raises(DimensionError, match="drift has 2 entries; it must have 3"):
        _core.TaskSpace(contact, d.b, d.g, d.J_com, np.zeros(2))
    task = _core.TaskSpace(contact, d.b, d.g, d.J_com, d.drift_com)
    with pytest.raises(DimensionError, match="f_star has 4 entries; it must have 3"):
        task.force(np.zeros(4))
    with pytest.raises(DimensionError, match="F has 1 entries; it must have 3"):
        task.torque(np.zeros(1))
    assert d.A.shape == (31, 31)  # refused, unchanged


def test_sole_jacobian_keeps_its_shape(dynamics):
    with pytest.raises(DimensionError, match=r"J is \(6, 3\); it must be \(6, 31\)"):
        dynamics.left.J = np.zeros((6, 3))
    assert dynamics.left.J.shape == (6, 31)


def test_estimator_refuses_what_does_not_fit(dynamics):
    d = dynamics
    estimator = zmpwalk.ZmpEstimator(nv=31)
    soles = [d.left.p_WF, d.right.p_WF]
    fits = {
        "A": d.A, "b": d.b, "g": d.g, "J_c": d.left.J, "drift_c": d.left.drift, "standing": (True, False),
        "soles": soles, "support": "left",
    }  # fmt: skip
    estimator.update(**fits)
    assert estimator.estimate(np.zeros(25)).f_c.shape == (12,)
    with pytest.raises(DimensionError, match=r"J_c is \(6, 31\); it must be \(12, 31\)"):
        estimator.update(**{**fits, "standing": (True, True)})
    with pytest.raises(InputError, match="no foot stands"):
        estimator.update(**{**fits, "standing": (False, False), "J_c": np.zeros((0, 31)), "drift_c": []})
    with pytest.raises(InputError, match="support = 'middle' is unknown; there are: left, right"):
        estimator.update(**{**fits, "support": "middle"})
    with pytest.raises(DimensionError, match="tau has 24 entries; it must have 25"):
        estimator.estimate(np.zeros(24))


def test_estimator_without_contact_says_so(dynamics):
    d = dynamics
    estimator = zmpwalk.ZmpEstimator(31)
    standing = (True, False)
    estimator.update(d.A, d.b, d.g, d.left.J, d.left.drift, standing, [d.left.p_WF, d.right.p_WF], "left")
    limp = estimator.estimate(np.zeros(25))
    assert np.isnan(limp.f_c[6:]).all()
    assert np.isfinite(limp.f_c[:6]).all()
    assert limp.in_contact == bool(abs(limp.f_c[2]) >= 1.0)
    d.g, d.b, d.left.drift = np.zeros(31), np.zeros(31), np.zeros(6)  # weightless and at rest
    estimator.update(d.A, d.b, d.g, d.left.J, d.left.drift, standing, [d.left.p_WF, d.right.p_WF], "left")
    floating = estimator.estimate(np.zeros(25))
    assert not floating.in_contact
    assert np.isnan(floating.zmp).all()


def test_whole_body_controller_refuses_what_does_not_fit(dynamics, whole_body, accelerations):
    with pytest.raises(InputError, match="before prepare"):
        whole_body.solve([0.0, 0.0])
    with pytest.raises(InputError, match="no foot stands"):
        whole_body.prepare(dynamics, (False, False), "left", accelerations)
    with pytest.raises(InputError, match="support = 'up' is unknown; there are: left, right"):
        whole_body.prepare(dynamics, (True, True), "up", accelerations)
    with pytest.raises(DimensionError, match="10 entries; it must have 31"):
        whole_body.prepare(_core.Dynamics(10), (True, True), "left", accelerations)
    short = _core.TaskAccelerations(np.zeros(3), np.zeros(3), np.zeros(6), np.zeros(3))
    with pytest.raises(DimensionError, match=r"f_star\.posture has 3 entries; it must have 25"):
        whole_body.prepare(dynamics, (True, True), "left", short)
    with pytest.raises(DimensionError, match="2 entries; it must have 6"):
        _core.WholeBodyController(31, [[0, 1], [2, 3]])
    with pytest.raises(DimensionError, match=r"99 is outside 0\.\.24"):
        _core.WholeBodyController(31, [[0, 1, 2, 3, 4, 99], [6, 7, 8, 9, 10, 11]])


def test_support_must_be_a_foot_that_stands(dynamics, whole_body, accelerations):
    with pytest.raises(InputError, match="right"):
        whole_body.prepare(dynamics, (True, False), "right", accelerations)


# --- wrong types and wrong data


def test_what_is_no_mujoco_object_is_named(scene):
    model, description, data = scene
    controller = zmpwalk.WalkingController(model, description)
    with pytest.raises(TypeError, match=r"expected a mujoco\.MjData, got MjModel"):
        controller.update(model)
    with pytest.raises(TypeError, match=r"expected a mujoco\.MjData, got NoneType"):
        controller.reset(None)
    with pytest.raises(TypeError, match=r"expected a mujoco\.MjModel, got MjData"):
        _core.WalkingController(data, description)
    with pytest.raises(TypeError, match=r"expected a mujoco\.MjModel, got str"):
        zmpwalk.measured_zmp("mahru", data, description)
    with pytest.raises(TypeError):
        _core.WalkingController(model, description, {"law": "paper"})
    with pytest.raises(TypeError):
        _core.Recorder(data)


def test_data_of_another_model_is_refused(scene):
    """Its arrays are shorter: reading on would be reading someone else's memory."""
    model, description, data = scene
    other = mujoco.MjData(mujoco.MjModel.from_xml_string("<mujoco><worldbody/></mujoco>"))
    controller = zmpwalk.WalkingController(model, description)
    controller.reset(data)
    out = controller.update(data)
    for call in (
        lambda: controller.reset(other),
        lambda: controller.update(other),
        lambda: _core.Recorder(controller).add(out, other),
        lambda: _core.Robot(model, description).read(other),
        lambda: zmpwalk.measured_zmp(model, other, description),
    ):
        with pytest.raises(zmpwalk.Error, match="model"):
            call()


def test_robot_that_is_not_in_the_model_is_refused(scene):
    ball = "<mujoco><worldbody><body><freejoint/><geom size='1'/></body></worldbody></mujoco>"
    other = mujoco.MjModel.from_xml_string(ball)
    with pytest.raises(ModelError, match="the model has no joint named 'root'"):
        _core.WalkingController(other, scene[1])


def test_update_before_reset_is_refused(scene):
    with pytest.raises(InputError, match="before reset"):
        zmpwalk.WalkingController(*scene[:2]).update(scene[2])


@pytest.mark.parametrize("where", ["qpos", "qvel"])
@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_nan_in_data_raises_and_changes_nothing(scene, where, value):
    model, description, data = scene

    def walk(spoiled_at=None):
        description.place(model, data)
        mujoco.mj_resetData(model, data)
        description.place(model, data)
        controller = zmpwalk.WalkingController(model, description)
        controller.reset(data)
        taus = []
        for k in range(40):
            if k == spoiled_at:
                array = getattr(data, where)
                kept, ctrl = array.copy(), data.ctrl.copy()
                array[-3] = value
                spoiled = array.copy()
                with pytest.raises(InputError, match="not finite"):
                    controller.update(data)
                assert_array_equal(array, spoiled)
                assert_array_equal(data.ctrl, ctrl)
                with pytest.raises(InputError, match="not finite"):
                    controller.reset(data)
                array[:] = kept
            taus.append(controller.update(data).tau.copy())
            mujoco.mj_step(model, data)
        return np.array(taus)

    assert_array_equal(walk(spoiled_at=20), walk())


def test_reset_on_nan_leaves_a_new_controller_unstarted(scene):
    model, description, data = scene
    controller = zmpwalk.WalkingController(model, description)
    data.qpos[3] = np.nan
    with pytest.raises(InputError, match="not finite"):
        controller.reset(data)
    with pytest.raises(InputError, match="before reset"):
        controller.update(data)
    with pytest.raises(InputError, match="not finite"):
        _core.Robot(model, description).read(data)


# --- settings


def test_settings_take_keywords_and_give_them_back():
    settings = WalkSettings(law="paper", com_x_kp=7, footsteps=[0.1, 0.2], posture_task=False)
    assert (settings.law, settings.com_x_kp, settings.footsteps, settings.posture_task) == ("paper", 7.0, "list", False)
    assert settings.step_lengths == [0.1, 0.2]
    again = settings.to_dict()
    law, again["footsteps"] = again.pop("law"), again["step_lengths"]
    assert WalkSettings(law, **again) == settings
    assert WalkSettings("paper", footsteps=np.array([0.1, 0.2])).step_lengths == [0.1, 0.2]


def test_settings_copy_pickle_compare_and_print():
    settings = WalkSettings("paper", com_x_kp=7.0, T_ds=float("nan"))
    for other in (copy.copy(settings), copy.deepcopy(settings), pickle.loads(pickle.dumps(settings))):
        assert other == settings
        assert other.law == "paper"
        other.com_x_kp = 8.0
        assert other != settings
        assert settings.com_x_kp == 7.0
    assert settings != WalkSettings()
    assert settings != 3
    assert settings is not None and settings != None  # noqa: E711
    assert repr(settings).startswith("WalkSettings(law='paper', ")
    assert "com_x_kp=7.0" in repr(settings)


@pytest.mark.parametrize(
    ("keywords", "message"),
    [
        ({"law": "literal"}, "law = 'literal' is unknown; there are: default, paper"),
        ({"com_kp": 1.0}, r"there is no setting 'com_kp'; did you mean com.kp_x \(com_x_kp\)"),
        ({"tracker": "smoth"}, "tracker = 'smoth' is unknown; there are: smooth, bang_bang"),
        ({"iteration": "newton"}, "iteration = 'newton' is unknown; there are: closed_form, loop"),
        ({"footsteps": "short"}, "footsteps = 'short' is unknown; there are: tied, absolute, paper, printed, list"),
        ({"footsteps": [0.1, "far"]}, r"footsteps = \[0.1, 'far'\] is of the wrong type"),
        ({"com_x_kp": "stiff"}, "com_x_kp = 'stiff' is of the wrong type"),
        ({"com_x_kp": None}, "com_x_kp = None is of the wrong type"),
        ({"feed_forward": 1}, "feed_forward = 1 is of the wrong type; it must be true or false"),
        ({"max_iterations": 2.5}, "max_iterations = 2.5 is of the wrong type"),
        ({"first_swing": "middle"}, "first_swing = 'middle' is unknown; there are: right, left"),
    ],
)
def test_wrong_settings_are_named_at_once(keywords, message):
    with pytest.raises(InputError, match=message):
        WalkSettings(**keywords)


@pytest.mark.parametrize(
    ("keywords", "message"),
    [
        ({"T_ss": -0.1}, "T_ss = -0.1.*greater than 0"),
        ({"T_ds": float("inf")}, "T_ds = inf"),
        ({"zmp_threshold": 0.0}, r"zmp.threshold \(zmp_threshold\) = 0"),
        ({"sole_fraction": float("nan")}, "sole_fraction = nan"),
        ({"com_x_kp": -1.0}, r"com_x_kp\) = -1.*not negative"),
        ({"max_iterations": 0}, "max_iterations = 0; it must be at least 1"),
        ({"footsteps": []}, "'list' needs steps.lengths"),
        ({"footsteps": [0.1, float("nan")]}, r"step_lengths\) = nan"),
        ({"control_dt": 0.0015}, r"control_dt\) = 0.0015.* multiple of the model's time step, 0.001"),
        ({"sole_fraction": 1e-9}, None),
    ],
)
def test_settings_that_break_a_rule_are_refused_by_the_controller(scene, keywords, message):
    model, description, _ = scene
    settings = WalkSettings(**keywords)
    if message is None:
        zmpwalk.WalkingController(model, description, settings)  # strange, but no rule says no
        return
    with pytest.raises(InputError, match=message):
        zmpwalk.WalkingController(model, description, settings)


def test_refused_setting_leaves_the_settings_as_they_were():
    settings = WalkSettings(com_x_kp=5.0)
    before = settings.to_dict()
    for name, value in (("com_x_kp", "x"), ("tracker", "y"), ("footsteps", [0.1, "z"]), ("law", "paper"), ("nope", 1)):
        with pytest.raises((InputError, AttributeError)):
            setattr(settings, name, value)
    assert repr(settings.to_dict()) == repr(before)


def test_controller_takes_a_copy_of_settings_and_gives_copies(scene):
    model, description, _ = scene
    settings = WalkSettings(com_x_kp=50.0)
    controller = zmpwalk.WalkingController(model, description, settings)
    settings.com_x_kp = 1.0
    assert controller.settings.com_x_kp == 50.0
    controller.settings.com_x_kp = 2.0
    assert controller.settings.com_x_kp == 50.0
    assert np.isnan(settings.T_ds)  # the given ones keep "from the robot"
    assert controller.settings.T_ds > 0


# --- keywords


def test_arguments_have_the_names_of_the_design(scene):
    model, description, data = scene
    controller = zmpwalk.WalkingController(
        model=model, description=description, settings=WalkSettings(), profile=VelocityProfile.paper()
    )
    controller.reset(data=data)
    out = controller.update(data=data)
    mujoco.mj_step(model, data)
    recorder = zmpwalk.Recorder(controller)
    recorder.add(out=out, data=data)
    assert len(recorder.trace().t) == 1
    assert zmpwalk.measured_zmp(model=model, data=data, description=description).shape == (2,)
    lower, upper = controller.zmp_bounds(side="left")
    assert np.all(lower < upper)
    with pytest.raises(InputError, match="side = 'up' is unknown; there are: left, right"):
        controller.zmp_bounds("up")
    profile = _core.VelocityProfile(t=[0.0, 1.0], v=[[0.1, 0, 0], [0.2, 0, 0]], interpolation="linear")
    assert profile.displacement(t0=0.0, t1=1.0)[0] == pytest.approx(0.15)
    with pytest.raises(TypeError):
        zmpwalk.WholeBodyController(31, [[0] * 6, [0] * 6], True)  # options by name only


def test_rooms_stand_alone_in_python():
    """Pendulum, tracker and gait on plain numbers, without model or simulator."""
    tracker = zmpwalk.VelocityTracker(law="smooth", gain=5.0, time=0.05)
    tracker.advance(v_des=0.2, v_plan=0.25, dt=0.01)
    assert tracker.integral == pytest.approx(-5e-4)
    assert tracker.acceleration(v_plan=0.25, v=0.2) == pytest.approx((0.25 + 5.0 * 5e-4 - 0.2) / 0.05)
    with pytest.raises(InputError, match="law = 'pid' is unknown"):
        zmpwalk.VelocityTracker(law="pid")
    gait = zmpwalk.GaitGenerator(com_height=0.747, foot_distance=0.22, sole_width=0.14, profile=VelocityProfile.paper())
    soles = np.array([[0, 0.11, 0], [0, -0.11, 0]])
    gait.reset(com=[0, 0], dcom=[0, 0], soles=soles)
    first = gait.update(t=0.0, com=[0, 0], dcom=[0, 0], soles=soles)
    assert (first.phase, first.support, first.standing) == (0, -1, [True, True])
    with pytest.raises(InputError, match="t = nan"):
        gait.update(t=float("nan"), com=[0, 0], dcom=[0, 0], soles=soles)


# --- the lock, callbacks, Ctrl-C


def test_simulation_releases_the_lock(scene):
    controller = zmpwalk.WalkingController(*scene[:2])
    done = threading.Event()
    worker = threading.Thread(target=lambda: (_core.simulate(controller, 6.0), done.set()))
    worker.start()
    progress = 0
    while not done.is_set():
        progress += 1
    worker.join()
    # Behind the lock this loop would run between callbacks at most, some ten times.
    assert progress > 10000


def test_two_simulations_run_side_by_side(scene):
    alone, _ = _core.simulate(zmpwalk.WalkingController(*scene[:2]), 1.0)
    results = [None, None]

    def run(k):
        results[k] = _core.simulate(zmpwalk.WalkingController(*zmpwalk.load_robot("mahru")), 1.0)[0]

    threads = [threading.Thread(target=run, args=(k,)) for k in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for columns in results:
        assert_array_equal(columns["qpos"], alone["qpos"])


def test_progress_is_told_while_it_walks(scene):
    seen = []
    controller = zmpwalk.WalkingController(*scene[:2])
    _, info = _core.simulate(controller, 8.0, lambda t, duration: seen.append((t, duration)))
    times = [t for t, _ in seen]
    assert times == sorted(times)
    assert all(duration == 8.0 for _, duration in seen)
    assert 1 <= len(seen) <= 25 * info["wall_time"] + 1  # about twenty a second


class Stop(Exception):
    pass


def raise_stop(t, duration):
    raise Stop(f"at {t}")


def test_exception_in_the_callback_propagates_and_the_controller_walks_again(scene):
    controller = zmpwalk.WalkingController(*scene[:2])
    for _ in range(2):
        with pytest.raises(Stop, match="at "):
            _core.simulate(controller, 1000.0, raise_stop)
    fresh, _ = _core.simulate(zmpwalk.WalkingController(*scene[:2]), 0.3)
    again, _ = _core.simulate(controller, 0.3)
    assert_array_equal(again["qpos"], fresh["qpos"])


@pytest.mark.parametrize("on_progress", [None, lambda t, duration: None], ids=["no callback", "callback"])
def test_ctrl_c_stops_the_walk(scene, on_progress, ctrl_c):
    controller = zmpwalk.WalkingController(*scene[:2])
    timer = threading.Timer(0.3, _thread.interrupt_main)
    start = time.perf_counter()
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        _core.simulate(controller, 100000.0, on_progress)
    timer.join()
    assert time.perf_counter() - start < 20.0


def test_keyboard_interrupt_from_the_callback_propagates(scene):
    def stop(t, duration):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        _core.simulate(zmpwalk.WalkingController(*scene[:2]), 1000.0, stop)


@pytest.mark.parametrize("duration", [0.0, -1.0, np.nan, np.inf])
def test_duration_must_be_positive_and_finite(scene, duration):
    with pytest.raises(InputError, match="duration = "):
        _core.simulate(zmpwalk.WalkingController(*scene[:2]), duration)


# --- the same numbers


def contact_sum(model, data, description):
    """ZMP of the contact forces from what MuJoCo's own bindings say, on the load-weighted plane of the soles."""
    feet = [description.left, description.right]
    bodies = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, foot.body) for foot in feet]
    sites = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SITE, foot.sole_site) for foot in feet]
    F, M, force = np.zeros((2, 3)), np.zeros(3), np.zeros(6)
    for i in range(data.ncon):
        contact = data.contact[i]
        pair = [model.geom_bodyid[contact.geom1], model.geom_bodyid[contact.geom2]]
        for side, body in enumerate(bodies):
            if body not in pair:
                continue
            mujoco.mj_contactForce(model, data, i, force)  # of the first geom on the second, in the contact's axes
            f = (1 if body == pair[0] else -1) * np.array(contact.frame).reshape(3, 3).T @ force[:3]
            F[side] += f
            M += np.cross(np.array(contact.pos), f)
    total = F.sum(axis=0)
    plane = F[:, 2] @ data.site_xpos[sites, 2] / total[2]  # positions that mj_step left are those of the forces
    M = M - np.cross([0, 0, plane], total)
    return np.array([-M[1] / total[2], M[0] / total[2]])


def test_measured_zmp_is_the_sum_over_numpy_contacts(scene):
    model, description, data = scene
    controller = zmpwalk.WalkingController(model, description)
    controller.reset(data)
    compared = 0
    while data.time < 1.3:
        controller.update(data)
        mujoco.mj_step(model, data)
        measured = zmpwalk.measured_zmp(model, data, description)
        if round(data.time * 1000) % 10 or np.isnan(measured).any():
            continue
        assert measured == pytest.approx(contact_sum(model, data, description), abs=1e-9)
        compared += 1
    assert compared > 100


def test_measured_zmp_in_the_air_is_nan(scene):
    model, description, data = scene
    description.place(model, data, ground=1.0)
    mujoco.mj_step(model, data)
    assert np.isnan(zmpwalk.measured_zmp(model, data, description)).all()


def test_same_inputs_give_bit_identical_traces(scene):
    first = zmpwalk.simulate("mahru", duration=2.0)
    again = zmpwalk.simulate("mahru", duration=2.0)
    assert again == first
    controller = zmpwalk.WalkingController(*scene[:2])
    for _ in range(2):  # and a controller that has walked before is as good as new
        columns, _ = _core.simulate(controller, 2.0)
        for name, column in columns.items():
            assert_array_equal(column, first[name], err_msg=name)


def test_same_inputs_give_bit_identical_traces_in_another_process(tmp_path):
    code = "import sys, zmpwalk; zmpwalk.simulate('mahru', duration=0.5).save(sys.argv[1])"
    subprocess.run([sys.executable, "-c", code, str(tmp_path / "other.npz")], check=True, timeout=120)
    assert zmpwalk.Trace.load(tmp_path / "other.npz") == zmpwalk.simulate("mahru", duration=0.5)


def test_textbook_path_walks_the_same_walk():
    direct = zmpwalk.simulate("mahru", duration=1.0)
    textbook = zmpwalk.simulate("mahru", duration=1.0, settings=WalkSettings(textbook=True))
    assert np.abs(textbook.com - direct.com).max() < 1e-8


def test_slower_control_holds_the_torque_between(scene):
    model, description, data = scene
    controller = zmpwalk.WalkingController(model, description, WalkSettings(control_dt=0.004))
    controller.reset(data)
    recorder = zmpwalk.Recorder(controller)
    fresh, torques = [], []
    for _ in range(40):
        out = controller.update(data)
        fresh.append(out.fresh)
        torques.append(data.ctrl.copy())
        mujoco.mj_step(model, data)
        recorder.add(out, data)
    assert fresh == [True, False, False, False] * 10
    held = np.array(torques).reshape(10, 4, -1)
    assert np.all(held == held[:, :1])
    assert np.all(np.abs(np.diff(held[:, 0], axis=0)).max(axis=1) > 0)
    trace = recorder.trace()
    assert trace.t == pytest.approx(0.004 * np.arange(10))  # held cycles add no row
    assert_array_equal(trace.tau, held[:, 0])
    in_cpp, _ = _core.simulate(zmpwalk.WalkingController(model, description, WalkSettings(control_dt=0.004)), 0.04)
    assert_array_equal(in_cpp["qpos"], trace.qpos)


def test_core_knows_which_mujoco_it_was_built_with():
    assert _core.mujoco_version() == mujoco.__version__
