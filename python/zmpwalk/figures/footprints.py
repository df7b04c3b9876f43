"""The walk from above."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Polygon

from ..analysis import feet_pose, planned_path, sole_yaw
from ..trace import Trace
from .curves import excerpt, happened, spans, walked_until, window
from .style import (
    COM,
    DESIRED,
    MEASURED,
    PLANNED,
    PUSH,
    RIGHT_SOLE,
    SOLE,
    WIDTH,
    legend_above,
    new_figure,
    styled,
    title,
)

SAME = 0.02  # within which two places of a sole are one [m]
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
        walked = trace.zmp_meas[rows][trace.t[rows] < walked_until(trace)]
        ax.plot(*walked.T, color=MEASURED, lw=0.8, zorder=3, label="measured ZMP")
    landed = np.flatnonzero(np.diff(trace.phase[rows]) < 0) + 1 + rows.start
    size = 0.15 * float(com[0, 2])
    x, y, yaw = _apart(feet_pose(trace.foot_left[landed], trace.foot_right[landed]), size).T
    arrow: dict[str, Any] = {"angles": "xy", "scale_units": "xy", "scale": 1, "width": 0.003, "zorder": 5}
    ax.quiver(x, y, size * np.cos(yaw), size * np.sin(yaw), color=DESIRED, label="_heading", **arrow)
    ax.plot([], [], color=DESIRED, ls="", marker=r"$\rightarrow$", ms=11, label="heading")
    _pushes(ax, trace, rows, size)
    fell = {at for at, word, _ in happened(trace) if word == "fell"}
    last = "fell" if any(abs(at - trace.t[rows][-1]) < 0.1 for at in fell) else "end"
    # The start is a ring round the end where both are at one place.
    for k, word, look in (
        (0, "start", {"marker": "o", "mfc": "white", "mec": COM, "ms": 9, "zorder": 6}),
        (-1, last, {"marker": "X" if last == "fell" else "s", "mfc": COM, "mec": "white", "ms": 6, "zorder": 7}),
    ):
        ax.plot(*com[k, :2], ls="", label=f"{word}, {trace.t[rows][k]:.3g} s", **look)
    ax.set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
    ax.set(xlim=(low[0] - margin, high[0] + margin), ylim=(low[1] - margin, high[1] + margin))
    legend_above(ax, 4)
    until = walked_until(trace)
    left_out = f"; soles and ZMP until {until:.2f} s" if until <= trace.t[rows][-1] else ""
    title(figure, axes, "The walk from above" + excerpt(trace, rows) + left_out)
    return figure


def _pushes(ax: Axes, trace: Trace, rows: slice, size: float) -> None:
    """An arrow along each push from where the COM was, of `size` for the largest of them."""
    t, pushes = trace.t[rows], list(trace.meta.get("push") or ())
    shown = [(float(at), np.asarray(force[:2], float)) for at, _, _, force in pushes if t[0] <= float(at) <= t[-1]]
    most = max((float(np.hypot(*force)) for _, force in shown), default=0.0)
    words = f"push, {shown[0][0]:.2f} s" if len(shown) == 1 else f"{len(shown)} pushes"
    for n, (at, force) in enumerate(shown if most else ()):
        com = trace.com[rows][min(int(np.searchsorted(t, at)), len(t) - 1), :2]
        tip = com + 2.0 * size * force / most
        look: dict[str, Any] = {"arrowstyle": "-|>", "color": PUSH, "lw": 2.0, "mutation_scale": 12}
        ax.annotate("", tuple(tip), tuple(com), arrowprops=look, zorder=8)
        if n == 0:
            ax.plot([], [], color=PUSH, ls="", marker=r"$\rightarrow$", ms=11, label=words)


def _apart(poses: np.ndarray, least: float) -> np.ndarray:
    """Of poses (n, 3) those that are `least` away from the last one kept, or turned by 20 degrees from it."""
    kept: list[np.ndarray] = []
    for pose in poses:
        turned = 1.0 if not kept else abs(np.angle(np.exp(1j * (pose[2] - kept[-1][2]))))
        if not kept or np.hypot(*(pose[:2] - kept[-1][:2])) > least or turned > np.radians(20.0):
            kept.append(pose)
    return np.array(kept).reshape(-1, 3)


def _prints(trace: Trace, rows: slice, side: int) -> list[np.ndarray]:
    """Corners (4, 2) of a sole [m], once for each place where it stood."""
    name = ("left", "right")[side]
    foot = trace.meta.get("description", {}).get(name, {})
    half_length, half_width = foot.get("length", 0.0) / 2, foot.get("width", 0.0) / 2
    poses = trace[f"foot_{name}"][rows]
    corners: list[np.ndarray] = []
    down = (trace.phase[rows] == 0) | ((trace.support[rows] > 0) == (side == 0))
    for span in spans(down & (trace.t[rows] < walked_until(trace))):
        pose = poses[(span.start + span.stop) // 2]
        c, s = np.cos(sole_yaw(pose)), np.sin(sole_yaw(pose))
        box = np.array([(1, 1), (-1, 1), (-1, -1), (1, -1)]) * (half_length, half_width)
        corner = pose[:2] + box @ np.array([(c, s), (-s, c)])
        if not any(np.abs(corner - known).max() < SAME for known in corners):
            corners.append(corner)
    return corners
