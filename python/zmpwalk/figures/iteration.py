"""Fig. 2: how the reference ZMP of one cycle was found."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from ..errors import InputError
from ..trace import Trace
from .curves import window
from .style import DESIRED, ESTIMATED, FAINT, legend_above, new_figure, nothing_to_draw, styled, title

MOST_PASSES = 200  # of an iteration that are drawn
NAMES = ("forward", "lateral")


@styled
def iteration(
    trace: Trace,
    cycle: int | None = None,
    start: float | None = None,
    end: float | None = None,
    axis: str = "x",
    axes: Any = None,
) -> Figure:
    """Fig. 2: the estimated ZMP goes to the desired one as the iteration of III-B goes on.

    The passes are those of the paper's loop, r_ref += r_des - r_est, replayed from the cycle's first estimate and
    from how strongly the estimate follows the reference; a walk that used the closed form is shown as the loop would
    have gone.

    Args:
        trace: a walk.
        cycle: row to show; None takes, from `start` to `end`, the modified cycle whose first estimate was farthest off.
        start, end: window for that choice [s]; None is the walk's start, its end.
        axis: "x" forward or "y" leftward.
        axes: two Axes to draw on (ZMP, error), or None for a figure of its own.

    Returns:
        The figure.

    Raises:
        InputError: a window or cycle outside the walk.

    Usage: `trace.plot("iteration", cycle=850)`
    """
    i = _axis(axis)
    figure, (left, right) = new_figure(axes, 1, 2, height=3.1)
    k = _largest_first_error(trace, start, end, i) if cycle is None else cycle
    if k is None or not -len(trace.t) <= k < len(trace.t):
        if cycle is not None:
            raise InputError(f"cycle {cycle} is outside the walk, which has {len(trace.t)}")
        return nothing_to_draw(figure, left, right, note="no cycle with an estimate in this window")
    k = k % len(trace.t)
    if not (np.isfinite(trace.zmp_first[k, i]) and trace.zmp_slope[k, i]):
        raise InputError(f"cycle {k} at {trace.t[k]:.3f} s was not iterated: its ZMP was left alone")
    threshold = 1e3 * float(trace.meta.get("settings", {}).get("zmp_threshold") or 1e-3)
    centre = (trace.foot_left if trace.support[k] > 0 else trace.foot_right)[k, i]
    desired, slope = 1e3 * (trace.zmp_des[k, i] - centre), trace.zmp_slope[k, i]
    first_error = 1e3 * (trace.zmp_des[k, i] - trace.zmp_first[k, i])
    contraction = 1.0 - slope
    needed = _passes(first_error, contraction, threshold)
    n = np.arange(max(needed + 2, 5))
    error = first_error * contraction**n
    reference = desired + np.concatenate([[0.0], np.cumsum(error)[:-1]])
    marker = "o" if len(n) <= 40 else ""

    band = f"within {threshold:g} mm"
    if threshold > 0.02 * np.ptp(desired - error):  # otherwise it is thinner than a line
        left.axhspan(desired - threshold, desired + threshold, color=DESIRED, alpha=0.15, lw=0, label=band)
    left.axhline(desired, color=DESIRED, label="desired ZMP")
    if np.ptp(reference) < 3 * np.ptp(desired - error):  # of slow iterations it goes metres away
        square = "s" if marker else ""
        left.plot(n + 1, reference, color=FAINT, ls=":", marker=square, ms=3, label="pendulum's reference ZMP")
    left.plot(n + 1, desired - error, color=ESTIMATED, marker=marker, ms=4, label="estimated ZMP")
    left.set(xlabel="pass", ylabel=f"{NAMES[i]} ZMP from support sole [mm]")
    legend_above(left, 2)

    right.axhline(threshold, color=DESIRED, ls="--", label=f"threshold {threshold:g} mm")
    left_over = f"each pass leaves {100 * abs(contraction):.3g} % of the error"
    right.semilogy(n + 1, np.abs(error), color=ESTIMATED, marker=marker, ms=4, label=left_over)
    right.set(xlabel="pass", ylabel="error: |desired − estimated ZMP| [mm]")
    right.set_ylim(bottom=max(np.abs(error).min() / 2, threshold * 1e-6))
    legend_above(right, 1)
    for ax in (left, right):
        ax.xaxis.set_major_locator(MaxNLocator(6, integer=True))
        ax.set_xlim(1 - 0.04 * len(n), len(n) + 0.04 * len(n))
    passes = "1 pass" if needed == 1 else f"{needed} passes" if needed < MOST_PASSES else f"over {MOST_PASSES} passes"
    title(figure, axes, f"The paper's loop for the ZMP, at {trace.t[k]:.3f} s: {passes} to the threshold")
    return figure


def _axis(axis: str) -> int:
    if axis not in ("x", "y"):
        raise InputError(f"axis is {axis!r}; it is 'x' (forward) or 'y' (lateral)")
    return "xy".index(axis)


def _largest_first_error(trace: Trace, start: float | None, end: float | None, i: int) -> int | None:
    rows = window(trace, start, end)
    error = np.abs(trace.zmp_des[rows, i] - trace.zmp_first[rows, i])
    usable = np.isfinite(error) & np.isfinite(trace.zmp_slope[rows, i]) & (trace.zmp_slope[rows, i] != 0)
    modified = usable & (trace.zmp_modified[rows, i] != 0)
    candidates = modified if modified.any() else usable
    if not candidates.any():
        return None
    return rows.start + int(np.argmax(np.where(candidates, error, -1.0)))


def _passes(first_error: float, contraction: float, threshold: float) -> int:
    """Passes of the loop after which the error is below the threshold; at most `MOST_PASSES`."""
    error, n = abs(first_error), 1
    while error >= threshold and n < MOST_PASSES:
        error, n = error * abs(contraction), n + 1
    return n
