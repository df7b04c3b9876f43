"""Shared by the Python tests: a made-up walk whose every number is known, and where the test robots are."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

GRAVITY, Z_C, MASS = 9.81, 0.73, 60.0
T_C = np.sqrt(Z_C / GRAVITY)
T_SS, T_DS, FIRST_DS = 0.64, 0.16, 0.18
SLOPE = 1.14  # d zmp_est / d r_ref: the links' angular momentum adds 14 % to the pendulum's 1
HALF_LENGTH, HALF_WIDTH, BOUND, FOOT_Y = 0.125, 0.07, (0.09, 0.05), 0.11
PAPER = ([0.0, 0.8, 1.6, 2.4], [0.063, 0.156, 0.219, 0.25])


def walk_columns(duration=8.0, profile=None, dt=0.001):
    """Columns of a point mass that follows the velocity profile over feet that step under it.

    Sagittally a smooth tracker inside ZMP bounds, with a made-up whole-body disturbance of the ZMP; laterally the
    pendulum (17) that swings between the feet, switched where w(T) of (18) is zero.
    """
    n = round(duration / dt)
    t = dt * np.arange(n)
    if profile is None:
        v_plan = np.asarray(PAPER[1])[np.searchsorted(PAPER[0], t + 1e-9, side="right") - 1]
    else:
        v_plan = np.array([profile.velocity(s)[0] for s in t])
    c = {
        name: np.zeros((n, 3)) for name in ("com", "dcom", "com_des", "dcom_des", "v_plan", "v_des", "v_error_integral")
    }
    c.update(
        {
            name: np.zeros((n, 2))
            for name in (
                ["zmp_des", "zmp_ref", "zmp_est", "zmp_meas", "zmp_lower", "zmp_upper", "zmp_first", "zmp_modified"]
            )
        }
    )
    c.update(
        {
            name: np.zeros(n)
            for name in (
                ["phase", "support", "iterations", "fell", "saturated", "damped", "step", "phase_time", "torque_ratio"]
            )
        }
    )
    c.update(
        t=t,
        foot_left=np.zeros((n, 7)),
        foot_right=np.zeros((n, 7)),
        w_T=np.full(n, np.nan),
        foothold=np.full((n, 3), np.nan),
    )
    c.update(zmp_slope=np.full((n, 2), SLOPE), f_c=np.full((n, 12), np.nan), contact_wrench=np.full((n, 12), np.nan))

    x, v, integral, y, w = 0.0, 0.0, 0.0, 0.0, 0.0
    feet, support, k, start, end, step, switched = (
        [0.0, 0.0],
        -1,
        0,
        0.0,
        FIRST_DS,
        0,
        False,
    )  # feet: x of left and right
    for i, now in enumerate(t):
        if now >= end - 1e-9:
            k, start = 1 - k, end
            end += T_SS if k else T_DS
            if k:
                foot_from = feet[0 if support < 0 else 1]
                foothold = x + v_plan[i] * (T_SS + T_DS / 2) + 0.4 * v_plan[i]
            else:
                step, switched = step + 1, False
        swing = 0 if support < 0 else 1
        s = now - start
        lift = 0.0
        if k:
            u = s / T_SS
            feet[swing] = foot_from + (foothold - foot_from) * u * u * (3 - 2 * u)
            lift = 0.04 * 16 * (u * (1 - u)) ** 2
            c["foothold"][i] = foothold, FOOT_Y * -support, 0
        elif not switched:
            remaining = end - now - dt + T_SS / 2
            c["w_T"][i] = (np.sinh(remaining / T_C) * (y + support * FOOT_Y) + np.cosh(remaining / T_C) * T_C * w) / T_C
            if c["w_T"][i] * support <= 0:
                support, switched = -support, True
        stance_x, stance_y = feet[0 if support > 0 else 1], FOOT_Y * support
        # whole-body disturbance of the ZMP: the swing leg, and the blow of the touch-down
        disturbance = v_plan[i] * (0.22 * np.sin(2 * np.pi * s / T_SS) if k else 0.8 * np.exp(-s / 0.06))
        want = (v_plan[i] - 4 * integral - v) / 0.05
        lower, upper = (np.array([stance_x, stance_y]) + sign * np.array(BOUND) for sign in (-1, 1))
        if not k:
            lower, upper = (
                np.array([edge(feet), sign * FOOT_Y]) + sign * np.array(BOUND) for edge, sign in ((min, -1), (max, 1))
            )
        need = x - T_C**2 * want + disturbance
        zmp = np.array([np.clip(need, lower[0], upper[0]), stance_y])
        accelerations = (x + disturbance - zmp[0]) / T_C**2, (y - stance_y) / T_C**2
        c["com"][i], c["dcom"][i] = (x, y, Z_C), (v, w, 0)
        c["v_plan"][i, 0], c["v_des"][i, 0], c["v_error_integral"][i, 0] = v_plan[i], v, integral
        c["zmp_des"][i], c["zmp_ref"][i] = zmp, zmp - np.array([disturbance / SLOPE, 0])
        c["zmp_modified"][i, 0] = np.sign(zmp[0] - need) * -1 if zmp[0] != need else 0
        c["zmp_first"][i] = zmp + np.array([disturbance, 0.004 * np.sin(7 * now)])
        c["zmp_est"][i] = zmp + 2e-4 * np.array([np.sin(40 * now), np.cos(40 * now)])
        c["zmp_lower"][i], c["zmp_upper"][i] = lower, upper
        contact_blow = 0.02 * np.exp(-s / 0.005) * np.cos(s / 0.002) if not k and step else 0.0
        c["zmp_meas"][i] = c["zmp_est"][i] + contact_blow * np.array([1, -0.5]) + 5e-6
        c["phase"][i], c["support"][i], c["step"][i], c["phase_time"][i] = k, support, step, s
        c["iterations"][i] = 3 if c["zmp_modified"][i, 0] else 1
        c["torque_ratio"][i] = 0.5 + 0.1 * np.sin(now)
        for side, (name, sign) in enumerate((("foot_left", 1), ("foot_right", -1))):
            c[name][i] = feet[side], sign * FOOT_Y, lift if k and side == swing else 0.0, 1, 0, 0, 0
            if not (k and side == swing):
                for wrench in ("f_c", "contact_wrench"):
                    c[wrench][i, 6 * side : 6 * side + 6] = 0, 0, -MASS * GRAVITY / (1 if k else 2), 0, 0, 0
        x, v = x + dt * v + accelerations[0] * dt**2 / 2, v + accelerations[0] * dt
        y, w = (
            np.cosh(dt / T_C) * (y - stance_y) + np.sinh(dt / T_C) * T_C * w + stance_y,
            np.sinh(dt / T_C) * (y - stance_y) / T_C + np.cosh(dt / T_C) * w,
        )
        integral += dt * (v - v_plan[i])
    c["com_des"], c["dcom_des"] = c["com"] + 1e-4, c["dcom"] + 1e-3
    c["tau"] = np.full((n, 25), 20.0)
    c["qpos"], c["qvel"] = np.zeros((n, 32)), np.zeros((n, 31))
    return c


def walk_meta(**changes):
    """Meta data that goes with `walk_columns`, as `zmpwalk.simulate` would write it."""
    foot = {
        "foot_body": "l_foot",
        "sole_site": "left_sole",
        "sole_center": [0, 0, 0],
        "length": 2 * HALF_LENGTH,
        "width": 2 * HALF_WIDTH,
    }
    meta = {
        "robot": "made-up", "source": "simulate", "seed": 0, "timestep": 0.001, "control_dt": 0.001,
        "settings": {"law": "default", "T_ss": T_SS, "T_ds": T_DS, "footsteps": "tied"},
        "description": {"name": "made-up", "left": foot, "right": dict(foot, foot_body="r_foot")},
        "profile": {"t": PAPER[0], "v": [[v, 0.0, 0.0] for v in PAPER[1]], "interpolation": "hold"},
        "versions": {"mujoco": "2.2.2", "zmpwalk": "0"}, "fell": False, "fall_time": None, "fall_cause": "",
        "timing": {"cycle_us": {"median": 90.0, "p99": 120.0}, "wall_time": 1.6, "real_time_factor": 5.0},
    }  # fmt: skip
    meta.update(changes)
    return meta


@pytest.fixture(scope="session")
def made_up():
    """The made-up walk's makers and constants."""
    from zmpwalk.trace import Trace

    return SimpleNamespace(
        columns=walk_columns,
        meta=walk_meta,
        changed=lambda columns, **values: Trace({**columns, **values}, walk_meta()),
        PAPER=PAPER,
        MASS=MASS,
        FIRST_DS=FIRST_DS,
    )


