"""The paper's figures and the walk from above, each drawn from a Trace alone.

Every function takes a trace and returns a matplotlib Figure; a notebook shows it, `save_all` writes them all. Nothing
here touches pyplot, so no window opens and no global state is left behind.

Colours mean the same in every figure: black the centre of mass, blue what is desired, red what the controller
estimates, green what the simulator measures, orange what is planned; blue bands are ZMP bounds, grey ones double
support, brown ones soles on the ground (from above the right one is purple).
"""

from __future__ import annotations

import functools
import io
import math
import os
from pathlib import Path
from typing import Any, Callable

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import Polygon
from matplotlib.patheffects import withStroke
from matplotlib.ticker import MaxNLocator

from .analysis import feet_pose, planned_path, sole_yaw
from .errors import InputError
from .trace import Trace

__all__ = ["FIGURES", "footprints", "iteration", "lateral", "sagittal", "save_all", "switch", "tracking", "velocity"]

# Okabe and Ito's palette, which colour-blind readers can tell apart.
COM, DESIRED, ESTIMATED, MEASURED, PLANNED = "black", "#0072B2", "#D55E00", "#009E73", "#E69F00"
BOUND, SOLE, RIGHT_SOLE, DOUBLE_SUPPORT, FAINT = "#56B4E9", "#8C6239", "#CC79A7", "#000000", "#777777"
DASHES = (0, (4, 4))  # of what is desired: the line under it shows through

STYLE: Any = {
    "font.size": 9, "axes.labelsize": 9, "xtick.labelsize": 8, "ytick.labelsize": 8, "legend.fontsize": 8,
    "axes.spines.top": False, "axes.spines.right": False, "axes.linewidth": 0.7, "lines.linewidth": 1.2,
    "xtick.major.width": 0.7, "ytick.major.width": 0.7, "legend.frameon": False, "legend.handlelength": 1.8,
    "legend.columnspacing": 1.4, "savefig.dpi": 150, "figure.dpi": 100,
}  # fmt: skip
WIDTH = 7.2  # of a figure [in]: two columns of a paper
MOST_PASSES = 200  # of an iteration that are drawn
LONGEST = 10.0  # of a walk that is drawn unless asked for more [s]


class WalkFigure(Figure):
    """A Figure that shows itself in a notebook even where no plotting backend was chosen."""

    def _repr_png_(self) -> bytes:
        buffer = io.BytesIO()
        self.savefig(buffer, format="png", dpi=110)
        return buffer.getvalue()


def _styled(draw: Callable[..., Figure]) -> Callable[..., Figure]:
    @functools.wraps(draw)
    def styled(*arguments: Any, **options: Any) -> Figure:
        with matplotlib.rc_context(STYLE):
            return draw(*arguments, **options)

    return styled


# --- the figures


@_styled
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
    figure, (left, right) = _figure(axes, 1, 2, height=3.1)
    k = _largest_first_error(trace, start, end, i) if cycle is None else cycle
    if k is None or not -len(trace.t) <= k < len(trace.t):
        if cycle is not None:
            raise InputError(f"cycle {cycle} is outside the walk, which has {len(trace.t)}")
        return _nothing(figure, left, right, note="no cycle with an estimate in this window")
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
    left.axhspan(desired - threshold, desired + threshold, color=DESIRED, alpha=0.15, lw=0, label=band)
    left.axhline(desired, color=DESIRED, label="desired ZMP")
    if np.ptp(reference) < 3 * np.ptp(desired - error):  # of slow iterations it goes metres away
        square = "s" if marker else ""
        left.plot(n + 1, reference, color=FAINT, ls=":", marker=square, ms=3, label="pendulum's reference (16)")
    left.plot(n + 1, desired - error, color=ESTIMATED, marker=marker, ms=4, label="estimated ZMP")
    left.set(xlabel="pass", ylabel=f"{_NAMES[i]} ZMP from support sole [mm]")
    _legend_above(left, 2)

    right.axhline(threshold, color=DESIRED, ls="--", label=f"threshold {threshold:g} mm")
    right.semilogy(
        n + 1, np.abs(error), color=ESTIMATED, marker=marker, ms=4, label=f"× {abs(contraction):.3g} per pass"
    )
    right.set(xlabel="pass", ylabel="|desired − estimated ZMP| [mm]")
    right.set_ylim(bottom=max(np.abs(error).min() / 2, threshold * 1e-6))
    _legend_above(right, 2)
    for ax in (left, right):
        ax.xaxis.set_major_locator(MaxNLocator(6, integer=True))
        ax.set_xlim(1 - 0.04 * len(n), len(n) + 0.04 * len(n))
    passes = "1 pass" if needed == 1 else f"{needed} passes" if needed < MOST_PASSES else f"over {MOST_PASSES} passes"
    _title(figure, axes, f"ZMP iteration at t = {trace.t[k]:.3f} s: {passes} to the threshold")
    return figure


