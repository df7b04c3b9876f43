#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "zmpwalk/math/spline.hpp"
#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// Rotation about the world's z axis by `yaw` [rad].
inline Mat3 rotation_z(double yaw) {
  const double c = std::cos(yaw), s = std::sin(yaw);
  Mat3 R;
  R << c, -s, 0, s, c, 0, 0, 0, 1;
  return R;
}

/// An orientation with its angular velocity [rad/s] and acceleration [rad/s^2], all expressed in the frame that `R` leads to.
struct Turning {
  Mat3 R = Mat3::Identity();
  Vec3 omega = Vec3::Zero(), alpha = Vec3::Zero();
};

/// R = R_z(yaw) R_y(pitch) R_x(roll), each angle with its rate and acceleration.
inline Turning turning(const Motion1& roll, const Motion1& pitch, const Motion1& yaw) {
  if (roll.at_zero() && pitch.at_zero() && yaw.at_zero()) return {};
  const Mat3 R_z = rotation_z(yaw.p);
  const Vec3 y = R_z.col(1), x = std::cos(pitch.p) * R_z.col(0) - std::sin(pitch.p) * Vec3::UnitZ();
  const Vec3 omega_z = yaw.v * Vec3::UnitZ(), omega_zy = omega_z + pitch.v * y;
  Turning out;
  out.R = R_z * Eigen::AngleAxisd(pitch.p, Vec3::UnitY()) * Eigen::AngleAxisd(roll.p, Vec3::UnitX());
  out.omega = omega_zy + roll.v * x;
  out.alpha =
      yaw.a * Vec3::UnitZ() + pitch.a * y + roll.a * x + pitch.v * omega_z.cross(y) + roll.v * omega_zy.cross(x);
  return out;
}

/// Heading of a frame: the angle of its x axis in the horizontal plane [rad].
inline double yaw_of(const Mat3& R) { return std::atan2(R(1, 0), R(0, 0)); }

/// An angle brought into (-pi, pi]; one that lies inside is returned as it is.
inline double wrap_angle(double angle) { return std::abs(angle) < M_PI ? angle : std::remainder(angle, 2.0 * M_PI); }

/// Rotation vector, in world axes, that turns `R` into `R_des` [rad], (3,). Zero when they agree.
///
/// R_des = exp(skew(e)) R. So e is the position error of a task whose velocity is the angular velocity in world axes.
inline Vec3 orientation_error(const Mat3& R_des, const Mat3& R) {
  const Eigen::AngleAxisd turn(Mat3(R_des * R.transpose()));
  return turn.angle() * turn.axis();
}

}  // namespace zmpwalk
