"""The live window: keys into commands without a window, the walk behind it, and the window itself where Xvfb is."""

import ctypes.util
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk import InputError
from zmpwalk.live import KEYS, LEGEND
from zmpwalk.view import LiveWalk, Steering, ray, view

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
    walk.data.qpos[3:7] = [0.8, 0, 0.6, 0]  # it leans by 74 degrees
    walk.advance(2.0)
    assert walk.out.fell
    t = walk.data.time
    walk.advance(0.5)
    assert walk.data.time == t
    assert walk.words["fell"].endswith("R restarts")
    walk.press("R")
    assert "fell" not in walk.words


def walking(seconds=3.0, presses=5):
    walk = LiveWalk("mahru")
    for _ in range(presses):
        walk.press("W")
    walk.advance(seconds)
    return walk


@pytest.mark.parametrize(("key", "axis", "sign"), [("UP", 0, 1), ("DOWN", 0, -1), ("LEFT", 1, 1), ("RIGHT", 1, -1)])
def test_shift_and_an_arrow_push_the_robot_by_the_chosen_impulse(key, axis, sign):
    pushed, quiet = LiveWalk("mahru"), LiveWalk("mahru")
    for walk in (pushed, quiet):
        walk.advance(0.5)
    pushed.press("1")
    pushed.press(key, shift=True)
    assert pushed.steering.command == (0, 0, 0)
    assert len(pushed.arrows) == 1 and np.sign(pushed.arrows[0]["along"][axis]) == sign
    for walk in (pushed, quiet):
        walk.advance(0.083)
    gained = (pushed.out.dcom - quiet.out.dcom)[axis]
    assert sign * gained == pytest.approx(0.05, abs=0.02)  # 0.05 N s/kg; the ankles have begun to resist
    assert (pushed.data.xfrc_applied == 0).all()
    pushed.advance(0.5)
    assert pushed.arrows == []


def test_a_push_follows_the_heading():
    walk = LiveWalk("mahru")
    walk.press("LEFT")
    walk.press("LEFT")
    walk.advance(8.0)
    walk.press("UP", shift=True)
    along = walk.arrows[0]["along"]
    assert walk.out.heading > 0.5
    assert np.arctan2(along[1], along[0]) == pytest.approx(walk.out.heading, abs=1e-6)


def test_pause_holds_the_walk_and_one_cycle_at_a_time_goes_on():
    walk = walking(1.0)
    walk.press("P")
    t = walk.data.time
    walk.advance(1.0)
    assert walk.data.time == t and "paused" in walk.words["mahru"]
    walk.press("N")
    assert walk.data.time == pytest.approx(t + walk.model.opt.timestep)
    walk.press("P")
    walk.advance(0.1)
    assert walk.data.time == pytest.approx(t + 0.101, abs=0.0011)
    walk.press("N")  # pauses a walk that goes on
    assert walk.paused


def test_the_pace_is_halved_and_doubled_and_said():
    walk = LiveWalk("mahru")
    walk.press("MINUS")
    walk.press("MINUS")
    assert walk.pace == 0.25 and "0.25 x real time" in walk.words["mahru"]
    for _ in range(12):
        walk.press("EQUAL")
    assert walk.pace == 4.0
    for _ in range(20):
        walk.press("MINUS")
    assert walk.pace == 2.0**-6
    assert LiveWalk("mahru", pace=0.3).pace == 0.3


def test_a_recording_is_written_and_can_be_read_again(tmp_path):
    walk = LiveWalk("mahru", record=tmp_path / "mine.npz")
    walk.press("W")
    walk.advance(1.0)
    walk.press("T")
    walk.advance(0.5)
    walk.press("LEFT", shift=True)
    assert "recording, 0.5 s" in walk.words["mahru"]
    walk.advance(0.5)
    walk.press("T")
    assert walk.recorded == [tmp_path / "mine.npz"] and "written: mine.npz" in walk.words["mahru"]
    trace = zmpwalk.Trace.load(walk.recorded[0])
    assert (trace.t[0], trace.t[-1]) == pytest.approx((1.0, 1.999), abs=0.002)
    ((t, duration, body, wrench),) = trace.meta["push"]
    assert (t, duration, body) == (pytest.approx(1.5, abs=0.002), 0.08, "torso")
    assert wrench[1] == pytest.approx(0.15 * walk.controller.mass / 0.08)
    walk.press("T")
    walk.advance(0.1)
    walk.press("R")  # writes before it restarts, and into a file of its own
    assert [path.name for path in walk.recorded] == ["mine.npz", "mine-2.npz"]
    walk.press("T")
    walk.press("T")  # nothing happened: nothing is written
    assert len(walk.recorded) == 2


def test_a_recording_goes_into_a_trace_file_only():
    with pytest.raises(InputError, match=r"a recorded walk is a \.npz file"):
        LiveWalk("mahru", record="walk.mp4")