@_styled
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
    if (start, end) == (0.7, 1.2) and _end(trace) < 1.2:  # a walk that ended before the paper's window
        start, end = max(0.0, _end(trace) - 0.5), None
    rows = _window(trace, start, end)
    t = trace.t[rows]
    figure, (a, b, c) = _figure(axes, 3, 1, height=6.4, ratios=(1.6, 1.1, 0.9))
    for ax in (a, b, c):
        _double_support(ax, trace, rows)
        _plan_changes(ax, trace, rows)
    _zmp_and_com(a, trace, rows, 0)
    a.set_ylabel("(a) position, forward [m]")
    _legend_above(a, 4)
    _velocities(b, trace, rows)
    b.set_ylabel("(b) velocity [m/s]")
    _legend_above(b, 4, skip=("double support", "plan changes"))
    integral = 1e3 * trace.v_error_integral[rows, 0]
    c.axhline(0, color=FAINT, lw=0.6)
    c.fill_between(t, 0, integral, color=DESIRED, alpha=0.2, lw=0)
    c.plot(t, integral, color=DESIRED, label="integral of desired − planned velocity")
    c.set(ylabel="(c) integral [mm]", xlabel="time [s]")
    _legend_above(c, 4, skip=("double support", "plan changes"))
    _share_time(trace, rows, a, b, c)
    figure.align_ylabels([a, b, c])
    _title(figure, axes, "Following the planned velocity by moving the ZMP")
    return figure


@_styled
def switch(trace: Trace, step: int = 0, axes: Any = None) -> Figure:
    """Fig. 5: the lateral velocity that (18) expects in the middle of the next single support, while support may
    still switch.

    Where it reaches zero the ZMP goes from one foot to the other. Positive is towards the foot being left, so that
    the curves of left and right steps lie on one another.

    Args:
        trace: a walk.
        step: double support to show, 0 the first; all others are drawn faintly.
        axes: one Axes to draw on, or None for a figure of its own.

    Returns:
        The figure.

    Raises:
        InputError: the walk has no such double support.

    Usage: `trace.plot("switch", step=3)`
    """
    figure, (ax,) = _figure(axes, 1, 1, height=3.3)
    supports = _double_supports(trace)
    if not supports:
        return _nothing(figure, ax, note="no double support in this walk")
    if not -len(supports) <= step < len(supports):
        raise InputError(f"double support {step}: this walk has {len(supports)}, counted from 0")
    step = step % len(supports)
    shown = [n for n in range(len(supports)) if n != step] + [step]
    for n in shown:
        rows = supports[n]
        since = 1e3 * (trace.t[rows] - trace.t[rows.start])
        w = trace.w_T[rows] * trace.support[rows.start]
        chosen = n == step
        others = f"the other {len(shown) - 1} double supports" if n == shown[0] and not chosen else None
        ordinal = "first double support" if step == 0 else f"double support {step}"
        faint: dict[str, Any] = {"color": FAINT, "lw": 0.7, "alpha": 0.6}
        look = {"color": ESTIMATED, "lw": 2.0, "zorder": 3} if chosen else faint
        ax.plot(since, w, label=ordinal if chosen else others, **look)
        if not chosen:
            continue
        changed = np.flatnonzero(np.diff(trace.support[rows]))
        ax.axvline(since[-1] + 1e3 * trace.control_dt, color=FAINT, ls=":", lw=1.0, label="double support ends")
        if len(changed):
            moment = since[changed[0] + 1]
            ax.axvline(moment, color=DESIRED, ls="--", lw=1.2, label=f"ZMP switches at {1e-3 * moment:.3f} s")
    ax.axhline(0, color=FAINT, lw=0.6)
    ax.set(xlabel="time in double support [ms]", ylabel="w(T) towards the foot being left [m/s]")
    ax.set_xlim(left=0)
    _legend_above(ax, 2)
    _title(figure, axes, "Expected lateral velocity at the middle of the next single support")
    return figure


