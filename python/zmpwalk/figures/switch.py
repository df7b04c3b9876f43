"""Fig. 5: when the ZMP goes from one foot to the other."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ..errors import InputError
from ..trace import Trace
from .curves import spans
from .style import DESIRED, ESTIMATED, FAINT, legend_above, new_figure, nothing_to_draw, styled, title


@styled
def switch(trace: Trace, step: int = 0, axes: Any = None) -> Figure:
    """Fig. 5: the lateral velocity that (18) expects in the middle of the next single support, while support may
    still switch.

    Where it reaches zero the ZMP goes from one foot to the other. It is positive towards the foot that the ZMP leaves,
    so that the curves of left and right steps lie on one another.

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
    figure, (ax,) = new_figure(axes, 1, 1, height=3.3)
    supports = spans(trace.phase == 0)
    if not supports:
        return nothing_to_draw(figure, ax, note="no double support in this walk")
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
        end = since[-1] + 1e3 * trace.control_dt
        ax.axvline(end, color=FAINT, ls=":", lw=1.0, label=f"double support ends after {end:.0f} ms")
        if len(changed):
            moment = since[changed[0] + 1]
            ax.axvline(moment, color=DESIRED, ls="--", lw=1.2, label=f"ZMP switches after {moment:.0f} ms")
    ax.axhline(0, color=FAINT, lw=0.6)
    words = (
        "w(T) is the velocity that the pendulum would have in the middle of the next step if the ZMP\n"
        "switched now, towards the foot that it leaves. At 0 the COM turns round there: the ZMP switches."
    )
    ax.text(0.99, 0.98, words, transform=ax.transAxes, ha="right", va="top", fontsize=7, zorder=5,
            bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.9, "pad": 1.5})  # fmt: skip
    ax.set(xlabel="time in double support [ms]", ylabel="expected sideways velocity w(T) [m/s]")
    ax.set_xlim(left=0)
    legend_above(ax, 2)
    title(figure, axes, "When the ZMP goes from one foot to the other")
    return figure
