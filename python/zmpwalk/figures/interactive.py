"""A walk, or several, in a figure to zoom into: with Plotly, for a browser or a notebook."""

from __future__ import annotations

from typing import Any, List, Mapping, Sequence, Tuple

import numpy as np

from ..errors import InputError, needed
from ..trace import Trace
from .compare import COMPARED, QUANTITIES, label_of, values_of
from .curves import end_of
from .style import BOUND, COM, DESIRED, ESTIMATED, MEASURED, PLANNED, SERIES

MOST = 8000  # points of a line; a longer walk shows every second row, or third, ...
HEIGHT = 210  # of a panel [pixels]
THIN, THICK = 1.0, 1.8  # of lines [pixels]

Line = Tuple[str, np.ndarray, str, float, str]  # name, values, colour, width [pixels], dash
Panel = Tuple[str, List[Tuple[Trace, Line]]]  # label, and lines with the walk that each is of


def interactive(
    traces: Trace | Mapping[str, Trace],
    quantities: Sequence[str] = COMPARED,
    start: float | None = None,
    end: float | None = None,
) -> Any:
    """A walk over time to zoom into, or several over one another: what the mouse points at is said in numbers.

    Of one walk it shows velocity, COM and ZMP forward and sideways, the error of the estimate and the torque. All
    panels zoom together, and a click on a name hides its line.

    Args:
        traces: a walk, or what each of several walks is called and its trace.
        quantities: a panel for each, of several walks; see `compare`.
        start, end: window [s]; None is the beginning, the end.

    Returns:
        A `plotly.graph_objects.Figure`, which a notebook shows; `write_html` writes it.

    Raises:
        ImportError: Plotly is not installed (the extra `interactive`).  InputError: no trace, nothing in the window,
        or a quantity that a trace does not have.

    Usage: `zmpwalk.plot.interactive(trace).write_html("walk.html")`
    """
    one = isinstance(traces, Trace)
    named: Mapping[str, Trace] = {"": traces} if isinstance(traces, Trace) else traces
    if not isinstance(named, Mapping) or not any(len(trace.t) for trace in named.values()):
        raise InputError('there is no trace to draw; give a trace, or a dict such as {"a": trace, "b": other}')
    low = min(float(trace.t[0]) for trace in named.values() if len(trace.t)) if start is None else start
    high = max(map(end_of, named.values())) if end is None else end
    if not low < high:
        raise InputError(f"nothing to draw from {low:g} to {high:g} s")
    panels = _panels_of_one(named[""]) if one else _panels_of_several(named, quantities)
    graph, subplots = (
        needed(f"plotly.{part}", "an interactive figure", "plotly") for part in ("graph_objects", "subplots")
    )
    figure = subplots.make_subplots(rows=len(panels), shared_xaxes=True, vertical_spacing=0.03)
    known: set[str] = set()
    for row, (label, lines) in enumerate(panels, 1):
        for trace, (name, values, colour, width, dash) in lines:
            rows = slice(*np.searchsorted(trace.t, (low - 1e-9, high + 1e-9)))
            t = trace.t[rows]
            step = max(1, -(-len(t) // MOST))
            line = {"color": colour, "width": width, "dash": dash}
            look = {"name": name, "legendgroup": name, "showlegend": name not in known, "line": line}
            shown = graph.Scattergl(x=t[::step], y=values[rows][::step], mode="lines", hovertemplate="%{y:.5g}", **look)
            figure.add_trace(shown, row=row, col=1)
            known.add(name)
        figure.update_yaxes(title_text=label.replace("\n", "<br>"), row=row, col=1)
        if label == QUANTITIES["estimate"]:
            figure.update_yaxes(type="log", row=row, col=1)
    figure.update_xaxes(title_text="time [s]", row=len(panels), col=1)
    figure.update_layout(
        height=HEIGHT * len(panels) + 90,
        hovermode="x unified",
        template="plotly_white",
        legend={"orientation": "h", "y": 1.0, "yanchor": "bottom"},
        margin={"l": 80, "r": 20, "t": 60, "b": 50},
    )
    return figure


def _panels_of_one(trace: Trace) -> list[Panel]:
    """Labels and lines of the panels of one walk."""

    def zmp_and_com(i: int) -> list[Line]:
        return [
            ("ZMP bounds", trace.zmp_lower[:, i], BOUND, THIN, "solid"),
            ("ZMP bounds", trace.zmp_upper[:, i], BOUND, THIN, "solid"),
            ("COM", trace.com[:, i], COM, THICK, "solid"),
            ("measured ZMP", trace.zmp_meas[:, i], MEASURED, THICK, "solid"),
            ("estimated ZMP", trace.zmp_est[:, i], ESTIMATED, THIN, "solid"),
            ("desired ZMP", trace.zmp_des[:, i], DESIRED, THIN, "dot"),
        ]

    velocity = [
        ("planned", trace.v_plan[:, 0], PLANNED, THICK, "solid"),
        ("COM", trace.forward_velocity(), COM, THIN, "solid"),
        ("desired", trace.v_des[:, 0], DESIRED, THIN, "dash"),
    ]
    error = [("|estimated − measured ZMP|", values_of(trace, "estimate", ""), ESTIMATED, THIN, "solid")]
    torque = [("largest torque", values_of(trace, "torque", ""), DESIRED, THIN, "solid")]
    panels = {
        QUANTITIES["velocity"]: velocity, "forward\n[m]": zmp_and_com(0), "leftward\n[m]": zmp_and_com(1),
        QUANTITIES["estimate"]: error, QUANTITIES["torque"]: torque,
    }  # fmt: skip
    return [(label, [(trace, line) for line in lines]) for label, lines in panels.items()]


def _panels_of_several(traces: Mapping[str, Trace], quantities: Sequence[str]) -> list[Panel]:
    names = [quantities] if isinstance(quantities, str) else list(quantities)
    panels = []
    for name in names:
        lines = [
            (trace, (label, values_of(trace, name, label), SERIES[i % len(SERIES)], THICK, "solid"))
            for i, (label, trace) in enumerate(traces.items())
        ]
        panels.append((QUANTITIES.get(name) or label_of(name), lines))
    return panels
