"""A trace holds everything that a walk did, cycle by cycle. It can be saved, plotted again and run again."""

from __future__ import annotations

import hashlib
import io
import json
import math
import os
import reprlib
import typing
import zipfile
from pathlib import Path
from typing import Any, Callable, Iterator, Mapping

import mujoco
import numpy as np

from ._columns import RecordedColumns
from ._core import RecordedColumn, RobotDescription, WalkSettings, recorded_columns
from .analysis import bound_excess
from .disturbances import uncertainty_of
from .errors import ColumnError, DimensionError, Error, InputError, ModelError, nearest, needed
from .files import cause, whole
from .motion import JointMotion
from .profiles import VelocityProfile
from .robots import description_from_dict
from .robots.source import Source
from .shortfalls import shortfalls

__all__ = ["ABOVE", "FORMAT_VERSION", "Fall", "Trace"]

# What a trace, and what is made of traces, does by means of rooms that stand above. `zmpwalk/__init__.py` puts their
# functions here under the names of the methods that call them, so that the rooms below import none of them.
ABOVE: dict[str, Callable[..., Any]] = {}

# The version grows when an older zmpwalk would read a file wrongly: because the file is laid out in another way, or a
# name means something else. A new column alone is no new version: a file may lack columns.
FORMAT_VERSION = 1

# What is read of a trace's meta data as such.
KINDS: dict[Any, tuple[str, ...]] = {
    dict: ("settings", "description", "profile", "motion", "versions", "timing"),
    list: ("joint_names", "torque_limits", "tasks", "push"),
    str: ("robot", "source", "fall_cause", "alarm_cause", "model_sha256", "simulated_sha256"),
    (int, float): ("fall_time", "control_dt", "timestep", "requested_duration", "alarm_time"),
}
ROOM, MOST_INFLATION = 1e8, 20  # bytes that any file may inflate to, and how many times its own size beyond

COLUMNS = {column.name: column for column in recorded_columns()}
AXES = {2: ["x", "y"], 3: ["x", "y", "z"]}  # of columns that are not in the table


class Fall(typing.NamedTuple):
    """How a walk ended in a fall, or would have: what was foreseen, and what came of it."""

    foreseen: float | None
    """When it was foreseen [s]; None where it was not."""
    foreseen_cause: str
    """Such as "the DCM is 0.04 m beyond what any foothold within reach can catch"."""
    time: float | None
    """Time of the fall [s]; None where the robot did not fall."""
    cause: str


