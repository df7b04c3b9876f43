"""The command `zmpwalk`: a file for each of walk, view, plot, video, push-map, robustness, sweep, inspect, humanoid,
settings, bench, build-adapter.

Exit codes: 0 the robot stood to the end, 3 it fell, or fell short with --strict (everything is written all the same),
2 bad input (one line on stderr, nothing written), 130 stopped by Ctrl-C (nothing written), 1 a fault of zmpwalk's own.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
import traceback
from typing import Any

import click
import mujoco

from .._build import VERSION
from ..errors import Error
from ..files import cause
from . import bench, build_adapter, humanoid, inspect, plot, push_map, robustness, settings, sweep, video, view, walk
from .terminal import FAULT, INTERRUPTED, STOOD, complain, say_no_more

__all__ = ["cli", "main"]


def main(arguments: list[str] | None = None) -> int:
    """Run the command line.

    Args:
        arguments: words after the command's name; None takes the process's own.

    Returns:
        The exit code; every error has been printed.

    Usage: `zmpwalk.cli.main(["walk", "--duration", "4"])`
    """
    ended = _end_by_signals()
    _say_what_can_be_said()
    try:
        code = _run(arguments)
        sys.stdout.flush()
    except BrokenPipeError:  # the reader of our output went away after everything was done
        say_no_more()
        code = STOOD
    except OSError as error:
        say_no_more()
        code = complain(f"standard output cannot be written: {cause(error)}")
    except KeyboardInterrupt:  # while the last words were said: all is done
        code = INTERRUPTED
    finally:
        ended.working = False
    return 128 + ended.came[0] if ended.came else code


def _run(arguments: list[str] | None) -> int:
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
    except OSError as error:
        if error.filename is None:  # of an output that is no file: see `main`
            raise
        return complain(f"{error.filename}: {cause(error)}")
    except Exception:
        traceback.print_exc()
        print("zmpwalk: this is a fault of zmpwalk, please report it with the lines above", file=sys.stderr)
        return FAULT


class _Signals:
    """The signals that came. While the command is `working` they end it; after that they change nothing any more."""

    def __init__(self) -> None:
        self.came: list[int] = []
        self.working = True

    def end(self, number: int, frame: Any) -> None:
        if self.working:
            self.came.append(number)
            raise KeyboardInterrupt


def _end_by_signals() -> _Signals:
    """SIGTERM and SIGHUP end a command as Ctrl-C does, with nothing left behind."""
    signals = _Signals()
    if threading.current_thread() is threading.main_thread():
        for name in ("SIGTERM", "SIGHUP"):
            number = getattr(signal, name, None)
            if number is not None and signal.getsignal(number) is signal.SIG_DFL:
                signal.signal(number, signals.end)
    return signals


def _say_what_can_be_said() -> None:
    """A closed output swallows what is said; one that lacks a letter, such as a dash or a mu, gets a ? in its place."""
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: SIM115
        elif hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="replace")


def _print_version(context: click.Context, parameter: click.Parameter, asked: bool) -> None:
    if asked and not context.resilient_parsing:
        click.echo(f"zmpwalk {VERSION}, MuJoCo {mujoco.__version__}")
        context.exit()


FIRST_STEPS = """
\b
First steps:
  zmpwalk walk --duration 8 --out out/first   walks the robot and draws it
  zmpwalk view                                opens a window: keys walk it
  zmpwalk inspect my_robot.xml                says whether yours can walk
  zmpwalk walk --help                         explains all of a command
"""


@click.group(context_settings={"help_option_names": ["-h", "--help"]}, epilog=FIRST_STEPS)
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


for room in (walk, view, plot, video, push_map, robustness, sweep, inspect, humanoid, settings, bench, build_adapter):
    cli.add_command(room.command)
