"""Adapters to MuJoCo: which one a version needs, where it lies, and how one is built.

The core includes none of MuJoCo's headers, since MuJoCo promises no binary interface from one version to the next. An
adapter does: a small library that is compiled against the headers of one version. Versions in which all that it touches
lies in the same places share one; `adapters/layouts.json` names them. It is written by `cpp/adapter/layouts.py`.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
from importlib import util
from pathlib import Path

from .errors import InputError
from .files import whole

__all__ = ["adapter_file", "adapter_versions", "build_adapter", "libmujoco_file", "main"]

PACKAGE = Path(__file__).resolve().parent
OWN = PACKAGE / "adapters"  # those that come with zmpwalk
COMMAND = "zmpwalk build-adapter"
INTERFACE = 1  # ZMPWALK_ADAPTER_INTERFACE of mujoco_adapter.h: an adapter of another zmpwalk may not fit


def adapter_file(version: str) -> Path | None:
    """The adapter for a version of MuJoCo, or None where there is none.

    Args:
        version: of libmujoco, such as "3.3.7".

    Usage: `adapter_file("3.3.7")`
    """
    names = [version, *(other for other in _like(version) if other != version)]
    for folder in _folders():
        for name in names:
            file = folder / f"adapter-{name}.so"
            if file.is_file():
                return file
    return None


def adapter_versions() -> list[str]:
    """Versions of MuJoCo that have an adapter here, in order.

    Usage: `adapter_versions()  # -> ["2.2.2", "4.0.0"]`
    """
    built = {file.stem[len("adapter-") :] for folder in _folders() for file in folder.glob("adapter-*.so")}
    return sorted({like for name in built for like in (name, *_like(name))}, key=_order)


def libmujoco_file() -> Path | None:
    """MuJoCo's library, in the mujoco package or, as conda has it, beside Python's own; None where there is none.

    The package is located but not imported.

    Usage: `libmujoco_file().name  # -> "libmujoco.so.3.3.7"`
    """
    spec = util.find_spec("mujoco")
    if spec is None:
        return None
    folders = [*map(Path, spec.submodule_search_locations or ()), Path(sys.prefix, "lib")]
    return next((file for folder in folders for file in sorted(folder.glob("libmujoco.*"))), None)


def build_adapter(version: str, compiler: str | None = None) -> Path:
    """Compile the adapter for the installed MuJoCo.

    Args:
        version: of the installed MuJoCo; the file is called after it.
        compiler: a C++17 compiler; None takes $CXX, else the first of c++, g++, clang++.

    Returns:
        The adapter: beside zmpwalk's own where that folder can be written, else in the user's cache.

    Raises:
        InputError: there is no compiler, MuJoCo comes without its headers, or it does not compile.

    Usage: `build_adapter("9.9.9")`
    """
    library = libmujoco_file()
    places = [library.parent / "include", Path(sys.prefix, "include")] if library else []
    headers = next((place for place in places if (place / "mujoco" / "mujoco.h").is_file()), None)
    if headers is None:
        raise InputError("the mujoco package is not installed, or it comes without its headers: pip install mujoco")
    source, include = _sources()
    compilers = [compiler] if compiler else [os.environ.get("CXX"), "c++", "g++", "clang++"]
    found = next((name for name in compilers if name and shutil.which(name)), None)
    if found is None:
        raise InputError(
            f"no C++17 compiler was found as {', '.join(name for name in compilers if name)}: install one, such as g++"
        )
    with tempfile.TemporaryDirectory() as scratch:
        made = Path(scratch, "adapter.so")
        command = [found, "-std=c++17", "-O2", "-fPIC", "-shared", "-fvisibility=hidden", "-w"]
        command += ["-I", str(include), "-I", str(headers), str(source), "-o", str(made)]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode != 0:
            why = next((line for line in done.stdout.splitlines() if "error" in line), done.stdout.strip()[:300])
            raise InputError(f"the adapter does not compile against MuJoCo {version}: {why}")
        for folder in (OWN, _cache()):
            try:
                folder.mkdir(parents=True, exist_ok=True)
                with whole(folder / f"adapter-{version}.so") as draft:
                    shutil.copy2(made, draft)
                return folder / f"adapter-{version}.so"
            except OSError as error:
                refused = error
    raise InputError(f"the adapter cannot be written: {refused}")


def main(version: str | None) -> int:
    """`zmpwalk build-adapter`, which works where the rest of zmpwalk cannot be imported for want of an adapter.

    Args:
        version: of the installed MuJoCo.

    Returns:
        The exit code.
    """
    try:
        if version is None:
            raise InputError("no mujoco is installed: pip install mujoco")
        print(f"{build_adapter(version)} is the adapter to MuJoCo {version}")
    except InputError as error:
        print(f"zmpwalk: {error}", file=sys.stderr)
        return 2
    check = [sys.executable, "-c", "import zmpwalk"]
    return 2 if subprocess.run(check, check=False, stdout=subprocess.DEVNULL).returncode else 0


def _folders() -> list[Path]:
    """Where adapters lie: in the package, where the core's own file is (in editable installs), in the user's cache."""
    core = util.find_spec(f"{__package__}._core")
    beside = [Path(core.origin).resolve().parent] if core and core.origin else []
    return [OWN, *beside, *(folder / "adapters" for folder in beside), _cache()]


def _cache() -> Path:
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache", "zmpwalk", f"adapters-{INTERFACE}")


def _like(version: str) -> list[str]:
    """Every known version whose layout is that of this one."""
    file = PACKAGE / "adapters" / "layouts.json"
    layouts = json.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}
    return [other for other, layout in layouts.items() if layout == layouts.get(version, version)]


def _order(version: str) -> tuple[int, ...]:
    return tuple(int(part) for part in version.split(".") if part.isdigit())


def _sources() -> tuple[Path, Path]:
    """The adapter's source and the folder of the header that it includes, in the package or in the source tree."""
    own, tree = PACKAGE / "adapters", PACKAGE.parents[1] / "cpp"
    for source, include in ((own / "adapter.cpp", own), (tree / "adapter" / "adapter.cpp", tree / "include")):
        if source.is_file():
            return source, include
    raise InputError("this copy of zmpwalk has no source of the adapter (adapter.cpp)")
