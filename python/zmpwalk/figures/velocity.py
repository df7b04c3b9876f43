"""Figs. 4 and 6: how the velocity follows its plan."""

from __future__ import annotations

from typing import Any

from matplotlib.figure import Figure

from ..trace import Trace
from .curves import (
    LONGEST,
    double_support_bars,
    end_of,
    excerpt,
    plan_changes,
    share_time,
    velocities,
    window,
    zmp_and_com,
)
from .style import DESIRED, FAINT, legend_above, new_figure, styled, title


@styled
def tracking(trace: Trace, start: float | None = 0.7, end: float | None = 1.2, axes: Any = None) -> Figure:
    """Fig. 4: how the tracker of III-C follows a change of the planned velocity, sagittally.

    (a) COM and ZMP with its bounds [m], (b) COM velocity [m/s], (c) integral of desired minus planned velocity [mm].

    Args:
        trace: a walk.
        start, end: window [s]; the default is the paper's, around the change at 0.8 s. None is the walk's start, its
            end.
        axes: three Axes to draw on, or None for a figure of its own.

    Returns:
        The figure.

    Raises:
        InputError: `start` is not before `end`.

    Usage: `trace.plot("tracking", start=1.5, end=2.0)`
    """
    if (start, end) == (0.7, 1.2) and end_of(trace) < 1.2:  # a walk that ended before the paper's window
        start, end = max(0.0, end_of(trace) - 0.5), None
    rows = window(trace, start, end)
    t = trace.t[rows]
    figure, (a, b, c) = new_figure(axes, 3, 1, height=6.4, ratios=(1.6, 1.1, 0.9))
    for ax in (a, b, c):
        double_support_bars(ax, trace, rows)
        plan_changes(ax, trace, rows)
    zmp_and_com(a, trace, rows, 0)
    a.set_ylabel("(a) position, forward [m]")
    legend_above(a, 4)
    velocities(b, trace, rows)
    b.set_ylabel("(b) velocity [m/s]")
    legend_above(b, 4, skip=("double support", "plan changes"))
    integral = 1e3 * trace.v_error_integral[rows, 0]
    c.axhline(0, color=FAINT, lw=0.6)
    c.fill_between(t, 0, integral, color=DESIRED, alpha=0.2, lw=0)
    c.plot(t, integral, color=DESIRED, label="integral of desired − planned velocity")
    c.set(ylabel="(c) integral [mm]", xlabel="time [s]")
    legend_above(c, 4, skip=("double support", "plan changes"))
    share_time(trace, rows, a, b, c)
    figure.align_ylabels([a, b, c])
    title(figure, axes, "Following the planned velocity by moving the ZMP")
    return figure


@styled
def velocity(trace: Trace, start: float | None = None, end: float | None = None, axes: Any = None) -> Figure:
    """Fig. 6: forward velocity of the COM: planned, desired and measured [m/s].

    Args:
        trace: a walk.
        start, end: window [s]; None for both is the walk, or ten seconds of a longer one.
        axes: one Axes to draw on, or None for a figure of its own.

    Returns:
        The figure.

    Raises:
        InputError: `start` is not before `end`.

    Usage: `trace.plot("velocity")`
    """
    rows = window(trace, start, end, LONGEST)
    figure, (ax,) = new_figure(axes, 1, 1, height=3.2)
    double_support_bars(ax, trace, rows)
    velocities(ax, trace, rows)
    ax.set(xlabel="time [s]", ylabel="forward velocity [m/s]")
    share_time(trace, rows, ax)
    legend_above(ax, 4)
    title(figure, axes, "Velocity of the centre of mass, forward" + excerpt(trace, rows))
    return figure
