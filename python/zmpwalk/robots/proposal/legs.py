"""Where a robot is in a model: base, two legs, feet, which foot is the left one and which way is forward."""

from __future__ import annotations

import mujoco
import numpy as np

from ... import _core
from ...errors import ModelError
from . import refusals
from .soles import fit_sole, sole_points, support_points, touching_geoms
from .tree import HELP, JNT, OBJ, UP, Found, Side, Tree, body_label, name_of

LOW = 0.05  # of the robot's height: what is this near to the ground stands on it


def find_robot(model: mujoco.MjModel) -> Found:
    """The robot at `qpos0`, or at the first keyframe that shows one."""
    roots = [int(model.jnt_bodyid[j]) for j in range(model.njnt) if model.jnt_type[j] == JNT.mjJNT_FREE]
    world = _core.model_reasons(model)
    if not roots:
        refusals.refuse(text for _, text in world)
    refused: list[tuple[tuple[int, float], ModelError]] = []
    for k, pose in enumerate([model.qpos0, *model.key_qpos]):
        data = mujoco.MjData(model)
        data.qpos[:] = pose
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        found = []
        for root in roots:
            tree = Tree(model, root)
            try:
                found.append(_find_legs(tree, data))
            except ModelError as error:  # most worth telling: the tree with the most joints, at the first pose
                refused.append(((-len(tree.links), len(refused)), error))
        if len(found) > 1:
            names = ", ".join(body_label(model, one.tree.root) for one in found)
            raise ModelError(f"the model has {len(found)} robots with two legs ({names}); pass a robot.json for one")
        if found:
            if k > 0:
                found[0].remarks.append("the feet were found at a keyframe, not at the zero pose")
            return found[0]
    refusals.refuse(text for rule, text in world if rule == "base")  # the robot is what hangs from the world
    raise min(refused, key=lambda pair: pair[0])[1]


def _find_legs(tree: Tree, data: mujoco.MjData) -> Found:
    model, geoms = tree.model, touching_geoms(tree.model)
    lows = {}
    for link in tree.links:
        mine = [g for b in tree.bodies if model.body_weldid[b] == link for g in geoms.get(b, [])]
        if mine:
            lows[link] = min(support_points(model, data, g, UP)[:, 2].min() for g in mine)
    if not lows:
        raise ModelError(
            f"{body_label(model, tree.root)} and what hangs from it touch nothing: no collision geom makes a sole"
        )
    ground = min(lows.values())
    height = max(data.xpos[b][2] for b in tree.bodies) - ground
    low = [link for link in lows if lows[link] <= ground + LOW * height]
    tops = sorted({[one for one in tree.chain(link) if one in low][-1] for link in low})
    for top in tops:
        lowest = min((link for link in low if top in tree.chain(link)), key=lambda link: lows[link])
        refusals.refuse(refusals.wheels(tree, data, lowest, geoms))
    names = ", ".join(body_label(model, top) for top in tops)
    if tree.root in tops:
        base = body_label(model, tree.root)
        raise ModelError(f"no legs: {base} lies on the ground itself, without legs and soles{HELP}")
    if len(tops) == 1:
        raise ModelError(f"one leg: only {names} reaches the ground; walking takes two feet with soles{HELP}")
    if len(tops) > 2:
        raise ModelError(f"{len(tops)} links reach the ground ({names}); zmpwalk walks on two feet with soles{HELP}")
    trunk = [link for link in tree.chain(tops[0]) if link in tree.chain(tops[1])]
    sides = []
    for top in tops:
        lowest = min(lows[link] for link in low if top in tree.chain(link))
        down = [link for link in low if top in tree.chain(link) and lows[link] <= lowest + 0.2 * LOW * height]
        sides.append(_leg(tree, data, down, trunk, geoms))
    robot = Found(tree, data, sides, [])
    reasons = refusals.of_robot(robot)
    if all(rule != "leg" for rule, _ in reasons):  # six hinges each: enough to tell left, right and forward
        _orient(robot)
        for side in robot.sides:
            fit_sole(robot, side)
        reasons = refusals.of_robot(robot, upright=True)
    refusals.refuse(text for _, text in reasons)
    return robot


def _leg(tree: Tree, data: mujoco.MjData, low: list[int], trunk: list[int], geoms: dict) -> Side:
    """Finds a leg. Its foot is the highest of the links near the ground; a link below it is taken only if the sixth
    joint is there, and most of the sole."""
    options = []
    for link in low:
        side = Side(link, tree.joints(link, trunk))
        mine = [g for b in tree.under(link) for g in geoms.get(b, [])]
        side.corners, side.up, area = sole_points(tree.model, data, link, mine)
        options.append((side, area))
    first = min(options, key=lambda option: len(option[0].joints))
    later = [one for one in options if len(one[0].joints) == 6 and one[1] >= 0.5 * first[1]]
    return first[0] if len(first[0].joints) >= 6 or not later else later[0][0]


def _orient(robot: Found) -> None:
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


def _says_left(model: mujoco.MjModel, side: Side) -> int:
    """+1 where the foot's and joints' names say left, -1 right."""
    words = [name_of(model, OBJ.mjOBJ_BODY, side.link)] + [name_of(model, OBJ.mjOBJ_JOINT, j) for j in side.joints]
    score = 0
    for word in (word.lower() for word in words):
        score += "left" in word or word.startswith(("l_", "l-")) or word.endswith("_l")
        score -= "right" in word or word.startswith(("r_", "r-")) or word.endswith("_r")
    return int(np.sign(score))
