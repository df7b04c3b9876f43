"""A description proposed for a model that nobody has marked: base, legs, soles and a bent-knee stand.

Everything is read at one reference pose, where the robot stands upright: `qpos0`, or a keyframe where that shows no
feet.
"""

from __future__ import annotations

import json
import os
from dataclasses import dataclass, field
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import mujoco
import numpy as np

from . import _core
from ._core import Foot, RobotDescription
from .description import description_to_dict, inspect_robot, joint_torque_limits
from .errors import Error, InputError, ModelError

__all__ = ["Proposal", "is_marked", "propose", "write_description"]

BENT = 0.935  # hip to ankle at the stand, as a share of the straight leg: knees at about 0.73 rad
LOW = 0.05  # of the robot's height: what is this near to the ground stands on it
PLANE = 0.012  # of the foot's extent: points this near to the lowest one lie on the sole
LONG_ENOUGH = 0.75  # of the largest inscribed area: the sole is the longest rectangle that has it
POINT_LENGTH, POINT_WIDTH = 0.10, 0.04  # of the leg: a smaller sole is a point foot
ARM_OUT = 0.3  # of a lowered arm from the vertical [rad]
HELP = "; add box sites left_sole and right_sole and a keyframe stand, or pass a robot.json"

UP = np.array([0.0, 0.0, 1.0])
OBJ = mujoco.mjtObj


def _numbers(kinds: Any) -> Any:
    """The members of one of MuJoCo's enums as plain integers: NumPy's do not always compare with the enum's own."""
    names = [name for name in dir(kinds) if name.startswith("mj")]
    return SimpleNamespace(**{name: int(getattr(kinds, name)) for name in names})


GEOM, JNT, EQ, TRN = (_numbers(kinds) for kinds in (mujoco.mjtGeom, mujoco.mjtJoint, mujoco.mjtEq, mujoco.mjtTrn))
WRAP = _numbers(mujoco.mjtWrap)


@dataclass(frozen=True)
class Proposal:
    """A description and how far to trust it.

    Fields: description; remarks, one line each, of what is unsure or unusual; table, plain values: what `inspect_robot`
    gives, thigh_m, shank_m, leg_share (hip to ankle at the stand, of the straight leg), speed_limit_mps (None where the
    controller refuses the robot: a remark says why), remarks.
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
        ModelError: no robot that could walk was found; one line that says why.

    Usage: `proposal = zmpwalk.proposal.propose(mujoco.MjModel.from_xml_path("bare.xml")); print(proposal.remarks)`
    """
    if is_marked(model):
        description, remarks = _core.describe(model), []
        left, right = description.left, description.right
        _refuse_unknown_features(
            _Tree(model, _id(model, OBJ.mjOBJ_BODY, left.body)), left.leg_joints + right.leg_joints
        )
    else:
        robot = _find_robot(model)
        description, remarks = _describe(robot), robot.remarks
        description.check(model)
    return appraise(model, description, remarks)


def appraise(model: mujoco.MjModel, description: RobotDescription, remarks: list[str] | None = None) -> Proposal:
    """A description that exists, with the table and remarks that `propose` gives.

    Usage: `appraise(*zmpwalk.load_robot("mahru")).remarks`
    """
    remarks = list(remarks or []) + _remarks(model, description)
    table = inspect_robot(model, description)
    try:
        still = _core.VelocityProfile([0.0], [[0.0, 0.0, 0.0]], "hold")
        controller = _core.WalkingController(model, description, settings=_core.WalkSettings(), profile=still)
        table["speed_limit_mps"] = float(controller.speed_limit)
    except Error as error:
        table["speed_limit_mps"] = None
        remarks.append(f"the walking controller refuses it: {error}")
    data = mujoco.MjData(model)
    description.place(model, data)
    table["thigh_m"], table["shank_m"], table["leg_share"] = _leg_geometry(model, data, description.left)
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


# --- the tree of a robot


class _Tree:
    """The kinematic tree that a body hangs in; a link is a body with joints, and what is welded to it."""

    def __init__(self, model: mujoco.MjModel, body: int):
        self.model, self.root = model, int(model.body_rootid[body])
        self.bodies = [b for b in range(1, model.nbody) if model.body_rootid[b] == self.root]
        self.links = sorted({int(model.body_weldid[b]) for b in self.bodies})

    def chain(self, link: int) -> list[int]:
        """Links from `link` up to the root, itself first."""
        links = []
        while link > 0:
            links.append(link)
            link = int(self.model.body_weldid[self.model.body_parentid[link]])
        return links

    def joints(self, link: int, stop: list[int]) -> list[int]:
        """Joints from the first link outside `stop` down to `link`."""
        links = [one for one in self.chain(link) if one not in stop]
        return [int(self.model.body_jntadr[one]) + k for one in links[::-1] for k in range(self.model.body_jntnum[one])]

    def under(self, link: int) -> list[int]:
        """Bodies that move with `link`."""
        return [b for b in self.bodies if link in self.chain(int(self.model.body_weldid[b]))]


@dataclass
class _Side:
    """A foot as it is found: its link, its leg's joint numbers, and the sole in the foot body's frame."""

    link: int
    joints: list[int]
    corners: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))  # on the sole, in the body [m]
    up: np.ndarray = field(default_factory=lambda: UP)
    pos: np.ndarray = field(default_factory=lambda: np.zeros(3))
    R: np.ndarray = field(default_factory=lambda: np.eye(3))  # columns: forward, left, up in the body
    length: float = 0.0
    width: float = 0.0


