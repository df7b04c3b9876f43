"""The package's build of the control cycle against one made for this very machine (-march=native), timed in turns.

`make native` builds both programs and calls this.
"""

from __future__ import annotations

import subprocess
import sys

from instructions import MODEL

ROUNDS = 5


def main(generic: str, native: str) -> int:
    times: dict[str, dict[str, list[tuple[float, float]]]] = {"generic": {}, "native": {}}
    for _ in range(ROUNDS):
        for name, program in (("generic", generic), ("native", native)):
            out = subprocess.run([program, str(MODEL), "time"], check=True, stdout=subprocess.PIPE).stdout.decode()
            for line in out.splitlines():
                part, least, median = line.split()
                times[name].setdefault(part, []).append((float(least), float(median)))
    for part in times["generic"]:
        for i, statistic in enumerate(("min", "median")):
            ours, best = (min(pair[i] for pair in times[name][part]) for name in ("generic", "native"))
            print(f"{part:13} {statistic:7} {ours:6.2f} us, -march=native {best:6.2f} us: {ours / best:.2f} x")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
