"""What a walk needs to know of a robot, as plain values: feet, legs, masses, and what each joint is for."""

from __future__ import annotations

from collections import Counter
from typing import Any

import mujoco
import numpy as np

from ..._core import Foot, RobotDescription
from ..description import sole_pose
from .tree import JNT, OBJ, Tree, find_id, name_of, root_body

TURNS = ("roll", "pitch", "yaw")  # about a sole's x, y, z
LEG = ["hip", "hip", "hip", "knee", "ankle", "ankle"]  # parts that a leg's joints turn


def inspect_robot(model: mujoco.MjModel, description: RobotDescription) -> dict[str, Any]:
    """What a walk needs to know of a robot, found in its model.

    Args:
        model, description: as `load_robot` returns them.

    Returns:
        Plain values: name, base, mass_kg, com_height_m (over the lower sole, at the start pose), T_c_s, feet (where
        they stand), thigh_m, shank_m, leg_share (hip to ankle at the start pose, of the straight leg), roles (how many
        joints each), joints (role: left or right leg or arm, waist, head, toes; turns: roll, pitch or yaw in the
        sole's axes at the start pose, for a leg after the part, as "hip roll"; stand_rad, range_rad and
        torque_limit_Nm, None where there is no limit, torque_path).

    Raises:
        ModelError: the model lacks what the description names.

    Usage: `inspect_robot(*zmpwalk.load_robot("mahru"))["mass_kg"]`
    """
    data = mujoco.MjData(model)
    description.place(model, data)
    root = root_body(model, description)
    feet = {side: _foot(model, data, getattr(description, side)) for side in ("left", "right")}
    height = float(data.subtree_com[root][2] - min(foot["sole_center_m"][2] for foot in feet.values()))
    drives = description.drives(model)
    axes = sole_pose(model, data, description.left)[1]
    parts = dict(zip([*description.left.leg_joints, *description.right.leg_joints], 2 * LEG))
    joints: list[dict[str, Any]] = []
    for j, role in _roles(model, data, description).items():
        name = name_of(model, OBJ.mjOBJ_JOINT, j)
        limit, path = drives[name]
        turns = TURNS[int(np.argmax(np.abs(data.xaxis[j] @ axes)))]
        joints.append({
            "name": name,
            "role": role,
            "turns": f"{parts[name]} {turns}" if name in parts else turns,
            "stand_rad": float(data.qpos[model.jnt_qposadr[j]]),
            "range_rad": model.jnt_range[j].tolist() if model.jnt_limited[j] else None,
            "torque_limit_Nm": limit if np.isfinite(limit) else None,
            "torque_path": path,
        })  # fmt: skip
    thigh, shank, share = _leg(model, data, description.left)
    return {
        "name": description.name,
        "base": {"body": name_of(model, OBJ.mjOBJ_BODY, root), "joint": description.root_joint},
        "mass_kg": float(model.body_subtreemass[root]),
        "com_height_m": height,
        "T_c_s": float(np.sqrt(height / np.linalg.norm(model.opt.gravity))),
        "feet": feet,
        "thigh_m": thigh,
        "shank_m": shank,
        "leg_share": share,
        "stand_keyframe": description.stand_keyframe,
        "roles": dict(Counter(joint["role"] for joint in joints)),
        "joints": joints,
    }


def _foot(model: mujoco.MjModel, data: mujoco.MjData, foot: Foot) -> dict[str, Any]:
    return {
        "body": foot.body,
        "sole_site": foot.sole_site,
        "sole_center_m": sole_pose(model, data, foot)[0].tolist(),
        "length_m": float(foot.length),
        "width_m": float(foot.width),
        "leg_joints": list(foot.leg_joints),
    }


def _leg(model: mujoco.MjModel, data: mujoco.MjData, foot: Foot) -> tuple[float, float, float]:
    """Hip to knee, knee to ankle [m], and hip to ankle as a share of both, from the side as the controller sees it."""
    _, axes = sole_pose(model, data, foot)
    joints = [find_id(model, OBJ.mjOBJ_JOINT, name) for name in foot.leg_joints]
    turn = [abs(data.xaxis[j] @ axes[:, 1]) for j in joints]
    three = joints[int(np.argmax(turn[:3]))], joints[3], joints[4 + int(np.argmax(turn[4:]))]
    hip, knee, ankle = (data.xanchor[j] - axes[:, 1] * (data.xanchor[j] @ axes[:, 1]) for j in three)
    thigh, shank, whole = (float(np.linalg.norm(bone)) for bone in (knee - hip, ankle - knee, ankle - hip))
    return thigh, shank, whole / max(thigh + shank, 1e-9)


def _roles(model: mujoco.MjModel, data: mujoco.MjData, description: RobotDescription) -> dict[int, str]:
    """What each joint of the robot is for: a leg's, or by where the limb hangs that it is in; else the waist's."""
    sides = {"left": description.left, "right": description.right}
    feet = {word: int(model.body_weldid[find_id(model, OBJ.mjOBJ_BODY, foot.body)]) for word, foot in sides.items()}
    tree = Tree(model, feet["left"])
    left = sole_pose(model, data, description.left)[1][:, 1]
    roles: dict[int, str] = {}
    limbs = tree.limbs({link for foot in feet.values() for link in tree.chain(foot)})
    for limb in limbs:
        side = (data.subtree_com[limb] - data.subtree_com[tree.root]) @ left
        place = [f"{word} toes" for word, foot in feet.items() if foot in tree.chain(limb)]
        aside = abs(side) > 0.2 * data.subtree_com[tree.root][2]  # a head is in the middle
        role = place[0] if place else f"{'left' if side > 0 else 'right'} arm" if aside else "head"
        roles.update((b, role) for b in tree.bodies if limb in tree.chain(int(model.body_weldid[b])))
    legs = {name: f"{word} leg" for word, foot in sides.items() for name in foot.leg_joints}
    return {
        j: legs.get(name_of(model, OBJ.mjOBJ_JOINT, j), roles.get(int(model.jnt_bodyid[j]), "waist"))
        for j in range(model.njnt)
        if int(model.jnt_bodyid[j]) in tree.bodies and model.jnt_type[j] != JNT.mjJNT_FREE
    }