class Trace(RecordedColumns, Mapping):
    """The record of a walk: a mapping of column names to arrays, each also an attribute.

    Row k holds the state before step k and what was decided for it. Units are SI, the frame is the world (z up) unless
    said otherwise, and quaternions are (w, x, y, z). Columns are read-only float arrays (T,) or (T, n); what is true
    or false is 1 or 0. `print(trace.describe())` tells what each column means, `Trace.columns()` holds the same as
    values.

    `meta` tells what was run: settings, description, profile, versions, model hash, seed, limits, fall, timing.

    Args:
        columns: name -> (T,) or (T, n); must include `t`.
        meta: plain dictionaries, lists, strings, numbers.
        model: bytes of the compiled model (`mj_saveModel`), so that `rerun` works; None if unknown. Only the MuJoCo
            that wrote them reads them.
        copy: False keeps float arrays as they are given, for a caller who gives them away.
        simulated: bytes of the model that was simulated, where it is not the controller's.
        source: the files that `model` was compiled from, which every MuJoCo reads; None if unknown.
        simulated_source: the same of the model that was simulated.

    Raises:
        InputError: no column `t`.  DimensionError: columns of different length, or a known one of another width.

    Usage: `trace = zmpwalk.simulate("mahru"); trace.com[:, 0]; trace["zmp_est"]; trace.summary()`
    """

    def __init__(
        self,
        columns: Mapping[str, Any],
        meta: dict[str, Any] | None = None,
        model: bytes | None = None,
        copy: bool = True,
        simulated: bytes | None = None,
        source: Source | None = None,
        simulated_source: Source | None = None,
    ):
        if not isinstance(columns, Mapping):
            raise InputError(f"columns are {type(columns).__name__}; they must be a mapping of names to arrays")
        if "t" not in columns:
            raise InputError(f"a trace needs the column 't'; it has {', '.join(columns) or 'none'}")
        self._columns: dict[str, np.ndarray] = {}
        rows = np.shape(columns["t"])[:1]
        for name, values in columns.items():
            array = _numbers_in(name, values, copy)
            if array.ndim not in (1, 2) or array.shape[:1] != rows:
                raise DimensionError(
                    f"column '{name}' has shape {array.shape}; 't' has {'no' if not rows else rows[0]} rows"
                )
            known = COLUMNS.get(name)
            if known and known.width and array.shape[1:] != (known.width,) * (known.width > 1):
                raise DimensionError(f"column '{name}' has shape {array.shape}; a row of it holds {_numbers(known)}")
            array.flags.writeable = False
            self._columns[name] = array
        self.meta: dict[str, Any] = {"format_version": FORMAT_VERSION, **_checked(meta or {})}
        self._model, self._simulated = model, simulated
        self._source, self._simulated_source = source, simulated_source

    # --- a mapping with attributes

    def __getitem__(self, name: str) -> np.ndarray:
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    if not typing.TYPE_CHECKING:  # type checkers know the columns by RecordedColumns, and refuse any other name

        def __getattr__(self, name: str) -> np.ndarray:
            columns = self.__dict__.get("_columns", {})
            if name in columns:
                return columns[name]
            if hasattr(type(self), name):  # a property has failed: asked once more, it says why
                return object.__getattribute__(self, name)
            if name in COLUMNS:
                raise ColumnError(f"this trace does not hold the column '{name}': it was recorded without it")
            if name.startswith("_"):
                raise AttributeError(f"a trace has no '{name}'")
            if name in self.flat():
                raise AttributeError(f"'{name}' is a part of a column: trace.flat()['{name}'] gives it")
            near = nearest(name, [*columns, *(other for other in dir(type(self)) if not other.startswith("_"))])
            raise AttributeError(f"a trace has no '{name}'; the nearest names are {', '.join(near)}")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._columns]

    def __repr__(self) -> str:
        end = f"fell at {self.meta['fall_time']:.2f} s" if self.meta.get("fall_time") is not None else "stood"
        return f"Trace({self.meta.get('robot', 'robot')}, {self.duration:g} s, {len(self.t)} cycles, {end})"

    @staticmethod
    def columns() -> dict[str, RecordedColumn]:
        """Every column that zmpwalk records, in the order of the record.

        Returns:
            name -> its `parts`, `width` or `size`, `unit`, `frame` and `meaning`.

        Usage: `Trace.columns()["zmp_est"].meaning`
        """
        return dict(COLUMNS)

    def describe(self) -> str:
        """What each column of this trace holds and means, as text of two lines a column.

        Usage: `print(trace.describe())`
        """
        lines = []
        for name, array in self.items():
            known = COLUMNS.get(name)
            lines.append(f"{name} {array.shape}" + (f": {_numbers(known)}" if known else ""))
            lines.append(f"    {known.meaning if known else 'This column is not one that zmpwalk records.'}")
        return "\n".join(lines)

    def identical(self, other: Trace) -> bool:
        """Whether two traces hold the same columns, bit for bit (NaN equals NaN).

        Timing and other meta data are not compared: they differ between machines.

        Usage: `assert trace.identical(trace.rerun())`
        """
        return set(self) == set(other) and all(
            self[name].shape == other[name].shape and np.array_equal(self[name], other[name], equal_nan=True)
            for name in self
        )

    def __eq__(self, other: object) -> bool:
        return self.identical(other) if isinstance(other, Trace) else NotImplemented

    __hash__ = None  # type: ignore[assignment]

    # --- what was run

    @property
    def control_dt(self) -> float:
        """Time between rows [s]."""
        known = float(self.meta.get("control_dt") or math.nan)
        if math.isfinite(known):
            return known
        return float(np.median(np.diff(self.t))) if len(self.t) > 1 else 0.0

    @property
    def duration(self) -> float:
        """Simulated time that the rows cover [s]."""
        return round(float(self.t[-1] - self.t[0]) + self.control_dt, 9) if len(self.t) else 0.0

    @property
    def step_period(self) -> float:
        """T_ss + T_ds [s]; from the touch-downs where the settings leave it to the robot, NaN if there are not two."""
        settings = self.meta.get("settings", {})
        period = float(settings.get("T_ss", math.nan)) + float(settings.get("T_ds", math.nan))
        if math.isfinite(period):
            return period
        touch_downs = self.t[1:][(self.phase[:-1] == 1) & (self.phase[1:] == 0)]
        return float(np.median(np.diff(touch_downs))) if len(touch_downs) > 1 else math.nan

    @property
    def profile(self) -> VelocityProfile:
        """The velocity profile that was walked."""
        return VelocityProfile.from_dict(self._meta("profile"))

    @property
    def motion(self) -> JointMotion | None:
        """The motion of arms, waist and trunk during the walk; None where they kept the start pose."""
        motion = self.meta.get("motion")
        return None if motion is None else JointMotion.from_dict(motion)

    @property
    def settings(self) -> WalkSettings:
        """The settings that were used."""
        return WalkSettings(**self._meta("settings"))

    @property
    def description(self) -> RobotDescription:
        """The robot's description."""
        return description_from_dict(self._meta("description"), "the trace's description")

    @property
    def model(self) -> mujoco.MjModel:
        """The model that the controller knew, from the trace alone: as a rule the one that was simulated.

        Under the MuJoCo that walked, it is the compiled model; under another, it is compiled from its source.

        Raises:
            ModelError: the trace has no model, or only one in the compiled form of another MuJoCo version, or this
            MuJoCo refuses its source.
        """
        return self._read(self._model, self._source, "model_sha256")

    @property
    def simulated_model(self) -> mujoco.MjModel:
        """The model that was simulated; `model` where the controller knew it.

        Raises:
            ModelError: as `model`.
        """
        if not self.meta.get("simulated_sha256"):
            return self.model
        is_given, source = self.meta.get("simulated_given", True), self._simulated_source
        if self._made_here or (is_given and source is None):
            return self._read(self._simulated, source, "simulated_sha256")
        unsure, known = uncertainty_of(self.meta.get("uncertainty")), source.compiled() if source else self.model
        if not unsure.changes_model:
            return known
        return unsure.changed(known, unsure.root_of(known, self.description), self.meta.get("seed", 0))

    @property
    def model_kept(self) -> str:
        """In which form this trace keeps its model, in words: its files, its compiled form, or none.

        Usage: `trace.model_kept  # -> "the files of mahru.xml, for every MuJoCo"`
        """
        if self._source is not None:
            return f"the files of {self._source.main}, for every MuJoCo that reads them"
        if self._model is None:
            return "none"
        return (
            f"its compiled form, for MuJoCo {self._made_by} only: it was not loaded from a file, or was changed since "
            "(`source=` gives its MJCF)"
        )

    @property
    def _made_by(self) -> str | None:
        return self.meta.get("versions", {}).get("mujoco")

    @property
    def _made_here(self) -> bool:
        return self._made_by == mujoco.__version__

    def _read(self, compiled: bytes | None, source: Source | None, sha: str) -> mujoco.MjModel:
        if compiled is None and source is None:
            raise ModelError("this trace carries no model: it can be plotted but not run again")
        if compiled is None or not self._made_here:
            if source is not None:
                return source.compiled()
            raise ModelError(
                f"this trace keeps its model in compiled form only, which MuJoCo {self._made_by} wrote and MuJoCo "
                f"{mujoco.__version__} cannot read: open it there, or walk again from a file or with `source=`"
            )
        if hashlib.sha256(compiled).hexdigest() != self.meta.get(sha):
            raise ModelError("the model inside this trace is damaged: its hash is not the recorded one")
        return mujoco.MjModel.from_binary_path("trace.mjb", {"trace.mjb": compiled})

    def _meta(self, key: str) -> dict[str, Any]:
        if key not in self.meta:
            raise InputError(f"this trace does not say its {key}")
        return self.meta[key]

    def rerun(self, on_progress: Callable[[float, float], None] | None = None) -> Trace:
        """Repeat the walk that this trace recorded, from nothing but the trace.

        Under another MuJoCo than the one that walked, a warning says how far the COM went away from the recorded one.

        Args:
            on_progress: called with (t, duration) [s] now and then; may raise to stop.

        Returns:
            A new trace: `identical` to this one, on the same machine and under the same MuJoCo, if nobody touched the
            robot meanwhile.

        Raises:
            ModelError: the model is missing or damaged, or this MuJoCo cannot read it (`model_kept`).

        Usage: `Trace.load("trace.npz").rerun().summary()`
        """
        return ABOVE["rerun"](self, on_progress)

    # --- files

    def save(self, path: str | os.PathLike) -> Path:
        """Write everything into one `.npz` file, whole or not at all.

        The file holds each column as `<name>.npy`, `meta.json` and, compressed, the compiled model and, where they are
        known, the files that it was compiled from (`model/...`).

        Args:
            path: the file; `.npz` is added if there is no suffix.

        Returns:
            The path written.

        Raises:
            OSError: the folder does not exist or cannot be written.

        Usage: `trace.save("out/trace.npz")`
        """
        path = Path(path)
        path = path if path.suffix else path.with_suffix(".npz")
        with whole(path) as draft, zipfile.ZipFile(draft, "w") as file:
            for name, array in self._columns.items():
                with file.open(zipfile.ZipInfo(f"{name}.npy"), "w", force_zip64=True) as entry:
                    np.lib.format.write_array(entry, array, allow_pickle=False)
            file.writestr(zipfile.ZipInfo("meta.json"), json.dumps(self.meta, indent=1))
            for name, compiled in (("model.mjb", self._model), ("simulated.mjb", self._simulated)):
                if compiled is not None:
                    file.writestr(zipfile.ZipInfo(name), compiled, zipfile.ZIP_DEFLATED)
            for folder, source in (("model/", self._source), ("simulated/", self._simulated_source)):
                for name, content in source.files.items() if source else ():
                    file.writestr(zipfile.ZipInfo(folder + name), content, zipfile.ZIP_DEFLATED)
        return path

    @classmethod
    def load(cls, path: str | os.PathLike) -> Trace:
        """Read what `save` wrote.

        Raises:
            InputError: no such file, not a trace, damaged, or of a newer format. Every older format is read.

        Usage: `trace = Trace.load("out/mahru-default/trace.npz")`
        """
        path = Path(path)
        try:
            with zipfile.ZipFile(path) as file:
                _require_size(path, file)
                names = file.namelist()
                if "meta.json" not in names or "t.npy" not in names:
                    raise InputError(f"{path}: not a trace that zmpwalk saved")
                meta = json.loads(file.read("meta.json").decode())
                if not isinstance(meta, dict):
                    raise InputError(f"{path}: not a trace that zmpwalk saved: its meta.json holds no object")
                version = meta.get("format_version")
                if type(version) is not int or version < 1:
                    raise InputError(f"{path}: not a trace that zmpwalk saved: its format is {version!r}")
                if version > FORMAT_VERSION:
                    author = meta.get("versions", {}).get("zmpwalk", "of a later version")
                    raise InputError(
                        f"{path}: trace format {version} is newer than this zmpwalk, which reads up to "
                        f"{FORMAT_VERSION}; it was written by zmpwalk {author}"
                    )
                columns = {
                    name[:-4]: np.lib.format.read_array(io.BytesIO(file.read(name)), allow_pickle=False)
                    for name in names
                    if name.endswith(".npy") and "/" not in name
                }
                model = file.read("model.mjb") if "model.mjb" in names else None
                simulated = file.read("simulated.mjb") if "simulated.mjb" in names else None
                source, simulated_source = (
                    Source({name[len(folder) :]: file.read(name) for name in names if name.startswith(folder)})
                    if any(name.startswith(folder) for name in names)
                    else None
                    for folder in ("model/", "simulated/")
                )
        except OSError as error:
            raise InputError(f"{path}: {cause(error)}") from None
        except Error:
            raise
        except Exception as error:  # zipfile, zlib, json and numpy each have their own way to say it
            raise InputError(f"{path}: not a trace, or damaged: {error}") from None
        meta = {**meta, "format_version": FORMAT_VERSION}  # saved again: today's format
        try:
            return cls(columns, meta, model, True, simulated, source, simulated_source)
        except (DimensionError, InputError) as error:
            raise InputError(f"{path}: not a trace, or damaged: {error}") from None

    def to_csv(self, path: str | os.PathLike) -> Path:
        """Write the columns as one table, seventeen digits so that nothing is lost, whole or not at all.

        Args:
            path: the file; the header names are those of `flat`.

        Raises:
            OSError: the folder does not exist or cannot be written.

        Usage: `trace.to_csv("walk.csv")`
        """
        path, flat = Path(path), self.flat()
        with whole(path) as draft, open(draft, "w", encoding="utf-8") as file:
            np.savetxt(file, np.column_stack(list(flat.values())), "%.17g", ",", header=",".join(flat), comments="")
        return path

    def to_dataframe(self) -> Any:
        """The columns as a pandas table with one number per cell, indexed by `t`.

        Raises:
            ImportError: pandas is not installed.

        Usage: `trace.to_dataframe()[["com_x", "zmp_est_x"]].plot()`
        """
        return needed("pandas", "to_dataframe", "pandas").DataFrame(self.flat()).set_index("t")

    def to_parquet(self, path: str | os.PathLike) -> Path:
        """Write the columns of `flat` as a Parquet file, with `meta` in its schema, whole or not at all.

        Raises:
            InputError: it cannot be written.  ImportError: pyarrow is not installed (extra `sweep`).

        Usage: `trace.to_parquet("walk.parquet")`
        """
        return ABOVE["write_parquet"](self, path)

    def to_xarray(self) -> Any:
        """The columns as an xarray data set: time is a dimension, and so are joints and the parts of a column.

        Each variable has `units`, `frame` and `long_name`; `meta` is kept as JSON. It can be written as a NetCDF 4
        file, which is HDF5.

        Raises:
            ImportError: xarray is not installed (extra `xarray`).

        Usage: `trace.to_xarray().to_netcdf("walk.nc"); trace.to_xarray().tau.sel(joint="l_knee").plot()`
        """
        return ABOVE["xarray_of"](self)

    def to_rerun(self, path: str | os.PathLike) -> Path:
        """Write a recording for the viewer Rerun: COM, ZMP and soles in space, velocities and torque as curves.

        Args:
            path: a .rrd file; `rerun walk.rrd` opens it.

        Raises:
            InputError: another suffix, or it cannot be written.  ImportError: no rerun-sdk is there (extra `rerun`).

        Usage: `trace.to_rerun("walk.rrd")`
        """
        return ABOVE["write_rerun"](self, path)

    def flat(self) -> dict[str, np.ndarray]:
        """The columns cut into single numbers per row.

        Returns:
            name -> (T,): `com_x`, `foot_left_qw`, `v_plan_yaw`, `f_c_right_fz`, `tau_<joint>`, `qpos_0`, ...

        Usage: `trace.flat()["zmp_est_x"]`
        """
        out: dict[str, np.ndarray] = {"t": self.t}
        for name, array in self.items():
            if array.ndim == 1:
                out[name] = array
            else:
                out.update((f"{name}_{part}", array[:, i]) for i, part in enumerate(self.parts(name)))
        return out

    def parts(self, name: str) -> list[str]:
        """Names of a column's numbers: x, y, z, the joints, or 0, 1, ...; none of a column with one number a row.

        Usage: `trace.parts("com")  # -> ["x", "y", "z"]`
        """
        if self[name].ndim == 1:
            return []
        width: int = self[name].shape[1]
        known, joints = COLUMNS.get(name), self.meta.get("joint_names", [])
        if known and known.size == "joints" and len(joints) == width:
            return joints
        parts = known.parts if known else AXES.get(width, [])
        return parts or [str(i) for i in range(width)]

    # --- what came of it

    @property
    def fall(self) -> Fall | None:
        """The fall, foreseen or come true; None where there was neither.

        Usage: `if trace.fall: print(trace.fall.foreseen_cause, trace.fall.time)`
        """
        meta = self.meta
        alarm, time = meta.get("alarm_time"), meta.get("fall_time")
        if alarm is None and time is None:
            return None
        foreseen = alarm is not None and alarm != time
        cause = meta.get("alarm_cause", "") if foreseen else ""
        return Fall(alarm if foreseen else None, cause, time, meta.get("fall_cause", ""))

    def summary(self) -> dict[str, Any]:
        """Say how the walk went in a few numbers.

        Returns:
            robot, mujoco_version, model_kept, duration [s], fell, fall_time [s], fall_cause, foreseen_time [s],
            foreseen_cause (of a fall that was foreseen), step_count (touch-downs);
            mean_speed_per_step, planned_speed_per_step [m/s]: forward, over each whole step period T = T_ss + T_ds
            from the start, the COM's displacement in the planned heading over T, and the profile's; speed_rms_error
            [m/s]: of the COM's forward velocity about the plan, over all cycles; step_period [s];
            zmp_error_mm: |estimated - measured ZMP|, each [x, y]: median, p95 over all cycles, single_support_p95,
                single_support_rms;
            bound_excess_mm: farthest that the estimate went beyond the designed bounds in single support, [x, y];
            iterations: mean, max over the cycles whose ZMP was modified; modified_cycles; peak_torque_ratio;
            cycle_us: median, p99 of the controller's time per cycle; real_time_factor;
            shortfalls: what a walk that stood fell short of, a sentence each: a speed that was
                missed, a joint on its stop, torques that were cut.
            Plain numbers that JSON can hold: what is not known is None.

        Usage: `print(trace.summary()["zmp_error_mm"])`
        """
        meta, timing = self.meta, self.meta.get("timing") or {}
        mean_speed, planned_speed = self._speed_per_step()
        single = self.phase == 1
        error = 1e3 * np.abs(self.zmp_est - self.zmp_meas)
        excess = 1e3 * bound_excess(self)
        modified = (self.zmp_modified != 0).any(axis=1)
        summary = {
            "robot": meta.get("robot"),
            "mujoco_version": meta.get("versions", {}).get("mujoco"),
            "model_kept": self.model_kept,
            "zmpwalk_version": meta.get("versions", {}).get("zmpwalk"),
            "law": meta.get("settings", {}).get("law"),
            "duration": self.duration,
            "fell": bool(meta.get("fell", self.fell.any())),
            "fall_time": meta.get("fall_time"),
            "fall_cause": meta.get("fall_cause") or None,
            "foreseen_time": self.fall and self.fall.foreseen,
            "foreseen_cause": (self.fall and self.fall.foreseen_cause) or None,
            "step_count": int(((self.phase[:-1] == 1) & (self.phase[1:] == 0)).sum()),
            "mean_speed_per_step": mean_speed,
            "planned_speed_per_step": planned_speed,
            "step_period": self.step_period,
            "speed_rms_error": _rms(self.forward_velocity() - self.v_plan[:, 0]),
            "zmp_error_mm": {
                "median": _percentile(error, 50),
                "p95": _percentile(error, 95),
                "single_support_p95": _percentile(error[single], 95),
                "single_support_rms": [_rms(error[single, axis]) for axis in (0, 1)],
            },
            "bound_excess_mm": [float(np.nanmax(np.append(excess[:, axis], 0.0))) for axis in (0, 1)],
            "iterations": {
                "mean": self.iterations[modified].mean() if modified.any() else None,
                "max": int(self.iterations[modified].max()) if modified.any() else None,
            },
            "modified_cycles": int(modified.sum()),
            "peak_torque_ratio": np.nanmax(self.torque_ratio) if np.isfinite(self.torque_ratio).any() else None,
            "cycle_us": {key: (timing.get("cycle_us") or {}).get(key) for key in ("median", "p99")},
            "real_time_factor": timing.get("real_time_factor"),
            "shortfalls": shortfalls(self),
        }
        return plain(summary, finite=True)

    def forward_velocity(self) -> np.ndarray:
        """Velocity of the COM along the planned heading, to compare with the first of `v_plan` and `v_des`.

        Returns:
            (T,) [m/s].

        Usage: `trace.forward_velocity() - trace.v_plan[:, 0]`
        """
        along, across = self._heading_axes()
        return self.dcom[:, 0] * along + self.dcom[:, 1] * across

    def _heading_axes(self) -> Any:
        """Cosine and sine (T,) of the planned heading: the feet's at the start, turned by the planned turning rate."""
        quaternions = (self.foot_left[0, 3:], self.foot_right[0, 3:]) if len(self.t) else ()
        yaws = [math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)) for w, x, y, z in quaternions]
        start = math.atan2(sum(map(math.sin, yaws)), sum(map(math.cos, yaws)))
        turned = self.control_dt * np.concatenate([[0.0], np.cumsum(self.v_plan[:-1, 2])])
        return np.cos(start + turned), np.sin(start + turned)

    def _speed_per_step(self) -> Any:
        """Mean forward speed and plan [m/s] over each whole step period."""
        period, dt, count = self.step_period, self.control_dt, len(self.t)
        if count < 2 or not math.isfinite(period):
            return [], []
        last = self.com[-1] + dt * self.dcom[-1]  # the state after the last row
        moved = np.diff(np.vstack([self.com, last])[:, :2], axis=0)
        along, across = self._heading_axes()
        travelled = np.concatenate([[0.0], np.cumsum(moved[:, 0] * along + moved[:, 1] * across)])
        windows = int((count * dt + 1e-9) / period)
        edges = np.rint(period / dt * np.arange(windows + 1)).astype(int)
        speed = np.diff(travelled[edges]) / (dt * np.diff(edges))
        if "profile" in self.meta:
            profile = self.profile
            plan = [profile.displacement(period * k, period * (k + 1))[0] / period for k in range(windows)]
        else:
            plan = [self.v_plan[a:b, 0].mean() for a, b in zip(edges[:-1], edges[1:])]
        return speed.tolist(), plan

    def video(self, path: str | os.PathLike | None = None, **options: Any) -> Any:
        """Make a film of the walk.

        Args:
            path: a `.mp4` or `.gif` to write; None makes an `.mp4` that lives as long as what is returned.
            options: passed to `zmpwalk.render.video`: speed, fps, width, height, camera and others.

        Returns:
            A film, which a notebook plays: its `path`, and `save(path)` for one that was not written yet.

        Raises:
            What `zmpwalk.render.video` raises.

        Usage: `trace.video(speed=0.5)` as the last line of a notebook's cell; `trace.video("walk.mp4")`
        """
        return ABOVE["video"](self, path, **options)

    def plot(self, figure: str = "all", **options: Any) -> Any:
        """Draw how true the estimate was, one of the paper's figures, or all.

        Args:
            figure: "estimate" (how true it was), "iteration", "tracking", "switch", "velocity", "sagittal", "lateral"
                (Figs. 2, 4 to 8), "footprints" (from above) or "all".
            options: passed to that function of `zmpwalk.plot`.

        Returns:
            A matplotlib Figure, which a notebook shows; for "all" a dictionary of them.

        Raises:
            InputError: no figure of that name.

        Usage: `trace.plot("sagittal", start=2, end=6)`
        """
        return ABOVE["plot"](self, figure, **options)


