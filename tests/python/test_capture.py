"""The pendulum's limit: the table of what place, time and crossing are worth, and what must hold of any such limit."""

import math

import numpy as np
import pytest
import zmpwalk
from zmpwalk import InputError, PendulumWalk, pendulum_limit

WALK = PendulumWalk(
    Tc=0.2759, sole=(0.25, 0.14), step_width=0.22, velocity=0.25, period=0.8, double_support=0.16
)  # 62.9 kg, z_c 0.747 m
# Largest impulse [N s/kg] over the phases of single support: forward, the worse of both outward diagonals, outwards,
# backward, inwards. The first row is of an impulse, changes feet at once and stands on the next foot.
TABLE = {
    "place": ({"timing": False, "later_steps": False, "double_support": 0.0, "push_time": 0.0},
              [0.50, 0.36, 0.24, 0.54, 0.30]),
    "place and time": ({}, [1.32, 0.42, 0.30, 1.52, 0.88]),
    "place and time, quick": ({"period": 0.54, "double_support": 0.10}, [1.28, 0.50, 0.36, 1.50, 0.84]),
    "crossing, whole sole": ({"crossing": True, "sole_share": 1.0}, [1.36, 1.12, 0.80, 1.54, 1.18]),
}  # fmt: skip


def worst(directions, **changes):
    period, double = changes.get("period", WALK.period), changes.get("double_support", WALK.double_support)
    phases = [i / 8 for i in range(8) if i / 8 * period <= period - double + 1e-9]
    return pendulum_limit(WALK, directions, phases, **changes).min(axis=0)


@pytest.mark.parametrize("name", TABLE)
def test_limit_is_that_of_the_table(name):
    changes, table = TABLE[name]
    forward, left, right, outwards, backward, inwards = worst([0, 45, 135, 90, 180, 270], **changes)
    np.testing.assert_allclose([forward, min(left, right), outwards, backward, inwards], table, rtol=0.05)


def test_outwards_at_a_lift_off_the_dcm_reaches_the_edge_of_the_sole():
    half_a_double_support = math.exp(0.08 / WALK.Tc)
    dcm = WALK.step_width / (math.exp(WALK.period / WALK.Tc) + 1.0) * half_a_double_support  # inwards of the foot
    edge = 0.5 * 0.95 * WALK.sole[1]
    limit = pendulum_limit(WALK, [90], [0.0])[0, 0]
    assert limit == pytest.approx((edge + dcm) / WALK.Tc, rel=0.01)


def test_what_is_allowed_besides_never_lowers_the_limit():
    base = pendulum_limit(WALK)
    for more in ({"crossing": True}, {"sole_share": 1.0}, {"reach_forward": 0.6}, {"reach_sideways": 0.6},
                 {"shortest": 0.2}):  # fmt: skip
        assert np.all(pendulum_limit(WALK, **more) >= base - 1e-3), more
    assert np.all(pendulum_limit(WALK, timing=False)[:7] <= base[:7] + 1e-3)


def test_double_support_is_judged_for_the_foot_that_carries_next():
    limit = pendulum_limit(WALK, [0, 90, 180, 270], [0.0, 0.95])
    np.testing.assert_array_equal(limit[1], limit[0][[0, 3, 2, 1]])


def test_a_robot_that_stands_has_one_phase_and_two_equal_sides():
    limit = pendulum_limit(WALK, 12, 8, velocity=0.0)
    assert limit.shape == (1, 12)
    np.testing.assert_allclose(limit[0, 1:6], limit[0, :6:-1])


def test_the_reach_of_a_robot_is_that_of_the_bundled_one_times_the_length_of_its_legs():
    ours = PendulumWalk.of("mahru")
    assert (ours.reach_forward, ours.reach_sideways) == (pytest.approx(0.45), pytest.approx(0.50))
    assert (ours.sole, ours.step_width, ours.period) == ((0.25, 0.14), 0.22, pytest.approx(0.8))
    assert ours.Tc == pytest.approx(WALK.Tc, abs=1e-3)


@pytest.mark.parametrize("wrong", [{"shortest": 0.0}, {"Tc": math.nan}, {"double_support": 0.9}])
def test_an_assumption_that_makes_no_sense_is_refused(wrong):
    with pytest.raises(InputError, match=next(iter(wrong))):
        pendulum_limit(WALK, **wrong)


def test_an_unknown_assumption_is_refused():
    with pytest.raises(InputError, match="hop"):
        zmpwalk.PendulumWalk.of("mahru", hop=True)
