"""Says what keeps a robot from walking, a line for each reason: wheels, and the rules of the model.

The rules themselves are `_core.model_reasons`; nothing here states one again.
"""

from __future__ import annotations

from typing import Iterable, Iterator

import mujoco
import numpy as np

from ... import _core
from ...errors import ModelError
from .tree import GEOM, JNT, Found, Tree, body_label


def refuse(reasons: Iterable[str]) -> None:
    """Does nothing where there is no reason.

    Raises:
        ModelError: with all reasons.
    """
    reasons = list(reasons)
    if reasons:
        raise ModelError(*reasons)


def wheels(tree: Tree, data: mujoco.MjData, link: int, geoms: dict[int, list[int]]) -> Iterator[str]:
    """Finds a round geom that its own unlimited joint spins about a level axis through its centre: a wheel."""
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


def of_robot(robot: Found, upright: bool = False) -> list[tuple[str, str]]:
    """Reasons that the model's rules give for a robot that was found: (rule, sentence) pairs.

    Args:
        upright: left, right, forward and soles are known by now: look at them too.
    """
    words = ("left", "right") if upright else ("", "")
    legs = [
        _core.LegParts(
            foot=side.link,
            joints=side.joints,
            side=word,
            sole=np.array([side.length, side.width]) if upright else None,
        )
        for word, side in zip(words, robot.sides)
    ]
    forward = robot.forward if upright else np.zeros(3)
    parts = _core.RobotParts(root_body=robot.tree.root, legs=legs, forward=forward)
    return _core.model_reasons(robot.tree.model, parts, robot.data)
