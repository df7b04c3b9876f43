"""Arms, waist and trunk that move while the legs walk, arms that cancel yaw momentum, and the walk without III-B."""

import math
import pickle

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk import InputError, JointMotion, VelocityProfile, WalkSettings, analysis
from zmpwalk.cli import main

MM = 1e-3
SPEED = 0.25
WAVE = {"l_shoulder_pitch": 1.0, "r_shoulder_pitch": -1.0}


def walk(motion=None, duration=10.0, speed=SPEED, **settings):
    trace = zmpwalk.simulate(
        "mahru", VelocityProfile.ramp(0, speed, 3), duration, WalkSettings(**settings), motion=motion
    )
    assert not trace.meta["fell"], (trace.meta["fall_time"], trace.meta["fall_cause"])
    return trace


def joints(trace, *names):
    return trace.qpos[:, [7 + trace.meta["joint_names"].index(name) for name in names]]


@pytest.fixture(scope="module")
def mahru():
    return zmpwalk.load_robot("mahru")


@pytest.fixture(scope="module")
def swinging():
    return walk(JointMotion.sine(WAVE, 1.0, 10.0))


# --- a motion while walking


def test_arms_follow_their_references_while_the_robot_walks(swinging):
    late = swinging.t > swinging.t[0] + 1.0  # blended in
    wanted = np.array([swinging.motion.at(t)[0] for t in swinging.t[late]])
    assert np.abs(joints(swinging, *swinging.motion.names)[late] - wanted).max() < 0.02


def test_the_estimate_absorbs_swinging_arms(swinging):
    error = analysis.zmp_error(swinging)
    assert np.median(error, axis=0).max() < 0.05 * MM
    assert np.percentile(error, 95, axis=0).max() < 2 * MM
    assert analysis.bound_excess(swinging).max() < 0.01 * MM
    walked = swinging.t > 4.0
    speed = (swinging.com[-1, 0] - swinging.com[walked][0, 0]) / (swinging.t[-1] - swinging.t[walked][0])
    assert speed == pytest.approx(SPEED, rel=0.01)


def test_a_motion_begins_without_a_jump(mahru):
    """A step of the reference by 1.25 rad would change the torque by tens of N m at once."""
    model, description = mahru
    controller = zmpwalk.WalkingController(model, description, profile=VelocityProfile.constant(0.0))
    data = mujoco.MjData(model)
    description.place(model, data)
    controller.reset(data)
    arm = controller.joint_names.index("l_shoulder_pitch")
    torque = []
    for k in range(2500):
        if k == 700:
            controller.move(JointMotion([0.0, 1.0], ["l_shoulder_pitch"], [[-1.0], [-2.0]]))
        if k == 1500:
            controller.move(None)
        torque.append(controller.update(data).tau[arm])
        mujoco.mj_step(model, data)
    assert np.ptp(torque) > 3.0
    assert np.abs(np.diff(torque)).max() < 0.5
    address = model.jnt_qposadr[mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, "l_shoulder_pitch")]
    assert data.qpos[address] == pytest.approx(description.stand_joints["l_shoulder_pitch"], abs=0.01)


def test_the_trunk_turns_as_asked_in_the_heading_frame():
    angles = {"trunk_roll": 0.08, "trunk_pitch": 0.15, "trunk_yaw": -0.1}
    trace = walk(JointMotion([0.0, 2.0], list(angles), [[0.0] * 3, list(angles.values())]))
    w, x, y, z = trace.qpos[-1, 3:7]
    roll = math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))
    pitch = math.asin(2 * (w * y - z * x))
    yaw = math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
    assert [roll, pitch, yaw] == pytest.approx(list(angles.values()), abs=0.005)


def test_a_run_again_repeats_the_motion(swinging, tmp_path):
    again = zmpwalk.Trace.load(swinging.save(tmp_path / "trace.npz"))
    assert again.motion == swinging.motion
    assert again.rerun().identical(swinging)
    batch = zmpwalk.simulate_batch([{"profile": swinging.profile, "duration": 10.0, "motion": swinging.motion}])
    assert batch[0].identical(swinging)


