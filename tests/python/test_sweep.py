"""Sweeps: the same table on one process, on two and on a Dask cluster; nothing is lost; what cannot begin says why."""

import json
import math
import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
import zmpwalk
from zmpwalk import InputError, Sweep, sweep
from zmpwalk.sweeps import _journal_path, walk

GRID = {"profile": [0.1, 0.2], "tracker_gain": [2.0, 4.0]}


@pytest.fixture(scope="module")
def found():
    return sweep(GRID, processes=1, duration=0.5)


def same(a, b):
    """Whether two tables are equal, bit for bit; NaN equals NaN."""
    return a.columns == b.columns and repr(a.rows) == repr(b.rows)


def test_every_combination_is_walked_the_last_name_first(found):
    assert found.axes == ["profile", "tracker_gain"]
    assert [(row["profile"], row["tracker_gain"]) for row in found] == [(0.1, 2.0), (0.1, 4.0), (0.2, 2.0), (0.2, 4.0)]
    assert len(found) == 4


def test_a_row_says_what_the_walk_of_its_point_says(found):
    trace = zmpwalk.simulate(profile=0.2, settings={"tracker_gain": 4.0}, duration=0.5)
    row, said = found.rows[3], trace.summary()
    assert row["stood"] == 1 and row["error"] == ""
    assert [row["zmp_error_x"], row["zmp_error_y"]] == said["zmp_error_mm"]["median"]
    assert row["torque"] == said["peak_torque_ratio"]
    assert row["duration"] == 0.5
    assert math.isnan(row["fall_time"])


def test_two_processes_give_the_same_table(found):
    assert same(sweep(GRID, processes=2, duration=0.5), found)


def test_a_dask_cluster_gives_the_same_table(found):
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50
    ) as cluster:  # fmt: skip
        assert same(sweep(GRID, cluster=cluster.scheduler_address, duration=0.5), found)
        with distributed.Client(cluster) as client:
            assert same(sweep(GRID, cluster=client, duration=0.5), found)


def test_a_walk_that_cannot_begin_is_a_row_with_its_reason():
    table = sweep({"profile": [0.1, 50.0]}, processes=1, duration=0.2)
    assert [row["stood"] for row in table][:1] == [1] and math.isnan(table.rows[1]["stood"])
    (failure,) = table.failures
    assert "50" in failure["error"] and "m/s" in failure["error"]
    assert "1 could not begin" in repr(table)


def test_a_table_with_a_walk_that_cannot_begin_is_saved(tmp_path):
    pytest.importorskip("pyarrow")
    table = zmpwalk.sweep({"profile": [0.1, 90.0]}, duration=0.5)
    assert list(table["fall_cause"]) == ["", ""]
    assert table.save(tmp_path / "two.parquet").is_file()


def test_points_may_be_listed_and_name_uncertainties():
    table = sweep(
        [{"profile": 0.1, "seed": 1}, {"profile": 0.2, "seed": 2}], processes=1, duration=0.2,
        **{"uncertainty.noise": 1.0},
    )  # fmt: skip
    trace = zmpwalk.simulate(profile=0.2, seed=2, duration=0.2, uncertainty={"noise": 1.0})
    assert table.axes == ["profile", "seed"]
    assert table["torque"][1] == trace.summary()["peak_torque_ratio"]


def test_a_measure_of_your_own_adds_its_columns():
    table = sweep(
        {"profile": [0.1]}, processes=1, duration=0.2, measure=lambda trace: {"height": trace.com[:, 2].min()}
    )
    assert table["height"] == pytest.approx(0.747, abs=0.01)


def test_what_a_measure_raises_passes_on():
    with pytest.raises(ZeroDivisionError):
        sweep({"profile": [0.1]}, processes=1, duration=0.2, measure=lambda trace: {"no": 1 / 0})


def test_a_process_that_dies_loses_nothing(found, tmp_path):
    mark = tmp_path / "died"

    def die_once(trace):
        if not mark.exists():
            mark.touch()
            os.kill(os.getpid(), signal.SIGKILL)
        return {}

    assert same(sweep(GRID, processes=2, duration=0.5, measure=die_once), found)
    assert mark.exists()


