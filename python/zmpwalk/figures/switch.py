"""Fig. 5: when the ZMP goes from one foot to the other."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ..errors import InputError
from ..trace import Trace
from .curves import excerpt, spans
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
    figure, (ax,) = new_figure(axes, 1, 1, height=3.6)
    supports = spans(trace.phase == 0)
    if not supports:
        return nothing_to_draw(figure, ax, note="no double support in this walk")
    if not -len(supports) <= step < len(supports):
        raise InputError(f"double support {step}: this walk has {len(supports)}, counted from 0")
    step = step % len(supports)
    lasts: list[float] = []  # how long each is [ms]
    shown = [n for n in range(len(supports)) if n != step] + [step]
    for n in shown:
        rows = supports[n]
        since = 1e3 * (trace.t[rows] - trace.t[rows.start])
        w = trace.w_T[rows] * trace.support[rows.start]
        chosen = n == step
        others = f"the other {len(shown) - 1} double supports" if n == shown[0] and not chosen else None
        lasts.append(1e3 * (trace.t[rows.stop - 1] - trace.t[rows.start] + trace.control_dt))
        ordinal = "first double support" if step == 0 else f"double support {step}"
        faint: dict[str, Any] = {"color": FAINT, "lw": 0.7}
        look = {"color": ESTIMATED, "lw": 2.0, "zorder": 3} if chosen else faint
        ax.plot(since, w, label=ordinal if chosen else others, **look)
        if not chosen:
            continue
        changed = np.flatnonzero(np.diff(trace.support[rows]))
        end = since[-1] + 1e3 * trace.control_dt
        ax.axvline(
            end,
            color=FAINT,
            ls=":",
            lw=1.0,
            label=f"the first ends after {end:.0f} ms" if step == 0 else f"it ends after {end:.0f} ms",
        )
        if len(changed):
            moment = since[changed[0] + 1]
            ax.axvline(moment, color=DESIRED, ls="--", lw=1.2, label=f"ZMP switches in it after {moment:.0f} ms")
    ax.axhline(0, color=FAINT, lw=0.6)
    words = (
        "w(T) is the velocity that the pendulum would have in the middle of the next step if the ZMP\n"
        "switched now, towards the foot that it leaves. At 0 the COM turns round there: the ZMP switches."
    )
    if axes is None:
        figure.supxlabel(words, x=0.012, ha="left", fontsize=7.5, color=FAINT)
    ax.set(xlabel="time in double support [ms]", ylabel="sideways velocity w(T) [m/s]")
    ax.set_xlim(left=0)
    if len(lasts) > 1:
        handles, labels = ax.get_legend_handles_labels()
        beside = [handle for handle, label in zip(handles, labels) if label.startswith("the other")]
        rest = lasts[:-1]
        same = f"{min(rest):.0f}" if round(min(rest)) == round(max(rest)) else f"{min(rest):.0f} to {max(rest):.0f}"
        beside[0].set_label(f"the other {len(rest)} double supports, which last {same} ms")
    legend_above(ax, 2)
    title(figure, axes, "When the ZMP goes from one foot to the other" + excerpt(trace, slice(0, len(trace.t))))
    return figure