@pytest.mark.parametrize(
    ("t", "names", "q", "words"),
    [
        ([0], ["l_elbo"], [[0]], ["l_elbo", "l_elbow", "trunk_yaw"]),
        ([0], ["l_knee"], [[0.5]], ["l_knee", "leg"]),
        ([0], ["l_elbow"], [[0.4]], ["l_elbow", "0.4", "-2.27"]),
        ([0, 1, 1.1], ["l_elbow"], [[-2.2], [-2.2], [-1.0]], ["l_elbow", "-2.27", "between the knots"]),
        ([0], ["trunk_pitch"], [[0.5]], ["trunk_pitch", "0.5", "0.4"]),
        ([0, math.nan], ["l_elbow"], [[0], [0]], ["nan"]),
        ([0, 1, 1], ["l_elbow"], [[0], [0], [0]], ["1.0", "increase"]),
    ],
)
def test_a_motion_that_cannot_be_is_refused_with_value_and_rule(mahru, t, names, q, words):
    controller = zmpwalk.WalkingController(*mahru)
    with pytest.raises(InputError) as error:
        controller.move(JointMotion(t, names, q))
    for word in words:
        assert word in str(error.value)
    assert controller.motion is None


# --- ways to make one


def test_random_motion_keeps_limits_and_speed_and_depends_on_its_seed(mahru):
    model, description = mahru
    controller = zmpwalk.WalkingController(model, description)
    motion = JointMotion.random(controller, seed=1, max_speed=3.0, duration=12.0)
    assert motion.names == controller.arm_joints
    q, dq, _ = np.moveaxis([motion.at(t) for t in np.linspace(0, 12, 5000)], 1, 0)
    assert 2.5 < np.abs(dq).max() < 3.0
    ids = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name) for name in motion.names]
    assert (q > model.jnt_range[ids, 0]).all()
    assert (q < model.jnt_range[ids, 1]).all()
    assert motion == JointMotion.random(controller, seed=1, max_speed=3.0, duration=12.0)
    assert motion != JointMotion.random(controller, seed=2, max_speed=3.0, duration=12.0)
    controller.move(motion)
    with pytest.raises(InputError, match="l_elbo"):
        JointMotion.random(controller, seed=1, names=["l_elbo"])


def test_sine_swings_between_its_amplitudes_and_starts_and_ends_at_rest():
    motion = JointMotion.sine(WAVE, 2.0, 5.0, centre={"r_shoulder_pitch": 0.2})
    q, dq, ddq = np.moveaxis([motion.at(t) for t in np.linspace(0, 5, 5001)], 1, 0)
    assert np.abs(q - [0, 0.2]).max() == pytest.approx(1.0, rel=2e-3)
    assert np.abs(dq).max() == pytest.approx(4 * math.pi, rel=0.01)
    assert np.abs(ddq).max() < 1.1 * (4 * math.pi) ** 2  # no kink where it starts and stops
    middle = [motion.at(t)[0, 0] for t in (2.0, 2.25, 2.5)]  # a whole period apart, and half
    assert middle[0] == pytest.approx(middle[2], abs=2e-3)
    assert middle[0] == pytest.approx(-middle[1], abs=2e-3)


def test_motions_survive_pickle_dict_and_csv(tmp_path):
    motion = JointMotion([0.0, 1.0], ["l_elbow", "trunk_yaw"], [[-0.5, 0.0], [-1.0, 0.1]])
    assert pickle.loads(pickle.dumps(motion)) == motion
    assert JointMotion.from_dict(motion.to_dict()) == motion
    (tmp_path / "m.csv").write_text("# a wave\nt, l_elbow, trunk_yaw\n0, -0.5, 0\n\n1, -1, 0.1\n")
    assert JointMotion.from_csv(tmp_path / "m.csv") == motion


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("0,1\n1,2\n", "header"),
        ("t,l_elbow\n0,x\n", "line 2"),
        ("t,l_elbow\n0,-1\n1\n", "line 3"),
        ("t,l_elbow\n0,-1\n0,-1\n", "increase"),
        ("t,l_elbow\n0,nan\n", "nan"),
    ],
)
def test_a_bad_csv_names_file_line_and_rule(tmp_path, text, words):
    path = tmp_path / "m.csv"
    path.write_text(text)
    with pytest.raises(InputError, match=words) as error:
        JointMotion.from_csv(path)
    assert str(path) in str(error.value)


