#include <algorithm>
#include <cmath>
#include <vector>

#include "testing.hpp"
#include "zmpwalk/gait/point_walk.hpp"

// What the gait does with a point mass that has been pushed.

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

const RobotScale kRobot{0.747, 9.81, 0.001, 0.22};  // the robot of the gains: period 0.8 s
const SoleSize kSole{0.25, 0.14};
const ZmpBounds kBounds{Vec2(-0.09, -0.0504), Vec2(0.09, 0.0504)};
const LinearInvertedPendulum kPendulum(kRobot.com_height, kRobot.gravity);
constexpr double kLost = 1.0;  // a DCM this far from between the feet does not come back [m]

WalkSettings settings(bool timing) {
  WalkSettings s;
  s.steps.timing = timing;
  return resolve(s, kRobot);
}

GaitInput stand() {
  GaitInput in;
  in.p_sole = {Vec3(0, 0.11, 0), Vec3(0, -0.11, 0)};
  return in;
}

VelocityProfile steady(const Vec3& v) { return VelocityProfile({0.0}, {v}); }

/// Directions of a push in mid-swing: towards the swing foot, ahead, back, and away from the swing foot.
enum Direction { kInwards, kForwards, kBackwards, kOutwards };

struct TestWalk : PointWalk {
  explicit TestWalk(const VelocityProfile& profile, bool timing = true)
      : PointWalk(settings(timing), profile, kPendulum, {kBounds, kBounds}, kSole, stand()) {}
  explicit TestWalk(double v, bool timing = true) : TestWalk(steady({v, 0, 0}), timing) {}

  Vec2 middle() const { return 0.5 * (in.p_sole[kLeft] + in.p_sole[kRight]).head<2>(); }
  double off() const { return (in.com + pendulum.Tc() * in.dcom - middle()).norm(); }  ///< of the DCM
  Phase phase() const { return gait.output().phase.phase; }
  void run_until(double t) {
    while (in.t < t) step();
  }
  void run_to_mid_swing(int n) {
    while (gait.output().phase.step < n || gait.output().phase.to_mid_single > 0.0) step();
  }
  void push(Direction direction, double speed) {
    const double inwards = side_sign(gait.output().swing);
    const std::array<Vec2, 4> ways{Vec2(0, inwards), Vec2(1, 0), Vec2(-1, 0), Vec2(0, -inwards)};
    in.dcom += speed * ways[direction];
  }
  /// Largest distance of the DCM from between the feet in the next `time` [s], or until the walk is lost.
  double farthest(double time) {
    double far = 0.0;
    for (const double end = in.t + time; in.t < end && far < kLost;) {
      step();
      far = std::max(far, off());
    }
    return far;
  }
  /// Length of the single support under way when it ends [s].
  double single_support() {
    double length = kNaN;
    while (phase() == Phase::kSingleSupport) {
      length = gait.output().phase.duration;
      step();
    }
    return length;
  }
};

/// Speed and sway of a walk, from one landing to the fourth after it.
struct Figures {
  double speed, sway;
};

Figures figures(TestWalk& walk) {
  const auto until = [&](Phase phase, double& low, double& high) {
    while (walk.phase() != phase) {
      walk.step();
      low = std::min(low, walk.in.com.y());
      high = std::max(high, walk.in.com.y());
    }
  };
  double low = 1e9, high = -1e9;
  until(Phase::kSingleSupport, low, high);
  until(Phase::kDoubleSupport, low, high);
  const double t = walk.in.t, x = walk.in.com.x();
  low = high = walk.in.com.y();
  for (int n = 0; n < 4; ++n) {
    until(Phase::kSingleSupport, low, high);
    until(Phase::kDoubleSupport, low, high);
  }
  return {(walk.in.com.x() - x) / (walk.in.t - t), 0.5 * (high - low)};
}

/// Where and when the feet of a walk land.
struct Landings {
  std::vector<double> t;
  std::vector<Vec2> p;
};