def _numbers(column: RecordedColumn) -> str:
    """What a row of a column holds: names of the numbers, or how many there are, unit and frame."""
    numbers = ", ".join(column.parts) or {"1": "one number"}.get(column.size, f"{column.size} numbers")
    return numbers + (f" [{column.unit}]" if column.unit else "") + (f" in {column.frame}" if column.frame else "")


def _numbers_in(name: str, values: Any, copy: bool) -> np.ndarray:
    array = np.asarray(values)
    if array.dtype.kind not in "biuf" and array.size:
        raise InputError(f"column '{name}' holds {array.dtype}; it must hold real numbers")
    return np.array(array, dtype=float) if copy else np.asarray(array, dtype=float)


def _checked(meta: Any) -> dict[str, Any]:
    """The meta data as plain values, each of the kind that whoever reads it expects."""
    if not isinstance(meta, Mapping):
        raise InputError(f"meta is {type(meta).__name__}; it must be a mapping of names to plain values")
    out = plain(meta)
    for kind, names in KINDS.items():
        for name in names:
            if out.get(name) is not None and (not isinstance(out[name], kind) or isinstance(out[name], bool)):
                word = " or ".join(each.__name__ for each in (kind if isinstance(kind, tuple) else (kind,)))
                raise InputError(f"meta['{name}'] is {reprlib.repr(out[name])}; it must be {word}")
    for name in ("T_ss", "T_ds"):
        if not isinstance((out.get("settings") or {}).get(name, 0.0), (int, float)):
            raise InputError(
                f"meta['settings']['{name}'] is {reprlib.repr(out['settings'][name])}; it must be a number"
            )
    return out


