#include "zmpwalk/simulation/uncertainty.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/robot/words.hpp"

namespace zmpwalk {
namespace {

constexpr double kLongest = 1.0;  // delay or lag [s]

int steps(double delay, double dt) { return static_cast<int>(std::lround(delay / dt)); }

/// Uniform in (0, 1), the same on every machine.
double uniform(std::mt19937_64& random) { return (static_cast<double>(random() >> 11) + 0.5) * 0x1.0p-53; }

}  // namespace

bool Uncertainty::none() const {
  return noise.joint == 0.0 && noise.joint_speed == 0.0 && noise.gyro == 0.0 && noise.attitude == 0.0 &&
         noise.base_speed == 0.0 && roll_bias == 0.0 && pitch_bias == 0.0 && state_delay == 0.0 &&
         torque_delay == 0.0 && lag == 0.0;
}

const Uncertainty& Uncertainty::checked() const {
  require_finite("roll_bias", roll_bias);
  require_finite("pitch_bias", pitch_bias);
  const std::pair<const char*, double> values[] = {{"the noise of joint positions", noise.joint},
                                                   {"the noise of joint speeds", noise.joint_speed},
                                                   {"the noise of the gyro", noise.gyro},
                                                   {"the noise of the attitude", noise.attitude},
                                                   {"the noise of the base's speed", noise.base_speed},
                                                   {"state_delay", state_delay},
                                                   {"torque_delay", torque_delay},
                                                   {"lag", lag}};
  for (const auto& [name, value] : values) {
    require_finite(name, value);
    if (value < 0.0) throw InputError(std::string(name) + " is " + number(value) + "; it must be at least 0");
  }
  for (const auto& [name, value] : {values[5], values[6], values[7]})
    if (value > kLongest)
      throw InputError(std::string(name) + " is " + number(value) + " s; it must be at most " + number(kLongest) +
                       " s");
  return *this;
}

const VecX& DelayLine::pass(const VecX& in) {
  if (!filled_)
    for (VecX& each : line_) each = in;
  filled_ = true;
  line_[next_] = in;
  next_ = (next_ + 1) % line_.size();
  return line_[next_];
}

Sensors::Sensors(const Uncertainty& uncertainty, int nv, double dt)
    : uncertainty_(uncertainty.checked()),
      q_(steps(uncertainty.state_delay, dt), nv + 1),
      dq_(steps(uncertainty.state_delay, dt), nv),
      measured_(nv),
      random_(uncertainty.seed) {}

double Sensors::gauss(double deviation) {  // Box and Muller
  const double u = uniform(random_), v = uniform(random_);
  return deviation * std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * M_PI * v);
}

const State& Sensors::measure(const State& truth) {
  const SensorNoise& noise = uncertainty_.noise;
  State& out = measured_;
  out.time = truth.time;
  out.q = q_.pass(truth.q);
  out.dq = dq_.pass(truth.dq);
  for (Eigen::Index i = 7; i < out.q.size(); ++i) out.q[i] += gauss(noise.joint);
  for (Eigen::Index i = 6; i < out.dq.size(); ++i) out.dq[i] += gauss(noise.joint_speed);
  Vec3 turn(uncertainty_.roll_bias, uncertainty_.pitch_bias, 0.0);
  for (int i = 0; i < 3; ++i) {
    out.dq[i] += gauss(noise.base_speed);
    out.dq[3 + i] += gauss(noise.gyro);
    turn[i] += gauss(noise.attitude);
  }
  if (const double angle = turn.norm(); angle > 0.0) {
    const Eigen::Quaterniond R_WB(out.q[3], out.q[4], out.q[5], out.q[6]);
    const Eigen::Quaterniond R = (R_WB * Eigen::AngleAxisd(angle, turn / angle)).normalized();
    out.q.segment<4>(3) << R.w(), R.x(), R.y(), R.z();
  }
  return out;
}

Drives::Drives(const Uncertainty& uncertainty, int joints, double dt)
    : sent_(steps(uncertainty.checked().torque_delay, dt), joints),
      acting_(VecX::Zero(joints)),
      share_(uncertainty.lag > 0.0 ? 1.0 - std::exp(-dt / uncertainty.lag) : 1.0) {}

const VecX& Drives::act(const VecX& tau) {
  const VecX& sent = sent_.pass(tau);
  if (!started_ || share_ == 1.0)
    acting_ = sent;
  else
    acting_ += share_ * (sent - acting_);
  started_ = true;
  return acting_;
}

}  // namespace zmpwalk
