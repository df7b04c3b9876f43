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

/// Trajectory of the swing foot: cubic splines (section IV), up and down in z, and to a foothold that may move until late in x, y, yaw.
///
/// When the time left or the height of the ground changes in flight, the foot takes the cubic splines from where it is to where it now lands;
/// the acceleration that it has beside theirs fades out on the way (a quintic), so that position, velocity and acceleration go on
/// without a jump.
class SwingFoot {
 public:
  /// @param p, R      sole at lift-off   @param duration of the single support [s]
  /// @param z_land    height at which the sole lands [m]   @param height  of the top over the higher of both ends [m]
  /// @param speed     at which it comes down there [m/s]
  void begin(const Vec3& p, const Mat3& R, double duration, double z_land, double height, double speed = 0.0);
  /// From the next `update` on, at `t` [s] since lift-off, the foot is to land `left` [s] > 0 later. A foot that still rises passes its
  /// top after the same share of the time left as before; one that comes down goes on down.
  void replan(double t, double left);
  /// The foot met no ground: from the next `update` on, at `t` [s], it goes on down for `time` [s], ever slower.
  void sink(double t, double time);

  /// @param t since lift-off [s]   @param dt control period [s]
  /// The horizontal spline runs from where it is to the foothold in what is left of the time, and arrives at rest.
  const SwingTarget& update(double t, double dt, const Foothold& foothold);

  const SwingTarget& target() const { return target_; }
  double duration() const { return duration_; }  ///< from lift-off to landing [s]

 private:
  Motion1 height(double t) const;  // of the splines alone

  double duration_ = 0.0, z_land_ = 0.0, top_ = 0.0, speed_ = 0.0;
  // Up from `start_` on for `rise_` [s], then down.
  double start_ = 0.0, rise_ = 0.0;
  Cubic up_, down_;
  std::array<Motion1, 3> next_;  // of the splines in x, y, yaw, in the cycle to come
  Vec3 to_ = Vec3::Zero();       // where these were last to arrive
  // What x, y, yaw, z have beside the splines: the accelerations at `start_`, which fade out in `fade_` [s]; 0: nothing.
  std::array<double, 4> beside_{};
  double fade_ = 0.0;
  double yaw_ = 0.0;  // of the target
  SwingTarget target_;
};

}  // namespace zmpwalk
