"""Commands in every direction: `python benchmarks/walk_anywhere.py [ROBOT.json ...] [--page docs/walk_anywhere.md]`.

`--only ladder` (also `make ladder`) walks faster and faster until the robot falls. The other parts: directions, script,
stops, jumps, idle, robots, all axes. `--page` writes that page's part for this MuJoCo, and its figures.
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
from rich.progress import Progress
from zmpwalk import InputError, VelocityProfile, analysis, plot

# Speed [m/s] -> largest 95th percentile of |estimated ZMP - CoP| [mm], x and y; beyond, every 0.1 m/s until a fall.
LADDER = {0.25: 2.0, 0.35: 2.0, 0.45: 2.0, 0.6: 5.0, 0.8: 10.0}
RUNG, RAMP, STEADY = 0.1, 1 / 6, 30.0  # [m/s], [m/s^2], [s]
LARGEST_MEDIAN, LARGEST_SPEED_ERROR = 0.05, 0.5  # of |estimated ZMP - CoP| [mm]; of the mean speed [%]
DIRECTIONS = {
    "backward": (-0.3, 0, 0), "to the left": (0, 0.15, 0), "to the right": (0, -0.15, 0),
    "turning left": (0, 0, 0.5), "turning right": (0, 0, -0.5),
    "forward, turning left": (0.3, 0, 0.5), "forward, turning right": (0.3, 0, -0.5),
}  # fmt: skip
# Velocity (vx, vy, wz) and how long it is held [s], reached within CHANGE [s]: 60 s in all.
SCRIPT = (
    ((0, 0, 0), 1), ((0.3, 0, 0), 5), ((0.3, 0, 0.5), 4), ((0, 0, 0), 2), ((0, 0.15, 0), 4), ((0, 0, -0.5), 3),
    ((0, 0, 0), 2), ((-0.3, 0, 0), 4), ((0, 0, 0.5), 3), ((0, -0.15, 0), 4), ((0, 0, 0), 2), ((0.2, 0.1, -0.3), 3),
    ((0, 0, 0), 5),
)  # fmt: skip
CHANGE = 1.5
LARGEST_MISS = 2.0, 2.0  # at the script's end: [% of the path's length], [degrees]
STOP_SPEED, STOP_WALK, STOP_STAND, STOPS, LARGEST_STEPS = 0.6, 9.0, 14.0, 10, 3  # [m/s], [s], [s], times, steps
JUMP_BASE, JUMP, JUMP_RANGE, JUMP_WITHIN, JUMP_DURATION = 0.3, 0.3, (-0.3, 0.6), 10.0, 13.0  # [m/s], [s]
SEEDS, IDLE_FROM, LARGEST_IDLE = 100, 2.0, 1.0  # of the jumps; [s] and motion of the COM that stands [mm]
# Of another robot, in v / sqrt(g z_c) and wz T_c: a script like the one above, 30 s.
ROBOT_SCRIPT = (
    ((0, 0, 0), 1), ((0.0935, 0, 0), 3), ((0.06, 0, 0.08), 3), ((-0.05, 0, 0), 2), ((0, 0.03, 0), 2.5),
    ((0, 0, -0.08), 2.5), ((0.05, 0.02, 0.05), 2), ((0, 0, 0), 3.5),
)  # fmt: skip
# Jumps of all three velocities together: they are held for so long, and go as far as the script above [s].
HELD, AXES_FROM, AXES_DURATION = (1.0, 2.0), 1.0, 15.0
BUNDLED_TIMES = 2.0  # how much farther than that the bundled robot's jump


def script(segments, scale=(1.0, 1.0, 1.0), change=CHANGE):
    """The profile that holds each velocity times `scale` for its time and goes to the next within `change` [s]."""
    t, points = 0.0, []
    for velocity, hold in segments:
        points += [(t, velocity), (t + hold, velocity)]
        t += hold + change
    times, velocities = zip(*points)
    return VelocityProfile(times, np.multiply(velocities, scale), "linear"), t - change


def jumps(seed):
    """Velocities that jump: [(t, vx)] [s, m/s]."""
    random = np.random.default_rng(seed)
    v = random.uniform(0, JUMP_BASE)
    points = [(0.0, v)]
    for t in np.sort(random.uniform(0, JUMP_WITHIN, random.integers(3, 6))):
        v = float(np.clip(v + random.uniform(-JUMP, JUMP), *JUMP_RANGE))
        points.append((float(t), v))
    return points


def live(points):
    """The same as a command."""
    return lambda t, out: [v for start, v in points if start <= t][-1]


def axis_jumps(seed, largest):
    """Velocities (vx, vy, wz) that jump within +-`largest` (3,): [(t, velocity)] [s]."""
    random = np.random.default_rng(seed)
    points, t = [(0.0, (0.0, 0.0, 0.0))], AXES_FROM
    while t < AXES_DURATION:
        points.append((t, tuple(random.uniform(-1, 1, 3) * largest)))
        t += random.uniform(*HELD)
    return points


def walk(speed):
    """Arguments of a walk of the ladder. No limit of commands holds it back, so that it shows where the robot falls."""
    ramp, free = speed / RAMP, {"command_limit": False}
    return {"profile": VelocityProfile.ramp(0.0, speed, ramp), "duration": ramp + STEADY, "settings": free}


def stops(times=STOPS):
    """Arguments of the walk that stops and starts again `times`."""
    period = STOP_WALK + STOP_STAND
    points = [(period * i + t, v) for i in range(times) for t, v in ((0.0, STOP_SPEED), (STOP_WALK, 0.0))]
    return {"profile": VelocityProfile.constant(0.0), "command": live(points), "duration": times * period}


def measure(trace, start=0.0):
    """Numbers of a walk: fell (time [s] or None), torque [%], saturated, self_contacts (cycles); from `start` [s] on
    median and p95 of |estimated ZMP - CoP| (2,) [mm] and, over whole strides, velocity (3,), period [s]."""
    rows = trace.t >= start
    error = 1e3 * np.abs(trace.zmp_est - trace.zmp_meas)[rows]
    landed = np.flatnonzero((np.diff(trace.phase) < 0) & rows[1:]) + 1
    landed = landed[: len(landed) - 1 + len(landed) % 2]  # whole strides
    numbers = {
        "fell": trace.meta["fall_time"],
        "median": np.nanmedian(error, axis=0) if rows.any() else np.full(2, np.nan),
        "p95": np.nanpercentile(error, 95, axis=0) if rows.any() else np.full(2, np.nan),
        "torque": 100 * float(trace.torque_ratio.max()),
        "saturated": int((trace.torque_ratio > 1.0).sum()),
        "self_contacts": int((trace.self_contacts > 0).sum()),
        "velocity": np.full(3, np.nan),
        "period": math.nan,
    }
    if len(landed) > 2:
        seconds = float(np.diff(trace.t[landed[[0, -1]]])[0])
        numbers["period"] = seconds / (len(landed) - 1)
        numbers["velocity"] = stride_velocity(trace, landed)
    return numbers


def stride_velocity(trace, landed):
    """Mean velocity (vx, vy, wz) of the feet's middle between landings, stride by stride (3,)."""
    poses, t = analysis.feet_pose(trace.foot_left[landed], trace.foot_right[landed]), trace.t[landed]
    strides = [analysis.mean_velocity(*poses[[i, i + 2]], t[i + 2] - t[i]) for i in range(0, len(landed) - 2, 2)]
    return np.average(strides, axis=0, weights=[t[i + 2] - t[i] for i in range(0, len(landed) - 2, 2)])


