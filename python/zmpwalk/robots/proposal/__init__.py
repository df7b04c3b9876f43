"""A description proposed for a model that nobody has marked: base, legs, soles and a bent-knee stand.

Everything is read at one reference pose, where the robot stands upright: `qpos0`, or a keyframe where that shows no
feet. `legs` finds the robot, `soles` its soles, `stand` its pose; `refusals` and `remarks` say what is in the way.
"""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import mujoco
import numpy as np

from ... import _core
from ..._core import Foot, RobotDescription
from ...errors import Error, ModelError
from ...files import as_input_error, whole
from ..description import description_to_dict
from .legs import find_robot
from .remarks import find_remarks, remark_ranges, remark_room, remark_usual_walk, usual_speed
from .soles import remark_soles
from .stand import find_stand
from .table import inspect_robot
from .tree import GEOM, OBJ, Found, name_of

__all__ = ["Proposal", "appraise", "describe", "is_marked", "propose", "write_description"]


@dataclass(frozen=True)
class Proposal:
    """A description and how far to trust it.

    Fields: description; remarks, one line each, of what is unsure or unusual; table, plain values: what
    `table.inspect_robot` gives, zmp_bounds_m (left and right, each lower and upper about the sole's centre) and
    speed_limit_mps, speed_limits (all None where the controller refuses the robot: a remark says why), remarks.
    """

    description: RobotDescription
    remarks: list[str]
    table: dict[str, Any]


def propose(model: mujoco.MjModel) -> Proposal:
    """Find a robot in a model: its base, legs, soles and how it stands.

    Where the model carries box sites `left_sole` and `right_sole` and a keyframe `stand`, these are taken.

    Args:
        model: any compiled model; changed by nothing.

    Returns:
        The proposal; `description.check(model)` has passed.

    Raises:
        ModelError: no robot that could walk was found; its `reasons` say why, a line each.

    Usage: `proposal = zmpwalk.propose(mujoco.MjModel.from_xml_path("bare.xml")); print(proposal.remarks)`
    """
    return appraise(model, *_found(model))


def describe(model: mujoco.MjModel) -> RobotDescription:
    """The description of a robot that is found in its model.

    Args:
        model: carries box sites `left_sole` and `right_sole` (centre on the sole plane, x forward, y left, z up, half
            sizes those of the sole) and a keyframe `stand`, which are taken as they are. From any other model a
            description is proposed: `zmpwalk.propose` does the same and says what is unsure.

    Returns:
        Feet, legs, soles and start pose.

    Raises:
        ModelError: no robot that can walk was found; one line says why.

    Usage: `description = zmpwalk.describe(mujoco.MjModel.from_xml_path("robot.xml"))`
    """
    return _found(model)[0]


def _found(model: mujoco.MjModel) -> tuple[RobotDescription, list[str]]:
    """The description of the robot in a model, and what is unsure about it."""
    if is_marked(model):
        return _core.describe(model), []
    robot = find_robot(model)
    description = _describe(robot)
    description.check(model)
    return description, robot.remarks


def appraise(model: mujoco.MjModel, description: RobotDescription, remarks: list[str] | None = None) -> Proposal:
    """A description that exists, with the table and remarks that `propose` gives.

    Usage: `appraise(*zmpwalk.load_robot("mahru")).remarks`
    """
    remarks = list(remarks or []) + find_remarks(model, description)
    table = inspect_robot(model, description)
    remarks += remark_ranges(table["joints"])
    speed = usual_speed(model, table["com_height_m"])
    try:
        controller, refusal = _controller(model, description, speed), ""
    except Error as error:
        refusal = str(error)
    try:
        if refusal:  # perhaps only of a usual walk
            controller = _controller(model, description, 0.0)
        table["speed_limit_mps"] = float(controller.speed_limit)
        table["speed_limits"] = {
            way: {"most": most, "limit": limit} for way, (most, limit) in controller.speed_limits.items()
        }
        bounds = {side: [b.tolist() for b in controller.zmp_bounds(side)] for side in ("left", "right")}
        table["zmp_bounds_m"] = bounds
        remarks += remark_room(description.stand_ahead(model), bounds)
        remarks += remark_usual_walk(model, description, controller, speed, refusal)
    except Error as error:
        table["speed_limit_mps"] = table["speed_limits"] = table["zmp_bounds_m"] = None
        reasons = error.reasons if isinstance(error, ModelError) else (str(error),)
        remarks += [f"the walking controller refuses it: {reason}" for reason in reasons]
    table["remarks"] = remarks = list(dict.fromkeys(remarks))  # each once
    return Proposal(description, remarks, table)


