"""The wheels under many MuJoCo versions: each installs, walks as under MuJoCo 2.2.2, inspects, films and reads traces.

Usage:
    python packaging/matrix.py dist/*.whl                                   # every pair of Python and MuJoCo
    python packaging/matrix.py dist/*cp310*.whl --mujoco 2.2.2 3.3.7 --numpy 1
    python packaging/matrix.py --table                                      # what earlier runs have found

Every combination gets an empty environment under build/matrix, into which MuJoCo and NumPy are installed first and the
wheel second; that must change neither. The reference is the walk under MuJoCo 2.2.2 of the first Python that has it,
and the newest MuJoCo repeats its trace, as every other does, while MuJoCo 2.2.2 repeats the newest's. Results are kept
in build/matrix/results.json; the table of docs/mujoco.md is made of them. `make matrix` builds the wheels and does all
this.
"""

from __future__ import annotations

import argparse
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "build" / "matrix"
RESULTS = FOLDER / "results.json"
PAGE = ROOT / "docs" / "mujoco.md"
MARKS = ("<!-- matrix -->\n", "<!-- end of matrix -->\n")  # the table on the page stands between them
VERSIONS = ["2.2.2", "2.3.7", "3.1.6", "3.2.7", "3.3.7", "3.8.1", "3.17.0", "4.0.0"]
FIRST_FOR_NUMPY_2 = (3, 1, 4)
TOLERANCE = 1e-8  # of the COM [m]
REFERENCE, NEWEST = FOLDER / "reference.npz", FOLDER / "newest.npz"

# Runs in each environment. What it finds goes out as JSON, in the last line.
PROBE = """
import json, pathlib, sys, warnings
import mujoco, numpy as np, zmpwalk
folder, reference, others = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3:]
settings = zmpwalk.WalkSettings(kernel="x86-64")
walk = zmpwalk.simulate("mahru", profile=zmpwalk.VelocityProfile.paper(), duration=8.0, settings=settings)
walk.save(folder / "walk.npz")
com = zmpwalk.Trace.load(reference).com if reference.exists() else walk.com
found = {"mujoco": mujoco.__version__, "numpy": np.__version__, "com": float(np.abs(walk.com - com).max())}
found["fell"] = bool(walk.meta["fell"])
warnings.simplefilter("ignore")
for other in others:
    recorded = zmpwalk.Trace.load(other)
    again = recorded.rerun()
    found["again"] = max(found.get("again", 0.0), float(np.abs(again.com - recorded.com).max()))
    assert (again.meta["versions"]["mujoco"] == recorded.meta["versions"]["mujoco"]) == ("rerun_of" not in again.meta)
print(json.dumps(found))
"""


def run(*command: str | Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [str(part) for part in command], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False
    )


def last_line(text: str) -> str:
    return text.strip().splitlines()[-1]


def environment(wheel: Path, python: str, folder: Path, mujoco: str, numpy: str) -> Path | str:
    """The Python of a new environment with these versions and the wheel, or why there is none."""
    inside = folder / "bin" / "python"
    run(python, "-m", "venv", "--clear", folder)
    pip = [inside, "-m", "pip", "--disable-pip-version-check", "-q", "install"]
    if run(*pip, "--only-binary", ":all:", f"mujoco=={mujoco}", "numpy<2" if numpy == "1" else "numpy>=2").returncode:
        return "not to be had"
    before = run(inside, "-m", "pip", "freeze").stdout
    done = run(*pip, wheel, "imageio", "imageio-ffmpeg")
    if done.returncode:
        return f"does not install: {last_line(done.stdout)}"
    kept = [line for line in before.splitlines() if re.match("mujoco|numpy", line)]
    lost = [line for line in kept if line not in run(inside, "-m", "pip", "freeze").stdout.splitlines()]
    return f"installing changed {', '.join(lost)}" if lost else inside


