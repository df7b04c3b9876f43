#pragma once

namespace zmpwalk {

/// Position and velocity of the pendulum's mass along one axis, about the support [m, m/s].
struct PendulumState {
  double x = 0.0;
  double v = 0.0;
};

/// Linear inverted pendulum: x'' = (x - r) / T_c^2 with T_c = sqrt(z_c / g).
class LinearInvertedPendulum {
 public:
  /// @param z_c height of the COM above the support [m]   @param gravity g [m/s^2]
  /// @throws InputError either is not finite and > 0
  LinearInvertedPendulum(double z_c, double gravity);

  double Tc() const { return Tc_; }           ///< [s]
  double omega() const { return 1.0 / Tc_; }  ///< [rad/s]

  /// Eq. 16 (corrected: no 1/T_c): state after `dt` [s] under a constant reference ZMP `r` [m].
  PendulumState step(double dt, const PendulumState& s, double r) const;
  /// Eq. 17: the same about a zero reference, the lateral motion.
  PendulumState step_lateral(double dt, const PendulumState& s) const;
  /// Eq. 18: velocity after `T` [s] about a zero reference [m/s].
  double velocity_after(double T, const PendulumState& s) const;

  /// (x - r) / T_c^2 [m/s^2].
  double acceleration(double x, double r) const { return (x - r) / (Tc_ * Tc_); }
  /// The reference ZMP that gives acceleration `a`: r = x - T_c^2 a [m].
  double reference_for(double x, double a) const { return x - Tc_ * Tc_ * a; }
  /// Divergent component of motion x + T_c v [m]; under a constant r it leaves r as exp(t / T_c).
  double dcm(const PendulumState& s) const { return s.x + Tc_ * s.v; }
  /// The constant reference ZMP that brings the DCM from `xi` to `xi_end` in `time` [s] > 0.
  double reference_to_reach(double xi, double xi_end, double time) const;

  // The lateral orbit over feet that alternate, `width` apart, while their middle moves on by `drift` each step of `period` [s].
  /// Half way between the feet its DCM lies `orbit_inset` inside the foot to come: width / (1 + exp(period / T_c)) [m],
  double orbit_inset(double width, double period) const;
  /// and `orbit_offset` further along the drift: drift / (exp(period / T_c) - 1) [m].
  double orbit_offset(double drift, double period) const;
  /// Its velocity in the middle of a single support, drift / (2 T_c sinh(period / 2 T_c)) [m/s]: zero where nothing drifts.
  double orbit_velocity(double drift, double period) const;

  /// Length of the first double support from which the symmetric orbit starts at rest half way between the feet [s].
  ///
  /// The ZMP stays for t_1 on the foot that swings first, then moves to the other; T_r later the lateral velocity is zero,
  /// and that must be the middle of the first single support: T_ds = t_1 + T_r - T_ss / 2.
  /// cosh(t_1/T_c) = (5 - 1/cosh^2(T/2T_c)) / 4, tanh(T_r/T_c) = sinh(t_1/T_c) / (2 - cosh(t_1/T_c)), T the step period.
  double first_double_support(double period, double T_ss) const;

 private:
  double Tc_;
};

}  // namespace zmpwalk
