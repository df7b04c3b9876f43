"""How true the estimate is: the estimated ZMP against the one of the simulator's contact forces."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..trace import Trace
from .curves import LONGEST, double_support_bars, events, excerpt, share_time, window
from .style import COM, DESIRED, ESTIMATED, FAINT, MEASURED, legend_above, new_figure, nothing_to_draw, styled, title

LEAST = 1e-6  # of an error that is drawn [mm]: below it is rounding
APART = 0.15  # of two notes, share of the height of their axes
PHASES = ((1, "single support", MEASURED, "-"), (0, "double support", DESIRED, (0, (4, 1.5))))


@styled
def estimate(trace: Trace, start: float | None = None, end: float | None = None, axes: Any = None) -> Figure:
    """How true the estimate is: |estimated - measured ZMP| over time, and its distribution by phase [mm].

    The estimate is what the controller knew before it sent the torque; the measurement is the centre of pressure of the
    simulator's contact forces after it. The errors forward are above, those leftward below, both on a logarithmic axis.
    On the right each curve tells in which share of a phase's cycles the error is smaller.

    Args:
        trace: a walk.
        start, end: window [s]; None for both is the walk, or ten seconds of a longer one.
        axes: four Axes to draw on (forward: over time, distribution; leftward: the same), or None for a figure of its
            own.

    Returns:
        The figure.

    Raises:
        InputError: `start` is not before `end`.

    Usage: `trace.plot("estimate")`
    """
    rows = window(trace, start, end, LONGEST)
    figure, grid = new_figure(axes, 2, 2, height=5.1, widths=(2.3, 1.0), sharey=True)
    errors = 1e3 * np.abs(trace.zmp_est[rows] - trace.zmp_meas[rows])
    if not np.isfinite(errors).all(axis=1).any():
        return nothing_to_draw(figure, *grid, note="no cycle with an estimate and a measurement")
    sole = [1e3 * size for size in _half_sole(trace)]
    for i, word in enumerate(("forward", "leftward")):
        over_time, share = grid[2 * i], grid[2 * i + 1]
        error = np.maximum(errors[:, i], LEAST)
        double_support_bars(over_time, trace, rows)
        over_time.semilogy(trace.t[rows], error, color=ESTIMATED, lw=0.8, label="|estimated − measured ZMP|")
        known = error[np.isfinite(error)]
        median, most = np.percentile(known, (50, 95))
        lines = [(median, "-", "median"), (most, (0, (3, 2)), "95 % are below")]
        if np.isfinite(sole[i]):
            lines.append((sole[i], ":", "edge of the sole"))
        for value, dashes, name in lines:
            colour = COM if value != sole[i] else FAINT
            for ax in (over_time, share):
                ax.axhline(value, color=colour, lw=0.9, ls=dashes, zorder=3, label=name if i == 0 else "_")
        over_time.set_ylabel(f"error {word} [mm]")
        _distribution(share, error, trace.phase[rows])
        low, high = np.percentile(known, 0.5), max(known.max(), sole[i] if np.isfinite(sole[i]) else 0.0)
        over_time.set_ylim(max(low / 3, LEAST / 2), 2.0 * high)
        share.set_ylim(over_time.get_ylim())
        _notes(share, [(value, name) for value, _, name in lines])
        events(trace, rows, over_time)
        share_time(trace, rows, over_time)
    grid[2].set_xlabel("time [s]")
    grid[3].set_xlabel("share of cycles\nwith less error [%]")
    legend_above(grid[0], 2)
    legend_above(grid[1], 1, skip=("median", "95 % are below", "edge of the sole"))
    figure.align_ylabels([grid[0], grid[2]])
    title(figure, axes, "How true the estimate of the ZMP is" + excerpt(trace, rows))
    return figure


def _notes(ax: Axes, lines: list[tuple[float, str]]) -> None:
    """Small words at the right ends of horizontal lines, one above the other where the lines are close."""
    low, high = np.log(ax.get_ylim())
    above = -np.inf
    for value, name in sorted(lines):
        above = max((np.log(value) - low) / (high - low), above + APART)
        words = f"{name}:\n{value:.2g} mm" if value < 10 else f"{name}:\n{value:.0f} mm"
        ax.annotate(words, (1.0, above), (3, 0), "axes fraction", "offset points", fontsize=7, va="center")


def _distribution(ax: Axes, error: np.ndarray, phase: np.ndarray) -> None:
    """Share of the cycles of a phase below each error, the error upwards."""
    for number, label, colour, dashes in PHASES:
        known = np.sort(error[(phase == number) & np.isfinite(error)])
        if len(known):
            ax.semilogy(100 * np.arange(1, len(known) + 1) / len(known), known, color=colour, ls=dashes, label=label)
    ax.set(xlim=(0, 100), xticks=(0, 50, 95))
    ax.set_yscale("log")
    ax.grid(axis="x", color=FAINT, lw=0.4, alpha=0.5)


def _half_sole(trace: Trace) -> tuple[float, float]:
    """From the centre of a sole to its edge, forward and sideways [m]; NaN where the trace does not know it."""
    foot = trace.meta.get("description", {}).get("left", {})
    return float(foot.get("length", np.nan)) / 2, float(foot.get("width", np.nan)) / 2