def _require_size(path: Path, file: zipfile.ZipFile) -> None:
    """Only the compiled models are compressed: a small file does not become a large trace."""
    inflated, size = sum(entry.file_size for entry in file.infolist()), path.stat().st_size
    if inflated > ROOM + MOST_INFLATION * size:
        raise InputError(
            f"{path}: {size / 1e6:.3g} MB that would become {inflated / 1e6:.3g} MB; a trace grows less when it is read"
        )


def plain(value: Any, finite: bool = False) -> Any:
    """Dictionaries, lists, strings, numbers and None only; with `finite`, NaN and infinity become None."""
    if isinstance(value, Mapping):
        return {str(key): plain(item, finite) for key, item in value.items()}
    if isinstance(value, np.ndarray):
        return plain(value.tolist(), finite)
    if isinstance(value, (list, tuple)):
        return [plain(item, finite) for item in value]
    if isinstance(value, np.generic):
        value = value.item()
    if finite and isinstance(value, float) and not math.isfinite(value):
        return None
    return value if value is None or isinstance(value, (bool, int, float, str)) else str(value)


def _rms(values: np.ndarray) -> float | None:
    values = values[np.isfinite(values)]
    return float(np.sqrt(np.mean(values**2))) if len(values) else None


def _percentile(values: np.ndarray, percent: float) -> list[float | None]:
    """[x, y] over the rows where there is a number."""
    columns = (values[np.isfinite(values[:, axis]), axis] for axis in (0, 1))
    return [float(np.percentile(column, percent)) if len(column) else None for column in columns]
