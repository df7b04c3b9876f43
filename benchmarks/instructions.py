"""Instructions of one control cycle and of a plan, counted by callgrind and held against benchmarks/instructions.json.

Counts do not depend on how busy the machine is, but on compiler and kernel: the file names both. `make instructions`
builds the program and calls this; `--update` writes the counts anew, which is to be done on purpose only. What was
counted at earlier revisions stays in the file's `history`.
"""

from __future__ import annotations

import argparse
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).parent
RECORD = HERE / "instructions.json"
MODEL = HERE.parent / "python" / "zmpwalk" / "robots" / "mahru.xml"
KERNEL = "x86-64"  # runs on every x86-64 machine, so that all count the same
TOLERANCE = 0.05  # of the record, with its compiler
OTHER_COMPILER = 1.25  # another compiler's code may take so many times the limit
# The loop's limit is 1.15 times the 37,492 that a cycle took before it answered pushes; the plan's is a share of what
# BEFORE counted.
LIMITS = {"in_loop": 43_100, "from_scratch": 200_000, "plan": 0.5}
BEFORE = "a1d900f"  # revision in the record's history
PLAN = "plan of 3.2 s"


def count(program: str, *words: str) -> float:
    """Mean number of instructions of a counted call; `program` prints how many it made."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "callgrind.out"
        callgrind = ["valgrind", "--tool=callgrind", "--collect-atstart=no", "--toggle-collect=*counted_*"]
        done = subprocess.run(
            [*callgrind, f"--callgrind-out-file={out}", program, str(MODEL), *words, KERNEL],
            capture_output=True,
            text=True,
        )
    if done.returncode:
        raise SystemExit(f"callgrind failed:\n{done.stderr}")
    collected = re.search(r"Collected : (\d+)", done.stderr)
    return int(collected.group(1)) / int(done.stdout)


def counts_of(program: str) -> dict[str, int]:
    """Name of each count and its number of instructions."""
    counts = {
        f"{terms}, {phase} support": round(count(program, "count", phase, terms))
        for terms in ("in_loop", "from_scratch")
        for phase in ("single", "double")
    }
    return {**counts, PLAN: round(count(program, "plan"))}


def limit_of(name: str, history: dict[str, dict[str, int]]) -> float:
    """What a count may be at most."""
    limit = LIMITS[name.split(",")[0].split()[0]]
    return limit * history[BEFORE][PLAN] if name == PLAN else limit


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="the built benchmarks/cycle.cpp")
    parser.add_argument("compiler", help="name and version of the compiler that built it")
    parser.add_argument("--update", action="store_true", help="write the record anew")
    given = parser.parse_args()
    if not shutil.which("valgrind"):
        raise SystemExit("instructions: valgrind is not installed (Debian, Ubuntu: apt install valgrind)")

    counts = counts_of(given.program)
    record = json.loads(RECORD.read_text())
    if given.update:
        record.update(compiler=given.compiler, kernel=KERNEL, counts=counts)
        RECORD.write_text(json.dumps(record, indent=2) + "\n")
    comparable = record["compiler"] == given.compiler
    failed = False
    for name, number in counts.items():
        change = number / record["counts"][name] - 1
        limit = limit_of(name, record["history"]) * (1.0 if comparable else OTHER_COMPILER)
        words = []
        if number > limit:
            words.append(f"MORE THAN {limit:.0f}")
        if comparable and abs(change) > TOLERANCE:
            words.append(f"CHANGED BY MORE THAN {100 * TOLERANCE:g} %")
        failed |= bool(words)
        print(
            f"{name:30} {number:8d} instructions, recorded {record['counts'][name]:8d}, {100 * change:+.1f} %, at most "
            f"{limit:.0f}{''.join('  ' + each for each in words)}"
        )
    if not comparable:
        print(f"recorded with {record['compiler']}, built with {given.compiler}: only limits a quarter higher hold")
    if failed:
        print("where a count changed on purpose: make instructions UPDATE=--update; a limit stays a limit")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
