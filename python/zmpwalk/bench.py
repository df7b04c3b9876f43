"""Measures how fast the controller is on this machine: every number of docs/benchmarks.md."""

from __future__ import annotations

import os
import platform
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Callable, Iterator

import mujoco
import numpy as np

from . import _core
from .errors import InputError
from .profiles import VelocityProfile
from .robots import ROBOTS, Robot, load_robot
from .simulation import Progress, WalkingController, check_duration, simulate, simulate_batch

__all__ = ["PARTS", "bench", "tables"]

PHASES = {"double": 0, "single": 1}
JOINTS = (12, 25, 40, 60)
TEXTBOOK_EVERY = 20  # cycles
WALK = VelocityProfile.paper

Result = dict


def bench(
    robot: Robot = "mahru",
    duration: float = 120.0,
    parts: tuple[str, ...] | None = None,
    on_progress: Callable[[str, float], None] | None = None,
) -> Result:
    """Measure how fast the controller is. What is compared is measured in one process, cycle by cycle in turn.

    Args:
        robot: what `load_robot` takes.
        duration: of the walk in which cycles are timed [s].
        parts: which of `PARTS`; None takes all. `joints`, `import` and `command` speak of our own robot.
        on_progress: called as f(part, share done).

    Returns:
        A dictionary that JSON takes: machine, build, and one entry a part. Times in microseconds unless said, each with
        min, median, p99, p99.9, max.

    Raises:
        InputError: an unknown part, a bad duration.  ModelError: a robot that cannot be used.

    Usage: `zmpwalk.bench.bench(duration=8, parts=("cycle",))`
    """
    duration = check_duration(duration)
    for part in parts or ():
        if part not in PARTS:
            raise InputError(f"there is no part '{part}' to measure; there are: {', '.join(PARTS)}")
    say = on_progress or (lambda part, share: None)
    loaded = load_robot(robot)
    result: Result = {"machine": machine(), "build": _core.build_info(), "duration": duration}
    for part in PARTS if parts is None else parts:
        say(part, 0.0)
        result[part] = PARTS[part](loaded, duration, _share_of(part, say))
        say(part, 1.0)
    return result


def _share_of(part: str, say: Callable[[str, float], None]) -> Progress:
    return lambda t, whole: say(part, min(t / whole, 1.0))


def machine() -> dict[str, Any]:
    """Processor, how many of it this process may use, and the versions that matter.

    Usage: `machine()["cpu"]`
    """
    cpu = platform.processor() or platform.machine()
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        cpu = next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        pass
    return {
        "cpu": cpu,
        "cores": _cores(),
        "mujoco": mujoco.__version__,
        "numpy": np.__version__,
        "python": platform.python_version(),
    }


def _cores() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@contextmanager
def _pinned() -> Iterator[None]:
    """On one processor, where the system can do that: a move to another costs more than a cycle."""
    if not hasattr(os, "sched_setaffinity"):
        yield
        return
    before = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {max(before)})
    try:
        yield
    finally:
        os.sched_setaffinity(0, before)


def statistics(times: np.ndarray) -> dict[str, float]:
    """min, median, p99, p99.9, max of what is finite.

    Usage: `statistics(np.array([1.0, 2.0]))["median"]`
    """
    times = times[np.isfinite(times)]
    if not len(times):
        return {}
    p99, p999 = np.percentile(times, [99.0, 99.9])
    return {
        "min": float(times.min()),
        "median": float(np.median(times)),
        "p99": float(p99),
        "p99.9": float(p999),
        "max": float(times.max()),
    }


def _cycle(loaded: Any, duration: float, progress: Progress) -> Result:
    """Cycle by stage, in the loop and from scratch, beside mj_step and the equations as printed."""
    model, description = loaded
    settings = _core.WalkSettings()
    with _pinned():
        columns = _core.benchmark_cycle(model, description, settings, WALK(), duration, TEXTBOOK_EVERY, progress)
    phase = columns.pop("phase")
    difference = columns.pop("difference")
    result: Result = {"largest_difference_to_textbook": float(np.nanmax(difference)), "cycles": len(phase)}
    for name, number in {**PHASES, "all": -1}.items():
        rows = slice(None) if number < 0 else phase == number
        result[name] = {column: statistics(values[rows]) for column, values in columns.items()}
        of = result[name]
        if len(of["in_loop"]) == 0 or len(of["textbook"]) == 0:
            raise InputError(f"duration is {duration:g} s: no cycle in {name} was measured; walk for 2 s or longer")
        of["other"] = {"median": of["other"]["median"]}  # a difference of times: its extremes mean nothing
        result[name]["ratios"] = {
            f"{above} / {below}": {each: of[above][each] / of[below][each] for each in ("min", "median")}
            for above, below in (
                ("in_loop", "step"),
                ("from_scratch", "step"),
                ("textbook", "algebra"),
                ("iteration", "in_loop"),
            )
        }
    return result