@dataclass
class _Found:
    """The robot in the model: the tree, data at the reference pose, left and right, directions in the world."""

    tree: _Tree
    data: mujoco.MjData
    sides: list[_Side]
    remarks: list[str]
    forward: np.ndarray = field(default_factory=lambda: np.array([1.0, 0.0, 0.0]))
    left: np.ndarray = field(default_factory=lambda: np.array([0.0, 1.0, 0.0]))


def _name(model: mujoco.MjModel, kind: Any, index: int) -> str:
    return mujoco.mj_id2name(model, kind, int(index)) or ""


def _id(model: mujoco.MjModel, kind: Any, name: str) -> int:
    return int(mujoco.mj_name2id(model, kind, name))


def _body(model: mujoco.MjModel, body: int) -> str:
    return f"body '{_name(model, OBJ.mjOBJ_BODY, body) or body}'"


def _find_robot(model: mujoco.MjModel) -> _Found:
    """The robot at `qpos0`, or at the first keyframe that shows one."""
    roots = [int(model.jnt_bodyid[j]) for j in range(model.njnt) if model.jnt_type[j] == JNT.mjJNT_FREE]
    if not roots:
        fixed = [b for b in range(1, model.nbody) if model.body_parentid[b] == 0]
        what = _body(model, max(fixed, key=lambda b: model.body_subtreemass[b])) + " is" if fixed else "everything is"
        raise ModelError(
            f"fixed base: the model has no free joint, {what} fixed to the world; a walking robot has a floating base "
            f'(<freejoint name="root"/>) and two legs with soles'
        )
    refused: list[tuple[tuple[int, float], ModelError]] = []
    for k, pose in enumerate([model.qpos0, *model.key_qpos]):
        data = mujoco.MjData(model)
        data.qpos[:] = pose
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        found = []
        for root in roots:
            tree = _Tree(model, root)
            try:
                found.append(_find_legs(tree, data))
            except ModelError as error:  # most worth telling: the tree with the most joints, at the first pose
                refused.append(((-len(tree.links), len(refused)), error))
        if len(found) > 1:
            names = ", ".join(_body(model, one.tree.root) for one in found)
            raise ModelError(f"the model has {len(found)} robots with two legs ({names}); pass a robot.json for one")
        if found:
            if k > 0:
                found[0].remarks.append("the feet were found at a keyframe, not at the zero pose")
            return found[0]
    raise min(refused, key=lambda pair: pair[0])[1]


def _find_legs(tree: _Tree, data: mujoco.MjData) -> _Found:
    model, geoms = tree.model, _touching_geoms(tree.model)
    lows = {}
    for link in tree.links:
        mine = [g for b in tree.bodies if model.body_weldid[b] == link for g in geoms.get(b, [])]
        if mine:
            lows[link] = min(_support_points(model, data, g, UP)[:, 2].min() for g in mine)
    if not lows:
        raise ModelError(
            f"{_body(model, tree.root)} and what hangs from it touch nothing: no collision geom makes a sole"
        )
    ground = min(lows.values())
    height = max(data.xpos[b][2] for b in tree.bodies) - ground
    low = [link for link in lows if lows[link] <= ground + LOW * height]
    tops = sorted({[one for one in tree.chain(link) if one in low][-1] for link in low})
    for top in tops:
        _refuse_wheel(
            tree, data, min((link for link in low if top in tree.chain(link)), key=lambda link: lows[link]), geoms
        )
    names = ", ".join(_body(model, top) for top in tops)
    if tree.root in tops:
        raise ModelError(f"no legs: {_body(model, tree.root)} lies on the ground itself, without legs and soles{HELP}")
    if len(tops) == 1:
        raise ModelError(f"one leg: only {names} reaches the ground; walking takes two feet with soles{HELP}")
    if len(tops) > 2:
        raise ModelError(f"{len(tops)} links reach the ground ({names}); zmpwalk walks on two feet with soles{HELP}")
    trunk = [link for link in tree.chain(tops[0]) if link in tree.chain(tops[1])]
    _refuse_joints(model, [j for top in tops for j in tree.joints(top, trunk)])
    sides = []
    for top in tops:
        lowest = min(lows[link] for link in low if top in tree.chain(link))
        down = [link for link in low if top in tree.chain(link) and lows[link] <= lowest + 0.2 * LOW * height]
        sides.append(_leg(tree, data, down, trunk, geoms))
    for side in sides:
        if len(side.joints) != 6:
            raise ModelError(
                f"the leg that ends at {_body(model, side.link)} has {len(side.joints)} joints "
                f"({_joint_names(model, side.joints)}); placing a flat foot anywhere takes 6: hip 3, knee 1, ankle 2"
            )
    robot = _Found(tree, data, sides, [])
    _refuse_unknown_features(tree, [_name(model, OBJ.mjOBJ_JOINT, j) for side in sides for j in side.joints])
    _orient(robot)
    for side in robot.sides:
        _fit_sole(robot, side)
    _refuse_legs(robot)
    return robot


def _leg(tree: _Tree, data: mujoco.MjData, low: list[int], trunk: list[int], geoms: dict) -> _Side:
    """The foot is the highest low link; one below it only where the sixth joint comes there, and most of the sole."""
    options = []
    for link in low:
        side = _Side(link, tree.joints(link, trunk))
        mine = [g for b in tree.under(link) for g in geoms.get(b, [])]
        side.corners, side.up, area = _sole_points(tree.model, data, link, mine)
        options.append((side, area))
    first = min(options, key=lambda option: len(option[0].joints))
    later = [one for one in options if len(one[0].joints) == 6 and one[1] >= 0.5 * first[1]]
    return first[0] if len(first[0].joints) >= 6 or not later else later[0][0]


