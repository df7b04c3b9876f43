"""Many walks over a grid of values, on the cores of this machine or on a Dask cluster, with the same table."""

from __future__ import annotations

import contextlib
import copy
import hashlib
import importlib
import inspect
import itertools
import json
import math
import os
import pickle
import queue
import subprocess
import sys
import threading
from collections import Counter
from pathlib import Path
from typing import Any, Callable, Iterable, Iterator, Mapping, Sequence, Union

import numpy as np

from ._build import VERSION
from ._core import WalkSettings
from .disturbances import Uncertainty
from .errors import Error, InputError, nearest, needed
from .files import as_input_error, cause, whole, write_table
from .functions import fingerprint
from .given import settings_of
from .simulation import processors, simulate
from .trace import ABOVE, Trace, plain

__all__ = ["Sweep", "sweep"]

Grid = Union[Mapping[str, Sequence[Any]], Iterable[Mapping[str, Any]]]
Measure = Callable[[Trace], Mapping[str, Any]]
ARGUMENTS = tuple(name for name in inspect.signature(simulate).parameters if name not in ("on_progress", "command"))
CHART = ("zmp_error_x_p95", "torque")  # columns of the chart unless asked for others
MEANT = {"speed": ("profile",), "velocity": ("profile",), "gain": ("tracker_gain",)}  # other words for what there is
TRIES = 3  # of a walk whose process dies


class Sweep:
    """The table of a sweep: a row for each walk, in the order of the grid.

    A row holds the values of its point, then what came of the walk: `stood` (1 or 0), `error` (why the walk could not
    begin, or "" where it did), `fall_time` [s], `fall_cause`, `duration` [s], `steps`, `speed` (mean forward speed of
    the second half [m/s]), `speed_error` (against the plan [m/s]), `zmp_error_x`, `zmp_error_y` (median of |estimated -
    measured ZMP| [mm]), `zmp_error_x_p95`, `zmp_error_y_p95` [mm], `torque` (largest, as a share of its limit), and
    what a `measure` of your own has returned. What is not known is NaN.

    Args:
        rows: a mapping of column to value for each walk.
        axes: names of the grid, outermost first.

    Usage: `found = zmpwalk.sweep({"profile": [0.1, 0.2, 0.3]}); found["zmp_error_x"]; found.plot()`
    """

    def __init__(self, rows: Sequence[Mapping[str, Any]], axes: Sequence[str]):
        names = dict.fromkeys(name for row in rows for name in row)  # in their order
        texts = {name for row in rows for name, value in row.items() if isinstance(value, str)}
        missing = {name: "" if name in texts else math.nan for name in names}
        self.rows: list[dict[str, Any]] = [{name: row.get(name, missing[name]) for name in names} for row in rows]
        self.axes = list(axes)

    def __len__(self) -> int:
        return len(self.rows)

    def __iter__(self) -> Iterator[dict[str, Any]]:
        return iter(self.rows)

    def __getitem__(self, name: str) -> np.ndarray:
        if self.rows and name not in self.rows[0]:
            raise InputError(f"a sweep has no '{name}'; the nearest names are {', '.join(nearest(name, self.rows[0]))}")
        return np.array([row[name] for row in self.rows])

    def __repr__(self) -> str:
        fell, failed = sum(row["stood"] == 0 for row in self.rows), len(self.failures)
        said = f"Sweep({len(self.rows)} walks over {', '.join(self.axes)}; {fell} fell, {failed} could not begin"
        return said + (f", the first because {self.failures[0]['error']})" if failed else ")")

    @property
    def columns(self) -> list[str]:
        """Names of the columns."""
        return list(self.rows[0]) if self.rows else []

    @property
    def failures(self) -> list[dict[str, Any]]:
        """Rows of the walks that could not begin; `error` says why."""
        return [row for row in self.rows if row["error"]]

    def to_dataframe(self) -> Any:
        """The table for pandas.

        Raises:
            ImportError: pandas is not installed.

        Usage: `found.to_dataframe().groupby("profile").speed.mean()`
        """
        return needed("pandas", "to_dataframe", "pandas").DataFrame(self.rows)

    def save(self, path: str | os.PathLike) -> Path:
        """Write the table into a `.parquet` (which needs the extra `sweep`) or `.csv` file, whole or not at all.

        Raises:
            InputError: another suffix, or it cannot be written.  ImportError: pyarrow is not installed.

        Usage: `found.save("speeds.parquet")`
        """
        path = _table_path(path)
        rows = [{name: _cell(value) for name, value in row.items()} for row in self.rows]
        if path.suffix.lower() == ".csv":
            return write_table(path, rows)
        arrow = needed("pyarrow", "a Parquet file", "pyarrow")
        parquet = needed("pyarrow.parquet", "a Parquet file", "pyarrow")
        table = arrow.Table.from_pylist(rows).replace_schema_metadata({"zmpwalk_axes": json.dumps(self.axes)})
        with as_input_error(path), whole(path) as draft:
            parquet.write_table(table, draft)
        return path

    def plot(self, y: str | Sequence[str] = CHART, x: str | None = None, axes: Any = None) -> Any:
        """A chart: a panel for each `y` over `x`, a line for each value of the next axis of the grid.

        A cross marks a walk that fell; a walk that could not begin is left out.

        Args:
            y: columns.
            x: a column; None takes the first axis of the grid that has numbers.
            axes: as many Axes as `y`, or None for a figure of its own.

        Returns:
            A matplotlib Figure, which a notebook shows.

        Usage: `found.plot("speed_error")`
        """
        return ABOVE["plot_sweep"](self, y, x, axes)


