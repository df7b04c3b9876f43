"""Kills commands at random moments and looks at what is there: `python benchmarks/kills.py`, or `make kills`.

walk, plot, video, inspect and sweep write over what an earlier run has written, and get SIGKILL, SIGTERM or SIGHUP at a
random moment. Afterwards

- nothing is torn: whatever file is there is whole, and a walk's summary is that of its trace;
- nothing is lost: what was there before is still there, in its old or its new form;
- after SIGTERM and SIGHUP nothing is left behind at once; after SIGKILL, once the command has run again.

The script prints the seed and a table, and ends with exit code 1 where anything of this does not hold.
"""

from __future__ import annotations

import argparse
import importlib.util
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any, Callable

import numpy as np
import zmpwalk

SIGNALS = ("SIGKILL", "SIGTERM", "SIGHUP")
LONGEST = 120.0  # that a command may run [s]
ENDS_WITHIN = 10.0  # after a signal [s]

WALK = ["walk", "--profile", "0.2", "--format", "png", "--out", "OUT"]
COMMANDS: dict[str, list[str]] = {
    "walk": [*WALK, "--duration", "3"],
    "plot": ["plot", "TRACE", "--out", "OUT"],
    "video": ["video", "TRACE", "--size", "64x48", "--fps", "10", "--out", "OUT/walk.mp4"],
    "inspect": ["inspect", "mahru", "--write", "OUT/robot.json", "--figure", "OUT/robot.png"],
    "sweep": ["sweep", "GRID", "--processes", "1", "--out", "OUT"],
}


def is_whole(file: Path) -> bool:
    """Whether a reader of its kind takes the file."""
    raw = file.read_bytes()
    try:
        if file.suffix == ".npz":
            return bool(len(zmpwalk.Trace.load(file).t))
        if file.suffix == ".walks":  # a journal: it may be empty, and only its last line may be cut
            return all(json.loads(line) for line in raw.splitlines()[:-1])
        if file.suffix == ".json":
            return bool(json.loads(raw))
        if file.suffix == ".png":
            return raw.startswith(b"\x89PNG") and raw.rstrip().endswith(b"IEND\xaeB`\x82")
        if file.suffix == ".mp4":
            return b"moov" in raw and raw[4:8] == b"ftyp"
        if file.suffix == ".csv":
            return raw.endswith(b"\n") and len({line.count(b",") for line in raw.splitlines()}) >= 1
        if file.suffix == ".parquet":
            return raw.startswith(b"PAR1") and raw.endswith(b"PAR1")
    except (zmpwalk.Error, ValueError):
        return False
    return len(raw) > 0


def agree(folder: Path) -> bool:
    """Whether the summary in a folder is that of the trace beside it."""
    if not (folder / "trace.npz").exists():
        return True
    summary = json.loads((folder / "summary.json").read_text())
    return bool(summary["duration"] == zmpwalk.Trace.load(folder / "trace.npz").duration)


class Victim:
    """A command in a folder of its own, in which it has run before."""

    def __init__(self, name: str, folder: Path, trace: Path):
        self.name, self.out = name, folder / "out"
        grid = folder / "grid.toml"
        folder.mkdir()
        self.out.mkdir()
        grid.write_text("duration = 0.5\n[grid]\nprofile = [0.1, 0.2, 0.3]\n")
        places = {"OUT": str(self.out), "TRACE": str(trace), "GRID": str(grid)}
        words = COMMANDS[name]
        for short, place in places.items():
            words = [place if word == short else word.replace(f"{short}/", f"{place}/") for word in words]
        self.words = words
        before = [word if word != "3" else "2" for word in words] if name == "walk" else words
        began = time.monotonic()
        self._run(before)
        self.takes = time.monotonic() - began
        self.before = self.files()

    def files(self) -> set[str]:
        return {file.name for file in self.out.iterdir()}

    def again(self) -> None:
        """Runs to the end."""
        if self.name == "sweep":  # all is there already: what it keeps of its walks goes
            self.forget()
        self._run(self.words)

    def forget(self) -> None:
        for kept in self.out.glob("sweep.*.walks"):
            if kept.is_dir():
                shutil.rmtree(kept)
            else:
                kept.unlink()

    def _run(self, words: list[str]) -> None:
        done = subprocess.run(
            [sys.executable, "-m", "zmpwalk", *words], capture_output=True, text=True, timeout=LONGEST, check=False
        )
        if done.returncode != 0:
            raise SystemExit(f"{self.name} does not run: {done.stderr}")

    def kill(self, how: int, after: float) -> tuple[bool, int, str]:
        """Whether the command was still running, its exit code and what it said."""
        if self.name == "sweep":
            self.forget()
        process = subprocess.Popen(
            [sys.executable, "-m", "zmpwalk", *self.words],
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
        )  # fmt: skip
        time.sleep(after)
        hit = process.poll() is None
        if hit:
            process.send_signal(how)
        try:
            said = process.communicate(timeout=ENDS_WITHIN)[1]
        except subprocess.TimeoutExpired:
            process.kill()
            return hit, -1, "hangs"
        return hit, process.returncode, said

    def troubles(self, how: str, had: set[str]) -> list[str]:
        """What is not as it should be, right after the kill."""
        there, said = self.files(), []
        torn = [name for name in sorted(there) if not name.startswith(".") and (self.out / name).is_file()
                and not is_whole(self.out / name)]  # fmt: skip
        said += [f"torn: {name}" for name in torn]
        lost = {name for name in self.before - there if not name.endswith(".walks")}  # those went before
        said += [f"lost: {name}" for name in sorted(lost)]
        if not torn and not agree(self.out):
            said.append("torn: summary and trace of different walks")
        if how != "SIGKILL":
            said += [f"left: {name}" for name in sorted(there - self.before - had)]
        return said


