#include "zmpwalk/gait/forward_orbit.hpp"

namespace zmpwalk {

ForwardOrbit::ForwardOrbit(const LinearInvertedPendulum& pendulum, double v, double period, double roll)
    : Tc_(pendulum.Tc()),
      v_(v),
      v_0_(v),
      period_(period),
      half_(0.5 * std::abs(v) * period),
      roll_(std::max(roll, 0.0)) {
  const double beyond = (half_ - roll_) / Tc_;
  if (beyond <= 0.0) return;
  // In u = 1 / |v_0| the equation is concave and rising: Newton's steps from 1 / |v| come to its root from one side.
  constexpr int kSteps = 5;
  double u = 1.0 / std::abs(v);
  for (int i = 0; i < kSteps; ++i) {
    const double before = u, s = beyond * u;
    u -= (roll_ * u + Tc_ * std::asinh(s) - 0.5 * period) / (roll_ + Tc_ * beyond / std::sqrt(1.0 + s * s));
    if (u == before) break;
  }
  v_0_ = std::copysign(1.0 / u, v);
}

double ForwardOrbit::ahead(double t) const {
  if (half_ <= roll_) return 0.0;
  const double rolls = roll_ / std::abs(v_0_), after = std::abs(t) - rolls;
  const double x =
      after > 0.0 ? std::min(roll_ + Tc_ * std::abs(v_0_) * std::sinh(after / Tc_), half_) : std::abs(v_0_ * t);
  return std::copysign(x, v_ * t) - v_ * t;
}

}  // namespace zmpwalk