def test_a_pull_draws_a_link_towards_a_point_and_lets_go():
    walk, quiet = LiveWalk("mahru"), LiveWalk("mahru")
    torso = walk.pick(np.array([-3.0, 0.0, 1.1]), np.array([1.0, 0.0, 0.0]))
    assert mujoco.mj_id2name(walk.model, mujoco.mjtObj.mjOBJ_BODY, torso) == "torso"
    assert walk.pick(np.array([-3.0, 0.0, 9.0]), np.array([1.0, 0.0, 0.0])) is None
    walk.pull(torso, walk.data.xipos[torso] + [0.0, 0.05, 0.0])
    for each in (walk, quiet):
        each.advance(0.3)
    assert walk.out.com[1] > quiet.out.com[1] + 0.002
    assert len(walk.arrows) == 1
    walk.pull(None)
    assert walk.arrows == []
    walk.advance(3.0)
    assert walk.out.at_rest and abs(walk.out.com[1] - quiet.out.com[1]) < 0.03


def test_the_support_polygon_and_the_next_footsteps_are_where_the_feet_stand_and_will_land():
    walk = LiveWalk("mahru")
    (polygon,) = walk.outlines
    low, high = polygon["corners"].min(axis=0), polygon["corners"].max(axis=0)
    assert high - low == pytest.approx([0.25, 0.22 + 0.14], abs=1e-3)  # both soles
    walk = walking(4.0)
    while not (walk.out.phase == 1 and walk.out.phase_time > 0.3):
        walk.advance(0.01)
    stance, *steps = (outline["corners"] for outline in walk.outlines)
    assert stance.max(axis=0) - stance.min(axis=0) == pytest.approx([0.25, 0.14], abs=1e-3)
    planned = [corners.mean(axis=0) for corners in steps]
    assert len(planned) == 3
    assert planned[0] == pytest.approx(walk.out.foothold[:2])
    landed = []
    while len(landed) < 3:
        swing = walk.out.foot_right if walk.out.support > 0 else walk.out.foot_left
        before = walk.out.phase
        walk.advance(0.001)
        if before == 1 and walk.out.phase == 0:
            landed.append(np.array(swing[:2]))
    for foot, place in zip(landed, planned):
        assert foot == pytest.approx(place, abs=0.015)


def test_the_marks_are_zmp_com_and_dcm_in_the_colours_of_the_legend():
    walk = walking(2.0)
    marks = {tuple(mark["rgba"]): np.array(mark["pos"][:2]) for mark in walk.marks}
    assert marks[LEGEND["zmp"][0]] == pytest.approx(walk.out.zmp_est)
    assert marks[LEGEND["com"][0]] == pytest.approx(walk.out.com[:2])
    assert marks[LEGEND["dcm"][0]] == pytest.approx(walk.out.com[:2] + walk.controller.Tc * walk.out.dcom[:2])


def test_a_ray_through_a_point_of_the_picture_hits_what_is_seen_there():
    camera = mujoco.MjvCamera()
    camera.lookat[:] = (0.3, -0.2, 0.9)
    camera.distance, camera.azimuth, camera.elevation = 2.5, 37.0, -22.0
    eye, along = ray(camera, 45.0, 640, 480, 320, 240)  # the middle sees the point that is looked at
    assert eye + 2.5 * along == pytest.approx(camera.lookat)
    _, up = ray(camera, 45.0, 640, 480, 320, 0)
    assert np.degrees(np.arccos(up @ along)) == pytest.approx(22.5)
    assert up[2] > along[2]
    _, right = ray(camera, 45.0, 640, 480, 640, 240)
    assert np.cross(along, right)[2] < 0  # clockwise from above is right


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


def test_the_page_of_the_window_lists_its_keys():
    page = (Path(__file__).parents[2] / "docs" / "viewer.md").read_text(encoding="utf-8")
    assert dict(re.findall(r"^\| `(.+?)` \| (.+?) \|$", page, re.M)) == KEYS


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
    if count == 4:
        bar = window._picture().bottom
        for key, mods in ((glfw.KEY_P, 0), (glfw.KEY_5, 0), (glfw.KEY_RIGHT, glfw.MOD_SHIFT), (glfw.KEY_T, 0)):
            window.key(None, key, 0, glfw.PRESS, mods)
        window.key(None, glfw.KEY_N, 0, glfw.PRESS, 0)
        plain = window.picture()
        window.key(None, glfw.KEY_H, 0, glfw.PRESS, 0)
        shown = window.picture()
        assert (plain != shown).any() and (plain[-bar:] == shown[-bar:]).all()
        assert len(walk.arrows) == 1 and walk.paused
        eye, _ = window._ray(0.0, 0.0)
        along = walk.data.xipos[walk._trunk] - eye
        window.hold(eye, along / np.linalg.norm(along))
        window.cursor(None, 200.0, 40.0)
        assert len(walk.arrows) == 2
        window.key(None, glfw.KEY_N, 0, glfw.PRESS, 0)
        window.button(None, glfw.MOUSE_BUTTON_LEFT, glfw.RELEASE, 0)
        assert len(walk.arrows) == 1
        window.key(None, glfw.KEY_T, 0, glfw.PRESS, 0)
        print(walk.recorded[0].name, len(walk.recorded))
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


