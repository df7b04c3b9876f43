"""What a walk bears of each kind of trouble, on one page."""

from __future__ import annotations

import math
from typing import Any

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from .style import ESTIMATED, FAINT, MEASURED, WIDTH, WalkFigure, given_axes, styled

__all__ = ["robustness"]


@styled
def robustness(found: Any, axes: Any = None) -> Figure:
    """A line of cells for each trouble, from mild to hard.

    Green cells stood, orange ones fell, and where only some of the walks stood a cell is green to that share. The cell
    of the bar, the level that a walk should bear, has a thick frame.

    Args:
        found: what `zmpwalk.robustness` returned.
        axes: one Axes to draw on, or None for a figure of its own.

    Returns:
        The figure.

    Usage: `zmpwalk.robustness().plot()`
    """
    count = len(found.troubles)
    height = 0.245 * count + 0.75
    if axes is None:
        figure: Any = WalkFigure(figsize=(WIDTH, height))
        FigureCanvasAgg(figure)
        ax = figure.add_axes((0.26, 0.28 / height, 0.73, 1.0 - 0.75 / height))
    else:
        (ax,) = given_axes(axes, 1)
        figure = ax.figure
    widest = max((len(trouble.levels) for trouble in found.troubles), default=1)
    for i, trouble in enumerate(found.troubles):
        for k, (level, share) in enumerate(zip(trouble.levels, trouble.stood)):
            ax.add_patch(Rectangle((k, i - 0.42), 0.96, 0.84, color=ESTIMATED, alpha=0.55, lw=0))
            ax.add_patch(Rectangle((k, i - 0.42), 0.96 * share, 0.84, color="white", lw=0))
            ax.add_patch(Rectangle((k, i - 0.42), 0.96 * share, 0.84, color=MEASURED, alpha=0.6, lw=0))
            if not math.isnan(trouble.bar) and abs(level - trouble.bar) < 1e-9:
                ax.add_patch(Rectangle((k, i - 0.42), 0.96, 0.84, fill=False, ec="black", lw=1.6))
            ax.text(k + 0.48, i, f"{level:.3g}", ha="center", va="center", fontsize=6.5)
    ax.set_yticks(range(count), [f"{t.name} [{t.unit}]" if t.unit else t.name for t in found.troubles], fontsize=7.5)
    ax.set_xticks([])
    ax.set(xlim=(0, widest), ylim=(count - 0.5, -0.5))
    for side in ("left", "bottom"):
        ax.spines[side].set_visible(False)
    ax.tick_params(length=0)
    if axes is not None:
        return figure
    figure.suptitle(
        f"{found.robot} at {found.velocity:g} m/s: what the walk bears", x=0.012, y=1.0 - 0.08 / height, ha="left",
        va="top", fontsize=10, fontweight="bold",
    )  # fmt: skip
    note = (
        "green: it stood; orange: it fell, or lost its speed or its path; both: the green part of the walks stood; "
        "framed: the level that it should bear"
    )
    figure.text(0.012, 0.08 / height, note, fontsize=7, color=FAINT)
    return figure
