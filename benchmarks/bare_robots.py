"""Robots stripped of their marks, described by `inspect`, walking: `python benchmarks/bare_robots.py mahru FOLDER...`.

Each is a robot's name or a folder with a `robot.json` and its MJCF. Sole sites, the sensors on them and keyframes are
taken out of the MJCF's text, `zmpwalk.robots` describes what is left, and the proposal walks at three Froude numbers
v / sqrt(g z_c). Prints a table: how far the proposed soles and T_c are from the file's, and each walk's figures.
"""

import argparse
import re
import tempfile
from pathlib import Path

import mujoco
import numpy as np
import zmpwalk
from zmpwalk import analysis
from zmpwalk.robots import appraise, propose, robot_file, write_description

FROUDE = (0.03, 0.06, 0.0935)
RAMP = 3.0  # to full speed [s]


def bare_xml(path):
    """The MJCF text without sole sites, the sensors on them and keyframes; an include is put in its place."""
    text = Path(path).read_text(encoding="utf-8")
    include = re.search(r'<include file="([^"]+)"\s*/>', text)
    if include:
        inner = re.sub(r"<!--.*?-->", "", (Path(path).parent / include.group(1)).read_text(), flags=re.DOTALL)
        inner = re.sub(r"^.*?<mujoco[^>]*>|</mujoco>\s*$", "", inner, flags=re.DOTALL)
        text = text.replace(include.group(0), inner)
    text = re.sub(r"<keyframe>.*?</keyframe>", "", text, flags=re.DOTALL)
    return re.sub(r'<[^<>]*(name|site|objname)="(left|right)_sole"[^<>]*/>', "", text)


def sole_corners(foot):
    """Corners of a sole in its body's frame (4, 3) [m]."""
    R = np.zeros(9)
    mujoco.mju_quat2Mat(R, np.asarray(foot.sole_quat, float))
    half = np.array([[i * foot.length / 2, j * foot.width / 2, 0] for i in (-1, 1) for j in (-1, 1)])
    return np.asarray(foot.sole_pos) + half @ R.reshape(3, 3).T


def walk_lines(trace, model, description, speed):
    """What a walk is accepted by: worst speed error [%], peak torque [%], median and p95 error and its limit [mm]."""
    summary = trace.summary()
    walked, planned = (np.array(summary[f"{kind}_speed_per_step"]) for kind in ("mean", "planned"))
    full = planned > 0.999 * speed
    error = 1e3 * analysis.zmp_error(trace, single_support=True)
    weight = 9.81 * np.sum(model.body_mass)
    ankles = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name) for name in description.left.leg_joints[4:]]
    friction = model.dof_frictionloss[model.jnt_dofadr[ankles]].max()
    limit = description.left.length / 0.25 + 1.5e3 * friction / weight
    speed_error = 100 * np.abs(walked - planned)[full].max() / speed
    return (
        speed_error,
        100 * trace.torque_ratio.max(),
        np.median(error, axis=0),
        np.percentile(error, 95, axis=0),
        limit,
    )


def described_again(robot):
    """The robot without marks, as `inspect --write` describes it: model, description, proposal."""
    with tempfile.TemporaryDirectory() as scratch:
        xml = Path(scratch) / "bare.xml"
        xml.write_text(bare_xml(robot_file(robot)), encoding="utf-8")
        proposal = propose(mujoco.MjModel.from_xml_path(str(xml)))
        return (*zmpwalk.load_robot(write_description(xml.with_suffix(".json"), xml, proposal)), proposal)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("robot", nargs="+")
    parser.add_argument("--duration", type=float, default=60.0, help="of each walk [s]")
    options = parser.parse_args()
    print(f"MuJoCo {mujoco.__version__}, {options.duration:g} s each\n")
    print(
        "| robot | soles off mm | T_c off % | Froude | stands | speed off % | torque % | median mm | p95 mm (limit) |"
    )
    print("|---|---|---|---|---|---|---|---|---|")
    for robot in options.robot:
        model, known = zmpwalk.load_robot(robot)
        bare, found, proposal = described_again(robot)
        corners = [[sole_corners(getattr(one, side)) for side in ("left", "right")] for one in (known, found)]
        soles_off = 1e3 * np.abs(np.subtract(*corners)).max()
        T_c_off = 100 * (proposal.table["T_c_s"] / appraise(model, known).table["T_c_s"] - 1)
        for froude in FROUDE:
            speed = froude * np.sqrt(9.81 * proposal.table["com_height_m"])
            profile = zmpwalk.VelocityProfile.ramp(0.0, speed, RAMP)
            trace = zmpwalk.simulate((bare, found), profile, options.duration)
            speed_off, torque, median, p95, limit = walk_lines(trace, bare, found, speed)
            stands = f"falls at {trace.meta['fall_time']:.1f} s" if trace.meta["fell"] else "yes"
            errors = [" / ".join(f"{e:.3f}" for e in error) for error in (median, p95)]
            cells = [known.name, f"{soles_off:.1f}", f"{T_c_off:+.1f}", froude, stands, f"{speed_off:.2f}"]
            cells += [f"{torque:.0f}", errors[0], f"{errors[1]} ({limit:.2f})"]
            print("| " + " | ".join(map(str, cells)) + " |", flush=True)


if __name__ == "__main__":
    main()
