"""The wheel for aarch64, tried under emulation: the C++ tests, and a walk beside that of this machine's own wheel.

Usage:
    python packaging/arm.py dist/*cp311*.whl                     # wheels for x86_64 and for aarch64
    python packaging/arm.py dist/*cp311*.whl --mujoco 4.0.0 --only walk

An aarch64 Python with all that it needs is unpacked from Debian's packages, and nothing of the system changes. What has
to be there is Debian with apt, of a release whose Python is that of the wheels, and qemu-aarch64-static (package
qemu-user-static). Everything is kept in build/arm; `make arm-check` makes the wheels and does all this.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

from wheels import TOOLS, compiler, made, requirements

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "build" / "arm"
SYSTEM = FOLDER / "root"  # the aarch64 system
EMULATOR = "qemu-aarch64-static"
VERSIONS = ["2.3.7", "4.0.0"]
PYTHON = "3.11"
PLATFORMS = ("manylinux2014", "manylinux_2_17", "manylinux_2_24", "manylinux_2_27", "manylinux_2_28", "manylinux_2_34")
DURATION, TOLERANCE = 2.0, 1e-9  # of the walk [s], of its COM [m]

WALK = """
import json, platform, sys
import mujoco, numpy as np, zmpwalk
kernel = "x86-64" if platform.machine() == "x86_64" else "generic"
profile, settings = zmpwalk.VelocityProfile.paper(), zmpwalk.WalkSettings(kernel=kernel)
walk = zmpwalk.simulate("mahru", profile=profile, duration=float(sys.argv[2]), settings=settings)
np.save(sys.argv[1], walk.com)
print(json.dumps({"machine": platform.machine(), "mujoco": mujoco.__version__, "fell": bool(walk.meta["fell"]),
                  "build": zmpwalk.build_info()}))
