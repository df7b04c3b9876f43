#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "zmpwalk/math/types.hpp"
#include "zmpwalk/robot/state.hpp"

namespace zmpwalk {

/// Standard deviations of what is measured: white and Gaussian.
struct SensorNoise {
  double joint = 0.0;        ///< joint positions, by encoders [rad]
  double joint_speed = 0.0;  ///< [rad/s]
  double gyro = 0.0;         ///< angular velocity of the base [rad/s]
  double attitude = 0.0;     ///< of the base, about each of its axes [rad]
  double base_speed = 0.0;   ///< along each axis [m/s]
};

/// What a controller on a robot has to live with, and in a simulation need not: by default nothing.
struct Uncertainty {
  SensorNoise noise;
  double roll_bias = 0.0, pitch_bias = 0.0;  ///< of the measured attitude, about the base's x and y [rad]
  double state_delay = 0.0;                  ///< age of the position and velocity that are measured [s]
  double torque_delay = 0.0;                 ///< from a torque's decision to its effect [s]
  double lag = 0.0;                          ///< time constant with which a drive takes a torque up [s]
  std::uint64_t seed = 0;                    ///< of the noise

  /// True where the controller reads the state, and its torque acts, as they are.
  bool none() const;
  /// Itself. @throws InputError  a number that is not finite, or, but for a bias, below 0; a delay or lag above 1 s
  const Uncertainty& checked() const;
};

/// Vectors that come out so many steps after they went in; until then, the first.
class DelayLine {
 public:
  DelayLine(int steps, Eigen::Index size) : line_(static_cast<std::size_t>(steps) + 1, VecX::Zero(size)) {}
  /// Takes in this step's and gives that of `steps` before. Allocates nothing.
  const VecX& pass(const VecX& in);

 private:
  std::vector<VecX> line_;
  std::size_t next_ = 0;
  bool filled_ = false;
};

/// What the robot's sensors make of its state.
class Sensors {
 public:
  /// @param nv velocity coordinates of the robot   @param dt time between two measurements [s]. @throws InputError  as `checked`
  Sensors(const Uncertainty& uncertainty, int nv, double dt);
  /// The position and velocity that are measured when the robot is in `truth`, with its time. Allocates nothing.
  const State& measure(const State& truth);

 private:
  double gauss(double deviation);  // mean 0

  Uncertainty uncertainty_;
  DelayLine q_, dq_;
  State measured_;
  std::mt19937_64 random_;
};

/// What the robot's drives make of the torque that is sent.
class Drives {
 public:
  /// @param joints of the robot   @param dt time between two torques [s]
  Drives(const Uncertainty& uncertainty, int joints, double dt);
  /// The torque that acts when `tau` (joints,) is sent [N m]. Allocates nothing.
  const VecX& act(const VecX& tau);

 private:
  DelayLine sent_;
  VecX acting_;
  double share_;  // of the way to the torque that is sent, which one step goes
  bool started_ = false;
};

}  // namespace zmpwalk
