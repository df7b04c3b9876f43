#include <cmath>

#include "testing.hpp"
#include "zmpwalk/gait/capture_region.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

const LinearInvertedPendulum pendulum(0.747, 9.81);
const Vec2 kSole(0.125, 0.07);

CaptureRegion region(const StepReach& reach = {0.45, 0.50, 0.16, 0.3}) {
  CaptureRegion out(reach, kSole);
  out.set_pendulum(pendulum);
  return out;
}

/// DCM after `time` [s] under the ZMP `r`, by (16).
double dcm_after(double xi, double r, double time) {
  return pendulum.dcm(pendulum.step(pendulum.over(time), {0.0, xi / pendulum.Tc()}, r));
}

/// A foot that has just taken over: the next one lands to the left of it.
std::array<CatchAxis, 2> just_landed(const CaptureRegion& of, double x, double y) {
  const Interval sole_x{-kSole.x(), kSole.x()}, sole_y{-kSole.y(), kSole.y()}, across = of.hold()[1];
  const StepReach& reach = of.reach();
  return {CatchAxis{x, sole_x, sole_x, {-reach.ahead, reach.ahead}, of.hold()[0]},
          CatchAxis{y, sole_y, sole_y, {reach.near, reach.aside}, across}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_interval_earlier_is_where_the_pendulum_comes_from) {
  const Interval then{-0.3, 0.5}, zmp{-0.1, 0.08};
  const double time = 0.37;
  const Interval now = CaptureRegion::before(then, zmp, std::exp(-time / pendulum.Tc()));
  CHECK_NEAR(dcm_after(now.lower, zmp.lower, time), then.lower, 1e-12);
  CHECK_NEAR(dcm_after(now.upper, zmp.upper, time), then.upper, 1e-12);
}

BOOST_AUTO_TEST_CASE(what_a_landed_foot_can_hold_is_what_the_next_one_can_a_step_earlier) {
  // Slow steps, whose side away from the other foot is the sole's edge, and quick ones, which gain there.
  for (const double least_time : {0.3, 0.12}) {
    const CaptureRegion r = region({0.45, 0.50, 0.16, least_time});
    const double shrink = std::exp(-least_time / pendulum.Tc());
    const Interval ahead = r.hold()[0], aside = r.hold()[1];
    const Interval next{-0.45 + ahead.lower, 0.45 + ahead.upper};
    CHECK_NEAR(CaptureRegion::before(next, {-kSole.x(), kSole.x()}, shrink).upper, ahead.upper, 1e-12);
    // The foot after it stands on the other side: `aside` counts away from the foot before.
    const Interval other{-0.50 - aside.upper, -0.16 - aside.lower};
    const Interval earlier = CaptureRegion::before(other, {-kSole.y(), kSole.y()}, shrink);
    CHECK_NEAR(earlier.lower, aside.lower, 1e-12);
    CHECK_NEAR(std::max(earlier.upper, kSole.y()), aside.upper, 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(steps_at_the_edge_of_the_region_hold_the_dcm_and_beyond_it_they_do_not) {
  const CaptureRegion r = region();
  const auto after_steps = [&](double xi, int steps) {
    for (int i = 0; i < steps; ++i) xi = dcm_after(xi, kSole.x(), 0.3) - 0.45;  // as early and as far as can be
    return xi;
  };
  const double edge = r.hold()[0].upper;
  BOOST_CHECK_LT(after_steps(edge - 1e-3, 12), 0.0);
  BOOST_CHECK_GT(after_steps(edge + 1e-3, 12), 1.0);
}

BOOST_AUTO_TEST_CASE(gap_is_zero_inside_and_the_distance_outside) {
  const CaptureRegion r = region();
  const CatchTimes times{0.0, 0.64, 0.3, 1.5};
  CHECK_NEAR(r.gap(just_landed(r, 0.0, 0.05), times), 0.0, 0.0);
  const double edge = r.hold()[0].upper;
  CHECK_NEAR(r.gap(just_landed(r, edge + 0.1, 0.05), times), 0.1, 1e-9);
  // Beyond the edge of the sole the earliest or the latest landing reaches farthest.
  const auto lower_for = [&](double time) {
    const double shrink = std::exp(-time / pendulum.Tc());
    return CaptureRegion::before({0.16 + r.hold()[1].lower, 1.0}, {-kSole.y(), kSole.y()}, shrink).lower;
  };
  const double lower = std::min(lower_for(times.least), lower_for(times.most));
  CHECK_NEAR(r.gap(just_landed(r, 0.0, lower - 0.05), times), 0.05, 1e-9);
}

BOOST_AUTO_TEST_CASE(another_landing_time_makes_the_gap_no_larger) {
  Numbers numbers(3);
  const CaptureRegion r = region();
  for (int i = 0; i < 200; ++i) {
    const auto axes = just_landed(r, numbers.uniform(-1, 1), numbers.uniform(-0.5, 1));
    const double planned = numbers.uniform(0.3, 0.8), both = numbers.uniform(0.0, 0.2);
    const double fixed = r.gap(axes, {both, planned, planned, planned});
    BOOST_CHECK_LE(r.gap(axes, {both, planned, 0.3, 1.5}), fixed);
  }
}