def _joint_names(model: mujoco.MjModel, joints: list[int]) -> str:
    return ", ".join(_name(model, OBJ.mjOBJ_JOINT, j) or f"joint {j}" for j in joints)


# --- what cannot walk


def _refuse_wheel(tree: _Tree, data: mujoco.MjData, link: int, geoms: dict) -> None:
    """A round geom that its own unlimited joint spins about a level axis through its centre."""
    model = tree.model
    j = int(model.body_jntadr[link] + model.body_jntnum[link] - 1)
    if model.body_jntnum[link] == 0 or model.jnt_type[j] != JNT.mjJNT_HINGE or model.jnt_limited[j]:
        return
    for g in (g for b in tree.bodies if model.body_weldid[b] == link for g in geoms.get(b, [])):
        turning = model.geom_type[g] == GEOM.mjGEOM_SPHERE or (
            model.geom_type[g] in (GEOM.mjGEOM_CYLINDER, GEOM.mjGEOM_ELLIPSOID)
            and abs(data.geom_xmat[g].reshape(3, 3)[:, 2] @ data.xaxis[j]) > 0.98
        )
        offset = np.linalg.norm(np.cross(data.geom_xpos[g] - data.xanchor[j], data.xaxis[j]))
        if turning and abs(data.xaxis[j][2]) < 0.3 and offset < 0.1 * model.geom_size[g, 0]:
            raise ModelError(f"wheels: {_body(model, link)} rolls on the ground; zmpwalk walks on two flat feet")


def _refuse_joints(model: mujoco.MjModel, joints: list[int]) -> None:
    for j in joints:
        if model.jnt_type[j] != JNT.mjJNT_HINGE:
            kind = {JNT.mjJNT_BALL: "ball", JNT.mjJNT_SLIDE: "slide"}.get(int(model.jnt_type[j]), "free")
            raise ModelError(
                f"leg joint '{_name(model, OBJ.mjOBJ_JOINT, j) or j}' is a {kind} joint; a leg is six hinges "
                "(write a ball joint as three)"
            )


def _refuse_unknown_features(tree: _Tree, leg_joints: list[str]) -> None:
    """Loops, ties to the world and tendons that drive legs: the controller does not model them."""
    model, joints = tree.model, [_id(tree.model, OBJ.mjOBJ_JOINT, name) for name in leg_joints if name]
    active = model.eq_active0 if hasattr(model, "eq_active0") else model.eq_active
    for e in range(model.neq):
        label = _name(model, OBJ.mjOBJ_EQUALITY, e) or e
        kind, first, second = int(model.eq_type[e]), int(model.eq_obj1id[e]), int(model.eq_obj2id[e])
        if not active[e]:
            continue
        if kind in (EQ.mjEQ_CONNECT, EQ.mjEQ_WELD):
            if hasattr(model, "eq_objtype") and model.eq_objtype[e] == int(OBJ.mjOBJ_SITE):
                first, second = int(model.site_bodyid[first]), int(model.site_bodyid[second])
            inside = [b for b in (first, second) if b in tree.bodies]
            if len(inside) == 2:
                raise ModelError(
                    f"closed loop: equality '{label}' ties {_body(model, first)} to {_body(model, second)}; "
                    "zmpwalk needs a tree of joints"
                )
            if inside:
                raise ModelError(
                    f"equality '{label}' ties {_body(model, inside[0])} to what is not the robot; remove it to walk"
                )
        elif kind == EQ.mjEQ_JOINT and {first, second} & set(joints):
            tied = [j for j in (first, second) if j in joints]
            raise ModelError(
                f"equality '{label}' couples leg joint {_joint_names(model, tied[:1])}; six free hinges are needed"
            )
    for a in range(model.nu):
        if model.actuator_trntype[a] != TRN.mjTRN_TENDON:
            continue
        pulled = [j for j in _tendon_joints(model, int(model.actuator_trnid[a, 0])) if j in joints]
        if pulled:
            raise ModelError(
                f"actuator '{_name(model, OBJ.mjOBJ_ACTUATOR, a) or a}' drives leg joint "
                f"'{_joint_names(model, pulled[:1])}' through a tendon; each leg joint needs a motor of its own"
            )
    for j in joints:
        if j not in joint_torque_limits(model):
            raise ModelError(
                f"leg joint '{_joint_names(model, [j])}' has no actuator; each leg joint needs a motor "
                f'(<motor joint="{_joint_names(model, [j])}" ctrlrange="-tau tau"/>)'
            )


def _tendon_joints(model: mujoco.MjModel, tendon: int) -> list[int]:
    """Joints that a tendon pulls: those of a fixed one, those between the sites of a spatial one."""
    wraps = range(int(model.tendon_adr[tendon]), int(model.tendon_adr[tendon] + model.tendon_num[tendon]))
    joints, bodies = [], []
    for w in wraps:
        if model.wrap_type[w] == WRAP.mjWRAP_JOINT:
            joints.append(int(model.wrap_objid[w]))
        elif model.wrap_type[w] == WRAP.mjWRAP_SITE:
            bodies.append(int(model.site_bodyid[model.wrap_objid[w]]))
    chains = []
    for body in bodies:
        chain = []
        while body > 0:
            chain.append(body)
            body = int(model.body_parentid[body])
        chains.append(set(chain))
    moved = set().union(*chains) - set.intersection(*chains) if chains else set()
    return joints + [int(j) for j in range(model.njnt) if model.jnt_bodyid[j] in moved]


