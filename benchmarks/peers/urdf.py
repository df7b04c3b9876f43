"""A compiled MuJoCo robot as URDF, and its states in the order that pinocchio wants: for the peers, nothing else.

Kept: tree, inertia, hinge axes, ranges, torque limits, damping, dry friction; URDF has no armature, so it is apart.
Each link stands at its joint's anchor, in its MuJoCo body's axes; frames asked for become links without mass.
"""

import xml.etree.ElementTree as ET

import mujoco
import numpy as np


def _numbers(values):
    return " ".join(repr(float(x)) for x in values)


def _rotation(quat):
    """Rotation (3, 3) of a quaternion (w, x, y, z)."""
    matrix = np.zeros(9)
    mujoco.mju_quat2Mat(matrix, np.asarray(quat, float))
    return matrix.reshape(3, 3)


def _rpy(R):
    """URDF's fixed-axis roll, pitch, yaw [rad] of a rotation."""
    return np.arctan2(R[2, 1], R[2, 2]), np.arctan2(-R[2, 0], np.hypot(R[2, 1], R[2, 2])), np.arctan2(R[1, 0], R[0, 0])


def _name(model, kind, index):
    return mujoco.mj_id2name(model, kind, int(index))


def robot_bodies(model, root_joint):
    """(body, its hinge or -1) of the tree under free joint `root_joint`, parents first.

    Raises:
        ValueError: a body with a joint that is no hinge, or with two.
    """
    root = int(model.jnt_bodyid[mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, root_joint)])
    bodies = [b for b in range(model.nbody) if model.body_rootid[b] == root]
    pairs = [(root, -1)]
    for body in bodies[1:]:
        joints = range(model.body_jntadr[body], model.body_jntadr[body] + model.body_jntnum[body])
        if len(joints) > 1 or any(model.jnt_type[j] != mujoco.mjtJoint.mjJNT_HINGE for j in joints):
            raise ValueError(f"body '{_name(model, mujoco.mjtObj.mjOBJ_BODY, body)}' must have one hinge or none")
        pairs.append((body, joints[0] if joints else -1))
    return pairs


def joint_names(model, root_joint):
    """Hinges in MuJoCo's order: the order of every joint vector that goes to the peers."""
    return [_name(model, mujoco.mjtObj.mjOBJ_JOINT, j) for _, j in robot_bodies(model, root_joint) if j >= 0]


def armature(model, root_joint):
    """Rotor inertia seen at each hinge [kg m^2], in the order of `joint_names`."""
    return [float(model.dof_armature[model.jnt_dofadr[j]]) for _, j in robot_bodies(model, root_joint) if j >= 0]


def export(model, root_joint, torque_limit, frames):
    """The robot under free joint `root_joint` as URDF text.

    Args:
        model: compiled MjModel.
        root_joint: name of the robot's free joint.
        torque_limit: torque limit of each hinge [N m], in the order of `joint_names`.
        frames: name -> (body name, position (3,) [m], quaternion (w, x, y, z)) in that body: links without mass.

    Raises:
        ValueError: see `robot_bodies`.
    """
    robot = ET.Element("robot", name="robot")
    anchor = {}  # of each body: where its link stands, in the body's axes
    limits = iter(torque_limit)

    def add_joint(name, kind, parent, child, position, quat):
        joint = ET.SubElement(robot, "joint", name=name, type=kind)
        ET.SubElement(joint, "parent", link=parent)
        ET.SubElement(joint, "child", link=child)
        ET.SubElement(joint, "origin", xyz=_numbers(position), rpy=_numbers(_rpy(_rotation(quat))))
        return joint

    for body, hinge in robot_bodies(model, root_joint):
        name = _name(model, mujoco.mjtObj.mjOBJ_BODY, body)
        anchor[body] = np.array(model.jnt_pos[hinge]) if hinge >= 0 else np.zeros(3)
        link = ET.SubElement(robot, "link", name=name)
        inertial = ET.SubElement(link, "inertial")
        ET.SubElement(inertial, "origin", xyz=_numbers(model.body_ipos[body] - anchor[body]), rpy="0 0 0")
        ET.SubElement(inertial, "mass", value=repr(float(model.body_mass[body])))
        R = _rotation(model.body_iquat[body])
        inertia = R @ np.diag(model.body_inertia[body]) @ R.T
        entries = {f"i{'xyz'[i]}{'xyz'[j]}": repr(float(inertia[i, j])) for i in range(3) for j in range(i, 3)}
        ET.SubElement(inertial, "inertia", entries)
        if body == model.body_rootid[body]:
            continue
        parent = int(model.body_parentid[body])
        position = model.body_pos[body] + _rotation(model.body_quat[body]) @ anchor[body] - anchor[parent]
        parent_name, quat = _name(model, mujoco.mjtObj.mjOBJ_BODY, parent), model.body_quat[body]
        if hinge < 0:
            add_joint(f"{name}_fixed", "fixed", parent_name, name, position, quat)
            continue
        joint = add_joint(_name(model, mujoco.mjtObj.mjOBJ_JOINT, hinge), "revolute", parent_name, name, position, quat)
        ET.SubElement(joint, "axis", xyz=_numbers(model.jnt_axis[hinge]))
        lower, upper = model.jnt_range[hinge] if model.jnt_limited[hinge] else (-2 * np.pi, 2 * np.pi)
        # MuJoCo limits no speed; URDF wants a number, and no peer's task here uses it.
        ET.SubElement(
            joint,
            "limit",
            lower=repr(float(lower)),
            upper=repr(float(upper)),
            effort=repr(float(next(limits))),
            velocity="100.0",
        )
        dof = model.jnt_dofadr[hinge]
        damping, friction = model.dof_damping[dof], model.dof_frictionloss[dof]
        ET.SubElement(joint, "dynamics", damping=repr(float(damping)), friction=repr(float(friction)))

    for name, (body_name, position, quat) in frames.items():
        body = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, body_name)
        ET.SubElement(robot, "link", name=name)
        add_joint(f"{name}_fixed", "fixed", body_name, name, np.asarray(position) - anchor[body], quat)
    return ET.tostring(robot, encoding="unicode")


def base_rotation(qpos):
    """Rotation (3, 3) of the base, base axes to world, from the robot's own (nq,) coordinates."""
    return _rotation(qpos[3:7])


def to_pinocchio(qpos, qvel):
    """The robot's own coordinates in pinocchio's convention.

    Quaternion (x, y, z, w) for (w, x, y, z); base linear velocity in base axes for world axes.
    """
    qpos, qvel = np.array(qpos, float), np.array(qvel, float)
    q = np.concatenate([qpos[:3], qpos[4:7], qpos[3:4], qpos[7:]])
    return q, np.concatenate([base_rotation(qpos).T @ qvel[:3], qvel[3:]])


def from_pinocchio(qpos, qvel, M, h):
    """Inertia (nv, nv) and nonlinear effects (nv,) that pinocchio gave, in MuJoCo's velocity coordinates.

    v_P = T v with T = diag(R', I), hence A = T' M T and h = T' (h_P + M dT/dt v), dT/dt v = (-omega x R' v_lin, 0).
    """
    v = to_pinocchio(qpos, qvel)[1]
    T = np.eye(len(v))
    T[:3, :3] = base_rotation(np.asarray(qpos)).T
    drift = np.zeros(len(v))
    drift[:3] = -np.cross(v[3:6], v[:3])
    return T.T @ M @ T, T.T @ (h + M @ drift)
