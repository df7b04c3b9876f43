#include <cmath>

#include "robots.hpp"
#include "zmpwalk/gait/pendulum.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/zmp/bounds.hpp"
#include "zmpwalk/zmp/estimate.hpp"
#include "zmpwalk/zmp/reference_iteration.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

constexpr double kThreshold = 1e-3;  // m, section IV
const Vec2 kSagittal(1, 0);

/// Passes that the loop of III-B needs where the estimate is affine with slope `s`: e_n = (1 - s)^n e_0, and the first pass has e_0.
int passes(double e_0, double s) {
  return 1 + static_cast<int>(std::ceil(std::log(kThreshold / std::abs(e_0)) / std::log(std::abs(1.0 - s))));
}

/// An estimate that is affine in the reference, with coupling between the axes.
struct Affine {
  Mat2 slope;
  Vec2 offset;
  Vec2 operator()(const Vec2& r) const { return offset + slope * r; }
};

/// The humanoid at a random instant, with the estimator of its stance.
struct Instant {
  Instant(Standing standing, unsigned seed)
      : robot(mahru(), describe(mahru())),
        data(make_data(mahru())),
        stance(stance_of(standing)),
        controller(robot.nv(), robot.leg_joints()),
        estimator(robot.nv()) {
    randomize(robot, data.get(), seed);
    robot.read(data.get());
    controller.prepare(dyn(), stance, random_tasks(robot.joints(), seed));
    const ContactRows rows = contact_rows(dyn(), stance);
    estimator.update(dyn().A, dyn().b, dyn().g, rows.J, rows.drift, controller.feet(), stance.support);
  }
  const Dynamics& dyn() const { return robot.dynamics(); }
  ZmpEstimate estimate(const Vec2& f_xy) const {
    WholeBodyResult out = controller.result();
    controller.solve(f_xy, out);
    return estimator.estimate(out.tau);
  }

  Robot robot;
  MjDataPtr data;
  Stance stance;
  WholeBodyController controller;
  ZmpEstimator estimator;
};

}  // namespace

BOOST_AUTO_TEST_CASE(zmp_of_a_wrench_by_hand) {
  // A load of 100 N at x = 0.03, y = -0.02: moment p x F.
  const Vec3 F(0, 0, -100), p(0.03, -0.02, 0);
  CHECK_NEAR(zmp_of_wrench(F, p.cross(F)), p.head<2>(), 1e-16);
  CHECK_NEAR(zmp_of_wrench(-F, Vec3(-p.cross(F))), p.head<2>(), 1e-16);  // either sign of the convention
  CHECK_NEAR(zmp_of_wrench(F, p.cross(F) + Vec3(0, 0, 7)), p.head<2>(), 1e-16);
  CHECK_NEAR(zmp_of_wrench(Vec3(5, 0, -100), Vec3(2, -3, 0)), Vec2(-0.03, -0.02), 1e-16);
}

BOOST_AUTO_TEST_CASE(total_wrench_moves_moments_and_leaves_out_feet_in_the_air) {
  const std::array<Vec3, 2> c{Vec3(0, 0.1, 0), Vec3(0.2, -0.1, 0)};
  Vec12 f;
  f << 0, 0, -30, 1, 2, 3, 0, 0, -10, 0, 0, 0;
  const Wrench both = total_wrench(f, c, Vec3::Zero());
  CHECK_NEAR(both.F, Vec3(0, 0, -40), 0.0);
  CHECK_NEAR(both.M, Vec3(1 - 0.1 * 30 + 0.1 * 10, 2 + 0.2 * 10, 3), 1e-14);
  f.tail<6>().setConstant(kNaN);
  CHECK_NEAR(total_wrench(f, c, c[kLeft]).M, Vec3(1, 2, 3), 0.0);
}