def sweep(
    grid: Grid,
    out: str | os.PathLike | None = None,
    processes: int | None = None,
    cluster: Any = None,
    measure: Measure | None = None,
    on_progress: Callable[[int, int], None] | None = None,
    **common: Any,
) -> Sweep:
    """Walk once for every point of a grid, and put what came of it into one table.

    The table does not depend on where the walks are walked, nor on how many at a time. A walk that cannot begin, as
    with a speed that the legs do not reach, is a row with its reason. Where a process dies, its walk is walked again.

    Args:
        grid: names to values, of which every combination is walked, the last name changing first; or a list of
            mappings, one for each walk. A name is an argument of `simulate`, a setting ("tracker_gain" or
            "tracking.gain"), or a field of `Uncertainty` ("uncertainty.noise").
        out: a `.parquet` or `.csv` file for the table. Finished walks are kept beside it until all are done, so that
            the same call goes on after an interrupt; and a walk that the file holds already is not walked again.
        processes: how many walk at a time on this machine; None takes all processors.
        cluster: address of a Dask scheduler ("tcp://host:8786") or a `distributed.Client`, whose workers walk instead.
            They must have the same zmpwalk and MuJoCo.
        measure: more numbers of a trace, f(trace) -> {column: number}; with `processes` it needs to be picklable. Where
            its code has changed since `out` was written, every walk is walked again; see `fingerprint` in
            `zmpwalk.functions` for what it cannot know.
        on_progress: called with (walks done, all walks) after each.
        common: arguments of `simulate`, settings or uncertainties that all walks share.

    Returns:
        The table, in the order of the grid.

    Raises:
        InputError: an unknown name, an empty grid, processes < 1.  ImportError: no Dask, or no pyarrow for Parquet.
        KeyboardInterrupt: Ctrl-C; what was walked is kept where `out` is given.

    Usage: `zmpwalk.sweep({"profile": [0.1, 0.2, 0.3], "tracker_gain": [2, 4]}, out="gains.parquet", duration=10)`
    """
    points, axes = _points(grid)
    if processes is None:
        processes = processors()
    if isinstance(processes, bool) or not isinstance(processes, (int, np.integer)) or processes < 1:
        raise InputError(f"processes is {processes!r}; it must be an integer of at least 1")
    if measure is not None and not callable(measure):
        raise InputError(f"measure is {measure!r}; it must be a function f(trace) -> {{column: number}}")
    path = None if out is None else _table_path(out)
    if path is not None and path.suffix.lower() == ".parquet":
        needed("pyarrow", "a Parquet file", "pyarrow")  # found out before the first walk
    jobs = [arguments_of({**common, **point}) for point in points]
    keys = [_key(job, measure) for job in jobs]
    known = _kept(path)
    journal = _Journal(path)
    open_ = [i for i, key in enumerate(keys) if key not in known]
    done = len(jobs) - len(open_)

    def take(i: int, found: dict[str, Any]) -> None:
        nonlocal done
        known[keys[i]] = found
        journal.add(keys[i], found)
        done += 1
        if on_progress:
            on_progress(done, len(jobs))

    if on_progress:
        on_progress(done, len(jobs))
    if open_:
        payload = {i: (jobs[i], measure) for i in open_}
        with journal:
            if cluster is None:
                _on_processes(payload, min(int(processes), len(open_)), take)
            else:
                _on_cluster(payload, cluster, take)
    rows = [{**{name: _cell(value) for name, value in point.items()}, **known[key]} for point, key in zip(points, keys)]
    found = Sweep(rows, axes)
    if path is not None:
        found.save(path)
        _write_keys(path, {key: known[key] for key in keys})
    return found


