#include "testing.hpp"
#include "walk.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

const VelocityProfile kStand({0.0}, {Vec3::Zero()});

CommandLimit limit_of(const WalkSettings& s = WalkSettings(), const Model& m = mahru()) {
  return WalkingController(m, describe(mahru()), s, kStand).command_limit();
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_humanoid_may_walk_every_speed_that_it_has_walked_and_its_hip_limits_the_rest) {
  // docs/walk_anywhere.md: 1.2 m/s is kept, 1.3 m/s falls.
  const AxisLimit forward = limit_of().axes()[0];
  BOOST_CHECK_GE(forward.most, 1.2);
  BOOST_CHECK_LT(forward.most, 1.3);
  BOOST_CHECK(forward.limit == SpeedLimit::kHip);
  BOOST_CHECK(forward.joint == "l_hip_pitch" || forward.joint == "r_hip_pitch");
}

BOOST_AUTO_TEST_CASE(a_velocity_within_the_limits_is_itself_and_another_is_scaled_down_to_them) {
  const CommandLimit limit = limit_of();
  Numbers numbers(7);
  int scaled = 0;
  for (int n = 0; n < 300; ++n) {
    const Vec3 v = numbers.vector(3, 2.0);
    SpeedLimit bites, again;
    const Vec3 to = limit.within(v, &bites);
    CHECK_NEAR(to.cross(v), Vec3::Zero(), 1e-9);
    BOOST_CHECK_EQUAL(bites != SpeedLimit::kNone, to != v);
    CHECK_NEAR(limit.within(to, &again), to, 0.0);  // and is not scaled twice
    BOOST_CHECK(again == bites);
    scaled += to != v;
  }
  BOOST_CHECK(scaled > 50 && scaled < 300);
  CHECK_NEAR(limit.within({9, 0, 0}), Vec3(limit.axes()[0].most, 0, 0), 1e-9);
  CHECK_NEAR(limit.within({-9, 0, 0}), Vec3(-limit.axes()[1].most, 0, 0), 1e-9);
}

BOOST_AUTO_TEST_CASE(weaker_hips_walk_more_slowly_and_a_larger_share_faster) {
  const auto forward = [](double hip, double share) {
    WalkSettings s;
    for (const char* joint : {"l_hip_pitch", "r_hip_pitch"}) s.control.torque_limits[joint] = hip;
    s.command.share = share;
    return limit_of(s).axes()[0].most;
  };
  BOOST_CHECK_LT(forward(60.0, 1.0), forward(100.0, 1.0));
  BOOST_CHECK_LT(forward(60.0, 1.0), forward(60.0, 1.2));
}

BOOST_AUTO_TEST_CASE(slippery_soles_walk_more_slowly) {
  const auto limit = [](double friction) {
    const ModelPtr m = load_text(mahru_text());
    for (int g = 0; g < m->ngeom; ++g) m->geom_friction[3 * g] = friction;
    return limit_of(WalkSettings(), m.get()).axes()[0];
  };
  const AxisLimit grips = limit(1.0), slips = limit(0.3);
  BOOST_CHECK_LT(slips.most, grips.most);
  BOOST_CHECK(slips.limit == SpeedLimit::kYawFriction || slips.limit == SpeedLimit::kFriction);
}

BOOST_AUTO_TEST_CASE(without_a_limit_only_the_legs_reach_counts) {
  WalkSettings s;
  s.command.limit = false;
  const WalkingController controller(mahru(), describe(mahru()), s, kStand);
  CHECK_NEAR(controller.command_limit().within({9, 0.3, 0}), controller.reach().within({9, 0.3, 0}), 0.0);
  BOOST_CHECK(controller.command_limit().axes()[0].limit == SpeedLimit::kReach);
}
