#include <cmath>

#include "testing.hpp"
#include "zmpwalk/gait/pendulum.hpp"
#include "zmpwalk/math/error.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

constexpr double kGravity = 9.81;
const LinearInvertedPendulum pendulum(0.747, kGravity);
const PendulumState start{0.04, -0.3};

/// Eq. 16 as it is printed, with 1/T_c before the last term.
PendulumState printed_step(double dt, const PendulumState& s, double r) {
  const double Tc = pendulum.Tc(), ch = std::cosh(dt / Tc), sh = std::sinh(dt / Tc);
  return {ch * s.x + sh * Tc * s.v - (ch - 1.0) * r / Tc, (sh * s.x + ch * Tc * s.v - sh * r / Tc) / Tc};
}

/// Largest violation of x' = v and v' = (x - r) / T_c^2 along a motion, by central differences.
template <class Step>
double violation(Step&& step, double r) {
  const double h = 1e-5;
  double worst = 0.0;
  for (double t = 0.05; t < 0.8; t += 0.05) {
    const PendulumState before = step(t - h, start, r), now = step(t, start, r), after = step(t + h, start, r);
    worst = std::max(worst, gap((after.x - before.x) / (2 * h), now.v));
    worst = std::max(worst, gap((after.v - before.v) / (2 * h), pendulum.acceleration(now.x, r)));
  }
  return worst;
}

/// Largest difference between 40 steps of dt and one of 40 dt.
template <class Step>
double discord(Step&& step, double r) {
  PendulumState s = start;
  for (int i = 0; i < 40; ++i) s = step(0.02, s, r);
  const PendulumState once = step(0.8, start, r);
  return std::max(gap(s.x, once.x), gap(s.v, once.v));
}

/// v^2/2 - (x - r)^2 / (2 T_c^2): constant under a constant reference.
double orbital_energy(const PendulumState& s, double r) {
  return 0.5 * (s.v * s.v - std::pow((s.x - r) / pendulum.Tc(), 2));
}

const auto step = [](double dt, const PendulumState& s, double r) { return pendulum.step(dt, s, r); };

}  // namespace

BOOST_AUTO_TEST_CASE(time_constant_is_the_root_of_height_over_gravity) {
  CHECK_NEAR(pendulum.Tc(), std::sqrt(0.747 / 9.81), 1e-15);
  CHECK_NEAR(pendulum.omega() * pendulum.Tc(), 1.0, 1e-15);
  CHECK_THROWS(LinearInvertedPendulum(0.0, 9.81), InputError, "z_c = 0.000000");
  CHECK_THROWS(LinearInvertedPendulum(0.7, -9.81), InputError, "gravity = -9.81");
  CHECK_THROWS(LinearInvertedPendulum(kNaN, 9.81), InputError, "z_c = nan");
}

BOOST_AUTO_TEST_CASE(one_step_by_hand) {
  // T_c = 1 and dt = ln 2: ch = 5/4, sh = 3/4.
  const LinearInvertedPendulum unit(2.0, 2.0);
  const PendulumState s = unit.step(std::log(2.0), {1.0, 2.0}, 4.0);
  CHECK_NEAR(s.x, 1.25 * 1.0 + 0.75 * 2.0 - 0.25 * 4.0, 1e-15);
  CHECK_NEAR(s.v, 0.75 * 1.0 + 1.25 * 2.0 - 0.75 * 4.0, 1e-15);
  CHECK_NEAR(unit.velocity_after(std::log(2.0), {1.0, 2.0}), 0.75 + 2.5, 1e-15);
}

BOOST_AUTO_TEST_CASE(functions_of_a_time_that_are_kept_follow_the_pendulum_and_the_time) {
  LastOver over;
  const LinearInvertedPendulum other(0.7, kGravity);
  for (const LinearInvertedPendulum* p : {&pendulum, &pendulum, &other, &pendulum})
    for (const double dt : {0.001, 0.001, 0.01}) {
      const PendulumState a = p->step(over(*p, dt), start, 0.05), b = p->step(dt, start, 0.05);
      BOOST_CHECK_EQUAL(a.x, b.x);
      BOOST_CHECK_EQUAL(a.v, b.v);
    }
}

BOOST_AUTO_TEST_CASE(step_satisfies_the_differential_equation_of_the_pendulum) {
  for (const double r : {-0.09, 0.0, 0.05}) BOOST_CHECK_LE(violation(step, r), 1e-7);
}

BOOST_AUTO_TEST_CASE(many_short_steps_are_one_long_step) {
  for (const double r : {-0.09, 0.0, 0.05}) BOOST_CHECK_LE(discord(step, r), 1e-12);
}

