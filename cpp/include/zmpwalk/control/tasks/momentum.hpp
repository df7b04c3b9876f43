#pragma once

#include "zmpwalk/control/task.hpp"

namespace zmpwalk {

/// Keeps the angular momentum L about the COM small: about the vertical alone, or about all three axes.
///
/// L = C dq, f* = k_d (L_ref - L). The reference L_ref is what the robot would have if it turned as one body at the planned rate of the walk.
///
/// The task does not bring the joints home that it moves. With a weight below 1 it leaves a share to the posture, which does.
class MomentumTask : public Task {
 public:
  enum class Axes { kYaw, kAll };

  /// @param kd [1/s]. @throws InputError  negative or not finite
  explicit MomentumTask(Axes axes = Axes::kYaw, double kd = 20.0);

  int rows() const override { return axes_ == Axes::kYaw ? 1 : 3; }
  void compute(const TaskInput& in, TaskRows& out) override;

 private:
  Axes axes_;
  double kd_;
};

}  // namespace zmpwalk
