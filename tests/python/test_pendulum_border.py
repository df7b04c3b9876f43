"""Equations 16-18 as Python sees them, and that (16) as printed is not the pendulum."""

import numpy as np
import pytest
from zmpwalk import InputError, LinearInvertedPendulum

Z_C = 0.747  # [m]: T_c = 0.276 s, whose 1 / T_c is far from 1


@pytest.fixture
def pendulum():
    return LinearInvertedPendulum(Z_C)


def corrected(pendulum):
    return pendulum.step


def printed(pendulum):
    """(16) with the 1/T_c that the paper prints before the last term."""

    def step(dt, x, v, r):
        Tc = pendulum.Tc
        ch, sh = np.cosh(dt / Tc), np.sinh(dt / Tc)
        return ch * x + sh * Tc * v - (ch - 1) / Tc * r, (sh * x + ch * Tc * v - sh / Tc * r) / Tc

    return step


def assert_pendulum_equation_holds(step, Tc):
    x, v, r, h = 0.03, 0.2, -0.09, 1e-4
    (ahead, _), (back, _) = step(h, x, v, r), step(-h, x, v, r)
    assert (ahead - 2 * x + back) / h**2 == pytest.approx((x - r) / Tc**2, abs=1e-5)


def assert_mass_over_the_reference_stays_there(step):
    assert step(0.3, 0.05, 0.0, 0.05) == pytest.approx((0.05, 0.0), abs=1e-12)


def assert_orbital_energy_is_kept(step, Tc):
    def energy(x, v, r):
        return v**2 / 2 - (x - r) ** 2 / (2 * Tc**2)

    x, v, r = -0.05, 0.3, 0.04
    assert energy(*step(0.4, x, v, r), r) == pytest.approx(energy(x, v, r), abs=1e-12)


CHECKS = [
    assert_pendulum_equation_holds,
    lambda step, Tc: assert_mass_over_the_reference_stays_there(step),
    assert_orbital_energy_is_kept,
]
NAMES = ["equation", "equilibrium", "energy"]


@pytest.mark.parametrize("check", CHECKS, ids=NAMES)
def test_equation_16_is_the_pendulum(pendulum, check):
    check(corrected(pendulum), pendulum.Tc)


@pytest.mark.parametrize("check", CHECKS, ids=NAMES)
def test_equation_16_as_printed_is_not(pendulum, check):
    with pytest.raises(AssertionError):
        check(printed(pendulum), pendulum.Tc)


def test_equation_16_as_printed_is_the_pendulum_about_another_reference(pendulum):
    """So it composes as a pendulum does, but puts the ZMP 1 / T_c = 3.6 times too far from the support."""
    state = (0.02, 0.25)
    assert printed(pendulum)(0.16, *state, -0.02) == pytest.approx(pendulum.step(0.16, *state, -0.02 / pendulum.Tc))
    assert 1 / pendulum.Tc == pytest.approx(3.62, abs=0.01)


def test_many_short_steps_are_one_long(pendulum):
    x, v, r, dt, n = 0.02, 0.25, -0.09, 0.001, 160
    whole = pendulum.step(n * dt, x, v, r)
    for _ in range(n):
        x, v = pendulum.step(dt, x, v, r)
    assert (x, v) == pytest.approx(whole, abs=1e-12)


def test_printed_and_corrected_agree_where_the_time_constant_is_one_second():
    pendulum = LinearInvertedPendulum(z_c=9.81, gravity=9.81)  # which is how the misprint can hide
    assert printed(pendulum)(0.1, 0.02, 0.3, -0.09) == pytest.approx(pendulum.step(0.1, 0.02, 0.3, -0.09), abs=1e-14)


def test_equation_17_is_16_about_zero_and_18_its_velocity(pendulum):
    for y, w, T in ((-0.11, 0.3, 0.4), (0.05, -0.2, 0.06)):
        assert pendulum.step_lateral(T, y, w) == pendulum.step(T, y, w, 0.0)
        assert pendulum.velocity_after(T, y, w) == pytest.approx(pendulum.step_lateral(T, y, w)[1], abs=1e-14)


def test_time_constant_is_the_root_of_height_over_gravity(pendulum):
    assert pendulum.Tc == pytest.approx(np.sqrt(Z_C / 9.81), abs=1e-15)
    assert pendulum.omega == pytest.approx(1 / pendulum.Tc)


def test_reference_that_gives_an_acceleration_gives_it(pendulum):
    r = pendulum.reference_for(0.03, -0.4)
    assert pendulum.acceleration(0.03, r) == pytest.approx(-0.4, abs=1e-14)


def test_reference_brings_the_dcm_where_it_is_wanted(pendulum):
    x, v, time, wanted = 0.02, -0.1, 0.3, 0.07
    r = pendulum.reference_to_reach(pendulum.dcm(x, v), wanted, time)
    assert pendulum.dcm(*pendulum.step(time, x, v, r)) == pytest.approx(wanted, abs=1e-12)


def test_first_double_support_starts_the_symmetric_orbit_from_rest(pendulum):
    """ZMP for t_1 on the foot that swings first, then on the other; at rest in the middle of the single support."""
    period, T_ss, width = 0.8, 0.64, 0.22
    first = pendulum.first_double_support(period=period, T_ss=T_ss)
    assert first == pytest.approx(0.1806, abs=5e-5)
    assert LinearInvertedPendulum(0.45).first_double_support(period, T_ss) == pytest.approx(0.163, abs=5e-4)
    rest = first + T_ss / 2  # middle of the first single support
    low, high = 0.0, rest
    for _ in range(60):  # the switch time at which the mass is at rest then
        t_1 = (low + high) / 2
        y, w = pendulum.step(t_1, 0.0, 0.0, -width / 2)
        w = pendulum.velocity_after(rest - t_1, y - width / 2, w)
        low, high = (low, t_1) if w > 0 else (t_1, high)
    assert t_1 == pytest.approx(0.172, abs=5e-4)
    y, w = pendulum.step(t_1, 0.0, 0.0, -width / 2)
    amplitude = width / 2 - pendulum.step(rest - t_1, y, w, width / 2)[0]
    repeats = width / 2 / np.cosh(period / 2 / pendulum.Tc)
    assert amplitude == pytest.approx(repeats, abs=1e-9)


@pytest.mark.parametrize("z_c", [0.0, -1.0, float("nan"), float("inf")])
def test_height_must_be_positive_and_finite(z_c):
    with pytest.raises(InputError, match="z_c"):
        LinearInvertedPendulum(z_c)


def test_keywords_are_the_names_of_the_equations(pendulum):
    assert pendulum.step(dt=0.001, x=0.0, v=0.25, r=-0.09) == pendulum.step(0.001, 0.0, 0.25, -0.09)
    assert pendulum.velocity_after(T=0.1, y=0.0, w=0.2) == pendulum.velocity_after(0.1, 0.0, 0.2)
    with pytest.raises(TypeError):
        pendulum.step(0.001, 0.0, "fast", -0.09)
