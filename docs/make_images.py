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
CROSSES = {"estimated ZMP": "zmp_est", "COM": "com"}  # on the ground of each picture
DRAWN = ("estimate", "walk", "sagittal", "mixed", "ground", "stairs")
TIMES = {0.4: "stands on the left foot", 2.0: "first steps", 4.9: "both feet down", 5.3: "swings a leg"}
PORTING_TIMES = {0.0: "start pose", 9.95: "swings a leg", 10.24: "both feet down", 10.65: "swings the other leg"}
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
    """Four instants of the walk."""
    return instants(trace, TIMES)


def porting(trace: zmpwalk.Trace) -> Figure:
    """Four instants of the walk of the Fourier N1 in docs/porting.md."""
    return instants(trace, PORTING_TIMES)


def instants(trace: zmpwalk.Trace, times: dict[float, str]) -> Figure:
    """Instants of a walk side by side, each under its time, over a line that says what the crosses are."""
    with matplotlib.rc_context(plot.STYLE):
        figure = plot.WalkFigure(figsize=(10.0, 3.5))
        for i, (t, word) in enumerate(times.items()):
            ax = figure.add_axes((0.25 * i, 0.06, 0.248, 0.87))
            ax.imshow(render.snapshot(trace, t=t, width=400, height=480), aspect="auto")
            ax.set_axis_off()
            figure.text(0.25 * i + 0.006, 0.95, f"{t:g} s: {word}", fontsize=9)
        for k, (name, mark) in enumerate(CROSSES.items()):
            figure.text(0.006 + 0.14 * k, 0.015, f"+ {name}", fontsize=9, color=render.MARKS[mark])
        figure.text(0.2, 0.015, "crosses on the ground", fontsize=9, color=plot.FAINT)
    return figure


def mixed(trace: zmpwalk.Trace) -> Figure:
    """Sixty seconds from above, in four parts over the path that the commands lead."""
    path = analysis.planned_path(trace)[:, :2]
    low, high = path.min(axis=0) - 0.35, path.max(axis=0) + 0.35
    with matplotlib.rc_context(plot.STYLE):
        figure = plot.WalkFigure(figsize=(10.0, 8.4), layout="constrained")
        figure.get_layout_engine().set(w_pad=0.12, h_pad=0.08)
        for i, (ax, ((start, end), words)) in enumerate(zip(figure.subplots(2, 2).ravel(), LEGS.items())):
            ax.plot(*path.T, color=plot.PLANNED, lw=0.8, ls=":", zorder=0)
            plot.footprints(trace, start, end, ax=ax)
            for line in [line for line in ax.get_lines() if line.get_label() == "measured ZMP"]:
                line.remove()  # too much for turns on the spot
            handles, labels = ax.get_legend_handles_labels()
            ax.get_legend().remove()
            ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
            ax.set_title(words, loc="left", fontsize=9)
            if i == 0:
                names = {"start": "start of the part", "end": "end of the part"}
                labels = [names.get(label.split(",")[0], label) for label in labels]
                handles.append(ax.get_lines()[0])
                labels.append("the whole way")
                figure.legend(handles, labels, loc="outside upper left", ncol=5)
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
        words = f"{t:4.1f} s   {speed[k]:.2f} m/s" + ("   pushed by 30 N s" if pushed else "")
        text = ImageDraw.Draw(picture)
        text.text((10, 8), words, fill=(20, 20, 20), font=font)
        for k, (name, mark) in enumerate(CROSSES.items()):
            colour = tuple(round(255 * share) for share in render.MARKS[mark][:3])
            text.text((10 + 140 * k, MOVING[1] - 26), f"+ {name}", fill=colour, font=font)
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
        figure.text(0.01, 0.93, f"at {t:.2f} s", fontsize=9)
        ax = figure.add_axes((0.43, 0.17, 0.555, 0.72))
        for foot, label, colour in (
            (trace.foot_left, "left sole", plot.SOLE),
            (trace.foot_right, "right sole", plot.RIGHT_SOLE),
        ):
            ax.plot(trace.t, 100.0 * foot[:, 2], lw=1.1, color=colour, label=label)
        ax.plot(trace.t, 100.0 * trace.ground, color="black", lw=1.6, label="ground that is followed")
        ax.axvline(t, color=plot.FAINT, ls=":", lw=1.2, label="instant on the left")
        ax.set(**axes, xlabel="time [s]", ylabel="height over the floor [cm]")
        ax.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=4, borderaxespad=0.2)
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
    parser.add_argument("--porting", metavar="TRACE", help="the walk of docs/porting.md, of which its picture is drawn")
    args = parser.parse_args()
    only = args.only
    if args.porting:
        porting(zmpwalk.Trace.load(args.porting)).savefig(IMAGES / "porting_walk.png", dpi=100)
        return
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