@_styled
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
    rows = _window(trace, start, end, LONGEST)
    figure, (ax,) = _figure(axes, 1, 1, height=3.2)
    _double_support(ax, trace, rows)
    _velocities(ax, trace, rows)
    ax.set(xlabel="time [s]", ylabel="forward velocity [m/s]")
    _share_time(trace, rows, ax)
    _legend_above(ax, 4)
    _title(figure, axes, "Velocity of the centre of mass, forward" + _excerpt(trace, rows))
    return figure


@_styled
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
    rows = _window(trace, start, end, LONGEST)
    figure, (world, sole) = _figure(axes, 2, 1, height=5.6, ratios=(1.5, 1.0))
    for ax in (world, sole):
        _double_support(ax, trace, rows)
    _soles(world, trace, rows, 0)
    _zmp_and_com(world, trace, rows, 0)
    world.set_ylabel("position, forward [m]")
    _legend_above(world, 4)
    centre = np.where(trace.support > 0, trace.foot_left[:, 0], trace.foot_right[:, 0])
    centre[trace.phase == 0] = np.nan  # two soles
    _zmp_and_com(sole, trace, rows, 0, centre, unit=1e3)
    sole.set(xlabel="time [s]", ylabel="ZMP from support sole [mm]")
    _share_time(trace, rows, world, sole)
    figure.align_ylabels([world, sole])
    _title(figure, axes, "COM and ZMP, forward" + _excerpt(trace, rows))
    return figure


@_styled
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
    rows = _window(trace, start, end, LONGEST)
    figure, (ax,) = _figure(axes, 1, 1, height=3.9)
    _double_support(ax, trace, rows)
    _soles(ax, trace, rows, 1)
    _zmp_and_com(ax, trace, rows, 1)
    ax.set(xlabel="time [s]", ylabel="position, leftward [m]")
    _share_time(trace, rows, ax)
    _legend_above(ax, 4)
    _title(figure, axes, "COM and ZMP, sideways" + _excerpt(trace, rows))
    return figure


@_styled
def footprints(trace: Trace, start: float | None = None, end: float | None = None, axes: Any = None) -> Figure:
    """The walk from above: every place where a sole stood, COM, ZMP, and where the commands lead [m].

    An arrow at each touch-down goes from the middle of the feet along their mean heading.

    Args:
        trace: a walk.
        start, end: window [s]; None is the walk's start, its end.
        axes: one Axes to draw on, or None for a figure of its own.

    Returns:
        The figure.

    Raises:
        InputError: `start` is not before `end`.

    Usage: `trace.plot("footprints")`
    """
    rows = _window(trace, start, end)
    planned, com = planned_path(trace)[rows], trace.com[rows]
    prints = {side: _prints(trace, rows, side) for side in (0, 1)}
    everything = np.vstack([planned[:, :2], com[:, :2], *(p for corners in prints.values() for p in corners)])
    low, high = everything.min(axis=0), everything.max(axis=0)
    margin = 0.04 * max(high - low)
    width, height = high - low + 2 * margin
    figure, (ax,) = _figure(axes, 1, 1, height=min(max(0.9 * WIDTH * height / width + 1.3, 2.6), WIDTH))
    for side, (name, color) in enumerate((("left", SOLE), ("right", RIGHT_SOLE))):
        for n, corners in enumerate(prints[side]):
            label = f"{name} sole" if n == 0 else None
            ax.add_patch(Polygon(corners, closed=True, facecolor=color, alpha=0.25, lw=0, zorder=1, label=label))
            ax.add_patch(Polygon(corners, closed=True, fill=False, edgecolor=color, lw=0.7, zorder=1.5))
    ax.plot(*planned[:, :2].T, color=PLANNED, lw=2.2, zorder=2, label="where the commands lead")
    ax.plot(*trace.zmp_meas[rows].T, color=MEASURED, lw=0.8, alpha=0.8, zorder=3, label="measured ZMP")
    ax.plot(*com[:, :2].T, color=COM, lw=1.4, zorder=4, label="COM")
    landed = np.flatnonzero(np.diff(trace.phase[rows]) < 0) + 1 + rows.start
    x, y, yaw = feet_pose(trace.foot_left[landed], trace.foot_right[landed]).T
    size = 0.15 * float(com[0, 2])
    arrow: dict[str, Any] = {"angles": "xy", "scale_units": "xy", "scale": 1, "width": 0.003, "zorder": 5}
    ax.quiver(x, y, size * np.cos(yaw), size * np.sin(yaw), color=DESIRED, label="heading", **arrow)
    for k, word in ((0, "start"), (-1, "end")):
        ax.plot(*com[k, :2], color=COM, marker="o", ms=4, zorder=6)
        text = f"{word}, {trace.t[rows][k]:.3g} s"
        x_k, y_k = com[k, :2].tolist()
        word_k = ax.annotate(text, (x_k, y_k), (0, -12), textcoords="offset points", ha="center", fontsize=8, zorder=7)
        word_k.set_path_effects([withStroke(linewidth=2.5, foreground="white")])
    ax.set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
    ax.set(xlim=(low[0] - margin, high[0] + margin), ylim=(low[1] - margin, high[1] + margin))
    _legend_above(ax, 3)
    _title(figure, axes, "The walk from above" + _excerpt(trace, rows))
    return figure