def _refuse_legs(robot: _Found) -> None:
    """Point feet, an unknown order of joints, ankles that cannot roll."""
    model, data = robot.tree.model, robot.data
    for side in robot.sides:
        knee = side.joints[3]
        leg = np.linalg.norm(data.xanchor[knee] - data.xanchor[side.joints[0]])
        leg += np.linalg.norm(data.xanchor[side.joints[5]] - data.xanchor[knee])
        if side.length < POINT_LENGTH * leg or side.width < POINT_WIDTH * leg:
            raise ModelError(
                f"point foot: {_body(model, side.link)} meets the ground over {side.length:.3f} x {side.width:.3f} m, "
                f"too small a sole for a leg of {leg:.2f} m, which takes at least "
                f"{POINT_LENGTH * leg:.3f} x {POINT_WIDTH * leg:.3f} m"
            )
        pitch = [abs(data.xaxis[j] @ robot.left) > 0.7 for j in side.joints]
        roll = [abs(data.xaxis[j] @ robot.forward) > 0.7 for j in side.joints]
        names = _joint_names(model, side.joints)
        if not (pitch[3] and any(pitch[:3])):
            raise ModelError(f"the leg {names} is not hip 3 joints, knee, ankle 2: the fourth must bend the knee")
        if not any(pitch[4:]) or not any(roll[4:]):
            missing = "pitch" if not any(pitch[4:]) else "roll"
            raise ModelError(
                f"the leg {names} has no ankle {missing}: the last two joints must pitch and roll the foot"
            )


# --- soles


def _touching_geoms(model: mujoco.MjModel) -> dict[int, list[int]]:
    """Geoms that can touch the ground, by body: what is fixed to the world is ground, else MuJoCo's default geom."""
    fixed = [g for g in range(model.ngeom) if model.body_weldid[model.geom_bodyid[g]] == 0]
    masks = {(int(model.geom_contype[g]), int(model.geom_conaffinity[g])) for g in fixed} - {(0, 0)}
    masks = masks or {(1, 1)}
    paired = {int(g) for g in np.concatenate([model.pair_geom1, model.pair_geom2])} if model.npair else set()
    geoms: dict[int, list[int]] = {}
    for g in range(model.ngeom):
        contype, conaffinity = int(model.geom_contype[g]), int(model.geom_conaffinity[g])
        if g not in fixed and (g in paired or any(contype & a or c & conaffinity for c, a in masks)):
            geoms.setdefault(int(model.geom_bodyid[g]), []).append(g)
    return geoms


def _support_points(model: mujoco.MjModel, data: mujoco.MjData, g: int, up: np.ndarray) -> np.ndarray:
    """Points (n, 3) [m, world] of a geom that could rest on a plane with normal `up`."""
    p, R, size = data.geom_xpos[g], data.geom_xmat[g].reshape(3, 3), model.geom_size[g]
    down, kind = -R.T @ up, int(model.geom_type[g])
    if kind == GEOM.mjGEOM_MESH:
        mesh = int(model.geom_dataid[g])
        first = int(model.mesh_vertadr[mesh])
        points = np.asarray(model.mesh_vert[first : first + int(model.mesh_vertnum[mesh])], float)
    elif kind == GEOM.mjGEOM_BOX:
        points = size * np.array([[i, j, k] for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)])
    elif kind == GEOM.mjGEOM_CAPSULE:
        points = np.array([[0, 0, -size[1]], [0, 0, size[1]]]) + size[0] * down
    elif kind == GEOM.mjGEOM_CYLINDER:
        across = down[:2] / max(np.linalg.norm(down[:2]), 1e-12)
        angles = np.linspace(0, 2 * np.pi, 48, endpoint=False) if abs(down[2]) > 0.999 else [np.arctan2(*across[::-1])]
        points = np.array([[size[0] * np.cos(a), size[0] * np.sin(a), z] for a in angles for z in (-size[1], size[1])])
    elif kind == GEOM.mjGEOM_ELLIPSOID:
        points = (size**2 * down / np.linalg.norm(size * down))[None]
    else:  # a sphere; anything else counts as one
        points = (size[0] * down)[None]
    return p + points @ R.T


def _sole_points(
    model: mujoco.MjModel, data: mujoco.MjData, link: int, geoms: list[int]
) -> tuple[np.ndarray, np.ndarray, float]:
    """Points on the sole's plane and its normal, in the body's frame, and the area they span [m^2].

    The plane is level at the reference pose; or square to the body's own axis that is nearest to the vertical, where
    more of the foot lies on that.
    """
    p, R = data.xpos[link], data.xmat[link].reshape(3, 3)
    axis = np.sign(R[2, np.argmax(abs(R[2]))]) * np.eye(3)[np.argmax(abs(R[2]))]
    best: tuple[np.ndarray, np.ndarray, float] = (np.zeros((0, 3)), axis, -1.0)
    for up in (axis, R.T @ UP):
        points = np.concatenate([_support_points(model, data, g, R @ up) for g in geoms]) if geoms else np.zeros((0, 3))
        points = (points - p) @ R
        if not len(points):
            return points, up, 0.0
        heights = points @ up
        extent = np.linalg.norm(np.ptp(points - np.outer(heights, up), axis=0))
        points = points[heights <= heights.min() + PLANE * extent]
        area = _area(_hull(points @ _across(up)))
        if area > 1.02 * best[2]:  # the body's own axis unless the other is better
            best = points, up, area
    return best


def _across(up: np.ndarray) -> np.ndarray:
    """Two directions (3, 2) square to `up`."""
    x = np.eye(3)[np.argmin(abs(up))]
    x = x - up * (x @ up)
    x /= np.linalg.norm(x)
    return np.stack([x, np.cross(up, x)], axis=1)


