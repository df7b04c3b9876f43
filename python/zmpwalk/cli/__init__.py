"""The command `zmpwalk`: a file for each of walk, view, plot, video, push-map, robustness, sweep, inspect,
settings, bench, build-adapter.

Exit codes: 0 the robot stood to the end, 3 it fell (everything is written all the same), 2 bad input (one line on
stderr, nothing written), 130 stopped by Ctrl-C (nothing written), 1 a fault of zmpwalk's own.
"""

from __future__ import annotations

import os
import sys
import traceback

import click
import mujoco

from .._build import VERSION
from ..errors import Error
from . import bench, build_adapter, inspect, plot, push_map, robustness, settings, sweep, video, view, walk
from .terminal import FAULT, INTERRUPTED, STOOD, complain

__all__ = ["cli", "main"]


def main(arguments: list[str] | None = None) -> int:
    """Run the command line.

    Args:
        arguments: words after the command's name; None takes the process's own.

    Returns:
        The exit code; every error has been printed.

    Usage: `zmpwalk.cli.main(["walk", "--duration", "4"])`
    """
    try:
        words = sys.argv[1:] if arguments is None else list(arguments)
        return int(cli.main(args=words or ["--help"], prog_name="zmpwalk", standalone_mode=False) or 0)
    except click.exceptions.Exit as done:
        return done.exit_code
    except (click.Abort, KeyboardInterrupt):
        print("zmpwalk: stopped; nothing was written", file=sys.stderr)
        return INTERRUPTED
    except click.ClickException as error:
        return complain(error.format_message())
    except Error as error:
        return complain(str(error))
    except BrokenPipeError:  # the reader of our output went away
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return STOOD
    except Exception:
        traceback.print_exc()
        print("zmpwalk: this is a fault of zmpwalk, please report it with the lines above", file=sys.stderr)
        return FAULT


def _print_version(context: click.Context, parameter: click.Parameter, asked: bool) -> None:
    if asked and not context.resilient_parsing:
        click.echo(f"zmpwalk {VERSION}, MuJoCo {mujoco.__version__}")
        context.exit()


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
@click.option(
    "--version",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_print_version,
    help="Show versions and exit.",
)
def cli() -> None:
    """Walk humanoid robots in MuJoCo: give a velocity, get the torques, and know their ZMP beforehand."""


for room in (walk, view, plot, video, push_map, robustness, sweep, inspect, settings, bench, build_adapter):
    cli.add_command(room.command)
