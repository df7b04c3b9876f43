#pragma once

#include "zmpwalk/control/task.hpp"
#include "zmpwalk/control/task_space.hpp"

namespace zmpwalk {

/// The centre of mass (COM) follows a point; three rows in W. A walk takes only the vertical row from here: III-B chooses the horizontal ones.
struct ComTask : Task {
  Vec3 p = Vec3::Zero();   ///< reference [m]
  Vec3 v = Vec3::Zero();   ///< [m/s]
  Vec3 a = Vec3::Zero();   ///< [m/s^2]
  Vec3 kp = Vec3::Zero();  ///< of each axis [1/s^2]
  Vec3 kd = Vec3::Zero();  ///< of each axis [1/s]

  Vec3 acceleration(const Dynamics& dyn) const {
    Vec3 f_star = a;
    for (int i = 0; i < 3; ++i) f_star[i] += pd_acceleration(kp[i], kd[i], p[i] - dyn.com[i], v[i] - dyn.dcom[i]);
    return f_star;
  }

  int rows() const override { return 3; }
  void compute(const TaskInput& in, TaskRows& out) override {
    out.J = in.dynamics.J_com;
    out.drift = in.dynamics.drift_com;
    out.f_star = acceleration(in.dynamics);
  }
};

}  // namespace zmpwalk
