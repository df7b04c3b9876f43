#include "zmpwalk/gait/pendulum.hpp"

#include <cmath>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

LinearInvertedPendulum::LinearInvertedPendulum(double z_c, double gravity) {
  require_positive("z_c", z_c);
  require_positive("gravity", gravity);
  Tc_ = std::sqrt(z_c / gravity);
}

LinearInvertedPendulum::Over LinearInvertedPendulum::over(double dt) const {
  return {std::cosh(dt / Tc_), std::sinh(dt / Tc_)};
}

PendulumState LinearInvertedPendulum::step(const Over& dt, const PendulumState& s, double r) const {
  const auto [ch, sh] = dt;
  const double x_d = ch * s.x + sh * Tc_ * s.v - (ch - 1.0) * r;  // Eq. (16), corrected: no 1/T_c before the last term
  const double Tc_v_d = sh * s.x + ch * Tc_ * s.v - sh * r;
  return {x_d, Tc_v_d / Tc_};
}

PendulumState LinearInvertedPendulum::step_lateral(double dt, const PendulumState& s) const {
  return step(dt, s, 0.0);  // Eq. (17)
}

double LinearInvertedPendulum::velocity_after(double T, const PendulumState& s) const {
  return (std::sinh(T / Tc_) * s.x + std::cosh(T / Tc_) * Tc_ * s.v) / Tc_;  // Eq. (18)
}

LinearInvertedPendulum::Growth LinearInvertedPendulum::growth(double time) const {
  return {std::exp(time / Tc_), std::expm1(time / Tc_)};
}

double LinearInvertedPendulum::orbit_velocity(double drift, double period) const {
  return drift / (2.0 * Tc_ * std::sinh(0.5 * period / Tc_));
}

double LinearInvertedPendulum::first_double_support(double period, double T_ss) const {
  const double c = std::cosh(0.5 * period / Tc_);
  const double ch_1 = 0.25 * (5.0 - 1.0 / (c * c));
  const double t_1 = Tc_ * std::acosh(ch_1);
  const double T_r = Tc_ * std::atanh(std::sinh(t_1 / Tc_) / (2.0 - ch_1));
  return t_1 + T_r - 0.5 * T_ss;
}

}  // namespace zmpwalk
