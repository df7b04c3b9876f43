"""Traces: a mapping, a file, a summary; and runs that repeat themselves."""

import json
import pickle
import sys
import zipfile

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk import DimensionError, InputError, ModelError, Trace
from zmpwalk.robots import ROBOTS
from zmpwalk.trace import FORMAT_VERSION

# --- a mapping with attributes


def test_columns_are_items_and_attributes_and_read_only(made_up_trace, made_up_columns):
    assert set(made_up_trace) == set(made_up_columns)
    assert made_up_trace["com"] is made_up_trace.com
    assert made_up_trace.com.shape == (8000, 3)
    assert "zmp_est" in dir(made_up_trace)
    with pytest.raises(ValueError, match="read-only"):
        made_up_trace.com[0, 0] = 1.0


def test_unknown_name_is_answered_with_the_nearest(made_up_trace):
    with pytest.raises(AttributeError, match=r"a trace has no 'cmo'; the nearest names are com\b"):
        _ = made_up_trace.cmo
    with pytest.raises(AttributeError, match=r"no 'zmp'; the nearest names are .*zmp_est"):
        _ = made_up_trace.zmp
    with pytest.raises(AttributeError, match=r"no 'sumary'; the nearest names are summary"):
        made_up_trace.sumary()
    with pytest.raises(KeyError):
        made_up_trace["zmp"]


def test_column_that_was_not_recorded_is_told_from_one_that_does_not_exist(made_up_trace):
    assert "heading" not in made_up_trace
    with pytest.raises(AttributeError, match="does not hold the column 'heading': it was recorded without it"):
        _ = made_up_trace.heading


def test_property_that_fails_says_why(made_up_columns, made_up):
    class Careless(Trace):
        @property
        def quotient(self):
            return self.t.no_such_method()

    with pytest.raises(AttributeError, match=r"'numpy\.ndarray' object has no attribute 'no_such_method'"):
        _ = Careless(made_up_columns, made_up.meta()).quotient


def test_columns_of_different_length_are_refused():
    with pytest.raises(DimensionError, match=r"'com' has shape \(3, 3\); 't' has 4 rows"):
        Trace({"t": np.zeros(4), "com": np.zeros((3, 3))})
    with pytest.raises(InputError, match="needs the column 't'"):
        Trace({"com": np.zeros((3, 3))})


def test_columns_of_another_width_are_refused():
    t = np.zeros(4)
    with pytest.raises(DimensionError, match=r"'com' has shape \(4, 2\); a row of it holds x, y, z \[m\] in W"):
        Trace({"t": t, "com": np.zeros((4, 2))})
    with pytest.raises(DimensionError, match=r"'phase' has shape \(4, 2\); a row of it holds one number$"):
        Trace({"t": t, "phase": np.zeros((4, 2))})
    assert Trace({"t": t, "mine": np.zeros((4, 5)), "tau": np.zeros((4, 12))})["mine"].shape == (4, 5)


def test_trace_does_not_follow_the_arrays_it_was_made_from():
    t = np.arange(3.0)
    trace = Trace({"t": t})
    t[0] = 7.0
    assert trace.t[0] == 0.0


def test_traces_are_equal_bit_for_bit_and_not_by_their_timing(made_up, made_up_columns, made_up_trace):
    assert made_up_trace == Trace(made_up_columns, made_up.meta(timing={"wall_time": 99.0}))
    com = made_up_columns["com"].copy()
    com[5, 1] = np.nextafter(com[5, 1], 1.0)
    assert made_up_trace != made_up.changed(made_up_columns, com=com)
    assert made_up_trace != Trace({name: array for name, array in made_up_columns.items() if name != "tau"})


def test_trace_pickles(made_up_trace):
    other = pickle.loads(pickle.dumps(made_up_trace))
    assert other == made_up_trace
    assert other.meta == made_up_trace.meta


# --- files


def test_saved_trace_loads_the_same(made_up_trace, tmp_path):
    path = made_up_trace.save(tmp_path / "walk")
    assert path.name == "walk.npz"
    loaded = Trace.load(path)
    assert loaded == made_up_trace
    assert loaded.meta == made_up_trace.meta
    assert not loaded.com.flags.writeable
    with np.load(path) as file:  # and NumPy alone can read it
        assert np.array_equal(file["com"], made_up_trace.com)


