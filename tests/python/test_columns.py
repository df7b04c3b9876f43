"""A recorded column is stated once: record, CycleOutput, Trace, docs page and type checkers agree with the table."""

import importlib.util
import re
from pathlib import Path

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk import CycleOutput, Trace, _core

ROOT = Path(__file__).parents[2]
COLUMNS = _core.recorded_columns()
DECIDED = [column.name for column in COLUMNS if column.decided]


@pytest.fixture(scope="module")
def cycles():
    """A trace of 60 cycles in a loop of our own, every cycle's output, and the model."""
    model, description = zmpwalk.load_robot("mahru")
    data = mujoco.MjData(model)
    description.place(model, data)
    controller = zmpwalk.WalkingController(model, description)
    controller.reset(data)
    recorder, outputs = zmpwalk.Recorder(controller), []
    for _ in range(60):
        outputs.append(controller.update(data))
        mujoco.mj_step(model, data)
        recorder.add(outputs[-1], data)
    return recorder.trace(), outputs, model


@pytest.fixture(scope="module")
def make_columns():
    """The script that writes docs/columns.md and the attributes of a Trace."""
    spec = importlib.util.spec_from_file_location("make_columns", ROOT / "docs" / "make_columns.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_trace_holds_the_columns_of_the_table_in_its_order_and_widths(cycles, walked):
    trace, _, model = cycles
    joints = model.nv - 6
    robot_sizes = {"joints": joints, "nv": joints + 6, "nv + 1": joints + 7}
    for record in (trace, walked):
        assert list(record) == [column.name for column in COLUMNS] == list(Trace.columns())
        for column in COLUMNS:
            width = column.width or robot_sizes[column.size]
            assert record[column.name].shape[1:] == ((width,) if width > 1 else ()), column.name


def test_parts_name_each_number_of_a_row():
    for column in COLUMNS:
        assert len(column.parts) in (0, column.width), column.name
        assert len(set(column.parts)) == len(column.parts), column.name
        assert (column.width or 0) <= 1 or column.parts, column.name


def test_cycle_output_has_the_decided_columns_and_no_other_numbers():
    properties = {name for name in dir(CycleOutput) if not name.startswith("_")}
    assert properties == {*DECIDED, "fresh", "fall_cause", "foreseen_time", "foreseen_cause"}


def test_each_property_of_cycle_output_tells_its_meaning_and_unit():
    for column in COLUMNS:
        if column.decided:
            text = getattr(CycleOutput, column.name).__doc__
            assert text.startswith(column.meaning), column.name
            assert not column.unit or f"[{column.unit}]" in text, column.name


@pytest.mark.parametrize("name", DECIDED)
def test_recorded_number_is_the_one_that_the_cycle_decided(cycles, name):
    trace, outputs, _ = cycles
    assert np.array_equal(trace[name], np.array([getattr(out, name) for out in outputs], float), equal_nan=True)


def test_what_the_step_shows_is_measured_and_not_decided(cycles):
    trace, outputs, _ = cycles
    for name in ("zmp_meas", "contact_wrench", "self_contacts", "joint_margin", "qpos", "qvel"):
        assert name not in DECIDED
        assert not hasattr(outputs[0], name)
        assert np.isfinite(trace[name][1:].reshape(59, -1)).any(axis=1).all(), name


@pytest.mark.parametrize("column", COLUMNS, ids=lambda column: column.name)
def test_meaning_is_a_sentence_with_unit_and_frame_in_the_words_of_notation(column):
    assert re.fullmatch(r"[A-Z].{15,}[^.]\.", column.meaning)
    assert column.frame in ("", "W", "H", "S", "B")
    assert set(re.split(", | or ", column.unit)) <= {"", "m", "m/s", "m/s^2", "rad", "rad/s", "s", "N", "N m"}
    assert not hasattr(Trace, column.name), "an attribute of Trace hides the column"


def test_docs_page_shows_the_table(make_columns):
    page = (ROOT / "docs" / "columns.md").read_text(encoding="utf-8")
    table = re.search(r"<!-- columns -->\n(.*?)\n<!-- end -->", page, re.DOTALL).group(1)
    assert table.splitlines() == make_columns.page_rows(), "run `make columns`"


def test_type_checkers_know_the_columns_of_the_table(make_columns):
    assert make_columns.ATTRIBUTES.read_text(encoding="utf-8") == make_columns.attributes(), "run `make columns`"
    assert list(Trace.__mro__[1].__annotations__) == list(Trace.columns())


def test_a_trace_describes_its_columns_and_those_of_others(made_up_trace, made_up_columns):
    text = made_up_trace.describe()
    assert "zmp_est (8000, 2): x, y [m] in W\n    ZMP that the torque of this cycle will produce" in text
    assert "qpos (8000, 32): nv + 1 numbers [m, rad] in W\n" in text
    mine = Trace({**made_up_columns, "mine": np.zeros(8000)}).describe()
    assert "mine (8000,)\n    This column is not one that zmpwalk records." in mine
