"""How hard a push it takes from each side, phase by phase, beside what a pendulum would bear."""

from __future__ import annotations

import textwrap
from typing import Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke
from matplotlib.ticker import MaxNLocator

from ..errors import InputError
from .style import BOUND, DESIRED, ESTIMATED, FAINT, WIDTH, WalkFigure, given_axes, styled

__all__ = ["pushes"]

LOOKS = {"left": (DESIRED, "o-"), "right": (ESTIMATED, "s--")}  # of a stance


@styled
def pushes(push_map: Any, axes: Any = None) -> Figure:
    """A polar figure for each phase: the smallest impulse that fells, over the direction of the push.

    Forward is up and outwards, to the side of the stance foot, is to the left; a right stance is drawn mirrored, so
    that both stances of a symmetrical robot lie on one another. The filled curve is the pendulum's limit, cut off at
    the rim; its assumptions stand below. An open mark on the rim is a direction in which nothing that was tried fells.

    Args:
        push_map: what `zmpwalk.push_map` returned.
        axes: a polar Axes for each phase (`projection="polar"`), or None for a figure of its own.

    Returns:
        The figure.

    Usage: `zmpwalk.push_map().plot()`
    """
    count = len(push_map.phases)
    columns = min(count, 4)
    rows = -(-count // columns)
    height = (0.75 + 0.72 * WIDTH / max(columns, 3)) * rows + 1.25
    known = push_map.felling[np.isfinite(push_map.felling)]
    rim = 1.15 * (known.max() if len(known) else push_map.limit)
    if axes is None:
        figure: Any = WalkFigure(figsize=(WIDTH, height))
        FigureCanvasAgg(figure)
        grid = figure.subplots(
            rows, columns, squeeze=False, subplot_kw={"projection": "polar"},
            gridspec_kw={"left": 0.05, "right": 0.95, "bottom": 0.65 / height, "top": 1.0 - 1.15 / height,
                         "hspace": 0.62, "wspace": 0.45},
        )  # fmt: skip
        panels: list[Any] = list(grid.ravel())
    else:
        panels = given_axes(axes, count)
        figure = panels[0].figure
        if any(ax.name != "polar" for ax in panels):
            raise InputError('a push map needs polar axes: subplots(..., subplot_kw={"projection": "polar"})')
    around = np.radians(np.append(push_map.directions, push_map.directions[0] + 360.0))
    for i, ax in enumerate(panels):
        if i >= count:
            ax.set_axis_off()
            continue
        ax.set_theta_zero_location("N")
        bound = np.append(push_map.pendulum[i], push_map.pendulum[i, 0])
        fine = np.linspace(0.0, 2.0 * np.pi, 361)
        filled = np.minimum(np.interp(fine, around - around[0], bound), rim)
        ax.fill(fine + around[0], filled, color=BOUND, alpha=0.25, lw=0, label="pendulum's limit, cut at the rim")
        for stance, felling in zip(push_map.stances, push_map.felling[:, i]):
            colour, look = LOOKS[stance]
            closed = np.append(felling, felling[0])
            name = f"fells it, {stance} foot standing" if np.isfinite(push_map.period) else "fells it"
            ax.plot(around, closed, look, color=colour, ms=2.5, lw=1.0, label=name)
            beyond = np.isnan(felling)
            ax.plot(around[:-1][beyond], np.full(beyond.sum(), rim), "o", mfc="none", mec=colour, ms=5, clip_on=False)
        ax.set_rmax(rim)
        ax.set_rmin(0.0)
        ax.yaxis.set_major_locator(MaxNLocator(3))
        ax.set_rlabel_position(150)
        ax.tick_params(labelsize=6, pad=-2)
        for label in ax.get_yticklabels():
            label.set_path_effects([withStroke(linewidth=2, foreground="white")])
        sides = ("out", "in") if np.isfinite(push_map.period) else ("left", "right")
        ax.set_xticks(np.radians([0, 90, 180, 270]), ["forward", sides[0], "back", sides[1]])
        ax.grid(lw=0.4, color=FAINT, alpha=0.5)
        worst = push_map.felling[:, i]
        least = f"{np.nanmin(worst):.2f} N s/kg" if np.isfinite(worst).any() else f"over {push_map.limit:g} N s/kg"
        phase = push_map.phases[i]
        where = (
            f"{phase:.3g} of a step after lift-off,\n{push_map.support(phase)} support"
            if np.isfinite(push_map.period)
            else "standing"
        )
        ax.set_title(f"{where}\nworst {least}", fontsize=7.5, pad=8)
    if axes is not None:
        return figure
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper left", bbox_to_anchor=(0.005, 1.0 - 0.25 / height), ncol=3)
    v = push_map.velocity
    speed = " / ".join(f"{value:g}" for value in (v if any(v[1:]) else v[:1]))
    figure.suptitle(
        f"{push_map.robot} at {speed} m/s: the smallest impulse that fells it, by its direction [N s/kg]",
        x=0.012, ha="left", fontsize=10, fontweight="bold", y=1.0 - 0.08 / height, va="top",
    )  # fmt: skip
    note = (
        f"A force of {push_map.duration:g} s on the body '{push_map.body}', {push_map.mass:.1f} kg: "
        f"worst {push_map.worst:.2f}, mean {push_map.mean:.2f} N s/kg. Filled: {push_map.pendulum_assumptions}."
    )
    figure.text(0.012, 0.06 / height, "\n".join(textwrap.wrap(note, 140)), fontsize=7, color=FAINT)
    return figure
