"""One wheel under many MuJoCo versions: installs, walks the paper's profile, compares, inspects, films.

Usage:
    python benchmarks/mujoco_matrix.py build/py3.10/wheel/*.whl            # every version that this Python has
    python benchmarks/mujoco_matrix.py WHEEL --mujoco 3.3.7 --no-video

Each pair of versions gets an environment of its own under build/matrix, into which MuJoCo and NumPy are installed first
and the wheel second; that must change neither. The reference is the walk under MuJoCo 2.2.2, which stands in
build/matrix/reference.npy once a Python up to 3.10 has walked it. `make matrix PYTHON=3.10` builds the wheel and does
all this.
"""

from __future__ import annotations

import argparse
import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "build" / "matrix"
VERSIONS = ["2.2.2", "2.3.7", "3.1.6", "3.2.7", "3.3.7", "3.8.1", "3.17.0", "4.0.0"]
FIRST_FOR_NUMPY_2 = (3, 1, 4)
TOLERANCE = 1e-8  # of the COM [m]

PROBE = """
import json, sys, mujoco, numpy, zmpwalk
from zmpwalk import VelocityProfile, WalkSettings
walk = zmpwalk.simulate("mahru", profile=VelocityProfile.paper(), duration=8.0, settings=WalkSettings(kernel="x86-64"))
numpy.save(sys.argv[1], walk["com"])
print(json.dumps({"mujoco": mujoco.__version__, "numpy": numpy.__version__, "fell": bool(walk.meta["fell"])}))
"""


def run(*command: str | Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [str(part) for part in command], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False
    )


def environment(wheel: Path, python: str, mujoco: str, numpy: str) -> Path | str:
    """The Python of an environment with these versions and the wheel, or why there is none."""
    major, minor = re.search(r"-cp(\d)(\d+)-", wheel.name).groups()  # type: ignore[union-attr]
    folder = FOLDER / f"py{major}.{minor}-mujoco{mujoco}-numpy{numpy}"
    inside = folder / "bin" / "python"
    if not inside.exists():
        run(python, "-m", "venv", folder)
    pip = [inside, "-m", "pip", "--disable-pip-version-check", "-q", "install"]
    bound = "numpy<2" if numpy == "1" else "numpy>=2"
    if run(*pip, "--only-binary", ":all:", f"mujoco=={mujoco}", bound).returncode:
        return "not to be had"
    before = run(inside, "-m", "pip", "freeze").stdout
    done = run(*pip, "--force-reinstall", "--no-deps", wheel)
    done = done if done.returncode else run(*pip, f"{wheel}[video]")
    if done.returncode:
        return f"does not install: {done.stdout.strip().splitlines()[-1]}"
    kept = [line for line in before.splitlines() if re.match("mujoco|numpy", line)]
    lost = [line for line in kept if line not in run(inside, "-m", "pip", "freeze").stdout.splitlines()]
    return f"installing changed {', '.join(lost)}" if lost else inside


def row(wheel: Path, python: str, mujoco: str, numpy: str, video: bool) -> dict[str, str]:
    """What one pair of versions gave."""
    out = {"mujoco": mujoco, "numpy": numpy, "com": "", "inspect": "", "video": ""}
    inside = environment(wheel, python, mujoco, numpy)
    if isinstance(inside, str):
        return {**out, "com": inside}
    com = FOLDER / f"com-{wheel.name.split('-')[2]}-{mujoco}-{numpy}.npy"
    walked = run(inside, "-c", PROBE, com)
    if walked.returncode:
        return {**out, "com": walked.stdout.strip().splitlines()[-1]}
    said = json.loads(walked.stdout.strip().splitlines()[-1])
    reference = FOLDER / "reference.npy"
    if mujoco == VERSIONS[0]:
        np.save(reference, np.load(com))
    away = np.abs(np.load(com) - np.load(reference)).max() if reference.exists() else np.nan
    out.update(numpy=said["numpy"], com=f"{away:.1e}" + (", fell" if said["fell"] else ""))
    out["com"] += "" if away < TOLERANCE else ", too far"
    out["inspect"] = "yes" if run(inside, "-m", "zmpwalk", "inspect", "mahru", "--json").returncode == 0 else "no"
    if video:
        film = [inside, "-m", "zmpwalk", "video", "--duration", "0.5", "--out", FOLDER / f"{mujoco}.mp4"]
        out["video"] = "yes" if run(*film).returncode == 0 else "no"
    return out


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("wheel", type=Path)
    parser.add_argument("--mujoco", nargs="*", default=VERSIONS)
    parser.add_argument("--no-video", action="store_true")
    options = parser.parse_args()
    FOLDER.mkdir(parents=True, exist_ok=True)
    version = re.search(r"-cp(\d)(\d+)-", options.wheel.name)
    if not version:
        raise SystemExit(f"{options.wheel} is no wheel of one Python")
    name = ".".join(version.groups())
    found = run(ROOT / ".ci" / "find-python", name)
    if found.returncode:
        raise SystemExit(found.stdout.strip())
    print(f"Python {name}\n\n| MuJoCo | NumPy | COM away from 2.2.2 over 8 s [m] | inspect | video |")
    print("|---|---|---|---|---|")
    good = True
    for mujoco in options.mujoco:
        numbers = tuple(int(part) for part in mujoco.split("."))
        for numpy in ("1", "2") if numbers >= FIRST_FOR_NUMPY_2 else ("1",):
            line = row(options.wheel.resolve(), found.stdout.strip(), mujoco, numpy, not options.no_video)
            print("| " + " | ".join(line.values()) + " |", flush=True)
            good &= line["com"] == "not to be had" or ("," not in line["com"] and "no" not in line.values())
    sys.exit(not good)


if __name__ == "__main__":
    main()
