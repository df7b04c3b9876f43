#include "zmpwalk/walk/observer.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <random>

#include "instant.hpp"
#include "zmpwalk/math/rotation.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

constexpr double kGravity = 9.81, kDt = 0.001;

WalkSettings settings(const std::function<void(WalkSettings&)>& change = [](WalkSettings&) {}) {
  WalkSettings s;
  change(s);
  return resolve(s, {0.747, kGravity, kDt, 0.2});
}

/// A COM that is told the acceleration (sin 5 t, cos 3 t, 0) and has `extra` besides, of which what is made up for is missing again.
struct Com {
  explicit Com(const WalkSettings& s = settings()) : observer(s, kGravity) { observer.reset(v); }

  void run(double duration, const Vec3& extra, double noise = 0.0, bool frozen = false) {
    std::normal_distribution<double> gauss(0.0, 1.0);
    for (const double end = t + duration; t < end - 0.5 * kDt; t += kDt) {
      const Vec3 measured = v + noise * Vec3(gauss(random), gauss(random), gauss(random));
      observer.update(measured, frozen);
      const Vec3 f(std::sin(5.0 * t), std::cos(3.0 * t), 0.0);
      observer.command(f);
      v += (f + extra - observer.made_up_for()) * kDt;
    }
  }

  DisturbanceObserver observer;
  Vec3 v{0.25, 0.0, 0.0};
  double t = 0.0;
  std::mt19937 random{5};
};

Vec4 numbers_of(const Mat3& R) {
  const Eigen::Quaterniond q(R);
  return {q.w(), q.x(), q.y(), q.z()};
}

Mat3 turned(const Vec3& turn) { return Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix(); }

}  // namespace

BOOST_AUTO_TEST_CASE(a_com_that_does_as_it_is_told_is_not_disturbed) {
  Com com;
  com.run(2.0, Vec3::Zero());
  BOOST_CHECK(com.observer.disturbance().none());
  CHECK_NEAR(com.observer.found(), Vec3::Zero(), 1e-9);
}

BOOST_AUTO_TEST_CASE(a_steady_force_is_found_and_made_up_for_but_for_the_tolerance) {
  const WalkSettings s = settings();
  Com com(s);
  const Vec3 d(0.6, -0.4, -2.0);
  com.run(1.0, d);
  CHECK_NEAR(com.observer.found(), d, 1e-3);
  const double left = s.observer.tolerance;
  CHECK_NEAR(com.observer.made_up_for(), d - left * Vec3(1, -1, -1), 1e-3);
  CHECK_NEAR(com.observer.disturbance().acceleration, Vec2(0.6 - left, -0.4 + left), 1e-3);
  BOOST_CHECK_CLOSE(com.observer.disturbance().weight, 1.0 + (2.0 - left) / kGravity, 0.1);
  com.run(1.0, Vec3::Zero());
  BOOST_CHECK(com.observer.disturbance().none());  // once it is gone
}

BOOST_AUTO_TEST_CASE(what_is_made_up_for_is_steady_once_it_has_lasted) {
  const WalkSettings s = settings();
  Com com(s);
  const Vec3 d(0.8, 0.0, 0.0);
  com.run(0.1, d);  // as long as a push
  const double pushed = com.observer.made_up_for().x();
  BOOST_CHECK_GT(pushed, 0.3);
  BOOST_CHECK_LT(com.observer.steady().x(), 0.3 * pushed);
  com.run(2.0, d);
  CHECK_NEAR(com.observer.steady(), Vec2(d.x() - s.observer.tolerance, 0.0), 1e-2);
}

BOOST_AUTO_TEST_CASE(what_is_made_up_for_is_bounded) {
  const WalkSettings s = settings([](WalkSettings& w) { w.observer.push = 100.0; });
  Com com(s);
  com.run(1.0, Vec3(-9.0, 9.0, 9.0));
  CHECK_NEAR(com.observer.made_up_for(), Vec3(-s.observer.force_most, s.observer.force_most, 0.35 * kGravity), 1e-12);
}

BOOST_AUTO_TEST_CASE(a_push_and_a_fall_leave_what_was_found) {
  Com com;
  com.run(1.0, Vec3(0.5, 0.0, 0.0));
  const Vec3 before = com.observer.made_up_for();
  com.run(0.3, Vec3(0.0, 1.0, 0.0), 0.0, true);
  CHECK_NEAR(com.observer.made_up_for(), before, 0.0);
  Com pushed;
  pushed.run(0.3, Vec3(0.0, 6.0, 0.0));  // 0.015 s until it counts as a push
  BOOST_CHECK_LE(pushed.observer.made_up_for().norm(), 0.3);
}

BOOST_AUTO_TEST_CASE(noise_makes_it_slower_and_leaves_little_to_make_up_for) {
  Com com;
  com.run(4.0, Vec3::Zero(), 0.06);
  BOOST_CHECK_CLOSE(com.observer.noise(), 0.06, 10.0);
  double worst = 0.0;
  for (int k = 0; k < 2000; ++k) {
    com.run(kDt, Vec3::Zero(), 0.06);
    worst = std::max(worst, com.observer.made_up_for().norm());
  }
  BOOST_CHECK_LE(worst, 0.1);
  com.run(3.0, Vec3(0.0, 0.6, 0.0), 0.06);
  BOOST_CHECK_CLOSE(com.observer.found().y(), 0.6, 20.0);
}

