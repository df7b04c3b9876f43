"""zmpwalk: a walking controller for MuJoCo humanoids, by whole-body control and estimated ZMP.

Usage:
    import zmpwalk
    trace = zmpwalk.simulate("mahru", duration=8.0)
    trace.summary()
"""

from __future__ import annotations

import os
import sys
from types import ModuleType

from ._check_mujoco import load_mujoco as _load_mujoco
from .errors import DimensionError, Error, InputError, ModelError, VersionError

try:
    _load_mujoco()  # before the extension: a wrong MuJoCo gets a sentence, not a linker's message
except VersionError as error:
    if os.path.basename(sys.argv[0]) in ("zmpwalk", "-m"):  # the command line: one line, as for every bad input
        print(f"zmpwalk: {error}", file=sys.stderr)
        raise SystemExit(2) from None
    raise

from . import errors
from ._build import VERSION as __version__
from ._core import (
    CycleOutput,
    GaitGenerator,
    LinearInvertedPendulum,
    VelocityTracker,
    WalkSettings,
    WholeBodyController,
    ZmpEstimator,
    measured_zmp,
)
from .description import (
    Foot,
    RobotDescription,
    available_robots,
    describe,
    load_robot,
    read_description,
)
from .profiles import VelocityProfile
from .simulation import Recorder, WalkingController, simulate
from .trace import Trace

__all__ = [
    "CycleOutput",
    "DimensionError",
    "Error",
    "Foot",
    "GaitGenerator",
    "InputError",
    "LinearInvertedPendulum",
    "ModelError",
    "Recorder",
    "RobotDescription",
    "Trace",
    "VelocityProfile",
    "VelocityTracker",
    "VersionError",
    "WalkSettings",
    "WalkingController",
    "WholeBodyController",
    "ZmpEstimator",
    "__version__",
    "available_robots",
    "describe",
    "errors",
    "load_robot",
    "measured_zmp",
    "plot",
    "read_description",
    "render",
    "simulate",
]


def __getattr__(name: str) -> ModuleType:
    """What is slow to import, imported when first asked for."""
    if name in ("plot", "render"):
        from importlib import import_module

        return import_module(f".{name}", __name__)
    raise AttributeError(f"module 'zmpwalk' has no attribute '{name}'")


def __dir__() -> list[str]:
    return sorted(__all__)