def test_a_walk_whose_process_always_dies_is_a_row_too():
    table = sweep({"profile": [0.1]}, processes=1, duration=0.2, measure=lambda trace: os.kill(os.getpid(), 9))
    assert "its process died 3 times" in table.rows[0]["error"]


SCRIPT = """
import sys, zmpwalk
zmpwalk.sweep({"profile": [0.05 * k for k in range(1, 9)]}, sys.argv[1], processes=1, duration=2.0)
"""


def test_an_interrupted_sweep_goes_on_and_gives_the_same_table(tmp_path, ctrl_c):
    table, path = tmp_path / "walks.csv", [sys.executable, "-c", SCRIPT]
    process = subprocess.Popen([*path, table], stderr=subprocess.DEVNULL)
    end = time.monotonic() + 120
    while time.monotonic() < end:
        kept = _journal_path(table)
        if kept.exists() and len(kept.read_text().splitlines()) >= 2:
            break
        time.sleep(0.02)
    process.send_signal(signal.SIGINT)
    assert process.wait(60) != 0
    assert not table.exists()
    before = len(_journal_path(table).read_text().splitlines())
    done = []
    grid = {"profile": [0.05 * k for k in range(1, 9)]}
    again = sweep(grid, table, processes=1, duration=2.0, on_progress=lambda n, total: done.append((n, total)))
    assert done[0] == (before, 8) and done[-1] == (8, 8)
    whole = sweep(grid, tmp_path / "other.csv", processes=1, duration=2.0)
    assert same(again, whole)
    assert table.read_bytes() == (tmp_path / "other.csv").read_bytes()


def test_a_sweep_over_more_walks_only_what_is_new(tmp_path, monkeypatch):
    done = []
    for profiles in ([0.1], [0.1, 0.2]):
        sweep(
            {"profile": profiles}, tmp_path / "a.csv", processes=1, duration=0.2, on_progress=lambda *n: done.append(n)
        )
    assert done == [(0, 1), (1, 1), (1, 2), (2, 2)]


def test_a_measure_whose_code_changed_is_walked_again(tmp_path):
    walked = []

    def again(measure):
        done = []
        found = sweep(
            {"profile": [0.1]},
            tmp_path / "a.csv",
            1,
            measure=measure,
            duration=0.2,
            on_progress=lambda *n: done.append(n),
        )
        walked.append(done[0][0] == 0)
        return found["height"][0]

    lowest = again(lambda trace: {"height": trace.com[:, 2].min()})
    assert again(lambda trace: {"height": trace.com[:, 2].min()}) == lowest
    assert again(lambda trace: {"height": trace.com[:, 2].max()}) > lowest
    assert walked == [True, False, True]


def test_a_damaged_line_of_what_was_kept_is_walked_again(tmp_path):
    table = tmp_path / "a.csv"
    first = sweep({"profile": [0.1]}, table, processes=1, duration=0.2)
    kept = _journal_path(table)
    kept.write_text(kept.read_text()[:40])
    assert same(sweep({"profile": [0.1]}, table, processes=1, duration=0.2), first)


