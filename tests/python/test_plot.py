"""Figures: drawn from a trace alone, filled, labelled with units, and showing the numbers of the trace."""

import subprocess
import sys

import numpy as np
import pytest
import zmpwalk
from matplotlib.figure import Figure
from zmpwalk import InputError, Trace, plot
from zmpwalk.figures.curves import spans

FILES = [
    "estimate",
    "fig2_iteration",
    "fig4_tracking",
    "fig5_switch",
    "fig6_velocity",
    "fig7_sagittal",
    "fig8_lateral",
    "footprints",
]


def pixels(figure):
    figure.canvas.draw()
    return np.asarray(figure.canvas.buffer_rgba())[..., :3]


def line(ax, label):
    found = [one for one in ax.get_lines() if one.get_label().startswith(label)]
    assert found, f"no line '{label}' among {[one.get_label() for one in ax.get_lines()]}"
    return found[0].get_xdata(), found[0].get_ydata()


@pytest.mark.parametrize("name", plot.FIGURES)
def test_figure_is_filled_and_every_axis_has_a_name_and_a_unit(made_up_trace, name):
    figure = made_up_trace.plot(name)
    image = pixels(figure)
    for ax in figure.axes:
        box = ax.get_window_extent().extents.astype(int)
        inside = image[image.shape[0] - box[3] : image.shape[0] - box[1], box[0] : box[2]]
        assert (inside < 200).any(axis=-1).mean() > 0.005, "an empty panel"
        assert "[" in ax.get_ylabel() or name == "estimate"  # whose panels on the right share the left ones' axis
        assert ax.get_legend() is not None or ax is not figure.axes[0]
    names = ("[s]", "[ms]", "[m]", "pass", "[%]")
    assert any(ax.get_xlabel().endswith(names) for ax in figure.axes)


@pytest.mark.parametrize("name", plot.FIGURES)
def test_nothing_is_drawn_outside_the_picture(made_up_trace, name):
    figure = made_up_trace.plot(name)
    figure.canvas.draw()
    frame = figure.bbox
    for ax in figure.axes:
        for text in [ax.get_legend(), ax.xaxis.label, ax.yaxis.label]:
            box = text.get_window_extent() if text is not None else frame
            assert box.x0 >= frame.x0 - 1 and box.x1 <= frame.x1 + 1, (name, text)
            assert box.y0 >= frame.y0 - 1 and box.y1 <= frame.y1 + 1, (name, text)


def test_figures_need_the_trace_file_alone(made_up_trace, tmp_path):
    loaded = Trace.load(made_up_trace.save(tmp_path / "walk.npz"))
    for name in plot.FIGURES:
        assert np.array_equal(pixels(loaded.plot(name)), pixels(made_up_trace.plot(name)))


def test_real_walk_draws_every_figure(walked):
    for figure in walked.plot("all").values():
        assert (pixels(figure) < 200).any(axis=-1).mean() > 0.01


def test_iteration_replays_the_paper_s_loop(made_up_trace):
    trace, axis = made_up_trace, 0
    modified = np.flatnonzero(trace.zmp_modified[:, axis])
    first_error = trace.zmp_des[:, axis] - trace.zmp_first[:, axis]
    k = modified[np.argmax(np.abs(first_error[modified]))]
    figure = trace.plot("iteration")
    centre = (trace.foot_left if trace.support[k] > 0 else trace.foot_right)[k, axis]
    passes, estimate = line(figure.axes[0], "estimated ZMP")
    reference = line(figure.axes[0], "pendulum's reference")[1]
    desired = 1e3 * (trace.zmp_des[k, axis] - centre)
    assert passes[0] == 1
    assert estimate[0] == pytest.approx(1e3 * (trace.zmp_first[k, axis] - centre))
    assert reference[0] == pytest.approx(desired)
    for n in range(len(passes) - 1):  # r_ref += r_des - r_est, and the estimate follows by its slope
        assert reference[n + 1] - reference[n] == pytest.approx(desired - estimate[n])
        step = trace.zmp_slope[k, axis] * (reference[n + 1] - reference[n])
        assert estimate[n + 1] - estimate[n] == pytest.approx(step)
    assert abs(estimate[-1] - desired) < 1.0
    assert f"at {trace.t[k]:.3f} s" in figure._suptitle.get_text()