def tried(wheel: Path, python: str, version: str, mujoco: str, numpy: str) -> dict[str, Any]:
    """What one combination gave; `wrong` says what was not as it should be."""
    folder = FOLDER / f"py{version}-mujoco{mujoco}-numpy{numpy}"
    inside = environment(wheel, python, folder, mujoco, numpy)
    if isinstance(inside, str):
        return {"wrong": inside}
    others = [trace for trace in (REFERENCE, NEWEST) if trace.exists()]
    probed = run(inside, "-c", PROBE, folder, REFERENCE, *others)
    if probed.returncode:
        return {"wrong": last_line(probed.stdout)}
    found: dict[str, Any] = json.loads(last_line(probed.stdout))
    wrong = []
    if found["fell"] or not max(found["com"], found.get("again", 0.0)) < TOLERANCE:
        wrong.append("too far away")
    for trace, first in ((REFERENCE, mujoco == VERSIONS[0]), (NEWEST, mujoco == VERSIONS[-1])):
        if first and not trace.exists():
            shutil.copy(folder / "walk.npz", trace)
    film = [inside, "-m", "zmpwalk", "video", "--size", "160x120", "--fps", "2", "--out", folder / "walk.mp4"]
    if run(inside, "-m", "zmpwalk", "inspect", "mahru", "--json").returncode:
        wrong.append("inspect fails")
    if run(*film, "--duration", "1").returncode:
        wrong.append("video fails")
    for trace in others:
        if run(*film, trace).returncode:
            wrong.append(f"the film of {trace.name} fails")
    shutil.rmtree(folder, ignore_errors=True)
    return {**found, "wrong": ", ".join(wrong)}


def _cell(found: dict[str, Any]) -> str:
    if "com" not in found or found["wrong"]:
        return {"not to be had": "–"}.get(found["wrong"], found["wrong"])
    return f"{found['com']:.1e}" if found["com"] else "0"


def table(results: dict[str, dict[str, Any]]) -> str:
    """The results as Markdown: a row for each MuJoCo and NumPy, a column for each Python."""
    pythons = sorted({key.split()[0] for key in results}, key=lambda name: int(name.split(".")[1]))
    lines = [
        "| MuJoCo | NumPy | " + " | ".join(f"Python {name}" for name in pythons) + " | traces of others |",
        "|" + "---|" * (len(pythons) + 3),
    ]
    for mujoco in VERSIONS:
        for numpy in ("1", "2"):
            row = [results.get(f"{name} {mujoco} {numpy}", {"wrong": "not tried"}) for name in pythons]
            if all(found["wrong"] in ("not to be had", "not tried") for found in row):
                continue
            cells = [_cell(found) for found in row]
            again = [found["again"] for found in row if "again" in found]
            lines.append(f"| {mujoco} | {numpy} | {' | '.join(cells)} | {f'{max(again):.1e}' if again else ''} |")
    return "\n".join(lines) + "\n"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("wheels", type=Path, nargs="*")
    parser.add_argument("--mujoco", nargs="*", default=VERSIONS)
    parser.add_argument("--numpy", nargs="*", default=["1", "2"])
    parser.add_argument("--table", action="store_true", help="only write the table of docs/mujoco.md")
    options = parser.parse_args()
    FOLDER.mkdir(parents=True, exist_ok=True)
    results: dict[str, dict[str, Any]] = json.loads(RESULTS.read_text()) if RESULTS.exists() else {}
    combinations = []
    for wheel in sorted(options.wheels, key=lambda path: [int(n) for n in re.findall(r"cp3(\d+)-", path.name)]):
        version = ".".join(re.search(r"-cp(\d)(\d+)-", wheel.name).groups())  # type: ignore[union-attr]
        for mujoco in options.mujoco:
            is_old = tuple(int(part) for part in mujoco.split(".")) < FIRST_FOR_NUMPY_2
            combinations += [(wheel, version, mujoco, each) for each in (["1"] if is_old else options.numpy)]
    # Where MuJoCo 2.2.2 walked before there was a trace of the newest, it is asked once more at the end.
    combinations += [one for one in combinations if one[2] == VERSIONS[0] and not NEWEST.exists()]
    good = True
    for wheel, version, mujoco, numpy in combinations:
        python = run(ROOT / ".ci" / "find-python", version)
        if python.returncode:
            raise SystemExit(python.stdout.strip())
        found = tried(wheel.resolve(), python.stdout.strip(), version, mujoco, numpy)
        print(f"Python {version}, MuJoCo {mujoco}, NumPy {numpy}: {found}", flush=True)
        results[f"{version} {mujoco} {numpy}"] = found
        RESULTS.write_text(json.dumps(results, indent=0))
        good &= found["wrong"] in ("", "not to be had")
    print(table(results))
    head, _, rest = PAGE.read_text().partition(MARKS[0])
    PAGE.write_text(head + MARKS[0] + table(results) + MARKS[1] + rest.partition(MARKS[1])[2])
    sys.exit(not good)


if __name__ == "__main__":
    main()