def _hull(points: np.ndarray) -> np.ndarray:
    """Convex hull (n, 2) of points in the plane, counter-clockwise."""
    ordered = sorted(set(map(tuple, np.round(points, 9))))
    if len(ordered) < 3:
        return np.array(ordered, float).reshape(-1, 2)

    def half(line: list) -> list:
        chain: list = []
        for p in line:
            while len(chain) > 1 and np.linalg.det([np.subtract(chain[-1], chain[-2]), np.subtract(p, chain[-1])]) <= 0:
                chain.pop()
            chain.append(p)
        return chain[:-1]

    return np.array(half(ordered) + half(ordered[::-1]), float)


def _area(hull: np.ndarray) -> float:
    if len(hull) < 3:
        return 0.0
    x, y = hull.T
    return 0.5 * abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1)))


def inscribed_rectangle(points: np.ndarray) -> tuple[float, float, float, float]:
    """The sole's rectangle inside the convex hull of its points.

    Of all rectangles with sides along x and y, the longest along x that has at least `LONG_ENOUGH` of the largest area:
    length is what walking ahead needs.

    Args:
        points: (n, 2) [m], x forward, y left.

    Returns:
        x from, x to, y from, y to [m]; all of no extent where the points span no area.

    Usage: `inscribed_rectangle(corners)`
    """
    hull = _hull(points)
    if _area(hull) < 1e-9:
        x, y = points.mean(axis=0) if len(points) else (0.0, 0.0)
        return x, x, y, y
    x = np.unique(np.concatenate([hull[:, 0], np.linspace(hull[:, 0].min(), hull[:, 0].max(), 121)]))
    lower, upper = np.full(len(x), np.inf), np.full(len(x), -np.inf)
    for a, b in zip(hull, np.roll(hull, -1, axis=0)):
        inside = (x >= min(a[0], b[0]) - 1e-12) & (x <= max(a[0], b[0]) + 1e-12)
        ends = (a[1], b[1]) if abs(b[0] - a[0]) < 1e-12 else ()
        for y in ends or (a[1] + (b[1] - a[1]) * (x[inside] - a[0]) / (b[0] - a[0]),):
            lower[inside], upper[inside] = np.minimum(lower[inside], y), np.maximum(upper[inside], y)
    widths = np.minimum(upper[:, None], upper) - np.maximum(lower[:, None], lower)
    lengths = x[None, :] - x[:, None]
    areas = np.where((lengths > 0) & (widths > 0), lengths * widths, 0.0)
    enough = areas >= LONG_ENOUGH * areas.max()
    i, j = np.unravel_index(np.argmax(np.where(enough, lengths + 1e-6 * widths, -1.0)), areas.shape)
    return x[i], x[j], max(lower[i], lower[j]), min(upper[i], upper[j])


def _fit_sole(robot: _Found, side: _Side) -> None:
    """The sole's frame and rectangle in the foot's body: x is the robot's forward, or the body's axis next to it."""
    R_WB = robot.data.xmat[side.link].reshape(3, 3)
    ahead = R_WB.T @ robot.forward
    axis = np.sign(ahead[np.argmax(abs(ahead))]) * np.eye(3)[np.argmax(abs(ahead))]
    if axis @ ahead > np.cos(0.26) and abs(axis @ side.up) < 0.05:  # toes may point out by 15 degrees
        ahead = axis
    ahead = ahead - side.up * (ahead @ side.up)
    ahead /= np.linalg.norm(ahead)
    side.R = np.stack([ahead, np.cross(side.up, ahead), side.up], axis=1)
    if not len(side.corners):
        return
    points = side.corners @ side.R
    x0, x1, y0, y1 = inscribed_rectangle(points[:, :2])
    side.length, side.width = float(x1 - x0), float(y1 - y0)
    side.pos = side.R @ np.array([(x0 + x1) / 2, (y0 + y1) / 2, points[:, 2].min()])


# --- directions


def _orient(robot: _Found) -> None:
    """Forward and left in the world, and which foot is the left one.

    Left is across the hips. Which way is forward is a vote: toes are longer than heels, knees bend backwards, the
    base's x axis, names.
    """
    model, data, (a, b) = robot.tree.model, robot.data, robot.sides
    across = np.mean([data.xanchor[i] - data.xanchor[j] for i, j in zip(a.joints, b.joints)], axis=0) * [1, 1, 0]
    if np.linalg.norm(across) < 1e-4:
        raise ModelError("the two legs stand in one place: no left and right foot can be told apart" + HELP)
    left = across / np.linalg.norm(across)  # if a is left
    R_base = data.xmat[robot.tree.root].reshape(3, 3)
    near = R_base[:, np.argmax(abs(R_base.T @ left))]
    if abs(near @ left) > np.cos(0.17) and abs(near[2]) < 1e-3:
        left = near * np.sign(near @ left)
    forward, votes = np.cross(left, UP), {}
    toes = []
    for side in (a, b):
        if len(side.corners):
            ankle = np.mean([data.xanchor[j] for j in side.joints[4:]], axis=0)
            ahead = (data.xpos[side.link] + side.corners @ data.xmat[side.link].reshape(3, 3).T - ankle) @ forward
            toes.append((ahead.max() + ahead.min()) / max(np.ptp(ahead), 1e-6))
    votes["toes"] = float(np.clip(5 * np.mean(toes or [0.0]), -1, 1))
    knees = [
        np.sign(data.xaxis[s.joints[3]] @ left) * np.sign(np.round(model.jnt_range[s.joints[3]].sum(), 3))
        for s in (a, b)
        if model.jnt_limited[s.joints[3]]
    ]
    votes["knees"] = 0.8 * float(np.mean(knees)) if knees else 0.0
    votes["the base's x axis"] = 0.6 * float(R_base[:, 0] @ forward)
    votes["names"] = float(_says_left(model, a) - _says_left(model, b)) / 2
    total = sum(votes.values())
    against = [word for word, vote in votes.items() if vote * total < -0.05]
    if against or abs(total) < 0.5:
        robot.remarks.append(
            f"which way is forward: {' and '.join(against) or 'nothing'} speaks {'against it' if against else 'for it'}"
        )
    if total < 0:
        left, forward, robot.sides = -left, -forward, [b, a]
    robot.left, robot.forward = left, forward


