"""Tasks of a user's own while the robot walks, and known forces: from Python, in `simulate` and in a loop."""

import math
import re
from pathlib import Path

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk import (
    FrameTask,
    InputError,
    JointMotion,
    JointTask,
    MomentumTask,
    Trace,
    VelocityProfile,
    WalkSettings,
    analysis,
)

MM, DEGREE = 1e-3, math.radians(1)


@pytest.fixture(scope="module")
def mahru():
    return zmpwalk.load_robot("mahru")


def body_poses(trace, name):
    """Position (T, 3) and rotation (T, 3, 3) of a site over a trace."""
    model = trace.model
    data, site = mujoco.MjData(model), mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SITE, name)
    p, R = np.empty((len(trace.t), 3)), np.empty((len(trace.t), 3, 3))
    for k in range(len(trace.t)):
        data.qpos[:] = trace.qpos[k]
        mujoco.mj_kinematics(model, data)
        p[k], R[k] = data.site_xpos[site], data.site_xmat[site].reshape(3, 3)
    return p, R


def hand_drift(trace):
    """How far the left hand is from where it started, once a task has its full effect [m]."""
    p, _ = body_poses(trace, "left_hand")
    return np.linalg.norm(p - p[0], axis=1)[trace.t > 1.0].max()


def estimate_error(trace):
    """|estimated - measured ZMP| of each row [m]; NaN without contact."""
    return np.abs(trace.zmp_est - trace.zmp_meas)


def angle(R, R_to):
    """Angle between rotations (T, 3, 3) [rad]."""
    trace = np.einsum("tij,tij->t", R, R_to)
    return 2 * np.arcsin(np.sqrt(np.clip((3 - trace) / 4, 0, 1)))


class Loop:
    """A walk in a loop of our own."""

    def __init__(self, robot, speed=0.0, **settings):
        self.model, description = robot
        self.data = mujoco.MjData(self.model)
        description.place(self.model, self.data)
        self.controller = zmpwalk.WalkingController(
            self.model, description, WalkSettings(**settings), VelocityProfile.ramp(0, speed, 1.5)
        )
        self.controller.reset(self.data)
        self.recorder = zmpwalk.Recorder(self.controller, "mahru")

    def until(self, t, each=None, external=None):
        while self.data.time < t - 1e-9:
            out = self.controller.update(self.data, external=external)
            mujoco.mj_step(self.model, self.data)
            self.recorder.add(out, self.data)
            assert not out.fell, out.fall_cause
            if each:
                each(out)


class HoldPosition:
    """A task in Python: a frame stays where it was at the first cycle."""

    def __init__(self, frame):
        self.frame, self.p = frame, None

    def compute(self, state):
        frame = state.frame(self.frame)
        if self.p is None or state.t == 0.0:
            self.p = frame.p_WF
        f_star = 400 * (self.p - frame.p_WF) - 40 * frame.velocity[:3]
        return frame.J[:3], frame.drift[:3], f_star


# --- a hand that stays in the world


@pytest.mark.parametrize("kind", ["built-in", "Python"])
def test_a_hand_stays_in_the_world_while_the_robot_walks_by(mahru, kind):
    """Ahead of the robot, for as long as the arm reaches; a core that does not know the task serves it the same."""
    walk = Loop(mahru, 0.25)
    walk.until(3.0)
    site = walk.data.site("left_hand")
    p, R = site.xpos + [0.22, 0.1, 0.1], site.xmat.reshape(3, 3).copy()
    if kind == "built-in":
        walk.controller.add(FrameTask("left_hand", position=p, orientation=R))
    else:

        class Pose:
            def __init__(self):
                self.start = None

            def compute(self, state):
                frame = state.frame("left_hand")
                if self.start is None or state.t == 0.0:
                    self.start = state.t if state.t > 0 else None
                    self.away = frame.p_WF - p
                s = np.clip((state.t - (self.start or 0.0)) / 0.5, 0, 1)
                fade = 1 - s**3 * (10 - 15 * s + 6 * s**2)
                D = R @ frame.R_WF.T
                turn = 0.5 * np.array([D[2, 1] - D[1, 2], D[0, 2] - D[2, 0], D[1, 0] - D[0, 1]])
                error = np.concatenate([p + fade * self.away - frame.p_WF, turn])
                return frame.J, frame.drift, 400 * error - 40 * frame.velocity

        walk.controller.add(Pose())
    walk.until(5.2)
    trace = walk.recorder.trace()
    late = trace.t > 3.75
    at, turned = body_poses(trace, "left_hand")
    assert np.linalg.norm(at[late] - p, axis=1).max() < 2 * MM
    assert angle(turned[late], np.broadcast_to(R, turned[late].shape)).max() < 0.5 * DEGREE
    assert analysis.bound_excess(trace).max() < 0.01 * MM
    assert np.nanmedian(estimate_error(trace)[trace.t > 3.0], axis=0).max() < 0.05 * MM


