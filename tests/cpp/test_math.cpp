#include <Eigen/Eigenvalues>
#include <atomic>
#include <cmath>
#include <thread>

#include "testing.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/math/inverse.hpp"
#include "zmpwalk/math/mailbox.hpp"
#include "zmpwalk/math/rotation.hpp"
#include "zmpwalk/math/spline.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

/// Symmetric positive semi-definite, of the rank that `eigenvalues` (ascending) has.
RowMatX with_eigenvalues(const VecX& eigenvalues, unsigned seed) {
  Numbers numbers(seed);
  const long n = eigenvalues.size();
  const MatX A = numbers.vector(n * n, 1.0).reshaped(n, n);
  const MatX V = Eigen::SelfAdjointEigenSolver<MatX>(A + A.transpose()).eigenvectors();
  return V * eigenvalues.asDiagonal() * V.transpose();
}

}  // namespace

BOOST_AUTO_TEST_CASE(cubic_meets_position_and_velocity_at_both_ends) {
  const Cubic cubic(0.1, -0.4, 0.7, 0.2, 0.64);
  CHECK_NEAR(cubic.at(0.0).p, 0.1, 1e-15);
  CHECK_NEAR(cubic.at(0.0).v, -0.4, 1e-15);
  CHECK_NEAR(cubic.at(0.64).p, 0.7, 1e-14);
  CHECK_NEAR(cubic.at(0.64).v, 0.2, 1e-14);
  BOOST_CHECK_EQUAL(cubic.duration(), 0.64);
}

