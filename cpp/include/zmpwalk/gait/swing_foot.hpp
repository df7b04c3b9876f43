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
class SwingFoot {
 public:
  /// @param p, R      sole at lift-off   @param duration of the single support [s]
  /// @param z_land    height at which the sole lands [m]   @param height  of the top over the higher of both ends [m]
  void begin(const Vec3& p, const Mat3& R, double duration, double z_land, double height);

  /// @param t since lift-off [s]   @param dt control period [s]
  /// The horizontal spline runs from where it is to the foothold in what is left of the time, and arrives at rest.
  const SwingTarget& update(double t, double dt, const Foothold& foothold);

  const SwingTarget& target() const { return target_; }

 private:
  double duration_ = 0.0;
  Cubic up_, down_;
  Vec3 from_ = Vec3::Zero();  // x, y, yaw now
  Vec3 velocity_ = Vec3::Zero();
  double yaw_ = 0.0;  // of the target
  SwingTarget target_;
};

}  // namespace zmpwalk