def _says_left(model: mujoco.MjModel, side: _Side) -> int:
    """+1 where the foot's and joints' names say left, -1 right."""
    words = [_name(model, OBJ.mjOBJ_BODY, side.link)] + [_name(model, OBJ.mjOBJ_JOINT, j) for j in side.joints]
    score = 0
    for word in (word.lower() for word in words):
        score += "left" in word or word.startswith(("l_", "l-")) or word.endswith("_l")
        score -= "right" in word or word.startswith(("r_", "r-")) or word.endswith("_r")
    return int(np.sign(score))


# --- the stand


def _describe(robot: _Found) -> RobotDescription:
    model, tree = robot.tree.model, robot.tree
    joints = [j for j in range(model.njnt) if model.jnt_bodyid[j] in tree.bodies]
    for kind, ids in ((OBJ.mjOBJ_JOINT, joints), (OBJ.mjOBJ_BODY, [side.link for side in robot.sides])):
        for i in ids:
            if not _name(model, kind, i):
                what = "joint" if kind == OBJ.mjOBJ_JOINT else "foot body"
                where = f" of {_body(model, model.jnt_bodyid[i])}" if what == "joint" else ""
                raise ModelError(f"{what} {i}{where} has no name; descriptions go by names, so give it one")
            if kind == OBJ.mjOBJ_JOINT and model.jnt_type[i] == JNT.mjJNT_BALL:
                raise ModelError(
                    f"joint '{_name(model, kind, i)}' is a ball joint; zmpwalk drives hinges and slides only"
                )
    _compare_sides(robot)
    _remark_soles(robot)
    data, keyframe = _stand(robot)
    root = joints[0]
    base = data.qpos[model.jnt_qposadr[root] :][:7]
    feet = [
        Foot(
            body=_name(model, OBJ.mjOBJ_BODY, side.link),
            sole_site="",
            sole_pos=side.pos,
            sole_quat=_quat(side.R),
            length=side.length,
            width=side.width,
            leg_joints=[_name(model, OBJ.mjOBJ_JOINT, j) for j in side.joints],
        )
        for side in robot.sides
    ]
    return RobotDescription(
        name=_name(model, OBJ.mjOBJ_BODY, tree.root) or "robot",
        root_joint=_name(model, OBJ.mjOBJ_JOINT, root),
        left=feet[0],
        right=feet[1],
        stand_joints={_name(model, OBJ.mjOBJ_JOINT, j): float(data.qpos[model.jnt_qposadr[j]]) for j in joints[1:]},
        stand_base_pos=base[:3].copy(),
        stand_base_quat=base[3:] / np.linalg.norm(base[3:]),
        stand_keyframe=keyframe,
    )


def _quat(R: np.ndarray) -> np.ndarray:
    quat = np.zeros(4)
    mujoco.mju_mat2Quat(quat, np.ascontiguousarray(R).ravel())
    return quat


def _compare_sides(robot: _Found) -> None:
    """One size for both soles where they differ by no more than a millimetre or two; a remark where by more."""
    a, b = robot.sides
    if max(abs(a.length - b.length), abs(a.width - b.width)) > 0.02 * a.length:
        robot.remarks.append(
            f"the soles differ: left {a.length:.3f} x {a.width:.3f} m, right {b.length:.3f} x {b.width:.3f} m"
        )


def _remark_soles(robot: _Found) -> None:
    model, data = robot.tree.model, robot.data
    for word, side in zip(("left", "right"), robot.sides):
        outline = _area(_hull((side.corners @ side.R)[:, :2]))
        if side.length * side.width < 0.93 * outline:
            share = 100 * side.length * side.width / outline
            robot.remarks.append(
                f"{word} sole: no rectangle; the one taken inside its outline has {share:.0f} % of the area"
            )
        tilt = np.arccos(np.clip(data.xmat[side.link].reshape(3, 3)[2] @ side.up, -1, 1))
        if tilt > 0.01:
            robot.remarks.append(f"{word} sole: not level at the reference pose, by {np.degrees(tilt):.1f} degrees")
        toes = [b for b in robot.tree.under(side.link) if model.body_weldid[b] != side.link]
        if toes:
            robot.remarks.append(
                f"{word} sole: {_body(model, toes[0])} moves against the foot and counts as part of the sole"
            )


def _stand(robot: _Found) -> tuple[mujoco.MjData, str]:
    """A pose with flat level soles on z = 0, knees bent, COM over their middle; and the keyframe that it is, or ''."""
    model = robot.tree.model
    keyframe = _best_keyframe(robot)
    data = mujoco.MjData(model)
    data.qpos[:] = robot.data.qpos if keyframe < 0 else model.key_qpos[keyframe]
    _forward(model, data)
    soles = [_sole(data, side) for side in robot.sides]
    if keyframe >= 0:
        label = _name(model, OBJ.mjOBJ_KEY, keyframe) or f"{keyframe}"
        gap = abs(soles[0][0][2] - soles[1][0][2])
        if max(np.arccos(np.clip(R[2, 2], -1, 1)) for _, R in soles) < 2e-3 and gap < 1e-3 * _straight(robot):
            _put_on_ground(robot, data)
            return data, _name(model, OBJ.mjOBJ_KEY, keyframe)
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
    _bend(robot, data, distance)
    _put_on_ground(robot, data)
    if keyframe < 0:
        robot.remarks.append("stand pose: by inverse kinematics, for no keyframe stands on flat soles")
    return data, ""


