"""Our control cycle beside TSID's tick and placo's: `python benchmarks/peers/run.py [--json FILE]`, zmpwalk's Python.

Makes the peers' environments under build/peers from the extras `peers` and `peers-placo`, exports the robot and
instants of a walk, checks that all answer alike, then times everybody in turn, round after round. Needs a C++ compiler.
"""

import argparse
import contextlib
import json
import os
import platform
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import mujoco
import numpy as np
import problem
import zmpwalk
from zmpwalk import _core

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(HERE.parent))
from report import peers_table  # noqa: E402

try:
    import tomllib
except ImportError:  # before Python 3.11
    from pip._vendor import tomli as tomllib

BUILD = ROOT / "build" / "peers"
PYTHONS = ("3.10", "3.11", "3.12")  # for which the pinned versions have wheels
# A peer that answers worse than this does not solve our problem, and its time means nothing.
MODEL_TOLERANCE = 1e-9  # relative
TOLERANCE = {"acceleration": 1e-3, "force": 1e-2, "zmp_mm": 1e-2, "torque_motion": 1e-2}
PHASES = ("ss", "ds", "stand")


class Failure(Exception):
    """One line for the user."""


def run(command, what, **options):
    """Run to the end. Raises Failure with the last line that it said."""
    done = subprocess.run(
        [str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options
    )
    if done.returncode:
        said = [line for line in done.stdout.splitlines() if "error" in line.lower()] or done.stdout.splitlines()[-1:]
        raise Failure(f"{what} failed: {said[0].strip() if said else f'exit {done.returncode}'}")
    return done.stdout


def peers_python():
    """An interpreter for which the pins have wheels: this one, else the first that `.ci/find-python` knows."""
    for version in (platform.python_version().rpartition(".")[0], *PYTHONS):
        if version in PYTHONS:
            with contextlib.suppress(Failure):
                return run([ROOT / ".ci" / "find-python", version], "find-python").strip().splitlines()[-1]
    raise Failure(f"the peers' wheels need one of Python {', '.join(PYTHONS)}, and none is here")


def environment(extra):
    """The Python of an environment that holds what `extra` of pyproject.toml asks for; made anew when that changed."""
    pins = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"][extra]
    folder = BUILD / f"{extra}-environment"
    stamp, wanted = folder / "pins.txt", "\n".join(pins) + "\n"
    python = folder / "bin" / "python"
    if stamp.exists() and stamp.read_text() == wanted:
        return python
    print(f"-- making {folder.relative_to(ROOT)}", file=sys.stderr)
    run([peers_python(), "-m", "venv", "--clear", folder], f"making the environment of [{extra}]")
    folder.joinpath("asked.txt").write_text(wanted)
    pip = [
        python,
        "-m",
        "pip",
        "--disable-pip-version-check",
        "--no-input",
        "install",
        "-q",
        "-r",
        folder / "asked.txt",
    ]
    run(pip, f"installing [{extra}] into {folder.relative_to(ROOT)}")
    stamp.write_text(wanted)
    return python


def compile_cpp(python):
    """tsid_peer.cpp against the headers and libraries of TSID's environment; plain -O3, as the libraries are built."""
    compiler = shutil.which(os.environ.get("CXX") or "c++") or shutil.which("g++") or shutil.which("clang++")
    if not compiler:
        raise Failure("no C++ compiler for tsid_peer.cpp: set CXX or install one (Debian, Ubuntu: apt install g++)")
    prefix = Path(
        run([python, "-c", "import cmeel, pathlib; print(pathlib.Path(cmeel.__file__).parents[1])"], "cmeel").strip()
    )
    prefix, source, program = prefix / "cmeel.prefix", HERE / "tsid_peer.cpp", BUILD / "tsid_peer"
    if not program.exists() or program.stat().st_mtime < max(source.stat().st_mtime, python.lstat().st_mtime):
        print(f"-- compiling {source.relative_to(ROOT)}", file=sys.stderr)
        command = [compiler, "-std=c++17", "-O3", "-DNDEBUG", "-w", source, "-o", program]
        command += ["-isystem", prefix / "include", "-isystem", prefix / "include" / "eigen3"]
        command += [f"-L{prefix / 'lib'}", f"-Wl,-rpath,{prefix / 'lib'}"]
        command += ["-ltsid", "-leiquadprog", "-lpinocchio_default", "-lpinocchio_parsers"]
        run(command, "compiling tsid_peer.cpp")
    version = run([compiler, "--version"], "the compiler").splitlines()[0]
    return program, version


class Peer:
    """A process that answers the commands of serve.py."""

    def __init__(self, name, command, folder):
        self.name = name
        self.log = (folder / f"{name}.log").open("w+")
        self.process = subprocess.Popen(
            [str(c) for c in (*command, folder)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self.log,
            text=True,
            bufsize=1,
        )

    def ask(self, *command):
        with contextlib.suppress(BrokenPipeError):
            self.process.stdin.write(" ".join(str(word) for word in command) + "\n")
        line = self.process.stdout.readline()
        if not line:
            self.log.seek(0)
            said = self.log.read().splitlines()
            raise Failure(f"{self.name} died at '{command[0]}': {said[-1] if said else self.process.wait()}")
        return json.loads(line)

    def close(self):
        with contextlib.suppress(BrokenPipeError):
            self.process.stdin.close()
        self.process.wait()
        self.log.close()


def our_python(seconds):
    """phase -> [ns] of `controller.update(data)` timed from Python inside a walk."""
    model, description = zmpwalk.load_robot("mahru")
    data = mujoco.MjData(model)
    description.place(model, data)
    controller = zmpwalk.WalkingController(model, description)
    controller.reset(data)
    cycles = {"ss": [], "ds": []}
    for _ in range(round(seconds / model.opt.timestep)):
        before = time.perf_counter_ns()
        out = controller.update(data)
        after = time.perf_counter_ns()
        cycles["ss" if out.phase else "ds"].append(after - before)
        mujoco.mj_step(model, data)
    return cycles


def our_cpp(seconds):
    """who -> phase -> [ns] of a walk in C++: cycle from the state alone, cycle after mj_step1, physics step."""
    model, description = zmpwalk.load_robot("mahru")
    settings, profile = zmpwalk.WalkSettings(), zmpwalk.VelocityProfile.paper()
    columns = _core.benchmark_cycle(model, description, settings, profile, seconds, textbook_every=0)
    names = {"zmpwalk_cpp": "from_scratch", "zmpwalk_cpp_in_loop": "in_loop", "mj_step_cpp": "step"}
    return {
        who: {phase: (1e3 * columns[name][columns["phase"] == i]).tolist() for i, phase in enumerate(("ds", "ss"))}
        for who, name in names.items()
    }


def cpu():
    with contextlib.suppress(OSError):
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()


def check(peers, ours):
    """How far every peer is from us. Raises Failure where one does not solve the same problem."""
    agreement = {"model": problem.model_difference(ours, peers["tsid_python"].ask("model"))}
    for name, value in agreement["model"].items():
        if not value <= MODEL_TOLERANCE:
            raise Failure(f"the exported URDF is not our robot: {name} differ by {value:.1e} (relative)")
    for peer in peers.values():
        agreement[peer.name] = {phase: problem.difference(ours[phase], peer.ask("solve", phase)) for phase in PHASES}
        for phase, differences in agreement[peer.name].items():
            for name, limit in TOLERANCE.items():
                if not differences[name] <= limit:
                    raise Failure(
                        f"{peer.name} answers another problem ({phase}): {name} differs by {differences[name]:.1e}"
                    )
    return agreement


def measure(peers, rounds, ticks, seconds):
    """phase -> who -> {min, median} [us], everybody in turn, round after round."""
    samples = {phase: {} for phase in PHASES}

    def add(who, by_phase):
        for phase, nanoseconds in by_phase.items():
            samples[phase].setdefault(who, []).extend(nanoseconds)

    our_python(seconds), our_cpp(seconds)  # nobody starts cold
    for peer in peers.values():
        for phase in PHASES:
            peer.ask("time", phase, ticks)
    for _ in range(rounds):
        add("zmpwalk_python", our_python(seconds))
        for who, by_phase in our_cpp(seconds).items():
            add(who, by_phase)
        for peer in peers.values():
            add(peer.name, {phase: peer.ask("time", phase, ticks) for phase in PHASES})
    return {phase: {who: summary(values) for who, values in part.items()} for phase, part in samples.items()}


def summary(nanoseconds):
    """Minimum and median [us]."""
    return {"min": 1e-3 * float(np.min(nanoseconds)), "median": 1e-3 * float(np.median(nanoseconds))}


def compare(rounds, ticks, seconds):
    """The whole comparison as one dictionary, ready for JSON."""
    pythons = {extra: environment(extra) for extra in ("peers", "peers-placo")}
    program, compiler = compile_cpp(pythons["peers"])
    with tempfile.TemporaryDirectory(prefix="zmpwalk-peers-") as temporary, contextlib.ExitStack() as stack:
        folder = Path(temporary)
        written, ours = problem.build(folder)
        peers = {
            "tsid_cpp": [program],
            "tsid_python": [pythons["peers"], HERE / "tsid_peer.py"],
            "placo_python": [pythons["peers-placo"], HERE / "placo_peer.py"],
        }
        for name, command in peers.items():
            peers[name] = Peer(name, command, folder)
            stack.callback(peers[name].close)
        versions = {"zmpwalk": zmpwalk.__version__, "mujoco": mujoco.__version__, "numpy": np.__version__}
        for name in ("tsid_python", "placo_python"):
            package = name.partition("_")[0]
            versions.update(
                {k if k == package else f"{k} ({package})": v for k, v in peers[name].ask("versions").items()}
            )
        return {
            "cpu": cpu(),
            "cores": os.cpu_count(),
            "python": platform.python_version(),
            "peers_python": run([pythons["peers"], "-V"], "the peers' Python").split()[-1],
            "compiler": compiler,
            "kernel": zmpwalk.build_info()["kernel"],
            "versions": versions,
            "rounds": rounds,
            "ticks": ticks,
            "states": {phase: len(written["phases"][phase]["states"]) for phase in PHASES},
            "size": peers["tsid_python"].ask("size"),
            "active": {
                phase: [answer["active"] for answer in peers["tsid_cpp"].ask("solve", phase)] for phase in PHASES
            },
            "agreement": check(peers, ours),
            **measure(peers, rounds, ticks, seconds),
            "plan": {
                "placo_python": {
                    timesteps: {**summary(plan["ns"]), "planned_s": plan["planned_s"]}
                    for timesteps, plan in peers["placo_python"].ask("plan").items()
                }
            },
        }


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--json", type=Path, help="write the numbers here (default: build/peers/peers.json)")
    parser.add_argument("--rounds", type=int, default=8, help="times that everybody gets a turn (default %(default)s)")
    parser.add_argument(
        "--ticks", type=int, default=300, help="ticks of a peer per turn and phase (default %(default)s)"
    )
    parser.add_argument("--seconds", type=float, default=4.0, help="our walk per turn [s] (default %(default)s)")
    options = parser.parse_args()
    try:
        result = compare(options.rounds, options.ticks, options.seconds)
    except Failure as failure:
        print(f"peers: {failure}", file=sys.stderr)
        raise SystemExit(1) from None
    path = options.json or BUILD / "peers.json"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(result, indent=2) + "\n")
    print(peers_table(result))
    print(f"written: {path}", file=sys.stderr)


if __name__ == "__main__":
    main()
