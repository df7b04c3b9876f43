#include "zmpwalk/simulation/uncertainty.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "testing.hpp"
#include "zmpwalk/math/error.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

constexpr int kNv = 10;  // a base and four joints
constexpr double kDt = 0.001;

Eigen::Quaterniond attitude(const State& s) { return {s.q[3], s.q[4], s.q[5], s.q[6]}; }

}  // namespace

BOOST_AUTO_TEST_CASE(without_uncertainty_what_is_measured_is_the_state) {
  State truth(kNv);
  truth.q << 1, 2, 3, 0.5, 0.5, 0.5, 0.5, 0.1, 0.2, 0.3, 0.4;
  truth.dq.setLinSpaced(-1, 1);
  truth.time = 0.25;
  BOOST_CHECK(Uncertainty().none());
  Sensors sensors(Uncertainty(), kNv, kDt);
  const State& out = sensors.measure(truth);
  CHECK_NEAR(out.q, truth.q, 0.0);
  CHECK_NEAR(out.dq, truth.dq, 0.0);
  BOOST_CHECK_EQUAL(out.time, 0.25);
}

BOOST_AUTO_TEST_CASE(noise_has_no_mean_the_deviation_that_it_says_and_no_memory) {
  Uncertainty unsure;
  unsure.noise = {0.01, 0.02, 0.03, 0.04, 0.05};
  unsure.seed = 7;
  Sensors sensors(unsure, kNv, kDt);
  const State truth(kNv);
  constexpr int kCount = 20000;
  Eigen::MatrixXd errors(kCount, 5);  // a joint, its speed, gyro, attitude about x, base's speed
  for (int k = 0; k < kCount; ++k) {
    const State& out = sensors.measure(truth);
    BOOST_REQUIRE_CLOSE(attitude(out).norm(), 1.0, 1e-9);
    errors.row(k) << out.q[8], out.dq[7], out.dq[4], 2.0 * out.q[4], out.dq[1];
    CHECK_NEAR(out.q.head<3>(), truth.q.head<3>(), 0.0);  // where the base is, is known
  }
  for (int i = 0; i < 5; ++i) {
    const double deviation = 0.01 * (i + 1);
    BOOST_CHECK_SMALL(errors.col(i).mean(), 4.0 * deviation / std::sqrt(kCount));
    BOOST_CHECK_CLOSE(std::sqrt(errors.col(i).squaredNorm() / kCount), deviation, 3.0);
    const double next = errors.col(i).head(kCount - 1).dot(errors.col(i).tail(kCount - 1)) / kCount;
    BOOST_CHECK_SMALL(next, 4.0 * deviation * deviation / std::sqrt(kCount));
  }
}

BOOST_AUTO_TEST_CASE(a_bias_turns_the_attitude_in_its_own_axes) {
  Uncertainty unsure;
  unsure.roll_bias = 0.1;
  State truth(kNv);
  const Eigen::Quaterniond R_WB(Eigen::AngleAxisd(1.2, Vec3::UnitZ()));
  truth.q.segment<4>(3) << R_WB.w(), R_WB.x(), R_WB.y(), R_WB.z();
  Sensors sensors(unsure, kNv, kDt);
  const Eigen::Quaterniond want = R_WB * Eigen::AngleAxisd(0.1, Vec3::UnitX());
  CHECK_NEAR(attitude(sensors.measure(truth)).toRotationMatrix(), want.toRotationMatrix(), 1e-12);
}

BOOST_AUTO_TEST_CASE(a_delayed_state_is_that_of_so_many_steps_before_and_at_first_the_first) {
  Uncertainty unsure;
  unsure.state_delay = 0.003;
  Sensors sensors(unsure, kNv, kDt);
  State truth(kNv);
  for (int k = 0; k < 10; ++k) {
    truth.q[7] = truth.dq[6] = k;
    truth.time = kDt * k;
    const State& out = sensors.measure(truth);
    BOOST_CHECK_EQUAL(out.q[7], std::max(k - 3, 0));
    BOOST_CHECK_EQUAL(out.dq[6], std::max(k - 3, 0));
    BOOST_CHECK_EQUAL(out.time, truth.time);  // the clock is right
  }
}

BOOST_AUTO_TEST_CASE(a_lagging_drive_goes_63_percent_of_the_way_in_its_time_constant) {
  Uncertainty unsure;
  unsure.lag = 0.010;
  Drives drives(unsure, 1, kDt);
  BOOST_CHECK_EQUAL(drives.act(VecX::Zero(1))[0], 0.0);
  double acting = 0.0;
  for (int k = 0; k < 10; ++k) acting = drives.act(VecX::Ones(1))[0];
  BOOST_CHECK_CLOSE(acting, 1.0 - std::exp(-1.0), 1e-9);
}

BOOST_AUTO_TEST_CASE(a_delayed_torque_comes_so_many_steps_later) {
  Uncertainty unsure;
  unsure.torque_delay = 0.002;
  Drives drives(unsure, 1, kDt);
  for (int k = 0; k < 6; ++k) BOOST_CHECK_EQUAL(drives.act(VecX::Constant(1, k))[0], std::max(k - 2, 0));
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  Uncertainty unsure;
  unsure.lag = -1.0;
  CHECK_THROWS(Drives(unsure, 1, kDt), InputError, "lag is -1");
  unsure.lag = 0.0;
  unsure.state_delay = 2.0;
  CHECK_THROWS(Sensors(unsure, kNv, kDt), InputError, "at most 1 s");
  unsure.state_delay = kNaN;
  CHECK_THROWS(Sensors(unsure, kNv, kDt), InputError, "state_delay");
}