# --- the points


def _points(grid: Grid) -> tuple[list[dict[str, Any]], list[str]]:
    if isinstance(grid, Mapping):
        values = {str(name): _values(str(name), given) for name, given in grid.items()}
        points = [dict(zip(values, combination)) for combination in itertools.product(*values.values())]
        axes = list(values)
    else:
        points = [{str(name): value for name, value in point.items()} for point in grid]
        axes = list(dict.fromkeys(name for point in points for name in point))
    if not points or not axes:
        raise InputError('the grid is empty; it is {"profile": [0.1, 0.2], ...} or a list of points')
    return points, axes


def _values(name: str, given: Any) -> list[Any]:
    if isinstance(given, np.ndarray):
        return given.tolist()
    if isinstance(given, (str, bytes, Mapping)) or not isinstance(given, Iterable):
        raise InputError(f"the grid's '{name}' is {given!r}; it must be a list of values")
    return list(given)


def arguments_of(point: Mapping[str, Any]) -> dict[str, Any]:
    """Arguments of `simulate` of names that may also be settings and uncertainties."""
    arguments: dict[str, Any] = {}
    changes: dict[str, Any] = {}
    unsure: dict[str, Any] = {}
    for name, value in point.items():
        if name in ARGUMENTS:
            arguments[name] = value
        elif name.startswith("uncertainty."):
            unsure[name.partition(".")[2]] = value
        else:
            try:
                WalkSettings.find(name)
            except InputError:
                known = [*ARGUMENTS, *(row.flat for row in WalkSettings.table().values())]
                near = ", ".join([*MEANT.get(name, ()), *nearest(name, known)][:3])
                raise InputError(
                    f"'{name}' is no argument of simulate, no setting and no uncertainty; the nearest names are {near}"
                ) from None
            changes[name] = value
    if changes:
        settings = copy.copy(settings_of(arguments.get("settings")))
        settings.update(**changes)
        arguments["settings"] = settings
    if unsure:
        given = arguments.get("uncertainty") or {}
        fields = given.to_dict() if isinstance(given, Uncertainty) else dict(given)
        arguments["uncertainty"] = {**fields, **unsure}
    return arguments


def _key(job: Mapping[str, Any], measure: Measure | None) -> str:
    """What tells one walk from every other: its arguments, the measure's code, and zmpwalk's version."""
    words = {
        "arguments": {name: _described(value) for name, value in sorted(job.items())},
        "measure": None if measure is None else fingerprint(measure),
        "zmpwalk": VERSION,
    }
    return hashlib.sha256(json.dumps(words, sort_keys=True).encode()).hexdigest()[:16]


def _described(value: Any) -> Any:
    if hasattr(value, "to_dict"):
        return plain(value.to_dict())
    if isinstance(value, (list, tuple)):
        return [_described(item) for item in value]
    if isinstance(value, Mapping):
        return {str(name): _described(item) for name, item in value.items()}
    if value is None or isinstance(value, (bool, int, float, str, np.generic, np.ndarray, os.PathLike)):
        return plain(value)
    return hashlib.sha256(pickle.dumps(value)).hexdigest()  # a model


# --- one walk


