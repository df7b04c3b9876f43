"""Velocity profiles say with which velocity the robot is to walk over time (III-C, IV)."""

from __future__ import annotations

import csv
import io
import math
import os
import reprlib
from typing import Any, Callable, Iterable, Mapping, Sequence, Tuple, Union

import numpy as np

from . import _core
from .checks import is_number, positive, samples
from .errors import DimensionError, InputError
from .files import read_text

__all__ = ["Profile", "VelocityProfile", "profile_of"]

Velocity = Union[float, Sequence[float]]
Profile = Union[
    _core.VelocityProfile,
    Velocity,
    Sequence[Tuple[float, Velocity]],
    Mapping[float, Velocity],
    str,
    "os.PathLike[str]",
    None,
]

COLUMNS = ("t", "vx", "vy", "wz")


class VelocityProfile(_core.VelocityProfile):
    """A velocity over time in the heading frame of the walk.

    Args:
        t: (n,) [s] instants, the first 0, strictly increasing.
        v: (n, 3) [m/s, m/s, rad/s] forward, leftward and turning velocity at each instant.
        interpolation: "hold" keeps a value until the next instant (steps), "linear" joins the values; both keep the
            last for ever.

    Raises:
        InputError: NaN or infinite values, no rows, first t not 0, t not increasing, another interpolation.
        DimensionError: `t` is not (n,) or `v` is not (n, 3).

    Usage: `VelocityProfile([0, 2], [[0.1, 0, 0], [0.2, 0, 0]], "hold").velocity(2.5)  # -> [0.2, 0, 0]`
    """

    @classmethod
    def paper(cls) -> VelocityProfile:
        """The profile of section IV: 0.063, 0.156, 0.219 and 0.25 m/s forward from 0, 0.8, 1.6 and 2.4 s.

        Returns:
            The profile, held between the instants.

        Usage: `zmpwalk.simulate("mahru", profile=VelocityProfile.paper())`
        """
        return cls.piecewise([(0.0, 0.063), (0.8, 0.156), (1.6, 0.219), (2.4, 0.25)])

    @classmethod
    def constant(cls, v: Velocity) -> VelocityProfile:
        """One velocity for ever.

        Args:
            v: vx [m/s], or (vx, vy, wz) [m/s, m/s, rad/s].

        Raises:
            InputError: NaN or infinite.  DimensionError: neither one nor three numbers.

        Usage: `VelocityProfile.constant(0.25)`
        """
        return cls.piecewise([(0.0, v)])

    @classmethod
    def piecewise(cls, points: Iterable[tuple[float, Velocity]]) -> VelocityProfile:
        """Steps: each velocity is held from its instant to the next.

        Args:
            points: pairs (t [s], v), t from 0 and increasing; v is vx [m/s] or (vx, vy, wz).

        Raises:
            InputError: NaN, first t not 0, t not increasing.  DimensionError: a v with neither one nor three numbers.

        Usage: `VelocityProfile.piecewise([(0, 0.063), (0.8, 0.156)])`
        """
        return cls._from_points(points, "hold")

    @classmethod
    def ramp(cls, v0: Velocity, v1: Velocity, duration: float) -> VelocityProfile:
        """From one velocity to another at a constant acceleration; the last is kept.

        Args:
            v0, v1: velocity at 0 and at `duration`; vx [m/s] or (vx, vy, wz).
            duration: [s], more than 0.

        Raises:
            InputError: NaN, or `duration` not positive.

        Usage: `VelocityProfile.ramp(0.0, 0.25, 4.0)`
        """
        return cls._from_points([(0.0, v0), (positive("duration", duration), v1)], "linear")

    @classmethod
    def from_function(cls, f: Callable[[float], Velocity], duration: float, dt: float = 0.01) -> VelocityProfile:
        """Sample a function of time; linear between the samples, the last is kept.

        Args:
            f: t [s] -> vx [m/s] or (vx, vy, wz).
            duration: [s] the last sample's time.
            dt: [s] time between samples (the last step may be shorter).

        Raises:
            InputError: `f` gives NaN or infinity, `duration` or `dt` not positive.

        Usage: `VelocityProfile.from_function(lambda t: 0.2 + 0.05 * math.sin(t), duration=20)`
        """
        duration, dt = positive("duration", duration), positive("dt", dt)
        count = samples(duration, dt)
        t = np.minimum(dt * np.arange(count + 1), duration)
        return cls._from_points([(s, f(s)) for s in t.tolist()], "linear")

    @classmethod
    def from_csv(cls, path: str | os.PathLike, interpolation: str = "hold") -> VelocityProfile:
        """Read a table with the columns t, vx and, if given, vy and wz.

        A header may name the columns, in any order; without one they are t, vx, vy, wz. Empty lines and lines from
        `#` are skipped.

        Args:
            path: the CSV file; t [s], vx, vy [m/s], wz [rad/s].
            interpolation: "hold" or "linear".

        Raises:
            InputError: no such file, or a value that is missing, not a number, not finite, or a time that does not
                increase from 0; the message names file, line, value and rule.

        Usage: `VelocityProfile.from_csv("walk.csv")`
        """
        rows = _read_csv(path)
        return cls([row[0] for row in rows], np.array([row[1:] for row in rows]), interpolation)

    @classmethod
    def from_spec(cls, spec: str) -> VelocityProfile:
        """What the command line understands.

        Args:
            spec: "paper", a CSV file's path (with ":linear" behind it to join its rows), one speed "0.2", or steps
                "0:0.063,0.8:0.156" (t [s] : vx [m/s] or vx/vy/wz).

        Raises:
            InputError: none of these; the message says which would have worked.

        Usage: `VelocityProfile.from_spec("0:0.1,2:0.2")`
        """
        spec = str(spec).strip()
        if spec == "paper":
            return cls.paper()
        path, _, interpolation = spec.rpartition(":")
        if path and interpolation in ("hold", "linear"):
            return cls.from_csv(path, interpolation)
        if spec.lower().endswith(".csv") or os.path.isfile(spec):
            return cls.from_csv(spec)
        forms = 'a profile is "paper", a CSV file, a speed "0.2" or steps "0:0.063,0.8:0.156" (seconds:m/s)'
        points = []
        for part in spec.split(","):
            time, colon, velocity = part.rpartition(":")
            try:
                points.append((float(time) if colon else 0.0, [float(number) for number in velocity.split("/")]))
            except ValueError:
                raise InputError(f'profile "{spec}": cannot read "{part}"; {forms}') from None
            if len(points[-1][1]) not in (1, 3):
                raise InputError(f'profile "{spec}": "{part}" needs vx or vx/vy/wz; {forms}')
        if len(points) > 1 and ":" not in spec:
            raise InputError(f'profile "{spec}": several speeds need their times; {forms}')
        try:
            return cls.piecewise([(t, v if len(v) == 3 else v[0]) for t, v in points])
        except InputError as error:
            raise InputError(f'profile "{spec}": {error}') from None

    @classmethod
    def _from_points(cls, points: Iterable[tuple[float, Velocity]], interpolation: str) -> VelocityProfile:
        pairs = list(points)
        for pair in pairs:
            if not hasattr(pair, "__len__") or len(pair) != 2:
                raise DimensionError(f"{reprlib.repr(pair)} is not a pair (t, v)")
        return cls(
            [_time(t) for t, _ in pairs],
            np.array([three(v) for _, v in pairs]).reshape(-1, 3),
            interpolation,
        )

    @classmethod
    def of(cls, profile: _core.VelocityProfile) -> VelocityProfile:
        """The same profile as this class, which can be saved and printed.

        Usage: `VelocityProfile.of(controller.profile)`
        """
        return profile if isinstance(profile, cls) else cls(profile.t, profile.v, profile.interpolation)

    def to_dict(self) -> dict[str, Any]:
        """Plain lists, as they are stored in a trace.

        Returns:
            {"t": [...], "v": [[vx, vy, wz], ...], "interpolation": "hold" | "linear"}.

        Usage: `json.dumps(profile.to_dict())`
        """
        return {"t": np.asarray(self.t).tolist(), "v": np.asarray(self.v).tolist(), "interpolation": self.interpolation}

    @classmethod
    def from_dict(cls, plain: dict[str, Any]) -> VelocityProfile:
        """The inverse of `to_dict`.

        Raises:
            InputError: a key is missing.

        Usage: `VelocityProfile.from_dict(json.loads(text))`
        """
        for key in ("t", "v"):
            if key not in plain:
                raise InputError(f"a profile needs the key '{key}'; it has {', '.join(map(repr, plain)) or 'none'}")
        return cls(plain["t"], _rows(plain["v"]), plain.get("interpolation", "hold"))

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (np.array(self.t), np.array(self.v), self.interpolation)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _core.VelocityProfile) and self.to_dict() == VelocityProfile.of(other).to_dict()

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        t, v = np.asarray(self.t), np.asarray(self.v)
        sideways = v[:, 1:].any()
        shown = [f"{s:g}: {'/'.join(f'{x:g}' for x in (u if sideways else u[:1]))}" for s, u in zip(t[:6], v[:6])]
        if len(t) > 6:
            shown.append(f"... {len(t)} points to {t[-1]:g}")
        return f"VelocityProfile({{{', '.join(shown)}}} s: m/s, {self.interpolation})"


