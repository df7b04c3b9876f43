"""Say where this Python keeps the headers and libraries that come as wheels, as `name=value` lines for CMake.

Nothing is imported: a package is only located, so this works in the isolated environment of a build as well.
"""

import importlib.util
import re
import sys
import sysconfig
from pathlib import Path


def include_folder(folder: str, probe: str) -> str:
    """The include folder of a package, known by one of its headers; empty if it is not installed.

    It is that of a cmeel wheel or, as conda has it, that of Python's own prefix.
    """
    for prefix in (*(Path(entry or ".", "cmeel.prefix") for entry in sys.path), Path(sys.prefix)):
        include = prefix / "include" / folder
        if (include / probe).exists():
            return include.resolve().as_posix()
    return ""


def mujoco_library() -> "tuple[str, str, str]":
    """Folder of the mujoco package, file name of its versioned library, and that version.

    The package of the environment that is built for comes first: an isolated build hides it from import.
    """
    spec = importlib.util.find_spec("mujoco")
    folders = [sysconfig.get_path("platlib") + "/mujoco", *((spec.submodule_search_locations or []) if spec else [])]
    for folder in folders:
        for library in sorted(Path(folder).glob("libmujoco.*")):
            version = re.search(r"\d+(\.\d+)+", library.name)
            if version:
                return Path(folder).resolve().as_posix(), library.name, version.group()
    return "", "", ""


if __name__ == "__main__":
    folder, library, version = mujoco_library()
    print(f"MUJOCO_DIR={folder}")
    print(f"MUJOCO_LIBRARY={library}")
    print(f"MUJOCO_VERSION={version}")
    print(f"EIGEN_INCLUDE_DIR={include_folder('eigen3', 'Eigen/Core')}")
    print(f"EIQUADPROG_INCLUDE_DIR={include_folder('', 'eiquadprog/eiquadprog-rt.hpp')}")
    print(f"BOOST_INCLUDE_DIR={include_folder('', 'boost/test/unit_test.hpp')}")