def walk(job: Mapping[str, Any], measure: Measure | None) -> dict[str, Any]:
    """One row without its point; what raises an error of zmpwalk's is a row as well."""
    try:
        trace = simulate(**job)
    except Error as failure:
        return {"stood": math.nan, "error": " ".join(str(failure).split())}
    said = trace.summary()
    half = len(trace.t) // 2
    forward = trace.forward_velocity()
    error = said["zmp_error_mm"]
    row: dict[str, Any] = {
        "stood": int(not said["fell"]),
        "error": "",
        "fall_time": said["fall_time"],
        "fall_cause": said["fall_cause"] or "",
        "duration": said["duration"],
        "steps": said["step_count"],
        "speed": float(forward[half:].mean()),
        "speed_error": float((forward - trace.v_plan[:, 0])[half:].mean()),
        "zmp_error_x": error["median"][0],
        "zmp_error_y": error["median"][1],
        "zmp_error_x_p95": error["p95"][0],
        "zmp_error_y_p95": error["p95"][1],
        "torque": said["peak_torque_ratio"],
    }
    if measure is not None:
        row.update(plain(dict(measure(trace))))
    return {name: math.nan if value is None else value for name, value in row.items()}


# --- processes of this machine


def _on_processes(payload: dict[int, Any], count: int, take: Callable[[int, dict], None]) -> None:
    """Walk in `count` processes; each gets one walk after the other, and is replaced where it dies."""
    dumps = _pickler()
    waiting: queue.Queue = queue.Queue()
    for i, job in payload.items():
        waiting.put((i, dumps(job)))
    found: queue.Queue = queue.Queue()
    workers: list[_Worker] = [_Worker() for _ in range(count)]
    deaths: Counter = Counter()
    stop = threading.Event()

    def serve(worker: _Worker) -> None:
        while not stop.is_set():
            try:
                i, job = waiting.get_nowait()
            except queue.Empty:
                return
            try:
                found.put((i, worker.ask(job)))
            except _DiedError as death:
                deaths[i] += 1
                if deaths[i] < TRIES:
                    waiting.put((i, job))
                else:
                    found.put((i, {"stood": math.nan, "error": f"its process died {TRIES} times: {death}"}))
            except BaseException as error:
                found.put((i, error))

    def start() -> list[threading.Thread]:
        started = [threading.Thread(target=serve, args=(worker,), daemon=True) for worker in workers]
        for thread in started:
            thread.start()
        return started

    threads = start()
    try:
        for _ in range(len(payload)):
            while True:
                try:
                    i, row = found.get(timeout=0.2)
                    break
                except queue.Empty:
                    if not any(thread.is_alive() for thread in threads):  # a walk came back after the others had ended
                        threads = start()
            if isinstance(row, BaseException):
                raise row
            take(i, row)
    finally:
        stop.set()
        for worker in workers:
            worker.end()


class _DiedError(Exception):
    """A process ended in the middle of a walk."""


class _Worker:
    """A process that walks what it is sent. It is started with the first walk."""

    def __init__(self) -> None:
        self._process: subprocess.Popen | None = None

    def ask(self, job: bytes) -> dict[str, Any]:
        if self._process is None:
            code = "from zmpwalk.sweeps import serve; serve()"
            path = os.pathsep.join(filter(None, [str(Path(__file__).parents[1]), *sys.path]))
            environment = {**os.environ, "PYTHONPATH": path}
            self._process = subprocess.Popen(
                [sys.executable, "-c", code], stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment
            )
        process: Any = self._process
        try:
            process.stdin.write(len(job).to_bytes(8, "little") + job)
            process.stdin.flush()
            head = process.stdout.read(8)
            answer = process.stdout.read(int.from_bytes(head, "little")) if len(head) == 8 else b""
        except OSError:
            answer = b""
        if not answer:
            self.end()
            raise _DiedError(f"exit code {process.returncode}")
        kind, value = pickle.loads(answer)
        if kind == "error":
            raise value
        return value

    def end(self) -> None:
        if self._process is not None:
            self._process.kill()
            self._process.wait()
            for stream in (self._process.stdin, self._process.stdout):
                if stream is not None:
                    with contextlib.suppress(OSError):
                        stream.close()
            self._process = None


