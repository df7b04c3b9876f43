"""Several walks in one figure: a colour for each."""

from __future__ import annotations

import math
from typing import Any, Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..errors import InputError, nearest
from ..trace import COLUMNS, Trace
from .curves import LONGEST, end_of, limits
from .style import FAINT, SERIES, SERIES_DASHES, legend_above, new_figure, styled, title

QUANTITIES = {
    "velocity": "COM, forward\n[m/s]",
    "sideways": "COM, leftward\n[m]",
    "zmp": "estimated ZMP,\nforward of COM [mm]",
    "estimate": "|estimated − mea-\nsured ZMP| [mm]",
    "torque": "largest torque\n[% of its limit]",
}
COMPARED = ("velocity", "sideways", "estimate", "torque")  # unless asked for others
CALM = 0.01  # within which the largest of torque and error is taken [s]


@styled
def compare(
    traces: Mapping[str, Trace],
    quantities: Sequence[str] = COMPARED,
    start: float | None = None,
    end: float | None = None,
    axes: Any = None,
) -> Figure:
    """Two or more walks over time in one figure, each in its colour.

    A cross marks where a walk fell. Dotted lines are planned velocities.

    Args:
        traces: what each walk is called, and its trace.
        quantities: a panel for each: "velocity" of the COM forward [m/s], "sideways" position of the COM [m], "zmp"
            estimated forward of the COM [mm], "estimate" is the largest |estimated - measured ZMP| of a hundredth of a
            second [mm], "torque" the largest of that time [% of its limit]; or any name that `Trace.flat` gives, such
            as "com_z" or "tau_l_knee".
        start, end: window [s]; None for both is the longest walk, or its first ten seconds.
        axes: as many Axes as quantities, or None for a figure of its own.

    Returns:
        The figure.

    Raises:
        InputError: no trace, a quantity that a trace does not have, or nothing in the window.

    Usage: `zmpwalk.plot.compare({"gain 1": slow, "gain 4": fast})`
    """
    if not isinstance(traces, Mapping) or isinstance(traces, Trace):  # a trace is a mapping as well
        raise InputError(f'traces is {type(traces).__name__}; it must be a dict such as {{"a": trace, "b": other}}')
    if not any(len(trace.t) for trace in traces.values()):
        raise InputError("there is no trace to compare, or none with a cycle")
    names = [quantities] if isinstance(quantities, str) else list(quantities)
    if not names:
        raise InputError(f"no quantity to compare; there are {', '.join(QUANTITIES)} and the names of Trace.flat")
    first = min(float(trace.t[0]) for trace in traces.values() if len(trace.t))
    if start is None and end is None:
        end = min(max(map(end_of, traces.values())), first + LONGEST)
    low, high = first if start is None else start, max(map(end_of, traces.values())) if end is None else end
    if not low < high:
        raise InputError(f"nothing to compare from {low:g} to {high:g} s")
    figure, panels = new_figure(axes, len(names), 1, height=0.9 + 1.5 * len(names))
    for ax, name in zip(panels, names):
        _panel(ax, name, traces, low, high)
    panels[-1].set_xlabel("time [s]")
    legend_above(panels[0], 4)
    figure.align_ylabels(panels)
    title(figure, axes, f"{len(traces)} walks compared")
    return figure


def _panel(ax: Axes, name: str, traces: Mapping[str, Trace], low: float, high: float) -> None:
    shown: list[np.ndarray] = []
    ends: list[tuple[float, float, str]] = []  # of the walks that fell: time, value, colour
    for i, (label, trace) in enumerate(traces.items()):
        rows = slice(*np.searchsorted(trace.t, (low - 1e-9, high + 1e-9)))
        look: dict[str, Any] = {"color": SERIES[i % len(SERIES)], "ls": SERIES_DASHES[i % len(SERIES_DASHES)]}
        t, values = trace.t[rows], _values(trace, name, label)[rows]
        if not len(t):
            continue
        if name in ("torque", "estimate"):
            t, values = _largest(t, values, max(1, round(CALM / trace.control_dt)))
        if name == "velocity":
            ax.step(t, trace.v_plan[rows, 0], where="post", color=look["color"], ls=":", lw=0.9, label="_planned")
        fell = trace.meta.get("fall_time") if trace.meta.get("fell") else None
        falls = fell is not None and low <= float(fell) <= high
        words = f"{label} (fell at {float(fell):.2f} s)" if falls and fell is not None else label
        ax.plot(t, values, lw=1.3, label=words, **look)
        if falls and np.isfinite(values).any():
            k = np.flatnonzero(np.isfinite(values))[-1]
            ends.append((float(t[k]), float(values[k]), look["color"]))
        calm = t < _trouble(trace)  # a fall would flatten all the rest
        shown.append(values[calm] if calm.any() else values)
    if not shown:
        raise InputError(f"nothing to compare from {low:g} to {high:g} s: every walk ends before, or begins after")
    ax.set_ylabel(QUANTITIES.get(name) or _label(name))
    ax.set_xlim(low, high)
    if name == "estimate":
        ax.set_yscale("log")
    else:
        ax.set_ylim(*limits(*shown))
    for at, value, colour in ends:  # at the rim where the fall went beyond it
        inside = min(max(value, ax.get_ylim()[0]), ax.get_ylim()[1])
        ax.plot(at, inside, marker="X", ms=7, color=colour, mec="black", mew=0.6, ls="", clip_on=False, zorder=6)
    if name == "torque" and ax.get_ylim()[1] > 100:
        ax.axhline(100, color=FAINT, lw=0.8, ls="--")


def _trouble(trace: Trace) -> float:
    """When a fall begins to show [s]; infinity where there is none."""
    known = [trace.meta.get(key) for key in ("fall_time", "alarm_time")] if trace.meta.get("fell") else []
    return min((float(t) - 0.3 for t in known if t is not None), default=math.inf)


def _values(trace: Trace, name: str, label: str) -> np.ndarray:
    if name == "velocity":
        return trace.forward_velocity()
    if name == "sideways":
        return trace.com[:, 1]
    if name == "zmp":
        return np.asarray(1e3 * (trace.zmp_est[:, 0] - trace.com[:, 0]))
    if name == "estimate":
        return np.asarray(1e3 * np.hypot(*(trace.zmp_est - trace.zmp_meas).T))
    if name == "torque":
        return np.asarray(100 * trace.torque_ratio)
    flat = trace.flat()
    if name not in flat:
        near = ", ".join(nearest(name, [*QUANTITIES, *flat])[:3])
        raise InputError(f"the walk '{label}' has no '{name}'; the nearest names are {near}")
    return flat[name]


def _largest(t: np.ndarray, values: np.ndarray, count: int) -> tuple[np.ndarray, np.ndarray]:
    """The largest of every `count` values, NaN where none is known."""
    whole = len(values) // count
    if whole < 2:
        return t, values
    parts = values[: whole * count].reshape(whole, count)
    known = np.where(np.isfinite(parts), parts, -math.inf).max(axis=1)
    return t[: whole * count : count], np.where(np.isfinite(known), known, math.nan)


def _label(name: str) -> str:
    column = COLUMNS.get(name) or next((known for known in COLUMNS.values() if name.startswith(known.name + "_")), None)
    return f"{name} [{column.unit}]" if column is not None and column.unit else name
