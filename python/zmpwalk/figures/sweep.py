"""The chart of a sweep: what came of the walks over one of the values that were tried."""

from __future__ import annotations

import math
import textwrap
from numbers import Real
from typing import Any, Sequence

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from ..errors import InputError
from ..sweeps import Sweep
from .curves import limits
from .style import FAINT, SERIES, SERIES_DASHES, legend_above, new_figure, nothing_to_draw, styled, title

LABELS = {
    "speed": "speed [m/s]", "speed_error": "speed error [m/s]", "torque": "largest torque\n[1 is its limit]",
    "zmp_error_x": "ZMP error forward,\nmedian [mm]", "zmp_error_y": "ZMP error leftward,\nmedian [mm]",
    "zmp_error_x_p95": "ZMP error forward,\n95th percentile [mm]", "profile": "commanded velocity [m/s]",
    "zmp_error_y_p95": "ZMP error leftward,\n95th percentile [mm]", "fall_time": "time of the fall [s]",
}  # fmt: skip

WORDS = {"profile": "velocity"}
MOST_LINES = 12  # that a legend tells apart


@styled
def sweep(found: Sweep, y: str | Sequence[str], x: str | None = None, axes: Any = None) -> Figure:
    """A panel for each `y` over `x`, a line for each value of the other axes of the grid.

    See `Sweep.plot` for the arguments.
    """
    names = [y] if isinstance(y, str) else list(y)
    numeric = [name for name in found.axes if all(_is_number(row[name]) for row in found)]
    if x is None:
        if not numeric:
            raise InputError(
                f"no axis of the sweep has numbers alone ({', '.join(found.axes)}); give x a column, such as one that "
                "a measure returns"
            )
        x = numeric[0]
    if len(found.failures) < len(found):
        for name in (x, *names):
            found[name]
    others = [name for name in found.axes if name != x]
    if x not in found.axes:  # a measured column: what it is measured of makes no lines of its own
        others = [name for name in numeric if len({row[name] for row in found}) <= MOST_LINES]
    lines: dict[tuple, list[dict[str, Any]]] = {}
    for row in found:
        if not row["error"]:
            lines.setdefault(tuple(row[name] for name in others), []).append(row)
    figure, panels = new_figure(axes, len(names), 1, height=1.2 + 1.9 * len(names))
    if not lines:
        return nothing_to_draw(
            figure, *panels, note="\n".join(textwrap.wrap("no walk could begin: " + found.failures[0]["error"], 90))
        )
    for ax, name in zip(panels, names):
        fallen: list[tuple[np.ndarray, np.ndarray, str]] = []
        standing: list[np.ndarray] = []
        for i, (values, rows) in enumerate(lines.items()):
            rows = sorted(rows, key=lambda row: row[x])
            colour, dashes = SERIES[i % len(SERIES)], SERIES_DASHES[i // len(SERIES) % len(SERIES_DASHES)]
            at, height = (np.array([float(row[key]) for row in rows]) for key in (x, name))
            stood = np.array([row["stood"] == 1 for row in rows])
            upright = np.where(stood, height, math.nan)
            ax.plot(at, upright, color=colour, ls=dashes, marker="o", ms=3.5, label=_label(others, values))
            standing.append(upright)
            fallen.append((at[~stood], height[~stood], colour))
        if name.startswith("zmp_error") and np.isfinite(np.concatenate(standing)).any():
            ax.set_yscale("log")
            ax.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
            ax.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
            ax.yaxis.set_minor_formatter(NullFormatter())
        elif np.isfinite(np.concatenate(standing)).any():
            ax.set_ylim(*limits(*standing))  # a fall would flatten all the rest: its cross is at the rim then
        label = "fell"
        for at, height, colour in fallen:
            low, high = ax.get_ylim()
            inside = np.clip(np.where(np.isfinite(height), height, high), low, high)
            if len(at):
                ax.plot(at, inside, "X", color=colour, ms=7, mec="black", mew=0.5, label=label, clip_on=False, zorder=5)
                label = "_"
        ax.set_ylabel(LABELS.get(name, name))
        ax.grid(color=FAINT, lw=0.3, alpha=0.4)
    panels[-1].set_xlabel(LABELS.get(x, x))
    if len(lines) <= MOST_LINES:
        legend_above(panels[0], 4)
    figure.align_ylabels(panels)
    drawn = LABELS.get(names[0], names[0]).split("\n")[0].split(" [")[0].rstrip(",")
    what = f"{drawn[0].upper()}{drawn[1:]} of " if len(names) == 1 else ""
    title(figure, axes, f"{what}{len(found)} walks over {' and '.join(WORDS.get(name, name) for name in found.axes)}")
    return figure


def _label(names: Sequence[str], values: Sequence[Any]) -> str:
    words = [
        f"{WORDS.get(name, name)} {value:g}" if _is_number(value) else f"{name} {value}"
        for name, value in zip(names, values)
    ]
    return ", ".join(words) or "stood"


def _is_number(value: Any) -> bool:
    return isinstance(value, Real) and not isinstance(value, bool)
