"""Sliders for a notebook: move one, and the walk is walked again and drawn anew."""

from __future__ import annotations

import html
from typing import Any, Sequence, Union

import numpy as np

from . import plot
from .errors import Error, InputError, needed
from .figures.small import png
from .robots import Robot, load_robot
from .simulation import simulate
from .sweeps import arguments_of
from .trace import Trace

__all__ = ["Explorer", "explore"]

Range = Union[Sequence[float], Sequence[str]]
STEPS = 60  # that a slider has between its ends


class Explorer:
    """What `explore` returns: a notebook shows it as sliders above a picture.

    `trace` is the walk that the picture shows, and `values` says where the sliders stand.
    """

    trace: Trace | None
    """the walk of the picture; None where it could not begin"""

    def __init__(self, figure: str, duration: float, robot: Robot, ranges: dict[str, Range], common: dict[str, Any]):
        self._widgets = widgets = needed("ipywidgets", "explore", "ipywidgets")
        self._figure, self._draw = figure, plot.figure_function(figure)
        self._common = {**common, "robot": load_robot(robot), "duration": duration}
        self.sliders = {name: _slider(widgets, name, given) for name, given in ranges.items()}
        arguments_of({**self._common, **self.values})  # an unknown name is no matter of one walk
        self._picture, self._words = widgets.Image(format="png"), widgets.HTML()
        self.widget = widgets.VBox([*self.sliders.values(), self._words, self._picture])
        for slider in self.sliders.values():
            slider.observe(lambda change: self.walk(), "value")
        self.walk()

    @property
    def values(self) -> dict[str, Any]:
        """Where the sliders stand: arguments of `simulate`, settings and uncertainties by their names."""
        return {name: slider.value for name, slider in self.sliders.items()}

    def walk(self) -> None:
        """Walk with the values of the sliders, and draw that walk. A mistake is said below the sliders."""
        try:
            trace = simulate(**arguments_of({**self._common, **self.values}))
            self._picture.value = png(self._draw(trace))
            fall = trace.fall
            stood = "it stood" if fall is None or fall.time is None else f"it fell at {fall.time:.2f} s: {fall.cause}"
            self.trace, self._words.value = trace, html.escape(stood)
        except Error as mistake:
            self.trace, self._words.value = None, f"<b>{html.escape(str(mistake))}</b>"

    def __repr__(self) -> str:
        return f"Explorer({self._figure}; {', '.join(f'{name}={value!r}' for name, value in self.values.items())})"

    def _repr_mimebundle_(self, **options: Any) -> dict[str, Any]:
        """The sliders, and for a page that has none the picture as it stands."""
        live = dict(self.widget._repr_mimebundle_(**options) or {})
        return {**live, "text/plain": repr(self), "image/png": bytes(self._picture.value)}


def explore(
    figure: str = "velocity", duration: float = 6.0, robot: Robot = "mahru", common: dict[str, Any] | None = None,
    **ranges: Range,
) -> Explorer:  # fmt: skip
    """Sliders in a notebook that walk the robot again, in about a second, and draw the walk.

    Args:
        figure: estimate, iteration, tracking, switch, velocity, sagittal, lateral or footprints.
        duration: of each walk [s].
        robot: as for `load_robot`.
        common: arguments of `simulate`, settings or uncertainties that all walks share.
        ranges: a slider each, named as in a grid of `sweep`: an argument of `simulate`, a setting or an uncertainty.
            Two numbers are the ends of a slider; a longer list are the values to choose from. Without any there is one
            for the velocity, from 0 to 0.6 m/s.

    Returns:
        What a notebook shows; its `trace` is the walk of the picture.

    Raises:
        InputError: an unknown name or figure, or a range that is none.  ImportError: ipywidgets is not installed.

    Usage: `zmpwalk.explore("sagittal", profile=(0, 0.6), step_height=(0.02, 0.08))`
    """
    given: dict[str, Range] = dict(ranges) or {"profile": (0.0, 0.6)}
    return Explorer(figure, duration, robot, given, dict(common or {}))


def _slider(widgets: Any, name: str, given: Range) -> Any:
    style: Any = {"description": name, "style": {"description_width": "initial"}}
    values = list(given) if isinstance(given, (list, tuple, np.ndarray)) else []
    if len(values) > 2 or (len(values) == 2 and isinstance(values[0], str)):
        return widgets.SelectionSlider(options=values, continuous_update=False, **style)
    if len(values) != 2 or not all(isinstance(end, (int, float, np.number)) for end in values) or not (
        values[0] < values[1]
    ):  # fmt: skip
        raise InputError(
            f"the range of '{name}' is {given!r}; it must be two numbers, low and high, or a list of values"
        )
    if all(isinstance(end, (int, np.integer)) and not isinstance(end, bool) for end in values) and name == "seed":
        return widgets.IntSlider(value=values[0], min=values[0], max=values[1], continuous_update=False, **style)
    low, high = map(float, values)
    return widgets.FloatSlider(
        value=round(low + 0.4 * (high - low), 12), min=low, max=high, step=(high - low) / STEPS,
        readout_format=".3g", continuous_update=False, **style,
    )  # fmt: skip
