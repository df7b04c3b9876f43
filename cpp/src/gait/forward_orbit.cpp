#include "zmpwalk/gait/forward_orbit.hpp"

#include <algorithm>
#include <cmath>

namespace zmpwalk {

ForwardOrbit::ForwardOrbit(const LinearInvertedPendulum& pendulum, double v, double period, double reach)
    : Tc_(pendulum.Tc()), v_(v), v_0_(v), half_(0.5 * std::abs(v) * period), reach_(std::max(reach, 0.0)) {
  const double beyond = (half_ - reach_) / Tc_;
  if (beyond <= 0.0) return;
  // In u = 1 / |v_0| the equation is concave and rising: Newton's steps from 1 / |v| come to its root from one side.
  double u = 1.0 / std::abs(v);
  for (int i = 0; i < 5; ++i) {
    const double s = beyond * u;
    u -= (reach_ * u + Tc_ * std::asinh(s) - 0.5 * period) / (reach_ + Tc_ * beyond / std::sqrt(1.0 + s * s));
  }
  v_0_ = std::copysign(1.0 / u, v);
}

double ForwardOrbit::velocity(double x) const {
  const double beyond = (std::min(std::abs(x), half_) - reach_) / Tc_;
  return beyond > 0.0 ? std::copysign(std::hypot(v_0_, beyond), v_) : v_0_;
}

double ForwardOrbit::acceleration(double x) const {
  const double beyond = std::min(std::abs(x), half_) - reach_;
  return beyond > 0.0 ? std::copysign(beyond, x) / (Tc_ * Tc_) : 0.0;
}

double ForwardOrbit::ahead(double t) const {
  if (half_ <= reach_) return 0.0;
  const double rolls = reach_ / std::abs(v_0_), after = std::abs(t) - rolls;
  const double x =
      after > 0.0 ? std::min(reach_ + Tc_ * std::abs(v_0_) * std::sinh(after / Tc_), half_) : std::abs(v_0_ * t);
  return std::copysign(x, v_ * t) - v_ * t;
}

}  // namespace zmpwalk
