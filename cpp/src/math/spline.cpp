#include "zmpwalk/math/spline.hpp"

namespace zmpwalk {

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
