"""Remarks on a description: what may keep the robot from walking, or may surprise its user."""

from __future__ import annotations

import re
from typing import Any

import mujoco
import numpy as np

from ... import _core
from ..._core import RobotDescription
from ..description import sole_pose
from .soles import touching_geoms
from .tree import EQ, GEOM, OBJ, Tree, body_label, find_id, joint_names, name_of, root_body, tendon_joints

USUAL_SPEED = 0.06  # Froude number v / sqrt(g z_c)
LEAST_RANGE = 0.1  # of a leg's joint: with less no leg walks [rad]
MOST_RANGE = 8.0  # with more the joint has no stop worth the name [rad]
HEAVY_ROTOR = 0.65  # share of the knee's torque from which it saturates


def find_remarks(model: mujoco.MjModel, description: RobotDescription) -> list[str]:
    """Remarks on torque limits, the floor, contacts of the robot with itself, and springs of tendons."""
    remarks = []
    data = mujoco.MjData(model)
    description.place(model, data)
    root = root_body(model, description)
    tree = Tree(model, root)
    drives = description.drives(model)
    names = list(description.left.leg_joints) + list(description.right.leg_joints)
    endless = [name for name in names if not np.isfinite(drives[name][0])]
    if endless:
        which = "no leg joint" if len(endless) == len(names) else f"not each leg joint ({', '.join(endless[:3])})"
        remarks.append(f"{which} has a torque limit: give the motors a ctrlrange, or robot.json torque_limits")
    past: dict[str, list[str]] = {}  # what drives them -> joints whose torque does not go through a motor
    for name, (_, path) in drives.items():
        if path.startswith("qfrc_applied"):
            past.setdefault(re.sub(r" '[^']*'", "", path), []).append(name)
    for path, joints in past.items():
        more = ", ..." if joints[3:] else ""
        remarks.append(f"the torque of {len(joints)} joints ({', '.join(joints[:3])}{more}) goes through {path}")
    weight = float(model.body_subtreemass[root] * np.linalg.norm(model.opt.gravity))
    for side in (description.left, description.right):
        centre, axes = sole_pose(model, data, side)
        for name in side.leg_joints[3:]:
            j = find_id(model, OBJ.mjOBJ_JOINT, name)
            turn = abs(data.xaxis[j] @ axes[:, 1])
            arm = abs((data.xanchor[j] - centre) @ axes[:, 0]) if turn > 0.7 else 0.0
            limit = drives[name][0]
            if limit < arm * weight:
                remarks.append(
                    f"{name} cannot hold the robot on one foot: limit {limit:.1f} N m, need {arm * weight:.1f} N m"
                )
    fixed = [g for g in range(model.ngeom) if model.body_weldid[model.geom_bodyid[g]] == 0]
    if not any(model.geom_type[g] in (GEOM.mjGEOM_PLANE, GEOM.mjGEOM_HFIELD, GEOM.mjGEOM_BOX) for g in fixed):
        remarks.append(
            "the model has no floor (a plane, a box or a height field fixed to the world): nothing to walk on"
        )
    geoms = touching_geoms(model)
    bodies = [find_id(model, OBJ.mjOBJ_BODY, foot.body) for foot in (description.left, description.right)]
    links = [int(model.body_weldid[body]) for body in bodies]
    kinds = {int(model.geom_type[g]) for link in links for b in tree.under(link) for g in geoms.get(b, [])}
    if kinds == {GEOM.mjGEOM_MESH}:
        remarks.append(
            "the soles are meshes, which MuJoCo lets touch a floor in two to four points at a time, so that the feet "
            "rock; boxes, capsules or spheres stand still"
        )
    pairs = set()
    for i in range(data.ncon):
        bodies = [int(model.geom_bodyid[g]) for g in (data.contact[i].geom1, data.contact[i].geom2) if g >= 0]
        if len(bodies) == 2 and set(bodies) <= set(tree.bodies):
            pairs.add(" and ".join(body_label(model, b) for b in sorted(bodies)))
    remarks += [f"at the stand {pair} touch" for pair in sorted(pairs)[:3]]
    for t in range(model.ntendon):
        tied = [j for j in tendon_joints(model, t) if model.jnt_bodyid[j] in tree.bodies]
        if tied and model.tendon_limited[t]:
            label = name_of(model, OBJ.mjOBJ_TENDON, t) or t
            remarks.append(
                f"tendon '{label}' limits {joint_names(model, tied[:2])}; it is slack at the stand, not modelled"
            )
    active = model.eq_active0 if hasattr(model, "eq_active0") else model.eq_active
    for e in range(model.neq):
        coupled = [j for j in (int(model.eq_obj1id[e]), int(model.eq_obj2id[e])) if j >= 0]
        if model.eq_type[e] == EQ.mjEQ_JOINT and active[e] and any(model.jnt_bodyid[j] in tree.bodies for j in coupled):
            label = name_of(model, OBJ.mjOBJ_EQUALITY, e) or e
            remarks.append(f"equality '{label}' couples {joint_names(model, coupled)}; its force is not modelled")
    return remarks