def test_a_frame_task_without_a_reference_holds_what_it_finds(mahru):
    trace = zmpwalk.simulate(mahru, VelocityProfile.constant(0.0), 3.0, tasks=[FrameTask("left_hand", "position")])
    assert hand_drift(trace) < 0.2 * MM


def test_a_function_of_time_is_followed_with_its_velocity(mahru):
    start = {}

    def circle(t):
        return start["p"] + 0.05 * np.array([1 - math.cos(3 * t), 0.0, math.sin(3 * t)])

    walk = Loop(mahru)
    walk.until(0.1)
    start["p"] = walk.data.site("left_hand").xpos + [0.05, 0.02, 0.1]
    walk.controller.add(FrameTask("left_hand", "position", reference=circle), blend=0.5)
    away, begin, site = [], walk.data.time, walk.data.site("left_hand")
    walk.until(3.0, lambda out: away.append(np.linalg.norm(site.xpos - circle(out.t - begin))))
    assert max(away[1000:]) < 0.5 * MM


def test_a_reference_is_set_anew_in_every_cycle(mahru):
    walk = Loop(mahru)
    task = JointTask(["l_elbow"])
    walk.controller.add(task)
    walk.until(0.6)

    def steer(out):
        t = out.t - 0.6
        task.set([-0.55 - 0.2 * t], [-0.2])

    walk.until(2.6, steer)
    elbow = walk.model.joint("l_elbow").qposadr[0]
    assert walk.data.qpos[elbow] == pytest.approx(-0.95, abs=0.01)


# --- a tray


def test_two_hands_carry_a_tray_as_the_page_shows(mahru):
    page = (Path(__file__).parents[2] / "docs" / "tasks.md").read_text()
    tray, reach, own = re.findall(r"```python\n(.*?)```", page, re.S)[:3]
    names = {}
    exec(tray, names)
    trace = names["trace"]
    assert not trace.meta["fell"]
    begun = np.searchsorted(trace.t, 1.5)
    assert trace.heading[-1] > 1.0
    c, s, zero = np.cos(trace.heading), np.sin(trace.heading), 0 * trace.heading
    R_HW = np.array([[c, s, zero], [-s, c, zero], [zero, zero, zero + 1]]).transpose(2, 0, 1)
    for side in ("left", "right"):
        R_HF = R_HW @ body_poses(trace, f"{side}_hand")[1]
        assert angle(R_HF[begun:], np.broadcast_to(R_HF[begun], R_HF[begun:].shape)).max() < DEGREE
    assert analysis.bound_excess(trace).max() < 0.01 * MM
    assert trace.identical(trace.rerun())  # with the tasks that were added on the way

    exec(reach, names)
    hand = body_poses(names["trace"], "right_hand")[0] - names["trace"].com
    c, s = np.cos(names["trace"].heading), np.sin(names["trace"].heading)
    place = np.column_stack([c * hand[:, 0] + s * hand[:, 1], -s * hand[:, 0] + c * hand[:, 1], hand[:, 2]])
    assert np.abs(place[2000:] - [0.30, -0.22, 0.15]).max() < 2 * MM
    assert not names["trace"].summary()["shortfalls"]

    exec(own, names)
    assert hand_drift(names["trace"]) < 0.2 * MM


# --- known forces


