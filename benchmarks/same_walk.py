"""Whether a change moved any bit of a walk: `python benchmarks/same_walk.py REVISION [REVISION2]`.

Builds the package as it was at a git revision and as it stands in the working tree (or at REVISION2), each in a folder
of its own under build/same/, where only what changed is compiled again. Both use this Python and its MuJoCo. Each walks
twelve reference walks in a process of its own, and every column that both record is compared bit for bit; NaN equals
NaN. Prints a table and exits with 1 where any walk differs. ZMPWALK_TEST_ROBOTS names the folder of the test robots;
without it their three walks are skipped.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any, Callable, Mapping, NamedTuple

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
BUILD = ROOT / "build" / "same" / f"py{sys.version_info[0]}.{sys.version_info[1]}"
ROBOTS = os.environ.get("ZMPWALK_TEST_ROBOTS", "")
# vx, vy, wz [m/s, m/s, rad/s], each for a second
COMMANDS = (
    (0.15, 0.0, 0.0),
    (0.05, 0.08, 0.3),
    (0.2, -0.06, -0.3),
    (0.0, 0.0, 0.0),
    (-0.1, 0.05, 0.2),
    (0.2, 0.0, 0.0),
)
STOPS = ((0.0, 0.2), (1.5, 0.0), (4.0, (0.1, 0.05, 0.2)), (5.5, 0.0))  # time [s], velocity
ARMS = {
    "l_shoulder_pitch": (0.0, -0.4, 0.3, 0.0),
    "r_shoulder_pitch": (0.0, 0.3, -0.4, 0.0),
    "l_elbow": (-0.3, -1.0, -0.5, -0.3),
    "waist_yaw": (0.0, 0.2, -0.2, 0.0),
    "trunk_pitch": (0.0, 0.1, 0.0, 0.0),
}  # [rad], at 0, 1, 2 and 3 s


# ---- the walks: what runs in every revision, so that it takes only names which the package has had for long

# name -> the arguments of `simulate`, from the package; `settings` without the kernel
WALKS: dict[str, Callable[[Any], dict[str, Any]]] = {
    "default": lambda z: {"duration": 8.0},
    "law paper": lambda z: {"duration": 8.0, "settings": {"law": "paper"}},
    "footsteps absolute": lambda z: {"duration": 4.0, "settings": {"footsteps": "absolute"}},
    "footsteps paper": lambda z: {"duration": 4.0, "settings": {"footsteps": "paper"}},
    "footsteps printed": lambda z: {"duration": 4.0, "settings": {"footsteps": "printed"}},
    "footsteps list": lambda z: {"duration": 4.0, "settings": {"footsteps": [0.1, 0.15, 0.2]}},
    "arms": lambda z: {
        "duration": 5.0,
        "settings": {"momentum_arms": 1.0},
        "motion": z.JointMotion([0.0, 1.0, 2.0, 3.0], list(ARMS), np.transpose(list(ARMS.values()))),
    },
    "commands": lambda z: {
        "duration": 7.0,
        "profile": z.VelocityProfile.constant(0.0),
        "command": lambda t, out: COMMANDS[int(t) % len(COMMANDS)],
    },
    "stops": lambda z: {"duration": 8.0, "profile": z.VelocityProfile.piecewise(STOPS)},
    "unitree_g1": lambda z: {"duration": 4.0, "profile": z.VelocityProfile.ramp(0.0, 0.15, 1.5)},
    "fourier_n1": lambda z: {"duration": 4.0, "profile": z.VelocityProfile.ramp(0.0, 0.15, 1.5)},
    "robotis_op3": lambda z: {"duration": 4.0, "profile": z.VelocityProfile.ramp(0.0, 0.05, 1.5)},
}
TEST_ROBOTS = ("unitree_g1", "fourier_n1", "robotis_op3")


def walk_all(folder: Path) -> None:
    """Walk with the package that this process finds, and leave one file a walk in `folder`."""
    # An editable install answers imports before the path does.
    sys.meta_path[:] = [finder for finder in sys.meta_path if type(finder).__name__ != "ScikitBuildRedirectingFinder"]
    import zmpwalk

    package = Path(os.environ["PYTHONPATH"]).resolve()
    if package not in Path(zmpwalk.__file__).resolve().parents:
        raise SystemExit(f"same_walk: Python took zmpwalk from {zmpwalk.__file__}, not from {package}")
    for name, arguments in WALKS.items():
        if name in TEST_ROBOTS and not ROBOTS:
            continue
        print(name, flush=True)
        robot = str(Path(ROBOTS) / name / "robot.json") if name in TEST_ROBOTS else "mahru"
        given = arguments(zmpwalk)
        settings = zmpwalk.WalkSettings(kernel="x86-64", **given.pop("settings", {}))  # runs on every such processor
        trace = zmpwalk.simulate(robot, settings=settings, **given)
        np.savez(folder / f"{name}.npz", **{column: trace[column] for column in trace})


# ---- comparing


class Difference(NamedTuple):
    """Where two walks part: the first row, the first column that differs in it, by how much, and the largest of all."""

    row: int
    column: str
    first: float
    largest: float
    largest_column: str


def first_difference(before: Mapping[str, np.ndarray], after: Mapping[str, np.ndarray]) -> Difference | None:
    """The first difference between two walks in the columns that both have, over the rows that both have.

    Numbers are compared bit for bit, so that -0 differs from 0; NaN equals every NaN. Where a column has another width
    or one walk ends earlier, the difference is infinite.

    Args:
        before, after: column name -> (T,) or (T, n) floats.

    Usage: `first_difference(np.load("before.npz"), np.load("after.npz"))`
    """
    found = []
    for column in before:
        if column not in after:
            continue
        a, b = (np.ascontiguousarray(walk[column], dtype=float) for walk in (before, after))
        rows = min(len(a), len(b))
        if a.shape[1:] != b.shape[1:]:
            found.append((0, column, np.inf, np.inf))
            continue
        a, b = a[:rows].reshape(rows, -1), b[:rows].reshape(rows, -1)
        differs = (a.view(np.int64) != b.view(np.int64)) & ~(np.isnan(a) & np.isnan(b))
        if differs.any():
            with np.errstate(invalid="ignore"):
                sizes = np.where(differs, np.nan_to_num(np.abs(a - b), nan=np.inf), 0.0).max(axis=1)
            row = int(np.argmax(differs.any(axis=1)))
            found.append((row, column, sizes[row], sizes.max()))
        elif len(before[column]) != len(after[column]):
            found.append((rows, column, np.inf, np.inf))
    if not found:
        return None
    row, column, first, _ = min(found, key=lambda each: each[0])
    _, largest_column, _, largest = max(found, key=lambda each: each[3])
    return Difference(row, column, float(first), float(largest), largest_column)


# ---- building


def said(command: list[Any], log: Path, **kw: Any) -> None:
    """Run a command, its words in `log`, which is shown when it fails."""
    log.parent.mkdir(parents=True, exist_ok=True)
    with log.open("w") as out:
        done = subprocess.run([str(word) for word in command], stdout=out, stderr=subprocess.STDOUT, **kw)
    if done.returncode:
        raise SystemExit(f"{log.read_text()}\nsame_walk: {command[0]} failed, see above and {log}")


def git(*words: str) -> str:
    done = subprocess.run(["git", "-C", str(ROOT), *words], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"same_walk: {done.stderr.strip()}")
    return done.stdout.strip()


def source_of(revision: str | None) -> tuple[str, Path]:
    """Name of a revision's folder under build/same/, and its sources there; None is the working tree."""
    if revision is None:
        return "tree", copy_of_tree(BUILD / "tree" / "source")
    commit = git("rev-parse", "--verify", "--short=12", f"{revision}^{{commit}}")
    source = BUILD / commit / "source"
    if not source.is_dir():
        source.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=source.parent) as folder:
            archive, unpacked = Path(folder) / "source.tar", Path(folder) / "source"
            git("archive", f"--output={archive}", commit)
            shutil.unpack_archive(archive, unpacked)
            unpacked.rename(source)
    return commit, source


