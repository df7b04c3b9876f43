#pragma once

#include <cmath>

#include "zmpwalk/control/task.hpp"
#include "zmpwalk/control/task_space.hpp"
#include "zmpwalk/math/rotation.hpp"

namespace zmpwalk {

/// The trunk (the floating base) follows an orientation that is given in the heading frame H, which itself turns; three rows, world axes.
///
/// R_des = R_WH R_turn R_HB: R_HB is the trunk's orientation in H at the start, R_turn the wanted turn from there, and R_WH the heading.
struct TrunkTask : Task {
  Turning turn;                  ///< wanted turn, heading frame
  Mat3 R_HB = Mat3::Identity();  ///< orientation of the trunk in the heading frame where it stands
  double kp = 0.0;               ///< [1/s^2]
  double kd = 0.0;               ///< [1/s]
  // A soft trunk comes back slowly, critically damped, whatever has turned it: what it does not turn takes nothing from the feet.
  double softness = 0.0;   ///< 0 stiff, with the gains above, to 1 soft
  double soft_rate = 0.0;  ///< [rad/s]
  double soft_most =
      0.0;  ///< largest angular acceleration about each axis of a soft trunk that has hardly turned [rad/s^2]
  double soft_angle = 0.17;  ///< angle at which a soft trunk is twice as stiff [rad]

  /// Rotation vector from where the trunk is to where it should be, world axes (3,) [rad]. @param R_WH heading frame
  Vec3 error(const Dynamics& dyn, const Mat3& R_WH) const { return orientation_error(R_WH * turn.R * R_HB, dyn.R_WB); }
  /// Commanded angular acceleration, world axes. @param R_WH heading frame   @param rate at which the heading frame turns [rad/s]
  Vec3 acceleration(const Dynamics& dyn, const Mat3& R_WH, double rate) const {
    const Vec3 heading_rate(0.0, 0.0, rate);
    Vec3 f_star = R_WH * turn.alpha + heading_rate.cross(R_WH * turn.omega);
    const Vec3 off = error(dyn, R_WH), slower = R_WH * turn.omega + heading_rate - dyn.omega_WB;
    const Vec3 stiff = pd_acceleration(kp, kd, off, slower);
    f_star += stiff;
    if (softness > 0.0) {
      // The further it has turned, the less soft it is: a force that goes on must not tip it over.
      const double firm = 1.0 + off.squaredNorm() / (soft_angle * soft_angle), most = firm * soft_most;
      const Vec3 soft = pd_acceleration(firm * soft_rate * soft_rate, 2.0 * std::sqrt(firm) * soft_rate, off, slower);
      f_star += softness * (soft.cwiseMax(-most).cwiseMin(most) - stiff);
    }
    return f_star;
  }

  int rows() const override { return 3; }
  void compute(const TaskInput& in, TaskRows& out) override {
    out.J.setZero();
    out.J.middleCols<3>(3) = in.dynamics.R_WB;
    out.drift.setZero();
    out.f_star = acceleration(in.dynamics, rotation_z(in.heading), in.heading_rate);
  }
};

}  // namespace zmpwalk
