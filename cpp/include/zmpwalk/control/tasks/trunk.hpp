#pragma once

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
  double soft_most = 0.0;  ///< largest angular acceleration about each axis of a soft trunk [rad/s^2]

  /// Commanded angular acceleration, world axes. @param R_WH heading frame   @param rate at which the heading frame turns [rad/s]
  Vec3 acceleration(const Dynamics& dyn, const Mat3& R_WH, double rate) const {
    const Vec3 heading_rate(0.0, 0.0, rate);
    Vec3 f_star = R_WH * turn.alpha + heading_rate.cross(R_WH * turn.omega);
    const Vec3 error = orientation_error(R_WH * turn.R * R_HB, dyn.R_WB),
               slower = R_WH * turn.omega + heading_rate - dyn.omega_WB;
    const Vec3 stiff = pd_acceleration(kp, kd, error, slower);
    f_star += stiff;
    if (softness > 0.0) {
      const Vec3 soft = pd_acceleration(soft_rate * soft_rate, 2.0 * soft_rate, error, slower);
      f_star += softness * (soft.cwiseMax(-soft_most).cwiseMin(soft_most) - stiff);
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
