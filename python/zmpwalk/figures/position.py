"""Figs. 7 and 8: where COM and ZMP are, forward and sideways."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ..trace import Trace
from .curves import LONGEST, double_support_bars, events, excerpt, share_time, soles, window, zmp_and_com
from .style import legend_above, new_figure, styled, title


@styled
def sagittal(trace: Trace, start: float | None = None, end: float | None = None, axes: Any = None) -> Figure:
    """Fig. 7: COM and ZMP forward, in the world [m] and, in single support, from the support foot's sole centre [mm].

    Args:
        trace: a walk.
        start, end: window [s]; None for both is the walk, or ten seconds of a longer one.
        axes: two Axes to draw on (world, from the sole), or None for a figure of its own.

    Returns:
        The figure.

    Raises:
        InputError: `start` is not before `end`.

    Usage: `trace.plot("sagittal", start=3, end=6)`
    """
    rows = window(trace, start, end, LONGEST)
    figure, (world, sole) = new_figure(axes, 2, 1, height=5.6, ratios=(1.5, 1.0))
    for ax in (world, sole):
        double_support_bars(ax, trace, rows)
    soles(world, trace, rows, 0)
    zmp_and_com(world, trace, rows, 0)
    world.set_ylabel("position, forward [m]")
    centre = np.where(trace.support > 0, trace.foot_left[:, 0], trace.foot_right[:, 0])
    centre[trace.phase == 0] = np.nan  # two soles
    sole.set(xlabel="time [s]", ylabel="ZMP from support sole\nin single support [mm]")
    zmp_and_com(sole, trace, rows, 0, centre, unit=1e3)
    events(trace, rows, world, sole)
    share_time(trace, rows, world, sole)
    legend_above(world, 4)
    figure.align_ylabels([world, sole])
    title(figure, axes, "COM and ZMP, forward" + excerpt(trace, rows))
    return figure


@styled
def lateral(trace: Trace, start: float | None = None, end: float | None = None, axes: Any = None) -> Figure:
    """Fig. 8: COM and ZMP sideways, left positive [m].

    Args:
        trace: a walk.
        start, end: window [s]; None for both is the walk, or ten seconds of a longer one.
        axes: one Axes to draw on, or None for a figure of its own.

    Returns:
        The figure.

    Raises:
        InputError: `start` is not before `end`.

    Usage: `trace.plot("lateral")`
    """
    rows = window(trace, start, end, LONGEST)
    figure, (ax,) = new_figure(axes, 1, 1, height=3.9)
    double_support_bars(ax, trace, rows)
    soles(ax, trace, rows, 1)
    zmp_and_com(ax, trace, rows, 1)
    ax.set(xlabel="time [s]", ylabel="position, leftward [m]")
    events(trace, rows, ax)
    share_time(trace, rows, ax)
    legend_above(ax, 4)
    title(figure, axes, "COM and ZMP, sideways" + excerpt(trace, rows))
    return figure