def _python(loaded: Any, duration: float, progress: Progress) -> Result:
    """`update` called from Python against the same call in C++, on one walk each."""
    model, description = loaded
    duration = min(duration, 8.0)
    with _pinned():
        from_cpp = _core.benchmark_cycle(model, description, _core.WalkSettings(), WALK(), duration, 0, progress)
        in_loop, from_scratch = (WalkingController(model, description, None, WALK()) for _ in range(2))
        data = mujoco.MjData(model)
        description.place(model, data)
        in_loop.reset(data)
        from_scratch.reset(data)
        times: dict[str, list[int]] = {"from_scratch": [], "in_loop": []}
        now = time.perf_counter_ns
        while data.time < duration:
            start = now()
            from_scratch.update(data)
            times["from_scratch"].append(now() - start)
            mujoco.mj_step1(model, data)
            start = now()
            in_loop.update(data, after_step1=True)
            times["in_loop"].append(now() - start)
            mujoco.mj_step2(model, data)
    result: Result = {}
    for name, values in times.items():
        python, cpp = statistics(np.array(values) / 1000.0), statistics(from_cpp[name])
        more = {each: python[each] - cpp[each] for each in ("min", "median")}
        result[name] = {"from_python": python, "from_cpp": cpp, "python_costs": more}
    return result


def _kernels(loaded: Any, duration: float, progress: Progress) -> Result:
    """The whole cycle in the loop with each build of the inner loops."""
    model, description = loaded
    times: dict[str, list[np.ndarray]] = {}
    with _pinned():
        for _ in range(3):  # in turns
            for name in _core.build_info()["kernels"]:
                settings = _core.WalkSettings(kernel=name)
                columns = _core.benchmark_cycle(model, description, settings, WALK(), 2.0, 0, progress)
                times.setdefault(name, []).append(columns["in_loop"])
    return {name: statistics(np.concatenate(values)) for name, values in times.items()}


def _plan(loaded: Any, duration: float, progress: Progress) -> Result:
    """3.2 s of footsteps, COM and ZMP, 320 instants."""
    model, description = loaded
    controller = WalkingController(model, description, None, WALK())
    times, now = [], time.perf_counter_ns
    for _ in range(1000):
        start = now()
        controller.plan(3.2, 0.01)
        times.append(now() - start)
    return statistics(np.array(times) / 1000.0)


def _simulate(loaded: Any, duration: float, progress: Progress) -> Result:
    """The closed loop with every column recorded, on one core."""
    with _pinned():
        start = time.perf_counter()
        trace = simulate(loaded, WALK(), duration, on_progress=progress)
        wall = time.perf_counter() - start
    return {
        "real_time_factor": duration / wall,
        "wall_s": wall,
        "trace_MB": sum(trace[name].nbytes for name in trace) / 1e6,
        "stood": not trace.meta["fell"],
    }


def _physics(loaded: Any, duration: float, progress: Progress) -> Result:
    """A recorded walk beside MuJoCo's step alone on the same states; a controller that cost nothing would have 1."""
    model, description = loaded
    with _pinned():
        columns = _core.benchmark_walk(model, description, _core.WalkSettings(), WALK(), duration, progress)
    walk, bare = statistics(columns["walk"]), statistics(columns["bare"])
    return {
        "walk": walk,
        "mj_step": bare,
        "speed_ratio": {each: bare[each] / walk[each] for each in ("min", "median")},
        "same_states": not columns["difference"].any(),
    }


