"""What was found in a model: the robot at its start pose, and from above its soles, ankles, ZMP bounds and COM."""

from __future__ import annotations

import copy
import textwrap
from typing import Any

import mujoco
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from .. import render
from ..errors import Error
from ..robots import Proposal, sole_pose
from ..robots.polygon import convex_hull
from ..robots.proposal.soles import sole_points, touching_geoms
from ..robots.proposal.tree import OBJ, Tree, find_id, root_body
from .style import BOUND, COM, FAINT, SOLE, WIDTH, WalkFigure, styled

VIEWS = {"from the front": 180.0, "from its left": -90.0}  # azimuth of the camera, robot facing x [deg]
PIXELS = 320, 640  # of a view, width and height


@styled
def draw(model: mujoco.MjModel, proposal: Proposal) -> Figure:
    """The robot at its start pose, and its soles from above.

    Brown is what a foot can stand on: hatched the outline of the geoms that touch the ground, full the rectangle taken
    of it. Blue are the bounds of the ZMP, none where the controller refuses the robot; grey the ankles' axes; black the
    point under the COM. Axes in metres, x where the robot faces.

    Args:
        model: the robot's.
        proposal: as `propose` or `appraise` returns it.

    Returns:
        The figure; where nothing can be rendered it says why instead of the views.

    Usage: `draw(model, zmpwalk.propose(model)).savefig("robot.png")`
    """
    data, table = mujoco.MjData(model), proposal.table
    model = _lit(model)
    proposal.description.place(model, data)
    figure = WalkFigure(figsize=(WIDTH, 3.7), layout="constrained")
    FigureCanvasAgg(figure)
    views = figure.subplot_mosaic([[*VIEWS, "above"]], width_ratios=(1.0, 1.0, 2.3))
    _render(model, data, proposal, [views[name] for name in VIEWS])
    for name in VIEWS:
        views[name].set_title(name, fontsize=9)
        views[name].set_axis_off()
    _soles(views["above"], model, data, proposal)
    size = f"{table['mass_kg']:.2f} kg, COM {table['com_height_m']:.3f} m over the soles"
    figure.suptitle(f"{table['name']}: {size}", x=0.012, ha="left", fontsize=10, fontweight="bold")
    return figure


def _lit(model: mujoco.MjModel) -> mujoco.MjModel:
    """The model with light from the camera, where it would be dark: not every robot's file has lamps and a sky."""
    lit = copy.copy(model)
    if lit.nlight == 0 or not any(texture == mujoco.mjtTexture.mjTEXTURE_SKYBOX for texture in lit.tex_type):
        lit.vis.headlight.ambient[:], lit.vis.headlight.diffuse[:] = 0.45, 0.6
        lit.vis.rgba.fog[:] = lit.vis.rgba.haze[:] = 1.0
    return lit


def _render(model: mujoco.MjModel, data: mujoco.MjData, proposal: Proposal, axes: list[Axes]) -> None:
    forward = sole_pose(model, data, proposal.description.left)[1][:, 0]
    heading = float(np.degrees(np.arctan2(forward[1], forward[0])))
    try:
        with render.OffScreen(model, *PIXELS) as screen:
            for ax, azimuth in zip(axes, VIEWS.values()):
                ax.imshow(screen.draw(data, {"azimuth": heading + azimuth, "elevation": -8.0}))
    except Error as error:  # no OpenGL here
        note = textwrap.fill(str(error), 34)
        axes[0].text(0, 0.5, note, va="center", color=FAINT, transform=axes[0].transAxes, in_layout=False)


def _soles(ax: Axes, model: mujoco.MjModel, data: mujoco.MjData, proposal: Proposal) -> None:
    description, bounds = proposal.description, proposal.table["zmp_bounds_m"]
    feet = {"left": description.left, "right": description.right}
    origin = np.mean([sole_pose(model, data, foot)[0] for foot in feet.values()], axis=0)
    axes = sole_pose(model, data, description.left)[1][:, :2]
    com = data.subtree_com[root_body(model, description)]

    def plan(points: Any) -> np.ndarray:
        return (np.asarray(points) - origin) @ axes

    def fill(points: np.ndarray, **look: Any) -> None:
        ax.fill(*plan(points).T, **look)

    for word, foot in feet.items():
        centre, R = sole_pose(model, data, foot)
        label = "" if word == "left" else "_"
        outline = convex_hull(plan(_ground_points(model, data, foot.body)))
        look: Any = {"facecolor": "none", "edgecolor": SOLE, "hatch": "////", "lw": 0.0, "alpha": 0.6}
        ax.fill(*outline.T, label=label + "can touch the ground", **look)
        half = np.array([foot.length, foot.width]) / 2
        corners = centre + _rectangle(-half, half) @ R.T
        fill(corners, facecolor=SOLE, alpha=0.18, lw=0)
        size = f"{1e3 * foot.length:.0f} × {1e3 * foot.width:.0f} mm"
        fill(corners, facecolor="none", edgecolor=SOLE, lw=1.2, label=label + f"rectangle taken as the sole, {size}")
        if bounds:
            box = centre + _rectangle(*bounds[word]) @ R.T
            fill(box, facecolor=BOUND, edgecolor=BOUND, alpha=0.45, lw=0.8, label=label + "bounds of the ZMP")
        for k, name in enumerate(foot.leg_joints[4:]):
            j = find_id(model, OBJ.mjOBJ_JOINT, name)
            ends = plan([data.xanchor[j] + sign * 0.6 * foot.width * data.xaxis[j] for sign in (-1, 1)])
            ax.plot(*ends.T, color=FAINT, ls="--", lw=1.0, label="_" if label or k else "ankle axes")
        ax.annotate(word, plan([corners[0]])[0], (2, 4), textcoords="offset points", color=SOLE)
    ax.plot(*plan([com])[0], color=COM, marker="P", ms=9, ls="", label="COM")
    ax.set(xlabel="forward from the middle of the soles [m]", ylabel="leftward [m]")
    ax.set_aspect("equal", adjustable="datalim")
    ax.legend(loc="lower left", bbox_to_anchor=(-0.1, 1.0), ncol=2, borderaxespad=0.2)


def _rectangle(lower: Any, upper: Any) -> np.ndarray:
    """Corners (4, 3) of a rectangle in a sole's frame, from ahead and the left round."""
    (x0, y0), (x1, y1) = lower, upper
    return np.array([[x1, y1, 0], [x0, y1, 0], [x0, y0, 0], [x1, y0, 0]])


def _ground_points(model: mujoco.MjModel, data: mujoco.MjData, foot_body: str) -> np.ndarray:
    """Points (n, 3) in the world on the plane of a foot's sole, of the geoms that can touch the ground."""
    body = find_id(model, OBJ.mjOBJ_BODY, foot_body)
    tree, geoms = Tree(model, body), touching_geoms(model)
    points, _, _ = sole_points(model, data, body, [g for b in tree.under(body) for g in geoms.get(b, [])])
    return data.xpos[body] + points @ data.xmat[body].reshape(3, 3).T