def test_the_command_line_takes_a_motion(tmp_path):
    (tmp_path / "m.csv").write_text("t,l_elbow\n0,-0.5\n1,-1.5\n")
    words = [
        "walk",
        "--motion",
        str(tmp_path / "m.csv"),
        "--duration",
        "2",
        "--no-figures",
        "--out",
        str(tmp_path / "o"),
    ]
    assert main(words) == 0
    trace = zmpwalk.Trace.load(tmp_path / "o" / "trace.npz")
    assert joints(trace, "l_elbow")[-1, 0] == pytest.approx(-1.5, abs=0.01)
    (tmp_path / "m.csv").write_text("t,l_knee\n0,0.5\n")
    assert main([*words[:-1], str(tmp_path / "p")]) == 2
    assert not (tmp_path / "p").exists()


# --- arms that cancel the yaw momentum


def test_momentum_arms_take_most_of_the_ground_yaw_moment_away():
    moments = [analysis.yaw_moment(walk(speed=0.35, momentum_arms=share)) for share in (0.0, 0.5, 1.0)]
    peak = [np.abs(moment[6000:]).max() for moment in moments]
    rms = [np.sqrt(np.mean(moment[6000:] ** 2)) for moment in moments]
    assert peak[2] < 0.7 * peak[0]
    assert rms[2] < 0.5 * rms[0]
    assert rms[2] < rms[1] < rms[0]


def test_momentum_arms_keep_the_walk_and_leave_to_a_motion_what_it_names():
    trace = walk(JointMotion([0.0, 1.0], ["l_shoulder_pitch"], [[0.25], [-0.5]]), momentum_arms=1.0)
    assert np.median(analysis.zmp_error(trace), axis=0).max() < 0.05 * MM
    assert trace.joint_margin.min() > 0.0
    late = trace.t > 3.0
    assert np.ptp(joints(trace, "l_shoulder_pitch")[late]) < 0.01
    assert np.ptp(joints(trace, "r_shoulder_pitch")[late]) > 0.2


def test_momentum_arms_let_the_robot_turn():
    """Its momentum of turning as one body is left alone: cancelled, it would hold one arm ahead of the other."""
    profile = VelocityProfile.piecewise([(0, 0.1), (1, (0.2, 0, 0.4))])
    trace = zmpwalk.simulate("mahru", profile, 10.0, WalkSettings(momentum_arms=1.0))
    assert not trace.meta["fell"]
    left, right = joints(trace, "l_shoulder_pitch", "r_shoulder_pitch")[trace.t > 5.0].T
    assert np.ptp(left) > 0.2
    assert abs(np.mean(left - right)) < 0.15


def test_momentum_arms_ask_for_a_share_and_for_arms():
    for share in (1.5, -0.1, math.nan):
        with pytest.raises(InputError, match="momentum_arms"):
            walk(momentum_arms=share)
    with pytest.raises(InputError, match="posture"):
        walk(momentum_arms=1.0, posture_task=False)


# --- without III-B


def test_without_the_iteration_the_zmp_misses_what_was_desired_by_centimetres():
    """The pendulum knows nothing of swinging legs; the estimate of the torque still says where the ZMP will be."""
    runs = [walk(iteration=iteration) for iteration in ("closed_form", "none")]
    miss = [np.nanmedian(np.abs(trace.zmp_des - trace.zmp_meas), axis=0) for trace in runs]
    assert miss[0].max() < 0.05 * MM
    assert miss[1].min() > 5 * MM
    assert np.median(analysis.zmp_error(runs[1]), axis=0).max() < 0.05 * MM


def test_without_the_iteration_the_literal_law_falls_in_its_first_step():
    """(8) alone moves the ZMP by a few percent of what its reference moves: it is III-B that brings it there."""
    trace = zmpwalk.simulate("mahru", duration=2.0, settings=WalkSettings(law="paper", iteration="none"))
    assert trace.meta["fall_time"] < 0.5
    assert not zmpwalk.simulate("mahru", duration=2.0, settings=WalkSettings(law="paper")).meta["fell"]


def test_without_the_iteration_swinging_arms_take_the_zmp_out_of_its_bounds():
    motion = JointMotion.sine(dict.fromkeys(WAVE, 1.0), 1.0, 10.0)
    excess = [analysis.bound_excess(walk(motion, iteration=i), single_support=False)[:, 0] for i in ("loop", "none")]
    assert excess[0].max() < 1.1 * MM  # the loop's threshold
    assert excess[1].max() > 5 * MM