def miss(trace):
    """Where the walk ended, against where its commands as given lead: distance [% of the path's length, m], angle
    [degrees], length of the path [m]."""
    path = analysis.planned_path(trace, as_given=True)
    length = float(np.hypot(*np.diff(path[:, :2], axis=0).T).sum())
    end = analysis.feet_pose(trace.foot_left[-1], trace.foot_right[-1])
    distance = math.dist(end[:2], path[-1, :2])
    return 100 * distance / length, distance, abs(math.degrees(math.remainder(end[2] - path[-1, 2], math.tau))), length


def stop_numbers(trace):
    """For each stop: feet lifted and time [s] until rest, and the COM's motion in the last 5 s of the stand [mm]; NaN
    where that never came."""
    for i in range(round(trace.meta["requested_duration"] / (STOP_WALK + STOP_STAND))):
        begin = i * (STOP_WALK + STOP_STAND) + STOP_WALK
        rows = np.flatnonzero((trace.t >= begin) & (trace.t < begin + STOP_STAND))
        rest = rows[trace.at_rest[rows] > 0] if len(rows) else rows
        if not len(rest) or trace.t[-1] < begin + STOP_STAND - 0.1:
            yield math.nan, math.nan, math.nan
            continue
        steps = np.count_nonzero(np.diff(trace.phase[rows[0] : rest[0] + 1]) > 0)
        last = trace.com[rows[trace.t[rows] >= begin + STOP_STAND - 5.0]]
        yield steps, trace.t[rest[0]] - begin, 1e3 * float(np.linalg.norm(np.ptp(last, axis=0)))


