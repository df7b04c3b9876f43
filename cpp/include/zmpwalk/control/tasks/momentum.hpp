#pragma once

#include "zmpwalk/control/task.hpp"

namespace zmpwalk {

/// The angular momentum L about the COM is brought to that of turning as the walk turns: about the vertical alone, or about all axes.
///
/// L = C dq, f* = k_d (L_ref - L), and L_ref is what the robot would have as one body turning at the planned rate.
///
/// Nothing here brings the joints home that the task moves. With a weight less than 1 the posture keeps a say in the task's own direction, and does.
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