def profile_of(profile: Profile) -> VelocityProfile:
    """Makes the velocity profile that was given in one of these forms.

    Args:
        profile: None takes `VelocityProfile.paper()`; a number is vx for ever [m/s], three numbers (vx, vy, wz) for
            ever; a list of pairs (t, v), or a mapping of t to v, are the steps of `VelocityProfile.piecewise`; a
            string is what the command line takes (`VelocityProfile.from_spec`); a path is a CSV file's.

    Raises:
        InputError, DimensionError: none of these, or values that make no profile; the message names the value.

    Usage: `profile_of(0.2)`, `profile_of([(0, 0.1), (2, (0.2, 0, 0.1))])`, `profile_of("0:0.1,2:0.2")`
    """
    if profile is None:
        return VelocityProfile.paper()
    if isinstance(profile, _core.VelocityProfile):
        return VelocityProfile.of(profile)
    if isinstance(profile, str):
        return VelocityProfile.from_spec(profile)
    if isinstance(profile, os.PathLike):
        return VelocityProfile.from_csv(profile)
    given: Any = profile
    if is_number(given):
        return VelocityProfile.constant(given)
    if isinstance(given, Mapping):
        if "t" in given and "v" in given:
            return VelocityProfile.from_dict(dict(given))  # as a trace keeps it
        return VelocityProfile.piecewise(given.items())
    items: list[Any] = list(given) if isinstance(given, (Sequence, np.ndarray)) else []
    if len(items) == 3 and all(map(is_number, items)):
        return VelocityProfile.constant(items)
    if items and not any(map(is_number, items)):
        return VelocityProfile.piecewise(items)
    if callable(profile):
        raise InputError("profile is a function; give VelocityProfile.from_function(f, duration) instead")
    raise InputError(
        f"profile is {reprlib.repr(profile)}; it must be vx, (vx, vy, wz), pairs [(0, 0.1), (2, 0.2)], "
        'a text "0:0.1,2:0.2" or "paper", a CSV file, or a VelocityProfile'
    )