@pytest.fixture(scope="session")
def made_up_columns():
    return walk_columns()


@pytest.fixture
def made_up_trace(made_up_columns):
    from zmpwalk.trace import Trace

    return Trace(made_up_columns, walk_meta())


@pytest.fixture(scope="session")
def walked():
    """A short walk of the bundled robot, simulated once."""
    import zmpwalk

    return zmpwalk.simulate("mahru", duration=1.5)


def edited_mahru(*changes):
    """The bundled robot's MJCF after each of `changes` has worked on its tree, its sensors gone."""
    from zmpwalk.robots import ROBOTS

    root = ET.parse(ROBOTS / "mahru.xml").getroot()
    root.remove(root.find("sensor"))
    for change in changes:
        change(root)
    return ET.tostring(root, encoding="unicode")


def hang_pelvis_from_torso(root):
    """Make the torso the floating base: the waist then stands between it and both legs. The robot stays the same."""
    world = root.find("worldbody")
    pelvis = world.find("body[@name='pelvis']")
    torso = pelvis.find("body[@name='torso']")
    world.remove(pelvis)
    pelvis.remove(torso)
    torso.set("pos", "0 0 0.85")
    torso.set("childclass", pelvis.attrib.pop("childclass"))
    waist, free = torso.find("joint"), pelvis.find("freejoint")
    torso.remove(waist)
    pelvis.remove(free)
    waist.set("pos", "0 0 0.1")
    pelvis.set("pos", "0 0 -0.1")
    torso.insert(0, free)
    pelvis.insert(0, waist)
    torso.insert(1, pelvis)
    world.append(torso)
    key = root.find("keyframe/key")
    qpos = key.get("qpos").split()
    qpos[2] = str(float(qpos[2]) + 0.1)
    key.set("qpos", " ".join([*qpos[:7], qpos[19], *qpos[7:19], *qpos[20:]]))


@pytest.fixture(scope="session")
def mahru_edited():
    """`edited_mahru` and the change that puts the waist between base and legs."""
    return SimpleNamespace(xml=edited_mahru, hang_pelvis_from_torso=hang_pelvis_from_torso)


@pytest.fixture(scope="session")
def test_robots():
    """The folder of third-party robots that the project does not ship."""
    folder = os.environ.get("ZMPWALK_TEST_ROBOTS")
    if not folder or not Path(folder).is_dir():
        pytest.skip("ZMPWALK_TEST_ROBOTS names no folder of test robots")
    return Path(folder)


@pytest.fixture(scope="session")
def zmpwalk_command():
    """Runs the command line as a user would, in a process of its own."""

    def run(*arguments, **kw):
        command = [sys.executable, "-m", "zmpwalk", *map(str, arguments)]
        return subprocess.run(command, capture_output=True, text=True, timeout=300, **kw)

    return run


@pytest.fixture
def ctrl_c():
    """Ctrl-C works as on a terminal: a shell that starts tests in the background has switched it off."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)
