"""The walk from above."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Polygon

from ..analysis import feet_pose, planned_path, sole_yaw
from ..trace import Trace
from .curves import excerpt, spans, window
from .style import (
    COM,
    DESIRED,
    MEASURED,
    PLANNED,
    RIGHT_SOLE,
    SOLE,
    WIDTH,
    legend_above,
    new_figure,
    styled,
    title,
)

MANY = 60  # places of a sole, beyond which the ZMP would only hide them


@styled
def footprints(trace: Trace, start: float | None = None, end: float | None = None, axes: Any = None) -> Figure:
    """The walk from above: every place where a sole stood, COM, ZMP, and where the commands lead [m].

    An arrow at each touch-down goes from the middle of the feet along their mean heading. The measured ZMP is left out
    where soles stand in more than 60 places.

    Args:
        trace: a walk.
        start, end: window [s]; None is the walk's start, its end.
        axes: one Axes to draw on, or None for a figure of its own.

    Returns:
        The figure.

    Raises:
        InputError: `start` is not before `end`.

    Usage: `trace.plot("footprints")`
    """
    rows = window(trace, start, end)
    planned, com = planned_path(trace)[rows], trace.com[rows]
    prints = {side: _prints(trace, rows, side) for side in (0, 1)}
    everything = np.vstack([planned[:, :2], com[:, :2], *(p for corners in prints.values() for p in corners)])
    low, high = everything.min(axis=0), everything.max(axis=0)
    margin = 0.04 * max(high - low)
    width, height = high - low + 2 * margin
    figure, (ax,) = new_figure(axes, 1, 1, height=min(max(0.9 * WIDTH * height / width + 1.3, 2.6), WIDTH))
    for side, (name, color) in enumerate((("left", SOLE), ("right", RIGHT_SOLE))):
        for n, corners in enumerate(prints[side]):
            label = f"{name} sole" if n == 0 else None
            ax.add_patch(Polygon(corners, closed=True, facecolor=color, alpha=0.25, lw=0, zorder=1, label=label))
            ax.add_patch(Polygon(corners, closed=True, fill=False, edgecolor=color, lw=0.7, zorder=1.5))
    ax.plot(*planned[:, :2].T, color=PLANNED, lw=2.2, zorder=2, label="where the commands lead")
    ax.plot(*com[:, :2].T, color=COM, lw=1.4, zorder=4, label="COM")
    if sum(map(len, prints.values())) <= MANY:
        ax.plot(*trace.zmp_meas[rows].T, color=MEASURED, lw=0.8, zorder=3, label="measured ZMP")
    landed = np.flatnonzero(np.diff(trace.phase[rows]) < 0) + 1 + rows.start
    x, y, yaw = feet_pose(trace.foot_left[landed], trace.foot_right[landed]).T
    size = 0.15 * float(com[0, 2])
    arrow: dict[str, Any] = {"angles": "xy", "scale_units": "xy", "scale": 1, "width": 0.003, "zorder": 5}
    ax.quiver(x, y, size * np.cos(yaw), size * np.sin(yaw), color=DESIRED, label="_heading", **arrow)
    ax.plot([], [], color=DESIRED, ls="", marker=r"$\rightarrow$", ms=11, label="heading")
    for k, word, marker in ((0, "start", "o"), (-1, "end", "s")):
        look: dict[str, Any] = {"mfc": "white" if k == 0 else COM, "ms": 6 if k == 0 else 5, "zorder": 6}
        ax.plot(*com[k, :2], color=COM, marker=marker, ls="", label=f"{word}, {trace.t[rows][k]:.3g} s", **look)
    ax.set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
    ax.set(xlim=(low[0] - margin, high[0] + margin), ylim=(low[1] - margin, high[1] + margin))
    legend_above(ax, 4)
    title(figure, axes, "The walk from above" + excerpt(trace, rows))
    return figure


def _prints(trace: Trace, rows: slice, side: int) -> list[np.ndarray]:
    """Corners (4, 2) of a sole [m], once for each time it stood."""
    name = ("left", "right")[side]
    foot = trace.meta.get("description", {}).get(name, {})
    half_length, half_width = foot.get("length", 0.0) / 2, foot.get("width", 0.0) / 2
    poses, corners = trace[f"foot_{name}"][rows], []
    for span in spans((trace.phase[rows] == 0) | ((trace.support[rows] > 0) == (side == 0))):
        pose = poses[(span.start + span.stop) // 2]
        c, s = np.cos(sole_yaw(pose)), np.sin(sole_yaw(pose))
        box = np.array([(1, 1), (-1, 1), (-1, -1), (1, -1)]) * (half_length, half_width)
        corners.append(pose[:2] + box @ np.array([(c, s), (-s, c)]))
    return corners
