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
from typing import TYPE_CHECKING, Any, Callable

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

from . import analysis, errors, shown, simulation, trace
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
    WholeBodyResult,
    ZmpEstimate,
    ZmpEstimator,
    build_info,
    common_plane,
    distribute_wrench,
    iterate_reference,
    measured_zmp,
    solve_reference,
    zmp_on_plane,
)
from .disturbances import Push, Uncertainty
from .motion import JointMotion
from .profiles import VelocityProfile
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
from .tasks import FrameTask, JointTask, MomentumTask
from .terrain import KnownGround, Patch, Terrain
from .trace import Fall, Trace

__all__ = [
    "Contact",
    "ContactSpace",
    "CycleOutput",
    "DimensionError",
    "Dynamics",
    "Error",
    "Explorer",
    "Fall",
    "Foot",
    "FrameTask",
    "GaitGenerator",
    "Humanoid",
    "InputError",
    "JointMotion",
    "JointTask",
    "KnownGround",
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
    "WholeBodyResult",
    "ZmpEstimate",
    "ZmpEstimator",
    "__version__",
    "analysis",
    "available_robots",
    "build_info",
    "common_plane",
    "describe",
    "distribute_wrench",
    "errors",
    "explore",
    "humanoid",
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


# Modules that most scripts do not need, each with the public names that it gives: whoever asks for one imports it.
_LATER = {
    "capture": ("PendulumWalk", "pendulum_limit"),
    "explorer": ("Explorer", "explore"),
    "plot": (),
    "pushes": ("PushMap", "push_map"),
    "render": (),
    "robots.humanoid": ("Humanoid", "humanoid"),
    "sweeps": ("Sweep", "sweep"),
    "troubles": ("Robustness", "robustness"),
    "verdict": ("Verdict", "judge"),
    "view": (),
    "waypoints": ("Waypoints", "walk_to"),
}

if TYPE_CHECKING:  # so that type checkers know what these hold
    from . import plot, render, view
    from .capture import PendulumWalk, pendulum_limit
    from .explorer import Explorer, explore
    from .pushes import PushMap, push_map
    from .robots.humanoid import Humanoid, humanoid
    from .sweeps import Sweep, sweep
    from .troubles import Robustness, robustness
    from .verdict import Verdict, judge
    from .waypoints import Waypoints, walk_to
else:

    def __getattr__(name: str) -> Any:
        """Imports the module that gives a name when it is first asked for."""
        for module, names in _LATER.items():
            if name == module or name in names:
                imported = import_module(f".{module}", __name__)
                return imported if name == module else getattr(imported, name)
        raise AttributeError(f"module 'zmpwalk' has no attribute '{name}'")


def _later(module: str, function: str) -> Callable[..., Any]:
    """A function of a module that is imported when it is called: what draws is slow to import."""
    return lambda *arguments, **options: getattr(import_module(f".{module}", __name__), function)(*arguments, **options)


trace.ABOVE.update(
    plot=_later("plot", "draw"),
    plot_pushes=_later("plot", "pushes"),
    plot_robustness=_later("plot", "robustness"),
    plot_sweep=_later("plot", "sweep"),
    rerun=simulation.rerun,
    video=_later("render", "film"),
    write_parquet=_later("exports", "write_parquet"),
    write_rerun=_later("exports", "write_rerun"),
    xarray_of=_later("exports", "xarray_of"),
)
shown.show_values()


def __dir__() -> list[str]:
    return sorted(__all__)
