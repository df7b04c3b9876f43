#include <cmath>

#include "testing.hpp"
#include "zmpwalk/gait/known_ground.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/math/rotation.hpp"
#include "zmpwalk/walk/height_plan.hpp"

// Ground that the user knows: heights, places for soles, and the height that the COM follows.

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

const SoleSize kSole{0.25, 0.14};
constexpr double kMargin = 0.0075, kFar = 0.15;

/// Treads of 0.28 m that rise by 0.12 m, the first riser at x = 0.5.
KnownGround stairs() {
  std::vector<GroundPatch> patches{{Vec2(-3, -2), Vec2(0.5, 2), 0.0, Vec2::Zero()}};
  for (int k = 1; k < 6; ++k)
    patches.push_back({Vec2(0.5 + 0.28 * (k - 1), -2), Vec2(0.5 + 0.28 * k, 2), 0.12 * k, Vec2::Zero()});
  return KnownGround(patches);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_patch_is_a_plane_and_the_highest_one_counts) {
  const KnownGround ground(
      {{Vec2(0, 0), Vec2(2, 2), 0.3, Vec2(0.1, -0.2)}, {Vec2(1, 1), Vec2(2, 2), 0.5, Vec2::Zero()}});
  CHECK_NEAR(ground.at({0.5, 0.25}).height, 0.3 - 0.05 + 0.15, 1e-15);
  CHECK_NEAR(ground.at({0.5, 0.25}).rise.y(), -0.2, 0.0);
  CHECK_NEAR(ground.at({1.5, 1.5}).height, 0.5, 0.0);
  BOOST_CHECK(std::isnan(ground.at({-0.1, 1.0}).height));
  BOOST_CHECK(std::isnan(ground.at({1.0, 2.0}).height));
}

BOOST_AUTO_TEST_CASE(heights_on_a_grid_are_bilinear_and_slopes_are_theirs) {
  RowMatX heights(3, 3);
  heights << 0, 0, 0, 0, 0.4, 0, 0, 0, 0;
  const KnownGround ground({0, 0}, 0.5, heights);
  CHECK_NEAR(ground.at({0.5, 0.5}).height, 0.4, 1e-15);
  CHECK_NEAR(ground.at({0.25, 0.25}).height, 0.1, 1e-15);
  const Vec2 p(0.6, 0.2);
  const GroundPoint here = ground.at(p);
  constexpr double kStep = 1e-6;
  CHECK_NEAR(here.rise.x(), (ground.at(p + kStep * Vec2::UnitX()).height - here.height) / kStep, 1e-6);
  CHECK_NEAR(here.rise.y(), (ground.at(p + kStep * Vec2::UnitY()).height - here.height) / kStep, 1e-6);
}

BOOST_AUTO_TEST_CASE(a_sole_lies_on_its_place_with_the_tilt_of_the_ground) {
  const Vec2 rise(0.2, -0.1);
  const KnownGround ground({{Vec2(-2, -2), Vec2(2, 2), 0.0, rise}});
  for (const double yaw : {0.0, 0.7, -2.0}) {
    const SolePlace place = ground.under({Vec2(0.3, -0.4), yaw}, kSole, 0.0);
    BOOST_CHECK(place.good);
    CHECK_NEAR(place.height, 0.06 + 0.04, 1e-12);
    const Vec2 tilt = tilt_on(place.rise, yaw);
    const Mat3 R = turning({tilt.x()}, {tilt.y()}, {yaw}).R;
    CHECK_NEAR((R.col(2) - Vec3(-rise.x(), -rise.y(), 1.0).normalized()).norm(), 0.0, 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(footholds_keep_wholly_on_one_tread) {
  const KnownGround ground = stairs();
  for (double x = 0.3; x < 1.5; x += 0.013) {
    const SolePlace place = ground.nearest({Vec2(x, 0.1), 0.0}, kSole, kMargin, kFar);
    BOOST_REQUIRE(place.good);
    BOOST_CHECK_LE(std::abs(place.at.p.x() - x), kFar + 0.02);
    const double front = place.at.p.x() + 0.125 + kMargin, back = place.at.p.x() - 0.125 - kMargin;
    CHECK_NEAR(ground.at({front - 1e-9, 0.1}).height, ground.at({back + 1e-9, 0.1}).height, 0.0);
    CHECK_NEAR(place.height, ground.at({place.at.p.x(), 0.1}).height, 1e-12);
  }
  BOOST_CHECK(!ground.nearest({Vec2(5.0, 0.0), 0.0}, kSole, kMargin, kFar).good);
  const SolePlace like = ground.under({Vec2(0.64, 0.0), 0.0}, kSole, 0.0);
  CHECK_NEAR(ground.nearest({Vec2(0.7, 0.0), 0.0}, kSole, kMargin, kFar, &like).height, like.height, 1e-12);
}

BOOST_AUTO_TEST_CASE(ground_that_is_none_is_refused) {
  BOOST_CHECK_THROW(KnownGround(std::vector<GroundPatch>{}), InputError);
  BOOST_CHECK_THROW(KnownGround({{Vec2(0, 0), Vec2(0, 1), 0.0, Vec2::Zero()}}), InputError);
  BOOST_CHECK_THROW(KnownGround({{Vec2(0, 0), Vec2(1, 1), kNaN, Vec2::Zero()}}), InputError);
  BOOST_CHECK_THROW(KnownGround({0, 0}, 0.1, RowMatX::Zero(1, 5)), InputError);
  BOOST_CHECK_THROW(KnownGround({0, 0}, 0.0, RowMatX::Zero(3, 3)), InputError);
  BOOST_CHECK(!KnownGround().known());
}

BOOST_AUTO_TEST_CASE(the_height_climbs_stairs_evenly_half_way_between_the_feet) {
  constexpr double kDt = 1e-3, kPeriod = 0.8, kRise = 0.12;
  HeightPlan plan(kDt, 0.276);
  plan.reset(0.0);
  GaitOutput gait;
  gait.at_rest = false;
  gait.swing = kLeft;
  gait.phase.phase = Phase::kSingleSupport;
  double worst = 0.0;
  for (int step = 0; step < 12; ++step, gait.swing = other(gait.swing)) {
    gait.under[other(gait.swing)].height = kRise * step;
    gait.place.height = kRise * (step + 1);
    for (double t = 0.0; t < kPeriod - 0.5 * kDt; t += kDt) {
      gait.phase.to_mid_double = kPeriod - t;
      plan.update(gait, kPeriod);
      if (step < 6) continue;
      worst = std::max(worst, std::abs(plan.drise() - kRise / kPeriod));
    }
    if (step >= 6) CHECK_NEAR(plan.rise(), kRise * (step + 0.5), 2e-3);
  }
  BOOST_CHECK_LT(worst, 0.02);
}
