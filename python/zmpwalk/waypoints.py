"""Walks to places: velocity commands lead the robot from pose to pose."""

from __future__ import annotations

import math
from collections.abc import Iterable as IterableABC
from typing import Any, Iterable, Sequence, Tuple

import numpy as np

from .analysis import feet_pose
from .errors import DimensionError, InputError
from .given import Settings
from .robots import Robot, load_robot
from .simulation import Progress, WalkingController, check_duration, name_of, run
from .trace import Trace, plain

__all__ = ["Waypoints", "walk_to"]

GRAVITY = 9.81  # only scales defaults [m/s^2]
Command = Tuple[float, float, float]


class Waypoints:
    """Velocity commands that lead a walk to one pose after the other.

    Far from a point the robot turns towards it and walks forward along the line from the point before; it steers at a
    place on that line that keeps ahead of it. Within `near` it walks straight to the point in any direction and turns
    to the point's heading. The speed falls with the distance d that is left, as min(speed, sqrt(2 acceleration d),
    d / settle), and the turning rate likewise as angle / settle. At a point without a heading that is not the last
    one, the robot does not slow down.

    Lengths and times scale with the robot where they are None: z_c is the height of the COM over the soles at the first
    call, and T_c = sqrt(z_c / g), 0.73 m and 0.27 s for mahru.

    Args:
        points: (x, y, yaw) or, for any heading, (x, y): W [m, rad].
        speed: forward, at most [m/s]; None is 0.1 z_c / T_c.
        sideways_speed: also backward, near a point [m/s]; None is 0.4 `speed`.
        turn_rate: at most [rad/s]; None is 0.1 / T_c.
        acceleration: of the commanded velocity, also when slowing down before a stop [m/s^2]; None is 0.01 g, for which
            the legs have a few steps.
        turn_acceleration: [rad/s^2]; None is 0.03 / T_c^2.
        settle: time constant of the last approach and of turning [s]; None is 6 T_c, twice a step: a command takes a
            step to act, and a quicker pull would overshoot.
        near: distance from which on it moves in any direction [m]; None is 0.6 z_c, about two steps.
        position_tolerance: a point is reached within it [m]; None is 0.02 z_c.
        heading_tolerance: and within it [rad].
        pause: standing time at each point before going on [s].

    Fields: `index` of the point walked to (the number of points after the last), `done`.

    Raises:
        InputError: no points, a number that is not finite, a limit that is not positive.
        DimensionError: a point with neither two nor three numbers.

    Usage: `follower = zmpwalk.Waypoints([(1, 0, 0), (1, 1, math.pi / 2)], speed=0.2)`, then see `__call__`
    """

    def __init__(
        self,
        points: Iterable[Sequence[float]],
        speed: float | None = None,
        sideways_speed: float | None = None,
        turn_rate: float | None = None,
        acceleration: float | None = None,
        turn_acceleration: float | None = None,
        settle: float | None = None,
        near: float | None = None,
        position_tolerance: float | None = None,
        heading_tolerance: float = math.radians(2.0),
        pause: float = 0.0,
    ):
        if not isinstance(points, IterableABC):
            raise InputError(f"waypoints are {points!r}; they are a list of (x, y, yaw) or (x, y)")
        self.points = [_point(i, point) for i, point in enumerate(points)]
        if not self.points:
            raise InputError("no waypoints; give at least one (x, y, yaw)")
        self.speed = _positive("speed", speed)
        self.sideways_speed = _positive("sideways_speed", sideways_speed)
        self.turn_rate = _positive("turn_rate", turn_rate)
        self.acceleration = _positive("acceleration", acceleration)
        self.turn_acceleration = _positive("turn_acceleration", turn_acceleration)
        self.settle = _positive("settle", settle)
        self.near = _positive("near", near)
        self.position_tolerance = _positive("position_tolerance", position_tolerance)
        self.heading_tolerance = _positive("heading_tolerance", heading_tolerance)
        self.pause = _number("pause", pause)
        if not (math.isfinite(self.pause) and self.pause >= 0):
            raise InputError(f"pause is {self.pause:g} s; it must be finite and not negative")
        self.restart()

    def restart(self) -> None:
        """Begin again with the first point."""
        self._index, self._resume = 0, -math.inf
        self._start: np.ndarray | None = None
        self._t, self._v = math.nan, np.zeros(3)  # of the last command

    @property
    def index(self) -> int:
        """Of the point that is walked to; the number of points when all are reached."""
        return self._index

    @property
    def done(self) -> bool:
        """Every point was reached, and the command is zero."""
        return self._index == len(self.points)

    def __call__(self, t: float, out: Any) -> Command:
        """The command for the state of a cycle.

        Args:
            t: [s].
            out: the cycle's `CycleOutput`: feet, heading, COM.

        Returns:
            (vx, vy, wz), heading frame [m/s, m/s, rad/s].

        Usage: `controller.command(*follower(data.time, controller.update(data)))`
        """
        p, yaw = feet_pose(out.foot_left, out.foot_right)[:2], out.heading
        if self._start is None:
            self._fill(out.com[2] - min(out.foot_left[2], out.foot_right[2]))
            self._start, self._t = p, t
        while not self.done and self._reached(p, yaw):
            self._start = np.array(self.points[self._index][:2])
            self._index += 1
            self._resume = t + self.pause
        if self.done or t < self._resume:
            self._v[:] = 0.0
        else:
            change = self._towards(p, yaw) - self._v
            along, turn = self.acceleration * (t - self._t), self.turn_acceleration * (t - self._t)
            change[:2] *= min(1.0, along / max(math.hypot(*change[:2]), 1e-12))
            self._v += (*change[:2], min(turn, max(-turn, change[2])))
        self._t = t
        vx, vy, wz = self._v.tolist()
        return vx, vy, wz

    def _fill(self, z_c: float) -> None:
        """Limits that were left to the robot, from its natural length and time."""
        Tc = math.sqrt(z_c / GRAVITY)
        natural = {
            "speed": 0.1 * z_c / Tc,
            "turn_rate": 0.1 / Tc,
            "acceleration": 0.01 * GRAVITY,
            "turn_acceleration": 0.03 / Tc**2,
            "settle": 6.0 * Tc,
            "near": 0.6 * z_c,
            "position_tolerance": 0.02 * z_c,
        }
        for name, value in natural.items():
            if math.isnan(getattr(self, name)):
                setattr(self, name, value)
        if math.isnan(self.sideways_speed):
            self.sideways_speed = 0.4 * self.speed

    def _stops(self) -> bool:
        """Whether the walk comes to rest at the point, rather than passing it."""
        return self._index == len(self.points) - 1 or not math.isnan(self.points[self._index][2]) or self.pause > 0

    def _reached(self, p: np.ndarray, yaw: float) -> bool:
        goal = self.points[self._index]
        distance = math.dist(p, goal[:2])
        if not self._stops():
            return distance < self.near
        left = 0.0 if math.isnan(goal[2]) else abs(_wrap(goal[2] - yaw))
        return (  # and slowly, as the approach is from within twice the tolerance: a stop from speed would go beyond
            distance < self.position_tolerance
            and left < self.heading_tolerance
            and math.hypot(*self._v[:2]) * self.settle < 2 * self.position_tolerance
            and abs(self._v[2]) * self.settle < 2 * self.heading_tolerance
        )

    def _towards(self, p: np.ndarray, yaw: float) -> np.ndarray:
        """The command for a robot whose velocity could jump."""
        goal = np.array(self.points[self._index])
        rest = goal[:2] - p
        d = math.hypot(*rest)
        speed = self.speed
        if self._stops():
            speed = min(speed, math.sqrt(2 * self.acceleration * d), d / self.settle)
        if d > self.near:  # turn to the carrot, forward as far as that is ahead
            line = goal[:2] - self._start
            length = math.hypot(*line)
            carrot = goal[:2]
            if length > 0:
                ahead = np.dot(p - self._start, line) / length + 2 * self.speed * self.settle
                carrot = self._start + min(ahead, length) * line / length
            off = _wrap(math.atan2(*(carrot - p)[::-1]) - yaw)
            return np.array([speed * max(0.0, math.cos(off)) ** 2, 0.0, self._turn(off)])
        along, left = (math.cos(yaw), math.sin(yaw)), (-math.sin(yaw), math.cos(yaw))
        v = np.array([np.dot(rest, along), np.dot(rest, left)]) * (speed / max(d, 1e-9))
        forward = self.speed if v[0] > 0 else self.sideways_speed
        vx, vy = v / max(1.0, math.hypot(v[0] / forward, v[1] / self.sideways_speed))
        return np.array([vx, vy, 0.0 if math.isnan(goal[2]) else self._turn(_wrap(goal[2] - yaw))])

    def _turn(self, angle: float) -> float:
        return max(-self.turn_rate, min(self.turn_rate, angle / self.settle))

    def __repr__(self) -> str:
        return f"Waypoints({len(self.points)} points, {'done' if self.done else f'at {self._index}'})"


