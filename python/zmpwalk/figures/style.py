"""How every figure looks: colours, sizes, legends, titles."""

from __future__ import annotations

import functools
import io
from typing import Any, Callable

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from ..errors import InputError

# Okabe and Ito's palette, which colour-blind readers can tell apart.
COM, DESIRED, ESTIMATED, MEASURED, PLANNED = "black", "#0072B2", "#D55E00", "#009E73", "#E69F00"
BOUND, SOLE, RIGHT_SOLE, DOUBLE_SUPPORT, FAINT = "#56B4E9", "#8C6239", "#CC79A7", "#BBBBBB", "#777777"
SOLE_FILL, MEASURED_BAND = "#F1EAE3", "#8FD0BA"  # SOLE and MEASURED, made light: nothing shines through anything
PUSH = "#9A0794"  # of forces from outside
SERIES = (DESIRED, ESTIMATED, MEASURED, RIGHT_SOLE, PLANNED, SOLE)  # of traces that are compared
SERIES_DASHES: tuple[Any, ...] = ("-", (0, (5, 1.5)), (0, (2, 1)), (0, (6, 1.5, 1, 1.5)))
DOTS = (0, (1.2, 2.4))  # of the desired ZMP, on the estimated one
DASHES = (0, (4, 4))  # of what is desired: the line under it shows through

STYLE: Any = {
    "font.size": 9, "axes.labelsize": 9, "xtick.labelsize": 8, "ytick.labelsize": 8, "legend.fontsize": 8,
    "axes.spines.top": False, "axes.spines.right": False, "axes.linewidth": 0.7, "lines.linewidth": 1.2,
    "xtick.major.width": 0.7, "ytick.major.width": 0.7, "legend.frameon": False, "legend.handlelength": 1.8,
    "legend.columnspacing": 1.4, "savefig.dpi": 150, "figure.dpi": 100, "pdf.fonttype": 42,
}  # fmt: skip
WIDTH = 7.2  # of a figure [in]: two columns of a paper


class WalkFigure(Figure):
    """A Figure that shows itself in a notebook even where no plotting backend was chosen."""

    def _repr_png_(self) -> bytes:
        buffer = io.BytesIO()
        self.savefig(buffer, format="png", dpi=110)
        return buffer.getvalue()


def styled(draw: Callable[..., Figure]) -> Callable[..., Figure]:
    """The same drawing function under `STYLE`; it takes `ax` as well as `axes`."""

    @functools.wraps(draw)
    def styled(*arguments: Any, **options: Any) -> Figure:
        if "ax" in options:
            if options.get("axes") is not None:
                raise InputError("give ax or axes, not both")
            options["axes"] = options.pop("ax")
        with matplotlib.rc_context(STYLE):
            return draw(*arguments, **options)

    return styled


def new_figure(
    axes: Any,
    rows: int,
    columns: int,
    height: float,
    ratios: tuple[float, ...] = (),
    widths: tuple[float, ...] = (),
    sharey: bool = False,
) -> tuple[Figure, list[Axes]]:
    """The given axes and their figure, or new ones row by row; those one under the other share x.

    Args:
        axes: one Axes, several in any nesting, or None.
        height: of a new figure [in].
        ratios: of the heights of its rows.
        widths: of its columns.
        sharey: those side by side share y.
    """
    if axes is not None:
        flat = given_axes(axes, rows * columns)
        owner: Any = flat[0].figure
        return owner, flat
    figure = WalkFigure(figsize=(WIDTH, height), layout="constrained")
    FigureCanvasAgg(figure)
    share: Any = "col" if columns == 1 or rows > 1 else False
    grid: Any = {"height_ratios": ratios} if ratios else {}
    if widths:
        grid["width_ratios"] = widths
    made = figure.subplots(
        rows, columns, sharex=share, sharey="row" if sharey else False, squeeze=False, gridspec_kw=grid or None
    )
    return figure, list(made.ravel())


def given_axes(axes: Any, count: int) -> list[Axes]:
    """The axes that a caller gave, one after the other.

    Raises:
        InputError: not `count` of them.
    """
    flat = list(np.atleast_1d(np.asarray(axes, dtype=object)).ravel())
    if len(flat) != count:
        raise InputError(f"this figure needs {count} axes, got {len(flat)}")
    return flat


def title(figure: Figure, axes: Any, text: str) -> None:
    """A title above a figure of its own; none where the caller gave the axes."""
    if axes is None:
        figure.suptitle(text, x=0.012, ha="left", fontsize=10, fontweight="bold")


def legend_above(ax: Axes, columns: int, skip: tuple[str, ...] = ()) -> None:
    """A legend over the axes, in so many columns, without the labels to `skip`."""
    known = [(handle, label) for handle, label in zip(*ax.get_legend_handles_labels()) if label not in skip]
    ax.legend(*zip(*known), loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=columns, borderaxespad=0.2)


def nothing_to_draw(figure: Figure, *axes: Axes, note: str) -> Figure:
    """The figure with a note in place of curves."""
    for ax in axes:
        ax.text(0.5, 0.5, note, ha="center", va="center", transform=ax.transAxes, color=FAINT)
        ax.set(xticks=[], yticks=[])
    return figure
