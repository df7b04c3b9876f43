"""Remarks on any description: what may keep the robot from walking, or surprise."""

from __future__ import annotations

import mujoco
import numpy as np

from .._core import RobotDescription
from ..description import joint_torque_limits, sole_pose
from .tree import EQ, GEOM, OBJ, Tree, body_label, find_id, joint_names, name_of, root_body, tendon_joints


def find_remarks(model: mujoco.MjModel, description: RobotDescription) -> list[str]:
    """What may keep a robot from walking, or surprise: torque, floor, contacts with itself, springs of tendons."""
    remarks = []
    data = mujoco.MjData(model)
    description.place(model, data)
    root = root_body(model, description)
    tree = Tree(model, root)
    limit = joint_torque_limits(model)
    names = list(description.left.leg_joints) + list(description.right.leg_joints)
    legs = [find_id(model, OBJ.mjOBJ_JOINT, name) for name in names]
    endless = [j for j in legs if not np.isfinite(limit.get(j, np.inf))]
    if endless:
        which = (
            "no leg joint" if len(endless) == len(legs) else f"not each leg joint ({joint_names(model, endless[:3])})"
        )
        remarks.append(f"{which} has a torque limit: give the motors a ctrlrange")
    weight = float(model.body_subtreemass[root] * np.linalg.norm(model.opt.gravity))
    for side in (description.left, description.right):
        centre, axes = sole_pose(model, data, side)
        for name in side.leg_joints[3:]:
            j = find_id(model, OBJ.mjOBJ_JOINT, name)
            turn = abs(data.xaxis[j] @ axes[:, 1])
            arm = abs((data.xanchor[j] - centre) @ axes[:, 0]) if turn > 0.7 else 0.0
            if limit.get(j, np.inf) < arm * weight:
                remarks.append(
                    f"{name} cannot hold the robot on one foot: limit {limit[j]:.1f} N m, need {arm * weight:.1f} N m"
                )
    fixed = [g for g in range(model.ngeom) if model.body_weldid[model.geom_bodyid[g]] == 0]
    if not any(model.geom_type[g] in (GEOM.mjGEOM_PLANE, GEOM.mjGEOM_HFIELD, GEOM.mjGEOM_BOX) for g in fixed):
        remarks.append(
            "the model has no floor (a plane, a box or a height field fixed to the world): nothing to walk on"
        )
    pairs = set()
    for i in range(data.ncon):
        bodies = [int(model.geom_bodyid[g]) for g in (data.contact[i].geom1, data.contact[i].geom2) if g >= 0]
        if len(bodies) == 2 and set(bodies) <= set(tree.bodies):
            pairs.add(" and ".join(body_label(model, b) for b in sorted(bodies)))
    remarks += [f"at the stand {pair} touch" for pair in sorted(pairs)[:3]]
    for t in range(model.ntendon):
        joints = [j for j in tendon_joints(model, t) if model.jnt_bodyid[j] in tree.bodies]
        if joints:
            label = name_of(model, OBJ.mjOBJ_TENDON, t) or t
            remarks.append(f"tendon '{label}' pulls on {joint_names(model, joints[:2])}; its force is not modelled")
    active = model.eq_active0 if hasattr(model, "eq_active0") else model.eq_active
    for e in range(model.neq):
        coupled = [j for j in (int(model.eq_obj1id[e]), int(model.eq_obj2id[e])) if j >= 0]
        if model.eq_type[e] == EQ.mjEQ_JOINT and active[e] and any(model.jnt_bodyid[j] in tree.bodies for j in coupled):
            label = name_of(model, OBJ.mjOBJ_EQUALITY, e) or e
            remarks.append(f"equality '{label}' couples {joint_names(model, coupled)}; its force is not modelled")
    return remarks
