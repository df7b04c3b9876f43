"""`zmpwalk build-adapter`: the adapter to the installed MuJoCo, compiled here."""

from __future__ import annotations

import click
import mujoco

from .. import _adapters
from .terminal import STOOD

__all__ = ["command"]


@click.command("build-adapter", short_help="Compile the adapter to the MuJoCo that is installed.")
def command() -> int:
    """Compile zmpwalk's adapter to the MuJoCo that is installed; it takes a second and needs a C++17 compiler.

    zmpwalk brings adapters to many MuJoCo versions. Where it says that it has none to yours, this makes one.
    """
    version = mujoco.__version__
    click.echo(f"{_adapters.build_adapter(version)} is the adapter to MuJoCo {version}")
    return STOOD
