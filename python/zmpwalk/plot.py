"""Draws how true the estimate was, the paper's figures and the walk from above, each from a Trace alone.

Every function takes a trace and returns a matplotlib Figure; a notebook shows it, `save_all` writes them all. What the
colours mean, and the drawing itself, is in `zmpwalk.figures`. Every one draws on axes of yours, `ax=` or `axes=`, and
`compare` draws several walks over one another.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Callable

from matplotlib.figure import Figure

from .errors import InputError
from .figures import FILES
from .figures.compare import COMPARED, compare
from .figures.estimate import estimate
from .figures.footprints import footprints
from .figures.interactive import interactive
from .figures.iteration import iteration
from .figures.position import lateral, sagittal
from .figures.pushes import pushes
from .figures.robustness import robustness
from .figures.style import (
    BOUND,
    COM,
    DESIRED,
    ESTIMATED,
    FAINT,
    MEASURED,
    PLANNED,
    RIGHT_SOLE,
    SOLE,
    STYLE,
    WIDTH,
    WalkFigure,
)
from .figures.sweep import sweep
from .figures.switch import switch
from .figures.velocity import tracking, velocity
from .files import whole
from .trace import Trace

__all__ = [
    "BOUND",
    "COM",
    "COMPARED",
    "DESIRED",
    "ESTIMATED",
    "FAINT",
    "FIGURES",
    "FILES",
    "MEASURED",
    "PLANNED",
    "RIGHT_SOLE",
    "SOLE",
    "STYLE",
    "WIDTH",
    "WalkFigure",
    "compare",
    "draw",
    "estimate",
    "figure_function",
    "footprints",
    "interactive",
    "iteration",
    "lateral",
    "pushes",
    "robustness",
    "sagittal",
    "save_all",
    "sweep",
    "switch",
    "tracking",
    "velocity",
]

FIGURES: dict[str, Callable[..., Figure]] = {
    function.__name__: function
    for function in (estimate, iteration, tracking, switch, velocity, sagittal, lateral, footprints)
}


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


def draw(trace: Trace, figure: str = "all", **options: Any) -> Any:
    """See `Trace.plot`."""
    if figure == "all":
        return {name: function(trace, **options) for name, function in FIGURES.items()}
    return figure_function(figure)(trace, **options)


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
        The files: estimate.png, fig2_iteration.png, fig4_tracking.png, fig5_switch.png, fig6_velocity.png,
        fig7_sagittal.png, fig8_lateral.png, footprints.png.

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
        with whole(path) as draft:
            draw(trace).savefig(draft, format=format, dpi=dpi)
        paths.append(path)
    return paths