def test_iteration_counts_the_passes_that_the_contraction_needs(made_up_trace, made_up_columns, made_up):
    slow = made_up.changed(made_up_columns, zmp_slope=np.full((8000, 2), 0.046))
    k = int(np.flatnonzero(slow.zmp_modified[:, 0])[0])
    error = abs(slow.zmp_des[k, 0] - slow.zmp_first[k, 0])
    expected = 1 + int(np.ceil(np.log(0.001 / error) / np.log(1 - 0.046)))
    assert f" {expected} passes" in slow.plot("iteration", cycle=k)._suptitle.get_text()


def test_iteration_refuses_what_was_not_iterated(made_up_columns, made_up):
    first = made_up_columns["zmp_first"].copy()
    first[100] = np.nan
    with pytest.raises(InputError, match=r"cycle 100 at 0\.100 s was not iterated"):
        made_up.changed(made_up_columns, zmp_first=first).plot("iteration", cycle=100)
    with pytest.raises(InputError, match="cycle 8000 is outside"):
        made_up.changed(made_up_columns).plot("iteration", cycle=8000)
    with pytest.raises(InputError, match=r"'x' .* or 'y'"):
        made_up.changed(made_up_columns).plot("iteration", axis="z")


def test_tracking_shows_the_paper_s_window(made_up_trace):
    figure = made_up_trace.plot("tracking")
    for ax in figure.axes:
        assert ax.get_xlim() == pytest.approx((0.7, 1.2), abs=2e-3)
    t, integral = line(figure.axes[2], "integral")
    rows = np.searchsorted(made_up_trace.t, t)
    assert integral == pytest.approx(1e3 * made_up_trace.v_error_integral[rows, 0])


def test_tracking_of_a_walk_that_ended_before_shows_its_last_half_second(made_up_columns, made_up):
    short = Trace({name: array[:600] for name, array in made_up_columns.items()}, made_up.meta(fell=True))
    assert short.plot("tracking").axes[0].get_xlim() == pytest.approx((0.1, 0.6), abs=2e-3)


def test_switch_marks_the_moment_when_support_changes(made_up_trace, made_up):
    for step, begin in ((0, 0.0), (3, made_up.FIRST_DS + 0.64 + 2 * 0.8)):
        after = made_up_trace.t >= begin + 1e-9
        support = made_up_trace.support[after]
        change = made_up_trace.t[after][np.flatnonzero(np.diff(support))[0] + 1] - begin
        figure = made_up_trace.plot("switch", step=step)
        at = line(figure.axes[0], "ZMP switches")[0][0]
        assert at == pytest.approx(1e3 * change, abs=1.01)
        _since, w = line(figure.axes[0], "first double support" if step == 0 else "double support 3")
        assert w[0] > 0.4
        assert (np.diff(w[np.isfinite(w)]) < 0).all()
        assert abs(w[np.isfinite(w)][-1]) < 0.01
    with pytest.raises(InputError, match="this walk has 10"):
        made_up_trace.plot("switch", step=10)


def test_velocity_draws_plan_desire_and_measurement(made_up_trace):
    ax = made_up_trace.plot("velocity").axes[0]
    assert np.array_equal(line(ax, "planned")[1], made_up_trace.v_plan[:, 0])
    assert np.array_equal(line(ax, "desired")[1], made_up_trace.v_des[:, 0])
    assert line(ax, "COM, measured")[1] == pytest.approx(made_up_trace.dcom[:, 0])


def test_sagittal_and_lateral_draw_the_columns_of_their_direction(made_up_trace):
    for name, i in (("sagittal", 0), ("lateral", 1)):
        ax = made_up_trace.plot(name, start=2.0, end=3.0).axes[0]
        rows = slice(2000, 3001)
        assert np.array_equal(line(ax, "COM")[1], made_up_trace.com[rows, i])
        for label, column in (("estimated", "zmp_est"), ("measured", "zmp_meas"), ("desired", "zmp_des")):
            assert np.array_equal(line(ax, label)[1], made_up_trace[column][rows, i])


