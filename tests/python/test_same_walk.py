"""The comparison of walks finds any bit: benchmarks/same_walk.py."""

import numpy as np
import pytest
from same_walk import first_difference


@pytest.fixture
def walk():
    rng = np.random.default_rng(1)
    return {"t": 0.001 * np.arange(50), "com": rng.normal(size=(50, 3)), "w_T": np.full(50, np.nan)}


def changed(walk, column, place, value):
    other = {name: values.copy() for name, values in walk.items()}
    other[column][place] = value
    return other


def test_a_walk_is_equal_to_its_copy_with_nan_where_it_has_nan(walk):
    assert first_difference(walk, changed(walk, "w_T", 3, -np.nan)) is None


def test_one_bit_in_one_row_is_found(walk):
    nudged = np.nextafter(walk["com"][17, 2], 10.0)
    found = first_difference(walk, changed(walk, "com", (17, 2), nudged))
    assert (found.row, found.column, found.largest_column) == (17, "com", "com")
    assert found.first == found.largest == abs(nudged - walk["com"][17, 2]) > 0


def test_the_sign_of_zero_is_a_bit(walk):
    assert first_difference(walk, changed(walk, "t", 0, -0.0)).row == 0


def test_the_first_row_is_named_and_the_largest_difference_with_its_column(walk):
    other = changed(walk, "t", 9, 7.0)
    other["com"][4, 0] += 1e-6
    found = first_difference(walk, other)
    assert (found.row, found.column, found.largest_column) == (4, "com", "t")
    assert found.first == pytest.approx(1e-6) and found.largest == pytest.approx(7.0, abs=0.1)


def test_nan_that_only_one_walk_has_is_a_difference(walk):
    found = first_difference(walk, changed(walk, "w_T", 5, 0.0))
    assert (found.row, found.column, found.largest) == (5, "w_T", np.inf)


def test_a_walk_that_ends_earlier_differs_where_it_ends(walk):
    shorter = {name: values[:30] for name, values in walk.items()}
    assert first_difference(walk, shorter).row == 30


def test_columns_that_only_one_walk_has_are_not_compared(walk):
    assert first_difference(walk, {**walk, "new": np.zeros(50)}) is None
    assert first_difference({**walk, "old": np.zeros(50)}, walk) is None
