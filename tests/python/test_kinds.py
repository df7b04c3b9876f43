"""Kinds of robots that went wrong once: each an edit of the bundled robot, with the right answer.

A little ZMP room ahead, B a clock that counts calls, C a floor above the soles, D joint ranges, E a base on slides,
F a newer MJCF, G objects between processes, H kinds of files, I a sole on the ankle's other link, J a renderer without
its library, K soles of meshes.
"""

import json
import os
import pickle
import re
import subprocess
import sys

import mujoco
import numpy as np
import pytest
import zmpwalk
from mahru_text import TEXT, bare, edited
from zmpwalk import ModelError, analysis, cli
from zmpwalk.robots import examine
from zmpwalk.shortfalls import shortfalls
from zmpwalk.tryout import try_out

BOX = '<geom type="box" size="0.125 0.07 0.015" pos="0.02 0 -0.075"/>'
FLOOR = '<geom name="floor" type="plane" size="0 0 0.05" material="floor"/>'
ROLL = '<joint class="hip_roll" name="l_hip_roll"/>'


@pytest.fixture
def file(tmp_path):
    """Writes a text into a file of the test's own."""

    def write(text, name="robot.xml"):
        (tmp_path / name).write_text(text)
        return tmp_path / name

    return write


def mean_of(trace, first=4):
    """Mean velocity (vx, vy, wz) from that touch-down on, over whole strides."""
    landed = 1 + np.flatnonzero((trace.phase[:-1] == 1) & (trace.phase[1:] == 0))[first - 1 :]
    landed = landed[: 1 + 2 * ((len(landed) - 1) // 2)]
    begin, end = landed[0], landed[-1]
    before, after = analysis.feet_pose(trace.foot_left[[begin, end]], trace.foot_right[[begin, end]])
    return analysis.mean_velocity(before, after, trace.t[end] - trace.t[begin])


# --- A


def foot_ahead(ankle):
    """Soles 3 cm further ahead of the ankle, whose pitch motors give `ankle` N m."""
    motor = '<motor ctrlrange="-150 150"/>\n      </default>\n      <default class="ankle_roll">'
    moved = [(f'pos="0.02 0 {z}"', f'pos="0.05 0 {z}"') for z in (-0.075, -0.09)]
    return bare(edited(*moved, (motor, motor.replace("150", str(ankle)))))


@pytest.mark.parametrize(("ankle", "room"), [(41, 0.010), (36, 0.003)])
def test_kind_A_little_room_ahead_walks_at_its_speed(file, ankle, room):
    model, proposal = examine(file(foot_ahead(ankle)))
    (lower, upper), _ = proposal.table["zmp_bounds_m"]["left"], None
    assert upper[0] == pytest.approx(room, abs=1e-3)
    assert proposal.description.stand_ahead(model) == pytest.approx((lower[0] + upper[0]) / 2)
    assert any("ahead of the sole's middle and 90 mm behind it" in remark for remark in proposal.remarks)
    for v in ((-0.05, 0, 0), (0.05, 0, 0), (0.1, 0, 0), (-0.1, 0, 0), (0, 0, 0.2)):  # from a jump at t = 0
        trace = zmpwalk.simulate((model, proposal.description), profile=v, duration=6.0)
        assert not trace.meta["fell"], (v, trace.meta["fall_cause"])
        assert mean_of(trace) == pytest.approx(v, rel=0.02, abs=0.003)
        assert shortfalls(trace) == []
        assert trace.torque_ratio.max() < 1.0


def test_kind_A_a_start_from_over_the_middle_of_the_sole_is_caught(file):
    """A robot.json whose stand was made before the room was known: the COM comes to the middle of the bounds."""
    model, proposal = examine(file(foot_ahead(41)))
    data = mujoco.MjData(model)
    proposal.description.place(model, data)
    data.qpos[0] -= proposal.description.stand_ahead(model)  # feet and COM
    controller = zmpwalk.WalkingController(model, proposal.description, profile=0.0)
    controller.reset(data)
    while data.time < 3.0:
        out = controller.update(data)
        mujoco.mj_step(model, data)
    assert not out.fell
    middle = 0.5 * (out.foot_left[:2] + out.foot_right[:2])
    assert out.com[0] - middle[0] == pytest.approx(proposal.description.stand_ahead(model), abs=1e-3)


def test_kind_A_a_robot_whose_soles_bound_the_zmp_rides_where_it_did():
    model, description = zmpwalk.load_robot("mahru")
    assert description.stand_ahead(model) == 0.0


# --- B


def test_kind_B_the_cycle_goes_by_the_time_of_the_data():
    model, description = zmpwalk.load_robot("mahru")
    controller, data = zmpwalk.WalkingController(model, description, profile=0.1), mujoco.MjData(model)
    description.place(model, data)
    controller.reset(data)
    fresh = 0
    while data.time < 0.1 - 1e-9:
        fresh += controller.update(data).fresh
        controller.update(data)  # a second call at the same time is no second cycle
        mujoco.mj_step(model, data)
    assert fresh == controller.cycles == 100


# --- C


@pytest.mark.parametrize("mm", [2, 10, 30])
def test_kind_C_soles_are_put_on_a_floor_that_is_above_them(file, mm):
    path = file(edited((FLOOR, FLOOR.replace("/>", f' pos="0 0 {mm / 1000}"/>'))))
    trace = zmpwalk.simulate(path, profile=0.1, duration=2.5)
    assert not trace.meta["fell"]
    assert trace.foot_left[0, 2] == pytest.approx(mm / 1000, abs=1e-6)
    assert max(trace.summary()["zmp_error_mm"]["p95"]) < 0.5
    model, description = zmpwalk.load_robot(path)
    data = mujoco.MjData(model)
    description.place(model, data, 0.0)  # a height that is given is kept
    assert data.site("left_sole").xpos[2] == pytest.approx(0.0, abs=1e-9)


def test_kind_C_inspect_names_the_floor(file, capsys):
    path = file(edited((FLOOR, FLOOR.replace("/>", ' pos="0 0 0.01"/>'))))
    assert cli.main(["inspect", str(path)]) == 0
    assert "floor: it lies 10 mm above the soles of the start pose" in capsys.readouterr().out


# --- D


def test_kind_D_a_short_range_is_kept_and_told(file, capsys):
    path = file(edited((ROLL, ROLL.replace("/>", ' range="-0.1 0.8"/>'))))
    assert cli.main(["inspect", str(path)]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "l_hip_roll came to 0.000 rad from the end of its range, -0.100 rad" in said
    trace = zmpwalk.simulate(path, profile=0.2, duration=4.0)
    assert not trace.meta["fell"]
    assert max(trace.summary()["zmp_error_mm"]["single_support_p95"]) < 0.1  # no stop that the estimate does not know


def test_kind_D_degrees_read_as_radians_are_guessed_and_the_stop_is_named(file, tmp_path, capsys):
    path = file(edited((ROLL, ROLL.replace("/>", ' range="-0.014 0.008"/>'))))
    assert cli.main(["inspect", str(path)]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "l_hip_roll turns only -0.014 .. +0.008 rad" in said
    assert "Was -0.80 .. +0.46 meant" in said
    assert "it fell" in said
    words = ["--profile", "0.2", "--duration", "3", "--no-figures", "--out", str(tmp_path / "o")]
    assert cli.main(["walk", "--robot", str(path), *words]) == 3
    assert re.search(r"before it fell: stop: l_hip_roll leaned on the \w+ end of its range", capsys.readouterr().err)


def test_kind_D_a_stand_outside_a_range_is_named(file):
    path = file(edited((ROLL, ROLL.replace("/>", ' range="0.2 0.8"/>'))))
    remarks = examine(path)[1].remarks
    assert any("l_hip_roll stands at +0.000 rad, outside its range +0.200 .. +0.800 rad" in each for each in remarks)


# --- E


def test_kind_E_joints_in_place_of_a_free_one_are_named(file):
    planar = "".join(
        f'<joint name="{name}" type="{kind}" axis="{axis}"/>'
        for name, kind, axis in (("rx", "slide", "1 0 0"), ("rz", "slide", "0 0 1"), ("ry", "hinge", "0 1 0"))
    )
    with pytest.raises(ModelError) as caught:
        examine(file(bare(edited(('<freejoint name="root"/>', planar)))))
    said = str(caught.value)
    assert "'rx' (slide), 'rz' (slide), 'ry' (hinge)" in said
    assert 'write <freejoint name="root"/> in body' in said
    assert "fixed to the world" not in said


# --- F


def test_kind_F_a_newer_mjcf_names_the_version_that_reads_it(file):
    path = file(edited(('name="l_knee"/>', 'name="l_knee" actuatorfrcrange="-160 160"/>')))
    if tuple(map(int, mujoco.__version__.split(".")[:2])) >= (3, 0):
        assert examine(path)[1].table["speed_limit_mps"] > 0.5
        return
    with pytest.raises(ModelError, match=r"needs MuJoCo 3\.0\.0 or later, and this is 2\.\d+\.\d+"):
        examine(path)


# --- G


def test_kind_G_what_does_not_cross_processes_says_what_does():
    model, description = zmpwalk.load_robot("mahru")
    assert pickle.loads(pickle.dumps(description)).name == description.name
    with pytest.raises(TypeError, match="send what it was made from"):
        pickle.dumps(zmpwalk.WalkingController(model, description))


# --- H


def test_kind_H_files_of_other_kinds_are_read_or_say_what_they_lack(file):
    assert zmpwalk.load_robot(file(TEXT, "robot.mjcf"))[1].left.length == 0.25
    inertia = '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
    small = f'<robot name="r"><link name="a"><inertial><mass value="1"/>{inertia}</inertial></link></robot>'
    with pytest.raises(ModelError, match="touch nothing: no collision geom makes a sole"):
        zmpwalk.load_robot(file(small, "small.urdf"))


# --- I


def test_kind_I_a_sole_on_the_pitch_link_says_where_it_belongs(file):
    text = TEXT
    for side in "lr":
        joint, geom = (
            f'<joint class="ankle_pitch" name="{side}_ankle_pitch"/>',
            f'<geom class="sole_box" name="{side}_foot"/>',
        )
        assert geom in text
        text = text.replace(geom, "").replace(joint, joint + geom)
    with pytest.raises(ModelError) as caught:
        examine(file(bare(text)))
    for side in "lr":
        (said,) = [reason for reason in caught.value.reasons if f"'{side}_ankle'" in reason]
        assert f"below body '{side}_ankle' hangs joint '{side}_ankle_roll'" in said
        assert f"the sole's geoms and site belong to body '{side}_foot'" in said


# --- J


def test_kind_J_a_renderer_without_its_library_is_one_line(tmp_path):
    env = {**os.environ, "MUJOCO_GL": "osmesa", "LD_LIBRARY_PATH": str(tmp_path)}
    done = subprocess.run(
        [sys.executable, "-m", "zmpwalk", "inspect", "mahru"], env=env, capture_output=True, text=True, check=False
    )
    if done.returncode != 0:  # the library is there on some machines, and is not asked for by newer versions
        assert done.returncode == 2
        assert len(done.stderr.strip().splitlines()) == 1
        assert "MUJOCO_GL=osmesa" in done.stderr


# --- K

OCTAGON = " ".join(
    f"{k * x:.5f} {k * y:.5f} {z:.5f}"
    for z, k in ((-0.015, 1.0), (0.015, 0.9))
    for x, y in [
        *((sx * 0.125, sy * 0.042) for sx in (1, -1) for sy in (1, -1)),
        *((sx * 0.1, sy * 0.07) for sx in (1, -1) for sy in (1, -1)),
    ]
)


def test_kind_K_mesh_soles_say_by_how_much_the_estimate_is_off(file):
    mesh = f'<mesh name="sole" vertex="{OCTAGON}"/></asset>'
    path = file(bare(edited(("</asset>", mesh), (BOX, '<geom type="mesh" mesh="sole" pos="0.02 0 -0.075"/>'))))
    model, proposal = examine(path)
    assert any("the soles are meshes" in remark for remark in proposal.remarks)
    tried, remarks = try_out(model, proposal.description, proposal.table)
    assert tried["stood"]
    off = max(tried["zmp_error_mm"])
    told = [remark for remark in remarks if "the estimate of the ZMP is off by" in remark]
    assert bool(told) == (off > 4.0 * proposal.table["com_height_m"])
    if told:
        assert f"{off:.1f} mm" in told[0]


# --- what is told at the end


def test_a_walk_that_stood_but_fell_short_says_so_and_strict_makes_it_a_failure(file, tmp_path, capsys):
    words = ["walk", "--profile", "0.2", "--duration", "3", "--no-figures", "--out", str(tmp_path / "o")]
    assert cli.main([*words, "--strict"]) == 0
    assert "short" not in capsys.readouterr().err
    short = file(edited((ROLL, ROLL.replace("/>", ' range="-0.1 0.8"/>'))))
    words += ["--robot", str(short), "--set", "limits.keep=false"]  # so that nothing keeps the joint off its stop
    assert cli.main(words) == 0
    said = capsys.readouterr()
    assert "it stood, but fell short: stop: l_hip_roll leaned on the lower end of its range, -0.100, for" in said.err
    assert "fell short of" in said.out
    (shortfall,) = json.loads((tmp_path / "o" / "summary.json").read_text())["shortfalls"]
    assert shortfall.startswith("stop: l_hip_roll")
    assert cli.main([*words, "--strict"]) == 3


def test_a_missed_speed_is_told_with_both_numbers(made_up, made_up_columns):
    n = len(made_up_columns["t"])
    slow = {name: made_up_columns[name].copy() for name in ("foot_left", "foot_right")}
    for feet in slow.values():
        feet[:, 0] *= 0.9
    (said,) = shortfalls(made_up.changed(made_up_columns, **slow))
    assert said.startswith("speed: it walked (0.225 m/s, 0.000 m/s, 0.000 rad/s) from")
    assert said.endswith("(0.250 m/s, 0.000 m/s, 0.000 rad/s) was planned")
    for feet in slow.values():
        feet[:, 0] *= 0.97 / 0.9
    assert shortfalls(made_up.changed(made_up_columns, **slow)) == []
    assert n == len(slow["foot_left"])


def test_shortfalls_of_made_up_walks_are_what_was_made_up(made_up, made_up_columns):
    assert shortfalls(made_up.changed(made_up_columns)) == []
    n = len(made_up_columns["t"])
    cut = made_up.changed(made_up_columns, saturated=np.arange(n) % 20 == 0)
    assert [each.partition(":")[0] for each in shortfalls(cut)] == ["torque"]
    q = made_up_columns["qpos"].copy()
    q[100:400, 9] = 0.5
    stop = made_up.changed(made_up_columns, qpos=q)
    stop.meta["joint_names"] = [f"j{i}" for i in range(25)]
    stop.meta["joint_ranges"] = [[-0.3, 0.3]] * 25
    assert shortfalls(stop) == [
        "stop: j2 leaned on the upper end of its range, +0.300, for 0.30 s; the stop's torque is not in the estimate"
    ]
    stop.meta["fell"] = True
    assert len(shortfalls(stop)) == 1  # a fall is told by its cause, and by the stop it may come from
