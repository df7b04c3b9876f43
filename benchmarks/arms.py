"""Arms that move while the legs walk: `python benchmarks/arms.py [--page docs/arms.md]`.

Scripted arm motions at 0.25 m/s for 30 s, with III-B and without (`iteration="none"`), then the ground yaw moment with
fixed arms and with arms that cancel the legs' yaw momentum. `--page` writes that page's part for this MuJoCo, and its
figure.
"""

import argparse
import math
from pathlib import Path

import matplotlib
import mujoco
import numpy as np
import zmpwalk
from pages import write_blocks
from rich.console import Console
from rich.progress import track
from zmpwalk import JointMotion, VelocityProfile, WalkSettings, analysis, plot

SPEED, RAMP, DURATION = 0.25, 3.0, 30.0  # [m/s], from a stand in [s], [s]
WINDOW = 5.0, 29.0  # whole steps and whole swings, over which the speed is taken [s]
LOAD, SEEDS = 2.0, 20  # in the left hand [kg]; of the random motions
YAW_SPEEDS, YAW_START, YAW_DURATION = (0.35, 0.6, 0.8), 8.0, 20.0  # [m/s]; measured from, to [s]
SWING = math.radians(60.0)


def cases():
    """(label, [(model and description, motion)]) of each row."""
    model, description = robot = zmpwalk.load_robot("mahru")
    loaded, _ = zmpwalk.load_robot("mahru")
    loaded.body_mass[mujoco.mj_name2id(loaded, mujoco.mjtObj.mjOBJ_BODY, "l_hand")] += LOAD
    mujoco.mj_setConst(loaded, mujoco.MjData(loaded))
    raised = {"l_shoulder_pitch": -math.pi / 2, "l_elbow": -0.3}
    stand = [description.stand_joints[name] for name in raised]
    controller = zmpwalk.WalkingController(model, description)

    def swing(left, right):
        return JointMotion.sine({"l_shoulder_pitch": left, "r_shoulder_pitch": right}, 1.0, DURATION)

    yield "arms at rest", [(robot, None)]
    yield "±60° at 1 Hz, against each other", [(robot, swing(SWING, -SWING))]
    yield "±60° at 1 Hz, together", [(robot, swing(SWING, SWING))]
    yield (
        f"left arm raised, {LOAD:g} kg in its hand",
        [((loaded, description), JointMotion([0, 1.5], list(raised), [stand, list(raised.values())]))],
    )
    yield (
        f"random, 3 rad/s, {SEEDS} seeds",
        [(robot, JointMotion.random(controller, seed, duration=DURATION)) for seed in range(SEEDS)],
    )


def measure(robot, motion, iteration):
    """One walk: fell, speed error [%], ZMP beyond its bounds [mm], median and p95 of |desired - measured ZMP| [mm]."""
    profile = VelocityProfile.ramp(0, SPEED, RAMP)
    trace = zmpwalk.simulate(robot, profile, DURATION, WalkSettings(iteration=iteration), motion=motion)
    start, end = (np.interp(t, trace.t, trace.com[:, 0]) for t in WINDOW)
    miss = 1e3 * np.abs(trace.zmp_des - trace.zmp_meas)
    return (
        trace.meta["fell"],
        100 * abs((end - start) / (WINDOW[1] - WINDOW[0]) / SPEED - 1),
        1e3 * max(analysis.bound_excess(trace, single_support=False).max(), 0.0),
        np.nanmedian(miss, axis=0),
        np.nanpercentile(miss, 95, axis=0),
    )


def motion_rows():
    """Cells of the first table; of several walks the worst."""
    for label, runs in cases():
        for iteration, words in (("closed_form", "with"), ("none", "without")):
            fell, speed, beyond, median, p95 = zip(*(measure(robot, motion, iteration) for robot, motion in runs))
            yield (
                label, words, f"{sum(fell)} of {len(fell)}", f"{max(speed):.2f}", f"{max(beyond):.2f}",
                *(f"{x:.3f} / {y:.3f}" if max(x, y) < 1 else f"{x:.1f} / {y:.1f}"
                  for x, y in (np.max(median, axis=0), np.max(p95, axis=0))),
            )  # fmt: skip


