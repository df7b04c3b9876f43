"""Traces for other tools: what they hold is what the trace holds."""

import json

import numpy as np
import pytest
import zmpwalk
from zmpwalk import InputError


@pytest.fixture(scope="module")
def trace():
    return zmpwalk.simulate(profile=0.2, duration=1.5)


def test_a_parquet_file_holds_every_number_and_what_was_said_of_the_walk(trace, tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    table = parquet.read_table(trace.to_parquet(tmp_path / "walk.parquet"))
    flat = trace.flat()
    assert table.column_names == list(flat)
    for name in ("t", "com_x", "zmp_est_y", "tau_l_knee"):
        assert np.array_equal(table.column(name).to_numpy(), flat[name], equal_nan=True)
    assert json.loads(table.schema.metadata[b"zmpwalk"])["robot"] == trace.meta["robot"]


def test_a_data_set_has_dimensions_units_and_names(trace):
    pytest.importorskip("xarray")
    data = trace.to_xarray()
    assert data.sizes["t"] == len(trace.t)
    assert np.array_equal(data.com.sel(com_part="z"), trace.com[:, 2])
    assert np.array_equal(data.tau.sel(joint="l_knee"), trace.flat()["tau_l_knee"])
    assert data.com.attrs["units"] == "m" and data.com.attrs["frame"] == "W"
    assert json.loads(data.attrs["meta"])["robot"] == trace.meta["robot"]


def test_a_data_set_goes_through_a_netcdf_file(trace, tmp_path):
    xarray = pytest.importorskip("xarray")
    pytest.importorskip("h5netcdf")
    trace.to_xarray().to_netcdf(tmp_path / "walk.nc", engine="h5netcdf")
    with xarray.open_dataset(tmp_path / "walk.nc", engine="h5netcdf") as data:
        assert np.array_equal(data.zmp_est.values, trace.zmp_est, equal_nan=True)
        assert list(data.joint.values) == trace.meta["joint_names"]


def test_a_recording_for_rerun_holds_places_and_curves(trace, tmp_path):
    rerun = pytest.importorskip("rerun")
    path = trace.to_rerun(tmp_path / "walk.rrd")
    assert path.stat().st_size > 10_000
    with pytest.raises(InputError, match=r"a recording for Rerun is a \.rrd file"):
        trace.to_rerun(tmp_path / "walk.rerun")
    dataframe = pytest.importorskip("rerun.recording") if hasattr(rerun, "recording") else None
    if dataframe is not None:
        store = dataframe.load_recording(path).schema()
        paths = {column.entity_path for column in store.component_columns()}
        assert {"/com", "/zmp_est", "/left_sole", "/plots/velocity/planned"} <= paths


@pytest.mark.parametrize("kind", ["csv", "parquet", "nc"])
def test_the_command_writes_a_table(zmpwalk_command, trace, tmp_path, kind):
    pytest.importorskip({"csv": "numpy", "parquet": "pyarrow", "nc": "h5netcdf"}[kind])
    trace.save(tmp_path / "walk.npz")
    done = zmpwalk_command("plot", "--table", kind, "walk.npz", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip().endswith(f"walk.{kind}")
    assert (tmp_path / f"walk.{kind}").stat().st_size > 10_000
    done = zmpwalk_command("plot", "--table", kind, "--interactive", "walk.npz", cwd=tmp_path)
    assert done.returncode == 2 and "give one of them" in done.stderr


def test_a_tool_that_is_missing_says_how_to_install_it(trace, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "xarray", None)
    with pytest.raises(ImportError, match=r"to_xarray needs xarray: pip install xarray h5netcdf h5py"):
        trace.to_xarray()