BOOST_AUTO_TEST_CASE(switched_off_it_finds_nothing) {
  const WalkSettings s = settings([](WalkSettings& w) { w.observer.on = false; });
  Com com(s);
  com.run(1.0, Vec3(0.6, 0.0, 0.0));
  BOOST_CHECK(com.observer.disturbance().none());
  AttitudeObserver attitude(s, kGravity);
  attitude.reset(Mat3::Identity());
  Vec4 q = numbers_of(turned(Vec3(0.1, 0, 0)));
  BOOST_CHECK(!attitude.correct(q, Vec3::Zero()));
}

BOOST_AUTO_TEST_CASE(a_heavier_robot_has_scaled_dynamics_and_a_force_acts_as_a_known_one_at_the_com) {
  Instant at(Standing::kBoth, 3);
  const Dynamics before = at.dyn();
  at.robot.apply_disturbance({});
  CHECK_NEAR(at.dyn().A, before.A, 0.0);
  CHECK_NEAR(at.dyn().b, before.b, 0.0);
  at.robot.apply_disturbance({Vec2(0.5, -0.2), 1.2});
  const Vec3 F = 1.2 * before.mass * Vec3(0.5, -0.2, 0.0);
  CHECK_NEAR(at.dyn().A, 1.2 * before.A, 1e-12);
  CHECK_NEAR(at.dyn().g, 1.2 * before.g, 1e-12);
  CHECK_NEAR(at.dyn().b, before.b + 0.2 * before.drift_momentum - before.J_com.transpose() * F, 1e-9);
  CHECK_NEAR(at.dyn().F_ext, F, 1e-12);
  const double h = before.com.z();
  const ForcedPendulum forced = forced_pendulum(at.dyn(), 0.0);
  CHECK_NEAR(forced.shift, Vec2(h / kGravity * Vec2(0.5, -0.2)), 1e-9);  // d T_c^2
  BOOST_CHECK_CLOSE(forced.gravity, kGravity, 1e-9);                     // a heavier robot is no other pendulum
}

BOOST_AUTO_TEST_CASE(an_attitude_that_its_angular_velocity_explains_is_taken_as_measured) {
  AttitudeObserver attitude(settings(), kGravity);
  Mat3 R = turned(Vec3(0.1, -0.2, 0.4));
  attitude.reset(R);
  for (int k = 0; k < 1000; ++k) {
    const Vec3 omega(3.0 * std::sin(0.02 * k), 1.0, -2.0);
    R = R * turned(omega * kDt);
    Vec4 q = numbers_of(R);
    BOOST_REQUIRE(!attitude.correct(q, omega));
    BOOST_REQUIRE_EQUAL(q, numbers_of(R));
  }
}

BOOST_AUTO_TEST_CASE(noise_of_the_attitude_is_reduced_by_a_factor_of_ten) {
  AttitudeObserver attitude(settings(), kGravity);
  std::mt19937 random(3);
  std::normal_distribution<double> gauss(0.0, 0.0087);
  Mat3 R = Mat3::Identity();
  attitude.reset(R);
  double square = 0.0;
  constexpr int kSettled = 2000, kCycles = 6000;
  for (int k = 0; k < kCycles; ++k) {
    const Vec3 omega(0.5 * std::sin(0.01 * k), 0.3, -0.2);
    R = R * turned(omega * kDt);
    Vec4 q = numbers_of(R * turned(Vec3(gauss(random), gauss(random), gauss(random))));
    attitude.correct(q, omega + Vec3(gauss(random), gauss(random), gauss(random)));
    const Mat3 believed = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
    if (k >= kSettled) square += orientation_error(R, believed).squaredNorm();
  }
  BOOST_CHECK_LE(std::sqrt(square / (kCycles - kSettled)), 0.1 * std::sqrt(3.0) * 0.0087);
}

BOOST_AUTO_TEST_CASE(a_biased_attitude_is_told_from_a_force_and_from_a_slope) {
  const WalkSettings s = settings();
  const Vec3 bias(0.03, -0.02, 0.0);
  // The robot's base is level and its heading is 1 rad; its believed attitude is off by what is left of the bias.
  const auto after = [&](double force_share, double slope_share) {
    AttitudeObserver attitude(s, kGravity);
    const Mat3 R = rotation_z(1.0);
    attitude.reset(R);
    for (int k = 0; k < 8000; ++k) {
      Vec4 q = numbers_of(R * turned(bias));
      attitude.correct(q, Vec3::Zero());
      const Mat3 believed = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
      const Vec3 n = believed * R.transpose() * Vec3::UnitZ();
      attitude.look_for_bias(believed, Vec3(slope_share * n.x(), slope_share * n.y(), 1.0),
                             -kGravity * force_share * n.head<2>());
    }
    return attitude.bias();
  };
  // What does not count is left along either axis of the world.
  const double left = std::max(s.observer.sole_tilt, s.observer.tolerance / kGravity);
  CHECK_NEAR(after(1.0, 1.0), bias, std::sqrt(2.0) * left);
  CHECK_NEAR(after(1.0, 0.0), Vec3::Zero(), 0.0);   // a force: the sole is level
  CHECK_NEAR(after(0.0, 1.0), Vec3::Zero(), 0.0);   // a slope: nothing accelerates the COM
  CHECK_NEAR(after(1.0, -1.0), Vec3::Zero(), 0.0);  // both, and they do not agree
}

BOOST_AUTO_TEST_CASE(a_bias_is_bounded) {
  const WalkSettings s = settings();
  AttitudeObserver attitude(s, kGravity);
  attitude.reset(Mat3::Identity());
  for (int k = 0; k < 5000; ++k) attitude.look_for_bias(Mat3::Identity(), Vec3(0.2, 0, 1), Vec2(-2.0, 0));
  BOOST_CHECK_CLOSE(attitude.bias().norm(), s.observer.bias_most, 1e-9);
}
