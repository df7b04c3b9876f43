"""The record of instructions holds what is counted, and every count has a limit: benchmarks/instructions.py."""

import json

import instructions
import pytest


@pytest.fixture
def names(monkeypatch):
    monkeypatch.setattr(instructions, "count", lambda program, *words: 1.0)
    return list(instructions.counts_of("cycle"))


@pytest.fixture
def record():
    return json.loads(instructions.RECORD.read_text())


def test_record_has_every_count_and_no_other(names, record):
    assert list(record["counts"]) == names
    assert all(list(counts) == names for counts in record["history"].values())


def test_limits_are_those_of_a_cycle_in_the_loop_and_from_scratch_and_half_of_an_earlier_plan(names, record):
    limits = {name: instructions.limit_of(name, record["history"]) for name in names}
    assert limits["in_loop, single support"] == limits["in_loop, double support"] == 43_100
    assert limits["from_scratch, single support"] == 200_000
    assert limits[instructions.PLAN] == 0.5 * record["history"][instructions.BEFORE][instructions.PLAN]


@pytest.mark.parametrize(
    ("compiler", "factor", "exit_code", "words"),
    [
        ("GNU 12.2.0", 1.0, 0, "+0.0 %"),
        ("GNU 12.2.0", 1.06, 1, "CHANGED"),
        ("GNU 12.2.0", 100.0, 1, "MORE THAN"),
        ("another", 1.06, 0, "recorded with GNU"),
        ("another", 100.0, 1, "MORE THAN"),
    ],
)
def test_check_fails_above_a_limit_and_with_the_records_compiler_at_a_change(
    tmp_path, monkeypatch, capsys, record, compiler, factor, exit_code, words
):
    small = dict.fromkeys(record["counts"], 1000)
    record.update(compiler="GNU 12.2.0", counts=small)
    file = tmp_path / "instructions.json"
    file.write_text(json.dumps(record))
    monkeypatch.setattr(instructions, "RECORD", file)
    monkeypatch.setattr(instructions, "counts_of", lambda program: {name: round(1000 * factor) for name in small})
    monkeypatch.setattr(instructions, "LIMITS", {"in_loop": 2000, "from_scratch": 2000, "plan": 0.5})
    monkeypatch.setattr(instructions.shutil, "which", lambda program: program)
    monkeypatch.setattr("sys.argv", ["instructions.py", "cycle", compiler])
    assert instructions.main() == exit_code
    assert words in capsys.readouterr().out
