#include <cmath>
#include <vector>

#include "testing.hpp"
#include "zmpwalk/gait/velocity_profile.hpp"
#include "zmpwalk/gait/velocity_tracker.hpp"
#include "zmpwalk/math/error.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

const VelocityLimits kLimits{{0.1, 0.08, 0.25}, {0.2, 0.25, 1.0}, {0.45, 0.25, 1.0}};

VelocityProfile random_profile(Numbers& numbers, Interpolation kind) {
  std::vector<double> t{0.0};
  std::vector<Vec3> v{numbers.vector(3, 0.6)};
  for (int i = 0; i < 8; ++i) {
    t.push_back(t.back() + numbers.uniform(0.05, 1.5));
    v.push_back(i % 3 ? Vec3(numbers.vector(3, 0.6)) : Vec3(Vec3::Zero()));
  }
  return VelocityProfile(t, v, kind);
}

TrackingSettings tracking(const char* law, double gain = 5.0, double time = 0.05, double catch_up_speed = INFINITY) {
  TrackingSettings out;
  out.law = chosen<TrackerLawName>("tracking.law", law);
  out.gain = gain;
  out.time = time;
  out.catch_up_speed = catch_up_speed;
  out.deadband = 2e-4;
  return out;
}

/// By how much changes of `v` from `from` on [t0, t1] go beyond what `limits` let pass at once, `spent` of it gone before.
double excess(const VelocityProfile& v, Vec3 from, double t0, double t1, const VelocityLimits& limits, Vec3 spent) {
  constexpr double h = 1e-3;
  double worst = -std::numeric_limits<double>::infinity();
  for (double t = t0; t < t1; t += h) {
    const Vec3 now = v.velocity(t);
    for (int i = 0; i < 3; ++i) {
      const bool slows = std::abs(now[i]) < std::abs(from[i]) || now[i] * from[i] < 0.0;
      const double rate = slows ? limits.deceleration[i] : limits.acceleration[i];
      spent[i] = std::max(spent[i] + std::abs(now[i] - from[i]) - (t > t0 ? h * rate : 0.0), 0.0);
      worst = std::max(worst, spent[i] - limits.jump[i]);
    }
    from = now;
  }
  return worst;
}

}  // namespace

BOOST_AUTO_TEST_CASE(paper_profile_advances_by_the_published_speeds) {
  const VelocityProfile profile = VelocityProfile::paper();
  const std::vector<double> speeds{0.063, 0.156, 0.219, 0.25, 0.25};
  for (int k = 0; k < 5; ++k) CHECK_NEAR(profile.displacement(0.8 * k, 0.8 * (k + 1)).x(), 0.8 * speeds[k], 1e-12);
  BOOST_CHECK_EQUAL(profile.velocity(0.8 - 2e-9).x(), 0.063);
  BOOST_CHECK_EQUAL(profile.velocity(0.8 - 5e-10).x(), 0.156);
  BOOST_CHECK_EQUAL(profile.velocity(-1.0).x(), 0.063);
  BOOST_CHECK_EQUAL(profile.velocity(100.0).x(), 0.25);
  BOOST_CHECK_EQUAL(profile.max_speed(), 0.25);
}

BOOST_AUTO_TEST_CASE(forward_speed_read_in_order_is_the_velocity_at_each_time) {
  Numbers numbers(5);
  for (const Interpolation kind : {Interpolation::kHold, Interpolation::kLinear}) {
    const VelocityProfile profile = random_profile(numbers, kind);
    VelocityProfile::Moment reached = profile.at(0.0);
    for (double t = 0.0; t < 8.0; t += 0.013)
      BOOST_CHECK_EQUAL(profile.forward_from(reached, t), profile.velocity(t).x());
    for (const double knot : profile.t()) {
      reached = profile.at(0.0);
      BOOST_CHECK_EQUAL(profile.forward_from(reached, knot - 5e-10), profile.velocity(knot).x());  // a nanosecond early
    }
  }
}

