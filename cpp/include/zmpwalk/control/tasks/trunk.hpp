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

  /// Commanded angular acceleration, world axes. @param R_WH heading frame   @param rate at which the heading frame turns [rad/s]
  Vec3 acceleration(const Dynamics& dyn, const Mat3& R_WH, double rate) const {
    const Vec3 heading_rate(0.0, 0.0, rate);
    Vec3 f_star = R_WH * turn.alpha + heading_rate.cross(R_WH * turn.omega);
    f_star += pd_acceleration(kp, kd, orientation_error(R_WH * turn.R * R_HB, dyn.R_WB),
                              Vec3(R_WH * turn.omega + heading_rate - dyn.omega_WB));
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
