"""Tests that depend on MuJoCo, under versions between the two that the whole suite runs with.

Usage:
    python packaging/smoke.py build/py3.10/smoke 2.3.7 3.3.7

The zmpwalk of this environment is used as it is: each MuJoCo is unpacked into a folder of its own, which comes before
the environment's packages on the path. `zmpwalk build-adapter` makes its adapter. The walk that each repeats was walked
by the environment's own MuJoCo.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
TESTS = ["test_smoke.py", "test_versions.py", "test_files.py"]
REFERENCE = (
    "import sys, zmpwalk; settings = zmpwalk.WalkSettings(kernel='x86-64'); "
    "zmpwalk.simulate('mahru', duration=2.4, settings=settings).save(sys.argv[1])"
)


def unpacked(folder: Path, version: str) -> None:
    """MuJoCo alone: what it needs for files over the network is not asked for."""
    if not (folder / "mujoco").is_dir():
        packages = [f"mujoco=={version}"] + [f"mujoco-core=={version}"] * (int(version.split(".")[0]) >= 4)
        pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "-q", "install", "--no-deps"]
        subprocess.run([*pip, "--target", str(folder), *packages], check=True)


def main() -> None:
    place, *versions = sys.argv[1:]
    failed = []
    reference = Path(place).resolve() / "reference.npz"
    reference.parent.mkdir(parents=True, exist_ok=True)
    subprocess.run([sys.executable, "-c", REFERENCE, str(reference)], check=True)
    for version in versions:
        folder = Path(place).resolve() / version
        unpacked(folder, version)
        environment = {**os.environ, "PYTHONPATH": str(folder), "ZMPWALK_REFERENCE": str(reference)}
        print(f"== MuJoCo {version}", flush=True)
        subprocess.run([sys.executable, "-m", "zmpwalk", "build-adapter"], check=True, env=environment)
        command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider"]
        tests = [str(ROOT / "tests" / "python" / test) for test in TESTS]
        if subprocess.run([*command, *tests], check=False, env=environment, cwd=ROOT).returncode:
            failed.append(version)
    if failed:
        raise SystemExit(f"the smoke tests failed under MuJoCo {', '.join(failed)}")


if __name__ == "__main__":
    main()