def walk_to(
    points: Iterable[Sequence[float]],
    robot: Robot = "mahru",
    settings: Settings = None,
    timeout: float = 300.0,
    on_progress: Progress | None = None,
    **limits: float,
) -> Trace:
    """Walk a robot from its start pose to one pose after the other, and stand at the last.

    Args:
        points: (x, y, yaw) or (x, y), as for `Waypoints`: W [m, rad].
        robot: what `load_robot` takes.
        settings: as for `simulate`; None takes `WalkSettings()`.
        timeout: simulated time after which it ends all the same [s].
        on_progress: called about ten times a second with (t, timeout) [s]; what it raises stops the walk and passes
            on.
        **limits: speed, tolerances and so on, as for `Waypoints`.

    Returns:
        The trace, until the robot has stood for `settle` at the last point, fell, or ran out of time;
        `meta["waypoints"]` is {"points", "reached": how many of them}.

    Raises:
        InputError, DimensionError: as `Waypoints`, or a bad timeout.  ModelError: a robot that cannot be used.

    Usage: `zmpwalk.walk_to([(1.0, 0.0, 0.0), (1.0, 0.6, math.pi / 2)]).plot("footprints")`
    """
    follower, timeout = Waypoints(points, **limits), check_duration(timeout)
    model, description = load_robot(robot)
    controller = WalkingController(model, description, settings, profile=0.0)
    arrived = math.inf

    def command(t: float, out: Any) -> Command:
        nonlocal arrived
        velocity = follower(t, out)
        arrived = min(arrived, t) if follower.done and out.at_rest else math.inf
        if t > arrived + follower.settle:
            raise StopIteration
        return velocity

    trace = run(controller, timeout, on_progress, robot=name_of(robot), command=command)
    trace.meta["waypoints"] = plain({"points": follower.points, "reached": follower.index})
    return trace


