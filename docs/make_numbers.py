"""Measures the numbers of the README and writes them there: `python docs/make_numbers.py`; `--check` says what drifted.

Two blocks of the README are made here: what `make demo` prints at its end, and the table of accuracy.
"""

import argparse
import contextlib
import io
import sys
import tempfile
from pathlib import Path

from zmpwalk import cli

ROOT = Path(__file__).parents[1]
sys.path.append(str(ROOT / "benchmarks"))
import accuracy  # noqa: E402
from pages import write_blocks  # noqa: E402

SHOWN = ("walk ", "ZMP error, median", "ZMP error, 95th")  # lines of the summary that do not depend on the machine


def demo() -> list:
    """The end of what a walk of the paper's profile prints, as a block of code."""
    with tempfile.TemporaryDirectory() as scratch, contextlib.redirect_stdout(io.StringIO()) as said:
        assert cli.main(["walk", "--profile", "paper", "--duration", "8", "--no-figures", "--out", scratch]) == 0
    lines = [line.rstrip() for line in said.getvalue().splitlines()]
    table = lines[: lines.index("")]
    return ["```", *table[-3:], "", *(line for line in lines if line.startswith(SHOWN)), "```"]


def table() -> list:
    """How exact the walk and the estimate are, over 120 s."""
    _, *case = next(accuracy.cases())
    row = accuracy.row(*case)

    def pair(key: str, digits: int) -> str:
        return " / ".join(f"{value:.{digits}f}" for value in row[key]) + " mm"

    return [
        "",
        f"| over {row['duration']:g} s, {row['steps']} steps of the paper's profile | |",
        "|---|---|",
        f"| way of the COM against the plan, in the worst 0.8 s | {row['speed_error_percent']:.2f} % |",
        f"| error of the estimated ZMP, median of all cycles, x / y | {pair('median_mm', 4)} |",
        f"| error of the estimated ZMP, 95th percentile of single support | {pair('single_support_p95_mm', 3)} |",
        f"| error of the estimated ZMP, 95th percentile of all cycles | {pair('p95_mm', 2)} |",
        "",
    ]


def blocks() -> dict:
    """Name of each block of the README -> its lines."""
    return {"demo": demo(), "accuracy": table()}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="write nothing; the exit code is 1 where a number drifted")
    check, readme = parser.parse_args().check, ROOT / "README.md"
    before = readme.read_text(encoding="utf-8")
    found = blocks()
    if not check:
        write_blocks(readme, found)
        return 0
    drifted = [name for name, lines in found.items() if "\n".join(lines) not in before]
    print(*(f"README.md, <!-- {name} -->: it is now\n" + "\n".join(found[name]) for name in drifted), sep="\n")
    return int(bool(drifted))


if __name__ == "__main__":
    sys.exit(main())