def _forward(model: mujoco.MjModel, data: mujoco.MjData) -> None:
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)


def _sole(data: mujoco.MjData, side: _Side) -> tuple[np.ndarray, np.ndarray]:
    """Centre and axes of a sole in the world."""
    R = data.xmat[side.link].reshape(3, 3)
    return data.xpos[side.link] + R @ side.pos, R @ side.R


def _pitch_joints(robot: _Found, side: _Side) -> tuple[int, int, int]:
    """Hip pitch, knee and ankle pitch."""
    turn = [abs(robot.data.xaxis[j] @ robot.left) for j in side.joints]
    return side.joints[int(np.argmax(turn[:3]))], side.joints[3], side.joints[4 + int(np.argmax(turn[4:]))]


def _sagittal(robot: _Found, data: mujoco.MjData, side: _Side) -> tuple[float, float, float]:
    """Hip to knee, knee to ankle, hip to ankle, seen from the side [m]."""
    hip, knee, ankle = (
        data.xanchor[j] - robot.left * (data.xanchor[j] @ robot.left) for j in _pitch_joints(robot, side)
    )
    return float(np.linalg.norm(knee - hip)), float(np.linalg.norm(ankle - knee)), float(np.linalg.norm(ankle - hip))


def _straight(robot: _Found) -> float:
    return sum(_sagittal(robot, robot.data, robot.sides[0])[:2])


def _best_keyframe(robot: _Found) -> int:
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
        named = 0.0 if _name(model, OBJ.mjOBJ_KEY, k) == "stand" else 1.0
        best = min(best, (named + abs(share - BENT), k))
    return best[1]


def _limits(robot: _Found) -> list[tuple[int, int, float, float]]:
    """Joint, place in qpos, range, of all limited joints with one degree of freedom."""
    model = robot.tree.model
    return [
        (j, int(model.jnt_qposadr[j]), *map(float, model.jnt_range[j]))
        for j in range(model.njnt)
        if model.jnt_bodyid[j] in robot.tree.bodies
        and model.jnt_limited[j]
        and model.jnt_type[j] in (JNT.mjJNT_SLIDE, JNT.mjJNT_HINGE)
    ]


def _outside(robot: _Found, data: mujoco.MjData) -> list[int]:
    return [j for j, at, low, high in _limits(robot) if not low - 1e-3 <= data.qpos[at] <= high + 1e-3]


def _clip(robot: _Found, data: mujoco.MjData) -> None:
    """Into the joints' ranges, a little inside; legs are bent later."""
    legs = [j for side in robot.sides for j in side.joints]
    outside = [j for j in _outside(robot, data) if j not in legs]
    if outside:
        names = _joint_names(robot.tree.model, outside[:4])
        robot.remarks.append(f"the zero pose is outside the range of {names}; moved inside at the stand")
    for j, at, low, high in _limits(robot):
        if j in outside:
            data.qpos[at] = np.clip(data.qpos[at], low + 0.02 * (high - low), high - 0.02 * (high - low))


def _lower_arms(robot: _Found, data: mujoco.MjData) -> None:
    """Arms that are held out, as in many zero poses, are let down by the one shoulder joint that does it best."""
    model, tree = robot.tree.model, robot.tree
    legs = {link for side in robot.sides for link in tree.chain(side.link)}
    shoulders = [
        b
        for b in tree.links
        if b not in legs and int(model.body_weldid[model.body_parentid[b]]) in legs | _spine(tree, legs)
    ]
    for shoulder in (b for b in shoulders if b not in _spine(tree, legs)):
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
            moved = _joint_names(model, [j for j in joints if best[1][j] != start[j]])
            robot.remarks.append(f"stand pose: the arm at {_body(model, shoulder)} is let down by {moved}")


def _spine(tree: _Tree, legs: set[int]) -> set[int]:
    """Links above the legs that carry more than an arm does: waist, torso."""
    model, spine = tree.model, {tree.root}
    total = model.body_subtreemass[tree.root]
    for link in tree.links:  # parents come first
        inside = int(model.body_weldid[model.body_parentid[link]]) in spine | legs
        if link not in legs and inside and model.body_subtreemass[link] > 0.2 * total:
            spine.add(link)
    return spine