def test_window_shows_the_robot_and_takes_keys_and_mouse(display, tmp_path):
    env = {name: value for name, value in os.environ.items() if name not in ("MUJOCO_GL", "WAYLAND_DISPLAY")}
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT],
        env={**env, "DISPLAY": display},
        capture_output=True,
        text=True,
        timeout=120,
        cwd=tmp_path,
    )
    if "cannot draw in a window" in done.stderr or "GLX" in done.stderr:
        pytest.skip(done.stderr.splitlines()[-1])
    assert done.returncode == 0, done.stderr
    recorded, command, picture = done.stdout.splitlines()
    assert recorded == "walk.npz 1"
    assert len(zmpwalk.Trace.load(tmp_path / "walk.npz").t) == 2  # two cycles, one after the other
    assert float(command.split()[0]) > 0.1  # two presses of W, and F1 is nothing
    changed, contrast = map(float, picture.split())
    assert changed > 0.02 and contrast > 10


REAL = """
import ctypes, sys
import glfw
from zmpwalk.view import view

x11, xtest = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXtst.so.6")
x11.XOpenDisplay.restype = ctypes.c_void_p
screen = ctypes.c_void_p(x11.XOpenDisplay(None))
x11.XStringToKeysym.restype = ctypes.c_ulong
glfw.get_x11_window.restype = ctypes.c_ulong


def key(name, down):
    code = x11.XKeysymToKeycode(screen, ctypes.c_ulong(x11.XStringToKeysym(name.encode())))
    xtest.XTestFakeKeyEvent(screen, code, down, ctypes.c_ulong(0))


def tap(name, held=None):
    for each, down in [(held, 1)] * bool(held) + [(name, 1), (name, 0)] + [(held, 0)] * bool(held):
        key(each, down)


def button(down):
    xtest.XTestFakeButtonEvent(screen, 1, down, ctypes.c_ulong(0))


def point(window, right):
    x, y = glfw.get_window_pos(window._window)
    width, _ = glfw.get_window_size(window._window)
    down = round(window._picture().height / 2)
    xtest.XTestFakeMotionEvent(screen, -1, x + width // 2 + right, y + down, ctypes.c_ulong(0))


def seen(window):
    return glfw.get_cursor_pos(window._window)[0] - glfw.get_window_size(window._window)[0] // 2


# What a person does, and what has come of it.
PLAN = [
    (lambda w: x11.XSetInputFocus(screen, ctypes.c_ulong(glfw.get_x11_window(w._window)), 1, ctypes.c_ulong(0)),
     lambda w, walk: glfw.get_window_attrib(w._window, glfw.FOCUSED)),
    (lambda w: tap("w"), lambda w, walk: walk.steering.command[0] > 0),
    (lambda w: tap("t"), lambda w, walk: "recording" in walk.words["mahru"]),
    (lambda w: tap("Up", "Shift_L"), lambda w, walk: len(walk.arrows) == 1 and walk.arrows[0]["along"][0] > 0),
    (lambda w: tap("p"), lambda w, walk: walk.paused),
    (lambda w: tap("minus"), lambda w, walk: walk.pace == 0.5),
    (lambda w: tap("p"), lambda w, walk: not walk.paused),
    (lambda w: point(w, 0), lambda w, walk: abs(seen(w)) < 2),
    (lambda w: (key("Control_L", 1), button(1)), lambda w, walk: walk._pull is not None),
    (lambda w: point(w, 40), lambda w, walk: walk._pulling()[1] < -10),  # to the right
    (lambda w: (button(0), key("Control_L", 0)), lambda w, walk: walk._pull is None),
    (lambda w: point(w, 90), lambda w, walk: abs(seen(w) - 90) < 2),
    (lambda w: tap("t"), lambda w, walk: len(walk.recorded) == 1),
    (lambda w: tap("Escape"), lambda w, walk: walk.closed),
]
step, waited = 0, 0


def frame(window, walk):
    global step, waited
    if step == len(PLAN):
        return
    act, done = PLAN[step]
    if waited == 0:
        act(window)
        x11.XFlush(screen)
    waited += 1
    if waited > 1 and done(window, walk):
        step, waited = step + 1, 0
    elif waited > 300:
        sys.exit(f"nothing came of action {step}")


view("mahru", width=320, height=240, shadows=False, on_frame=frame)
assert step >= len(PLAN) - 1
"""


def test_real_keys_and_a_real_mouse_reach_the_walk(display, tmp_path):
    if not ctypes.util.find_library("Xtst"):
        pytest.skip("no libXtst, which makes events of keys and mouse")
    env = {name: value for name, value in os.environ.items() if name not in ("MUJOCO_GL", "WAYLAND_DISPLAY")}
    done = subprocess.run(
        [sys.executable, "-c", REAL], env={**env, "DISPLAY": display}, capture_output=True, text=True, timeout=240,
        cwd=tmp_path,
    )  # fmt: skip
    if "cannot draw in a window" in done.stderr or "GLX" in done.stderr:
        pytest.skip(done.stderr.splitlines()[-1])
    assert done.returncode == 0, done.stderr
    assert zmpwalk.Trace.load(tmp_path / "walk.npz").meta["push"][0][3][0] > 0
