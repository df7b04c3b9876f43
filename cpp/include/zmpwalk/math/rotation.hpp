#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// Rotation about the world's z axis by `yaw` [rad].
inline Mat3 rotation_z(double yaw) {
  const double c = std::cos(yaw), s = std::sin(yaw);
  Mat3 R;
  R << c, -s, 0, s, c, 0, 0, 0, 1;
  return R;
}

/// Heading of a frame: the angle of its x axis in the horizontal plane [rad].
inline double yaw_of(const Mat3& R) { return std::atan2(R(1, 0), R(0, 0)); }

/// An angle brought into (-pi, pi].
inline double wrap_angle(double angle) { return std::remainder(angle, 2.0 * M_PI); }

/// Rotation vector, in world axes, that turns `R` into `R_des` [rad], (3,). Zero when they agree.
///
/// R_des = exp(skew(e)) R, so e feeds a task whose velocity is the angular velocity in world axes.
inline Vec3 orientation_error(const Mat3& R_des, const Mat3& R) {
  const Eigen::AngleAxisd turn(Mat3(R_des * R.transpose()));
  return turn.angle() * turn.axis();
}

}  // namespace zmpwalk