def _controller(model: mujoco.MjModel, description: RobotDescription, speed: float) -> _core.WalkingController:
    """A controller for a walk that reaches `speed` [m/s] in 10 s."""
    ramp = _core.VelocityProfile([0.0, 10.0], np.array([[0.0, 0.0, 0.0], [speed, 0.0, 0.0]]), "linear")
    return _core.WalkingController(model, description, settings=_core.WalkSettings(), profile=ramp)


def is_marked(model: mujoco.MjModel) -> bool:
    """True where the model has box sites `left_sole` and `right_sole` and a keyframe `stand`, so that nothing has to
    be guessed.

    Usage: `is_marked(model) or propose(model).remarks`
    """
    sites = [mujoco.mj_name2id(model, OBJ.mjOBJ_SITE, name) for name in ("left_sole", "right_sole")]
    boxes = all(site >= 0 and model.site_type[site] == GEOM.mjGEOM_BOX for site in sites)
    return boxes and mujoco.mj_name2id(model, OBJ.mjOBJ_KEY, "stand") >= 0


def write_description(path: str | os.PathLike, model_file: str | os.PathLike, proposal: Proposal) -> Path:
    """Write a proposal as the `robot.json` that `load_robot` reads.

    Args:
        path: the file to write, replaced if it exists.
        model_file: the MJCF; written relative to the file's folder.

    Raises:
        InputError: the file cannot be written.

    Usage: `write_description("robot.json", "bare.xml", propose(model))`
    """
    path, table = Path(path), proposal.table
    plain = description_to_dict(proposal.description)
    content = {
        "name": plain.pop("name"),
        "model": Path(os.path.relpath(Path(model_file).resolve(), path.resolve().parent)).as_posix(),
        "mass_kg": table["mass_kg"],
        "root_body": table["base"]["body"],
        **plain,
        "com_height_m": table["com_height_m"],
        "remarks": proposal.remarks,
    }
    with as_input_error(path), whole(path) as draft:
        draft.write_text(json.dumps(content, indent=1, allow_nan=False) + "\n", encoding="utf-8")
    return path


def _describe(robot: Found) -> RobotDescription:
    remark_soles(robot)
    remarks = list(robot.remarks)
    description = _standing(robot)
    try:
        ahead = description.stand_ahead(robot.tree.model)
    except Error:  # the model's rules or the controller say what is wrong
        return description
    if ahead == 0.0 or description.stand_keyframe:
        return description
    robot.remarks[:] = remarks
    return _standing(robot, ahead)


def _standing(robot: Found, ahead: float = 0.0) -> RobotDescription:
    """The description of a robot whose COM stands `ahead` of the middle of its soles [m]."""
    model, tree = robot.tree.model, robot.tree
    joints = [j for j in range(model.njnt) if model.jnt_bodyid[j] in tree.bodies]
    data, keyframe = find_stand(robot, ahead)
    root = joints[0]
    base = data.qpos[model.jnt_qposadr[root] :][:7]
    feet = [
        Foot(
            body=name_of(model, OBJ.mjOBJ_BODY, side.link),
            sole_site="",
            sole_pos=side.pos,
            sole_quat=_quat(side.R),
            length=side.length,
            width=side.width,
            leg_joints=[name_of(model, OBJ.mjOBJ_JOINT, j) for j in side.joints],
        )
        for side in robot.sides
    ]
    return RobotDescription(
        name=name_of(model, OBJ.mjOBJ_BODY, tree.root) or "robot",
        root_joint=name_of(model, OBJ.mjOBJ_JOINT, root),
        left=feet[0],
        right=feet[1],
        stand_joints={name_of(model, OBJ.mjOBJ_JOINT, j): float(data.qpos[model.jnt_qposadr[j]]) for j in joints[1:]},
        stand_base_pos=base[:3].copy(),
        stand_base_quat=base[3:] / np.linalg.norm(base[3:]),
        stand_keyframe=keyframe,
    )


def _quat(R: np.ndarray) -> np.ndarray:
    quat = np.zeros(4)
    mujoco.mju_mat2Quat(quat, np.ascontiguousarray(R).ravel())
    return quat
