"""Draws the pictures of the README and the mixed walk of `walk_anywhere.md`: `python docs/make_images.py`."""

import sys
from pathlib import Path

import numpy as np
import zmpwalk
from matplotlib.image import imsave
from zmpwalk import plot, render

sys.path.append(str(Path(__file__).parents[1] / "benchmarks"))
import walk_anywhere

IMAGES = Path(__file__).parent / "images"
TIMES = (0.4, 2.0, 4.9, 5.3)  # standing, first steps, walking


def main() -> None:
    trace = zmpwalk.simulate("mahru", duration=8.0)
    frames = [render.snapshot(trace, t=t, width=400, height=480) for t in TIMES]
    imsave(IMAGES / "walk.png", np.concatenate(frames, axis=1))
    plot.sagittal(trace).savefig(IMAGES / "sagittal.png", dpi=100)
    plot.footprints(zmpwalk.simulate(**walk_anywhere.mixed())).savefig(IMAGES / "mixed.png", dpi=100)


if __name__ == "__main__":
    main()
