#include "testing.hpp"
#include "zmpwalk/gait/joint_motion.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/math/rotation.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

/// Two columns through seven uneven knots.
JointMotion random_motion(unsigned seed) {
  Numbers numbers(seed);
  VecX t(7);
  RowMatX q(7, 2);
  for (int i = 0; i < 7; ++i) {
    t[i] = i == 0 ? 0.0 : t[i - 1] + numbers.uniform(0.1, 0.6);
    q.row(i) = numbers.vector(2, 1.0);
  }
  return JointMotion(t, {"a", "b"}, q);
}

Vec3 array(const Motion1& m) { return {m.p, m.v, m.a}; }

}  // namespace

BOOST_AUTO_TEST_CASE(spline_passes_its_knots_with_continuous_acceleration) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const JointMotion motion = random_motion(seed);
    for (int i = 0; i < 7; ++i)
      for (int j = 0; j < 2; ++j) {
        const double t = motion.t()[i];
        BOOST_CHECK_SMALL(motion.at(t, j).p - motion.q()(i, j), 1e-12);
        if (i == 0 || i == 6) continue;
        CHECK_NEAR(array(motion.at(t - 1e-12, j)), array(motion.at(t + 1e-12, j)), 1e-8);
      }
  }
}

BOOST_AUTO_TEST_CASE(motion_starts_and_ends_at_rest_and_holds_its_last_value) {
  const JointMotion motion = random_motion(1);
  BOOST_CHECK_EQUAL(motion.at(0.0, 0).v, 0.0);
  BOOST_CHECK_SMALL(motion.at(motion.duration() - 1e-13, 0).v, 1e-10);
  for (const double later : {0.0, 1.0, 1e6})
    CHECK_NEAR(array(motion.at(motion.duration() + later, 1)), Vec3(motion.q()(6, 1), 0, 0), 0.0);
}

BOOST_AUTO_TEST_CASE(speed_and_acceleration_are_the_derivatives) {
  constexpr double h = 1e-5;
  Numbers numbers(3);
  const JointMotion motion = random_motion(3);
  const Motion1 from{0.3, -1.0, 4.0};
  const auto check = [&](const auto& f, double t) {
    BOOST_CHECK_SMALL((f(t + h).p - f(t - h).p) / (2 * h) - f(t).v, 1e-6);
    BOOST_CHECK_SMALL((f(t + h).v - f(t - h).v) / (2 * h) - f(t).a, 1e-3);
  };
  for (int i = 0; i < 50; ++i) {
    check([&](double t) { return motion.at(t, 0); }, numbers.uniform(0.01, motion.duration() - 0.01));
    check([&](double t) { return fade_out(from, 0.7, t); }, numbers.uniform(0.01, 0.69));
  }
  CHECK_NEAR(array(fade_out(from, 0.7, 0.0)), array(from), 1e-13);
  CHECK_NEAR(array(fade_out(from, 0.7, 0.7 - 1e-9)), Vec3::Zero(), 1e-6);
}

BOOST_AUTO_TEST_CASE(extent_holds_the_turning_points_between_knots) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const JointMotion motion = random_motion(seed);
    const JointMotion::Extent extent = motion.extent(0);
    double low = kNaN, high = kNaN;
    for (double t = 0.0; t <= motion.duration(); t += 1e-3) {
      low = std::fmin(low, motion.at(t, 0).p);
      high = std::fmax(high, motion.at(t, 0).p);
    }
    BOOST_CHECK_SMALL(extent.low - low, 1e-4);
    BOOST_CHECK_SMALL(extent.high - high, 1e-4);
    BOOST_CHECK_SMALL(motion.at(extent.t_high, 0).p - extent.high, 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(reference_goes_over_into_a_motion_without_a_jump_and_then_is_the_motion) {
  MotionReference reference(Vec3(0.5, -0.2, 0.1));
  const JointMotion first = random_motion(4), second = random_motion(5);
  reference.start(first, {2, 0}, 0.5);
  double t = 0.0;
  for (; t < 0.8; t += 0.01) reference.update(t);
  reference.update(t);
  const VecX q = reference.q(), dq = reference.dq(), ddq = reference.ddq();
  reference.start(second, {0, 1}, 0.5);
  reference.update(t);
  CHECK_NEAR(reference.q(), q, 1e-14);
  CHECK_NEAR(reference.dq(), dq, 1e-13);
  CHECK_NEAR(reference.ddq(), ddq, 1e-11);
  reference.update(t + 0.6);
  CHECK_NEAR(reference.q(), Vec3(second.at(0.6, 0).p, second.at(0.6, 1).p, 0.1), 1e-13);  // what it does not name rests
  BOOST_CHECK(reference.names(1) && !reference.names(2));
  reference.reset();
  reference.update(0.0);
  CHECK_NEAR(reference.q(), Vec3(0.5, -0.2, 0.1), 0.0);
}

BOOST_AUTO_TEST_CASE(turning_rates_are_the_derivatives_of_its_rotation) {
  constexpr double h = 1e-6;
  const Motion1 roll{0.3, -0.7, 2.0}, pitch{-0.4, 1.1, -3.0}, yaw{0.9, 0.5, 1.5};
  const auto at = [&](double t) {
    const auto move = [t](const Motion1& m) { return Motion1{m.p + t * (m.v + 0.5 * t * m.a), m.v + t * m.a, m.a}; };
    return turning(move(roll), move(pitch), move(yaw));
  };
  const Turning now = at(0.0);
  CHECK_NEAR((at(h).R - at(-h).R) / (2 * h), skew(now.omega) * now.R, 1e-8);
  CHECK_NEAR((at(h).omega - at(-h).omega) / (2 * h), now.alpha, 1e-8);
}

BOOST_AUTO_TEST_CASE(motions_that_cannot_be_say_why) {
  const auto motion = [](std::vector<double> t, std::vector<std::string> names, const RowMatX& q) {
    return JointMotion(Eigen::Map<VecX>(t.data(), static_cast<long>(t.size())), std::move(names), q);
  };
  const RowMatX two = RowMatX::Zero(2, 1);
  BOOST_CHECK_THROW(motion({}, {"a"}, RowMatX::Zero(0, 1)), InputError);
  BOOST_CHECK_THROW(motion({0.1, 1}, {"a"}, two), InputError);
  BOOST_CHECK_THROW(motion({0, 0}, {"a"}, two), InputError);
  BOOST_CHECK_THROW(motion({0, kNaN}, {"a"}, two), InputError);
  BOOST_CHECK_THROW(motion({0, 1}, {"a"}, RowMatX::Constant(2, 1, kNaN)), InputError);
  BOOST_CHECK_THROW(motion({0, 1}, {"a", "a"}, RowMatX::Zero(2, 2)), InputError);
  BOOST_CHECK_THROW(motion({0, 1}, {"a", "b"}, two), DimensionError);
}