def test_long_walk_is_cut_to_ten_seconds_and_a_fall_shows_its_end(made_up_columns, made_up):
    long = {name: np.concatenate([array, array]) for name, array in made_up_columns.items()}
    long["t"] = 0.001 * np.arange(16000)
    stood, fell = Trace(long, made_up.meta()), Trace(long, made_up.meta(fell=True, fall_time=15.9))
    assert stood.plot("velocity").axes[0].get_xlim() == pytest.approx((0, 10), abs=0.01)
    assert fell.plot("velocity").axes[0].get_xlim() == pytest.approx(
        (6, 16.1), abs=0.01
    )  # the line of the fall is seen
    assert stood.plot("velocity", start=0).axes[0].get_xlim() == pytest.approx((0, 16), abs=0.01)
    assert "of 16 s" in stood.plot("sagittal")._suptitle.get_text()


def test_velocities_of_a_fall_do_not_flatten_the_walk(made_up_columns, made_up):
    wild = made_up_columns["v_des"].copy()
    wild[-3:] = -15.0
    low, high = made_up.changed(made_up_columns, v_des=wild).plot("velocity").axes[0].get_ylim()
    assert -0.3 < low < 0.0
    assert 0.25 < high < 0.6


def test_spikes_of_the_measurement_are_cut_and_said_so(made_up_columns, made_up):
    spiky = made_up_columns["zmp_meas"].copy()
    spiky[4000] = 3.0
    ax = made_up.changed(made_up_columns, zmp_meas=spiky).plot("lateral").axes[0]
    assert ax.get_ylim()[1] < 0.3
    line(ax, "measured ZMP (spikes cut)")


def test_window_outside_the_walk_is_refused(made_up_trace):
    for name in ("tracking", "velocity", "sagittal", "lateral"):
        with pytest.raises(InputError, match=r"nothing to draw from 9 to 10 s: the walk goes from 0 to 7\.999 s"):
            made_up_trace.plot(name, start=9, end=10)


def test_walk_without_the_event_says_so_instead_of_failing(made_up_columns, made_up):
    blank = np.full((8000, 2), np.nan)
    trace = made_up.changed(made_up_columns, zmp_first=blank, phase=np.ones(8000))
    for name in plot.FIGURES:
        pixels(trace.plot(name))


def test_figures_draw_on_axes_that_are_given(made_up_trace):
    mine = Figure()
    axes = mine.subplots(3, 1)
    assert made_up_trace.plot("tracking", axes=axes) is mine
    assert mine._suptitle is None
    assert all(ax.get_lines() for ax in axes)
    with pytest.raises(InputError, match="needs 3 axes, got 1"):
        made_up_trace.plot("tracking", axes=Figure().subplots())


def test_every_figure_draws_on_axes_that_are_given(made_up_trace):
    for name in plot.FIGURES:
        own = made_up_trace.plot(name)
        mine = Figure()
        assert made_up_trace.plot(name, ax=mine.subplots(1, len(own.axes))) is mine
        assert mine._suptitle is None
        assert len(mine.axes) == len(own.axes)
    with pytest.raises(InputError, match="give ax or axes, not both"):
        made_up_trace.plot("velocity", ax=Figure().subplots(), axes=Figure().subplots())


def test_every_figure_can_be_vector_graphics(made_up_trace, tmp_path):
    for kind, begins in (("pdf", b"%PDF"), ("svg", b"<?xml")):
        paths = plot.save_all(made_up_trace, tmp_path, ["estimate", "velocity"], kind)
        assert all(path.read_bytes().startswith(begins) for path in paths)


