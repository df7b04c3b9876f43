"""What figures over time share: the window of a walk, its phases, and the curves of COM, ZMP and velocity."""

from __future__ import annotations

import math
from typing import Any, Iterator

import numpy as np
from matplotlib.axes import Axes

from ..errors import InputError
from ..trace import Trace
from .style import (
    BOUND,
    COM,
    DASHES,
    DESIRED,
    DOTS,
    DOUBLE_SUPPORT,
    ESTIMATED,
    FAINT,
    MEASURED_BAND,
    PLANNED,
    PUSH,
    SOLE,
    SOLE_FILL,
)

LONGEST = 10.0  # of a walk that is drawn unless asked for more [s]


def window(trace: Trace, start: float | None, end: float | None, longest: float = math.inf) -> slice:
    """Rows from `start` to `end` [s]; with neither, at most `longest`: the beginning, or a fall's end."""
    if len(trace.t) < 2:
        raise InputError("this walk has fewer than two cycles: there is nothing to draw")
    if start is None and end is None and trace.duration > longest:
        start, end = (end_of(trace) - longest, None) if trace.meta.get("fell") else (None, trace.t[0] + longest)
    low = int(np.searchsorted(trace.t, -math.inf if start is None else start - 1e-9))
    high = int(np.searchsorted(trace.t, math.inf if end is None else end + 1e-9))
    if high - low < 2:
        raise InputError(
            f"nothing to draw from {start} to {end} s: the walk goes from {trace.t[0]:g} to {end_of(trace):g} s"
        )
    return slice(low, high)


def end_of(trace: Trace) -> float:
    """Time of the last cycle [s]."""
    return float(trace.t[-1]) if len(trace.t) else 0.0


def excerpt(trace: Trace, rows: slice) -> str:
    """What a title adds where it is not the whole walk that is drawn."""
    t = trace.t[rows]
    whole = len(t) == len(trace.t)
    part = "" if whole else f" ({t[0]:.3g} to {t[-1]:.3g} s of {trace.duration:.4g} s)"
    fell = None if trace.fall is None else trace.fall.time
    return part if fell is None else f"{part}; it fell at {fell:.2f} s"


def happened(trace: Trace) -> Iterator[tuple[float, str, dict[str, Any]]]:
    """What befell the robot: the instant [s], its word, and how its line looks."""
    for push in trace.meta.get("push") or ():
        yield float(push[0]), "push", {"color": PUSH, "ls": "-", "lw": 1.2}
    fall = trace.fall
    if fall is not None and fall.foreseen is not None:
        yield float(fall.foreseen), "fall foreseen", {"color": FAINT, "ls": "--", "lw": 1.2}
    if fall is not None and fall.time is not None:
        yield float(fall.time), "fell", {"color": FAINT, "ls": "-", "lw": 1.8}


def walked_until(trace: Trace) -> float:
    """When the robot stopped walking, because its fall was foreseen or because it fell [s]; else infinity."""
    known = [] if trace.fall is None else [t for t in (trace.fall.foreseen, trace.fall.time) if t is not None]
    return min(known, default=math.inf)


def events(trace: Trace, rows: slice, *axes: Axes) -> None:
    """Vertical lines through the axes where the robot was pushed, where its fall was foreseen and where it fell."""
    t = trace.t[rows]
    words: dict[str, list[float]] = {}
    for at, word, _ in happened(trace):
        if t[0] <= at <= t[-1] + trace.control_dt:
            words.setdefault(word, []).append(at)
    for at, word, look in happened(trace):
        known = words.get(word, [])
        if at not in known:
            continue
        label = f"{word}, {at:.2f} s" if len(known) == 1 else f"{word}: {len(known)} times"
        for k, ax in enumerate(axes):
            ax.axvline(at, zorder=0.8, label=label if k == 0 and at == known[0] else "_", **look)


def share_time(trace: Trace, rows: slice, *axes: Axes) -> None:
    """The axes go from the first row drawn to the end of the last."""
    for ax in axes:
        first, last = float(trace.t[rows][0]), float(trace.t[rows][-1])
        fell = trace.fall is not None and trace.fall.time is not None
        ax.set_xlim(first, last + (0.01 * (last - first) if fell else trace.control_dt))  # so that its line is seen