def yaw_walk(speed, share):
    """A walk whose arms cancel `share` of the yaw momentum, and its rows from YAW_START on."""
    profile = VelocityProfile.ramp(0, speed, 4.0)
    trace = zmpwalk.simulate("mahru", profile, YAW_DURATION, WalkSettings(momentum_arms=share))
    return trace, analysis.yaw_moment(trace), np.isfinite(trace.zmp_meas).all(axis=1)


def yaw_rows():
    """Cells of the second table."""
    for speed in YAW_SPEEDS:
        peak, rms, turning = [], [], []
        for share in (0.0, 1.0):
            trace, moment, touching = yaw_walk(speed, share)
            moment = moment[trace.t[touching] > YAW_START]
            peak.append(np.abs(moment).max())
            rms.append(np.sqrt(np.mean(moment**2)))
            about_com = analysis.yaw_moment(trace, about="com")[trace.t[touching] > YAW_START]
            turning.append(np.sqrt(np.mean(about_com**2)))
        yield (
            f"{speed:g}", *(f"{values[0]:.1f} → {values[1]:.1f} ({100 * (values[1] / values[0] - 1):+.0f} %)"
                            for values in (peak, rms, turning)),
            f"{np.ptp(shoulders(trace)[trace.t > YAW_START, 0]):.2f}",
        )  # fmt: skip


def shoulders(trace):
    """Shoulder pitch, left and right (T, 2) [rad]."""
    return trace.qpos[:, [7 + trace.meta["joint_names"].index(f"{side}_shoulder_pitch") for side in "lr"]]


def figure(speed=0.6, seconds=2.0):
    """Yaw moment of the ground with fixed arms and with swinging ones, and how these swing."""
    with matplotlib.rc_context(plot.STYLE):
        drawing = plot.WalkFigure(figsize=(plot.WIDTH, 4.0), layout="constrained")
        above, below = drawing.subplots(2, 1, sharex=True, height_ratios=(3, 2))
        for share, colour, label in (
            (0.0, plot.FAINT, "arms fixed"),
            (1.0, plot.DESIRED, "arms cancel the yaw momentum"),
        ):
            trace, moment, touching = yaw_walk(speed, share)
            t = trace.t[touching]
            shown = (t >= YAW_START) & (t <= YAW_START + seconds)
            above.plot(t[shown] - YAW_START, moment[shown], color=colour, label=label)
        shown = (trace.t >= YAW_START) & (trace.t <= YAW_START + seconds)
        for side, name, colour in ((0, "left", plot.ESTIMATED), (1, "right", plot.MEASURED)):
            angle = np.degrees(shoulders(trace)[shown, side])
            below.plot(trace.t[shown] - YAW_START, angle, color=colour, label=f"{name} shoulder, arms swinging")
        above.set_ylabel("yaw moment of\nthe ground [N m]")
        below.set(ylabel="shoulder pitch [°]", xlabel="time [s]", xlim=(0, seconds))
        for axes in (above, below):
            axes.margins(y=0.1)
            axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=2, borderaxespad=0.2)
        drawing.align_ylabels([above, below])
        text = f"What arms do for the feet: walking at {speed:g} m/s"
        drawing.suptitle(text, x=0.012, ha="left", fontsize=10, fontweight="bold")
    return drawing


def table(header, rows):
    """Lines of a table."""
    return ["| " + " | ".join(cells) + " |" for cells in (header, ("---",) * len(header), *rows)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--page", type=Path, metavar="FILE", help="update that page and its figure")
    args = parser.parse_args()
    motions = track(motion_rows(), "walking", total=10, console=Console(stderr=True))
    lines = [f"MuJoCo {mujoco.__version__}; millimetres, x / y; of the seeds the worst.", ""]
    lines += table(
        ("arms", "III-B", "falls", "speed error, %", "estimate beyond bounds", "desired − CoP, median", "p95"), motions
    )
    yaw = table(("m/s", "peak, N m", "RMS, N m", "RMS about the COM, N m", "shoulder swings, rad"), yaw_rows())
    number = mujoco.__version__[0]
    if args.page:
        write_blocks(args.page, {f"MuJoCo {number}": lines, f"yaw, MuJoCo {number}": yaw})
        if number == "2":
            figure().savefig(args.page.parent / "images" / "arms_yaw_moment.png", dpi=100)
    print("\n".join([*lines, "", *yaw]))


if __name__ == "__main__":
    main()
