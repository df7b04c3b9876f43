#include <cmath>
#include <vector>

#include "testing.hpp"
#include "zmpwalk/gait/velocity_profile.hpp"
#include "zmpwalk/gait/velocity_tracker.hpp"
#include "zmpwalk/math/error.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

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
  VelocityTracker tracker(TrackerLaw::kSmooth, 5.0, 0.05, 2e-4);
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

BOOST_AUTO_TEST_CASE(bang_bang_tracker_drives_until_the_integral_is_zero) {
  for (const double sign : {-1.0, 1.0}) {
    VelocityTracker tracker(TrackerLaw::kBangBang, 5.0, 0.05, 2e-4);
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
  CHECK_THROWS(VelocityTracker(TrackerLaw::kSmooth, 0.0, 0.05, 1e-4), InputError, "tracker_gain = 0");
}