# --- the tables: each part yields (lines of the page)


def marked(text, holds):
    return text if holds else f"**{text}**"


def pair(values, digits=3):
    return " / ".join("–" if math.isnan(value) else f"{value:.{digits}g}" for value in values)


def table(header, rows):
    return ["| " + " | ".join(cells) + " |" for cells in (header, ("---",) * len(header), *rows)]


def result(fell):
    return "walks" if fell is None else f"**falls at {fell:.1f} s**"


def rungs():
    """Speeds of the ladder, the ones that are asked for first."""
    speed = max(LADDER)
    yield from LADDER
    while True:
        speed = round(speed + RUNG, 6)
        yield speed


def ladder(run):
    """Speeds until the first fall beyond those asked for. Returns the page's lines."""
    rows, kept, within = [], 0.0, 0.0
    for speed in rungs():
        try:
            trace = run([walk(speed)])[0]
        except InputError as error:
            rows.append((f"{speed:g}", f"refused: {error}", *[""] * 7))
            break
        m = measure(trace, speed / RAMP + 2.0)
        off = 100 * (m["velocity"][0] / speed - 1)
        limit = LADDER.get(speed, math.inf)
        if m["fell"] is None and abs(off) <= LARGEST_SPEED_ERROR:
            kept = max(kept, speed)
            within = kept if m["saturated"] == 0 else within
        median = LARGEST_MEDIAN if speed in LADDER else math.inf
        rows.append((
            f"{speed:g}", result(m["fell"]),
            marked("–" if math.isnan(off) else f"{off:+.2f}", not abs(off) > LARGEST_SPEED_ERROR),
            marked(pair(m["median"]), not max(m["median"]) > median),
            marked(pair(m["p95"]), not max(m["p95"]) > limit), "" if math.isinf(limit) else f"{limit:g}",
            marked(f"{m['torque']:.0f}", m["saturated"] == 0), str(m["saturated"]),
            pair((speed * m["period"], m["period"])),
        ))  # fmt: skip
        if m["fell"] is not None and speed > max(LADDER):
            break
    header = ("m/s", "result", "speed error, %", "estimate − CoP, median mm", "p95 mm", "limit of p95",
              "largest torque, %", "cycles at a limit", "step, m / s")  # fmt: skip
    last = f"Highest speed that is kept for {STEADY:g} s: {kept:g} m/s; with every torque within its limit: "
    return [*table(header, rows), "", f"{last}{within:g} m/s."]


def directions(run):
    rows = []
    traces = run([{"profile": VelocityProfile.ramp((0, 0, 0), v, 2.0), "duration": 32.0} for v in DIRECTIONS.values()])
    for (label, v), trace in zip(DIRECTIONS.items(), traces):
        m = measure(trace, 4.0)
        rows.append((
            f"{label}: {v[0]:g}, {v[1]:g}, {v[2]:g}", result(m["fell"]), ", ".join(f"{x:.3f}" for x in m["velocity"]),
            pair(m["median"]), pair(m["p95"]), f"{m['torque']:.0f}", str(m["saturated"]), str(m["self_contacts"]),
        ))  # fmt: skip
    header = ("vx, vy, wz", "result", "walked", "estimate − CoP, median mm", "p95 mm", "largest torque, %",
              "cycles at a limit", "self contacts")  # fmt: skip
    return table(header, rows)


def mixed():
    """Arguments of the walk of SCRIPT."""
    profile, duration = script(SCRIPT)
    return {"profile": profile, "duration": duration}


def mixed_script(run):
    trace = run([mixed()])[0]
    m = measure(trace)
    percent, distance, angle, length = miss(trace)
    return [
        f"60 s, {length:.2f} m: {result(m['fell'])}; ends "
        + marked(f"{1e3 * distance:.0f} mm, {percent:.2f} % of the path", percent <= LARGEST_MISS[0])
        + " and "
        + marked(f"{angle:.2f}°", angle <= LARGEST_MISS[1])
        + f" from where the commands lead. Estimate − CoP p95 {pair(m['p95'])} mm, largest torque {m['torque']:.0f} %, "
        f"self contacts {m['self_contacts']}."
    ]


