#include <cmath>
#include <functional>

#include "testing.hpp"
#include "zmpwalk/gait/point_walk.hpp"
#include "zmpwalk/math/rotation.hpp"
#include "zmpwalk/walk/felt_ground.hpp"

// What the walk feels of ground that is not as planned.

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

const RobotScale kRobot{0.747, 9.81, 0.001, 0.22};  // the robot of the gains: period 0.8 s
const SoleSize kSole{0.25, 0.14};
const ZmpBounds kBounds{Vec2(-0.09, -0.0504), Vec2(0.09, 0.0504)};
const LinearInvertedPendulum kPendulum(kRobot.com_height, kRobot.gravity);
const VelocityProfile kAhead({0.0}, {Vec3(0.2, 0, 0)});
constexpr double kPeriod = 0.8;      // of the steps [s]
constexpr double kInertia = 8e-5;    // of a foot about its ankle, per weight [m s^2]
constexpr double kCycle = 1.001e-3;  // a control cycle and rounding [s]

WalkSettings settings(TouchDown touch_down = TouchDown::kFelt) {
  WalkSettings s;
  s.gait.touch_down = touch_down;
  return resolve(s, kRobot);
}

/// The ground below a robot whose left foot carries.
struct Standing {
  explicit Standing(TouchDown touch_down = TouchDown::kFelt)
      : s(settings(touch_down)), ground(s, kSole, kRobot.com_height, kPendulum.Tc(), kInertia), dynamics(6) {
    ground.reset(0.3);
    gait.support = kLeft;
    gait.swing = kRight;
    sole_at(0.0);
    sole_at(0.0, kRight);
  }
  void sole_at(double rise, Side side = kLeft) { dynamics.sole[side].p_WF.z() = 0.3 + rise; }
  void run(double time) {
    for (long k = std::lround(time / s.control.dt); k > 0; --k) ground.update(gait, dynamics, kPeriod);
  }

  WalkSettings s;
  FeltGround ground;
  Dynamics dynamics;
  GaitOutput gait;
};

GaitInput stand(const Mat3& R) {
  GaitInput in;
  in.p_sole = {R * Vec3(0, 0.11, 0), R * Vec3(0, -0.11, 0)};
  in.R_sole = {R, R};
  return in;
}

/// The first single support of a walk.
struct FirstSwing {
  FirstSwing(const WalkSettings& s, bool uneven, const Mat3& R = Mat3::Identity())
      : walk(s, kAhead, kPendulum, {kBounds, kBounds}, kSole, stand(R)) {
    walk.in.uneven = uneven;
  }
  /// Its length [s], where the foot is off the ground when `flies` says so; not-a-number: not known.
  double length(const std::function<double(double)>& contact, bool felt_before = true) {
    Phase phase = Phase::kDoubleSupport;
    for (double lifted = kNaN;;) {
      const GaitOutput& before = walk.gait.output();
      walk.in.contact.setConstant(felt_before ? 1.0 : 0.0);
      if (phase == Phase::kSingleSupport) walk.in.contact[before.swing] = contact(before.phase.time + walk.dt);
      const GaitOutput& now = walk.step();
      off_time |= now.off_time;
      if (now.phase.phase == Phase::kSingleSupport && phase == Phase::kDoubleSupport) lifted = walk.in.t;
      if (now.phase.phase == Phase::kDoubleSupport && phase == Phase::kSingleSupport) return walk.in.t - lifted;
      phase = now.phase.phase;
    }
  }

  PointWalk walk;
  bool off_time = false;  ///< whether any cycle has called the landing off its time
};

/// A contact that is gone between two times.
std::function<double(double)> gone(double from, double until) {
  return [=](double t) { return t >= from && t < until ? 0.0 : 1.0; };
}

}  // namespace

BOOST_AUTO_TEST_CASE(ground_whose_height_is_as_at_the_start_is_even_and_keeps_its_bits) {
  Standing on;
  for (const double rise : {0.0, 1e-3, -1e-3}) {
    on.sole_at(rise);
    on.run(1.0);
    BOOST_CHECK(!on.ground.uneven());
    CHECK_NEAR(on.ground.height(), 0.3, 0.0);
    CHECK_NEAR(on.ground.drise(), 0.0, 0.0);
    CHECK_NEAR(on.ground.ddrise(), 0.0, 0.0);
  }
}

