"""Checks, before the extension is loaded, that it can run with the installed MuJoCo and NumPy.

The extension is linked to one version of libmujoco. With another one the dynamic linker would speak first, and less
clearly; so the versions are compared before, from the packages' metadata and as strings, since MuJoCo's version
integer has changed its scheme.
"""

from importlib import metadata

from .errors import VersionError

__all__ = ["check_versions", "load_mujoco"]

REBUILD = "pip install --no-build-isolation --no-deps --force-reinstall ."


def check_versions(compiled: str, mujoco: "str | None", numpy: "str | None") -> None:
    """Refuse versions that do not work together.

    Args:
        compiled: MuJoCo version that the extension was compiled against, such as ``"2.2.2"``.
        mujoco: installed MuJoCo version, ``None`` if there is none.
        numpy: installed NumPy version, ``None`` if there is none.

    Raises:
        VersionError: the two MuJoCo versions differ, or NumPy 2 meets MuJoCo 2.2.

    Example:
        >>> check_versions(compiled="2.2.2", mujoco="2.2.2", numpy="1.26.4")
    """
    if mujoco is None:
        raise VersionError(
            f"zmpwalk needs MuJoCo {compiled}, and no mujoco is installed: pip install mujoco=={compiled}"
        )
    if mujoco != compiled:
        raise VersionError(
            f"zmpwalk was built for MuJoCo {compiled}, but MuJoCo {mujoco} is installed: "
            f"pip install mujoco=={compiled}, or rebuild in zmpwalk's source folder with: {REBUILD}"
        )
    if mujoco.startswith("2.2.") and numpy is not None and int(numpy.split(".")[0]) >= 2:
        raise VersionError(
            f"MuJoCo {mujoco} returns wrong contact positions under NumPy {numpy} (its views lose their strides): "
            'pip install "numpy<2"'
        )


def load_mujoco() -> None:
    """Check the versions of this environment, then import mujoco.

    The import puts the library of the mujoco package into the process, so that the extension finds that one by name,
    wherever the two packages are installed.

    Raises:
        VersionError: zmpwalk has not been built, or :func:`check_versions` refuses.
    """
    try:
        from ._build import MUJOCO_VERSION
    except ImportError:
        raise VersionError(
            "zmpwalk has not been built: run `pip install .` in its source folder, and do not put python/ on the path"
        ) from None
    check_versions(MUJOCO_VERSION, _installed("mujoco"), _installed("numpy"))
    import mujoco

    if mujoco.__version__ != MUJOCO_VERSION:  # metadata and library disagree: a damaged or a shadowed mujoco
        check_versions(MUJOCO_VERSION, mujoco.__version__, None)


def _installed(package: str) -> "str | None":
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return None
