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

from .. import _core
from .._core import Foot, RobotDescription
from ..description import Robot, description_to_dict, read_robot, renamed
from ..errors import Error, InputError, ModelError
from .legs import find_robot
from .remarks import find_remarks, remark_usual_walk
from .soles import remark_soles
from .stand import find_stand
from .table import inspect_robot
from .tree import GEOM, OBJ, Found, name_of

__all__ = ["Proposal", "appraise", "examine", "is_marked", "propose", "write_description"]


@dataclass(frozen=True)
class Proposal:
    """A description and how far to trust it.

    Fields: description; remarks, one line each, of what is unsure or unusual; table, plain values: what
    `table.inspect_robot` gives, zmp_bounds_m (left and right, each lower and upper about the sole's centre) and
    speed_limit_mps (both None where the controller refuses the robot: a remark says why), remarks.
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

    Usage: `proposal = zmpwalk.proposal.propose(mujoco.MjModel.from_xml_path("bare.xml")); print(proposal.remarks)`
    """
    if is_marked(model):
        description, remarks = _core.describe(model), []
    else:
        robot = find_robot(model)
        description, remarks = _describe(robot), robot.remarks
        description.check(model)
    return appraise(model, description, remarks)


def examine(robot: Robot) -> tuple[mujoco.MjModel, Proposal]:
    """What `load_robot` loads, with the table and remarks of `propose`.

    Args:
        robot: see `load_robot`.

    Raises:
        InputError, ModelError: as `load_robot`.

    Usage: `model, proposal = examine("bare.xml")`
    """
    model, description, name = read_robot(robot)
    if description is not None:
        description.check(model)
        return model, appraise(model, description)
    found = propose(model)
    table = {**found.table, "name": name or found.table["name"]}
    return model, Proposal(renamed(found.description, name), found.remarks, table)


def appraise(model: mujoco.MjModel, description: RobotDescription, remarks: list[str] | None = None) -> Proposal:
    """A description that exists, with the table and remarks that `propose` gives.

    Usage: `appraise(*zmpwalk.load_robot("mahru")).remarks`
    """
    remarks = list(remarks or []) + find_remarks(model, description)
    table = inspect_robot(model, description)
    try:
        still = _core.VelocityProfile([0.0], np.zeros((1, 3)), "hold")
        controller = _core.WalkingController(model, description, settings=_core.WalkSettings(), profile=still)
        table["speed_limit_mps"] = float(controller.speed_limit)
        bounds = {side: [b.tolist() for b in controller.zmp_bounds(side)] for side in ("left", "right")}
        table["zmp_bounds_m"] = bounds
        remarks += remark_usual_walk(model, description, controller)
    except Error as error:
        table["speed_limit_mps"] = table["zmp_bounds_m"] = None
        reasons = error.reasons if isinstance(error, ModelError) else (str(error),)
        remarks += [f"the walking controller refuses it: {reason}" for reason in reasons]
    table["remarks"] = remarks = list(dict.fromkeys(remarks))  # each once
    return Proposal(description, remarks, table)


def is_marked(model: mujoco.MjModel) -> bool:
    """The model has box sites `left_sole` and `right_sole` and a keyframe `stand`: nothing needs proposing.

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
    draft = path.with_name(f".{path.name}.draft")
    try:
        draft.write_text(json.dumps(content, indent=1, allow_nan=False) + "\n", encoding="utf-8")
        os.replace(draft, path)
    except OSError as error:
        raise InputError(f"{path}: cannot write there: {(error.strerror or str(error)).lower()}") from None
    return path


def _describe(robot: Found) -> RobotDescription:
    model, tree = robot.tree.model, robot.tree
    joints = [j for j in range(model.njnt) if model.jnt_bodyid[j] in tree.bodies]
    remark_soles(robot)
    data, keyframe = find_stand(robot)
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