def test_infinite_limits_survive_the_file(made_up, made_up_columns, tmp_path):
    trace = Trace(made_up_columns, made_up.meta(torque_limits=[np.inf, 80.0]))
    assert Trace.load(trace.save(tmp_path / "walk.npz")).meta["torque_limits"] == [np.inf, 80.0]


def test_failed_save_leaves_the_old_file_and_no_draft(made_up_trace, tmp_path, monkeypatch):
    path = tmp_path / "walk.npz"
    path.write_text("old")

    def full_disk(*arguments, **options):
        raise OSError("no space left")

    monkeypatch.setattr(np.lib.format, "write_array", full_disk)
    with pytest.raises(OSError, match="no space"):
        made_up_trace.save(path)
    assert [file.name for file in tmp_path.iterdir()] == ["walk.npz"]
    assert path.read_text() == "old"


def test_files_that_are_no_traces_are_named(made_up_trace, tmp_path):
    with pytest.raises(InputError, match=r"nowhere\.npz: no such file"):
        Trace.load(tmp_path / "nowhere.npz")
    (tmp_path / "text.npz").write_text("hello")
    with pytest.raises(InputError, match=r"text\.npz: not a trace"):
        Trace.load(tmp_path / "text.npz")
    np.savez(tmp_path / "other.npz", a=np.zeros(3))
    with pytest.raises(InputError, match=r"other\.npz: not a trace"):
        Trace.load(tmp_path / "other.npz")
    whole = made_up_trace.save(tmp_path / "whole.npz").read_bytes()
    (tmp_path / "half.npz").write_bytes(whole[: len(whole) // 2])
    with pytest.raises(InputError, match=r"half\.npz: not a trace, or damaged"):
        Trace.load(tmp_path / "half.npz")


# What version 1 had on its first day. Of the columns that have come since, such a file holds none.
FIRST_COLUMNS = [
    "t", "com", "dcom", "com_des", "dcom_des", "v_plan", "v_des", "v_error_integral", "zmp_des", "zmp_ref", "zmp_est",
    "zmp_meas", "zmp_lower", "zmp_upper", "zmp_first", "zmp_slope", "zmp_modified", "phase", "support", "step",
    "phase_time", "w_T", "iterations", "foothold", "foot_left", "foot_right", "tau", "f_c", "contact_wrench",
    "torque_ratio", "saturated", "damped", "self_contacts", "joint_margin", "fell", "qpos", "qvel",
]  # fmt: skip


def write_trace(path, columns, **meta):
    """A trace file written by hand, without the code that is tested."""
    np.savez(path, **columns)
    with zipfile.ZipFile(path, "a") as file:
        file.writestr("meta.json", json.dumps(meta))
    return path


def test_file_of_the_first_day_still_reads(made_up, made_up_columns, tmp_path):
    columns = {name: made_up_columns.get(name, np.zeros(8000)) for name in FIRST_COLUMNS}
    path = write_trace(tmp_path / "old.npz", columns, **made_up.meta(format_version=1))
    trace = Trace.load(path)
    assert list(trace) == FIRST_COLUMNS
    assert all(np.array_equal(trace[name], columns[name], equal_nan=True) for name in FIRST_COLUMNS)
    assert trace.summary()["step_count"] == 9
    assert trace.profile.displacement(0.0, 0.8)[0] == pytest.approx(0.8 * 0.063)
    assert trace.settings.T_ss == 0.64
    assert set(trace.plot()) >= {"sagittal", "lateral"}
    assert "com_x" in trace.flat() and trace.to_csv(tmp_path / "old.csv").exists()
    assert Trace.load(trace.save(tmp_path / "again.npz")) == trace


def test_file_of_a_newer_version_is_refused_in_one_line(made_up, made_up_columns, tmp_path):
    meta = made_up.meta(format_version=FORMAT_VERSION + 1, versions={"zmpwalk": "9.8"})
    with pytest.raises(InputError) as refusal:
        Trace.load(write_trace(tmp_path / "new.npz", made_up_columns, **meta))
    known, newer = FORMAT_VERSION, FORMAT_VERSION + 1
    assert str(refusal.value) == (
        f"{tmp_path / 'new.npz'}: trace format {newer} is newer than this zmpwalk, which reads up to {known}; "
        "it was written by zmpwalk 9.8"
    )


@pytest.mark.parametrize("version", [0, True, "1", None])
def test_file_without_a_version_is_no_trace(made_up, made_up_columns, tmp_path, version):
    path = write_trace(tmp_path / "odd.npz", made_up_columns, **made_up.meta(format_version=version))
    with pytest.raises(InputError, match=r"odd\.npz: not a trace that zmpwalk saved: its format is"):
        Trace.load(path)


def test_csv_loses_nothing(made_up, made_up_columns, tmp_path):
    trace = Trace({name: array[::500] for name, array in made_up_columns.items()}, made_up.meta())
    path = trace.to_csv(tmp_path / "walk.csv")
    names = path.read_text().splitlines()[0].split(",")
    assert names[0] == "t"
    table = np.genfromtxt(path, delimiter=",", skip_header=1)
    for name, column in trace.flat().items():
        assert np.array_equal(table[:, names.index(name)], column, equal_nan=True)


def test_flat_names_tell_part_and_joint(made_up, made_up_columns):
    joints = [f"joint{i}" for i in range(25)]
    flat = Trace(made_up_columns, made_up.meta(joint_names=joints)).flat()
    for name in ("com_x", "v_plan_yaw", "foot_left_qw", "contact_wrench_right_fz", "tau_joint24", "qpos_31", "phase"):
        assert name in flat
    standing = flat["contact_wrench_left_fz"] + flat["contact_wrench_right_fz"]
    assert np.nanmax(standing) == pytest.approx(-made_up.MASS * 9.81)


def test_dataframe_is_indexed_by_time(made_up_trace):
    pytest.importorskip("pandas")
    table = made_up_trace.to_dataframe()
    assert table.index.name == "t"
    assert np.array_equal(table["zmp_est_y"], made_up_trace.zmp_est[:, 1])


def test_dataframe_without_pandas_says_what_to_install(made_up_trace, monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(ImportError, match="pip install pandas"):
        made_up_trace.to_dataframe()


# --- summary


def test_summary_has_the_keys_that_others_script_against(made_up_trace):
    summary = json.loads(json.dumps(made_up_trace.summary(), allow_nan=False))
    assert set(summary) >= {
        "robot", "mujoco_version", "duration", "fell", "fall_time", "fall_cause", "step_count", "mean_speed_per_step",
        "planned_speed_per_step", "speed_rms_error", "zmp_error_mm", "iterations", "peak_torque_ratio", "cycle_us",
        "real_time_factor", "bound_excess_mm",
    }  # fmt: skip
    assert set(summary["zmp_error_mm"]) == {"median", "p95", "single_support_p95", "single_support_rms"}
    assert all(len(pair) == 2 for pair in summary["zmp_error_mm"].values())
    assert set(summary["iterations"]) == {"mean", "max"}
    assert set(summary["cycle_us"]) == {"median", "p99"}


def test_summary_of_the_made_up_walk_is_what_was_made_up(made_up, made_up_trace):
    summary = made_up_trace.summary()
    assert summary["duration"] == 8.0
    assert summary["step_count"] == 9  # touch-downs at 0.82, 1.62, ... 7.22
    assert summary["planned_speed_per_step"] == pytest.approx([*made_up.PAPER[1], *[0.25] * 6])
    com, last = made_up_trace.com[:, 0], made_up_trace.com[-1, 0] + 0.001 * made_up_trace.dcom[-1, 0]
    assert summary["mean_speed_per_step"] == pytest.approx(np.diff([*com[::800], last]) / 0.8)
    assert summary["zmp_error_mm"]["median"] == pytest.approx([0.005, 0.005])
    assert summary["zmp_error_mm"]["single_support_rms"] == pytest.approx([0.005, 0.005])
    assert summary["bound_excess_mm"][0] == pytest.approx(0.2, abs=0.01)  # the made-up estimate wanders by 0.2 mm
    assert summary["bound_excess_mm"][1] == 0.0
    assert summary["iterations"] == {"mean": 3.0, "max": 3}
    assert summary["peak_torque_ratio"] == pytest.approx(0.6, abs=1e-3)
    assert (summary["fell"], summary["fall_time"], summary["fall_cause"]) == (False, None, None)


def test_speed_is_measured_along_the_heading(made_up, made_up_columns, made_up_trace):
    turned, quarter = {}, np.array([[0.0, -1.0], [1.0, 0.0]])
    for name in ("com", "dcom"):
        turned[name] = made_up_columns[name].copy()
        turned[name][:, :2] = made_up_columns[name][:, :2] @ quarter.T
    for name in ("foot_left", "foot_right"):
        turned[name] = made_up_columns[name].copy()
        turned[name][:, 3:] = np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5)
    summary = made_up.changed(made_up_columns, **turned).summary()
    assert summary["mean_speed_per_step"] == pytest.approx(made_up_trace.summary()["mean_speed_per_step"])
    assert summary["speed_rms_error"] == pytest.approx(made_up_trace.summary()["speed_rms_error"])


def test_speed_of_walking_in_a_circle_is_the_planned_one(made_up):
    t, rate, radius = 0.001 * np.arange(8000), 0.5, 0.4
    columns = made_up.columns()
    columns["v_plan"][:] = radius * rate, 0.0, rate
    columns["com"][:, :2] = radius * np.column_stack([np.sin(rate * t), 1 - np.cos(rate * t)])
    columns["dcom"][:, :2] = radius * rate * np.column_stack([np.cos(rate * t), np.sin(rate * t)])
    profile = {"t": [0.0], "v": [[radius * rate, 0.0, rate]]}
    summary = Trace(columns, made_up.meta(profile=profile)).summary()
    assert summary["mean_speed_per_step"] == pytest.approx([radius * rate] * 10, rel=1e-3)
    assert summary["speed_rms_error"] == pytest.approx(0.0, abs=1e-12)


def test_summary_of_a_walk_without_contact_or_timing_holds_none(made_up, made_up_columns):
    empty = {"zmp_meas": np.full((8000, 2), np.nan), "zmp_modified": np.zeros((8000, 2))}
    summary = Trace(
        {**made_up_columns, **empty}, made_up.meta(timing={}, fell=True, fall_time=7.9, fall_cause="tilt")
    ).summary()
    assert summary["zmp_error_mm"]["p95"] == [None, None]
    assert summary["iterations"] == {"mean": None, "max": None}
    assert summary["cycle_us"] == {"median": None, "p99": None}
    assert (summary["fell"], summary["fall_time"], summary["fall_cause"]) == (True, 7.9, "tilt")
    json.dumps(summary, allow_nan=False)


def test_summary_of_a_very_short_walk_has_no_whole_step(made_up, made_up_columns):
    short = Trace({name: array[:100] for name, array in made_up_columns.items()}, made_up.meta())
    assert short.summary()["mean_speed_per_step"] == []
    assert short.summary()["duration"] == 0.1


# --- real runs


def test_simulated_trace_has_every_promised_column(walked):
    model, _ = zmpwalk.load_robot("mahru")
    widths = {
        **dict.fromkeys(["com", "dcom", "com_des", "dcom_des", "v_plan", "v_des", "v_error_integral", "foothold"], 3),
        **dict.fromkeys(["zmp_des", "zmp_ref", "zmp_est", "zmp_meas", "zmp_lower", "zmp_upper"], 2),
        **dict.fromkeys(["zmp_first", "zmp_slope", "zmp_modified"], 2),
        **dict.fromkeys(["t", "phase", "support", "iterations", "fell", "w_T", "step", "phase_time"], 0),
        **dict.fromkeys(["foot_left", "foot_right"], 7), **dict.fromkeys(["f_c", "contact_wrench"], 12),
        "torque_ratio": 0, "tau": model.nu, "qpos": model.nq, "qvel": model.nv,
    }  # fmt: skip
    for name, width in widths.items():
        assert walked[name].shape == ((1500, width) if width else (1500,)), name
    assert walked.t == pytest.approx(0.001 * np.arange(1500))
    assert walked.meta["robot"] == "mahru"
    assert walked.meta["model_sha256"]
    assert walked.meta["versions"]["mujoco"] == mujoco.__version__
    assert len(walked.meta["joint_names"]) == len(walked.meta["torque_limits"]) == model.nu


def test_saved_run_repeats_from_its_file_alone(walked, tmp_path):
    path = walked.save(tmp_path / "walk.npz")
    seen = []
    again = Trace.load(path).rerun(lambda t, duration: seen.append((t, duration)))
    assert again == walked
    assert all(duration == 1.5 for _, duration in seen)


def test_loop_in_python_is_the_loop_in_cpp(walked, tmp_path):
    model, description = zmpwalk.load_robot("mahru")
    data = mujoco.MjData(model)
    description.place(model, data)
    controller = zmpwalk.WalkingController(model, description)
    controller.reset(data)
    recorder = zmpwalk.Recorder(controller)
    while data.time < 0.3 - 1e-9:
        out = controller.update(data)
        mujoco.mj_step(model, data)
        recorder.add(out, data)
    trace = recorder.trace()
    assert all(np.array_equal(trace[name], walked[name][:300], equal_nan=True) for name in walked)
    assert trace.rerun() == trace
    assert Trace.load(trace.save(tmp_path / "walk.npz")).rerun() == trace
    assert trace.meta["fell"] is False


def test_a_loop_whose_torque_is_held_for_several_time_steps_runs_again():
    model, description = zmpwalk.load_robot("mahru")
    data = mujoco.MjData(model)
    description.place(model, data)
    controller = zmpwalk.WalkingController(model, description, zmpwalk.WalkSettings(control_dt=0.004))
    controller.reset(data)
    recorder = zmpwalk.Recorder(controller)
    while data.time < 0.3 - 1e-9:
        out = controller.update(data)
        mujoco.mj_step(model, data)
        recorder.add(out, data)
    assert len(recorder.trace().t) == 75
    assert recorder.trace().rerun() == recorder.trace()


def without_source(trace, **meta):
    return Trace(trace, {**trace.meta, **meta}, trace._model)


def as_by_another_mujoco(trace):
    """The same trace, as it looks where another MuJoCo than the one here has walked."""
    meta = {**trace.meta, "versions": {**trace.meta["versions"], "mujoco": "9.9.9"}}
    parts = trace._simulated, trace._source, trace._simulated_source
    return Trace(trace, meta, trace._model and b"of another layout", True, *parts)


def test_model_of_another_mujoco_without_source_or_a_damaged_one_is_refused(walked):
    with pytest.raises(ModelError, match=r"in compiled form only, which MuJoCo 9\.9\.9 wrote"):
        without_source(walked, versions={"mujoco": "9.9.9"}).rerun()
    damaged = Trace(walked, walked.meta, walked._model[:-1] + b"?")
    with pytest.raises(ModelError, match="damaged"):
        damaged.rerun()
    with pytest.raises(ModelError, match="no model"):
        Trace(walked, walked.meta).rerun()


def test_a_walk_by_another_mujoco_is_run_again_from_its_files_and_says_how_far_it_went(walked, tmp_path):
    other = Trace.load(as_by_another_mujoco(walked).save(tmp_path / "walk.npz"))
    assert other.model_kept == "the files of mahru.xml, for every MuJoCo that reads them"
    with pytest.warns(UserWarning, match=r"MuJoCo 9\.9\.9 walked this .* the COM went up to 0\.0e\+00 m away"):
        again = other.rerun()
    assert again == walked
    assert again.meta["rerun_of"] == {"mujoco": "9.9.9", "com_away": 0.0, "rows": 1500}


def test_what_was_simulated_is_made_again_under_another_mujoco():
    unsure = zmpwalk.simulate("mahru", duration=0.2, uncertainty={"mass": 1.05, "links": 0.1, "com": 0.01}, seed=5)
    other = as_by_another_mujoco(unsure)
    assert np.array_equal(other.simulated_model.body_mass, unsure.simulated_model.body_mass)
    with pytest.warns(UserWarning, match="went up to 0"):
        assert other.rerun() == unsure


def torso_of(mass):
    """A change of the bundled robot's MJCF (`mahru_edited`)."""
    return lambda root: root.find(".//body[@name='torso']/inertial").set("mass", str(mass))


def test_a_given_robot_that_was_simulated_is_kept_with_its_own_files(mahru_edited, tmp_path):
    heavy = tmp_path / "heavy.xml"
    heavy.write_text(mahru_edited.xml(torso_of(25)))
    trace = zmpwalk.simulate("mahru", duration=0.1, simulated=heavy)
    other = Trace.load(as_by_another_mujoco(trace).save(tmp_path / "walk.npz"))
    heavy.unlink()
    assert other.simulated_model.body("torso").mass == 25
    assert other.model.body("torso").mass != 25
    no_file = mujoco.MjModel.from_xml_path(str(ROBOTS / "mahru.xml"))
    compiled_only = as_by_another_mujoco(zmpwalk.simulate("mahru", duration=0.1, simulated=no_file))
    assert compiled_only.model.nq == no_file.nq
    with pytest.raises(ModelError, match="compiled form only"):
        _ = compiled_only.simulated_model


def test_a_model_that_was_changed_since_it_was_loaded_keeps_its_compiled_form_and_says_so():
    model, description = zmpwalk.load_robot("mahru")
    assert "the files of mahru.xml" in zmpwalk.simulate((model, description), duration=0.01).model_kept
    model.opt.gravity[2] = -9.7
    trace = zmpwalk.simulate((model, description), duration=0.01)
    assert trace.model_kept.startswith(f"its compiled form, for MuJoCo {mujoco.__version__} only")
    assert trace.summary()["model_kept"] == trace.model_kept
    assert trace.model.opt.gravity[2] == -9.7
    assert Trace({"t": trace.t}).model_kept == "none"


def test_a_humanoid_of_given_measures_is_kept_with_its_mjcf():
    trace = as_by_another_mujoco(zmpwalk.simulate(zmpwalk.humanoid(height=1.2).robot, duration=0.01))
    assert trace.model_kept.startswith("the files of humanoid.xml")
    assert trace.model.nq == trace.qpos.shape[1]


def test_source_is_a_path_a_text_or_a_text_with_files(tmp_path):
    text = (ROBOTS / "mahru.xml").read_text()
    (tmp_path / "of mine.xml").write_text(text)
    outer = '<mujoco><include file="inner.xml"/></mujoco>'
    for source in (tmp_path / "of mine.xml", text, (outer, {"inner.xml": text.encode()})):
        model = mujoco.MjModel.from_xml_path(str(ROBOTS / "mahru.xml"))
        trace = as_by_another_mujoco(zmpwalk.simulate(model, duration=0.01, source=source))
        assert np.array_equal(trace.model.body_mass, model.body_mass)


def test_source_of_another_model_is_refused(mahru_edited):
    model = mujoco.MjModel.from_xml_path(str(ROBOTS / "mahru.xml"))
    with pytest.raises(InputError, match="the source makes another model: it has 1 bodies"):
        zmpwalk.simulate(model, duration=0.01, source="<mujoco/>")
    lighter = mahru_edited.xml(torso_of(5))
    with pytest.raises(InputError, match="the source makes another model: body_mass differs"):
        zmpwalk.simulate(model, duration=0.01, source=lighter)
    with pytest.raises(InputError, match=r"nowhere\.xml: no such file"):
        zmpwalk.simulate(model, duration=0.01, source="nowhere.xml")


@pytest.mark.parametrize("duration", [0, -1, float("nan"), float("inf"), "long"])
def test_duration_must_be_positive_and_finite(duration):
    with pytest.raises(InputError, match="duration"):
        zmpwalk.simulate("mahru", duration=duration)


def test_what_on_progress_raises_stops_the_run_and_passes_on():
    def stop(t, duration):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        zmpwalk.simulate("mahru", duration=1000.0, on_progress=stop)


def test_plot_by_name_or_all(made_up_trace):
    assert set(made_up_trace.plot()) == {
        "estimate",
        "iteration",
        "tracking",
        "switch",
        "velocity",
        "sagittal",
        "lateral",
        "footprints",
    }
    with pytest.raises(InputError, match="no figure 'zmp'; there are estimate"):
        made_up_trace.plot("zmp")
