"""Robots, loaded by name or file, described by hand in a `robot.json`, or found in a model.

`load` leads to all of them; `description` is what the walk needs to know of a robot, as a value; `proposal` finds that
in a model that nobody has marked. The files of the robots that come with zmpwalk lie here too.
"""

from .description import (
    Foot,
    RobotDescription,
    description_from_dict,
    description_to_dict,
    read_description,
    sole_pose,
)
from .load import ROBOTS, Robot, available_robots, examine, load_robot, robot_file
from .proposal import Proposal, appraise, describe, is_marked, propose, write_description

__all__ = [
    "ROBOTS",
    "Foot",
    "Proposal",
    "Robot",
    "RobotDescription",
    "appraise",
    "available_robots",
    "describe",
    "description_from_dict",
    "description_to_dict",
    "examine",
    "is_marked",
    "load_robot",
    "propose",
    "read_description",
    "robot_file",
    "sole_pose",
    "write_description",
]