def copy_of_tree(copy: Path) -> Path:
    """The working tree's files in `copy`, where only those that changed are written anew.

    A copy lies beside its build folder as a revision's sources do, so that ccache knows the files that both have.
    """
    files = {name for name in git("ls-files", "-co", "--exclude-standard").splitlines() if (ROOT / name).is_file()}
    for file in [file for file in copy.rglob("*") if file.is_file()]:
        if file.relative_to(copy).as_posix() not in files:
            file.unlink()
    for name in files:
        ours, theirs = ROOT / name, copy / name
        if not theirs.is_file() or theirs.stat().st_mtime_ns != ours.stat().st_mtime_ns:
            theirs.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ours, theirs)
    return copy


def build(name: str, source: Path) -> Path:
    """Build the extension of `source` and lay the package beside it.

    Returns:
        The folder to put on the path, which holds zmpwalk/.
    """
    folder = BUILD / name
    programs = os.pathsep.join([str(Path(sys.executable).parent), os.environ.get("PATH", "")])
    env = {**os.environ, "PATH": programs}
    cmake = shutil.which("cmake", path=programs)
    if not cmake:
        raise SystemExit("same_walk: cmake is not installed in this Python's environment; `make same` has one")
    pybind11 = subprocess.run([sys.executable, "-m", "pybind11", "--cmakedir"], capture_output=True, text=True)
    options = ["-DZMPWALK_BUILD_PYTHON=ON", f"-DPython_EXECUTABLE={sys.executable}"]
    options.append(f"-Dpybind11_DIR={pybind11.stdout.strip()}")
    if shutil.which("ninja", path=programs):
        options += ["-G", "Ninja"]
    if shutil.which("ccache", path=programs):
        options.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
    said([cmake, "-S", source, "-B", folder / "build", *options], folder / "configure.log", env=env)
    said([cmake, "--build", folder / "build", "--target", "_core"], folder / "build.log", env=env)
    package = folder / "package"
    shutil.rmtree(package, ignore_errors=True)
    python = source / "python" / "zmpwalk"
    shutil.copytree(python, package / "zmpwalk", ignore=shutil.ignore_patterns("_core*.so", "_build.py", "__pycache__"))
    for file in [*(folder / "build").glob("_core*.so"), folder / "build" / "_build.py"]:
        shutil.copy(file, package / "zmpwalk")
    return package


