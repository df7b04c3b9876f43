"""The bundled robot's MJCF as a text that tests change."""

import re

from zmpwalk.robots import robot_file

TEXT = robot_file("mahru").read_text()


def edited(*changes):
    """The text, each (old, new) replaced."""
    text = TEXT
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return text


def bare(text):
    """Without sole sites and keyframe, as a stranger's file: its feet have to be found."""
    text = re.sub(r'<site[^>]*_sole"[^>]*/>', "", text)
    return re.sub(r"<keyframe>.*?</keyframe>", "", text, flags=re.DOTALL)
