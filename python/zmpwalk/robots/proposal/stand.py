"""How a robot stands: a keyframe that serves, or knees bent and arms let down by inverse kinematics."""

from __future__ import annotations

import mujoco
import numpy as np

from ...errors import ModelError
from .tree import JNT, OBJ, UP, Found, Side, body_label, joint_names, name_of

BENT = 0.915  # hip to ankle at the stand, of the straight leg: knees at 0.83 rad; straighter ones take more torque
ARM_OUT = 0.3  # of a lowered arm from the vertical [rad]


def find_stand(robot: Found, ahead: float = 0.0) -> tuple[mujoco.MjData, str]:
    """A pose with flat level soles on z = 0, knees bent, COM over their middle; and the keyframe that it is, or ''.

    Args:
        ahead: how far the COM is to stand ahead of that middle, where no keyframe serves [m].
    """
    model = robot.tree.model
    keyframe = _best_keyframe(robot)
    data = mujoco.MjData(model)
    data.qpos[:] = robot.data.qpos if keyframe < 0 else model.key_qpos[keyframe]
    _forward(model, data)
    soles = [_sole(data, side) for side in robot.sides]
    if keyframe >= 0:
        label = name_of(model, OBJ.mjOBJ_KEY, keyframe) or f"{keyframe}"
        gap = abs(soles[0][0][2] - soles[1][0][2])
        if max(np.arccos(np.clip(R[2, 2], -1, 1)) for _, R in soles) < 2e-3 and gap < 1e-3 * _straight(robot):
            _put_on_ground(robot, data)
            return data, name_of(model, OBJ.mjOBJ_KEY, keyframe)
        robot.remarks.append(
            f"stand pose: keyframe '{label}', its legs moved to put the soles flat and level, knees bent"
        )
    else:
        _clip(robot, data)
        _lower_arms(robot, data)
    distance = abs((soles[0][0] - soles[1][0]) @ robot.left)
    least = 1.15 * max(side.width for side in robot.sides)
    if distance < least:
        robot.remarks.append(
            f"feet: {distance:.3f} m apart at the reference pose, set {least:.3f} m apart at the stand"
        )
        distance = least
    _bend(robot, data, distance, ahead)
    _put_on_ground(robot, data)
    if keyframe < 0:
        robot.remarks.append("stand pose: by inverse kinematics, for no keyframe stands on flat soles")
    return data, ""


def _forward(model: mujoco.MjModel, data: mujoco.MjData) -> None:
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)


def _sole(data: mujoco.MjData, side: Side) -> tuple[np.ndarray, np.ndarray]:
    """Centre and axes of a sole in the world."""
    R = data.xmat[side.link].reshape(3, 3)
    return data.xpos[side.link] + R @ side.pos, R @ side.R


def _pitch_joints(robot: Found, side: Side) -> tuple[int, int, int]:
    """Hip pitch, knee and ankle pitch."""
    turn = [abs(robot.data.xaxis[j] @ robot.left) for j in side.joints]
    return side.joints[int(np.argmax(turn[:3]))], side.joints[3], side.joints[4 + int(np.argmax(turn[4:]))]


def _sagittal(robot: Found, data: mujoco.MjData, side: Side) -> tuple[float, float, float]:
    """Hip to knee, knee to ankle, hip to ankle, seen from the side [m]."""
    hip, knee, ankle = (
        data.xanchor[j] - robot.left * (data.xanchor[j] @ robot.left) for j in _pitch_joints(robot, side)
    )
    return float(np.linalg.norm(knee - hip)), float(np.linalg.norm(ankle - knee)), float(np.linalg.norm(ankle - hip))


def _straight(robot: Found) -> float:
    return sum(_sagittal(robot, robot.data, robot.sides[0])[:2])


def _best_keyframe(robot: Found) -> int:
    """The keyframe that stands best: upright, feet down, COM over them; `stand` first, then by its knees; or -1."""
    model, best = robot.tree.model, (np.inf, -1)
    R_up = robot.data.xmat[robot.tree.root].reshape(3, 3)
    for k in range(model.nkey):
        data = mujoco.MjData(model)
        data.qpos[:] = model.key_qpos[k]
        _forward(model, data)
        soles = [_sole(data, side) for side in robot.sides]
        leg = _straight(robot)
        upright = (data.xmat[robot.tree.root].reshape(3, 3) @ R_up.T)[2, 2]
        level = min(R[2, 2] for _, R in soles)
        middle, com = (soles[0][0] + soles[1][0]) / 2, data.subtree_com[robot.tree.root]
        share = min(_sagittal(robot, data, side)[2] for side in robot.sides) / leg
        off = np.linalg.norm((com - middle)[:2])
        stands = upright > 0.9 and level > 0.98 and abs(soles[0][0][2] - soles[1][0][2]) < 0.02 * leg
        ahead = abs((soles[0][0] - soles[1][0]) @ robot.forward)
        if not stands or off > 0.35 * robot.sides[0].length or ahead > 0.2 * leg or not 0.75 < share < 0.985:
            continue
        if _outside(robot, data):
            continue
        named = 0.0 if name_of(model, OBJ.mjOBJ_KEY, k) == "stand" else 1.0
        best = min(best, (named + abs(share - BENT), k))
    return best[1]