def _batch(loaded: Any, duration: float, progress: Progress) -> Result:
    """Eight walks on one thread, two, and as many as there are cores."""
    runs = [
        {"robot": loaded, "profile": VelocityProfile.constant(0.1), "duration": min(duration, 10.0), "seed": i}
        for i in range(8)
    ]
    result: Result = {}
    for threads in sorted({1, min(2, _cores()), _cores()}):
        best = np.inf
        for _ in range(3):
            start = time.perf_counter()
            simulate_batch(runs, threads, progress)
            best = min(best, time.perf_counter() - start)
        result[str(threads)] = {"wall_s": best, "simulated_s_per_s": len(runs) * runs[0]["duration"] / best}
    one = result["1"]["wall_s"]
    for each in result.values():
        each["speed_up"] = one / each["wall_s"]
    return result


def _joints(loaded: Any, duration: float, progress: Progress) -> Result:
    """Our robot with 12 joints (legs only), 25, and with fingers to make 40 and 60."""
    result: Result = {}
    with _pinned():
        for joints in JOINTS:
            model = mujoco.MjModel.from_xml_string(with_joints(joints))
            model, description = load_robot((model, _core.describe(model)))
            columns = _core.benchmark_cycle(
                model, description, _core.WalkSettings(), WALK(), min(duration, 4.0), TEXTBOOK_EVERY, progress
            )
            result[str(joints)] = {
                name: statistics(columns[name]) for name in ("in_loop", "from_scratch", "algebra", "textbook", "step")
            }
    return result


def with_joints(joints: int) -> str:
    """Our robot as MJCF with this many joints: 12 welds waist and arms, more than 25 adds fingers to the hands.

    Usage: `mujoco.MjModel.from_xml_string(with_joints(40))`
    """
    root = ElementTree.parse(ROBOTS / "mahru.xml").getroot()
    sensor, actuator, key = (root.find(path) for path in ("sensor", "actuator", "keyframe/key"))
    assert sensor is not None and actuator is not None and key is not None  # it is our own file
    root.remove(sensor)
    stand = key.attrib["qpos"].split()
    if joints < 25:
        legs = {motor.get("joint") for motor in actuator[:12]}
        for body in root.iter("body"):
            for joint in [j for j in body.findall("joint") if j.get("name") not in legs]:
                body.remove(joint)
        for motor in actuator[12:]:
            actuator.remove(motor)
        stand = stand[: 7 + 12]
        key.set("qpos", " ".join(stand))
        return ElementTree.tostring(root, encoding="unicode")
    hands = [body for body in root.iter("body") if body.get("name") in ("l_hand", "r_hand")]
    fingers = joints - 25
    for i in range(fingers):
        name = f"finger_{i}"
        finger = ElementTree.SubElement(hands[i % 2], "body", name=name, pos=f"0 {0.01 * (i // 2) - 0.05:g} -0.1")
        ElementTree.SubElement(finger, "inertial", mass="0.01", pos="0 0 -0.02", diaginertia="1e-5 1e-5 1e-5")
        ElementTree.SubElement(finger, "joint", name=name, axis="0 1 0", range="-1 1", armature="0.001")
        ElementTree.SubElement(actuator, "motor", name=name, joint=name, ctrlrange="-2 2")
    # qpos goes along the tree: the left hand's fingers follow its wrist, which is where the right arm begins
    left = (fingers + 1) // 2
    key.set("qpos", " ".join(stand[:26] + ["0"] * left + stand[26:] + ["0"] * (fingers - left)))
    return ElementTree.tostring(root, encoding="unicode")


def _import(loaded: Any, duration: float, progress: Progress) -> Result:
    """Seconds that `import zmpwalk` takes after mujoco and numpy, and how much longer all three take than these two.

    Each pair is measured in a process of its own. The first one leaves the byte code that an installed package has.
    """
    now = "time.perf_counter()"
    code = f"import time; a = {now}; import mujoco, numpy; b = {now}; import zmpwalk; print(b - a, {now} - b)"
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    command = [sys.executable, "-c", code]
    runs = [subprocess.run(command, check=True, stdout=subprocess.PIPE, env=environment).stdout for _ in range(12)]
    theirs, ours = np.array([run.split() for run in runs[1:]], float).T
    ratio = float(np.median((theirs + ours) / theirs))
    return {"min_s": float(ours.min()), "median_s": float(np.median(ours)), "ratio": ratio}


