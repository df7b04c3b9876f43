"""Figs. 4 and 6: how the velocity follows its plan."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ..trace import Trace
from .curves import (
    LONGEST,
    double_support_bars,
    end_of,
    events,
    excerpt,
    plan_changes,
    share_time,
    velocities,
    walked_until,
    window,
    zmp_and_com,
)
from .style import DESIRED, FAINT, legend_above, new_figure, styled, title

LONG, BEFORE = 0.5, 0.1  # of the window of Fig. 4 in the paper: its length, and what of it lies before the change [s]


@styled
def tracking(trace: Trace, start: float | None = None, end: float | None = None, axes: Any = None) -> Figure:
    """Fig. 4: how the tracker of III-C follows a change of the planned velocity, sagittally.

    (a) COM and ZMP with its bounds [m], (b) COM velocity [m/s], (c) integral of desired minus planned velocity [mm].

    Args:
        trace: a walk.
        start, end: window [s]; None for both is half a second about the largest change of the planned velocity, which
            is the paper's window for the paper's profile.
        axes: three Axes to draw on, or None for a figure of its own.

    Returns:
        The figure.

    Raises:
        InputError: `start` is not before `end`.

    Usage: `trace.plot("tracking", start=1.5, end=2.0)`
    """
    if start is None and end is None:
        start, end = _largest_change(trace)
    rows = window(trace, start, end)
    t = trace.t[rows]
    figure, (a, b, c) = new_figure(axes, 3, 1, height=6.4, ratios=(1.6, 1.1, 0.9))
    for ax in (a, b, c):
        double_support_bars(ax, trace, rows)
        plan_changes(ax, trace, rows)
    zmp_and_com(a, trace, rows, 0)
    a.set_ylabel("(a) position, forward [m]")
    events(trace, rows, a, b, c)
    legend_above(a, 4)
    velocities(b, trace, rows)
    b.fill_between(t, trace.v_plan[rows, 0], trace.v_des[rows, 0], step=None, color=DESIRED, alpha=0.2, lw=0,
                   label="its integral is (c)")  # fmt: skip
    b.set_ylabel("(b) velocity [m/s]")
    legend_above(b, 4, skip=("double support", "plan changes"))
    integral = 1e3 * trace.v_error_integral[rows, 0]
    c.axhline(0, color=FAINT, lw=0.6)
    c.plot(t, integral, color=DESIRED, label="integral of desired − planned velocity")
    c.set(ylabel="(c) integral [mm]", xlabel="time [s]")
    legend_above(c, 4, skip=("double support", "plan changes"))
    share_time(trace, rows, a, b, c)
    figure.align_ylabels([a, b, c])
    title(figure, axes, "Following the planned velocity by moving the ZMP" + excerpt(trace, rows))
    return figure


def _largest_change(trace: Trace) -> tuple[float, float]:
    """Half a second, of which a fifth lies before the largest change of the planned velocity after the start [s].

    Where the plan does not change, it is the end of the walk.
    """
    changes = np.abs(np.diff(trace.v_plan[:, 0]))
    changes[(trace.t[1:] < BEFORE) | (trace.t[1:] >= walked_until(trace))] = 0.0
    at = float(trace.t[1:][int(np.argmax(changes))]) if changes.any() else end_of(trace)
    start = max(0.0, min(at - BEFORE, end_of(trace) - LONG))
    return start, start + LONG


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
    events(trace, rows, ax)
    share_time(trace, rows, ax)
    legend_above(ax, 4)
    title(figure, axes, "Velocity of the centre of mass, forward" + excerpt(trace, rows))
    return figure
