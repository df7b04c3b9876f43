#pragma once

#include <functional>
#include <string>
#include <vector>

#include "zmpwalk/control/task.hpp"
#include "zmpwalk/math/spline.hpp"

namespace zmpwalk {

/// Joints outside the legs follow references, one row each.
///
/// The references are constant or change from cycle to cycle (`set`), or are functions of time (`follow`). Without references the joints stay where
/// they are when the task begins. The task begins without a jump: the references start at the joints' positions and speeds, and go over into
/// the given ones within the blend time.
class JointTask : public Task {
 public:
  /// @param joints names   @param kp [1/s^2]  @param kd [1/s]
  /// @throws InputError  no joint, a name given twice, a gain that is negative or not finite
  explicit JointTask(std::vector<std::string> joints, double kp = 400.0, double kd = 40.0);

  /// From the next cycle on, the references are these (m,) [rad or m].
  /// @throws DimensionError; InputError  not finite, or beyond a joint's range
  void set(const VecX& q, const VecX& dq, const VecX& ddq);
  /// The reference of joint i of `joints` is a function of the time since the task began [s], within `low` and `high` (m,).
  void follow(std::function<Motion1(double, int)> reference, const VecX& low, const VecX& high);

  int rows() const override { return static_cast<int>(names_.size()); }
  /// @throws InputError  a joint that is not there or is a leg's; a reference beyond its range
  void attach(RobotNames& names) override;
  void begin(const TaskInput& in, double blend) override;
  void compute(const TaskInput& in, TaskRows& out) override;

 private:
  void check_range(const VecX& low, const VecX& high) const;

  std::vector<std::string> names_;
  double kp_, kd_;
  std::vector<int> joint_;
  std::vector<std::pair<double, double>> range_;
  bool given_ = false;
  VecX low_, high_;  // what the references reach
  std::vector<Motion1> reference_, away_;
  std::function<Motion1(double, int)> function_;
  double t_begin_ = 0.0, blend_ = 1.0;
};

}  // namespace zmpwalk