def _command(loaded: Any, duration: float, progress: Progress) -> Result:
    """Seconds that `zmpwalk walk --duration 8` takes in all, without figures."""
    times = []
    for _ in range(3):
        with tempfile.TemporaryDirectory() as folder:
            words = ["walk", "--duration", "8", "--no-figures", "--out", str(Path(folder) / "walk")]
            start = time.perf_counter()
            subprocess.run([sys.executable, "-m", "zmpwalk", *words], check=True, capture_output=True)
            times.append(time.perf_counter() - start)
    return {"min_s": min(times), "median_s": float(np.median(times))}


PARTS: dict[str, Callable[[Any, float, Progress], Result]] = {
    "cycle": _cycle,
    "python": _python,
    "kernels": _kernels,
    "plan": _plan,
    "simulate": _simulate,
    "physics": _physics,
    "batch": _batch,
    "joints": _joints,
    "import": _import,
    "command": _command,
}

STAGES = {
    "in_loop": "whole cycle, on the terms of mj_step1",
    "from_scratch": "whole cycle, from the state alone",
    "terms": "of it: reading the terms",
    "algebra": "of it: torque, wrenches, ZMP",
    "other": "of it: gait, tracking, checks",
    "iteration": "of it: reference ZMP to 1 mm",
    "terms_from_scratch": "the terms from the state",
    "textbook": "torque, wrenches, ZMP as printed",
    "step": "mj_step",
}


def tables(result: Result) -> list[tuple[str, list[str], list[list[str]]]]:
    """The result as tables: title, headings, rows of text.

    Usage: `for title, headings, rows in tables(bench()): ...`
    """

    def us(of: dict[str, float], *keys: str) -> list[str]:
        return [f"{of[key]:.2f}" if key in of else "–" for key in keys]

    every = ("min", "median", "p99", "p99.9", "max")
    out = []
    if "cycle" in result:
        cycle = result["cycle"]
        for phase in PHASES:
            rows = [[text, *us(cycle[phase][stage], *every)] for stage, text in STAGES.items()]
            out.append((f"one cycle in {phase} support [µs]", ["", *every], rows))
        rows = [
            [f"{ratio}, {phase} support", *(f"{cycle[phase]['ratios'][ratio][each]:.3f}" for each in ("min", "median"))]
            for ratio in cycle["double"]["ratios"]
            for phase in PHASES
        ]
        out.append(("ratios", ["", "min / min", "median / median"], rows))
    if "python" in result:
        rows = [
            [f"{name}, {key}".replace("_", " "), *us(of, "min", "median")]
            for name, entry in result["python"].items()
            for key, of in entry.items()
        ]
        out.append(("one update [µs]", ["", "min", "median"], rows))
    if "kernels" in result:
        rows = [[name, *us(of, "min", "median")] for name, of in result["kernels"].items()]
        out.append(("whole cycle in the loop, by build of the inner loops [µs]", ["", "min", "median"], rows))
    if "joints" in result:
        names = ("in_loop", "from_scratch", "algebra", "textbook", "step")
        rows = [[joints, *(us(of[name], "median")[0] for name in names)] for joints, of in result["joints"].items()]
        out.append(("by number of joints, median [µs]", ["joints", *(n.replace("_", " ") for n in names)], rows))
    if "batch" in result:
        rows = [
            [threads, f"{of['simulated_s_per_s']:.1f}", f"{of['speed_up']:.2f}"]
            for threads, of in result["batch"].items()
        ]
        out.append(("batches", ["threads", "simulated s per s", "speed-up"], rows))
    rest = []
    if "simulate" in result:
        rest.append(
            [
                f"simulate, {result['duration']:g} s recorded",
                f"{result['simulate']['real_time_factor']:.1f}",
                "× real time",
            ]
        )
    if "physics" in result:
        ratio = result["physics"]["speed_ratio"]["median"]
        rest.append(["speed of a recorded walk, mj_step alone on the same states being 1", f"{ratio:.3f}", "×"])
    if "plan" in result:
        rest.append(["plan of 3.2 s", f"{result['plan']['median']:.0f}", "µs"])
    if "import" in result:
        rest.append(["import zmpwalk, after mujoco and numpy", f"{result['import']['median_s']:.3f}", "s"])
        rest.append(["import of all three, mujoco and numpy being 1", f"{result['import']['ratio']:.2f}", "×"])
    if "command" in result:
        rest.append(["zmpwalk walk --duration 8 --no-figures", f"{result['command']['median_s']:.2f}", "s"])
    if rest:
        out.append(("the rest", ["", "", ""], rest))
    return out
