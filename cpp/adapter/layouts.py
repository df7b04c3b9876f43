"""Which MuJoCo versions can share an adapter, and one adapter for each such group.

The adapter is compiled against the headers of every release. Where the object code is the same, all that the adapter
touches lies in the same places and has the same numbers: those versions are one layout, which is called after its
first. `python/zmpwalk/adapters/layouts.json` keeps the result, so that an adapter that was built for one version is
found for the others.

Usage:
    python cpp/adapter/layouts.py build/mujoco                     # writes layouts.json
    python cpp/adapter/layouts.py build/mujoco --adapters OUT      # and adapter-VERSION.so for each layout into OUT
    python cpp/adapter/layouts.py build/mujoco --release 4.1.0     # one more release than those in layouts.json

The headers come from the wheels in the package index, which are kept unpacked in the folder: VERSION/mujoco/include.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import subprocess
import sys
import tempfile
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
LAYOUTS = HERE.parents[1] / "python" / "zmpwalk" / "adapters" / "layouts.json"
# Without debugging records, which name the folder; an adapter needs nothing of the C++ library.
COMPILE = ["-std=c++17", "-O2", "-g0", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics", "-fPIC"]
COMPILE += ["-fvisibility=hidden", "-w", "-I", str(HERE.parent / "include")]
LINK = ["-shared", "-s", "-O2", "-nostdlib"]


def fetch(version: str, folder: Path) -> Path:
    """The include folder of a release, from its wheel. Any wheel will do: the headers are the same in all."""
    include = folder / version / "mujoco" / "include"
    for package in ("mujoco", "mujoco-core"):  # from 4.0 on the headers are in the second
        if include.is_dir():
            break
        with tempfile.TemporaryDirectory() as scratch:
            for python in ("3.10", "3.11", "3.12", "3.13"):
                command = [sys.executable, "-m", "pip", "-q", "download", "--no-deps", "--only-binary", ":all:"]
                command += ["--python-version", python, "-d", scratch, f"{package}=={version}.*"]  # 2.3.1.post1 too
                if subprocess.run(command, check=False, stderr=subprocess.DEVNULL).returncode == 0:
                    break
            for wheel in Path(scratch).glob("*.whl"):
                with zipfile.ZipFile(wheel) as archive:
                    wanted = ("mujoco/include/", "mujoco/libmujoco.so")  # attributes.py asks the library
                    names = [name for name in archive.namelist() if name.startswith(wanted)]
                    archive.extractall(folder / version, names)
    if not include.is_dir():
        raise SystemExit(f"layouts: no headers of MuJoCo {version} could be had")
    return include


def compiled(include: Path, made: Path) -> str:
    """Compile the adapter with these headers into `made`; what its object code is, as a short sum."""
    command = [os.environ.get("CXX", "c++"), *COMPILE, "-c", "-I", str(include), str(HERE / "adapter.cpp")]
    subprocess.run([*command, "-o", str(made)], check=True)
    return hashlib.sha256(made.read_bytes()).hexdigest()[:12]


def grouped(sums: dict[str, str]) -> dict[str, str]:
    """{version: the first version whose adapter is the same}, in the order of the versions."""
    first: dict[str, str] = {}
    ordered = sorted(sums, key=numbers)
    return {version: first.setdefault(sums[version], version) for version in ordered}


def numbers(version: str) -> tuple[int, ...]:
    return tuple(int(part) for part in version.split("."))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("headers", type=Path, help="folder with the unpacked headers, filled where it is not")
    parser.add_argument("--adapters", type=Path, help="folder to write an adapter for each layout into")
    parser.add_argument("--release", action="append", default=[], help="one more release to look at")
    options = parser.parse_args()
    versions = {*json.loads(LAYOUTS.read_text()), *options.release} if LAYOUTS.exists() else {*options.release}
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(os.cpu_count()) as pool:
        order = sorted(versions, key=numbers)
        objects = {version: Path(scratch, f"{version}.o") for version in order}
        sums = pool.map(lambda version: compiled(fetch(version, options.headers), objects[version]), order)
        layouts = grouped(dict(zip(order, sums)))
        LAYOUTS.write_text(json.dumps(layouts, indent=0) + "\n")
        print(f"{len(layouts)} releases, {len(set(layouts.values()))} layouts")
        for old in options.adapters.glob("adapter-*.so") if options.adapters else ():
            old.unlink()
        for layout in dict.fromkeys(layouts.values()) if options.adapters else ():
            options.adapters.mkdir(parents=True, exist_ok=True)
            link = [os.environ.get("CXX", "c++"), *LINK, str(objects[layout])]
            subprocess.run([*link, "-o", str(options.adapters / f"adapter-{layout}.so")], check=True)


if __name__ == "__main__":
    main()
