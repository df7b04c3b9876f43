#pragma once

#include "zmpwalk/control/dynamics.hpp"
#include "zmpwalk/control/external.hpp"
#include "zmpwalk/math/types.hpp"
#include "zmpwalk/settings/settings.hpp"

namespace zmpwalk {

/// Finds the steady acceleration d of the COM that the command does not explain: by a force, or by masses that differ from the model's.
///
/// A robot that is told the acceleration f, with d_c of it to make up for d, accelerates by f - d_c + d. With e = dv - (f - d_c) dt, what the
/// COM's speed changes by beyond the command, two low-passes in a row give d: p += (e - p dt) / T, and d += (p - d) dt / T. Where p is that of a push,
/// d goes back to what it was before, and waits until the push has passed. T is the setting `observer.time`, and up to four times as much where the
/// measured speed is noisy: then the root mean square of e - p dt tells by how much.
///
/// Of d, what is beyond `observer.tolerance` counts, up to a bound. The horizontal part counts as a force at the COM. The vertical part counts as
/// a mass 1 - d_z / g times the model's; so a COM that is too low or too high comes back to its height, and the pendulum keeps its T_c.
class DisturbanceObserver {
 public:
  /// @param settings resolved   @param gravity [m/s^2]
  DisturbanceObserver(const WalkSettings& settings, double gravity);

  void reset(const Vec3& dcom);
  /// Takes the velocity of the COM in this cycle, W (3,) [m/s]. While `frozen`, d stays: the robot has fallen, or did not get the torque that the
  /// command takes. Allocates nothing.
  void update(const Vec3& dcom, bool frozen);
  /// Says which acceleration of the COM this cycle has commanded, W (3,) [m/s^2].
  void command(const Vec3& f) { commanded_ = f - made_up_for_; }

  const Vec3& found() const { return found_; }              ///< d (3,) [m/s^2]
  const Vec3& made_up_for() const { return made_up_for_; }  ///< d_c (3,) [m/s^2]
  /// The part of d_c that has lasted, horizontal, W (2,) [m/s^2]. A push that is too weak to be told from a steady force is in d_c for a while, but
  /// hardly in here.
  Vec2 steady() const;
  Disturbance disturbance() const;
  /// Root mean square of the noise that the speed seems to have, along one axis [m/s].
  double noise() const;

 private:
  bool on_;
  double dt_, time_, speed_noise_, tolerance_, force_most_, weight_most_, push_, gravity_;
  Vec3 last_ = Vec3::Zero(), commanded_ = Vec3::Zero();
  Vec3 passing_ = Vec3::Zero(), found_ = Vec3::Zero(), made_up_for_ = Vec3::Zero();
  double square_ = 0.0;       // mean of (e - p dt)^2, of three axes
  Vec3 calm_ = Vec3::Zero();  // d over a longer time: found before the last push, and steady
  double held_ = 0.0;         // time for which that push is still waited for to pass [s]
};

/// Takes noise and bias out of the measured attitude of the base.
///
/// Noise: the angular velocity leads from the attitude of the cycle before to the one of this cycle. Where the measured one is off by more
/// than `observer.attitude_noise`, as root mean square, it corrects this prediction with the time constant `observer.attitude_time` only.
///
/// Bias: three things look alike. A steady force accelerates the COM while the soles are level. On a slope the standing sole is tilted, and nothing
/// accelerates the COM. A biased attitude tilts both: with the normal n of the sole that stands on level ground, the COM accelerates by -g (n_x, n_y)
/// beyond the command. What both agree in is the bias.
class AttitudeObserver {
 public:
  /// @param settings resolved   @param gravity [m/s^2]
  AttitudeObserver(const WalkSettings& settings, double gravity);

  /// @param R_WB measured rotation of the base
  void reset(const Mat3& R_WB);
  /// Takes the measured attitude, quaternion (w, x, y, z), and angular velocity [rad/s], base axes, and puts what the base's attitude is believed to
  /// be in place of the first.
  /// Returns false where that is the measured one, to the bit. Allocates nothing.
  bool correct(Eigen::Ref<Vec4> quaternion, const Vec3& omega);
  /// Looks for the bias. @param R_WB as believed   @param sole_normal  of the foot that stands alone, W   @param acceleration  found by the
  /// `DisturbanceObserver`, W (2,) [m/s^2]. Allocates nothing.
  void look_for_bias(const Mat3& R_WB, const Vec3& sole_normal, const Vec2& acceleration);

  const Vec3& bias() const { return bias_; }  ///< rotation vector, base axes (3,) [rad]

 private:
  bool on_;
  double dt_, time_, noise_, tolerance_, bias_time_, bias_most_, sole_tilt_, gravity_;
  Mat3 R_WB_ = Mat3::Identity();  // without the noise
  double square_ = 0.0;           // mean square of the angle to the measured attitude [rad^2]
  Vec2 tilt_ = Vec2::Zero();      // of the standing sole, low-passed
  Vec3 bias_ = Vec3::Zero();
};

}  // namespace zmpwalk
