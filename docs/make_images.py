"""Draws the pictures of README, how-tos, ground and the mixed walk: `python docs/make_images.py`.

`--only NAME` draws one: estimate, walk, sagittal, mixed, ground, stairs, howto, moving (the picture that moves) or
viewer. The last one needs a display (`xvfb-run`) and is drawn only when it is asked for.
"""

import argparse
import itertools
import os
import re
import shutil
import sys
import tempfile
from pathlib import Path
from typing import Any

import matplotlib
import matplotlib.image
import numpy as np
import zmpwalk
from matplotlib.figure import Figure
from PIL import Image, ImageDraw, ImageFont
from zmpwalk import analysis, plot, render, view

sys.path.append(str(Path(__file__).parents[1] / "benchmarks"))
import walk_anywhere

IMAGES = Path(__file__).parent / "images"
MOVING, FPS = (480, 360), 20  # of the picture that moves [pixels, 1/s]
DRAWN = ("estimate", "walk", "sagittal", "mixed", "ground", "stairs")
TIMES = {0.4: "stands on the left foot", 2.0: "first steps", 4.9: "both feet down", 5.3: "swings a leg"}
# What the script of the mixed walk does from one instant to the next [s].
LEGS = {
    (0.0, 15.5): "0 to 15 s: forward, then in a curve to the left",
    (15.5, 29.0): "15 to 29 s: to the left, then turning on the spot",
    (29.0, 40.7): "29 to 41 s: backward, then turning on the spot",
    (40.7, 60.0): "41 to 60 s: to the right, then all at once",
}


def estimate(trace: zmpwalk.Trace) -> Figure:
    """The headline."""
    return plot.estimate(trace)


def sagittal(trace: zmpwalk.Trace) -> Figure:
    """COM and ZMP over time."""
    return plot.sagittal(trace)


def walk(trace: zmpwalk.Trace) -> Figure:
    """Four instants of the walk side by side, each under its time."""
    with matplotlib.rc_context(plot.STYLE):
        figure = plot.WalkFigure(figsize=(10.0, 3.3))
        for i, (t, word) in enumerate(TIMES.items()):
            ax = figure.add_axes((0.25 * i, 0.0, 0.248, 0.92))
            ax.imshow(render.snapshot(trace, t=t, width=400, height=480), aspect="auto")
            ax.set_axis_off()
            figure.text(0.25 * i + 0.006, 0.94, f"{t:g} s: {word}", fontsize=9)
    return figure


def mixed(trace: zmpwalk.Trace) -> Figure:
    """Sixty seconds from above, in four parts over the path that the commands lead."""
    path = analysis.planned_path(trace)[:, :2]
    low, high = path.min(axis=0) - 0.35, path.max(axis=0) + 0.35
    with matplotlib.rc_context(plot.STYLE):
        figure = plot.WalkFigure(figsize=(10.0, 8.1), layout="constrained")
        for i, (ax, ((start, end), words)) in enumerate(zip(figure.subplots(2, 2).ravel(), LEGS.items())):
            ax.plot(*path.T, color=plot.PLANNED, lw=0.8, ls=":", zorder=0)
            plot.footprints(trace, start, end, ax=ax)
            handles, labels = ax.get_legend_handles_labels()
            ax.get_legend().remove()
            ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
            ax.set_title(words, loc="left", fontsize=9)
            if i == 0:
                shown = [k for k, label in enumerate(labels) if not label.startswith(("start", "end"))]
                figure.legend([handles[k] for k in shown], [labels[k] for k in shown], loc="outside upper left", ncol=6)
    return figure


def moving() -> None:
    """A walk that starts, is pushed to the left and catches itself, as a picture that moves."""
    push = zmpwalk.Push.impulse(4.3, (0.0, 30.0, 0.0))
    trace = zmpwalk.simulate("mahru", zmpwalk.VelocityProfile.ramp(0.0, 0.35, 1.5), 8.4, push=push)
    half = round(0.8 / trace.control_dt)  # the camera's path is the mean over a stride
    padded = np.pad(trace.com[:, :2], ((half, half), (0, 0)), mode="edge")
    path = np.column_stack([np.convolve(way, np.full(2 * half + 1, 1 / (2 * half + 1)), "valid") for way in padded.T])
    font, speed, pictures = ImageFont.load_default(size=15), trace.forward_velocity(), []
    for t in np.arange(1.0, trace.t[-1], 1 / FPS):
        k = np.searchsorted(trace.t, t)
        camera = {"lookat": (*path[k], 0.75), "azimuth": 145.0, "elevation": -14.0, "distance": 2.6}
        picture = Image.fromarray(render.snapshot(trace, t=t, width=MOVING[0], height=MOVING[1], camera=camera))
        pushed = push.t <= t < push.t + 0.6
        words = "pushed by 30 N s" if pushed else f"{speed[k]:.2f} m/s"
        ImageDraw.Draw(picture).text((10, 8), words, fill=(20, 20, 20), font=font)
        pictures.append(picture)
    options = {"duration": round(1000 / FPS), "loop": 0, "quality": 60, "method": 6}
    pictures[0].save(IMAGES / "walking.webp", save_all=True, append_images=pictures[1:], **options)


