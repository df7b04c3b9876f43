"""Instructions of one control cycle, counted by callgrind and held against benchmarks/instructions.json.

Counts do not depend on how busy the machine is, but on compiler and kernel: the file names both. `make instructions`
builds the program and calls this; `--update` writes the counts anew, which is to be done on purpose only.
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
TOLERANCE = 0.05
LIMIT = 200_000  # of a cycle in double support


def instructions(program: str, phase: str, terms: str, kernel: str) -> float:
    """Mean number of instructions of one cycle."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "callgrind.out"
        words = ["valgrind", "--tool=callgrind", "--collect-atstart=no", "--toggle-collect=*counted_update*"]
        done = subprocess.run(
            [*words, f"--callgrind-out-file={out}", program, str(MODEL), "count", phase, terms, kernel],
            capture_output=True,
            text=True,
        )
    if done.returncode:
        raise SystemExit(f"callgrind failed:\n{done.stderr}")
    collected = re.search(r"Collected : (\d+)", done.stderr)
    return int(collected.group(1)) / int(done.stdout)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="the built benchmarks/cycle.cpp")
    parser.add_argument("compiler", help="name and version of the compiler that built it")
    parser.add_argument("--update", action="store_true", help="write the record anew")
    given = parser.parse_args()
    if not shutil.which("valgrind"):
        raise SystemExit("instructions: valgrind is not installed (Debian, Ubuntu: apt install valgrind)")

    counts = {
        f"{terms}, {phase} support": round(instructions(given.program, phase, terms, KERNEL))
        for terms in ("in_loop", "from_scratch")
        for phase in ("single", "double")
    }
    if given.update:
        RECORD.write_text(json.dumps({"compiler": given.compiler, "kernel": KERNEL, "counts": counts}, indent=2) + "\n")
    record = json.loads(RECORD.read_text())
    comparable = record["compiler"] == given.compiler
    failed = False
    for name, count in counts.items():
        kept = record["counts"][name]
        change = count / kept - 1
        bad = count > LIMIT or (comparable and abs(change) > TOLERANCE)
        failed |= bad
        print(
            f"{name:30} {count:8d} instructions, recorded {kept:8d}, {100 * change:+.1f} %{'  FAILED' if bad else ''}"
        )
    if not comparable:
        print(f"recorded with {record['compiler']}, built with {given.compiler}: only the limit of {LIMIT} is held")
    if failed:
        print(f"a cycle may change by {100 * TOLERANCE:g} %; on purpose: make instructions UPDATE=--update")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
