"""What keeps a robot from walking, each a line: wheels, ball joints, loops, tendons, point feet, stiff ankles."""

from __future__ import annotations

from typing import Iterable, Iterator

import mujoco
import numpy as np

from ...errors import ModelError
from .tree import EQ, GEOM, JNT, OBJ, TRN, Found, Side, Tree, body_label, joint_names, name_of, tendon_joints

POINT_LENGTH, POINT_WIDTH = 0.10, 0.04  # of the leg: a smaller sole is a point foot


def refuse(reasons: Iterable[str]) -> None:
    """Nothing where there is no reason.

    Raises:
        ModelError: with all reasons.
    """
    reasons = list(reasons)
    if reasons:
        raise ModelError(*reasons)


def wheels(tree: Tree, data: mujoco.MjData, link: int, geoms: dict[int, list[int]]) -> Iterator[str]:
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
            yield f"wheels: {body_label(model, link)} rolls on the ground; zmpwalk walks on two flat feet"


def legs(model: mujoco.MjModel, sides: list[Side]) -> Iterator[str]:
    """Legs that are not six hinges."""
    for side in sides:
        for j in side.joints:
            if model.jnt_type[j] != JNT.mjJNT_HINGE:
                kind = {JNT.mjJNT_BALL: "ball", JNT.mjJNT_SLIDE: "slide"}.get(int(model.jnt_type[j]), "free")
                yield (
                    f"leg joint '{name_of(model, OBJ.mjOBJ_JOINT, j) or j}' is a {kind} joint; a leg is six hinges "
                    "(write a ball joint as three)"
                )
        if len(side.joints) != 6:
            yield (
                f"the leg that ends at {body_label(model, side.link)} has {len(side.joints)} joints "
                f"({joint_names(model, side.joints)}); placing a flat foot anywhere takes 6: hip 3, knee 1, ankle 2"
            )


def ties(tree: Tree, leg_joints: list[int]) -> Iterator[str]:
    """Loops, ties to the world, and equalities that couple leg joints: the controller does not model them."""
    model = tree.model
    active = model.eq_active0 if hasattr(model, "eq_active0") else model.eq_active
    for e in (e for e in range(model.neq) if active[e]):
        label = name_of(model, OBJ.mjOBJ_EQUALITY, e) or e
        kind, first, second = int(model.eq_type[e]), int(model.eq_obj1id[e]), int(model.eq_obj2id[e])
        if kind in (EQ.mjEQ_CONNECT, EQ.mjEQ_WELD):
            if hasattr(model, "eq_objtype") and model.eq_objtype[e] == int(OBJ.mjOBJ_SITE):
                first, second = int(model.site_bodyid[first]), int(model.site_bodyid[second])
            inside = [b for b in (first, second) if b in tree.bodies]
            if len(inside) == 2:
                yield (
                    f"closed loop: equality '{label}' ties {body_label(model, first)} to {body_label(model, second)}; "
                    "zmpwalk needs a tree of joints"
                )
            elif inside:
                body = body_label(model, inside[0])
                yield f"equality '{label}' ties {body} to what is not the robot; remove it to walk"
        elif kind == EQ.mjEQ_JOINT:
            for j in (j for j in (first, second) if j in leg_joints):
                name = joint_names(model, [j])
                yield f"equality '{label}' couples leg joint {name}; six free hinges are needed"
                break


def drives(model: mujoco.MjModel, leg_joints: list[int]) -> Iterator[str]:
    """Leg joints that a tendon drives."""
    for a in (a for a in range(len(model.actuator_trntype)) if model.actuator_trntype[a] == TRN.mjTRN_TENDON):
        pulled = [j for j in tendon_joints(model, int(model.actuator_trnid[a, 0])) if j in leg_joints]
        if pulled:
            yield (
                f"actuator '{name_of(model, OBJ.mjOBJ_ACTUATOR, a) or a}' drives leg joint "
                f"'{joint_names(model, pulled[:1])}' through a tendon; each leg joint needs a motor of its own"
            )


def feet(robot: Found) -> Iterator[str]:
    """Point feet, an unknown order of joints, ankles that cannot pitch or roll."""
    model, data = robot.tree.model, robot.data
    for side in robot.sides:
        hip, knee, ankle = (data.xanchor[side.joints[i]] for i in (0, 3, 5))
        leg = np.linalg.norm(knee - hip) + np.linalg.norm(ankle - knee)
        if side.length < POINT_LENGTH * leg or side.width < POINT_WIDTH * leg:
            yield (
                f"point foot: {body_label(model, side.link)} meets the ground over {side.length:.3f} x "
                f"{side.width:.3f} m, too small a sole for a leg of {leg:.2f} m, which takes at least "
                f"{POINT_LENGTH * leg:.3f} x {POINT_WIDTH * leg:.3f} m"
            )
        pitch = [abs(data.xaxis[j] @ robot.left) > 0.7 for j in side.joints]
        roll = [abs(data.xaxis[j] @ robot.forward) > 0.7 for j in side.joints]
        names = joint_names(model, side.joints)
        if not (pitch[3] and any(pitch[:3])):
            yield f"the leg {names} is not hip 3 joints, knee, ankle 2: the fourth must bend the knee"
        for missing in [word for word, turns in (("pitch", pitch), ("roll", roll)) if not any(turns[4:])]:
            yield f"the leg {names} has no ankle {missing}: the last two joints must pitch and roll the foot"