def test_a_known_force_leaves_the_estimate_as_true_as_without_it(mahru):
    def errors(force, told):
        walk = Loop(mahru, stand=False)
        body, site = walk.data.body("l_hand"), walk.data.site("left_hand")
        wrench = np.zeros(6)

        def push(out):
            t = walk.data.time
            wrench[:3] = np.clip(t - 1, 0, 1) * np.asarray(force)
            # MuJoCo's force acts at the body's centre of mass.
            body.xfrc_applied[:3] = wrench[:3]
            body.xfrc_applied[3:] = np.cross(site.xpos - body.xipos, wrench[:3])

        walk.until(6.0, push, {"left_hand": wrench} if told else None)
        trace = walk.recorder.trace()
        return estimate_error(trace)[trace.t > 2.5]

    free, known, unknown = errors([0, 0, 0], True), errors([-20, 0, 0], True), errors([-20, 0, 0], False)
    assert (np.nanmedian(known, axis=0) < np.nanmedian(free, axis=0) + 0.005 * MM).all()
    assert (np.nanpercentile(known, 95, axis=0) < np.nanpercentile(free, 95, axis=0) + 0.1 * MM).all()
    assert np.nanmedian(unknown[:, 0]) > 10 * np.nanmedian(free[:, 0])


# --- momentum


def test_a_momentum_task_takes_the_yaw_momentum_out_of_a_walk(mahru):
    profile = VelocityProfile.ramp(0, 0.25, 1.5)
    rms = {}
    for name, tasks in (("without", []), ("with", [MomentumTask("yaw", weight=0.95)])):
        trace = zmpwalk.simulate(mahru, profile, 5.0, tasks=tasks)
        assert not trace.meta["fell"]
        reader, data = zmpwalk.Robot(*mahru), mujoco.MjData(mahru[0])
        L = []
        for k in range(2500, len(trace.t), 10):
            data.qpos[:], data.qvel[:] = trace.qpos[k], trace.qvel[k]
            dynamics = reader.read(data)
            L.append(zmpwalk._core.yaw_momentum(dynamics) @ dynamics.dq)
        rms[name] = np.sqrt(np.mean(np.square(L)))
    assert rms["with"] < 0.3 * rms["without"]


# --- Python tasks and traces


def test_a_python_task_runs_in_simulate_and_its_trace_says_that_it_cannot_be_run_again(mahru, tmp_path):
    trace = zmpwalk.simulate(mahru, VelocityProfile.constant(0.0), 2.0, tasks=[HoldPosition("left_hand")])
    assert hand_drift(trace) < 0.2 * MM
    again = Trace.load(trace.save(tmp_path / "walk.npz"))
    with pytest.raises(InputError, match="'HoldPosition' of this trace is not in it: HoldPosition is Python"):
        again.rerun()


def test_a_walk_with_tasks_made_of_numbers_runs_again_bit_for_bit(mahru, tmp_path):
    tasks = [
        FrameTask("left_hand", "orientation", relative_to="trunk", weight=0.8),
        JointTask({"r_elbow": -1.0}, priority=1),
        JointTask(JointMotion([0, 1], ["waist_yaw"], [[0], [0.2]]), priority=-1),
        MomentumTask("all", kd=10, priority=2),
    ]
    trace = zmpwalk.simulate(mahru, VelocityProfile.constant(0.1), 1.5, tasks=tasks)
    assert [entry["task"]["type"] for entry in trace.meta["tasks"]] == [type(task).__name__ for task in tasks]
    assert Trace.load(trace.save(tmp_path / "walk.npz")).rerun().identical(trace)


def test_tasks_that_came_and_went_while_walking_do_so_again(mahru):
    walk = Loop(mahru, control_dt=0.002)
    hand, elbow = FrameTask("left_hand"), JointTask({"r_elbow": -1.0})
    walk.until(0.1)
    walk.controller.add(hand)
    walk.until(0.253)
    walk.controller.add(elbow, blend=0.2)
    walk.controller.remove(hand, blend=0.3)
    walk.until(0.4)
    walk.controller.add(hand)  # before it was gone
    walk.until(0.8)
    trace = walk.recorder.trace()
    assert [entry["same_as"] for entry in trace.meta["tasks"]] == [0, 1, 0]
    assert trace.rerun() == trace

    def steer(t, out):
        if abs(t - 0.2) < 1e-9:
            controller.add(task)
        if abs(t - 0.4) < 1e-9:
            controller.remove(task, blend=0.1)

    controller, task = zmpwalk.WalkingController(*mahru), MomentumTask("all")
    trace = zmpwalk.simulation.run(controller, 0.7, robot="mahru", command=steer)
    assert len(trace.meta["tasks"]) == 1
    assert trace.rerun() == trace