def walked_by(name: str, source: Path) -> Path:
    """Build `source`, walk with it, and return the folder of its walks."""
    print(f"building {name}", file=sys.stderr, flush=True)
    package = build(name, source)
    print(f"walking with {name}", file=sys.stderr, flush=True)
    out = BUILD / name / "walks"
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir()
    env = {**os.environ, "PYTHONPATH": str(package)}
    said([sys.executable, __file__, "--walk-into", out], BUILD / name / "walk.log", env=env)
    return out


def row_of(name: str, before: Path, after: Path) -> tuple[str, bool]:
    """A line of the table, and whether it says that the walks differ."""
    if not (before / f"{name}.npz").is_file():
        return f"{name:20}      –  skipped: ZMPWALK_TEST_ROBOTS names no folder of test robots", False
    a, b = (dict(np.load(folder / f"{name}.npz")) for folder in (before, after))
    only = [f"{column} is only in the {which}" for which, these, others in (("first", a, b), ("second", b, a))
            for column in these if column not in others]  # fmt: skip
    found = first_difference(a, b)
    words = "equal" if found is None else (
        f"DIFFERS first in {found.column}, row {found.row}, by {found.first:.2g}; most in {found.largest_column}, "
        f"by {found.largest:.2g}")  # fmt: skip
    fell = " (it falls)" if a["fell"].any() else ""
    return "; ".join([f"{name:20} {len(a['t']):6d}  {words}{fell}", *only]), found is not None


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("revision", nargs="?", default="HEAD", help="what is compared, such as HEAD~3")
    parser.add_argument("revision2", nargs="?", help="with what; without it, with the working tree")
    parser.add_argument("--walk-into", metavar="FOLDER", help=argparse.SUPPRESS)  # how this program calls itself
    given = parser.parse_args()
    if given.walk_into:
        walk_all(Path(given.walk_into))
        return 0
    first, second = source_of(given.revision), source_of(given.revision2)
    before, after = walked_by(*first), walked_by(*second)
    print(f"{first[0]} against {second[0]}\n{'walk':20}   rows  columns")
    differs = False
    for name in WALKS:
        line, differ = row_of(name, before, after)
        print(line)
        differs |= differ
    return int(differs)


if __name__ == "__main__":
    sys.exit(main())
