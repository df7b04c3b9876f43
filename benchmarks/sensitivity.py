"""Which acceptance lines move when a dimension, a gain or a bound changes by 5 %: `python benchmarks/sensitivity.py`.

One change at a time; 30 s of the default law and 30 s of the literal law each, on the bundled robot. Prints a table of
the lines that break; a walk that keeps them all has a dash.
"""

import mujoco
import numpy as np
import zmpwalk
from rich.console import Console
from rich.progress import track
from zmpwalk import analysis

PAPER_WINDOWS = ((4.08, 4.15), (4.87, 4.91), (5.64, 5.75), (6.44, 6.54))  # section IV, upper bound [s]
SETTINGS = [
    ("com_x_kp", "com_x_kd"),
    ("com_y_kp", "com_y_kd"),
    ("com_z_kp", "com_z_kd"),
    ("trunk_kp", "trunk_kd"),
    ("swing_kp", "swing_kd"),
    ("posture_kp", "posture_kd"),
    ("tracker_gain",),
    ("tracker_time",),
    ("sole_fraction",),
    ("T_ds_first",),
    ("step_height",),
    ("foothold_reach",),
    ("foothold_time",),
    ("com_lead",),
    ("contact_damping",),
    ("lateral_reach",),
]


def body(model, name):
    return mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, name)


def scale_link(link):
    """Moves the joint at the far end of a leg link, and its inertia, along the link."""

    def edit(model, factor):
        for side in "lr":
            model.body_pos[body(model, f"{side}_{link[1]}"), 2] *= factor
            model.body_ipos[body(model, f"{side}_{link[0]}"), 2] *= factor

    return edit


def scale_sole(axis):
    """Changes the length or width of both soles, contact box and site."""

    def edit(model, factor):
        for side, name in (("l", "left_sole"), ("r", "right_sole")):
            site = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SITE, name)
            model.site_size[site, axis] *= factor
            foot = body(model, f"{side}_foot")
            for geom in range(model.ngeom):
                touches = model.geom_contype[geom] or model.geom_conaffinity[geom]
                if model.geom_bodyid[geom] == foot and touches and model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_BOX:
                    model.geom_size[geom, axis] *= factor

    return edit


def scale_torso(what):
    def edit(model, factor):
        torso = body(model, "torso")
        if what == "mass":
            model.body_mass[torso] *= factor
            model.body_inertia[torso] *= factor
        else:
            model.body_ipos[torso, 2] *= factor

    return edit


MODELS = {
    "thigh length": scale_link(("thigh", "shank")),
    "shank length": scale_link(("shank", "ankle")),
    "sole length": scale_sole(0),
    "sole width": scale_sole(1),
    "torso mass": scale_torso("mass"),
    "torso COM height": scale_torso("height"),
    "armature": lambda model, factor: model.dof_armature.__imul__(factor),
}


def changed_robot(edit, factor):
    """The bundled robot with one property scaled, standing with its soles on the ground."""
    model, _ = zmpwalk.load_robot("mahru")
    edit(model, factor)
    data = mujoco.MjData(model)
    mujoco.mj_setConst(model, data)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_forward(model, data)
    sole = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SITE, "left_sole")
    model.key_qpos[0, 2] -= data.site_xpos[sole, 2]
    return model, zmpwalk.describe(model)


def default_lines(trace):
    """Names of the default law's lines that this walk breaks."""
    summary = trace.summary()
    if summary["fell"]:
        return [f"falls at {summary['fall_time']:.1f} s"]
    planned, walked = np.array(summary["planned_speed_per_step"]), np.array(summary["mean_speed_per_step"])
    error, single = analysis.zmp_error(trace), analysis.zmp_error(trace, single_support=True)
    offset = analysis.midstance_offset(trace)[6:]
    checks = {
        "speed 0.2 %": np.abs(walked / planned - 1).max() <= 2e-3,
        "median 0.01 mm": (np.median(error, axis=0) <= 1e-5).all(),
        "single support p95 0.05 mm": (np.percentile(single, 95, axis=0) <= 5e-5).all(),
        "p95 1 mm": (np.percentile(error, 95, axis=0) <= 1e-3).all(),
        "switch 2 ms": np.ptp(analysis.switch_times(trace)[5:]) <= 2e-3,
        "drift 0.05 mm a step": abs(np.polyfit(np.arange(len(offset)), offset, 1)[0]) <= 5e-5,
        "bounds": analysis.bound_excess(trace).max() <= 1e-3,
        "torque": trace.torque_ratio.max() < 1.0,
    }
    return [name for name, holds in checks.items() if not holds]


def paper_lines(trace):
    """Names of the literal law's lines that this walk breaks."""
    summary = trace.summary()
    if summary["fell"]:
        return [f"falls at {summary['fall_time']:.1f} s"]
    windows = analysis.zmp_windows(trace, shortest=0.003)
    lower = [w for w in windows if w.bound < 0]
    upper = [w for w in windows if w.bound > 0]
    start = [w for w in lower if abs(w.start - 0.8) < 0.01]
    matched = [
        any(w.start <= end and w.end >= begin and abs(w.end - end) <= 0.08 for w in upper)
        for begin, end in PAPER_WINDOWS
    ]
    checks = {
        "0.8 s: lower bound until 0.85-0.91 s": bool(start) and abs(start[0].end - 0.88) <= 0.03,
        "2.4 s: no lower bound": not any(2.4 <= w.start <= 2.5 for w in lower),
        "windows from 4 s on": all(matched),
    }
    return [name for name, holds in checks.items() if not holds]


def cases():
    """(label, robot, changed settings of each law)."""
    yield "nothing", zmpwalk.load_robot("mahru"), None
    for factor in (0.95, 1.05):
        for name, edit in MODELS.items():
            yield f"{name} x {factor}", changed_robot(edit, factor), None
        for names in SETTINGS:
            yield f"{', '.join(names)} x {factor}", zmpwalk.load_robot("mahru"), (names, factor)


def walk(robot, law, change):
    settings = zmpwalk.WalkSettings(law=law)
    if change is not None:
        names, factor = change
        resolved = zmpwalk.WalkingController(*robot, settings=settings).settings
        for name in names:
            setattr(settings, name, factor * getattr(resolved, name))
    return zmpwalk.simulate(robot, duration=30.0, settings=settings)


def main():
    print("| changed | default law breaks | literal law breaks |")
    print("|---|---|---|")
    for label, robot, change in track(list(cases()), description="walking", console=Console(stderr=True)):
        results = [
            "; ".join(lines(walk(robot, law, change))) or "-"
            for law, lines in (("default", default_lines), ("paper", paper_lines))
        ]
        print("| " + " | ".join([label, *results]) + " |", flush=True)


if __name__ == "__main__":
    main()