def _prints(trace: Trace, rows: slice, side: int) -> list[np.ndarray]:
    """Corners (4, 2) of a sole [m], once for each time it stood."""
    name = ("left", "right")[side]
    foot = trace.meta.get("description", {}).get(name, {})
    half_length, half_width = foot.get("length", 0.0) / 2, foot.get("width", 0.0) / 2
    poses, corners = trace[f"foot_{name}"][rows], []
    for span in _spans((trace.phase[rows] == 0) | ((trace.support[rows] > 0) == (side == 0))):
        pose = poses[(span.start + span.stop) // 2]
        c, s = np.cos(sole_yaw(pose)), np.sin(sole_yaw(pose))
        box = np.array([(1, 1), (-1, 1), (-1, -1), (1, -1)]) * (half_length, half_width)
        corners.append(pose[:2] + box @ np.array([(c, s), (-s, c)]))
    return corners


FIGURES: dict[str, Callable[..., Figure]] = {
    "iteration": iteration,
    "tracking": tracking,
    "switch": switch,
    "velocity": velocity,
    "sagittal": sagittal,
    "lateral": lateral,
    "footprints": footprints,
}
FILES = {name: f"fig{number}_{name}" for name, number in zip(FIGURES, (2, 4, 5, 6, 7, 8))}
FILES["footprints"] = "footprints"


def figure_function(name: str) -> Callable[..., Figure]:
    """The function that draws a figure.

    Args:
        name: a key of `FIGURES`, or the name of its file ("fig2_iteration").

    Raises:
        InputError: no such figure; names those that exist.

    Usage: `figure_function("lateral")(trace)`
    """
    for known, file in FILES.items():
        if name in (known, file):
            return FIGURES[known]
    raise InputError(f"no figure '{name}'; there are {', '.join(FIGURES)}, and all")


def save_all(
    trace: Trace, folder: str | os.PathLike, names: list[str] | None = None, format: str = "png", dpi: int = 150
) -> list[Path]:
    """Write the figures into a folder, each whole or not at all.

    Args:
        trace: a walk.
        folder: made if it does not exist.
        names: which; None is all of them.
        format: "png", "pdf" or "svg".
        dpi: dots per inch of a png.

    Returns:
        The files: fig2_iteration.png, fig4_tracking.png, fig5_switch.png, fig6_velocity.png, fig7_sagittal.png,
        fig8_lateral.png, footprints.png.

    Raises:
        InputError: no figure of that name.  OSError: the folder cannot be written.

    Usage: `zmpwalk.plot.save_all(trace, "out", format="pdf")`
    """
    functions = [figure_function(name) for name in (names or FIGURES)]
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    for draw in functions:
        path = folder / f"{FILES[draw.__name__]}.{format}"
        draft = path.with_name(f".{path.stem}.{os.getpid()}.{format}")
        try:
            draw(trace).savefig(draft, format=format, dpi=dpi)
            os.replace(draft, path)
        finally:
            if draft.exists():
                draft.unlink()
        paths.append(path)
    return paths


# --- what they share

_NAMES = ("forward", "lateral")


def _figure(
    axes: Any, rows: int, columns: int, height: float, ratios: tuple[float, ...] = ()
) -> tuple[Figure, list[Axes]]:
    """The given axes and their figure, or new ones one under the other."""
    if axes is not None:
        flat = list(np.atleast_1d(np.asarray(axes, dtype=object)).ravel())
        if len(flat) != rows * columns:
            raise InputError(f"this figure needs {rows * columns} axes, got {len(flat)}")
        return flat[0].figure, flat
    figure = WalkFigure(figsize=(WIDTH, height), layout="constrained")
    FigureCanvasAgg(figure)
    share: Any = "col" if columns == 1 else False
    grid = figure.subplots(
        rows, columns, sharex=share, squeeze=False, gridspec_kw={"height_ratios": ratios} if ratios else None
    )
    return figure, list(grid.ravel())


def _axis(axis: str) -> int:
    if axis not in ("x", "y"):
        raise InputError(f"axis is {axis!r}; it is 'x' (forward) or 'y' (lateral)")
    return "xy".index(axis)


def _end(trace: Trace) -> float:
    return float(trace.t[-1]) if len(trace.t) else 0.0


def _window(trace: Trace, start: float | None, end: float | None, longest: float = math.inf) -> slice:
    """Rows from `start` to `end` [s]; with neither, at most `longest`: the beginning, or a fall's end."""
    if len(trace.t) < 2:
        raise InputError("this walk has fewer than two cycles: there is nothing to draw")
    if start is None and end is None and trace.duration > longest:
        start, end = (_end(trace) - longest, None) if trace.meta.get("fell") else (None, trace.t[0] + longest)
    low = int(np.searchsorted(trace.t, -math.inf if start is None else start - 1e-9))
    high = int(np.searchsorted(trace.t, math.inf if end is None else end + 1e-9))
    if high - low < 2:
        raise InputError(
            f"nothing to draw from {start} to {end} s: the walk goes from {trace.t[0]:g} to {_end(trace):g} s"
        )
    return slice(low, high)


def _excerpt(trace: Trace, rows: slice) -> str:
    t = trace.t[rows]
    whole = len(t) == len(trace.t)
    return "" if whole else f" ({t[0]:.3g} to {t[-1]:.3g} s of {trace.duration:g} s)"


def _title(figure: Figure, axes: Any, text: str) -> None:
    if axes is None:
        figure.suptitle(text, x=0.012, ha="left", fontsize=10, fontweight="bold")


def _legend_above(ax: Axes, columns: int, skip: tuple[str, ...] = ()) -> None:
    known = [(handle, label) for handle, label in zip(*ax.get_legend_handles_labels()) if label not in skip]
    ax.legend(*zip(*known), loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=columns, borderaxespad=0.2)


def _share_time(trace: Trace, rows: slice, *axes: Axes) -> None:
    for ax in axes:
        ax.set_xlim(trace.t[rows][0], trace.t[rows][-1] + trace.control_dt)


def _spans(mask: np.ndarray) -> list[slice]:
    """Runs of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(int)))
    return [slice(int(a), int(b)) for a, b in zip(edges[::2], edges[1::2])]


def _double_supports(trace: Trace) -> list[slice]:
    return _spans(trace.phase == 0)


def _double_support(ax: Axes, trace: Trace, rows: slice) -> None:
    """Faint bands where both feet are down."""
    t, label = trace.t[rows], "double support"
    for span in _spans(trace.phase[rows] == 0):
        ax.axvspan(
            t[span.start],
            t[span.stop - 1] + trace.control_dt,
            color=DOUBLE_SUPPORT,
            alpha=0.07,
            lw=0,
            zorder=0,
            label=label,
        )
        label = "_"


def _plan_changes(ax: Axes, trace: Trace, rows: slice) -> None:
    """Dotted lines where the planned velocity steps, if that is seldom."""
    plan, label = trace.v_plan[rows, 0], "plan changes"
    changes = np.flatnonzero(np.abs(np.diff(plan)) > 1e-9) + 1
    for k in changes if len(changes) <= 6 else ():
        ax.axvline(trace.t[rows][k], color=PLANNED, ls=":", lw=1.4, zorder=1, label=label)
        label = "_"


def _soles(ax: Axes, trace: Trace, rows: slice, i: int) -> None:
    """Where each sole lies while it carries weight, from its size in the description."""
    label, edges = "soles on the ground", []
    for side, name in enumerate(("left", "right")):
        foot = trace.meta.get("description", {}).get(name, {})
        if "length" not in foot:
            continue
        half = foot["length" if i == 0 else "width"] / 2
        place = trace[f"foot_{name}"][rows, i]
        down = (trace.phase[rows] == 0) | ((trace.support[rows] > 0) == (side == 0))
        for span in _spans(down):
            t, x = trace.t[rows][span], place[span]
            ax.fill_between(t, x - half, x + half, facecolor=SOLE, alpha=0.18, lw=0, zorder=0.5, label=label)
            for edge in (x - half, x + half):
                ax.plot(t, edge, color=SOLE, lw=0.7, zorder=0.6)
            edges += [x - half, x + half]
            label = "_"
    if edges:
        ax.set_ylim(*_range(*edges))


def _velocities(ax: Axes, trace: Trace, rows: slice) -> None:
    """Planned, desired and measured forward velocity [m/s]."""
    t, desired, planned = trace.t[rows], trace.v_des[rows, 0], trace.v_plan[rows, 0]
    measured = trace.forward_velocity()[rows]
    ax.step(t, planned, where="post", color=PLANNED, lw=2.2, zorder=2, label="planned")
    ax.plot(t, measured, color=COM, lw=1.2, zorder=3, label="COM, measured")
    ax.plot(t, desired, color=DESIRED, lw=1.4, ls=DASHES, zorder=4, label="desired")
    reach = max(np.abs(planned).max(), 0.1)  # a fall's last instants would flatten all the rest
    ends = planned.min() - reach, planned.max() + reach
    ax.set_ylim(*_range(*(np.clip(values, *ends) for values in (desired, measured, planned))))


def _zmp_and_com(
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
    ax.fill_between(t, low, high, step="post", facecolor=BOUND, alpha=0.25, lw=0, zorder=1, label="ZMP bounds")
    for bound in (low, high):
        ax.step(t, bound, where="post", color=BOUND, lw=0.7, zorder=1.5)
    drawn = [low, high, desired]
    if origin is None:
        drawn.append(trace.com[rows, i])
        ax.plot(t, drawn[-1], color=COM, lw=1.4, zorder=5, label="COM")
    bottom, top = _range(*drawn)
    if ax.get_autoscaley_on() is False:  # the soles are there already
        bottom, top = min(bottom, ax.get_ylim()[0]), max(top, ax.get_ylim()[1])
    cut = (
        " (spikes cut)"
        if np.nanmax(measured, initial=bottom) > top or np.nanmin(measured, initial=top) < bottom
        else ""
    )
    ax.plot(t, measured, color=MEASURED, lw=3.0, alpha=0.6, zorder=2, solid_capstyle="butt", label=f"measured ZMP{cut}")
    ax.plot(t, estimated, color=ESTIMATED, lw=1.2, zorder=3, label="estimated ZMP")
    ax.plot(t, desired, color=DESIRED, lw=1.4, ls=DASHES, zorder=4, label="desired ZMP")
    ax.set_ylim(bottom, top)


def _range(*values: np.ndarray) -> tuple[float, float]:
    finite = np.concatenate([np.asarray(v)[np.isfinite(v)] for v in values])
    if not len(finite):
        return -1.0, 1.0
    low, high = float(finite.min()), float(finite.max())
    margin = 0.06 * (high - low) or 0.01
    return low - margin, high + margin


def _largest_first_error(trace: Trace, start: float | None, end: float | None, i: int) -> int | None:
    rows = _window(trace, start, end)
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


def _nothing(figure: Figure, *axes: Axes, note: str) -> Figure:
    for ax in axes:
        ax.text(0.5, 0.5, note, ha="center", va="center", transform=ax.transAxes, color=FAINT)
        ax.set(xticks=[], yticks=[])
    return figure
