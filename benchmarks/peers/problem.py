"""What the peers are asked: instants of a walk of ours, with the accelerations commanded there; and how they answered.

Convention of all vectors that leave this file: pinocchio's (see `urdf.to_pinocchio`), joints in MuJoCo's order.
"""

import json

import mujoco
import numpy as np
import urdf
import zmpwalk

SIDES = ("left", "right")
WALK = 4.0  # simulated time that the instants come from [s]: the start, then every speed of the paper's profile
SETTLED = 0.25  # an instant is taken this far inside its phase, as a share of it: after impacts, before the switch
# What placo's walk generator plans: the paper's step times and four steps, on its default of 10 time steps per single
# support and on 32 (20 ms).
PLAN = {
    "single_support": 0.64,
    "double_support": 0.16,
    "steps": 4,
    "step_length": 0.2,
    "step_width": 0.22,
    "timesteps": [10, 32],
    "repeat": 20,
}
# TSID's weights. Its examples weigh motion 1 against force 1e-5, which bends the motion by 0.1 m/s^2 to spare force;
# here the motion has to be the one that was asked for. The solver's time does not depend on it.
TSID = {"motion": 1e3, "force": 1e-6, "min_force": 5.0, "max_force": 1000.0}
# placo's, for the same reason: motion, torque, contact moments (its examples: 1, 1e-3, 1e-3).
PLACO = {"motion": 1e3, "torque": 1e-6, "moments": 1e-6}


def instants(trace, count):
    """`count` rows of each phase, spread over the walk, away from its switches; single support is on the left foot."""
    middle = {}
    for phase, name in ((0, "ds"), (1, "ss")):
        mine = (trace.phase == phase) & ((trace.support == 1) | (phase == 0)) & (trace.step > 0)
        edges = np.flatnonzero(np.diff(np.concatenate([[0], mine.astype(int), [0]])))
        rows = []
        for first, last in zip(edges[::2], edges[1::2]):
            margin = int(SETTLED * (last - first))
            rows += range(first + margin, last - margin)
        middle[name] = np.array(rows)[np.linspace(0, len(rows) - 1, count).astype(int)]
    return middle


def commanded(dynamics, standing, tau):
    """Joint torque `tau` (joints,) as task accelerations: the motion that it makes while the feet stand still.

    A ddq + h + J_c' f_c = S' tau with J_c ddq = -Jdot_c dq, then x'' = J ddq + Jdot dq for every task.

    Returns:
        ddq (nv,) and the accelerations by task, world axes; `swing` only where one foot stands.
    """
    soles = {side: getattr(dynamics, side) for side in SIDES}
    J = np.vstack([soles[side].J for side in SIDES if side in standing])
    drift = np.concatenate([soles[side].drift for side in SIDES if side in standing])
    n, m = dynamics.nv, len(drift)
    K = np.block([[dynamics.A, J.T], [J, np.zeros((m, m))]])
    right = np.concatenate([np.concatenate([np.zeros(6), tau]) - dynamics.b - dynamics.g, -drift])
    ddq = np.linalg.solve(K, right)[:n]
    tasks = {
        "com": dynamics.J_com @ ddq + dynamics.drift_com,
        "trunk": dynamics.R_WB @ ddq[3:6],  # omega x omega = 0
        "posture": ddq[6:],
    }
    for side in set(SIDES) - set(standing):
        tasks["swing"] = soles[side].J @ ddq + soles[side].drift
    return tasks


