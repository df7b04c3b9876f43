"""Figures to zoom into: their lines are the columns of the trace, and the page holds all it needs."""

import numpy as np
import pytest
from zmpwalk import InputError, cli, plot

pytest.importorskip("plotly")


def lines(figure, name):
    return [line for line in figure.data if line.name == name]


def test_its_lines_are_the_columns_of_the_walk(walked):
    figure = plot.interactive(walked)
    forward, leftward = lines(figure, "estimated ZMP")
    assert np.array_equal(forward.x, walked.t)
    assert np.array_equal(forward.y, walked.zmp_est[:, 0], equal_nan=True)
    assert np.array_equal(leftward.y, walked.zmp_est[:, 1], equal_nan=True)
    (error,) = lines(figure, "|estimated − measured ZMP|")
    assert np.nanmedian(error.y) == pytest.approx(1e3 * np.nanmedian(np.hypot(*(walked.zmp_est - walked.zmp_meas).T)))
    assert figure.layout.yaxis4.type == "log"
    assert len({figure.layout[f"xaxis{k}"].matches for k in ("", 2, 3, 4)}) <= 2  # zoom together


def test_each_name_stands_in_the_legend_once(walked):
    shown = [line.name for line in plot.interactive(walked).data if line.showlegend]
    assert sorted(shown) == sorted(set(shown))
    assert {"COM", "estimated ZMP", "measured ZMP", "planned"} <= set(shown)


def test_several_walks_are_drawn_over_one_another(walked):
    figure = plot.interactive({"a": walked, "b": walked}, ["velocity", "com_z"])
    assert [line.name for line in figure.data] == ["a", "b", "a", "b"]
    assert np.array_equal(figure.data[2].y, walked.com[:, 2])
    assert figure.data[0].line.color != figure.data[1].line.color


def test_a_long_walk_keeps_its_lines_short(made_up):
    from zmpwalk.trace import Trace

    trace = Trace(made_up.columns(20.0), made_up.meta())
    assert len(lines(plot.interactive(trace), "planned")[0].x) <= 8000
    part = lines(plot.interactive(trace, start=2.0, end=3.0), "planned")[0]
    assert (part.x[0], part.x[-1], len(part.x)) == (pytest.approx(2.0), pytest.approx(3.0), 1001)


def test_what_cannot_be_drawn_says_why(walked):
    with pytest.raises(InputError, match="there is no trace to draw"):
        plot.interactive({})
    with pytest.raises(InputError, match="nothing to draw from 3 to 2 s"):
        plot.interactive(walked, start=3.0, end=2.0)
    with pytest.raises(InputError, match="the walk 'a' has no 'com_w'; the nearest names are"):
        plot.interactive({"a": walked}, ["com_w"])


def test_the_command_writes_a_page_that_needs_no_network(walked, tmp_path, capsys):
    path = walked.save(tmp_path / "trace.npz")
    assert cli.main(["plot", str(path), "--interactive"]) == 0
    page = (tmp_path / "interactive.html").read_text(encoding="utf-8")
    assert capsys.readouterr().out.strip() == str(tmp_path / "interactive.html")
    assert "estimated ZMP" in page and '<script src="http' not in page
    assert cli.main(["plot", str(path), "--interactive", "--figure", "lateral"]) == 2
    other = walked.save(tmp_path / "other.npz")
    assert cli.main(["plot", "--compare", "--interactive", str(path), str(other)]) == 0