"""


def run(*command: str | Path, **environment: str) -> str:
    """What a command says; where it fails, that is shown and everything ends."""
    words = [str(part) for part in command]
    done = subprocess.run(
        words, text=True, stdout=-1, stderr=subprocess.STDOUT, check=False, env={**os.environ, **environment}
    )
    if done.returncode:
        raise SystemExit(f"{' '.join(words)[:300]} failed:\n{done.stdout}")
    return done.stdout


def system() -> None:
    """Unpack an aarch64 Python and what it needs, by an apt that has folders of its own."""
    if (FOLDER / "ready").exists():
        return
    for folder in ("lists/partial", "cache/archives/partial"):
        (FOLDER / folder).mkdir(parents=True, exist_ok=True)
    (FOLDER / "status").touch()  # nothing is installed: all that is needed gets downloaded
    apt = ["apt-get", "-o", "APT::Architecture=arm64", "-o", "APT::Architectures::=arm64", "-o", "Debug::NoLocking=1"]
    places = {"": FOLDER, "::lists": FOLDER / "lists", "::status": FOLDER / "status"}
    for name, place in places.items():
        apt += ["-o", f"Dir::State{name}={place}"]
    apt += ["-o", f"Dir::Cache={FOLDER / 'cache'}", "-q"]
    run(*apt, "update")
    run(*apt, "install", "-y", "--download-only", "--no-install-recommends", f"python{PYTHON}", "libstdc++6")
    for file in sorted((FOLDER / "cache" / "archives").glob("*.deb")):
        run("dpkg", "-x", file, SYSTEM)
    (FOLDER / "ready").touch()


def is_old(mujoco: str) -> bool:
    """Whether this MuJoCo needs NumPy below 2."""
    return tuple(int(part) for part in mujoco.split(".")) < (3, 1, 4)


def unpacked(folder: Path, *wanted: str | Path) -> None:
    """Packages for aarch64 in a folder of their own."""
    shutil.rmtree(folder, ignore_errors=True)
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "-q", "install", "--target", folder]
    pip += ["--only-binary", ":all:", "--python-version", PYTHON, "--implementation", "cp"]
    for platform in PLATFORMS:
        pip += ["--platform", f"{platform}_aarch64"]
    run(*pip, *wanted)


def walks(mujoco: str, here: Path, there: Path) -> bool:
    """Walk with both wheels; whether the COM is the same."""
    folder, versions = FOLDER / f"mujoco{mujoco}", [f"mujoco=={mujoco}", *["numpy<2"] * is_old(mujoco)]
    unpacked(folder, there, *versions)
    found = subprocess.run([ROOT / ".ci" / "find-python", PYTHON], text=True, check=True, stdout=-1).stdout.strip()
    own = made(FOLDER / f"own{mujoco}", found, versions)
    for more in (["--force-reinstall", "--no-deps"], []):
        run(own, "-m", "pip", "--disable-pip-version-check", "-q", "install", *more, here)
    coms = [FOLDER / f"{machine}-{mujoco}.npy" for machine in ("own", "arm")]
    emulated = [EMULATOR, "-L", SYSTEM, SYSTEM / "usr" / "bin" / f"python{PYTHON}"]
    environment = {"PYTHONPATH": str(folder), "MUJOCO_GL": "disable", "MPLCONFIGDIR": str(FOLDER / "matplotlib")}
    said = [run(own, "-c", WALK, coms[0], str(DURATION))]
    start = time.time()
    said.append(run(*emulated, "-c", WALK, coms[1], str(DURATION), **environment))
    took = time.time() - start
    infos = [json.loads(text.strip().splitlines()[-1]) for text in said]
    compare = "import numpy as np, sys; a, b = map(np.load, sys.argv[1:]); print(len(a), float(np.abs(a - b).max()))"
    count, distance = run(own, "-c", compare, *coms).split()
    print(f"MuJoCo {mujoco}: COM {float(distance):.1e} m from that on {infos[0]['machine']}, {count} samples")
    print(f"  {infos[1]['build']}, {took:.0f} s", flush=True)
    return float(distance) < TOLERANCE and not any(info["fell"] for info in infos)


def tests(mujoco: str) -> bool:
    """Build the C++ tests for aarch64 and run them; whether all pass."""
    folder = FOLDER / "tests"
    # One place for every MuJoCo, so that only what includes its headers is compiled again.
    core = [f"mujoco-core=={mujoco}"] * (int(mujoco.split(".")[0]) >= 4)
    unpacked(FOLDER / "chosen", "--no-deps", f"mujoco=={mujoco}", *core)
    tools = made(FOLDER / "tools", sys.executable, [*TOOLS, *requirements(), "cmeel-boost"])
    cxx = compiler(FOLDER, tools, "aarch64")
    here = {"CXX": str(cxx), "ZIG_GLOBAL_CACHE_DIR": str(FOLDER.parent / "wheels" / "zig"), "CCACHE_DISABLE": "1"}
    here["PATH"] = f"{tools.parent}:{os.environ['PATH']}"
    here["PYTHONPATH"] = str(FOLDER / "chosen")
    cmake = ["-S", ROOT, "-B", folder, "-G", "Ninja", f"-DPython_EXECUTABLE={tools}", f"-DCMAKE_CXX_COMPILER={cxx}"]
    cmake += ["-DZMPWALK_BUILD_PYTHON=OFF", "-DZMPWALK_BUILD_TESTS=ON", "-DCMAKE_SYSTEM_NAME=Linux"]
    cmake += ["-DCMAKE_SYSTEM_PROCESSOR=aarch64", f"-DCMAKE_CROSSCOMPILING_EMULATOR={EMULATOR};-L;{SYSTEM}"]
    cmake += ["-DCMAKE_EXE_LINKER_FLAGS=-Wl,--allow-shlib-undefined"]  # libmujoco wants a newer glibc than we target
    run("cmake", *cmake, **here)
    run("cmake", "--build", folder, **here)
    command = [
        "ctest",
        "--output-on-failure",
        "--no-tests=error",
        "--timeout",
        "3000",
        "-j",
        os.environ.get("JOBS", "2"),
    ]
    done = subprocess.run(
        command, cwd=folder, text=True, stdout=-1, stderr=subprocess.STDOUT, check=False, env={**os.environ, **here}
    )
    (FOLDER / f"ctest-{mujoco}.log").write_text(done.stdout)
    total = re.search(r".*tests passed.*", done.stdout)
    print(f"MuJoCo {mujoco}: {total.group() if total else done.stdout[-1000:]}", flush=True)
    return done.returncode == 0


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("wheels", type=Path, nargs="+", help=f"those of Python {PYTHON} for both machines are taken")
    parser.add_argument("--mujoco", nargs="*", default=VERSIONS)
    parser.add_argument("--only", choices=("walk", "tests"), help="one of the two")
    options = parser.parse_args()
    if shutil.which(EMULATOR) is None:
        raise SystemExit(f"there is no {EMULATOR}: install qemu-user-static")
    mine = [path.resolve() for path in options.wheels if f"cp{PYTHON.replace('.', '')}-" in path.name]
    wheels = [next(path for path in mine if path.stem.endswith(machine)) for machine in ("x86_64", "aarch64")]
    system()
    good = True
    for mujoco in options.mujoco:
        if options.only != "tests":
            good &= walks(mujoco, *wheels)
        if options.only != "walk":
            good &= tests(mujoco)
    sys.exit(not good)


if __name__ == "__main__":
    main()