BOOST_AUTO_TEST_CASE(height_goes_to_that_of_the_foot_that_carries_as_a_critically_damped_low_pass) {
  const double T = 0.36 * kPendulum.Tc();
  for (const double rise : {0.03, -0.02}) {
    Standing on;
    on.sole_at(rise);
    double t = 0.0, last = 0.0, last_rate = 0.0;
    for (; t < 1.2; t += on.s.control.dt) {
      CHECK_NEAR(on.ground.height() - 0.3, rise * (1.0 - (1.0 + t / T) * std::exp(-t / T)), 0.01 * std::abs(rise));
      on.run(on.s.control.dt);
      BOOST_CHECK(on.ground.uneven());
      // Height, rate and acceleration belong together.
      CHECK_NEAR(on.ground.height() - 0.3 - last, on.s.control.dt * last_rate, 1e-15);
      CHECK_NEAR(on.ground.drise() - last_rate, on.s.control.dt * on.ground.ddrise(), 1e-15);
      last = on.ground.height() - 0.3;
      last_rate = on.ground.drise();
    }
    CHECK_NEAR(on.ground.height(), 0.3 + rise, 1e-3 * std::abs(rise));
  }
}

BOOST_AUTO_TEST_CASE(a_landing_off_its_time_at_another_height_makes_ground_uneven_until_some_steps_found_it_level) {
  Standing on;
  on.gait.off_time = true;
  on.run(on.s.control.dt);
  BOOST_CHECK(!on.ground.uneven());  // early onto ground that is where it should be: the foot was too low
  on.sole_at(0.01, kRight);
  on.run(on.s.control.dt);
  BOOST_CHECK(on.ground.uneven());
  CHECK_NEAR(on.ground.height(), 0.3, 0.0);
  on.gait.off_time = false;
  on.run(4.0);
  BOOST_CHECK(on.ground.uneven());
  on.run(2.0);
  BOOST_CHECK(!on.ground.uneven());
}

BOOST_AUTO_TEST_CASE(a_sole_that_rocks_on_its_own_edge_makes_no_ground_uneven) {
  for (const double tilt : {0.12, -0.12}) {
    for (const Vec3& axis : {Vec3(0, 1, 0), Vec3(1, 0, 0)}) {
      Standing on;
      Mat3& R = on.dynamics.sole[kLeft].R_WF;
      R = Eigen::AngleAxisd(tilt, axis).toRotationMatrix();
      // Its edge stays on the ground, its middle rises.
      on.sole_at(0.5 * (std::abs(R(2, 0)) * kSole.length + std::abs(R(2, 1)) * kSole.width));
      on.run(1.0);
      BOOST_CHECK(!on.ground.uneven());
      on.sole_at(0.0);  // one edge is in the ground: it has been found lower
      on.run(on.s.control.dt);
      BOOST_CHECK(on.ground.uneven());
    }
  }
}

BOOST_AUTO_TEST_CASE(the_zmp_goes_against_the_rotation_of_a_sole_that_carries_alone_on_uneven_ground) {
  Standing on;
  on.dynamics.sole[kLeft].velocity << 0, 0, 0, 0.4, -1.0, 2.0;
  on.gait.phase.phase = Phase::kSingleSupport;
  CHECK_NEAR(on.ground.steadying(on.gait, on.dynamics), Vec2::Zero(), 0.0);
  on.sole_at(0.03);
  on.run(on.s.control.dt);
  // Toes that rise (w_y < 0) are pressed by a ZMP ahead, a left edge that rises (w_x > 0) by one to the left.
  const double D = 0.05 * kRobot.com_height * kPendulum.Tc() + 3.2 * kInertia / kPendulum.Tc();
  CHECK_NEAR(on.ground.steadying(on.gait, on.dynamics), D * Vec2(1.0, 0.4), 1e-15);
  on.gait.phase.phase = Phase::kDoubleSupport;
  CHECK_NEAR(on.ground.steadying(on.gait, on.dynamics), Vec2::Zero(), 0.0);
}

BOOST_AUTO_TEST_CASE(ground_that_stays_level_at_another_height_is_even_there) {
  Standing on;
  on.sole_at(0.03);
  on.run(6.0);
  BOOST_CHECK(!on.ground.uneven());
  CHECK_NEAR(on.ground.height(), 0.33, 1e-9);
  CHECK_NEAR(on.ground.drise(), 0.0, 0.0);
  on.sole_at(0.031);
  on.run(1.0);
  BOOST_CHECK(!on.ground.uneven());
  on.sole_at(0.0);
  on.run(1.5);
  BOOST_CHECK(on.ground.uneven());
  CHECK_NEAR(on.ground.height(), 0.3, 1e-4);
}

