"""Traces for other tools: a Parquet file, an xarray data set, and a recording for the viewer Rerun."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import numpy as np

from .errors import InputError, needed
from .files import as_input_error, whole
from .trace import COLUMNS, Trace, plain

__all__ = ["write_parquet", "write_rerun", "xarray_of"]

COLOURS = {"com": (0, 0, 0), "zmp_est": (213, 94, 0), "zmp_meas": (0, 158, 115)}  # as in the figures
SCALARS = {  # curves of a recording: its path, and the column
    "velocity/planned": "v_plan_x",
    "velocity/desired": "v_des_x",
    "zmp_forward/estimated": "zmp_est_x",
    "zmp_forward/measured": "zmp_meas_x",
    "zmp_leftward/estimated": "zmp_est_y",
    "zmp_leftward/measured": "zmp_meas_y",
    "torque/largest_share": "torque_ratio",
}
SOLE_THICKNESS = 0.01  # of a drawn sole [m]


def write_parquet(trace: Trace, path: str | os.PathLike) -> Path:
    """See `Trace.to_parquet`."""
    arrow, parquet = needed("pyarrow", "to_parquet", "pyarrow"), needed("pyarrow.parquet", "to_parquet", "pyarrow")
    path = Path(path)
    table = arrow.Table.from_pydict(trace.flat())
    table = table.replace_schema_metadata({"zmpwalk": json.dumps(plain(trace.meta, finite=True))})
    with as_input_error(path), whole(path) as draft:
        parquet.write_table(table, draft)
    return path


def xarray_of(trace: Trace) -> Any:
    """See `Trace.to_xarray`."""
    xarray = needed("xarray", "to_xarray", "xarray h5netcdf h5py")
    variables: dict[str, Any] = {}
    coordinates: dict[str, Any] = {"t": ("t", trace.t, {"units": "s", "long_name": "time in the simulation"})}
    for name, values in trace.items():
        known = COLUMNS.get(name)
        about = {} if known is None else {"units": known.unit, "frame": known.frame, "long_name": known.meaning}
        if name == "t":
            continue
        if values.ndim == 1:
            variables[name] = ("t", values, about)
        else:
            parts = trace.parts(name)
            along = "joint" if parts == trace.meta.get("joint_names") else f"{name}_part"
            coordinates[along] = (along, parts)
            variables[name] = (("t", along), values, about)
    about = {"robot": str(trace.meta.get("robot", "")), "meta": json.dumps(plain(trace.meta, finite=True))}
    return xarray.Dataset(variables, coordinates, about)


def write_rerun(trace: Trace, path: str | os.PathLike) -> Path:
    """See `Trace.to_rerun`."""
    rerun = needed("rerun", "to_rerun", "rerun-sdk")
    path = Path(path)
    if path.suffix != ".rrd":
        raise InputError(f"{path}: a recording for Rerun is a .rrd file")
    time, ground, flat = [rerun.TimeColumn("time", duration=trace.t)], _ground(trace), trace.flat()
    with as_input_error(path), whole(path) as draft:
        recording = rerun.RecordingStream("zmpwalk")
        recording.save(draft)
        recording.log("/", rerun.ViewCoordinates.RIGHT_HAND_Z_UP, static=True)
        for name, colour in COLOURS.items():
            place = trace[name] if name == "com" else np.column_stack([trace[name], ground])
            seen = np.isfinite(place).all(axis=1)
            recording.log(name, rerun.Points3D.from_fields(radii=0.015, colors=[colour]), static=True)
            at = [rerun.TimeColumn("time", duration=trace.t[seen])]
            recording.send_columns(name, indexes=at, columns=rerun.Points3D.columns(positions=place[seen]))
        for side in ("left", "right"):
            foot, size = trace[f"foot_{side}"], trace.meta.get("description", {}).get(side, {})
            half = [size.get("length", 0.2) / 2, size.get("width", 0.1) / 2, SOLE_THICKNESS / 2]
            recording.log(f"{side}_sole", rerun.Boxes3D(half_sizes=[half]), static=True)
            placed = rerun.Transform3D.columns(translation=foot[:, :3], quaternion=foot[:, [4, 5, 6, 3]])
            recording.send_columns(f"{side}_sole", indexes=time, columns=placed)
        for curve, name in SCALARS.items():
            if name in flat:
                values = rerun.Scalars.columns(scalars=flat[name])
                recording.send_columns(f"plots/{curve}", indexes=time, columns=values)
        recording.flush()
        recording.disconnect()
    return path


def _ground(trace: Trace) -> np.ndarray:
    """Height that marks on the ground are drawn at (T,) [m]."""
    return np.where(trace.support > 0, trace.foot_left[:, 2], trace.foot_right[:, 2])
