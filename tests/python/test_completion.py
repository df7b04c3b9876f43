"""What the shell offers at the Tab key."""

import os

import pytest


@pytest.mark.parametrize(
    ("line", "offered"),
    [
        ("zmpwalk pu", {"push-map"}),
        ("zmpwalk walk --robot mah", {"mahru"}),
        ("zmpwalk walk --set tracking.ga", {"tracking.gain="}),
        ("zmpwalk walk --set first_swing=", {"first_swing=right", "first_swing=left"}),
        ("zmpwalk walk --set command.limit=", {"command.limit=true", "command.limit=false"}),
        ("zmpwalk walk --set no_setting=", set()),
        ("zmpwalk walk --terrain sl", {"slope:"}),
        ("zmpwalk walk --footsteps ti", {"tied"}),
        ("zmpwalk walk --law pa", {"paper"}),
        ("zmpwalk walk --uncertain torque", {"torque_delay="}),
        ("zmpwalk plot --figure sa", {"sagittal"}),
        ("zmpwalk plot --format p", {"png", "pdf"}),
    ],
)
def test_the_shell_offers_what_can_stand_there(zmpwalk_command, line, offered):
    words = line.split()
    told = {"COMP_WORDS": line, "COMP_CWORD": str(len(words) - 1), "_ZMPWALK_COMPLETE": "bash_complete"}
    done = zmpwalk_command(env={**os.environ, **told})
    assert done.returncode == 0, done.stderr
    found = [answer.split(",", 1) for answer in done.stdout.split()]
    assert {word for kind, word in found if kind == "plain"} == offered


def test_paths_are_left_to_the_shell(zmpwalk_command):
    told = {"COMP_WORDS": "zmpwalk plot out/", "COMP_CWORD": "2", "_ZMPWALK_COMPLETE": "bash_complete"}
    assert zmpwalk_command(env={**os.environ, **told}).stdout == "file,out/\n"