def _bend(robot: _Found, data: mujoco.MjData, distance: float) -> None:
    """Legs bent to `BENT` of their length, soles level, `distance` apart, COM over their middle; the base stays.

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
            com = data.subtree_com[root].copy()
            error = 0.0
            for side, sign in zip(robot.sides, (1, -1)):
                centre = com - UP * height + sign * robot.left * distance / 2
                error = max(error, _reach(model, data, side, centre, axes))
            _forward(model, data)
            share = np.mean([_sagittal(robot, data, side) for side in robot.sides], axis=0)
            lift = BENT * (share[0] + share[1]) - share[2]
            height += lift
            off = np.linalg.norm(
                (data.subtree_com[root] - np.mean([_sole(data, side)[0] for side in robot.sides], axis=0))[:2]
            )
            if max(error, abs(lift), off) < 1e-7 * max(1.0, height):
                break
        if error < worst:
            worst, failure = error, data.qpos.copy()
        if error < 1e-5:
            if knees < 0:
                robot.remarks.append("stand pose: the knees bend backwards")
            return
    data.qpos[:] = failure
    stuck = [_name(model, OBJ.mjOBJ_JOINT, j) for s in robot.sides for j in s.joints if _at_limit(model, data, j)]
    raise ModelError(
        f"no stand with bent knees and flat soles {distance:.3f} m apart was found: "
        + (f"{', '.join(stuck)} is at the end of its range" if stuck else f"the feet stay {1000 * worst:.1f} mm off")
    )


def _at_limit(model: mujoco.MjModel, data: mujoco.MjData, j: int) -> bool:
    q = data.qpos[model.jnt_qposadr[j]]
    return bool(model.jnt_limited[j] and min(q - model.jnt_range[j][0], model.jnt_range[j][1] - q) < 1e-6)


def _keep_in_range(model: mujoco.MjModel, data: mujoco.MjData, side: _Side) -> None:
    for j in side.joints:
        if model.jnt_limited[j]:
            at = model.jnt_qposadr[j]
            data.qpos[at] = np.clip(data.qpos[at], *model.jnt_range[j])


def _reach(model: mujoco.MjModel, data: mujoco.MjData, side: _Side, centre: np.ndarray, axes: np.ndarray) -> float:
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


def _put_on_ground(robot: _Found, data: mujoco.MjData) -> None:
    """The middle of the soles goes to z = 0, below where the base is at `qpos0`."""
    model = robot.tree.model
    root = int(model.jnt_qposadr[model.body_jntadr[robot.tree.root]])
    _forward(model, data)
    middle = np.mean([_sole(data, side)[0] for side in robot.sides], axis=0)
    data.qpos[root : root + 2] += model.qpos0[root : root + 2] - middle[:2]
    data.qpos[root + 2] -= middle[2]
    _forward(model, data)


# --- remarks on any robot


def _leg_geometry(model: mujoco.MjModel, data: mujoco.MjData, foot: Foot) -> tuple[float, float, float]:
    """Hip to knee, knee to ankle [m], and hip to ankle as a share of both, from the side as the controller sees it."""
    _, axes = _sole_of(model, data, foot)
    joints = [_id(model, OBJ.mjOBJ_JOINT, name) for name in foot.leg_joints]
    turn = [abs(data.xaxis[j] @ axes[:, 1]) for j in joints]
    three = joints[int(np.argmax(turn[:3]))], joints[3], joints[4 + int(np.argmax(turn[4:]))]
    hip, knee, ankle = (data.xanchor[j] - axes[:, 1] * (data.xanchor[j] @ axes[:, 1]) for j in three)
    thigh, shank = np.linalg.norm(knee - hip), np.linalg.norm(ankle - knee)
    return float(thigh), float(shank), float(np.linalg.norm(ankle - hip) / max(thigh + shank, 1e-9))


def _sole_of(model: mujoco.MjModel, data: mujoco.MjData, foot: Foot) -> tuple[np.ndarray, np.ndarray]:
    """Centre and axes of a description's sole in the world."""
    body, R_sole = _id(model, OBJ.mjOBJ_BODY, foot.body), np.zeros(9)
    mujoco.mju_quat2Mat(R_sole, np.asarray(foot.sole_quat, float))
    R = data.xmat[body].reshape(3, 3)
    return data.xpos[body] + R @ np.asarray(foot.sole_pos), R @ R_sole.reshape(3, 3)


def _remarks(model: mujoco.MjModel, description: RobotDescription) -> list[str]:
    """What may keep a robot from walking, or surprise: torque, floor, contacts with itself, springs of tendons."""
    remarks = []
    data = mujoco.MjData(model)
    description.place(model, data)
    root = int(model.jnt_bodyid[_id(model, OBJ.mjOBJ_JOINT, description.root_joint)])
    tree = _Tree(model, root)
    limit = joint_torque_limits(model)
    names = list(description.left.leg_joints) + list(description.right.leg_joints)
    legs = [_id(model, OBJ.mjOBJ_JOINT, name) for name in names]
    endless = [j for j in legs if not np.isfinite(limit.get(j, np.inf))]
    if endless:
        which = (
            "no leg joint" if len(endless) == len(legs) else f"not each leg joint ({_joint_names(model, endless[:3])})"
        )
        remarks.append(f"{which} has a torque limit: give the motors a ctrlrange")
    weight = float(model.body_subtreemass[root] * np.linalg.norm(model.opt.gravity))
    for side in (description.left, description.right):
        centre, axes = _sole_of(model, data, side)
        for name in side.leg_joints[3:]:
            j = _id(model, OBJ.mjOBJ_JOINT, name)
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
            pairs.add(" and ".join(_body(model, b) for b in sorted(bodies)))
    remarks += [f"at the stand {pair} touch" for pair in sorted(pairs)[:3]]
    for t in range(model.ntendon):
        joints = [j for j in _tendon_joints(model, t) if model.jnt_bodyid[j] in tree.bodies]
        if joints:
            label = _name(model, OBJ.mjOBJ_TENDON, t) or t
            remarks.append(f"tendon '{label}' pulls on {_joint_names(model, joints[:2])}; its force is not modelled")
    active = model.eq_active0 if hasattr(model, "eq_active0") else model.eq_active
    for e in range(model.neq):
        coupled = [j for j in (int(model.eq_obj1id[e]), int(model.eq_obj2id[e])) if j >= 0]
        if model.eq_type[e] == EQ.mjEQ_JOINT and active[e] and any(model.jnt_bodyid[j] in tree.bodies for j in coupled):
            label = _name(model, OBJ.mjOBJ_EQUALITY, e) or e
            remarks.append(f"equality '{label}' couples {_joint_names(model, coupled)}; its force is not modelled")
    return remarks
