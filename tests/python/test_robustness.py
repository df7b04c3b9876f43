"""The table of what a walk bears."""

import csv
import math

import pytest
from zmpwalk import InputError, robustness
from zmpwalk.troubles import Trouble


def test_borne_is_the_hardest_level_up_to_which_all_stood():
    trouble = Trouble("lag", "s", (1.0, 2.0, 3.0, 4.0), (1.0, 1.0, 0.5, 1.0), 2.0)
    assert (trouble.borne, trouble.passes) == (2.0, True)
    falling = Trouble("friction", "", (0.6, 0.4, 0.2), (1.0, 1.0, 0.0), 0.2)
    assert (falling.borne, falling.passes) == (0.4, False)
    none = Trouble("noise", "", (1.0, 2.0), (0.0, 0.0), math.nan)
    assert (math.isnan(none.borne), none.passes) == (True, None)


def test_a_short_table_as_text_csv_and_figure(tmp_path):
    seen = []
    found = robustness(duration=5.0, only=["drive lag", "ground friction"], on_progress=lambda *at: seen.append(at))
    assert [trouble.name for trouble in found.troubles] == ["drive lag", "ground friction"]
    assert found["drive lag"].borne >= 0.010
    assert found["ground friction"].borne <= 0.3
    assert seen[-1] == (12, 12)
    assert "drive lag [s]" in str(found)
    with open(found.to_csv(tmp_path / "table.csv"), encoding="utf-8") as file:
        assert len(list(csv.DictReader(file))) == 12
    assert [label.get_text() for label in found.plot().axes[0].get_yticklabels()] == [
        "drive lag [s]",
        "ground friction",
    ]


@pytest.mark.parametrize(("wrong", "words"), [({"velocity": 0.0}, "velocity"), ({"duration": 1.0}, "at least 4 s"),
                                              ({"only": ["hail"]}, "drive lag")])  # fmt: skip
def test_arguments_that_make_no_sense_are_refused(wrong, words):
    with pytest.raises(InputError, match=words):
        robustness(**wrong)


def test_the_command_writes_table_and_figure(zmpwalk_command, tmp_path):
    done = zmpwalk_command("robustness", "--duration", 4, "--only", "control rate", "--out", tmp_path)
    assert done.returncode == 0, done.stderr
    assert {file.name for file in tmp_path.iterdir()} == {"robustness.csv", "robustness.png"}
    assert "control rate [Hz]" in done.stdout
