#include "zmpwalk/control/tasks/joint.hpp"

#include <algorithm>

#include "zmpwalk/control/task_space.hpp"
#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

JointTask::JointTask(std::vector<std::string> joints, double kp, double kd)
    : names_(std::move(joints)), kp_(kp), kd_(kd), reference_(names_.size()), away_(names_.size()) {
  if (names_.empty()) throw InputError("a joint task names at least one joint");
  for (std::size_t i = 0; i < names_.size(); ++i)
    if (std::count(names_.begin(), names_.end(), names_[i]) > 1)
      throw InputError("the joint task names '" + names_[i] + "' twice");
  require_gain("kp", kp);
  require_gain("kd", kd);
}

void JointTask::set(const VecX& q, const VecX& dq, const VecX& ddq) {
  const long m = rows();
  require_size("q", q.size(), m);
  require_size("dq", dq.size(), m);
  require_size("ddq", ddq.size(), m);
  if (!(q.allFinite() && dq.allFinite() && ddq.allFinite()))
    throw InputError("the reference of a joint task is not finite");
  check_range(q, q);
  low_ = high_ = q;
  for (int i = 0; i < m; ++i) reference_[i] = {q[i], dq[i], ddq[i]};
  function_ = nullptr;
  given_ = true;
}

void JointTask::follow(std::function<Motion1(double, int)> reference, const VecX& low, const VecX& high) {
  require_size("low", low.size(), rows());
  require_size("high", high.size(), rows());
  check_range(low, high);
  low_ = low;
  high_ = high;
  function_ = std::move(reference);
  given_ = true;
}

void JointTask::attach(RobotNames& names) {
  std::vector<int> joint;
  std::vector<std::pair<double, double>> range;
  for (const std::string& name : names_) {
    joint.push_back(names.joint(name));
    range.push_back(names.joint_range(joint.back()));
  }
  std::swap(range, range_);
  try {
    if (given_) check_range(low_, high_);
  } catch (...) {
    std::swap(range, range_);
    throw;
  }
  joint_ = std::move(joint);
}

void JointTask::check_range(const VecX& low, const VecX& high) const {
  for (std::size_t i = 0; i < range_.size(); ++i) {
    const auto& [lower, upper] = range_[i];
    const auto k = static_cast<Eigen::Index>(i);
    if (low[k] >= lower && high[k] <= upper) continue;
    throw InputError("the joint task brings '" + names_[i] + "' to " +
                     std::to_string(low[k] < lower ? low[k] : high[k]) + " rad; its range is " + std::to_string(lower) +
                     " to " + std::to_string(upper) + " rad");
  }
}

void JointTask::begin(const TaskInput& in, double blend) {
  t_begin_ = in.t;
  blend_ = blend;
  for (int i = 0; i < rows(); ++i) {
    const double q = in.dynamics.q[joint_[i]], dq = in.dynamics.dq[6 + joint_[i]];
    if (function_)
      reference_[i] = function_(0.0, i);
    else if (!given_)
      reference_[i] = {q, 0.0, 0.0};
    away_[i] = {q - reference_[i].p, dq - reference_[i].v, 0.0};
  }
}

void JointTask::compute(const TaskInput& in, TaskRows& out) {
  const double t = in.t - t_begin_;
  out.J.setZero();
  out.drift.setZero();
  for (int i = 0; i < rows(); ++i) {
    if (function_) reference_[i] = function_(t, i);
    const Motion1 &wanted = reference_[i], away = fade_out(away_[i], blend_, t);
    const int j = joint_[i];
    out.J(i, 6 + j) = 1.0;
    out.f_star[i] =
        wanted.a + away.a +
        pd_acceleration(kp_, kd_, wanted.p + away.p - in.dynamics.q[j], wanted.v + away.v - in.dynamics.dq[6 + j]);
  }
}

}  // namespace zmpwalk