def test_the_table_as_parquet_and_for_pandas(found, tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    pytest.importorskip("pandas")
    read = parquet.read_table(found.save(tmp_path / "a.parquet"))
    assert read.column_names == found.columns
    assert read.column("zmp_error_x").to_pylist() == found["zmp_error_x"].tolist()
    assert json.loads(read.schema.metadata[b"zmpwalk_axes"]) == ["profile", "tracker_gain"]
    assert list(found.to_dataframe().profile) == [0.1, 0.1, 0.2, 0.2]
    with pytest.raises(InputError, match=r"a sweep's table is a \.parquet or \.csv file"):
        found.save(tmp_path / "a.xls")


def test_the_chart_has_a_line_for_each_value_of_the_other_axis(found):
    figure = found.plot("torque")
    (ax,) = figure.axes
    labels = [text.get_text() for text in ax.get_legend().get_texts()]
    assert labels == ["tracker_gain 2", "tracker_gain 4"]
    assert ax.get_lines()[0].get_xdata().tolist() == [0.1, 0.2]
    assert ax.get_lines()[1].get_ydata().tolist() == found["torque"][[1, 3]].tolist()
    with pytest.raises(InputError, match="a sweep has no 'torqe'; the nearest names are torque"):
        found.plot("torqe")


def test_the_chart_marks_falls():
    rows = [{"profile": v, "stood": int(v < 0.3), "error": "", "torque": v} for v in (0.1, 0.2, 0.3)]
    (ax,) = Sweep(rows, ["profile"]).plot("torque").axes
    (cross,) = [line for line in ax.get_lines() if line.get_marker() == "X"]
    assert cross.get_xdata().tolist() == [0.3]
    assert cross.get_ydata() == pytest.approx(ax.get_ylim()[1])  # at the rim: a fall does not flatten the walks
    assert np.isnan(ax.get_lines()[0].get_ydata()[2])


@pytest.mark.parametrize(
    ("grid", "more", "words"),
    [
        ({}, {}, "the grid is empty"),
        ({"speed_": [1]}, {}, "'speed_' is no argument of simulate, no setting and no uncertainty"),
        ({"profile": 0.1}, {}, "the grid's 'profile' is 0.1; it must be a list"),
        ({"profile": [0.1]}, {"processes": 0}, "processes is 0"),
        ({"profile": [0.1]}, {"out": "a.txt"}, "is a .parquet or .csv file"),
        ({"profile": [0.1]}, {"measure": 3}, "measure is 3"),
    ],
)
def test_what_makes_no_sense_is_refused_before_the_first_walk(grid, more, words):
    with pytest.raises(InputError, match=words.replace(".", r"\.")):
        sweep(grid, **more)


def test_one_walk_is_a_row_without_its_point():
    assert walk({"profile": 0.1, "duration": 0.1}, None)["stood"] == 1


def test_the_command_writes_table_and_chart(zmpwalk_command, tmp_path):
    (tmp_path / "speeds.toml").write_text(
        "duration = 0.3\n[grid]\nprofile = { from = 0.1, to = 0.2, count = 2 }\nstep_height = [0.03, 0.04]\n"
    )
    done = zmpwalk_command("sweep", "speeds.toml", "--processes", 1, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "Sweep(4 walks over profile, step_height; 0 fell, 0 could not begin)" in done.stdout
    names = {path.name for path in (tmp_path / "out" / "speeds").iterdir()}
    assert "sweep.png" in names and names & {"sweep.parquet", "sweep.csv"}
    (tmp_path / "empty.toml").write_text("duration = 1.0\n")
    done = zmpwalk_command("sweep", "empty.toml", cwd=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert "it has no table [grid]" in done.stderr


BIG = pytest.mark.skipif(not os.environ.get("ZMPWALK_BIG"), reason="ZMPWALK_BIG is not set: 200 walks take minutes")
LARGE = {"profile": [0.05 * k for k in range(1, 11)], "tracker_gain": [1.0, 2.0, 3.0, 4.0], "seed": [1, 2, 3, 4, 5]}
SHARED = {"duration": 2.0, "uncertainty.noise": 0.5}

INTERRUPTED = f"""
import sys, zmpwalk
zmpwalk.sweep({LARGE!r}, sys.argv[1], processes=2, **{SHARED!r})
"""


@BIG
def test_two_hundred_walks_are_one_table_wherever_they_are_walked(tmp_path, ctrl_c):
    distributed = pytest.importorskip("distributed")
    alone = sweep(LARGE, processes=1, **SHARED)
    assert len(alone) == 200
    assert same(sweep(LARGE, processes=2, **SHARED), alone)
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50
    ) as cluster:
        victim = next(iter(cluster.workers.values())).process.pid

        def kill(done, total):
            if done == total // 2:
                os.kill(victim, signal.SIGKILL)

        assert same(sweep(LARGE, cluster=cluster.scheduler_address, on_progress=kill, **SHARED), alone)
    table = tmp_path / "walks.csv"
    process = subprocess.Popen([sys.executable, "-c", INTERRUPTED, table], stderr=subprocess.DEVNULL)
    end = time.monotonic() + 300
    kept = _journal_path(table)
    while time.monotonic() < end and not (kept.exists() and len(kept.read_text().splitlines()) >= 60):
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    assert process.wait(60) != 0
    done = []
    again = sweep(LARGE, table, processes=2, on_progress=lambda n, total: done.append(n), **SHARED)
    assert done[0] >= 60 and len(done) == 200 - done[0] + 1  # only what was missing was walked
    assert same(again, alone)