def build(folder, count=16, seed=0):
    """Write robot.urdf and problem.json into `folder`.

    Returns:
        The problem as it was written, and `ours`: phase -> for each state what our whole-body controller answers.
    """
    model, description = zmpwalk.load_robot("mahru")
    robot = zmpwalk.Robot(model, description)
    root, joints = description.root_joint, urdf.joint_names(model, description.root_joint)
    if list(robot.joint_names) != joints:
        raise ValueError("joints of the robot and of its tree are not in one order")
    feet = {side: getattr(description, side) for side in SIDES}
    trunk = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_BODY, urdf.robot_bodies(model, root)[0][0])
    # placo's walk generator wants frames of these three names
    frames = {"trunk": (trunk, np.zeros(3), np.array([1.0, 0, 0, 0]))}
    for side, foot in feet.items():
        frames[f"{side}_sole"] = frames[f"{side}_foot"] = (foot.body, foot.sole_pos, foot.sole_quat)
    folder.joinpath("robot.urdf").write_text(urdf.export(model, root, robot.torque_limit, frames))

    data = mujoco.MjData(model)

    def place(qpos, qvel):
        data.qpos[:], data.qvel[:] = qpos, qvel
        mujoco.mj_forward(model, data)
        return robot.read(data)

    def coordinates(qpos, qvel):
        return {name: x.tolist() for name, x in zip("qv", urdf.to_pinocchio(qpos, qvel))}

    whole_body = zmpwalk.WholeBodyController(6 + len(joints), robot.leg_joints)

    def ask(qpos, qvel, standing, tau=None):
        """One state for the peers and our own answer to it; without torque, the state is held."""
        dynamics = place(qpos, qvel)
        if tau is None:
            tasks = {"com": np.zeros(3), "trunk": np.zeros(3), "posture": np.zeros(len(joints))}
        else:
            tasks = commanded(dynamics, standing, tau)
        f_star = zmpwalk.TaskAccelerations(**{"swing": np.zeros(6), **tasks})
        whole_body.prepare(dynamics, [side in standing for side in SIDES], SIDES[0], f_star)
        result = whole_body.solve(tasks["com"][:2])
        ddq, R = np.array(result.ddq), urdf.base_rotation(qpos)
        ddq[:3] = R.T @ ddq[:3] - np.cross(qvel[3:6], R.T @ qvel[:3])  # as in urdf.from_pinocchio
        f_c = np.array(result.f_c).reshape(2, 6)
        answer = {
            "tau": np.array(result.tau),
            "ddq": ddq,
            "wrenches": {f"{side}_sole": f_c[i] for i, side in enumerate(SIDES) if side in standing},
            "soles": {f"{side}_sole": np.array(getattr(dynamics, side).p_WF) for side in standing},
            "J_c": np.vstack([getattr(dynamics, side).J for side in standing]),
        }
        return {**coordinates(qpos, qvel), **{name: x.tolist() for name, x in tasks.items()}}, answer

    trace = zmpwalk.simulate("mahru", duration=WALK)
    asked = {}
    for phase, rows in instants(trace, count).items():
        standing = SIDES if phase == "ds" else SIDES[:1]
        asked[phase] = [ask(trace.qpos[k], trace.qvel[k], standing, trace.tau[k]) for k in rows]
    # Standing still: where no inequality of the peers is active.
    description.place(model, data)
    asked["stand"] = [ask(np.array(data.qpos), np.zeros(6 + len(joints)), SIDES)]
    phases, ours = {}, {}
    for phase, pairs in asked.items():
        feet_down = SIDES[:1] if phase == "ss" else SIDES
        phases[phase] = {
            "standing": [f"{side}_sole" for side in feet_down],
            "swing": "right_sole" if phase == "ss" else "",
            "states": [state for state, _ in pairs],
        }
        ours[phase] = [answer for _, answer in pairs]

    # The model is compared anywhere, not only where it walks.
    random = np.random.default_rng(seed)
    model_states, model_answers = [], []
    for _ in range(8):
        qpos = np.concatenate([random.normal(size=7), random.uniform(-1, 1, len(joints))])
        qpos[3:7] /= np.linalg.norm(qpos[3:7])
        qvel = random.normal(size=6 + len(joints))
        dynamics = place(qpos, qvel)
        model_states.append(coordinates(qpos, qvel))
        answer = {"A": dynamics.A, "h": dynamics.b + dynamics.g, "com": dynamics.com}
        answer["soles"] = [np.array(getattr(dynamics, side).p_WF) for side in SIDES]
        model_answers.append({**answer, "qpos": qpos, "qvel": qvel})
    ours["model"] = model_answers

    legs = {i for leg in robot.leg_joints for i in leg}
    problem = {
        "root_link": trunk,
        "joints": joints,
        "armature": urdf.armature(model, root),
        "posture_joints": [i for i in range(len(joints)) if i not in legs],
        "sole_length": feet["left"].length,
        "sole_width": feet["left"].width,
        "friction": float(model.geom_friction[0, 0]),
        "com_height": float(np.mean(trace.com[:, 2])),
        "tsid": TSID,
        "placo": PLACO,
        "plan": PLAN,
        "phases": phases,
        "model_states": model_states,
    }
    folder.joinpath("problem.json").write_text(json.dumps(problem))
    return problem, ours


