#pragma once

#include "zmpwalk/control/task.hpp"
#include "zmpwalk/control/task_space.hpp"

namespace zmpwalk {

/// Every joint follows a reference, one row each. A walk uses the rows of the joints outside the legs, after all other tasks.
struct PostureTask : Task {
  explicit PostureTask(int joints) : q(VecX::Zero(joints)), dq(VecX::Zero(joints)), ddq(VecX::Zero(joints)) {}

  VecX q, dq, ddq;  ///< reference (joints,) [rad or m]; ddq is fed forward
  double kp = 0.0;  ///< [1/s^2]
  double kd = 0.0;  ///< [1/s]

  /// Writes the commanded accelerations into `f_star` (joints,). Allocates nothing.
  void acceleration(const Dynamics& dyn, Eigen::Ref<VecX> f_star) const {
    f_star = ddq;
    f_star += pd_acceleration(kp, kd, q - dyn.q, dq - dyn.dq.tail(q.size()));
  }

  int rows() const override { return static_cast<int>(q.size()); }
  void compute(const TaskInput& in, TaskRows& out) override {
    out.J.setZero();
    out.J.rightCols(q.size()).setIdentity();
    out.drift.setZero();
    acceleration(in.dynamics, out.f_star);
  }
};

}  // namespace zmpwalk