Landings landings(const VelocityProfile& profile, bool timing, double duration) {
  TestWalk walk(profile, timing);
  Landings out;
  while (walk.in.t < duration) {
    const Phase before = walk.phase();
    const Side swing = walk.gait.output().swing;
    if (walk.step().phase.phase == before || before == Phase::kDoubleSupport) continue;
    out.t.push_back(walk.in.t);
    out.p.push_back(walk.in.p_sole[swing].head<2>());
  }
  return out;
}

/// Largest differences of landings in time and place; infinity where one walk has more steps.
Vec2 difference(const Landings& a, const Landings& b) {
  if (a.t.size() != b.t.size()) return Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 out = Vec2::Zero();
  for (std::size_t n = 0; n < a.t.size(); ++n) out = out.cwiseMax(Vec2(gap(a.t[n], b.t[n]), gap(a.p[n], b.p[n])));
  return out;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_walk_that_nothing_disturbs_is_the_same_to_the_bit_with_and_without_recovery) {
  std::vector<VelocityProfile> profiles;
  for (const Vec3& v :
       {Vec3(0.1, 0, 0), Vec3(0.2, 0, 0), Vec3(0.4, 0, 0), Vec3(0.6, 0, 0), Vec3(-0.2, 0, 0), Vec3(-0.5, 0, 0),
        Vec3(0, 0.1, 0), Vec3(0, -0.15, 0), Vec3(0, 0, 0.5), Vec3(1.0, 0, 0), Vec3(0.3, 0.1, -0.4)})
    profiles.push_back(steady(v));
  profiles.emplace_back(VelocityProfile({0.0, 5.0, 9.0}, {Vec3(0.3, 0, 0), Vec3::Zero(), Vec3(0.2, 0.05, 0)}));
  for (const VelocityProfile& profile : profiles) {
    const Landings on = landings(profile, true, 16.0);
    BOOST_CHECK_GE(on.t.size(), 14U);
    CHECK_NEAR(difference(on, landings(profile, false, 16.0)), Vec2::Zero(), 0.0);
  }
}

BOOST_AUTO_TEST_CASE(a_push_in_mid_swing_is_forgotten_after_eight_seconds) {
  struct Push {
    Direction direction;
    double speed;
  };
  for (const double v : {0.1, 0.2, 0.4}) {
    TestWalk undisturbed(v);
    undisturbed.run_until(14.0);
    const Figures quiet = figures(undisturbed);
    for (const int n : {8, 9})
      for (const Push& push :
           {Push{kInwards, 0.35}, Push{kForwards, 0.35}, Push{kBackwards, 0.35}, Push{kOutwards, 0.2}})
        BOOST_TEST_CONTEXT(v << " m/s, direction " << push.direction << ", step " << n) {
          TestWalk walk(v);
          walk.run_to_mid_swing(n);
          walk.push(push.direction, push.speed);
          BOOST_CHECK_LT(walk.farthest(8.0), 0.4);
          const Figures then = figures(walk);
          CHECK_NEAR(then.speed, quiet.speed, 2e-3);
          CHECK_NEAR(then.sway, quiet.sway, 1e-3);
        }
  }
}

BOOST_AUTO_TEST_CASE(pushes_that_no_walk_with_fixed_times_stands_are_caught_by_another_landing_time) {
  struct Push {
    double v;
    Direction direction;
    double speed;
  };
  for (const Push& push :
       {Push{0.1, kInwards, 0.7}, Push{0.2, kInwards, 0.7}, Push{0.4, kInwards, 0.65}, Push{0.8, kBackwards, 0.85},
        Push{0.1, kOutwards, 0.3}, Push{0.2, kOutwards, 0.3}, Push{0.4, kOutwards, 0.3}, Push{0.8, kOutwards, 0.35}})
    BOOST_TEST_CONTEXT(push.v << " m/s, direction " << push.direction) {
      const auto farthest = [&](bool timing) {
        TestWalk walk(push.v, timing);
        walk.run_to_mid_swing(8);
        walk.push(push.direction, push.speed);
        return walk.farthest(8.0);
      };
      BOOST_CHECK_LT(farthest(true), 0.5);
      BOOST_CHECK_GE(farthest(false), kLost);
    }
}