BOOST_AUTO_TEST_CASE(cubic_velocity_and_acceleration_are_derivatives_of_its_position) {
  const Cubic cubic(0.1, -0.4, 0.7, 0.2, 0.64);
  const double h = 1e-5;
  for (double t = 0.01; t < 0.63; t += 0.01) {
    CHECK_NEAR(cubic.at(t).v, (cubic.at(t + h).p - cubic.at(t - h).p) / (2 * h), 1e-8);
    CHECK_NEAR(cubic.at(t).a, (cubic.at(t + h).v - cubic.at(t - h).v) / (2 * h), 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(cubic_holds_past_its_ends) {
  const Cubic cubic(0.1, -0.4, 0.7, 0.2, 0.64);
  for (const double t : {-1.0, -1e-9}) {
    BOOST_CHECK_EQUAL(cubic.at(t).p, cubic.at(0.0).p);
    BOOST_CHECK_EQUAL(cubic.at(t).v, cubic.at(0.0).v);
    BOOST_CHECK_EQUAL(cubic.at(t).a, 0.0);
  }
  BOOST_CHECK_EQUAL(cubic.at(2.0).p, cubic.at(0.64).p);
  BOOST_CHECK_EQUAL(cubic.at(2.0).v, cubic.at(0.64).v);
  BOOST_CHECK_EQUAL(cubic.at(2.0).a, 0.0);
}

BOOST_AUTO_TEST_CASE(cubic_without_duration_is_at_its_end) {
  for (const double T : {0.0, -0.1}) {
    const Motion1 at = Cubic(0.1, -0.4, 0.7, 0.2, T).at(0.0);
    BOOST_CHECK_EQUAL(at.p, 0.7);
    BOOST_CHECK_EQUAL(at.v, 0.2);
    BOOST_CHECK_EQUAL(at.a, 0.0);
  }
}

BOOST_AUTO_TEST_CASE(skew_is_the_cross_product) {
  CHECK_NEAR(skew({1, 2, 3}) * Vec3(-4, 5, 6), Vec3(1, 2, 3).cross(Vec3(-4, 5, 6)), 0.0);
}

BOOST_AUTO_TEST_CASE(orientation_error_turns_one_frame_into_the_other) {
  Numbers numbers(1);
  for (const double size : {1e-9, 1e-3, 0.5, 3.0}) {
    const Vec3 axis = numbers.vector(3, 1.0).normalized();
    const Mat3 R(Eigen::AngleAxisd(1.0, Vec3(numbers.vector(3, 1.0).normalized())));
    const Mat3 R_des = Mat3(Eigen::AngleAxisd(size, axis)) * R;  // a turn about an axis of the world
    CHECK_NEAR(orientation_error(R_des, R), size * axis, 1e-14);
  }
  CHECK_NEAR(orientation_error(Mat3::Identity(), Mat3::Identity()), Vec3::Zero(), 0.0);
}

BOOST_AUTO_TEST_CASE(orientation_error_is_the_time_integral_of_the_angular_velocity) {
  const Vec3 omega(0.3, -0.7, 1.1);  // world axes
  const Mat3 R = rotation_z(0.4);
  const double h = 1e-6;
  const Mat3 later = R + h * skew(omega) * R;
  CHECK_NEAR(orientation_error(later, R) / h, omega, 1e-5);
}

BOOST_AUTO_TEST_CASE(yaw_is_the_heading_of_the_x_axis) {
  for (const double yaw : {-3.0, -0.5, 0.0, 1.2}) {
    CHECK_NEAR(yaw_of(rotation_z(yaw)), yaw, 1e-15);
    const Mat3 pitched = rotation_z(yaw) * Mat3(Eigen::AngleAxisd(0.4, Vec3::UnitY()));
    CHECK_NEAR(yaw_of(pitched), yaw, 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(wrapped_angle_is_the_same_turn_within_pi) {
  for (double angle = -20.0; angle < 20.0; angle += 0.37) {
    BOOST_CHECK_LE(std::abs(wrap_angle(angle)), M_PI);
    CHECK_NEAR(std::sin(wrap_angle(angle)), std::sin(angle), 1e-13);
    CHECK_NEAR(std::cos(wrap_angle(angle)), std::cos(angle), 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(symmetric_factors_are_the_pseudo_inverse_and_the_null_space) {
  const VecX eigenvalues = (VecX(6) << 0, 0, 1e-7, 0.02, 0.5, 1).finished();  // cut by count: 1e-7 counts
  const RowMatX W = with_eigenvalues(eigenvalues, 2);
  const SymmetricFactors factors = factor_symmetric(W, 4);
  CHECK_NEAR(W * factors.pinv * W, W, 1e-8);
  CHECK_NEAR(factors.pinv, factors.pinv.transpose(), 1e-8);
  BOOST_CHECK_EQUAL(factors.null_space.cols(), 2);
  CHECK_NEAR(W * factors.null_space, RowMatX::Zero(6, 2), 1e-13);
  CHECK_NEAR(factors.null_space.transpose() * factors.null_space, RowMatX::Identity(2, 2), 1e-14);
  CHECK_NEAR(factors.pinv * factors.null_space, RowMatX::Zero(6, 2), 1e-7);
}

BOOST_AUTO_TEST_CASE(symmetric_factors_of_full_rank_are_the_inverse) {
  const RowMatX W = with_eigenvalues((VecX(3) << 0.5, 1, 2).finished(), 3);
  const SymmetricFactors factors = factor_symmetric(W, 3);
  CHECK_NEAR(W * factors.pinv, RowMatX::Identity(3, 3), 1e-14);
  BOOST_CHECK_EQUAL(factors.null_space.cols(), 0);
}

BOOST_AUTO_TEST_CASE(symmetric_factors_refuse_wrong_shapes_and_ranks) {
  CHECK_THROWS(factor_symmetric(RowMatX::Zero(2, 3), 1), DimensionError, "W is (2, 3); it must be (2, 2)");
  CHECK_THROWS(factor_symmetric(RowMatX::Zero(2, 2), 3), DimensionError, "rank = 3; it must be in 0..2");
  CHECK_THROWS(factor_symmetric(RowMatX::Zero(2, 2), -1), DimensionError, "rank = -1");
}

BOOST_AUTO_TEST_CASE(inverse_of_a_positive_definite_matrix_is_exactly_symmetric) {
  const RowMatX M = with_eigenvalues((VecX(5) << 0.01, 0.5, 1, 2, 30).finished(), 4);
  const RowMatX inverse = inverse_spd(M);
  CHECK_NEAR(M * inverse, RowMatX::Identity(5, 5), 1e-12);
  CHECK_NEAR(inverse, inverse.transpose(), 0.0);
}

BOOST_AUTO_TEST_CASE(inverse_refuses_indefinite_and_rectangular_matrices) {
  const RowMatX indefinite = Vec3(1, -1, 2).asDiagonal();
  CHECK_THROWS(inverse_spd(indefinite), InputError, "positive definite");
  CHECK_THROWS(inverse_spd(RowMatX::Zero(2, 3)), DimensionError, "M is (2, 3); it must be (2, 2)");
}

BOOST_AUTO_TEST_CASE(requirements_say_name_value_and_rule) {
  CHECK_THROWS(require_size("tau", 3, 25), DimensionError, "tau has 3 entries; it must have 25");
  CHECK_THROWS(require_shape("A", 2, 3, 4, 5), DimensionError, "A is (2, 3); it must be (4, 5)");
  CHECK_THROWS(require_finite("v", kNaN), InputError, "v = nan; it must be a finite number");
  CHECK_THROWS(require_positive("z_c", 0.0), InputError, "z_c = 0.000000; it must be finite and greater than 0");
  CHECK_THROWS(require_positive("z_c", INFINITY), InputError, "z_c = inf");
  CHECK_THROWS(require_positive("z_c", kNaN), InputError, "z_c = nan");
  BOOST_CHECK_NO_THROW(require_size("tau", 25, 25));
  BOOST_CHECK_NO_THROW(require_shape("A", 4, 5, 4, 5));
  BOOST_CHECK_NO_THROW(require_finite("v", -1.0));
  BOOST_CHECK_NO_THROW(require_positive("z_c", 1e-300));
}

BOOST_AUTO_TEST_CASE(left_is_positive_and_the_other_side_of_right) {
  BOOST_CHECK_EQUAL(side_sign(kLeft), 1.0);
  BOOST_CHECK_EQUAL(side_sign(kRight), -1.0);
  BOOST_CHECK(other(kRight) == kLeft && other(kLeft) == kRight);
}

BOOST_AUTO_TEST_CASE(mailbox_gives_the_newest_once_and_nothing_before) {
  Mailbox box;
  Vec3 got = Vec3::Constant(kNaN);
  BOOST_CHECK(!box.take(got));
  box.put({1, 2, 3});
  box.put({4, 5, 6});
  BOOST_CHECK(box.take(got));
  CHECK_NEAR(got, Vec3(4, 5, 6), 0.0);
  BOOST_CHECK(!box.take(got));
}

BOOST_AUTO_TEST_CASE(mailbox_never_mixes_what_two_threads_put) {
  constexpr int kPuts = 200000;
  Mailbox box;
  std::atomic<int> writing{2};
  const auto put = [&](double sign) {
    for (int i = 1; i <= kPuts; ++i) box.put(sign * Vec3(i, 2 * i, 3 * i));
    --writing;
  };
  std::thread forward(put, 1.0), backward(put, -1.0);
  double newest[2] = {0.0, 0.0};
  int torn = 0, stale = 0;
  Vec3 got = Vec3::Zero();
  for (bool more = true; more;) {
    more = writing > 0;  // read before the last look into the box
    if (!box.take(got)) continue;
    double& before = newest[got.x() > 0];
    torn += got != got.x() * Vec3(1, 2, 3);
    stale += std::abs(got.x()) <= before;
    before = std::abs(got.x());
  }
  forward.join();
  backward.join();
  BOOST_CHECK_EQUAL(std::abs(got.x()), kPuts);  // the last of all is never lost
  BOOST_CHECK_EQUAL(torn, 0);
  BOOST_CHECK_EQUAL(stale, 0);
}