def ground(trace: zmpwalk.Trace) -> Figure:
    """An instant on blocks, and the heights over time."""
    camera = {"azimuth": 125.0, "elevation": -20.0, "distance": 2.7}
    return heights(trace, 8.62, camera, xlim=(4.0, 12.0), ylim=(-0.5, 14.0))


def stairs(trace: zmpwalk.Trace) -> Figure:
    """An instant on stairs, and the heights over time."""
    camera = {"azimuth": 60.0, "elevation": -12.0, "distance": 4.2}
    return heights(trace, 7.9, camera, xlim=(0.0, 21.0), ylim=(-10.0, 150.0))


def heights(trace: zmpwalk.Trace, t: float, camera: dict[str, float], **axes: Any) -> Figure:
    """The instant `t` seen by the camera, and the heights of soles and followed ground over time."""
    with matplotlib.rc_context(plot.STYLE):
        figure = plot.WalkFigure(figsize=(10.0, 3.4))
        view = figure.add_axes((0.0, 0.0, 0.36, 1.0))
        view.imshow(render.snapshot(trace, t=t, width=500, height=472, camera=camera), aspect="auto")
        view.set_axis_off()
        ax = figure.add_axes((0.43, 0.17, 0.56, 0.76))
        for foot, label in ((trace.foot_left, "left sole"), (trace.foot_right, "right sole")):
            ax.plot(trace.t, 100.0 * foot[:, 2], lw=0.9, label=label)
        ax.plot(trace.t, 100.0 * trace.ground, color="black", lw=1.6, label="height that the COM follows")
        ax.set(**axes, xlabel="t [s]", ylabel="height over the floor [cm]")
        ax.legend(loc="upper left", ncol=3)
    return figure


def howtos() -> None:
    """The pictures that the code of the how-tos writes: NAME.png becomes images/howto_NAME.png."""
    for page in sorted((IMAGES.parent / "howto").glob("*.md")):
        text = page.read_text(encoding="utf-8")
        with tempfile.TemporaryDirectory() as scratch:
            os.chdir(scratch)
            for block in re.findall(r"```python\n(.*?)```", text, re.S):
                exec(compile(block, page.name, "exec"), {})
            for name in re.findall(r"images/howto_(\w+\.png)", text):
                shutil.copy(name, IMAGES / f"howto_{name}")
            os.chdir(IMAGES)


def viewer() -> None:
    """The window a moment after a push, while the robot walks."""

    frames = itertools.count()

    def draw(window: Any, walk: Any) -> None:
        k = next(frames)
        if k == 0:
            for key, shift, seconds in [*[("W", False, 0.0)] * 5, ("5", False, 4.1), ("LEFT", True, 0.07)]:
                walk.press(key, shift)
                walk.advance(seconds)
            walk.paused = True  # while the camera comes after
        elif k == 40:
            walk.paused = False
            matplotlib.image.imsave(IMAGES / "viewer.png", window.picture())
            walk.closed = True

    view.view("mahru", width=1000, height=640, on_frame=draw)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", choices=(*DRAWN, "howto", "viewer", "moving"), help="one picture")
    only = parser.parse_args().only
    if only in (None, "howto"):
        howtos()
    if only in (None, "moving"):
        moving()
    if only == "viewer":
        viewer()
    if only in ("howto", "viewer", "moving"):
        return
    trace = zmpwalk.simulate("mahru", duration=8.0)
    for draw in (estimate, walk, sagittal):
        if only in (None, draw.__name__):
            draw(trace).savefig(IMAGES / f"{draw.__name__}.png", dpi=160 if draw is walk else 110)
    if only in (None, "mixed"):
        mixed(zmpwalk.simulate(**walk_anywhere.mixed())).savefig(IMAGES / "mixed.png", dpi=100)
    if only in (None, "ground"):
        blocks = zmpwalk.simulate(profile=0.25, duration=12.0, terrain="blocks:2,7")
        ground(blocks).savefig(IMAGES / "ground.png", dpi=100)
    if only in (None, "stairs"):
        climb = zmpwalk.simulate(profile=0.25, duration=21.0, terrain="stairs:12x28", known=True)
        stairs(climb).savefig(IMAGES / "stairs.png", dpi=100)


if __name__ == "__main__":
    main()
