"""What a wheel refuses: errors from C++ keep their type and text, and a MuJoCo that does not fit is one line.

Usage:
    python packaging/refusals.py dist/*cp310*.whl 2.2.2           # a wheel, and the MuJoCo beside which it is tried
    python packaging/refusals.py dist/*cp312*.whl 4.0.0

An empty environment under build/refusals gets MuJoCo and the wheel. Then its MuJoCo becomes an imaginary 9.9.9, is
swapped under a running Python, meets NumPy 2 where that is wrong, and is removed; each time the command line has to end
with one line and the exit code 2.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

from matrix import FIRST_FOR_NUMPY_2, ROOT, environment, last_line, run

FOLDER = ROOT / "build" / "refusals"
OTHERS = {"2.2.2": "2.3.7"}  # what a MuJoCo is swapped with, where it is not 3.3.7

ERRORS = """
import mujoco, numpy as np, zmpwalk
from zmpwalk import DimensionError, InputError, ModelError
calls = [
    (InputError, "kernel = 'abacus' is not one that this processor runs",
     lambda: zmpwalk.simulate("mahru", duration=0.1, settings=zmpwalk.WalkSettings(kernel="abacus"))),
    (InputError, "lateral_law = 'sideways' is unknown", lambda: zmpwalk.WalkSettings(lateral_law="sideways")),
    (InputError, "there is no setting 'abacus'", lambda: zmpwalk.WalkSettings(abacus=1)),
    (InputError, "T_ss", lambda: zmpwalk.simulate("mahru", duration=0.1, settings=zmpwalk.WalkSettings(T_ss=-1))),
    (InputError, "unknown robot 'marhu'", lambda: zmpwalk.load_robot("marhu")),
    (DimensionError, "v is (3, 1); it must be (2, 3)", lambda: zmpwalk.VelocityProfile([0, 1], [0, 1, 2])),
    (ModelError, "the model has no free joint",
     lambda: zmpwalk.WalkingController(mujoco.MjModel.from_xml_string("<mujoco/>"))),
    (InputError, "no file", lambda: zmpwalk.Trace.load("/nowhere/there is no file.npz")),
]
for kind, text, call in calls:
    try:
        call()
    except zmpwalk.Error as error:
        assert type(error) is kind, (type(error), error)
        assert text in str(error), error
    else:
        raise AssertionError(f"no error: {text}")
print(len(calls), "errors,", zmpwalk.build_info())
"""
SWAPPED = """
import subprocess, sys
import mujoco
pip = [sys.executable, "-m", "pip", "-q", "install", sys.argv[1]]
subprocess.run(pip, check=True, stderr=subprocess.DEVNULL)
sys.argv = ["zmpwalk", "inspect", "mahru"]
import zmpwalk
"""


def package_folder(inside: Path) -> Path:
    return next(inside.parents[1].glob("lib/python*/site-packages"))


def imaginary(inside: Path, version: str) -> None:
    """Make the installed MuJoCo one of the version 9.9.9."""
    site = package_folder(inside)
    (site / f"mujoco-{version}.dist-info").rename(site / "mujoco-9.9.9.dist-info")
    with (site / "mujoco" / "__init__.py").open("a") as file:
        file.write("\n__version__ = '9.9.9'\n")


def main() -> None:
    wheel, version = Path(sys.argv[1]).resolve(), sys.argv[2]
    found = run(ROOT / ".ci" / "find-python", ".".join(re.search(r"-cp(\d)(\d+)-", wheel.name).groups()))
    folder = FOLDER / f"{wheel.name.split('-')[2]}-mujoco{version}"
    is_old = tuple(int(part) for part in version.split(".")) < FIRST_FOR_NUMPY_2
    inside = environment(wheel, found.stdout.strip(), folder, version, "1" if is_old else "2")
    if isinstance(inside, str):
        raise SystemExit(inside)
    pip = [inside, "-m", "pip", "--disable-pip-version-check", "-q", "install", "--force-reinstall", "--no-deps"]
    command, inspect = inside.parent / "zmpwalk", ("inspect", "mahru")
    good = True

    def expect(what: str, part: str, *words: str | Path, code: int = 2) -> None:
        nonlocal good
        done = run(*words)
        lines = done.stdout.strip().splitlines()
        right = done.returncode == code and part in done.stdout and (code == 0 or len(lines) == 1)
        good &= right
        print(f"{what}: {'as it should be' if right else 'WRONG'}\n  {lines[-1] if right else done.stdout}", flush=True)

    expect("errors from C++", "errors, ", inside, "-c", ERRORS, code=0)
    expect("a bad argument", "abacus", command, "walk", "--set", "kernel=abacus")
    if is_old:
        numpy = last_line(run(inside, "-c", "import numpy; print(numpy.__version__)").stdout)
        run(*pip, "numpy>=2")
        expect("NumPy 2", 'pip install "numpy<2"', command, *inspect)
        run(*pip, f"numpy=={numpy}")
    other = OTHERS.get(version, "3.3.7")
    expect("swapped while Python runs", "is loaded, but", inside, "-c", SWAPPED, f"mujoco=={other}")
    expect("after that", "mahru", command, *inspect, code=0)
    # One that is taken away removes what it shares with another, so both go first.
    run(inside, "-m", "pip", "uninstall", "-y", "mujoco", "mujoco-core")
    run(*pip, f"mujoco=={version}", *[f"mujoco-core=={version}"] * (int(version.split(".")[0]) >= 4))
    imaginary(inside, version)
    expect("an imaginary MuJoCo", "no adapter to MuJoCo 9.9.9", command, *inspect)
    expect("its adapter", "is the adapter to MuJoCo 9.9.9", command, "build-adapter", code=0)
    expect("with that adapter", "mahru", command, *inspect, code=0)
    (package_folder(inside) / "mujoco-9.9.9.dist-info").rename(package_folder(inside) / f"mujoco-{version}.dist-info")
    run(inside, "-m", "pip", "uninstall", "-y", "mujoco", "mujoco-core")
    expect("no MuJoCo", "no mujoco is installed: pip install mujoco", command, *inspect)
    sys.exit(not good)


if __name__ == "__main__":
    main()
