"""zmpwalk makes humanoid robots walk in MuJoCo: you give a velocity, it computes the joint torques.

Before it sends a torque it estimates the zero moment point (ZMP) that the torque will produce.

Usage:
    import zmpwalk
    trace = zmpwalk.simulate("mahru", duration=8.0)
    print(trace.summary())
"""

from __future__ import annotations

import os
import sys
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

from ._check_mujoco import installed_mujoco as _installed_mujoco
from ._check_mujoco import load_mujoco as _load_mujoco
from .errors import DimensionError, Error, InputError, ModelError, VersionError

try:
    _load_mujoco()  # before all else: a MuJoCo that does not fit gets a sentence
except VersionError as error:
    if os.path.basename(sys.argv[0]) in ("zmpwalk", "-m"):  # the command line: one line, as for every bad input
        if sys.argv[1:2] == ["build-adapter"]:
            from ._adapters import main

            raise SystemExit(main(_installed_mujoco())) from None
        print(f"zmpwalk: {error}", file=sys.stderr)
        raise SystemExit(2) from None
    raise

from . import analysis, errors, pushes, shown, simulation, sweeps, trace, troubles
from ._build import VERSION as __version__
from ._core import (
    Contact,
    ContactSpace,
    CycleOutput,
    Dynamics,
    GaitGenerator,
    LinearInvertedPendulum,
    Plane,
    Robot,
    State,
    TaskAccelerations,
    TaskSpace,
    VelocityTracker,
    WalkSettings,
    WholeBodyController,
    ZmpEstimator,
    build_info,
    common_plane,
    distribute_wrench,
    iterate_reference,
    measured_zmp,
    solve_reference,
    zmp_on_plane,
)
from .capture import PendulumWalk, pendulum_limit
from .disturbances import Push, Uncertainty
from .motion import JointMotion
from .profiles import VelocityProfile
from .pushes import PushMap, push_map
from .robots import (
    Foot,
    Proposal,
    RobotDescription,
    available_robots,
    describe,
    load_robot,
    propose,
    read_description,
)
from .settings import load_settings, settings_toml
from .simulation import Recorder, WalkingController, simulate, simulate_batch
from .sweeps import Sweep, sweep
from .tasks import FrameTask, JointTask, MomentumTask
from .terrain import Patch, Terrain
from .trace import Trace
from .troubles import Robustness, robustness
from .verdict import Verdict, judge
from .waypoints import Waypoints, walk_to

__all__ = [
    "Contact",
    "ContactSpace",
    "CycleOutput",
    "DimensionError",
    "Dynamics",
    "Error",
    "Foot",
    "FrameTask",
    "GaitGenerator",
    "InputError",
    "JointMotion",
    "JointTask",
    "LinearInvertedPendulum",
    "ModelError",
    "MomentumTask",
    "Patch",
    "PendulumWalk",
    "Plane",
    "Proposal",
    "Push",
    "PushMap",
    "Recorder",
    "Robot",
    "RobotDescription",
    "Robustness",
    "State",
    "Sweep",
    "TaskAccelerations",
    "TaskSpace",
    "Terrain",
    "Trace",
    "Uncertainty",
    "VelocityProfile",
    "VelocityTracker",
    "Verdict",
    "VersionError",
    "WalkSettings",
    "WalkingController",
    "Waypoints",
    "WholeBodyController",
    "ZmpEstimator",
    "__version__",
    "analysis",
    "available_robots",
    "build_info",
    "common_plane",
    "describe",
    "distribute_wrench",
    "errors",
    "iterate_reference",
    "judge",
    "load_robot",
    "load_settings",
    "measured_zmp",
    "pendulum_limit",
    "plot",
    "propose",
    "push_map",
    "read_description",
    "render",
    "robustness",
    "settings_toml",
    "simulate",
    "simulate_batch",
    "solve_reference",
    "sweep",
    "view",
    "walk_to",
    "zmp_on_plane",
]


def _plot(*arguments: Any, **options: Any) -> Any:
    """`Trace.plot`. It imports matplotlib, which is slow, only when something is to be drawn."""
    from . import plot

    return plot.draw(*arguments, **options)


def _plot_pushes(push_map: PushMap, axes: Any = None) -> Any:
    """`PushMap.plot`."""
    from . import plot

    return plot.pushes(push_map, axes)


def _plot_robustness(found: Robustness, axes: Any = None) -> Any:
    """`Robustness.plot`."""
    from . import plot

    return plot.robustness(found, axes)


def _plot_sweep(found: Sweep, y: Any, x: Any = None, axes: Any = None) -> Any:
    """`Sweep.plot`."""
    from . import plot

    return plot.sweep(found, y, x, axes)


def _video(*arguments: Any, **options: Any) -> Any:
    """`Trace.video`."""
    from . import render

    return render.film(*arguments, **options)


trace.ABOVE.update(plot=_plot, rerun=simulation.rerun, video=_video)
pushes.ABOVE.update(plot=_plot_pushes)
troubles.ABOVE.update(plot=_plot_robustness)
sweeps.ABOVE.update(plot=_plot_sweep)
shown.show_values()

if TYPE_CHECKING:  # so that type checkers know what these hold
    from . import plot, render, view
else:

    def __getattr__(name: str) -> ModuleType:
        """Imports a module that is slow to import when it is first asked for."""
        if name in ("plot", "render", "view"):
            return import_module(f".{name}", __name__)
        raise AttributeError(f"module 'zmpwalk' has no attribute '{name}'")


def __dir__() -> list[str]:
    return sorted(__all__)
