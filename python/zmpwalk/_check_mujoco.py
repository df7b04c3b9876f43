"""Connects the core with the MuJoCo that is installed, or says in one line why that cannot be.

Versions are compared as strings and from the packages' metadata, because MuJoCo's version integer has changed its
scheme. Then the layout is checked: what the core sees of a small model has to lie where the mujoco package shows it.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any

from . import _adapters
from .errors import Error, InputError, VersionError

__all__ = ["check_layout", "check_versions", "installed_mujoco", "load_mujoco"]

# Before this version MuJoCo's bindings return contact.pos and contact.frame with stride 0 under NumPy 2.
FIRST_FOR_NUMPY_2 = (3, 1, 4)
OLDEST = (2, 2, 0)

# A ball on a plane and a driven hinge: something of every array that the core looks at.
SMALL = """
<mujoco><option timestep="0.004" gravity="0 0.1 -9"/>
<worldbody><geom name="f" type="plane" size="1 1 .1"/>
<body pos="0 0 .09"><freejoint/><geom name="b" type="sphere" size=".1"/><site name="s" pos="0 0 .1"/></body>
<body pos="2 0 1"><joint name="j" range="-1 1" limited="true" damping="2"/><geom size=".1"/></body></worldbody>
<contact><pair geom1="f" geom2="b"/></contact><tendon><fixed name="t"><joint joint="j" coef="1"/></fixed></tendon>
<equality><joint joint1="j"/></equality>
<actuator><motor joint="j" gear="3"/><general joint="j" dyntype="filter" dynprm="1"/></actuator>
<keyframe><key name="k" qpos="0 0 .09 1 0 0 0 .5"/></keyframe></mujoco>
"""


def check_versions(mujoco: str | None, numpy: str | None) -> None:
    """Refuse versions that zmpwalk does not work with.

    Args:
        mujoco: installed MuJoCo version, ``None`` if there is none.
        numpy: installed NumPy version, ``None`` if there is none.

    Raises:
        VersionError: there is no MuJoCo, it is older than 2.2, or NumPy 2 meets a MuJoCo before 3.1.4.

    Example:
        >>> check_versions(mujoco="2.2.2", numpy="1.26.4")
    """
    if mujoco is None:
        raise VersionError("zmpwalk needs MuJoCo 2.2 or later, and no mujoco is installed: pip install mujoco")
    if _numbers(mujoco) < OLDEST:
        raise VersionError(f"zmpwalk needs MuJoCo 2.2 or later, but {mujoco} is installed: pip install -U mujoco")
    if numpy is not None and int(numpy.split(".")[0]) >= 2 and _numbers(mujoco) < FIRST_FOR_NUMPY_2:
        raise VersionError(
            f"MuJoCo {mujoco} returns wrong contact positions under NumPy {numpy} (its views lose their strides): "
            'pip install "numpy<2", or "mujoco>=3.1.4"'
        )


def load_mujoco() -> None:
    """Check the versions of this environment, import mujoco, and connect the core with it.

    Raises:
        VersionError: zmpwalk has not been built, :func:`check_versions` refuses, or there is no adapter that fits.
    """
    try:
        from . import _build  # noqa: F401
    except ImportError:
        raise VersionError(
            "zmpwalk has not been built: run `pip install .` in its source folder, and do not put python/ on the path"
        ) from None
    installed = installed_mujoco()
    check_versions(installed, _installed("numpy"))
    try:
        import mujoco
    except Exception as error:  # of many kinds: MuJoCo imports the library that draws, whichever that is
        told = os.environ.get("MUJOCO_GL")
        raise VersionError(
            f"MuJoCo {installed} cannot be imported ({type(error).__name__}: {error})"
            + (f": MUJOCO_GL={told} names what draws; unset it, or install that library" if told else "")
        ) from None

    version = mujoco.__version__
    if _numbers(version) != _numbers(installed or version):
        raise VersionError(
            f"MuJoCo {version} is loaded, but MuJoCo {installed} is installed: start Python again, "
            "and if that does not help, pip install --force-reinstall mujoco"
        )
    adapter, library = _adapters.adapter_file(version), _adapters.libmujoco_file()
    if adapter is None or library is None:
        known = ", ".join(_adapters.adapter_versions())
        raise VersionError(
            f"zmpwalk has no adapter to MuJoCo {version} here: run `{_adapters.COMMAND}`, "
            f"which needs a C++17 compiler, or install a MuJoCo that has one ({known})"
        )
    from . import _core

    try:
        _core.connect(str(adapter), str(library), version)
        check_layout()
    except (Error, RuntimeError) as error:
        raise VersionError(
            f"the adapter {adapter} does not fit MuJoCo {version} ({error}): run `{_adapters.COMMAND}`"
        ) from None


def check_layout() -> None:
    """Compare what the core sees of a small model with what the mujoco package shows.

    Raises:
        InputError: something lies in another place, with its name.
    """
    import mujoco

    from . import _core

    model = mujoco.MjModel.from_xml_string(SMALL)
    data = mujoco.MjData(model)
    data.time = 0.25
    mujoco.mj_forward(model, data)
    seen = _core.seen(model, data)

    def require(name: str, ours: Any, theirs: Any) -> None:
        if ours != theirs:
            raise InputError(f"{name} lies in another place")

    for name, value in seen["numbers"].items():
        require(name, value, getattr(model.opt if "." in name else model, name.split(".")[-1]))
    for part, of in (("model", model), ("data", data)):
        for name, address in seen[part].items():
            array = getattr(of.opt if "." in name else of, name.split(".")[-1])
            if array.size:
                require(name, address, array.__array_interface__["data"][0])
    require("time", seen["time"], 0.25)
    contacts = [(*_geoms(c), tuple(c.pos)) for c in (data.contact[i] for i in range(data.ncon))]
    require("contact", [(one, two, tuple(pos)) for one, two, pos in seen["contacts"]], contacts)


def installed_mujoco() -> str | None:
    """Version of the installed mujoco package by its metadata; None where there is none.

    Usage: `installed_mujoco()  # -> "2.3.1.post1"`
    """
    return _installed("mujoco")


def _geoms(contact: Any) -> tuple[int, int]:
    return tuple(contact.geom) if hasattr(contact, "geom") else (contact.geom1, contact.geom2)


def _installed(package: str) -> str | None:
    """The version in the name of the folder that pip left beside the package, such as `mujoco-2.2.2.dist-info`.

    Only where there is no such folder is importlib.metadata asked, which takes longer to import than our core.
    """
    for folder in map(Path, sys.path):
        for info in folder.glob(f"{package}-*-info"):
            return info.stem.split("-")[1]
    from importlib import metadata

    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return None


def _numbers(version: str) -> tuple[int, ...]:
    """The three leading numbers of a version: (2, 3, 1) of "2.3.1.post1"."""
    return tuple(int(part) for part in version.split(".")[:3] if part.isdigit())
