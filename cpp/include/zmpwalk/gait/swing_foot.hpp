#pragma once

#include "zmpwalk/gait/footsteps.hpp"
#include "zmpwalk/math/spline.hpp"
#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// Desired motion of the swing sole in W.
struct SwingTarget {
  Vec3 p = Vec3::Zero();      ///< sole centre [m]
  Vec3 v = Vec3::Zero();      ///< [m/s]
  Vec3 a = Vec3::Zero();      ///< [m/s^2]
  Mat3 R = Mat3::Identity();  ///< sole orientation
  Vec3 omega = Vec3::Zero();  ///< [rad/s], world axes
  Vec3 alpha = Vec3::Zero();  ///< [rad/s^2]
};

/// The path of the swing foot through the air, by cubic splines (section IV): in z up and then down, and in x, y and yaw to a foothold that may move
/// until late.
///
/// When the time that is left or the height of the ground changes in flight, the foot takes new splines from where it is to where it now lands. The
/// difference between its acceleration and theirs fades out on the way along a quintic. So position, velocity and acceleration go on
/// without a jump.
class SwingFoot {
 public:
  /// The foot lifts off. @param p, R  pose of the sole at lift-off, W   @param duration of the single support [s]
  /// @param z_land    height at which the sole lands, W [m]   @param height  height of the path's top over the higher one of its two ends [m]
  /// @param speed     speed at which the sole comes down onto the ground [m/s]
  void begin(const Vec3& p, const Mat3& R, double duration, double z_land, double height, double speed = 0.0);
  /// Lets the foot land `left` [s] > 0 after the next `update`, which is at `t` [s] since lift-off. A foot that still rises passes its top after the
  /// same share of the time that is left as before; one that comes down goes on down.
  void replan(double t, double left);
  /// The foot met no ground where it should have: from the next `update` on, at `t` [s], it goes on down for `time` [s], ever slower.
  void sink(double t, double time);

  /// Goes on by one cycle. In x, y and yaw the spline leads from where the foot is to the foothold in the time that is left, and arrives at rest.
  /// @param t since lift-off [s]   @param dt control period [s]
  const SwingTarget& update(double t, double dt, const Foothold& foothold);

  const SwingTarget& target() const { return target_; }
  double duration() const { return duration_; }  ///< from lift-off to landing [s]

 private:
  Motion1 height(double t) const;  // z of the splines alone, without what fades out

  double duration_ = 0.0, z_land_ = 0.0, top_ = 0.0, speed_ = 0.0;
  // The foot rises from `start_` on for `rise_` [s], and then comes down.
  double start_ = 0.0, rise_ = 0.0;
  Cubic up_, down_;
  std::array<Motion1, 3> next_;  // the splines in x, y, yaw one cycle later
  Vec3 to_ = Vec3::Zero();       // foothold (x, y, yaw) to which these splines lead
  // Differences between the accelerations of x, y, yaw, z and those of the splines at `start_`; they fade out within `fade_` [s], if it is not 0.
  std::array<double, 4> beside_{};
  double fade_ = 0.0;
  double yaw_ = 0.0;  // of the target
  SwingTarget target_;
};

}  // namespace zmpwalk