def _limits(robot: Found) -> list[tuple[int, int, float, float]]:
    """Joint, place in qpos, range, of all limited joints with one degree of freedom."""
    model = robot.tree.model
    return [
        (j, int(model.jnt_qposadr[j]), float(model.jnt_range[j][0]), float(model.jnt_range[j][1]))
        for j in range(model.njnt)
        if model.jnt_bodyid[j] in robot.tree.bodies
        and model.jnt_limited[j]
        and model.jnt_type[j] in (JNT.mjJNT_SLIDE, JNT.mjJNT_HINGE)
    ]


def _outside(robot: Found, data: mujoco.MjData) -> list[int]:
    return [j for j, at, low, high in _limits(robot) if not low - 1e-3 <= data.qpos[at] <= high + 1e-3]


def _clip(robot: Found, data: mujoco.MjData) -> None:
    """Brings joints into their ranges, a little inside. Legs are bent later."""
    legs = [j for side in robot.sides for j in side.joints]
    outside = [j for j in _outside(robot, data) if j not in legs]
    if outside:
        names = joint_names(robot.tree.model, outside[:4])
        robot.remarks.append(f"the zero pose is outside the range of {names}; moved inside at the stand")
    for j, at, low, high in _limits(robot):
        if j in outside:
            data.qpos[at] = np.clip(data.qpos[at], low + 0.02 * (high - low), high - 0.02 * (high - low))


def _lower_arms(robot: Found, data: mujoco.MjData) -> None:
    """Lets down arms that are held out, as in many zero poses, by the one shoulder joint that does it best."""
    model, tree = robot.tree.model, robot.tree
    legs = {link for side in robot.sides for link in tree.chain(side.link)}
    for shoulder in tree.limbs(legs):
        chain = [b for b in tree.links if shoulder in tree.chain(b)]
        joints = [int(model.body_jntadr[b]) + k for b in chain for k in range(model.body_jntnum[b])]
        joints = [j for j in joints if model.jnt_type[j] == JNT.mjJNT_HINGE]

        def hang(q: dict[int, float], shoulder: int = shoulder) -> tuple[float, int]:
            for j, angle in q.items():
                data.qpos[model.jnt_qposadr[j]] = angle
            _forward(model, data)
            arm = data.subtree_com[shoulder] - data.xanchor[int(model.body_jntadr[shoulder])]
            mujoco.mj_collision(model, data)
            return float(np.arccos(np.clip(-arm[2] / max(np.linalg.norm(arm), 1e-9), -1, 1))), int(data.ncon)

        if len(chain) < 2 or not joints or model.body_subtreemass[shoulder] < 0.002 * model.body_subtreemass[tree.root]:
            continue
        start = {j: float(data.qpos[model.jnt_qposadr[j]]) for j in joints}
        angle, contacts = hang(start)
        aside = abs((data.subtree_com[shoulder] - data.subtree_com[tree.root]) @ robot.left)
        if angle < 1.0 or aside < 0.1 * _straight(robot):  # hangs already; a head
            continue
        best = (abs(angle - ARM_OUT), start)
        for j in joints[:3]:
            low, high = model.jnt_range[j] if model.jnt_limited[j] else (-np.pi, np.pi)
            for q in np.linspace(low, high, 101)[2:-2]:
                trial = {**start, j: float(q)}
                now, touching = hang(trial)
                if touching <= contacts and abs(now - ARM_OUT) < best[0] - 1e-6:
                    best = (abs(now - ARM_OUT), trial)
        hang(best[1])
        if best[1] != start:
            moved = joint_names(model, [j for j in joints if best[1][j] != start[j]])
            robot.remarks.append(f"stand pose: the arm at {body_label(model, shoulder)} is let down by {moved}")