BOOST_AUTO_TEST_CASE(estimated_zmp_and_wrench_are_those_the_torque_was_computed_for) {
  for (const Standing standing : kStandings)
    for (unsigned seed = 0; seed < 20; ++seed) {
      const Instant at(standing, seed);
      const Vec2 f_xy = Numbers(seed).vector(2, 3.0);
      WholeBodyResult out = at.controller.result();
      at.controller.solve(f_xy, out);
      const ZmpEstimate estimate = at.estimate(f_xy);
      BOOST_CHECK(estimate.in_contact);
      CHECK_NEAR(estimate.zmp, at.controller.zmp(f_xy), 1e-8);
      for (const Side side : kSides) {
        if (at.stance.standing[side])
          CHECK_NEAR(estimate.f_c.segment<6>(6 * side), out.f_c.segment<6>(6 * side), 1e-8);
        else
          BOOST_CHECK(estimate.f_c.segment<6>(6 * side).array().isNaN().all());
      }
    }
}

BOOST_AUTO_TEST_CASE(estimate_is_affine_in_the_commanded_acceleration) {
  for (const Standing standing : kStandings)
    for (unsigned seed = 0; seed < 10; ++seed) {
      const Instant at(standing, seed);
      const Vec2 zero = at.estimate({0, 0}).zmp, x = at.estimate({1, 0}).zmp - zero, y = at.estimate({0, 1}).zmp - zero;
      CHECK_NEAR(at.estimate({-7, 4}).zmp, zero - 7 * x + 4 * y, 1e-10);
      CHECK_NEAR(at.controller.zmp_slope().col(0), x, 1e-10);
      CHECK_NEAR(at.controller.zmp_slope().col(1), y, 1e-10);
    }
}

BOOST_AUTO_TEST_CASE(angular_momentum_of_the_links_makes_the_slope_steeper_than_the_pendulums) {
  Instant at(Standing::kLeft, 0);
  at.robot.description().place(mahru(), at.data.get());
  at.robot.read(at.data.get());
  TaskAccelerations none;
  none.posture = VecX::Zero(at.robot.joints());
  at.controller.prepare(at.dyn(), at.stance, none);
  const double pendulum = -(at.dyn().com.z() - at.dyn().sole[kLeft].p_WF.z()) / 9.81,
               slope = at.controller.zmp_slope()(0, 0);
  BOOST_CHECK_GT(slope / pendulum, 1.05);
  BOOST_CHECK_LT(slope / pendulum, 1.25);
}

BOOST_AUTO_TEST_CASE(estimate_without_normal_force_has_no_zmp) {
  Instant at(Standing::kLeft, 1);
  // A robot in free fall: no weight, no motion, no torque.
  const ContactRows rows = contact_rows(at.dyn(), at.stance);
  const VecX zero = VecX::Zero(31);
  at.estimator.update(at.dyn().A, zero, zero, rows.J, VecX::Zero(6), at.controller.feet(), kLeft);
  const ZmpEstimate estimate = at.estimator.estimate(VecX::Zero(25));
  BOOST_CHECK(!estimate.in_contact);
  BOOST_CHECK(estimate.zmp.array().isNaN().all());
}

BOOST_AUTO_TEST_CASE(estimator_refuses_what_it_cannot_use) {
  Instant at(Standing::kBoth, 1);
  CHECK_THROWS(at.estimator.estimate(VecX::Zero(31)), DimensionError, "tau has 31 entries; it must have 25");
  const ContactRows rows = contact_rows(at.dyn(), at.stance);
  const auto update = [&](const std::array<bool, 2>& standing) {
    std::array<Contact, 2> feet;
    for (const Side side : kSides) feet[side].standing = standing[side];
    at.estimator.update(at.dyn().A, at.dyn().b, at.dyn().g, rows.J, rows.drift, feet, kLeft);
  };
  CHECK_THROWS(update({false, false}), InputError, "no foot stands");
  CHECK_THROWS(update({true, false}), DimensionError, "J_c is (12, 31); it must be (6, 31)");
}