def stopping(run):
    trace = run([stops()])[0]
    numbers = list(stop_numbers(trace))
    rows = [
        (str(i), marked(f"{n:g}", n <= LARGEST_STEPS), f"{t:.2f}", marked(f"{mm:.2g}", mm <= LARGEST_IDLE))
        for i, (n, t, mm) in enumerate(numbers, 1)
    ]
    fell = trace.meta["fall_time"]
    return [f"Whole walk: {result(fell)}.", "", *table(("stop", "feet lifted until rest", "s", "COM moves, mm"), rows)]


def jumping(run, seeds=SEEDS):
    points = [jumps(seed) for seed in range(seeds)]
    profiles = [{"profile": VelocityProfile.piecewise(p), "duration": JUMP_DURATION} for p in points]
    zero = VelocityProfile.constant(0.0)
    commands = [{"profile": zero, "duration": JUMP_DURATION, "command": live(p)} for p in points]
    lines = []
    for label, runs in (("profile", profiles), ("`controller.command`", commands)):
        fallen = [(seed, trace.meta["fall_time"]) for seed, trace in enumerate(run(runs)) if trace.meta["fell"]]
        which = ": " + ", ".join(f"seed {seed} at {t:.1f} s" for seed, t in fallen) if fallen else ""
        lines.append((label, marked(f"{len(fallen)} of {seeds}{which}", not fallen)))
    return table(("jumps by", "falls"), lines)


def idle(run):
    trace = run([{"profile": VelocityProfile.constant(0.0), "duration": 20.0}])[0]
    moved = 1e3 * np.ptp(trace.com[trace.t >= IDLE_FROM], axis=0).max()
    text = marked(f"{moved:.2g} mm", moved <= LARGEST_IDLE)
    return [f"20 s: {result(trace.meta['fall_time'])}; from {IDLE_FROM:g} s on the COM moves {text}."]


def scales(robot):
    """Model, description and what vx, vy and wz of ROBOT_SCRIPT are multiplied by for this robot."""
    model, description = zmpwalk.load_robot(robot)
    still = zmpwalk.WalkingController(model, description, profile=VelocityProfile.constant(0.0))
    g, z_c = float(np.linalg.norm(model.opt.gravity)), still.com_height
    T_c = math.sqrt(z_c / g)
    return (model, description), (math.sqrt(g * z_c), math.sqrt(g * z_c), 1 / T_c)


def robot_walk(robot):
    """Arguments of the walk of ROBOT_SCRIPT, scaled."""
    robot, scale = scales(robot)
    profile, duration = script(ROBOT_SCRIPT, scale)
    return {"robot": robot, "profile": profile, "duration": duration}


def axis_walks(robot, seeds):
    """Largest velocity (3,), and arguments of walks whose three velocities jump together, one for each seed."""
    loaded, scale = scales(robot)
    times = BUNDLED_TIMES if robot == "mahru" else 1.0
    largest = times * np.abs([v for v, _ in ROBOT_SCRIPT]).max(axis=0) * scale
    zero = VelocityProfile.constant(0.0)
    return largest, [
        {"robot": loaded, "profile": zero, "duration": AXES_DURATION, "command": live(axis_jumps(seed, largest))}
        for seed in seeds
    ]


def all_axes(run, robots, seeds=SEEDS):
    rows = []
    for robot in robots:
        largest, walks = axis_walks(robot, range(seeds))
        fallen = [(seed, trace.meta["fall_time"]) for seed, trace in enumerate(run(walks)) if trace.meta["fell"]]
        which = ": " + ", ".join(f"seed {seed} at {t:.1f} s" for seed, t in fallen) if fallen else ""
        name = walks[0]["robot"][1].name
        rows.append(
            (name, ", ".join(f"{v:.2f}" for v in largest), marked(f"{len(fallen)} of {seeds}{which}", not fallen))
        )
    return table(("robot", "vx, vy, wz at most", "falls"), rows)


def other_robots(run, robots):
    rows = []
    for robot in robots:
        arguments = robot_walk(robot)
        trace = run([arguments])[0]
        m, (percent, _, angle, _) = measure(trace), miss(trace)
        top = arguments["profile"].v
        rows.append((
            arguments["robot"][1].name, f"{top[:, 0].max():.2f}, {top[:, 1].max():.2f}, {top[:, 2].max():.2f}",
            result(m["fell"]), f"{percent:.1f}", f"{angle:.1f}", pair(m["median"]), pair(m["p95"]),
            f"{m['torque']:.0f}", str(m["self_contacts"]),
        ))  # fmt: skip
    header = ("robot", "vx, vy, wz at most", "result", "off at the end, % of the path", "°",
              "estimate − CoP, median mm", "p95 mm", "largest torque, %", "self contacts")  # fmt: skip
    return table(header, rows)