BOOST_AUTO_TEST_CASE(displacement_is_the_integral_of_the_velocity) {
  for (const Interpolation kind : {Interpolation::kHold, Interpolation::kLinear}) {
    const VelocityProfile profile({0.0, 0.5, 2.0}, {Vec3(0.1, 0, 0.3), Vec3(0.4, -0.2, 0), Vec3(0.2, 0.1, -1)}, kind);
    Vec3 sum = Vec3::Zero();
    const double h = 1e-4;
    for (int i = 0; i < 30000; ++i) sum += h * profile.velocity((i + 0.5) * h);
    CHECK_NEAR(profile.displacement(0.0, 3.0), sum, 1e-8);
    CHECK_NEAR(profile.displacement(0.3, 2.7), profile.displacement(0.3, 1.1) + profile.displacement(1.1, 2.7), 1e-14);
    CHECK_NEAR(profile.displacement(2.7, 0.3), -profile.displacement(0.3, 2.7), 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(travel_at_a_constant_velocity_is_an_arc) {
  for (const Vec3& v : {Vec3(0.3, 0, 0.5), Vec3(0.2, -0.15, -0.5), Vec3(-0.1, 0.1, 0.3)}) {
    const VelocityProfile circle({0.0}, {v});
    for (const double T : {0.03, 0.8, 5.0, 2 * M_PI / std::abs(v.z())}) {
      const double yaw = v.z() * T, c = std::cos(yaw), s = std::sin(yaw);
      const Vec3 arc((s * v.x() - (1 - c) * v.y()) / v.z(), ((1 - c) * v.x() + s * v.y()) / v.z(), yaw);
      CHECK_NEAR(circle.travel(1.7, 1.7 + T), arc, 1.1e-4 * v.head<2>().norm() * T);
    }
  }
}

BOOST_AUTO_TEST_CASE(travel_without_turning_is_the_displacement_to_the_bit) {
  Numbers numbers(2);
  const VelocityProfile straight({0.0, 0.7, 1.3}, {Vec3(0.1, 0.2, 0), Vec3(-0.3, 0.1, 0), Vec3(0.2, 0, 0)});
  for (int i = 0; i < 100; ++i) {
    const double t0 = numbers.uniform(0.0, 2.0), t1 = t0 + numbers.uniform(0.0, 2.0);
    CHECK_NEAR(straight.travel(t0, t1), straight.displacement(t0, t1), 0.0);
  }
}

BOOST_AUTO_TEST_CASE(a_limited_profile_never_changes_faster_than_its_limits_and_gets_there) {
  Numbers numbers(7);
  for (int n = 0; n < 100; ++n) {
    const VelocityProfile wanted = random_profile(numbers, n % 2 ? Interpolation::kLinear : Interpolation::kHold);
    const VelocityProfile plan = wanted.limited(kLimits);
    const double end = wanted.t().back() + 10.0;
    BOOST_CHECK_LE(excess(plan, Vec3::Zero(), 0.0, end, kLimits, Vec3::Zero()), 1e-9);
    CHECK_NEAR(plan.velocity(end), wanted.v().back(), 0.0);
    for (std::size_t i = 1; i < plan.t().size(); ++i) BOOST_CHECK_GT(plan.t()[i], plan.t()[i - 1]);
  }
}

BOOST_AUTO_TEST_CASE(a_profile_within_the_limits_is_itself_to_the_bit) {
  const std::vector<double> t{0.0, 0.8, 1.7, 2.4, 3.0};
  const std::vector<Vec3> jumps{{0.1, 0, 0}, {0.15, 0.05, -0.2}, {0.11, 0, 0}, {0.2, 0.05, 0.1}, {0.2, 0.05, 0.1}},
      ramps{{0, 0, 0}, {0.12, 0.1, 0.7}, {0, 0, 0.1}, {-0.13, 0.11, 0}, {-0.2, 0, 0.5}};
  for (const VelocityProfile& wanted :
       {VelocityProfile(t, jumps), VelocityProfile(t, ramps, Interpolation::kLinear), VelocityProfile::paper()}) {
    const VelocityProfile plan = wanted.limited(kLimits);
    for (double now = 0.0; now < 4.0; now += 0.0137) {
      CHECK_NEAR(plan.velocity(now), wanted.velocity(now), 0.0);
      CHECK_NEAR(plan.displacement(0.0, now), wanted.displacement(0.0, now), 0.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_start_that_is_too_fast_passes_its_jump_at_once_and_then_accelerates) {
  const VelocityProfile plan = VelocityProfile({0.0}, {Vec3(0.5, 0, 0)}).limited(kLimits);
  for (const auto& [t, v] : {std::pair{0.0, 0.1}, {1.0, 0.3}, {2.0, 0.5}, {3.0, 0.5}})
    CHECK_NEAR(plan.velocity(t).x(), v, 1e-12);
  CHECK_NEAR(plan.displacement(0.0, 3.0).x(), 0.3 * 2.0 + 0.5, 1e-12);
}

BOOST_AUTO_TEST_CASE(a_moving_plan_steers_back_through_zero_at_both_rates) {
  VelocityProfile plan({0.0}, {Vec3(0.55, 0.1, 0)});
  plan.steer(3.0, Vec3(-0.2, 0.1, 0.2), kLimits, kLimits.jump);
  // The jump to 0.45, 1 s at 0.45 m/s^2 to zero, 1 s at 0.2 m/s^2 backward. Turning fits into its jump.
  for (const auto& [t, v] : {std::pair{3.0, 0.45}, {3.5, 0.225}, {4.0, 0.0}, {4.5, -0.1}, {5.0, -0.2}, {9.0, -0.2}})
    CHECK_NEAR(plan.velocity(t), Vec3(v, 0.1, 0.2), 1e-12);
}

BOOST_AUTO_TEST_CASE(a_plan_steered_at_any_time_keeps_to_the_limits) {
  Numbers numbers(8);
  VelocityProfile plan({0.0}, {Vec3::Zero()});
  Vec3 v = Vec3::Zero();
  double now = 0.0;
  for (int n = 0; n < 200; ++n) {
    const Vec3 target = n % 4 ? Vec3(numbers.vector(3, 0.8)) : Vec3(Vec3::Zero());
    const Vec3 allowance = kLimits.jump * numbers.uniform(0.0, 1.0);
    plan.steer(now, target, kLimits, allowance);
    CHECK_NEAR(plan.velocity(now + 100.0), target, 0.0);
    const double until = now + numbers.uniform(0.001, 3.0);
    BOOST_CHECK_LE(excess(plan, v, now, until, kLimits, kLimits.jump - allowance), 1e-9);
    v = plan.velocity(until);
    now = until;
  }
}

BOOST_AUTO_TEST_CASE(plan_is_at_rest_where_its_velocity_is_zero_throughout) {
  const std::vector<double> t{0.0, 1.0, 2.0, 3.0};
  const std::vector<Vec3> v{{0, 0, 0}, {0, 0, 0.1}, {0, 0, 0}, {0, 0, 0}};
  const VelocityProfile hold(t, v), linear(t, v, Interpolation::kLinear);
  BOOST_CHECK(hold.at_rest(0.0, 1.0) && !hold.at_rest(0.0, 1.1) && !hold.at_rest(1.9, 2.5) && hold.at_rest(2.0, 9.0));
  BOOST_CHECK(!linear.at_rest(0.0, 1.0) && !linear.at_rest(1.9, 2.5) && linear.at_rest(3.0, 9.0));
}

BOOST_AUTO_TEST_CASE(profile_refuses_gaps_and_wrong_order) {
  const Vec3 v(0.1, 0, 0);
  CHECK_THROWS(VelocityProfile({}, {}), InputError, "no knots");
  CHECK_THROWS(VelocityProfile({0.0, 1.0}, {v}), DimensionError, "v has 1 entries; it must have 2");
  CHECK_THROWS(VelocityProfile({0.1}, {v}), InputError, "starts at t = 0.100000 s; it must start at 0");
  CHECK_THROWS(VelocityProfile({0.0, 1.0, 1.0}, {v, v, v}), InputError,
               "knot 2: t = 1.000000 s does not come after 1.000000 s");
  CHECK_THROWS(VelocityProfile({0.0, kNaN}, {v, v}), InputError, "knot 1: time or velocity is not finite");
  CHECK_THROWS(VelocityProfile({0.0}, {Vec3(INFINITY, 0, 0)}), InputError, "knot 0");
}

BOOST_AUTO_TEST_CASE(smooth_tracker_brings_speed_and_integral_to_the_plan) {
  VelocityTracker tracker(tracking("smooth"));
  double v = 0.0;
  for (int k = 0; k < 4000; ++k) {
    v += tracker.acceleration(0.25, v) * 1e-3;
    tracker.advance(v, 0.25, 1e-3);
    BOOST_CHECK(tracker.drive() == Drive::kNone);
  }
  CHECK_NEAR(v, 0.25, 1e-6);
  CHECK_NEAR(tracker.integral(), 0.0, 1e-6);
  CHECK_NEAR(tracker.acceleration(0.35, 0.25), 0.1 / 0.05, 1e-4);
}

BOOST_AUTO_TEST_CASE(smooth_tracker_asks_for_nothing_while_the_integral_is_as_far_ahead_as_it_is_meant_to_be) {
  const double gain = 5.0, time = 0.05, reach = 0.08;
  VelocityTracker tracker(tracking("smooth", gain, time, reach));
  tracker.advance(0.26, 0.25, 1.0);  // I = 0.01 m
  CHECK_NEAR(tracker.catch_up(0.01), 0.0, 1e-15);
  CHECK_NEAR(tracker.acceleration(0.25, 0.25, 0.01), 0.0, 1e-13);
  CHECK_NEAR(tracker.catch_up(0.014), gain * 0.004, 1e-15);
  CHECK_NEAR(tracker.acceleration(0.25, 0.3, 0.014), (0.25 + gain * 0.004 - 0.3) / time, 1e-13);
  BOOST_CHECK_EQUAL(tracker.catch_up(), tracker.catch_up(0.0));
  BOOST_CHECK_EQUAL(tracker.acceleration(0.25, 0.3), tracker.acceleration(0.25, 0.3, 0.0));
  CHECK_NEAR(tracker.catch_up(), -gain * 0.01, 1e-15);
  for (const double sign : {-1.0, 1.0}) {
    CHECK_NEAR(tracker.catch_up(0.01 + sign), sign * reach, 1e-15);
    CHECK_NEAR(tracker.acceleration(0.0, 0.0, 0.01 + sign), sign * reach / time, 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(smooth_tracker_brings_the_integral_to_where_it_is_meant_to_be) {
  for (const double ahead : {-0.02, 0.03}) {
    VelocityTracker tracker(tracking("smooth", 5.0, 0.05, 0.08));
    double v = 0.25;
    for (int k = 0; k < 5000; ++k) {
      v += tracker.acceleration(0.25, v, ahead) * 1e-3;
      tracker.advance(v, 0.25, 1e-3);
      BOOST_CHECK_LE(std::abs(v - 0.25), 0.08 + 1e-12);
    }
    CHECK_NEAR(v, 0.25, 1e-6);
    CHECK_NEAR(tracker.integral(), ahead, 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(bang_bang_tracker_drives_until_the_integral_is_zero) {
  for (const double sign : {-1.0, 1.0}) {
    VelocityTracker tracker(tracking("bang_bang"));
    const Drive drive = sign < 0 ? Drive::kLower : Drive::kUpper;  // too slow: ZMP back, to accelerate
    tracker.advance(0.25 + sign * 0.1, 0.25, 1e-3);
    BOOST_CHECK(tracker.drive() == Drive::kNone);  // 1e-4 m is within the dead band
    for (int k = 0; k < 9; ++k) tracker.advance(0.25 + sign * 0.1, 0.25, 1e-3);
    BOOST_CHECK(tracker.drive() == drive);
    CHECK_NEAR(tracker.integral(), sign * 1e-3, 1e-12);
    for (int k = 0; k < 9; ++k) {
      tracker.advance(0.25 - sign * 0.1, 0.25, 1e-3);
      BOOST_CHECK(tracker.drive() == drive);  // also inside the dead band
    }
    tracker.advance(0.25 - sign * 0.15, 0.25, 1e-3);
    BOOST_CHECK(tracker.drive() == Drive::kNone);
    CHECK_NEAR(tracker.integral(), -sign * 5e-5, 1e-12);  // what is left of the last cycle stays
    tracker.reset();
    BOOST_CHECK_EQUAL(tracker.integral(), 0.0);
  }
  CHECK_THROWS(VelocityTracker(tracking("smooth", 0.0)), InputError, "tracker_gain = 0");
}