BOOST_AUTO_TEST_CASE(bounds_are_the_sole_where_the_ankle_is_strong) {
  const double strong = std::numeric_limits<double>::infinity();
  const ZmpBounds bounds = zmp_bounds({0.25, 0.14, Vec2(-0.02, 0), strong, strong}, 600.0, 0.72, 0.9);
  CHECK_NEAR(bounds.upper, Vec2(0.09, 0.0504), 1e-15);
  CHECK_NEAR(bounds.lower, Vec2(-0.09, -0.0504), 1e-15);
  CHECK_NEAR(bounds.clamp({0.2, -0.2}), Vec2(0.09, -0.0504), 1e-15);
  CHECK_NEAR(bounds.clamp({0.01, 0.02}), Vec2(0.01, 0.02), 0.0);
}

BOOST_AUTO_TEST_CASE(bounds_are_what_a_weak_ankle_can_hold) {
  // 0.9 * 40 N m / 600 N = 0.06 m about the pitch axis, 0.9 * 20 / 600 = 0.03 m about the roll axis.
  const ZmpBounds bounds = zmp_bounds({0.25, 0.14, Vec2(-0.05, 0.01), 40.0, 20.0}, 600.0, 0.72, 0.9);
  CHECK_NEAR(bounds.upper, Vec2(0.01, 0.04), 1e-15);
  CHECK_NEAR(bounds.lower, Vec2(-0.09, -0.02), 1e-15);
}

BOOST_AUTO_TEST_CASE(com_rides_where_either_foot_gives_the_zmp_a_fifth_of_a_sole_ahead_and_behind) {
  const auto place = [](double lower, double upper, double wanted) {
    const ZmpBounds bounds{Vec2(lower, -0.05), Vec2(upper, 0.05)};
    return place_with_room({bounds, bounds}, 0.25, wanted);
  };
  CHECK_NEAR(place(-0.09, 0.09, 0.01), 0.01, 0.0);
  CHECK_NEAR(place(-0.09, 0.02, 0.01), -0.03, 1e-15);
  CHECK_NEAR(place(-0.02, 0.09, 0.01), 0.03, 1e-15);
  CHECK_NEAR(place(-0.09, 0.003, 0.0), -0.0435, 1e-15);  // no room for both: the middle
  const ZmpBounds left{Vec2(-0.09, -0.05), Vec2(0.02, 0.05)}, right{Vec2(-0.08, -0.05), Vec2(0.04, 0.05)};
  CHECK_NEAR(place_with_room({left, right}, 0.25, 0.01), -0.03, 1e-15);
}

BOOST_AUTO_TEST_CASE(bounds_without_room_are_refused_with_the_numbers) {
  CHECK_THROWS(zmp_bounds({0.25, 0.14, Vec2(-0.2, 0), 10.0, 20.0}, 600.0, 0.72, 0.9), InputError,
               "no room for the ZMP along x: the sole allows +-0.090000 m, the ankle -0.200000 +- 0.015000 m");
  CHECK_THROWS(zmp_bounds({0.25, 0.14, Vec2::Zero(), 10.0, 0.0}, 600.0, 0.72, 0.9), InputError, "along y");
  CHECK_THROWS(zmp_bounds({0.25, 0.14, Vec2::Zero(), 10.0, 10.0}, 0.0, 0.72, 0.9), InputError, "weight = 0");
}

BOOST_AUTO_TEST_CASE(loop_needs_as_many_passes_as_its_contraction_says) {
  // s = 1.14 k_d dt without feed-forward and 1.14 (1 + k_d dt) with it; beyond 1 the error changes sign at each pass.
  for (const double s : {0.0456, 0.114, 0.5, 1.186, 1.8})
    for (const double e_0 : {0.15, -0.03, 0.0021}) {
      const Affine estimate{(Mat2() << s, 0, 0, s).finished(), Vec2((1 - s) * 0.09 - e_0, 0)};
      const ReferenceResult out = iterate_reference(estimate, Vec2(0.09, 0), Vec2::Zero(), kSagittal, kThreshold, 500);
      BOOST_CHECK(out.converged);
      BOOST_CHECK_LE(std::abs(out.passes - passes(e_0, s)), 1);
      BOOST_CHECK_LT(std::abs(out.zmp_est.x() - 0.09), kThreshold);
    }
}

