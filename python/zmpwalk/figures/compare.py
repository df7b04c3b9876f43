"""Several walks in one figure: a colour for each."""

from __future__ import annotations

import math
from typing import Any, Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..errors import InputError, nearest
from ..trace import COLUMNS, Trace
from .curves import LONGEST, end_of, happened, limits
from .style import FAINT, PUSH, SERIES, SERIES_DASHES, legend_above, new_figure, styled, title

QUANTITIES = {
    "velocity": "forward velocity\nof the COM [m/s]",
    "sideways": "place of the COM,\nleftward [m]",
    "zmp": "estimated ZMP,\nforward of COM [mm]",
    "estimate": "error of the ZMP\nestimate [mm]",
    "torque": "largest torque\n[% of its limit]",
}
COMPARED = ("velocity", "sideways", "estimate", "torque")  # unless asked for others
MOST_WORDS = 3  # about what differs, in a title
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

    Vertical lines say where a walk was pushed, and in its colour where it fell. Dotted lines are planned velocities.
    The title says what differs between the walks' profiles and settings.

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
    pushes = {
        at for trace in traces.values() for at, word, _ in happened(trace) if word == "push" and low <= at <= high
    }
    for at in sorted(pushes):
        words = f"push, {at:.2f} s" if len(pushes) == 1 else f"{len(pushes)} pushes"
        for k, ax in enumerate(panels):
            ax.axvline(at, color=PUSH, lw=1.0, zorder=0.8, label=words if k == 0 and at == min(pushes) else "_")
    legend_above(panels[0], 4)
    figure.align_ylabels(panels)
    if len(traces) == 1:
        title(figure, axes, f"The walk '{next(iter(traces))}'")
    else:
        title(figure, axes, f"{len(traces)} walks compared, {_difference(traces)}")
    return figure


def _difference(traces: Mapping[str, Trace]) -> str:
    """What the walks do not have in common, as far as a title holds it."""
    tables: list[dict[str, Any]] = []
    for trace in traces.values():
        settings = trace.meta.get("settings") or {}
        given = {name: trace.meta.get(name) for name in ("robot", "profile", "push", "terrain")}
        tables.append({**given, **settings})
    names = [name for name in tables[0] if any(repr(table.get(name)) != repr(tables[0][name]) for table in tables[1:])]
    words = [name for name in names if name in ("robot", "profile", "push", "terrain")]
    for name in names:
        values = [table.get(name) for table in tables]
        if name not in words and all(isinstance(value, (int, float, str)) for value in values):
            words.append(
                f"{name.replace('_', ' ')} {', '.join(f'{v:.4g}' if isinstance(v, float) else str(v) for v in values)}"
            )
    if not words:
        return "with equal profile and settings"
    return (
        "which differ in: "
        + "; ".join(words[:MOST_WORDS])
        + (f" and {len(words) - MOST_WORDS} more" if len(words) > MOST_WORDS else "")
    )


def _panel(ax: Axes, name: str, traces: Mapping[str, Trace], low: float, high: float) -> None:
    shown: list[np.ndarray] = []
    plans: list[np.ndarray] = []
    for i, (label, trace) in enumerate(traces.items()):
        rows = slice(*np.searchsorted(trace.t, (low - 1e-9, high + 1e-9)))
        look: dict[str, Any] = {"color": SERIES[i % len(SERIES)], "ls": SERIES_DASHES[i % len(SERIES_DASHES)]}
        t, values = trace.t[rows], values_of(trace, name, label)[rows]
        if not len(t):
            continue
        if name in ("torque", "estimate"):
            t, values = _largest(t, values, max(1, round(CALM / trace.control_dt)))
        if name == "velocity":
            plan = trace.v_plan[rows, 0]
            if not any(np.array_equal(plan, known) for known in plans):
                words = "_" if plans else "planned"
                ax.step(t, plan, where="post", color=FAINT, ls=":", lw=1.1, label=words, zorder=1)
            plans.append(plan)
        ax.plot(t, values, lw=1.3, label=label, **look)
        for at, word, _ in happened(trace):
            if word == "fell" and low <= at <= high:
                ax.axvline(at, color=look["color"], lw=1.8, ls="-.", zorder=1, label=f"{label} fell, {at:.2f} s")
        shown.append(values)
    if not shown:
        raise InputError(f"nothing to compare from {low:g} to {high:g} s: every walk ends before, or begins after")
    ax.set_ylabel(QUANTITIES.get(name) or label_of(name))
    ax.set_xlim(low, high)
    if name == "estimate":
        ax.set_yscale("log")
    else:
        ax.set_ylim(*limits(*shown))
    if name == "torque" and ax.get_ylim()[1] > 100:
        ax.axhline(100, color=FAINT, lw=0.8, ls="--")


def values_of(trace: Trace, name: str, label: str) -> np.ndarray:
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


def label_of(name: str) -> str:
    column = COLUMNS.get(name) or next((known for known in COLUMNS.values() if name.startswith(known.name + "_")), None)
    return f"{name} [{column.unit}]" if column is not None and column.unit else name