# --- the figures


def ladder_figure(lines):
    """Estimate error and torque over the speed, read from the ladder's table."""
    rows = [[cell.strip(" *") for cell in line.split("|")[1:-1]] for line in lines]
    falls = [float(row[0]) for row in rows if len(row) > 1 and row[1].startswith("falls")]
    rows = [row for row in rows if len(row) > 1 and row[1] == "walks" and abs(float(row[2])) <= LARGEST_SPEED_ERROR]
    speed, torque = ([float(row[k]) for row in rows] for k in (0, 6))
    p95 = np.array([[float(x) for x in row[4].split("/")] for row in rows])
    with matplotlib.rc_context(plot.STYLE):
        drawing = plot.WalkFigure(figsize=(plot.WIDTH, 4.0), layout="constrained")
        above, below = drawing.subplots(2, 1, sharex=True)
        for k, (axis, colour) in enumerate((("forward", plot.ESTIMATED), ("sideways", plot.DESIRED))):
            above.plot(speed, p95[:, k], "o-", color=colour, ms=4, label=axis)
        above.plot(
            list(LADDER), list(LADDER.values()), "_", color=plot.FAINT, ms=16, mew=2, label="allowed up to 0.8 m/s"
        )
        above.set(ylabel="error of the estimate,\n95th percentile [mm]", yscale="log")
        below.plot(speed, torque, "o-", color=plot.DESIRED, ms=4)
        below.axhline(100, color=plot.FAINT, lw=1.2)
        for axes in (above, below):
            for v in falls:
                axes.axvline(v, color="black", ls="--", lw=1.0, label=f"falls at {v:g} m/s" if v == falls[0] else "_")
        below.annotate("limit of the torque", (min(LADDER), 100), (0, -9), textcoords="offset points", fontsize=8)
        below.set(
            ylabel="largest torque asked\n[% of its limit]",
            xlabel="speed [m/s]",
            ylim=(0, 1.12 * max(100, *torque)),
            xlim=(min(LADDER) - 0.06, None),
        )
        above.legend(loc="upper left")
        drawing.suptitle("Faster until the robot falls", x=0.012, ha="left", fontsize=10, fontweight="bold")
    return drawing


PARTS = {
    "ladder": ladder, "directions": directions, "script": mixed_script, "stops": stopping, "jumps": jumping,
    "idle": idle,
}  # fmt: skip


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "robots", nargs="*", metavar="ROBOT.json", help="further robots, for the parts 'robots' and 'all axes'"
    )
    parser.add_argument("--only", choices=[*PARTS, "robots", "all axes"], help="one part")
    parser.add_argument("--page", type=Path, metavar="FILE", help="update that page and its figures")
    args = parser.parse_args()
    robots = ["mahru", *args.robots]
    parts = {
        **PARTS,
        "robots": lambda run: other_robots(run, robots),
        "all axes": lambda run: all_axes(run, robots),
    }
    chosen = {args.only: parts[args.only]} if args.only else parts
    number, blocks = mujoco.__version__[0], {}
    with Progress(console=Console(stderr=True), transient=True) as progress:
        for name, part in chosen.items():
            task = progress.add_task(name, total=None)

            def run(runs, task=task, name=name):
                total = sum(run["duration"] for run in runs)
                what = f"{name}, {len(runs)} walks of {total:.0f} s" if len(runs) > 1 else f"{name}, {total:.0f} s"
                progress.update(task, description=what, total=total, completed=0)
                return zmpwalk.simulate_batch(runs, on_progress=lambda t, _: progress.update(task, completed=t))

            blocks[f"{name}, MuJoCo {number}"] = part(run)
            progress.remove_task(task)
            progress.console.print(f"{name}: done")
    if args.page:
        write_blocks(args.page, blocks)
        if "ladder" in chosen and number == "2":
            figure = ladder_figure(blocks["ladder, MuJoCo 2"])
            figure.savefig(args.page.parent / "images" / "ladder.png", dpi=100)
    print(f"MuJoCo {mujoco.__version__}")
    for name, lines in blocks.items():
        print("\n".join(("", name, *lines)))


if __name__ == "__main__":
    main()
