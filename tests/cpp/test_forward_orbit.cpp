#include <algorithm>
#include <cmath>
#include <vector>

#include "testing.hpp"
#include "zmpwalk/gait/forward_orbit.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

const LinearInvertedPendulum pendulum(0.747, 9.81);
const double Tc = pendulum.Tc();

struct Walk {
  double v, period, roll;
  double half() const { return 0.5 * v * period; }  // L/2
  ForwardOrbit orbit() const { return {pendulum, v, period, roll}; }
};

/// Steps longer than the ZMP's travel, ahead and back, slow and fast, with much roll and with none.
std::vector<Walk> long_steps() {
  std::vector<Walk> out;
  for (const double period : {0.35, 0.8, 1.1})
    for (const double L : {0.02, 0.3, 0.7})
      for (const double share : {0.0, 0.1, 0.5, 0.99})
        for (const double sign : {-1.0, 1.0}) out.push_back({sign * L / period, period, share * 0.5 * L});
  return out;
}

/// x'' = (x - r) / T_c^2, its ZMP under the COM as far as `roll`, over `time` by Runge and Kutta.
PendulumState moved(PendulumState s, double roll, double time) {
  const auto a = [&](double x) { return pendulum.acceleration(x, std::clamp(x, -roll, roll)); };
  constexpr int kSteps = 4000;
  const double h = time / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const double v_1 = s.v, a_1 = a(s.x), v_2 = s.v + 0.5 * h * a_1, a_2 = a(s.x + 0.5 * h * v_1),
                 v_3 = s.v + 0.5 * h * a_2, a_3 = a(s.x + 0.5 * h * v_2), v_4 = s.v + h * a_3, a_4 = a(s.x + h * v_3);
    s = {s.x + h / 6 * (v_1 + 2 * v_2 + 2 * v_3 + v_4), s.v + h / 6 * (a_1 + 2 * a_2 + 2 * a_3 + a_4)};
  }
  return s;
}

}  // namespace

BOOST_AUTO_TEST_CASE(steps_within_the_reach_are_walked_at_one_speed) {
  for (const double v : {-0.2, 0.0, 0.05, 0.2, 0.22}) {
    const ForwardOrbit orbit(pendulum, v, 0.8, 0.09);  // L/2 up to 0.088 m
    for (const double x : {-0.3, -0.09, -0.05, 0.0, 0.03, 0.08, 0.5}) {
      BOOST_CHECK_EQUAL(orbit.velocity(x), v);
      BOOST_CHECK_EQUAL(orbit.acceleration(x), 0.0);
    }
    BOOST_CHECK_EQUAL(orbit.end_velocity(), v);
    for (const double t : {-0.4, -0.1, 0.0, 0.2, 0.4}) BOOST_CHECK_EQUAL(orbit.ahead(t), 0.0);
  }
}

BOOST_AUTO_TEST_CASE(who_stands_has_no_orbit_whatever_the_reach) {
  for (const double roll : {-0.01, 0.0, 0.09}) {
    const ForwardOrbit orbit(pendulum, 0.0, 0.8, roll);
    for (const double x : {-0.1, 0.0, 0.1}) {
      BOOST_CHECK_EQUAL(orbit.velocity(x), 0.0);
      BOOST_CHECK_EQUAL(orbit.acceleration(x), 0.0);
      BOOST_CHECK_EQUAL(orbit.ahead(x), 0.0);
    }
    BOOST_CHECK_EQUAL(orbit.end_velocity(), 0.0);
  }
}

BOOST_AUTO_TEST_CASE(pendulum_from_the_middle_is_half_a_step_on_half_a_period_later_with_the_end_velocity) {
  for (const Walk& walk : long_steps()) {
    const ForwardOrbit orbit = walk.orbit();
    const PendulumState end = moved({0.0, orbit.velocity(0.0)}, walk.roll, 0.5 * walk.period);
    CHECK_NEAR(end.x, walk.half(), 1e-8);
    CHECK_NEAR(end.v, orbit.end_velocity(), 1e-7);
    BOOST_CHECK_GT(std::abs(end.v), std::abs(walk.v));  // it falls from slow to fast
    BOOST_CHECK_LT(std::abs(orbit.velocity(0.0)), std::abs(walk.v));
  }
}