def attack(victim: Victim, count: int, chance: random.Random, tell: Callable[[str], None]) -> dict[str, Any]:
    row: dict[str, Any] = {"hits": 0, "troubles": []}
    for i in range(count):
        how = SIGNALS[i % len(SIGNALS)]
        there = victim.files()  # with what a run that was killed before has left
        hit, code, said = victim.kill(getattr(signal, how), chance.uniform(0.02, 1.1 * victim.takes))
        row["hits"] += hit
        troubles = victim.troubles(how, there)
        number = int(getattr(signal, how))
        if hit and code not in (-number, 128 + number, 0):
            troubles.append(f"exit code {code}: {said.strip()[-200:]}")
        if (
            "Traceback" in said and code != -number
        ):  # killed before it began: a child of glfw's may say that nobody listens
            troubles.append("traceback: " + " | ".join(said.strip().splitlines()[-4:])[-400:])
        troubles = [f"{victim.name} {i + 1}, {how}, code {code}: {each}" for each in troubles]
        row["troubles"] += troubles
        for each in troubles:
            tell(each)
        if how == "SIGKILL" and i % (3 * len(SIGNALS)) == 0:
            victim.again()
            left = sorted(victim.files() - victim.before)
            row["troubles"] += [f"{victim.name} {i + 1}: left after the next run: {name}" for name in left]
    victim.again()
    row["troubles"] += [f"{victim.name}: left at the end: {name}" for name in sorted(victim.files() - victim.before)]
    return row


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=45, help="kills of each command")
    parser.add_argument("--only", help="commands, with commas")
    parser.add_argument("--seed", type=int, default=int(np.random.SeedSequence().entropy % 100_000))
    args = parser.parse_args()
    chance = random.Random(args.seed)
    names = args.only.split(",") if args.only else list(COMMANDS)
    if importlib.util.find_spec("imageio") is None:
        names = [name for name in names if name != "video"]
    print(f"seed {args.seed}, MuJoCo {zmpwalk.trace.mujoco.__version__}")
    os.environ.setdefault("MPLBACKEND", "Agg")
    troubles: list[str] = []
    with tempfile.TemporaryDirectory(prefix="kills-") as place:
        trace = zmpwalk.simulate(profile=0.2, duration=1.0).save(Path(place) / "trace.npz")
        print(
            f"{'command':10s} {'kills':>6s} {'while it ran':>13s} {'torn':>5s} {'lost':>5s} {'left':>5s} {'other':>6s}"
        )
        for name in names:
            try:
                victim = Victim(name, Path(place) / name, trace)
            except SystemExit as error:
                print(f"{name:10s} {error}")
                continue
            row = attack(victim, args.count, chance, lambda line: print(line, file=sys.stderr, flush=True))
            counts = [sum(f": {kind}" in each for each in row["troubles"]) for kind in ("torn", "lost", "left")]
            other = len(row["troubles"]) - sum(counts)
            print(f"{name:10s} {args.count:6d} {row['hits']:13d} {counts[0]:5d} {counts[1]:5d} {counts[2]:5d} "
                  f"{other:6d}", flush=True)  # fmt: skip
            troubles += row["troubles"]
    for each in troubles:
        print(each)
    return 1 if troubles else 0


if __name__ == "__main__":
    sys.exit(main())