def test_estimate_draws_the_error_of_both_directions_and_its_share_in_each_phase(made_up_trace):
    trace = made_up_trace
    axes = trace.plot("estimate").axes
    error = 1e3 * np.abs(trace.zmp_est - trace.zmp_meas)
    for i in (0, 1):
        over_time, share = axes[2 * i], axes[2 * i + 1]
        drawn = over_time.get_lines()[0].get_ydata()
        assert drawn == pytest.approx(np.maximum(error[:, i], 1e-6))
        levels = [one.get_ydata()[0] for one in over_time.get_lines()[1:3]]
        assert levels == pytest.approx(np.percentile(error[:, i], (50, 95)))
        for phase, label in ((1, "single support"), (0, "double support")):
            percent, below = line(share, label)
            own = error[trace.phase == phase, i]
            middle = np.searchsorted(percent, 50.0)
            assert below[middle] == pytest.approx(np.maximum(np.median(own), 1e-6), rel=0.02)
            assert (np.diff(below) >= 0).all()
            assert percent[-1] == 100
        assert over_time.get_yscale() == share.get_yscale() == "log"


def test_estimate_says_the_same_numbers_as_the_summary(walked):
    figure, said = walked.plot("estimate"), walked.summary()["zmp_error_mm"]
    for i in (0, 1):
        levels = [one.get_ydata()[0] for one in figure.axes[2 * i].get_lines()[1:3]]
        assert levels == pytest.approx([said["median"][i], said["p95"][i]])


def test_compare_draws_a_line_of_its_own_for_each_walk(made_up_columns, made_up):
    slow, fast = Trace(made_up_columns, made_up.meta()), made_up.changed(
        made_up_columns, com=made_up_columns["com"] + 0.1
    )  # fmt: skip
    figure = plot.compare({"slow": slow, "fast": fast}, ("sideways", "com_z", "zmp_est_y"))
    assert [ax.get_ylabel() for ax in figure.axes][1:] == ["com_z [m]", "zmp_est_y [m]"]
    for name, trace in (("slow", slow), ("fast", fast)):
        assert np.array_equal(line(figure.axes[0], name)[1], trace.com[:, 1])
        assert np.array_equal(line(figure.axes[1], name)[1], trace.com[:, 2])
    colours = {line.get_color() for line in figure.axes[0].get_lines()}
    assert len(colours) == 2
    legend = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert legend == ["slow", "fast"]
    assert [
        text.get_text() for ax in figure.axes[1:] for text in (ax.get_legend().get_texts() if ax.get_legend() else ())
    ] == []