BOOST_AUTO_TEST_CASE(half_a_step_at_these_velocities_takes_half_a_period) {
  for (const Walk& walk : long_steps()) {
    const ForwardOrbit orbit = walk.orbit();
    constexpr int kParts = 200000;
    double time = 0.0;
    for (int i = 0; i < kParts; ++i) time += walk.half() / kParts / orbit.velocity((i + 0.5) / kParts * walk.half());
    CHECK_NEAR(time, 0.5 * walk.period, 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(acceleration_is_what_the_velocity_gains_on_its_way) {
  for (const Walk& walk : long_steps()) {
    const ForwardOrbit orbit = walk.orbit();
    const double h = 1e-4 * std::abs(walk.half());
    for (const double share : {-0.98, -0.7, -0.3, -0.05, 0.05, 0.3, 0.7, 0.98}) {
      const double x = share * walk.half(), a = orbit.acceleration(x);
      const double dv_dx = (orbit.velocity(x + h) - orbit.velocity(x - h)) / (2 * h);
      CHECK_NEAR(orbit.velocity(x) * dv_dx, a, 1e-5);
      CHECK_NEAR(a, pendulum.acceleration(x, std::clamp(x, -walk.roll, walk.roll)), 1e-13);
    }
  }
}

BOOST_AUTO_TEST_CASE(ahead_is_where_the_pendulum_is_beyond_steady_motion_and_nothing_at_either_end) {
  for (const Walk& walk : long_steps()) {
    const ForwardOrbit orbit = walk.orbit();
    for (const double share : {-0.95, -0.5, -0.1, 0.2, 0.6, 0.9}) {
      const double t = 0.5 * share * walk.period;
      const PendulumState then = moved({0.0, orbit.velocity(0.0)}, walk.roll, t);
      CHECK_NEAR(orbit.ahead(t), then.x - walk.v * t, 1e-8);
      CHECK_NEAR(orbit.ahead(-t), -orbit.ahead(t), 0.0);
      BOOST_CHECK_LT(orbit.ahead(t) * t * walk.v, 0.0);  // slow over the foot: behind after the middle, ahead before it
    }
    for (const double t : {-0.5 * walk.period, 0.0, 0.5 * walk.period}) CHECK_NEAR(orbit.ahead(t), 0.0, 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(backward_walking_is_the_mirror_image) {
  for (const Walk& walk : long_steps()) {
    const ForwardOrbit ahead = walk.orbit(), back(pendulum, -walk.v, walk.period, walk.roll);
    CHECK_NEAR(back.end_velocity(), -ahead.end_velocity(), 0.0);
    for (const double x : {-0.4, -0.1, -0.02, 0.0, 0.005, 0.05, 0.2}) {
      CHECK_NEAR(back.velocity(-x), -ahead.velocity(x), 0.0);
      CHECK_NEAR(back.velocity(x), -ahead.velocity(x), 0.0);
      CHECK_NEAR(back.acceleration(x), ahead.acceleration(x), 0.0);
      CHECK_NEAR(back.ahead(x), -ahead.ahead(x), 0.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(beyond_half_a_step_it_is_as_there) {
  const ForwardOrbit orbit(pendulum, 0.6, 0.8, 0.09);
  for (const double x : {-5.0, -0.25, 0.25, 5.0}) {
    BOOST_CHECK_EQUAL(orbit.velocity(x), orbit.end_velocity());
    BOOST_CHECK_EQUAL(orbit.acceleration(x), orbit.acceleration(std::copysign(0.24, x)));
  }
}

BOOST_AUTO_TEST_CASE(without_reach_it_is_the_pendulum_about_one_point) {
  // x = T_c v_0 sinh(t / T_c): v_0 and v_s in closed form.
  for (const double roll : {-0.05, 0.0}) {
    const double half = 0.24, theta = 0.4 / Tc;
    const ForwardOrbit orbit(pendulum, 0.6, 0.8, roll);
    CHECK_NEAR(orbit.velocity(0.0), half / (Tc * std::sinh(theta)), 1e-9);
    CHECK_NEAR(orbit.end_velocity(), half / (Tc * std::tanh(theta)), 1e-9);
    CHECK_NEAR(orbit.velocity(0.1), std::hypot(half / (Tc * std::sinh(theta)), 0.1 / Tc), 1e-9);
    CHECK_NEAR(orbit.ahead(0.2), half * std::sinh(0.5 * theta) / std::sinh(theta) - 0.6 * 0.2, 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(end_velocity_does_not_jump_where_steps_outgrow_the_reach) {
  double before = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double v = 0.2 + 5e-5 * i, now = ForwardOrbit(pendulum, v, 0.8, 0.09).end_velocity();
    BOOST_CHECK_GT(now, before);
    if (i > 0) BOOST_CHECK_LT(now - before, 1e-3);
    before = now;
  }
  CHECK_NEAR(ForwardOrbit(pendulum, 0.225 * (1 + 1e-9), 0.8, 0.09).end_velocity(), 0.225, 1e-8);
}

BOOST_AUTO_TEST_CASE(an_orbit_is_for_the_numbers_it_was_made_of_and_for_no_others) {
  const ForwardOrbit orbit(pendulum, 0.6, 0.8, 0.09);
  BOOST_CHECK(orbit.is_for(pendulum, 0.6, 0.8, 0.09));
  BOOST_CHECK(!orbit.is_for(pendulum, 0.61, 0.8, 0.09) && !orbit.is_for(pendulum, 0.6, 0.81, 0.09));
  BOOST_CHECK(!orbit.is_for(pendulum, 0.6, 0.8, 0.08));
  BOOST_CHECK(!orbit.is_for(LinearInvertedPendulum(0.746, 9.81), 0.6, 0.8, 0.09));
  BOOST_CHECK(ForwardOrbit(pendulum, 0.6, 0.8, -0.01).is_for(pendulum, 0.6, 0.8, -0.02));
  BOOST_CHECK(!ForwardOrbit().is_for(pendulum, 0.0, 0.8, 0.0));
}
