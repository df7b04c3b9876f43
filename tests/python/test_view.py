"""The live window: keys into commands without a window, the walk behind it, and the window itself where Xvfb is."""

import os
import shutil
import subprocess
import sys

import numpy as np
import pytest
import zmpwalk
from zmpwalk import InputError
from zmpwalk.view import LiveWalk, Steering, view

STEP, LIMIT = (0.1, 0.05, 0.2), (0.3, 0.12, 0.6)


@pytest.fixture
def steering():
    return Steering(STEP, LIMIT)


@pytest.mark.parametrize(
    ("keys", "command"),
    [
        ("W", (0.1, 0, 0)),
        ("UP UP DOWN", (0.1, 0, 0)),
        ("S", (-0.1, 0, 0)),
        ("A", (0, 0.05, 0)),
        ("D D", (0, -0.1, 0)),
        ("LEFT", (0, 0, 0.2)),
        ("RIGHT RIGHT", (0, 0, -0.4)),
        ("W A LEFT", (0.1, 0.05, 0.2)),
        ("W A LEFT SPACE", (0, 0, 0)),
        ("W W W W W", (0.3, 0, 0)),  # no farther than the limit
        ("A A A A A", (0, 0.12, 0)),  # even if that is no whole number of steps
        ("W W W W W S S S", (0, 0, 0)),  # and as many back are zero
        ("F1", (0, 0, 0)),
    ],
)
def test_keys_make_a_command(steering, keys, command):
    for key in keys.split():
        steering.press(key)
    assert steering.command == pytest.approx(command, abs=1e-15)


def test_press_says_whether_the_command_changed(steering):
    assert [steering.press(key) for key in ("SPACE", "W", "W", "W", "W", "Q", "SPACE")] == [0, 1, 1, 1, 0, 0, 1]


def test_steering_goes_as_far_as_the_robot_s_size_and_reach():
    model, description = zmpwalk.load_robot("mahru")
    controller = zmpwalk.WalkingController(model, description)
    steering = Steering.of(controller)
    for axis, key in enumerate(("W", "A", "LEFT")):
        steering.press("SPACE")
        for _ in range(20):
            steering.press(key)
        assert steering.command[axis] == pytest.approx((0.6, 0.147, 0.5)[axis], rel=0.03)
        assert controller.reach_share(steering.command) <= 1
        for _ in range((10, 5, 5)[axis]):
            steering.press({"W": "S", "A": "D", "LEFT": "RIGHT"}[key])
        assert steering.command == (0, 0, 0)


def test_bad_steering_is_refused():
    with pytest.raises(InputError, match=r"step is \[0\.0, 0\.1, 0\.1\]; it must be three positive numbers"):
        Steering((0, 0.1, 0.1), LIMIT)
    with pytest.raises(InputError, match="limit is"):
        Steering(STEP, (1, 1))
    with pytest.raises(InputError, match="beyond the limit"):
        Steering((0.4, 0.05, 0.2), LIMIT)


def test_a_walk_obeys_keys_within_a_step_or_two_and_restarts():
    walk = LiveWalk("mahru", steering=Steering((0.1, 0.05, 0.2), (0.1, 0.1, 0.4)))
    start = walk.data.qpos.copy()
    walk.advance(1.0)
    assert np.abs(walk.velocity).max() < 0.01  # stands
    walk.press("W")
    for _ in range(50):
        walk.advance(0.1)
    assert walk.velocity[0] == pytest.approx(0.1, abs=0.02)
    assert walk.words["asked"].startswith("forward +0.10 m/s")
    assert walk.words["walks"].startswith(f"forward {walk.velocity[0]:+.2f} m/s")
    walk.press("SPACE")
    for _ in range(40):
        walk.advance(0.1)
    assert np.abs(walk.velocity).max() < 0.01 and walk.out.at_rest
    walk.press("W")
    walk.press("R")
    assert walk.steering.command == (0, 0, 0)
    assert np.array_equal(walk.data.qpos, start)
    assert walk.words["mahru"] == "0.00 s" and not walk.closed
    walk.press("ESCAPE")
    assert walk.closed


def test_time_is_kept_between_frames():
    walk = LiveWalk("mahru")
    for _ in range(30):
        walk.advance(0.0333)  # no whole number of steps
    assert walk.data.time == pytest.approx(0.999, abs=0.0011)


def test_a_robot_that_fell_stays_and_says_so():
    walk = LiveWalk("mahru")
    walk.data.qpos[2] -= 0.4
    walk.advance(0.01)
    assert walk.out.fell
    t = walk.data.time
    walk.advance(0.5)
    assert walk.data.time == t
    assert walk.words["fell"].endswith("R restarts")
    walk.press("R")
    assert "fell" not in walk.words


def test_without_a_display_it_says_so_in_one_line(zmpwalk_command):
    env = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    done = zmpwalk_command("view", env=env)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == (
        "zmpwalk: cannot open a window: there is no display (DISPLAY is not set); zmpwalk video films a walk\n"
    )
    done = zmpwalk_command("view", env={**env, "DISPLAY": ":98765"})
    assert done.returncode == 2
    assert len(done.stderr.splitlines()) == 1 and "cannot open a window: " in done.stderr


def test_bad_speed_is_refused_before_a_window_opens():
    with pytest.raises(InputError, match="speed is 0; it must be positive"):
        view(speed=0.0)


SCRIPT = """
import sys
import glfw, numpy as np
from zmpwalk.view import view

count, seen = 0, []

def frame(window, walk):
    global count
    count += 1
    seen.append(window.picture())
    if count == 2:
        window.key(None, glfw.KEY_W, 0, glfw.PRESS, 0)
        window.key(None, glfw.KEY_W, 0, glfw.REPEAT, 0)
        window.key(None, glfw.KEY_W, 0, glfw.RELEASE, 0)
        window.key(None, glfw.KEY_F1, 0, glfw.PRESS, 0)
    if count == 3:
        window.scroll(None, 0.0, 5.0)
        window.cursor(None, 30.0, 40.0)  # no button is down
    if count == 5:
        print(*walk.steering.command)
        window.key(None, glfw.KEY_ESCAPE, 0, glfw.PRESS, 0)

view("mahru", width=320, height=240, shadows=False, on_frame=frame)
assert count == 5 and seen[0].shape == (240, 320, 3)
print(np.mean(seen[0] != seen[-1]), seen[0].std())
"""


@pytest.fixture
def display():
    """A display in memory."""
    if not shutil.which("Xvfb"):
        pytest.skip("no Xvfb")
    read, write = os.pipe()
    command = ["Xvfb", "-displayfd", str(write), "-screen", "0", "640x480x24", "-nolisten", "tcp"]
    server = subprocess.Popen(command, pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(write)
    with os.fdopen(read) as answer:
        number = answer.readline().strip()
    yield f":{number}"
    server.terminate()
    server.wait()


def test_window_shows_the_robot_and_takes_keys(display):
    env = {name: value for name, value in os.environ.items() if name not in ("MUJOCO_GL", "WAYLAND_DISPLAY")}
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT], env={**env, "DISPLAY": display}, capture_output=True, text=True, timeout=120
    )
    if "cannot draw in a window" in done.stderr or "GLX" in done.stderr:
        pytest.skip(done.stderr.splitlines()[-1])
    assert done.returncode == 0, done.stderr
    command, picture = done.stdout.splitlines()
    assert float(command.split()[0]) > 0.1  # two presses of W, and F1 is nothing
    changed, contrast = map(float, picture.split())
    assert changed > 0.02 and contrast > 10