def model_difference(ours, theirs):
    """Largest difference between MuJoCo's rigid-body terms and pinocchio's, each relative to its own largest entry."""
    worst = {"inertia": 0.0, "nonlinear_effects": 0.0, "com": 0.0, "soles": 0.0}
    for mine, answer in zip(ours["model"], theirs):
        A, h = urdf.from_pinocchio(mine["qpos"], mine["qvel"], np.array(answer["M"]), np.array(answer["h"]))
        pairs = {
            "inertia": (A, mine["A"]),
            "nonlinear_effects": (h, mine["h"]),
            "com": (answer["com"], mine["com"]),
            "soles": (answer["soles"], mine["soles"]),
        }
        for name, (a, b) in pairs.items():
            relative = np.abs(np.asarray(a) - b).max() / np.abs(b).max()
            worst[name] = float(np.maximum(worst[name], relative))  # keeps NaN, which max() would drop
    return worst


def total(wrenches, soles):
    """Total wrench (6,) on the ground about the world's origin, and the ZMP (2,) on the ground plane [m]."""
    force = sum(w[:3] for w in wrenches.values())
    moment = sum(w[3:] + np.cross(soles[name], w[:3]) for name, w in wrenches.items())
    z = np.mean([p[2] for p in soles.values()])
    about = moment - np.cross([0.0, 0.0, z], force)
    return np.concatenate([force, moment]), np.array([-about[1], about[0]]) / force[2]


def difference(ours, theirs):
    """How far a peer's answers are from ours, worst over the states of one phase.

    Two standing feet can press against each other in six ways without any motion; each controller chooses its own.
    `torque_motion` [N m] compares what is left of the torque without these (for one foot: all of it).

    Returns:
        acceleration [m/s^2, rad/s^2], force [N], zmp_mm [mm], torque and torque_motion [N m].
    """
    worst = dict.fromkeys(("acceleration", "force", "zmp_mm", "torque", "torque_motion"), 0.0)
    for mine, answer in zip(ours, theirs):
        wrenches = {name: np.array(w) for name, w in answer["wrenches"].items()}
        (mine_total, mine_zmp), (their_total, their_zmp) = (
            total(w, mine["soles"]) for w in (mine["wrenches"], wrenches)
        )
        tau = np.array(answer["tau"]) - mine["tau"]
        # Forces f with zero base rows of J_c' f change nothing but the joint torque J_c' f.
        J = mine["J_c"]
        internal = J[:, 6:].T @ np.linalg.svd(J[:, :6].T)[2][6:].T
        rest = tau - internal @ np.linalg.lstsq(internal, tau, rcond=None)[0] if internal.shape[1] else tau
        values = {
            "acceleration": np.abs(np.array(answer["ddq"]) - mine["ddq"]).max(),
            "force": np.abs(their_total[:3] - mine_total[:3]).max(),
            "zmp_mm": 1e3 * np.abs(their_zmp - mine_zmp).max(),
            "torque": np.abs(tau).max(),
            "torque_motion": np.abs(rest).max(),
        }
        worst = {name: float(np.maximum(worst[name], value)) for name, value in values.items()}
    return worst
