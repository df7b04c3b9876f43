#include "zmpwalk/math/spline.hpp"

#include <algorithm>

namespace zmpwalk {

Cubic::Cubic(double p0, double v0, double p1, double v1, double T) : c0_(p0), c1_(v0), T_(std::max(T, 0.0)) {
  if (T_ == 0.0) {
    c0_ = p1;
    c1_ = v1;
    return;
  }
  const double d = p1 - p0;
  c2_ = (3.0 * d / T_ - 2.0 * v0 - v1) / T_;
  c3_ = (v0 + v1 - 2.0 * d / T_) / (T_ * T_);
}

Motion1 Cubic::at(double t) const {
  const bool inside = t >= 0.0 && t <= T_;
  const double s = std::clamp(t, 0.0, T_);
  return {c0_ + s * (c1_ + s * (c2_ + s * c3_)), c1_ + s * (2.0 * c2_ + s * 3.0 * c3_),
          inside ? 2.0 * c2_ + 6.0 * c3_ * s : 0.0};
}

VecX knot_velocities(const ConstVecRef& t, const ConstVecRef& p) {
  const Eigen::Index n = t.size();
  VecX v = VecX::Zero(n), upper = VecX::Zero(n);
  // Elimination downwards, substitution upwards: the matrix is tridiagonal and its diagonal dominates.
  for (Eigen::Index i = 1; i + 1 < n; ++i) {
    const double a = 1.0 / (t[i] - t[i - 1]), b = 1.0 / (t[i + 1] - t[i]);
    const double pivot = 2.0 * (a + b) - a * upper[i - 1];
    upper[i] = b / pivot;
    v[i] = (3.0 * (a * a * (p[i] - p[i - 1]) + b * b * (p[i + 1] - p[i])) - a * v[i - 1]) / pivot;
  }
  for (Eigen::Index i = n - 2; i > 0; --i) v[i] -= upper[i] * v[i + 1];
  return v;
}

Motion1 fade_out(const Motion1& start, double T, double t) {
  const double s = t / T;
  if (!(s < 1.0)) return {};
  // (1 - s)^3 (a + b s + c s^2): the first factor leaves zeros at the end, the second meets the start.
  const double a = start.p, b = 3.0 * a + T * start.v, c = 3.0 * b - 3.0 * a + 0.5 * T * T * start.a;
  const double r = 1.0 - s, w = a + s * (b + s * c), dw = b + 2.0 * s * c, ddw = 2.0 * c;
  return {r * r * r * w, r * r * (r * dw - 3.0 * w) / T, r * (r * (r * ddw - 6.0 * dw) + 6.0 * w) / (T * T)};
}

}  // namespace zmpwalk