BOOST_AUTO_TEST_CASE(a_walk_by_time_or_by_contact_follows_no_ground) {
  for (const TouchDown touch_down : {TouchDown::kTime, TouchDown::kContact}) {
    Standing on(touch_down);
    on.gait.off_time = true;
    on.sole_at(0.05);
    on.run(1.0);
    BOOST_CHECK(!on.ground.uneven());
    CHECK_NEAR(on.ground.height(), 0.3, 0.0);
  }
}

BOOST_AUTO_TEST_CASE(on_even_ground_a_step_ends_by_time_unless_the_foot_meets_the_ground_well_before) {
  const WalkSettings s = settings();
  const double T = s.gait.T_ss;
  struct Case {
    double on;  ///< when the foot touches [s]
    double length;
    bool off_time;
  };
  for (const Case& c : {Case{T - 0.01, T, false}, Case{T, T, false}, Case{T + 0.05, T, false},
                        Case{T - 0.1, T - 0.1, true}, Case{0.2, 0.5 * T, true}})
    BOOST_TEST_CONTEXT("touches at " << c.on) {
      FirstSwing swing(s, false);
      CHECK_NEAR(swing.length(gone(0.03, c.on)), c.length, kCycle);
      BOOST_CHECK_EQUAL(swing.off_time, c.off_time);
    }
}

BOOST_AUTO_TEST_CASE(on_uneven_ground_a_step_ends_when_the_foot_touches) {
  const WalkSettings s = settings();
  const double T = s.gait.T_ss, longest = T + s.gait.touch_down_time;
  struct Case {
    double on;
    double length;
    bool off_time;
  };
  for (const Case& c : {Case{T - 0.01, T - 0.01, false}, Case{T - 0.1, T - 0.1, true},
                        Case{T + 0.005, T + 0.005, false}, Case{T + 0.04, T + 0.04, true}, Case{9.0, longest, true}})
    BOOST_TEST_CONTEXT("touches at " << c.on) {
      FirstSwing swing(s, true);
      CHECK_NEAR(swing.length(gone(0.03, c.on)), c.length, kCycle);
      BOOST_CHECK_EQUAL(swing.off_time, c.off_time);
    }
}

BOOST_AUTO_TEST_CASE(a_step_ends_by_time_where_its_contact_is_unknown_was_never_felt_or_never_gone) {
  const WalkSettings s = settings();
  for (const bool uneven : {false, true}) {
    const double T = s.gait.T_ss;
    CHECK_NEAR(FirstSwing(s, uneven).length([](double) { return kNaN; }), T, kCycle);
    CHECK_NEAR(FirstSwing(s, uneven).length(gone(0.0, 9.0), false), T, kCycle);
    CHECK_NEAR(FirstSwing(s, uneven).length(gone(9.0, 9.0)), T, kCycle);
    const auto scuffs = [&](double t) { return t < 0.03 || (t > 0.2 && t < 0.21) || t > T ? 1.0 : 0.0; };
    CHECK_NEAR(FirstSwing(s, uneven).length(scuffs), T, kCycle);
  }
}

BOOST_AUTO_TEST_CASE(on_uneven_ground_the_foot_rises_before_it_goes_ahead_and_comes_down_over_its_place) {
  const WalkSettings s = settings();
  for (const bool uneven : {false, true}) {
    FirstSwing first(s, uneven);
    PointWalk& walk = first.walk;
    while (walk.step().phase.phase == Phase::kDoubleSupport) continue;
    const Side side = walk.gait.output().swing;
    const double T = walk.gait.output().phase.duration;
    const double x = walk.in.p_sole[side].x(), z = walk.in.p_sole[side].z();
    double early = kNaN, late = kNaN, top = 0.0, speed = kNaN;
    while (walk.gait.output().phase.phase == Phase::kSingleSupport) {
      const GaitOutput& now = walk.step();
      if (now.phase.phase != Phase::kSingleSupport) break;
      const double t = now.phase.time;
      if (t < 0.15 * T) early = now.swing_target.p.x();
      if (t < 0.9 * T) late = (now.swing_target.p.head<2>() - now.foothold.p).norm();
      top = std::max(top, now.swing_target.p.z() - z);
      speed = -now.swing_target.v.z();
    }
    CHECK_NEAR(top, (uneven ? 1.7 : 1.0) * s.swing.height, 1e-3);
    CHECK_NEAR(speed, uneven ? s.gait.touch_down_speed : 0.0, 5e-3);
    BOOST_CHECK_EQUAL(early - x < 1e-9, uneven);
    BOOST_CHECK_EQUAL(late < 2e-3, uneven);
  }
}
