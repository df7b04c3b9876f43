"""The small pictures beside the tables that a notebook shows of a trace, a profile or a controller."""

from __future__ import annotations

import io
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ..profiles import VelocityProfile
from ..trace import Trace
from .style import COM, DESIRED, FAINT, PLANNED, WalkFigure, styled

__all__ = ["png", "profile", "walked"]

SIZE = (3.9, 1.7)  # [in]
AFTER = 2.0  # of a profile that is drawn after its last instant [s]


@styled
def walked(trace: Trace) -> Figure:
    """Planned and walked velocity, forward."""
    figure = WalkFigure(figsize=SIZE, layout="constrained")
    ax, plan = figure.subplots(), trace.v_plan[:, 0]
    ax.step(trace.t, plan, where="post", color=PLANNED, lw=1.6, label="planned")
    ax.plot(trace.t, trace.forward_velocity(), color=COM, lw=0.9, label="walked")
    reach = max(float(np.abs(plan).max()), 0.1)  # a fall's last instants would flatten all the rest
    ax.set(xlabel="time [s]", ylabel="forward [m/s]", ylim=(plan.min() - reach, plan.max() + reach))
    ax.legend(loc="lower right", ncol=2, fontsize=7)
    return figure


@styled
def profile(profile: VelocityProfile) -> Figure:
    """The velocities of a profile that are not 0 throughout, and the forward one."""
    figure = WalkFigure(figsize=SIZE, layout="constrained")
    ax = figure.subplots()
    t, v = np.append(profile.t, profile.t[-1] + AFTER), np.vstack([profile.v, profile.v[-1:]])
    names = (("forward [m/s]", PLANNED), ("leftward [m/s]", DESIRED), ("turning [rad/s]", FAINT))
    style: Any = {"drawstyle": "steps-post"} if profile.interpolation == "hold" else {}
    for i, (name, colour) in enumerate(names):
        if i == 0 or np.any(v[:, i]):
            ax.plot(t, v[:, i], color=colour, lw=1.6, label=name, **style)
    ax.set(xlabel="time [s]", ylabel="velocity")
    ax.legend(loc="best", fontsize=7)
    return figure


def png(figure: Figure) -> bytes:
    """The picture as a file's bytes."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=90)
    return buffer.getvalue()