def _bend(robot: Found, data: mujoco.MjData, distance: float, ahead: float) -> None:
    """Bends the legs to `BENT` of their length, with level soles `distance` apart and the COM `ahead` of their middle.
    The base stays.

    Raises:
        ModelError: the joints' ranges do not let it.
    """
    model, root = robot.tree.model, robot.tree.root
    axes = np.stack([robot.forward, robot.left, UP], axis=1)
    start = [data.qpos[model.jnt_qposadr[side.joints]].copy() for side in robot.sides]
    worst, failure = np.inf, None
    for knees in (1.0, -1.0):  # knees ahead; then, where the ranges forbid it, behind
        for side, q in zip(robot.sides, start):
            data.qpos[model.jnt_qposadr[side.joints]] = q
            bend = knees * np.arccos(BENT)
            for j, angle in zip(_pitch_joints(robot, side), (-bend, 2 * bend, -bend)):
                data.qpos[model.jnt_qposadr[j]] += angle * np.sign(robot.data.xaxis[j] @ robot.left)
            _keep_in_range(model, data, side)
        _forward(model, data)
        height = data.subtree_com[root][2] - np.mean([_sole(data, side)[0][2] for side in robot.sides])
        for _ in range(40):
            com = data.subtree_com[root] - ahead * robot.forward
            error = 0.0
            for side, sign in zip(robot.sides, (1, -1)):
                centre = com - UP * height + sign * robot.left * distance / 2
                error = max(error, _reach(model, data, side, centre, axes))
            _forward(model, data)
            share = np.mean([_sagittal(robot, data, side) for side in robot.sides], axis=0)
            lift = BENT * (share[0] + share[1]) - share[2]
            height += lift
            over = data.subtree_com[root] - ahead * robot.forward
            off = np.linalg.norm((over - np.mean([_sole(data, side)[0] for side in robot.sides], axis=0))[:2])
            if max(error, abs(lift), off) < 1e-7 * max(1.0, height):
                break
        if error < worst:
            worst, failure = error, data.qpos.copy()
        if error < 1e-5:
            if knees < 0:
                robot.remarks.append("stand pose: the knees bend backwards")
            return
    data.qpos[:] = failure
    stuck = [name_of(model, OBJ.mjOBJ_JOINT, j) for s in robot.sides for j in s.joints if _at_limit(model, data, j)]
    raise ModelError(
        f"no stand with bent knees and flat soles {distance:.3f} m apart was found: "
        + (f"{', '.join(stuck)} is at the end of its range" if stuck else f"the feet stay {1000 * worst:.1f} mm off")
    )


def _at_limit(model: mujoco.MjModel, data: mujoco.MjData, j: int) -> bool:
    q = data.qpos[model.jnt_qposadr[j]]
    return bool(model.jnt_limited[j] and min(q - model.jnt_range[j][0], model.jnt_range[j][1] - q) < 1e-6)


def _keep_in_range(model: mujoco.MjModel, data: mujoco.MjData, side: Side) -> None:
    for j in side.joints:
        if model.jnt_limited[j]:
            at = model.jnt_qposadr[j]
            data.qpos[at] = np.clip(data.qpos[at], *model.jnt_range[j])


def _reach(model: mujoco.MjModel, data: mujoco.MjData, side: Side, centre: np.ndarray, axes: np.ndarray) -> float:
    """Damped least squares of one leg: its sole to `centre`, its axes to `axes`. Returns what is left [m, rad]."""
    dofs = [int(model.jnt_dofadr[j]) for j in side.joints]
    places = model.jnt_qposadr[side.joints]
    jacp, jacr = np.zeros((3, model.nv)), np.zeros((3, model.nv))
    error = np.zeros(6)
    for _ in range(60):
        _forward(model, data)
        p, R = _sole(data, side)
        error[:3] = centre - p
        error[3:] = 0.5 * sum(np.cross(R[:, i], axes[:, i]) for i in range(3))
        if np.linalg.norm(error) < 1e-10:
            break
        mujoco.mj_jac(model, data, jacp, jacr, p, side.link)
        J = np.concatenate([jacp[:, dofs], jacr[:, dofs]])
        damping = min(1e-3, float(error @ error)) + 1e-12
        step = J.T @ np.linalg.solve(J @ J.T + damping * np.eye(6), error)
        data.qpos[places] += step * min(1.0, 0.3 / max(np.abs(step).max(), 1e-12))
        _keep_in_range(model, data, side)
    return float(np.linalg.norm(error))


def _put_on_ground(robot: Found, data: mujoco.MjData) -> None:
    """Moves the robot so that the middle between its soles is at z = 0, below the place of the base at `qpos0`."""
    model = robot.tree.model
    root = int(model.jnt_qposadr[model.body_jntadr[robot.tree.root]])
    _forward(model, data)
    middle = np.mean([_sole(data, side)[0] for side in robot.sides], axis=0)
    data.qpos[root : root + 2] += model.qpos0[root : root + 2] - middle[:2]
    data.qpos[root + 2] -= middle[2]
    _forward(model, data)
