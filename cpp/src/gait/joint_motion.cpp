#include "zmpwalk/gait/joint_motion.hpp"

#include <algorithm>
#include <cmath>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

JointMotion::JointMotion(const VecX& t, std::vector<std::string> names, const RowMatX& q)
    : t_(t), names_(std::move(names)), q_(q) {
  const Eigen::Index n = t.size(), m = static_cast<Eigen::Index>(names_.size());
  if (n == 0) throw InputError("a joint motion has no knots; it needs at least one, at t = 0");
  require_shape("q", q.rows(), q.cols(), n, m);
  for (std::size_t j = 0; j < names_.size(); ++j)
    if (std::count(names_.begin(), names_.end(), names_[j]) > 1)
      throw InputError("a joint motion names '" + names_[j] + "' more than once; each joint has one column");
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::string knot = "joint motion, knot " + std::to_string(i) + ": ";
    require_finite((knot + "t").c_str(), t[i]);
    for (Eigen::Index j = 0; j < m; ++j) require_finite((knot + names_[j]).c_str(), q(i, j));
    if (i == 0 && t[0] != 0.0)
      throw InputError("a joint motion starts at t = " + std::to_string(t[0]) + " s; it must start at 0");
    if (i > 0 && !(t[i] > t[i - 1]))
      throw InputError(knot + "t = " + std::to_string(t[i]) + " s does not come after " + std::to_string(t[i - 1]) +
                       " s; times must increase");
  }
  pieces_.resize(static_cast<std::size_t>((n - 1) * m));
  for (Eigen::Index j = 0; j < m; ++j) {
    const VecX v = knot_velocities(t, q.col(j));
    for (Eigen::Index i = 0; i + 1 < n; ++i)
      pieces_[i * m + j] = Cubic(q(i, j), v[i], q(i + 1, j), v[i + 1], t[i + 1] - t[i]);
  }
}

Motion1 JointMotion::at(double t, int column) const {
  const Eigen::Index last = t_.size() - 1;
  if (t < 0.0) return {q_(0, column), 0.0, 0.0};
  if (t >= t_[last]) return {q_(last, column), 0.0, 0.0};
  const Eigen::Index i = std::upper_bound(t_.data(), t_.data() + last, t) - t_.data() - 1;
  return piece(i, column).at(t - t_[i]);
}

JointMotion::Extent JointMotion::extent(int column) const {
  Extent out{0.0, q_(0, column), 0.0, q_(0, column)};
  const auto take = [&](double t, double p) {
    if (p < out.low) out.t_low = t, out.low = p;
    if (p > out.high) out.t_high = t, out.high = p;
  };
  for (Eigen::Index i = 0; i + 1 < t_.size(); ++i) {
    take(t_[i + 1], q_(i + 1, column));
    // The piece's velocity v + a s + b s^2 is zero at its turning points.
    const Cubic& cubic = piece(i, column);
    const double T = cubic.duration();
    const Motion1 start = cubic.at(0.0), end = cubic.at(T);
    const double v = start.v, a = start.a, b = 0.5 * (end.a - start.a) / T, root = a * a - 4.0 * b * v;
    if (root < 0.0) continue;
    const double sum = -0.5 * (a + std::copysign(std::sqrt(root), a));  // both roots without cancellation
    for (const double s : {sum / b, v / sum})
      if (s > 0.0 && s < T) take(t_[i] + s, cubic.at(s).p);
  }
  return out;
}

MotionReference::MotionReference(const VecX& rest)
    : rest_(rest),
      q_(rest),
      dq_(VecX::Zero(rest.size())),
      ddq_(VecX::Zero(rest.size())),
      difference_(static_cast<std::size_t>(rest.size())) {}

void MotionReference::start(JointMotion motion, std::vector<int> entry, double blend) {
  motion_ = std::move(motion);
  entry_ = std::move(entry);
  blend_ = blend;
  blend_from_here();
}

void MotionReference::reset() {
  q_ = rest_;
  dq_.setZero();
  ddq_.setZero();
  t_ = 0.0;
  blend_from_here();
}

void MotionReference::blend_from_here() {
  t_start_ = t_;
  rests_ = false;
  for (Eigen::Index i = 0; i < rest_.size(); ++i) difference_[i] = {q_[i] - rest_[i], dq_[i], ddq_[i]};
  for (std::size_t j = 0; j < entry_.size(); ++j) {
    const Motion1 first = motion_.at(0.0, static_cast<int>(j));
    Motion1& d = difference_[entry_[j]];
    d = {d.p + rest_[entry_[j]] - first.p, d.v - first.v, d.a - first.a};
  }
}

void MotionReference::update(double t) {
  t_ = t;
  if (rests_) return;
  const double since = t - t_start_;
  for (Eigen::Index i = 0; i < rest_.size(); ++i) {
    const Motion1 d = since < blend_ ? fade_out(difference_[i], blend_, since) : Motion1{};
    q_[i] = rest_[i] + d.p;
    dq_[i] = d.v;
    ddq_[i] = d.a;
  }
  for (std::size_t j = 0; j < entry_.size(); ++j) {
    const Motion1 m = motion_.at(since, static_cast<int>(j));
    const int i = entry_[j];
    q_[i] += m.p - rest_[i];
    dq_[i] += m.v;
    ddq_[i] += m.a;
  }
  rests_ = entry_.empty() && since >= blend_;
}

bool MotionReference::names(int coordinate) const {
  return std::find(entry_.begin(), entry_.end(), coordinate) != entry_.end();
}

}  // namespace zmpwalk
