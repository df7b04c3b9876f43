"""A function's fingerprint: it changes with the code and with what the code reads, and with nothing else."""

import functools
import os
import subprocess
import sys

import numpy as np
import pytest
from zmpwalk.functions import fingerprint

SOURCE = """
import math

import numpy as np

FACTOR = 2.0
TABLE = {"a": [1, 2]}


def helper(x):
    return x + 1


class Called:
    def __init__(self, gain):
        self.gain = gain

    def __call__(self, trace):
        return {"a": self.gain}


def measure(trace, scale=1.0):
    "Docstring."
    inner = [helper(v) * FACTOR for v in TABLE["a"]]
    return {"a": max(inner) * scale * math.pi, "b": "word" in {"word", "other", "third"}}
"""


def made(source=SOURCE, name="measure"):
    scope = {"__name__": "study"}
    exec(compile(source, "study.py", "exec"), scope)
    return scope[name]


def test_the_same_code_has_the_same_fingerprint_in_another_process():
    script = (
        "from zmpwalk.functions import fingerprint\n"
        f"scope = {{'__name__': 'study'}}\nexec({SOURCE!r}, scope)\nprint(fingerprint(scope['measure']))"
    )
    seeds = ("1", "2")  # of the order of sets
    found = {
        subprocess.run(
            [sys.executable, "-c", script],
            env={**os.environ, "PYTHONHASHSEED": seed},
            check=True,
            capture_output=True,
            text=True,
        ).stdout.strip()
        for seed in seeds
    }
    assert found == {fingerprint(made())}


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("x + 1", "x + 2"),
        ("x + 1", "x - 1"),
        ("FACTOR = 2.0", "FACTOR = 2.5"),
        ("[1, 2]", "[1, 3]"),
        ("scale=1.0", "scale=2.0"),
        ("max(inner)", "min(inner)"),
        ('"a": max', '"c": max'),
        ("math.pi", "math.e"),
        ("third", "fourth"),
    ],
)
def test_a_change_of_what_is_computed_changes_it(before, after):
    assert SOURCE.count(before) == 1
    assert fingerprint(made(SOURCE.replace(before, after))) != fingerprint(made())


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("Docstring.", "Another docstring."),
        ("return x + 1", "# a comment\n    return x + 1"),
        ("import math\n", "import math\n\n\nUNUSED = 3\n"),
    ],
)
def test_what_is_not_computed_does_not(before, after):
    assert fingerprint(made(SOURCE.replace(before, after))) == fingerprint(made())


def test_closures_arrays_partials_methods_and_objects_are_looked_into():
    def of(value):
        return lambda trace: {"a": value}

    for one, other in [(1, 2), (1, 1.0), (np.arange(3), np.arange(1, 4)), ({"a": 1}, {"a": 2}), ({1}, {2})]:
        assert fingerprint(of(one)) != fingerprint(of(other))
        assert fingerprint(of(one)) == fingerprint(of(one))
    measure, called = made(), made(name="Called")
    assert fingerprint(functools.partial(measure, scale=2.0)) != fingerprint(functools.partial(measure, scale=3.0))
    assert fingerprint(called(1.0)) != fingerprint(called(2.0))
    assert fingerprint(called(1.0)) == fingerprint(called(1.0))
    assert fingerprint(called(1.0).__call__) != fingerprint(called(2.0).__call__)


def test_what_another_module_gives_is_known_by_its_name():
    assert fingerprint(lambda trace: np.mean(trace)) != fingerprint(lambda trace: np.median(trace))
    assert fingerprint(len) == fingerprint(len) != fingerprint(max)


def test_functions_that_call_each_other_end():
    source = "def a(t):\n    return b(t)\n\n\ndef b(t):\n    return a(t)\n"
    assert fingerprint(made(source, "a")) != fingerprint(made(source.replace("b(t)\n\n", "b(t) + 1\n\n"), "a"))