BOOST_AUTO_TEST_CASE(orbital_energy_is_kept) {
  for (const double r : {-0.09, 0.0, 0.05}) {
    const double energy = orbital_energy(start, r);
    for (double t = 0.1; t < 0.8; t += 0.1) CHECK_NEAR(orbital_energy(pendulum.step(t, start, r), r), energy, 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(the_printed_form_of_16_fails_these_checks) {
  const double r = 0.05;
  BOOST_CHECK_GE(violation(printed_step, r), 0.5);  // m/s^2
  const PendulumState late = printed_step(0.4, start, r);
  BOOST_CHECK_GE(std::abs(orbital_energy(late, r) - orbital_energy(start, r)), 0.01);
}

BOOST_AUTO_TEST_CASE(printed_16_moves_a_mass_that_rests_over_its_reference) {
  CHECK_NEAR(pendulum.step(0.1, {0.05, 0.0}, 0.05).v, 0.0, 1e-15);
  BOOST_CHECK_GE(std::abs(printed_step(0.1, {0.05, 0.0}, 0.05).v), 0.1);
}

BOOST_AUTO_TEST_CASE(lateral_step_17_is_16_about_a_zero_reference) {
  for (const double dt : {0.001, 0.1, 0.64}) {
    const PendulumState a = pendulum.step_lateral(dt, start), b = pendulum.step(dt, start, 0.0);
    BOOST_CHECK_EQUAL(a.x, b.x);
    BOOST_CHECK_EQUAL(a.v, b.v);
  }
}

BOOST_AUTO_TEST_CASE(expected_velocity_18_is_the_velocity_of_17) {
  for (const double T : {0.001, 0.1, 0.48})
    CHECK_NEAR(pendulum.velocity_after(T, start), pendulum.step_lateral(T, start).v, 1e-13);
}

BOOST_AUTO_TEST_CASE(reference_for_an_acceleration_gives_that_acceleration) {
  CHECK_NEAR(pendulum.acceleration(0.03, pendulum.reference_for(0.03, 1.7)), 1.7, 1e-13);
}

BOOST_AUTO_TEST_CASE(dcm_leaves_the_reference_exponentially) {
  const double r = 0.02;
  for (const double t : {0.1, 0.5})
    CHECK_NEAR(pendulum.dcm(pendulum.step(t, start, r)) - r, (pendulum.dcm(start) - r) * std::exp(t / pendulum.Tc()),
               1e-13);
}

BOOST_AUTO_TEST_CASE(reference_to_reach_brings_the_dcm_there_in_time) {
  for (const double time : {0.05, 0.3}) {
    const double r = pendulum.reference_to_reach(pendulum.dcm(start), 0.11, time);
    CHECK_NEAR(pendulum.dcm(pendulum.step(time, start, r)), 0.11, 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(dcm_of_the_orbit_returns_mirrored_after_a_period) {
  // About the foot to come xi = -orbit_inset, about the next one it is +orbit_inset a period later, `width` to the other side.
  const double width = 0.22, period = 0.8, inset = pendulum.orbit_inset(width, period);
  CHECK_NEAR(-inset * std::exp(period / pendulum.Tc()), -(width - inset), 1e-12);
}

BOOST_AUTO_TEST_CASE(pendulum_over_alternating_feet_that_drift_repeats_the_orbit) {
  for (const double drift : {0.0, 0.05, -0.12})
    for (const double period : {0.45, 0.8}) {
      const double width = 0.22 + std::abs(drift);
      const auto foot = [&](int n) { return n * drift + (n % 2 ? -0.5 : 0.5) * width; };
      const auto orbit = [&](int n) {  // DCM in the middle of the double support before foot n carries the ZMP
        return foot(n) - (n % 2 ? -1 : 1) * pendulum.orbit_inset(width, period) + pendulum.orbit_offset(drift, period);
      };
      PendulumState s{0.0, 0.0};
      for (int n = 0; n < 24; ++n) {
        s.v = (orbit(n) - s.x) / pendulum.Tc();  // what rounding adds to the DCM grows; everything else decays
        const PendulumState middle = pendulum.step(0.5 * period, s, foot(n));
        s = pendulum.step(0.5 * period, middle, foot(n));
        CHECK_NEAR(pendulum.dcm(s), orbit(n + 1), 1e-12);
        if (n > 20) CHECK_NEAR(middle.v, pendulum.orbit_velocity(drift, period), 1e-12);
      }
    }
}

BOOST_AUTO_TEST_CASE(first_double_support_is_as_long_as_published_and_grows_with_the_robot) {
  CHECK_NEAR(pendulum.first_double_support(0.8, 0.64), 0.1806, 1e-3);
  // At the height that fits the paper's 0.16 s; there its Fig. 5 has the switch at 0.142 s.
  CHECK_NEAR(LinearInvertedPendulum(0.45, kGravity).first_double_support(0.8, 0.64), 0.163, 1e-3);
}

BOOST_AUTO_TEST_CASE(first_double_support_starts_an_orbit_that_repeats) {
  const double width = 0.22, period = 0.8, T_ss = 0.64, T_ds_first = pendulum.first_double_support(period, T_ss);
  // From rest between the feet, reference on the right foot. Switch where (18) says the next single support's middle is at rest.
  const double right = -0.5 * width, left = 0.5 * width, mid_single = T_ds_first + 0.5 * T_ss;
  const auto rest_after = [&](double t_1) {
    PendulumState s = pendulum.step(t_1, {0.0, 0.0}, right);
    s.x -= left;
    return pendulum.velocity_after(mid_single - t_1, s);
  };
  double low = 0.0, high = T_ds_first;
  BOOST_REQUIRE(rest_after(low) * rest_after(high) < 0.0);
  for (int i = 0; i < 60; ++i)
    (rest_after(0.5 * (low + high)) > 0.0) == (rest_after(low) > 0.0) ? low = 0.5 * (low + high)
                                                                      : high = 0.5 * (low + high);
  CHECK_NEAR(low, 0.172, 1e-3);
  PendulumState s = pendulum.step(mid_single - low, pendulum.step(low, {0.0, 0.0}, right), left);
  CHECK_NEAR(s.v, 0.0, 1e-9);
  // From there the switch in the middle of each double support mirrors the apex, step after step.
  for (int n = 0; n < 4; ++n) {
    const double here = n % 2 ? right : left, there = -here, apex = s.x;
    s = pendulum.step(0.5 * period, s, here);
    CHECK_NEAR(s.x, 0.0, 1e-8);  // rounding grows by exp(period / T_c) = 18 a step
    s = pendulum.step(0.5 * period, s, there);
    CHECK_NEAR(s.v, 0.0, 1e-8);
    CHECK_NEAR(s.x, -apex, 1e-8);
  }
}
