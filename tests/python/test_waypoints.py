"""Waypoints lead a walk that follows late and no faster than it can to each pose, and stop it there."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
import zmpwalk
from zmpwalk import DimensionError, InputError, Waypoints, analysis

Z_C = 0.73
DT = 0.02  # between commands [s]
STEP = 0.8  # a walk takes over a command where a step begins [s]
REST = 3.0  # watched after the end [s]
SWAY = 0.01  # of the feet's middle about the path, as steps make it [m]


def state(pose, z_c=Z_C):
    """What a cycle says of a walk at (x, y, yaw)."""
    x, y, yaw = pose
    turned = (math.cos(yaw / 2), 0.0, 0.0, math.sin(yaw / 2))
    across = 0.1 * np.array([-math.sin(yaw), math.cos(yaw)])
    left, right = (np.array([x + side * across[0], y + side * across[1], 0.0, *turned]) for side in (1, -1))
    return SimpleNamespace(foot_left=left, foot_right=right, com=np.array([x, y, z_c]), heading=yaw)


def follow(follower, start=(0.0, 0.0, 0.0), duration=120.0, acceleration=(0.3, 0.2, 0.8)):
    """A walk that takes over the command at each step and reaches it at an acceleration [m/s^2, rad/s^2].

    Returns:
        poses (T, 3) and commands (T, 3), one row each DT.
    """
    pose, v, held = np.array(start, float), np.zeros(3), np.zeros(3)
    poses, commands, rest = [], [], 0.0
    for k in range(round(duration / DT)):
        t = k * DT
        phase = math.pi * t / STEP
        seen = pose + [SWAY * math.cos(pose[2]) * math.sin(2 * phase), SWAY * math.sin(phase), 0.0]
        command = follower(t, state(seen))
        if k % round(STEP / DT) == 0:
            held = np.array(command)
        v = v + np.clip(held - v, -DT * np.array(acceleration), DT * np.array(acceleration))
        c, s = math.cos(pose[2]), math.sin(pose[2])
        pose = pose + DT * np.array([c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]])
        poses.append(pose)
        commands.append(command)
        rest = rest + DT if follower.done else 0.0
        if rest > REST:
            break
    return np.array(poses), np.array(commands)


def off(pose, point):
    """Distance [m] and angle [rad] of a pose from a waypoint."""
    return math.dist(pose[:2], point[:2]), abs(math.remainder(pose[2] - point[2], 2 * math.pi))


@pytest.mark.parametrize("seed", range(30))
def test_random_poses_are_all_reached_in_turn_and_the_walk_stops_at_the_last(seed):
    random = np.random.default_rng(seed)
    points = [(*random.uniform(-2, 2, 2), random.uniform(-math.pi, math.pi)) for _ in range(random.integers(1, 5))]
    follower = Waypoints(points)
    poses, commands = follow(follower, start=(*random.uniform(-1, 1, 2), random.uniform(-3, 3)), duration=300)
    assert follower.done, follower
    assert not commands[-1].any()
    k = 0
    for point in points:  # each is passed, after the one before
        near = [off(pose, point)[0] < 0.03 and off(pose, point)[1] < math.radians(4) for pose in poses[k:]]
        assert any(near), point
        k += near.index(True)
    distance, angle = off(poses[-1], points[-1])
    assert distance < 0.03
    assert angle < math.radians(3)


def test_the_line_between_two_points_is_kept():
    follower = Waypoints([(0, 0, 0), (3, 0, 0)])
    poses, _ = follow(follower, start=(0.0, 0.3, 0.0))
    assert np.abs(poses[poses[:, 0] > 1.5, 1]).max() < 0.03
    aside = Waypoints([(3, 0, 0)], near=0.2)  # blown off a line that begins where it stood
    aside(0.0, state((0, 0, 0)))
    vx, vy, wz = aside(0.1, state((1.0, 0.2, 0.0)))
    assert vx > 0 and vy == 0 and wz < 0


def test_limits_hold_and_commands_change_no_faster_than_the_acceleration():
    limits = {"speed": 0.3, "sideways_speed": 0.1, "turn_rate": 0.4, "acceleration": 0.05, "turn_acceleration": 0.5}
    _, commands = follow(Waypoints([(2, 1, 2), (0, 0, -2)], **limits))
    vx, vy, wz = commands.T
    assert vx.max() == pytest.approx(0.3)
    assert -0.1 - 1e-12 <= vx.min() < 0
    assert np.abs(vy).max() <= 0.1 + 1e-12
    assert np.abs(wz).max() == pytest.approx(0.4)
    change = np.diff(commands, axis=0)[commands[1:].any(axis=1)]  # a stop, from nearly nothing, is at once
    assert np.hypot(*change[:, :2].T).max() <= 0.05 * DT + 1e-12
    assert np.abs(change[:, 2]).max() <= 0.5 * DT + 1e-12
    assert np.hypot(vx, vy)[np.flatnonzero(vx)[-1]] < 0.02


def test_a_goal_at_the_back_or_side_is_near_enough_not_to_turn_to():
    for point in ((-0.3, 0, 0), (0, 0.3, 0), (0, -0.3, 0)):
        poses, _ = follow(Waypoints([point]))
        assert off(poses[-1], point)[0] < 0.025
        assert np.abs(poses[:, 2]).max() == 0
    poses, _ = follow(Waypoints([(-1.5, 0, 0)]))
    assert np.abs(poses[:, 2]).max() > 3  # but this one is not


def test_turning_on_the_spot_moves_nothing_else():
    poses, commands = follow(Waypoints([(0, 0, math.pi / 2)], position_tolerance=0.05))
    assert off(poses[-1], (0, 0, math.pi / 2))[1] < math.radians(2.5)
    assert np.abs(commands[:, :2]).max() < 0.02


def test_a_point_without_heading_is_passed_at_speed():
    follower = Waypoints([(1, 0), (2, 0.3), (3, 0)])
    poses, commands = follow(follower)
    inner = (poses[:, 0] > 0.5) & (poses[:, 0] < 2.2)
    assert commands[inner, 0].min() > 0.7 * follower.speed
    assert off(poses[-1], (3, 0, 0))[0] < 0.025
    assert follower.done and follower.index == 3


def test_pause_stands_at_each_point():
    _, commands = follow(Waypoints([(0.5, 0, 0), (1, 0, 0)], pause=2.0))
    still = ~commands.any(axis=1)
    last_move = np.flatnonzero(~still)[-1]
    assert np.count_nonzero(still[:last_move]) * DT == pytest.approx(2.0, abs=2 * DT)


def test_what_is_left_out_scales_with_the_robot():
    small, large = Waypoints([(1, 0, 0)]), Waypoints([(1, 0, 0)], speed=0.5)
    for follower, z_c in ((small, 0.25), (large, 1.0)):
        follower(0.0, state((0, 0, 0), z_c))
    assert large.near == 4 * small.near
    assert large.position_tolerance == pytest.approx(0.02)
    assert large.settle == pytest.approx(2 * small.settle)
    assert large.turn_rate == pytest.approx(small.turn_rate / 2)
    assert small.speed == pytest.approx(0.1 * math.sqrt(9.81 * 0.25))
    assert (large.speed, large.sideways_speed) == (0.5, 0.2)


def test_restart_begins_again():
    follower = Waypoints([(0.3, 0, 0)])
    first, _ = follow(follower)
    assert follower.done and repr(follower) == "Waypoints(1 points, done)"
    follower.restart()
    assert (follower.done, follower.index) == (False, 0)
    assert np.array_equal(follow(follower)[0], first)


def test_bad_waypoints_are_refused():
    with pytest.raises(InputError, match="no waypoints"):
        Waypoints([])
    with pytest.raises(DimensionError, match=r"waypoint 1 has 4 numbers; it is \(x, y, yaw\) or \(x, y\)"):
        Waypoints([(0, 0, 0), (0, 0, 0, 1)])
    with pytest.raises(InputError, match=r"waypoint 0 is \(0, nan\).* finite"):
        Waypoints([(0, math.nan)])
    with pytest.raises(InputError, match="waypoint 0 is 1"):
        Waypoints([1])
    for name in ("speed", "turn_rate", "acceleration", "near", "heading_tolerance"):
        with pytest.raises(InputError, match=f"{name} is -1; it must be positive"):
            Waypoints([(0, 0, 0)], **{name: -1})
    with pytest.raises(InputError, match="pause is -1 s"):
        Waypoints([(0, 0, 0)], pause=-1)


def test_feet_pose_is_the_middle_of_the_soles_and_their_mean_direction():
    for pose in ((1, 2, 0.3), (0, 0, math.pi - 0.01), (-1, 0, -3)):
        out = state(pose)
        assert analysis.feet_pose(out.foot_left, out.foot_right) == pytest.approx(np.array(pose))
    left, right = state((0, 0, math.pi - 0.1)).foot_left, state((0, 0, -math.pi + 0.1)).foot_right
    assert abs(analysis.feet_pose(left, right)[2]) == pytest.approx(math.pi)
    both = np.stack([left, left]), np.stack([right, right])
    assert analysis.feet_pose(*both).shape == (2, 3)


def test_planned_path_closes_a_circle():
    n = 6284
    feet = state((1.0, 0.0, math.pi / 2))
    v_plan = np.tile([1.0, 0.0, 1.0], (n, 1))
    trace = SimpleNamespace(
        t=np.linspace(0, 2 * math.pi, n),
        v_plan=v_plan,
        foot_left=feet.foot_left[None],
        foot_right=feet.foot_right[None],
    )
    path = analysis.planned_path(trace)
    assert np.hypot(path[:, 0], path[:, 1]) == pytest.approx(np.ones(n), abs=1e-9)
    assert path[-1] == pytest.approx(np.array([1.0, 0.0, 2.5 * math.pi]), abs=1e-9)


@pytest.fixture(scope="module")
def toured():
    return zmpwalk.walk_to([(0.4, 0, 0), (0.4, 0.2, math.pi / 6)])


def test_walk_to_stands_at_the_last_point(toured):
    assert toured.meta["waypoints"] == {"points": [[0.4, 0, 0], [0.4, 0.2, math.pi / 6]], "reached": 2}
    pose = analysis.feet_pose(toured.foot_left, toured.foot_right)
    assert off(pose[-1], (0.4, 0.2, math.pi / 6))[0] < 0.025
    assert off(pose[-1], (0.4, 0.2, math.pi / 6))[1] < math.radians(3)
    assert toured.at_rest[-1] and not toured.meta["fell"]
    assert analysis.planned_path(toured)[-1] == pytest.approx(pose[-1], abs=0.03)
    assert toured.rerun() == toured


def test_walk_to_ends_when_time_is_over(toured):
    late = zmpwalk.walk_to([(0.4, 0, 0), (0.4, 0.2, math.pi / 6)], timeout=1.0)
    assert (late.duration, late.meta["waypoints"]["reached"]) == (1.0, 0)
    assert np.array_equal(late.com, toured.com[:1000])
    with pytest.raises(InputError, match="duration is -1 s"):
        zmpwalk.walk_to([(0, 0)], timeout=-1)
