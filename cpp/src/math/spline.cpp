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

}  // namespace zmpwalk