def test_compare_marks_where_a_walk_fell(made_up_columns, made_up):
    short = {name: array[:4000] for name, array in made_up_columns.items()}
    fell = Trace(short, made_up.meta(fell=True, fall_time=3.999))
    figure = plot.compare({"a": Trace(made_up_columns, made_up.meta()), "b": fell})
    for ax in figure.axes:
        upright = [list(one.get_xdata()) for one in ax.get_lines() if list(one.get_ydata()) == [0, 1]]
        assert upright == [[3.999, 3.999]]
    assert "b fell, 4.00 s" in [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert figure.axes[0].get_xlim() == pytest.approx((0, 8), abs=0.01)


def test_compare_says_what_differs_and_when_was_pushed():
    push = zmpwalk.Push.impulse(0.5, (0.0, 5.0, 0.0))
    walks = {
        str(gain): zmpwalk.simulate(duration=1.0, push=push, settings={"tracker_gain": gain}) for gain in (2.0, 4.0)
    }
    figure = plot.compare(walks)
    assert figure.get_suptitle() == "2 walks compared, which differ in: tracker gain 2, 4"
    assert "push, 0.50 s" in [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert plot.compare({"a": walks["2.0"], "b": walks["2.0"]}).get_suptitle().endswith("equal profile and settings")


def test_figures_over_time_say_when_the_robot_was_pushed_and_when_it_fell():
    pushed = zmpwalk.simulate(profile=0.2, duration=3.0, push=[(1.5, 0.08, None, (0.0, 1500.0, 0.0))], on_fall="go_on")
    for name in ("velocity", "sagittal", "lateral", "estimate"):
        legend = pushed.plot(name).axes[0].get_legend()
        words = [text.get_text() for text in legend.get_texts()]
        assert "push, 1.50 s" in words, name
        assert f"fell, {pushed.fall.time:.2f} s" in words, name
    words = [text.get_text() for text in pushed.plot("footprints").axes[0].get_legend().get_texts()]
    assert "push, 1.50 s" in words and any(word.startswith("fell, ") for word in words)
    start, end = pushed.plot("tracking").axes[0].get_xlim()
    assert end - start == pytest.approx(0.5, abs=0.01)  # about a change of the plan, or the end, not of the fall


def test_compare_says_what_is_wrong(made_up_trace):
    with pytest.raises(InputError, match=r"the walk 'a' has no 'com_w'; the nearest names are com_"):
        plot.compare({"a": made_up_trace}, ["com_w"])
    with pytest.raises(InputError, match="traces is Trace; it must be a dict"):
        plot.compare(made_up_trace)
    with pytest.raises(InputError, match="nothing to compare from 20 to 30 s"):
        plot.compare({"a": made_up_trace}, start=20, end=30)


def test_figure_shows_itself_in_a_notebook(made_up_trace):
    assert made_up_trace.plot("velocity")._repr_png_().startswith(b"\x89PNG")


def test_plotting_leaves_pyplot_alone():
    code = "import sys, zmpwalk.plot; sys.exit('matplotlib.pyplot' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_save_all_writes_every_figure(made_up_trace, tmp_path):
    paths = plot.save_all(made_up_trace, tmp_path / "new")
    assert [path.name for path in paths] == [f"{name}.png" for name in FILES]
    assert sorted(path.name for path in (tmp_path / "new").iterdir()) == sorted(path.name for path in paths)
    assert all(path.read_bytes().startswith(b"\x89PNG") and path.stat().st_size > 10000 for path in paths)


def test_save_all_takes_names_and_print_formats(made_up_trace, tmp_path):
    (path,) = plot.save_all(made_up_trace, tmp_path, ["fig5_switch"], "pdf")
    assert path.name == "fig5_switch.pdf"
    assert path.read_bytes().startswith(b"%PDF")
    with pytest.raises(InputError, match="no figure 'fig3'; there are estimate, iteration"):
        plot.save_all(made_up_trace, tmp_path, ["fig3"])


def test_failed_figure_leaves_no_file(made_up_trace, tmp_path, monkeypatch):
    def full_disk(*arguments, **options):
        raise OSError("no space left")

    monkeypatch.setattr(Figure, "savefig", full_disk)
    with pytest.raises(OSError, match="no space"):
        plot.save_all(made_up_trace, tmp_path)
    assert not list(tmp_path.iterdir())


def test_footprints_lie_where_soles_stood_turned_as_they_were(made_up_columns, made_up):
    turn, c, s = 0.5, np.cos(0.5), np.sin(0.5)
    turned = {name: made_up_columns[name].copy() for name in ("foot_left", "foot_right", "com", "zmp_meas")}
    for array in turned.values():  # the whole walk, about W's origin
        array[:, :2] = array[:, :2] @ np.array([(c, s), (-s, c)])
    for name in ("foot_left", "foot_right"):
        turned[name][:, 3:] = np.cos(turn / 2), 0, 0, np.sin(turn / 2)
    trace = made_up.changed(made_up_columns, **turned)
    ax = trace.plot("footprints").axes[0]
    soles = [patch.get_xy()[:4] for patch in ax.patches if patch.get_fill()]
    stood = [spans((trace.phase == 0) | (trace.support == side)) for side in (1, -1)]
    assert len(soles) == sum(map(len, stood))
    first = soles[0]
    assert first.mean(axis=0) == pytest.approx(trace.foot_left[0, :2])
    assert first[0] - first[1] == pytest.approx(0.25 * np.array([c, s]))  # as long as the sole, along its heading
    assert first[0] - first[3] == pytest.approx(0.14 * np.array([-s, c]))
    planned = np.column_stack(line(ax, "where the commands lead"))
    assert planned[-1] - planned[0] == pytest.approx(made_up_columns["v_plan"][:-1, 0].sum() * 0.001 * np.array([c, s]))
    assert np.column_stack(line(ax, "COM")) == pytest.approx(trace.com[:, :2])
    assert ax.get_aspect() == 1
    arrows = next(one for one in ax.collections if one.get_label() == "_heading")
    assert np.arctan2(arrows.V, arrows.U) == pytest.approx(np.full(len(arrows.U), turn))
