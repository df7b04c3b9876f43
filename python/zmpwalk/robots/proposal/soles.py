"""The sole under a foot: its plane and its support rectangle, from the geoms that can touch the ground."""

from __future__ import annotations

import mujoco
import numpy as np

from ..polygon import area_of, convex_hull, inscribed_rectangle
from .tree import GEOM, UP, Found, Side, body_label

PLANE = 0.012  # of the foot's extent: points this near to the lowest one lie on the sole


def touching_geoms(model: mujoco.MjModel) -> dict[int, list[int]]:
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


def support_points(model: mujoco.MjModel, data: mujoco.MjData, g: int, up: np.ndarray) -> np.ndarray:
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


def sole_points(
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
        points = np.concatenate([support_points(model, data, g, R @ up) for g in geoms]) if geoms else np.zeros((0, 3))
        points = (points - p) @ R
        if not len(points):
            return points, up, 0.0
        heights = points @ up
        extent = np.linalg.norm(np.ptp(points - np.outer(heights, up), axis=0))
        points = points[heights <= heights.min() + PLANE * extent]
        area = area_of(convex_hull(points @ _across(up)))
        if area > 1.02 * best[2]:  # the body's own axis unless the other is better
            best = points, up, area
    return best


def _across(up: np.ndarray) -> np.ndarray:
    """Two directions (3, 2) square to `up`."""
    x = np.eye(3)[np.argmin(abs(up))]
    x = x - up * (x @ up)
    x /= np.linalg.norm(x)
    return np.stack([x, np.cross(up, x)], axis=1)


def fit_sole(robot: Found, side: Side) -> None:
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


def remark_soles(robot: Found) -> None:
    """Remarks on soles that differ, are no rectangles, are not level, or consist of two parts."""
    model, data, (a, b) = robot.tree.model, robot.data, robot.sides
    if max(abs(a.length - b.length), abs(a.width - b.width)) > 0.02 * a.length:
        robot.remarks.append(
            f"the soles differ: left {a.length:.3f} x {a.width:.3f} m, right {b.length:.3f} x {b.width:.3f} m"
        )
    for word, side in zip(("left", "right"), robot.sides):
        outline = area_of(convex_hull((side.corners @ side.R)[:, :2]))
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
                f"{word} sole: {body_label(model, toes[0])} moves against the foot and counts as part of the sole"
            )
