#pragma once

#include "zmpwalk/control/task.hpp"
#include "zmpwalk/control/tasks/pose.hpp"

namespace zmpwalk {

/// The sole of the swing foot follows a pose; six rows.
struct FootTask : Task {
  Side side = kLeft;
  PoseReference reference;  ///< W
  double kp = 0.0;          ///< [1/s^2]
  double kd = 0.0;          ///< [1/s]

  Vec6 acceleration(const Dynamics& dyn) const { return pose_acceleration(reference, dyn.sole[side], kp, kd); }

  int rows() const override { return 6; }
  void compute(const TaskInput& in, TaskRows& out) override {
    const FrameState& sole = in.dynamics.sole[side];
    out.J = sole.J;
    out.drift = sole.drift;
    out.f_star = acceleration(in.dynamics);
  }
};

}  // namespace zmpwalk