def spans(mask: np.ndarray) -> list[slice]:
    """Runs of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(int)))
    return [slice(int(a), int(b)) for a, b in zip(edges[::2], edges[1::2])]


def double_support_bars(ax: Axes, trace: Trace, rows: slice) -> None:
    """Grey bars along the lower edge where both feet are down."""
    t, label = trace.t[rows], "double support"
    for span in spans(trace.phase[rows] == 0):
        end = t[span.stop - 1] + trace.control_dt
        ax.axvspan(t[span.start], end, 0.0, 0.035, color=DOUBLE_SUPPORT, lw=0, zorder=0, label=label)
        label = "_"


def plan_changes(ax: Axes, trace: Trace, rows: slice) -> None:
    """Dotted lines where the planned velocity steps, if that is seldom."""
    plan, label = trace.v_plan[rows, 0], "plan changes"
    changes = np.flatnonzero(np.abs(np.diff(plan)) > 1e-9) + 1
    for k in changes if len(changes) <= 6 else ():
        ax.axvline(trace.t[rows][k], color=PLANNED, ls=":", lw=1.4, zorder=1, label=label)
        label = "_"


def soles(ax: Axes, trace: Trace, rows: slice, i: int) -> None:
    """Where each sole lies while it carries weight, from its size in the description."""
    label, edges = "soles on the ground", []
    for side, name in enumerate(("left", "right")):
        foot = trace.meta.get("description", {}).get(name, {})
        if "length" not in foot:
            continue
        half = foot["length" if i == 0 else "width"] / 2
        place = trace[f"foot_{name}"][rows, i]
        down = (trace.phase[rows] == 0) | ((trace.support[rows] > 0) == (side == 0))
        down &= trace.t[rows] < walked_until(trace)
        for span in spans(down):
            t, x = trace.t[rows][span], place[span]
            ax.fill_between(t, x - half, x + half, facecolor=SOLE_FILL, lw=0, zorder=0.5)
            for edge in (x - half, x + half):
                ax.plot(t, edge, color=SOLE, lw=0.7, zorder=0.6)
            if label != "_":
                ax.fill_between([], [], [], facecolor=SOLE_FILL, edgecolor=SOLE, lw=0.7, label=label)
            edges += [x - half, x + half]
            label = "_"
    if edges:
        ax.set_ylim(*limits(*edges))


def velocities(ax: Axes, trace: Trace, rows: slice) -> None:
    """Planned, desired and measured forward velocity [m/s]."""
    t, desired, planned = trace.t[rows], trace.v_des[rows, 0], trace.v_plan[rows, 0]
    measured = trace.forward_velocity()[rows]
    ax.step(t, planned, where="post", color=PLANNED, lw=2.2, zorder=2, label="planned")
    ax.plot(t, measured, color=COM, lw=1.2, zorder=3, label="COM, measured")
    ax.plot(t, desired, color=DESIRED, lw=1.4, ls=DASHES, zorder=4, label="desired")
    reach = max(np.abs(planned).max(), 0.1)  # a fall's last instants would flatten all the rest
    ends = planned.min() - reach, planned.max() + reach
    ax.set_ylim(*limits(*(np.clip(values, *ends) for values in (desired, measured, planned))))


def zmp_and_com(
    ax: Axes, trace: Trace, rows: slice, i: int, origin: np.ndarray | None = None, unit: float = 1.0
) -> None:
    """The three ZMPs with their bounds and the COM, forward (`i` 0) or lateral (1).

    With an `origin` (T,) the ZMPs alone, from there, times `unit`.
    """
    t = trace.t[rows]
    off = np.zeros(len(t)) if origin is None else origin[rows]
    low, high, desired, estimated, measured = (
        unit * (trace[name][rows, i] - off) for name in ("zmp_lower", "zmp_upper", "zmp_des", "zmp_est", "zmp_meas")
    )
    for bound, label in ((low, "ZMP bounds"), (high, "_")):
        ax.step(t, bound, where="post", color=BOUND, lw=1.3, zorder=1.5, label=label)
    measured = np.where(t < walked_until(trace), measured, np.nan)  # of a robot that lies down it says nothing
    drawn = [low, high, desired]
    if origin is None:
        drawn.append(trace.com[rows, i])
        ax.plot(t, drawn[-1], color=COM, lw=1.4, zorder=5, label="COM")
    bottom, top = limits(*drawn)
    if ax.get_autoscaley_on() is False:  # the soles are there already
        bottom, top = min(bottom, ax.get_ylim()[0]), max(top, ax.get_ylim()[1])
    is_cut = np.nanmax(measured, initial=bottom) > top or np.nanmin(measured, initial=top) < bottom
    cut = " (spikes cut)" if is_cut and origin is None else ""
    if is_cut and origin is not None:
        ax.set_ylabel(f"{ax.get_ylabel()},\nspikes cut")
    ax.plot(t, measured, color=MEASURED_BAND, lw=4.0, zorder=2, solid_capstyle="butt", label=f"measured ZMP{cut}")
    ax.plot(t, estimated, color=ESTIMATED, lw=1.6, zorder=3, label="estimated ZMP")
    ax.plot(t, desired, color=DESIRED, lw=1.4, ls=DOTS, zorder=4, label="desired ZMP")
    ax.set_ylim(bottom, top)


def limits(*values: np.ndarray) -> tuple[float, float]:
    """Ends of an axis that shows all finite values with a margin."""
    finite = np.concatenate([np.asarray(v)[np.isfinite(v)] for v in values])
    if not len(finite):
        return -1.0, 1.0
    low, high = float(finite.min()), float(finite.max())
    margin = 0.06 * (high - low) or 0.01
    return low - margin, high + margin