def _point(i: int, point: Sequence[float]) -> Command:
    """(x, y, yaw), yaw NaN where none is asked for."""
    try:
        numbers = [float(number) for number in point]
    except (TypeError, ValueError):
        raise InputError(f"waypoint {i} is {point!r}; it is (x, y, yaw) or (x, y)") from None
    if len(numbers) not in (2, 3):
        raise DimensionError(f"waypoint {i} has {len(numbers)} numbers; it is (x, y, yaw) or (x, y)")
    if not all(map(math.isfinite, numbers)):
        raise InputError(f"waypoint {i} is {point!r}; its numbers must be finite")
    x, y, yaw = numbers if len(numbers) == 3 else (*numbers, math.nan)
    return x, y, yaw


def _positive(name: str, value: float | None) -> float:
    """`value`, NaN where it is left to the robot."""
    if value is None:
        return math.nan
    number = _number(name, value)
    if not (math.isfinite(number) and number > 0):
        raise InputError(f"{name} is {number:g}; it must be positive and finite")
    return number


def _number(name: str, value: float) -> float:
    try:
        return float(value)
    except (TypeError, ValueError):
        raise InputError(f"{name} is {value!r}; it must be a number") from None


def _wrap(angle: float) -> float:
    """The same angle in [-pi, pi)."""
    return (angle + math.pi) % (2 * math.pi) - math.pi