BOOST_AUTO_TEST_CASE(a_push_inwards_lands_the_foot_earlier_one_outwards_later_and_a_small_one_at_its_time) {
  const auto length = [](Direction direction, double speed, bool timing = true) {
    TestWalk walk(0.2, timing);
    walk.run_to_mid_swing(8);
    walk.push(direction, speed);
    return walk.single_support();
  };
  const WalkSettings s = settings(true);
  for (const Direction direction : {kInwards, kForwards, kBackwards, kOutwards}) {
    CHECK_NEAR(length(direction, 0.02), s.gait.T_ss, 1e-12);
    CHECK_NEAR(length(direction, 0.35, false), s.gait.T_ss, 1e-12);
  }
  double before = s.gait.T_ss;
  for (const double speed : {0.1, 0.2, 0.3}) {
    const double inwards = length(kInwards, speed);
    BOOST_CHECK_LE(inwards, before + 1e-12);
    before = inwards;
  }
  BOOST_CHECK_LT(before, s.gait.T_ss - 0.05);
  for (const double speed : {0.4, 0.6, 0.9}) BOOST_CHECK_GE(length(kInwards, speed), s.steps.least_time - 1e-9);
  const double outwards = length(kOutwards, 0.3);
  BOOST_CHECK_GT(outwards, s.gait.T_ss + 0.05);
  BOOST_CHECK_LE(outwards, s.gait.T_ss + s.steps.wait_time + 1e-9);
}

BOOST_AUTO_TEST_CASE(a_foot_that_lands_sooner_keeps_the_dcm_nearer) {
  const auto farthest = [](bool timing) {
    TestWalk walk(0.2, timing);
    walk.run_to_mid_swing(8);
    walk.push(kInwards, 0.6);
    return walk.farthest(8.0);
  };
  BOOST_CHECK_LT(farthest(true), 0.8 * farthest(false));
}

BOOST_AUTO_TEST_CASE(a_foot_that_lands_ahead_of_a_push_carries_at_once) {
  // Share of the double support until the foot that has landed carries the ZMP; it lands where it was planned to.
  const auto switched = [](Direction direction, double speed) {
    TestWalk walk(0.2);
    walk.run_to_mid_swing(8);
    while (walk.gait.schedule().touch_down() - walk.in.t > 0.02) walk.step();
    walk.push(direction, speed);
    while (walk.phase() == Phase::kSingleSupport) walk.step();
    while (walk.gait.output().support == walk.gait.output().swing) walk.step();
    const GaitPhase& phase = walk.gait.output().phase;
    return phase.phase == Phase::kDoubleSupport ? phase.time / phase.duration : 1.0;
  };
  const double quiet = switched(kForwards, 0.0);
  BOOST_CHECK_GT(quiet, 0.3);
  BOOST_CHECK_EQUAL(switched(kForwards, 0.05), quiet);
  BOOST_CHECK_LT(switched(kForwards, 0.5), 0.1);
  // Where the DCM goes away from that foot, the other one holds it better.
  BOOST_CHECK_GT(switched(kOutwards, 0.5), 0.3);
  BOOST_CHECK_GT(switched(kBackwards, 0.5), 0.3);
}

BOOST_AUTO_TEST_CASE(a_push_before_the_landing_is_caught_by_the_foot_that_lands) {
  TestWalk walk(0.2);
  walk.run_to_mid_swing(8);
  while (walk.gait.schedule().touch_down() - walk.in.t > 0.02) walk.step();
  walk.push(kForwards, 0.55);
  BOOST_CHECK_LT(walk.farthest(8.0), kLost);
}