def _rows(v: Any) -> np.ndarray:
    try:
        return np.asarray(v, float).reshape(-1, 3)
    except (OverflowError, TypeError, ValueError):
        raise InputError(f"the key 'v' of a profile is {reprlib.repr(v)}; it must be rows [vx, vy, wz]") from None


def _time(t: Any) -> float:
    try:
        return float(t)
    except (OverflowError, TypeError, ValueError):
        raise InputError(f"time {t!r} is not a number; a profile's pairs are (t, v), t in seconds") from None


def three(v: Velocity) -> np.ndarray:
    """vx or (vx, vy, wz) as (3,)."""
    try:
        array = np.asarray(v, float)
    except (OverflowError, TypeError, ValueError):
        raise InputError(f"velocity {v!r} is not a number; it is vx or (vx, vy, wz)") from None
    if array.size == 1:
        return np.array([float(array.reshape(())), 0.0, 0.0])
    if array.shape != (3,):
        raise DimensionError(f"velocity has shape {array.shape}; it is vx or (vx, vy, wz)")
    return array


def _read_csv(path: str | os.PathLike) -> list:
    """Rows [t, vx, vy, wz] of a CSV file, every value checked where its line is known."""
    name = os.fspath(path)
    table = csv.reader(io.StringIO(read_text(path, "a CSV text file"), newline=""))
    try:
        lines = [(number, [cell.strip() for cell in cells]) for number, cells in enumerate(table, 1)]
    except csv.Error as error:
        raise InputError(f"{name}: not a CSV text file ({error})") from None
    lines = [(number, cells) for number, cells in lines if any(cells) and not cells[0].startswith("#")]
    columns: tuple[str, ...] = COLUMNS
    if lines and any(cell.lower() in COLUMNS for cell in lines[0][1]):
        number, header = lines.pop(0)
        columns = tuple(cell.lower() for cell in header)
        for required in COLUMNS[:2]:
            if required not in columns:
                raise InputError(
                    f"{name}, line {number}: the header has no column '{required}'; columns are {', '.join(COLUMNS)}"
                )
        for column in columns:
            if column not in COLUMNS or columns.count(column) > 1:
                raise InputError(
                    f"{name}, line {number}: column '{column}' is unknown or twice; columns are {', '.join(COLUMNS)}"
                )
        width = len(columns)
    else:
        width = max((len(cells) for _, cells in lines), default=0)
    if not lines:
        raise InputError(f"{name}: no rows; give lines 't, vx' from t = 0 on")
    if width not in range(2, 5):
        raise InputError(f"{name}, line {lines[0][0]}: {width} columns; they are t, vx and, if given, vy, wz")

    rows: list = []
    for number, cells in lines:
        place = f"{name}, line {number}"
        if len(cells) != width:
            raise InputError(f"{place}: {len(cells)} values where the table has {width} columns")
        row = dict.fromkeys(COLUMNS, 0.0)
        for column, cell in zip(columns, cells):
            if not cell:
                raise InputError(f"{place}: {column} is empty; every row needs every value")
            try:
                row[column] = float(cell)
            except ValueError:
                raise InputError(f"{place}: {column} is '{cell}'; it must be a number") from None
            if not math.isfinite(row[column]):
                raise InputError(f"{place}: {column} is {cell}; it must be finite")
        if not rows and row["t"] != 0:
            raise InputError(f"{place}: t is {row['t']:g}; the first time must be 0")
        if rows and row["t"] <= rows[-1][0]:
            raise InputError(f"{place}: t is {row['t']:g} after {rows[-1][0]:g}; times must increase")
        rows.append([row[column] for column in COLUMNS])
    return rows