def remark_room(ahead: float, bounds: dict[str, list[list[float]]]) -> list[str]:
    """A remark where weak ankles leave the ZMP little room ahead of, or behind, the middle of the soles.

    Args:
        ahead: how far ahead of that middle the COM rides for it [m] (`RobotDescription.stand_ahead`).
        bounds: of the ZMP about the sole's centre, lower and upper, by side [m].
    """
    if ahead == 0.0:
        return []
    front = min(upper[0] for _, upper in bounds.values())
    back = min(-lower[0] for lower, _ in bounds.values())
    where = f"{1000 * abs(ahead):.0f} mm {'ahead of' if ahead > 0 else 'behind'} it"
    return [
        f"ankles: they hold the ZMP up to {1000 * front:.0f} mm ahead of the sole's middle and {1000 * back:.0f} mm "
        f"behind it, so the COM rides {where}; stronger ankle pitch motors would give room"
    ]


def remark_ranges(joints: list[dict[str, Any]]) -> list[str]:
    """Remarks on leg joints whose range is hardly one, or does not hold the start pose.

    Args:
        joints: as `inspect_robot` lists them.
    """
    remarks = []
    for joint in joints:
        if joint["range_rad"] is None or not joint["role"].endswith("leg"):
            continue
        (low, high), stand = joint["range_rad"], joint["stand_rad"]
        text = f"{low:+.3f} .. {high:+.3f} rad"
        if high - low < LEAST_RANGE:
            wide, as_radians = np.degrees(high - low), f"{np.degrees(low):+.2f} .. {np.degrees(high):+.2f}"
            remarks.append(
                f"range: {joint['name']} turns only {text}, {wide:.1f} degrees in all. Was {as_radians} meant, in "
                'radians? Then the file needs <compiler angle="radian"/>'
            )
        elif high - low > MOST_RANGE:
            remarks.append(
                f"range: {joint['name']} turns {text}, more than a full turn. Was {np.radians(low):+.2f} .. "
                f'{np.radians(high):+.2f} meant? Then the file\'s angles are degrees: <compiler angle="degree"/>'
            )
        if not low - 1e-3 <= stand <= high + 1e-3:
            remarks.append(f"range: {joint['name']} stands at {stand:+.3f} rad, outside its range {text}")
    return remarks


def usual_speed(model: mujoco.MjModel, com_height: float) -> float:
    """Speed of a usual walk of a robot of this COM height [m] over its soles [m/s]."""
    return USUAL_SPEED * float(np.sqrt(np.linalg.norm(model.opt.gravity) * com_height))


def remark_usual_walk(
    model: mujoco.MjModel,
    description: RobotDescription,
    controller: _core.WalkingController,
    speed: float,
    refusal: str,
) -> list[str]:
    """Remarks on what a usual walk asks of short legs, weak hips and heavy rotors.

    Args:
        model, description: of the robot.
        controller: of a walk that comes up to `speed`; where that is refused, of the robot that stands.
        speed: of a usual walk [m/s].
        refusal: why a walk of that speed is refused; empty if it is not.
    """
    g, z_c = float(np.linalg.norm(model.opt.gravity)), controller.com_height
    if speed > controller.speed_limit:
        limit = controller.speed_limits["forward"][1]
        return [f"speed: the {limit} allows {controller.speed_limit:.3f} m/s, less than a usual walk's {speed:.3f} m/s"]
    if refusal:
        return [f"a usual walk of {speed:.3f} m/s is refused: {refusal}"]
    share = controller.knee_share(speed)
    remarks = []
    if share > HEAVY_ROTOR:
        remarks.append(
            f"torque: at {speed:.3f} m/s the swinging knee takes {100 * share:.0f} % of its torque limit for its own "
            "rotor and damping; it will saturate"
        )
    # Sideways the pendulum sways: on one foot a hip carries the weight half the feet's distance beside it, and its
    # rotor follows the COM, which turns about the foot with g y / z_c^2.
    data, drives = mujoco.MjData(model), description.drives(model)
    description.place(model, data)
    soles = [sole_pose(model, data, foot) for foot in (description.left, description.right)]
    beside = 0.5 * abs((soles[0][0] - soles[1][0]) @ soles[0][1][:, 1])
    weight = float(model.body_subtreemass[root_body(model, description)]) * g
    for foot, (_, axes) in zip((description.left, description.right), soles):
        joints = [find_id(model, OBJ.mjOBJ_JOINT, name) for name in foot.leg_joints[:3]]
        j = max(joints, key=lambda joint: abs(data.xaxis[joint] @ axes[:, 0]))
        sway = float(model.dof_armature[model.jnt_dofadr[j]]) * g * beside / z_c**2
        limit = drives[name_of(model, OBJ.mjOBJ_JOINT, j)][0]
        if limit < weight * beside + sway:
            remarks.append(
                f"torque: {joint_names(model, [j])} is too weak to sway on one foot: limit {limit:.2f} N m, need "
                f"{weight * beside:.2f} N m for the weight and {sway:.2f} N m for its rotor"
            )
    return remarks