BOOST_AUTO_TEST_CASE(a_robot_that_stands_steps_where_the_dcm_leaves_its_feet_and_stands_again) {
  for (const Vec2& push : {Vec2(0.5, 0), Vec2(-0.5, 0)}) {
    TestWalk walk(0.0), fixed(0.0, false);
    for (TestWalk* w : {&walk, &fixed}) {
      w->run_until(1.0);
      BOOST_CHECK(w->gait.output().at_rest);
      w->in.dcom += push;
    }
    BOOST_CHECK_LT(walk.farthest(4.0), 0.4);
    BOOST_CHECK(walk.gait.output().at_rest);
    BOOST_CHECK_GE(walk.gait.output().phase.step, 2);
    CHECK_NEAR((walk.in.p_sole[kLeft] - walk.in.p_sole[kRight]).head<2>(), Vec2(0, 0.22), 1e-3);
    BOOST_CHECK_GT(walk.middle().x() * push.x(), 0.05);
    walk.run_until(10.0);
    CHECK_NEAR(walk.in.com, walk.middle(), 1e-4);
    BOOST_CHECK_GE(fixed.farthest(4.0), kLost);
  }
}

BOOST_AUTO_TEST_CASE(a_push_that_the_soles_can_hold_moves_no_foot_of_a_robot_that_stands) {
  for (const Vec2& push : {Vec2(0.3, 0), Vec2(-0.3, 0), Vec2(0, 0.5), Vec2(0, -0.5), Vec2(0.2, 0.3)}) {
    TestWalk walk(0.0);
    walk.run_until(1.0);
    walk.in.dcom += push;
    while (walk.in.t < 6.0) BOOST_REQUIRE(walk.step().at_rest);
    CHECK_NEAR(walk.in.com, walk.middle(), 1e-4);
  }
}

BOOST_AUTO_TEST_CASE(steps_make_up_way_that_a_push_has_cost_or_given_and_none_within_its_threshold) {
  const TrackingSettings tracking = settings(true).tracking;
  const auto hurried = [](double behind, bool timing) {
    TestWalk walk(0.2, timing);
    walk.run_until(4.0);
    walk.tracker.reset();
    walk.tracker.advance(0.0, behind - walk.gait.output().orbit_ahead, 1.0);
    walk.step();
    return walk.gait.footsteps().hurried();
  };
  const double from = tracking.regain_from;
  for (const double sign : {-1.0, 1.0}) {
    CHECK_NEAR(hurried(sign * 0.99 * from, true), 0.0, 0.0);
    CHECK_NEAR(hurried(sign * (from + 0.02), true), sign * 0.02 * tracking.regain_gain, 1e-12);
    CHECK_NEAR(hurried(sign * 10.0, true), sign * tracking.regain_speed, 1e-12);
    CHECK_NEAR(hurried(sign * 10.0, false), 0.0, 0.0);
  }
}

BOOST_AUTO_TEST_CASE(the_zmp_may_use_the_more_of_the_sole_the_further_the_dcm_has_left_its_plan) {
  const ZmpBounds whole{Vec2(-0.12, -0.065), Vec2(0.12, 0.065)};
  /// Bounds of the ZMP right after a push in mid-swing, of a gait that goes along with a walk and has the whole sole.
  const auto room = [&](double push) {
    TestWalk walk(0.2);
    const WalkSettings s = settings(true);
    GaitGenerator gait(s, steady({0.2, 0, 0}), kSole, {kBounds, kBounds}, {whole, whole});
    gait.reset(walk.in, walk.pendulum);
    while (walk.gait.output().phase.step < 8 || walk.gait.output().phase.to_mid_single > 0.0) {
      gait.update(walk.in);
      walk.step();
    }
    walk.push(kForwards, push);
    return gait.update(walk.in).room;
  };
  double before = 0.0;
  for (const double push : {0.0, 0.1, 0.2, 0.25, 0.3, 0.4}) {
    const ZmpBounds now = room(push);
    CHECK_NEAR(now.upper, -now.lower, 1e-12);
    BOOST_CHECK_GE(now.upper.x(), before);
    BOOST_CHECK_LE(now.upper.y(), whole.upper.y() + 1e-12);
    before = now.upper.x();
  }
  CHECK_NEAR(room(0.0).upper, kBounds.upper, 1e-12);
  CHECK_NEAR(before, whole.upper.x(), 1e-12);
}