BOOST_AUTO_TEST_CASE(error_of_the_loop_never_grows_while_the_slope_is_between_0_and_2) {
  for (const double s : {0.1, 0.9, 1.9}) {
    double last = 1.0;
    const auto estimate = [&](const Vec2& r) {
      const Vec2 est(s * r.x() - 0.05, 0);
      BOOST_CHECK_LT(std::abs(0.09 - est.x()), last);
      last = std::abs(0.09 - est.x());
      return est;
    };
    iterate_reference(estimate, Vec2(0.09, 0), Vec2::Zero(), kSagittal, kThreshold, 100);
  }
}

BOOST_AUTO_TEST_CASE(loop_beyond_slope_2_gives_up_and_says_so) {
  const Affine estimate{(Mat2() << 2.5, 0, 0, 1).finished(), Vec2(0.1, 0)};
  const ReferenceResult out = iterate_reference(estimate, Vec2(0.09, 0), Vec2::Zero(), kSagittal, kThreshold, 30);
  BOOST_CHECK(!out.converged);
  BOOST_CHECK_EQUAL(out.passes, 30);
}

BOOST_AUTO_TEST_CASE(closed_form_is_the_fixed_point_of_the_loop) {
  const Affine estimate{(Mat2() << 1.2, 0.1, -0.05, 0.9).finished(), Vec2(-0.03, 0.01)};
  for (const Vec2& axes : {Vec2(1, 0), Vec2(0, 1), Vec2(1, 1)}) {
    const Vec2 wanted(0.09, -0.04), kept(0.02, 0.03);
    const ReferenceResult exact = solve_reference(estimate, wanted, kept, axes, estimate.slope, kThreshold);
    const ReferenceResult loop = iterate_reference(estimate, wanted, kept, axes, 1e-13, 500);
    BOOST_CHECK(exact.converged && loop.converged);
    BOOST_CHECK_EQUAL(exact.passes, 2);
    CHECK_NEAR(exact.zmp_ref, loop.zmp_ref, 1e-12);
    CHECK_NEAR(exact.zmp_est, loop.zmp_est, 1e-12);
    for (int i = 0; i < 2; ++i) {
      if (axes[i] > 0.0)
        CHECK_NEAR(exact.zmp_est[i], wanted[i], 1e-14);
      else
        CHECK_NEAR(exact.zmp_ref[i], kept[i], 0.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(loop_and_closed_form_agree_on_the_humanoid) {
  for (const bool feed_forward : {false, true})
    for (const Standing standing : kStandings) {
      const Instant at(standing, 3);
      const LinearInvertedPendulum pendulum(0.75, 9.81);
      const double kp = 400, kd = 40, dt = 1e-3, x = 0.03, v = 0.25;
      const auto acceleration = [&](double r) {
        const PendulumState next = pendulum.step(dt, {x, v}, r);
        return (feed_forward ? pendulum.acceleration(x, r) : 0.0) + pd_acceleration(kp, kd, next.x - x, next.v - v);
      };
      const auto estimate = [&](const Vec2& r) { return at.estimate({acceleration(r.x()), 0.0}).zmp; };
      const Vec2 zero = estimate(Vec2::Zero());
      Mat2 slope = Mat2::Identity();
      slope.col(0) = (estimate({0.1, 0}) - zero) / 0.1;
      const Vec2 wanted = zero + Vec2(0.15, 0);  // asks for e_0 = 0.15 m - what r_ref = r_des gives
      const double e_0 = (wanted - estimate(wanted)).x();
      const ReferenceResult loop = iterate_reference(estimate, wanted, Vec2::Zero(), kSagittal, kThreshold, 500);
      const ReferenceResult exact = solve_reference(estimate, wanted, Vec2::Zero(), kSagittal, slope, kThreshold);
      BOOST_CHECK(loop.converged && exact.converged);
      CHECK_NEAR(loop.zmp_est.x(), exact.zmp_est.x(), kThreshold);
      CHECK_NEAR(exact.zmp_est.x(), wanted.x(), 1e-10);
      BOOST_CHECK_LE(std::abs(loop.passes - passes(e_0, slope(0, 0))), 1);
    }
}