def serve() -> None:
    """The loop of a worker's process: a walk's job from stdin, its row to stdout, until stdin ends."""
    answers, jobs = os.fdopen(os.dup(1), "wb"), sys.stdin.buffer
    os.dup2(2, 1)  # what a measure prints does not mix with the answers
    try:
        while len(head := jobs.read(8)) == 8:
            try:
                answer = ("row", walk(*pickle.loads(jobs.read(int.from_bytes(head, "little")))))
                content = pickle.dumps(answer)
            except Exception as error:
                content = pickle.dumps(("error", _portable(error)))
            answers.write(len(content).to_bytes(8, "little") + content)
            answers.flush()
    except KeyboardInterrupt:
        pass


def _portable(error: Exception) -> Exception:
    try:
        pickle.loads(pickle.dumps(error))
    except Exception:
        return RuntimeError(f"{type(error).__name__}: {error}")
    return error


def _pickler() -> Callable[[Any], bytes]:
    """`cloudpickle.dumps` where it is installed: it also sends functions of a notebook or script."""
    try:
        return importlib.import_module("cloudpickle").dumps
    except ImportError:
        return pickle.dumps


# --- a Dask cluster


def _on_cluster(payload: dict[int, Any], cluster: Any, take: Callable[[int, dict], None]) -> None:
    distributed = needed("distributed", "a sweep on a cluster", "distributed")
    own = isinstance(cluster, str)
    client = distributed.Client(cluster, timeout=20) if own else cluster
    try:
        futures = {client.submit(walk, *job, pure=False, retries=TRIES - 1): i for i, job in payload.items()}
        for future in distributed.as_completed(futures):
            try:
                take(futures[future], future.result())
            except distributed.KilledWorker as death:
                take(futures[future], {"stood": math.nan, "error": f"its workers died: {death}"})
            future.release()
    finally:
        if own:
            client.close()


# --- files


class _Journal:
    """Finished walks beside the table that is to come, a line each."""

    def __init__(self, table: Path | None):
        self._path = None if table is None else _journal_path(table)
        self._file: Any = None

    def __enter__(self) -> _Journal:
        if self._path is not None:
            with as_input_error(self._path):
                self._file = open(self._path, "a", encoding="utf-8")
        return self

    def add(self, key: str, row: Mapping[str, Any]) -> None:
        if self._file is not None:
            self._file.write(json.dumps([key, row]) + "\n")
            self._file.flush()

    def __exit__(self, *exception: Any) -> None:
        if self._file is not None:
            self._file.close()


def _journal_path(table: Path) -> Path:
    return table.with_name(table.name + ".walks")


def _kept(table: Path | None) -> dict[str, dict[str, Any]]:
    """Rows that an earlier sweep into this file has finished, by their keys."""
    if table is None or not _journal_path(table).exists():
        return {}
    found: dict[str, dict[str, Any]] = {}
    try:
        lines = _journal_path(table).read_text(encoding="utf-8").splitlines()
    except OSError as error:
        raise InputError(f"{_journal_path(table)}: {cause(error)}") from None
    for line in lines:
        try:
            key, row = json.loads(line)
        except ValueError:  # the line in which an earlier sweep was interrupted
            continue
        found[key] = row
    return found


def _write_keys(table: Path, rows: Mapping[str, Mapping[str, Any]]) -> None:
    """The finished walks, once each, for a later sweep over more."""
    path = _journal_path(table)
    with as_input_error(path), whole(path) as draft:
        draft.write_text("".join(json.dumps([key, row]) + "\n" for key, row in rows.items()), encoding="utf-8")


def _table_path(path: str | os.PathLike) -> Path:
    path = Path(path)
    if path.suffix.lower() not in (".parquet", ".csv"):
        raise InputError(f"{path}: a sweep's table is a .parquet or .csv file")
    return path


def _cell(value: Any) -> Any:
    """A value as a table can hold it: a number, a word, or the text of anything else."""
    value = value.item() if isinstance(value, np.generic) else value
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    described = _described(value)
    return described if isinstance(described, str) else json.dumps(described)