def test_a_task_that_was_set_by_code_is_not_run_again(mahru):
    task = FrameTask("left_hand", "position", position=[0.1, 0.3, 0.6])
    task.set(position=[0.1, 0.3, 0.7])
    trace = zmpwalk.simulate(mahru, VelocityProfile.constant(0.0), 0.2, tasks=[task])
    with pytest.raises(InputError, match="its reference was set by Python code"):
        trace.rerun()


def test_what_a_python_task_raises_ends_the_run_and_passes_on(mahru):
    class Fails(HoldPosition):
        def compute(self, state):
            if state.t > 0.3:
                raise ZeroDivisionError("on purpose")
            return super().compute(state)

    with pytest.raises(ZeroDivisionError, match="on purpose"):
        zmpwalk.simulate(mahru, VelocityProfile.constant(0.0), 1.0, tasks=[Fails("left_hand")])


@pytest.mark.parametrize(
    ("answer", "message"),
    [
        (None, "must return"),
        ((np.zeros((1, 5)), [0.0], [0.0]), "J is"),
        ((np.zeros((1, 31)), [0.0, 0.0], [0.0]), "drift has 2"),
        ((np.zeros((0, 31)), [], []), "no row"),
    ],
)
def test_a_python_task_that_answers_nonsense_is_refused_when_it_is_added(mahru, answer, message):
    class Nonsense:
        def compute(self, state):
            return answer

    controller = zmpwalk.WalkingController(*mahru)
    with pytest.raises(zmpwalk.Error, match=message):
        controller.add(Nonsense())
    assert controller.task_activations == []


def test_a_state_is_good_only_within_its_cycle_and_frames_are_chosen_at_first(mahru):
    kept = []

    class Keeps(HoldPosition):
        def compute(self, state):
            kept.append(state)
            if len(kept) == 3:
                state.frame("right_hand")
            return super().compute(state)

    walk = Loop(mahru)
    walk.controller.add(Keeps("left_hand"))
    walk.until(0.001)
    with pytest.raises(InputError, match="only while its compute"):
        kept[0].frame("left_hand")
    with pytest.raises(InputError, match="'right_hand' was not asked for"):
        walk.until(0.01)


def test_tasks_are_refused_with_a_reason(mahru):
    controller = zmpwalk.WalkingController(*mahru)
    task = FrameTask("left_hand")
    with pytest.raises(InputError, match="has not been added"):
        controller.remove(task)
    controller.add(task)
    for refused, message in (
        (task, "added already"),
        (FrameTask("tail"), "no body or site 'tail'"),
        (JointTask(["l_knee"]), "a joint of a leg"),
        (JointTask({"l_elbow": 1.0}), "its range is -2.27"),
        (42, "is no task"),
    ):
        with pytest.raises(InputError, match=message):
            controller.add(refused)
    with pytest.raises(InputError, match="belongs to another controller"):
        zmpwalk.WalkingController(*mahru).add(task)
    for make, message in (
        (lambda: FrameTask("left_hand", "place"), "part = 'place' is unknown"),
        (lambda: FrameTask("left_hand", relative_to="moon"), "relative_to = 'moon' is unknown"),
        (lambda: FrameTask("left_hand", position=[0, 0, 1]), "needs an orientation"),
        (lambda: FrameTask("left_hand", orientation=[0, 0, 0, 0], position=[0, 0, 1]), "quaternion"),
        (lambda: MomentumTask("sideways"), "axes = 'sideways' is unknown"),
        (lambda: JointTask([]), "at least one joint"),
    ):
        with pytest.raises(InputError, match=message):
            make()


def test_a_task_comes_and_goes_within_its_blend(mahru):
    walk = Loop(mahru)
    task = JointTask({"l_elbow": -1.0})
    walk.controller.add(task, blend=0.2)
    walk.until(0.1)
    assert 0.3 < walk.controller.task_activations[0] < 0.7
    walk.until(0.3)
    assert walk.controller.task_activations == [1.0]
    walk.controller.remove(task, blend=0.1)
    walk.until(0.5)
    assert walk.controller.task_activations == [0.0]
    walk.controller.add(task)  # anew
    walk.until(1.2)
    assert walk.controller.task_activations == [1.0]
