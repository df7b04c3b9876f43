#pragma once

namespace zmpwalk {

/// Position and velocity of the pendulum's mass along one axis, from a point of the ground that the caller chooses [m, m/s].
struct PendulumState {
  double x = 0.0;
  double v = 0.0;
};

/// The linear inverted pendulum, which stands for the robot: a point mass at the constant height z_c over a ZMP at r.
///
/// x'' = (x - r) / T_c^2 with T_c = sqrt(z_c / g). Its divergent component of motion (DCM), xi = x + T_c v, tells where it tends: put the ZMP there, and the
/// mass comes to rest over it.
class LinearInvertedPendulum {
 public:
  /// @param z_c height of the COM above the support [m]   @param gravity g [m/s^2]
  /// @throws InputError either is not finite and > 0
  LinearInvertedPendulum(double z_c, double gravity);

  double Tc() const { return Tc_; }           ///< time constant T_c [s]
  double omega() const { return 1.0 / Tc_; }  ///< [rad/s]

  /// The two functions of a time in (16) to (18). They are kept apart so that a caller with the same time computes them once.
  struct Over {
    double ch = 1.0, sh = 0.0;  ///< cosh(dt / T_c), sinh(dt / T_c)
  };
  Over over(double dt) const;  ///< dt [s]

  /// Eq. 16 (corrected: no 1/T_c): state after `dt` [s] under a constant reference ZMP `r` [m].
  PendulumState step(double dt, const PendulumState& s, double r) const { return step(over(dt), s, r); }
  PendulumState step(const Over& dt, const PendulumState& s, double r) const;
  /// Eq. 17: the same about a zero reference, the lateral motion.
  PendulumState step_lateral(double dt, const PendulumState& s) const;
  /// Eq. 18: velocity after `T` [s] about a zero reference [m/s].
  double velocity_after(double T, const PendulumState& s) const;

  /// (x - r) / T_c^2 [m/s^2].
  double acceleration(double x, double r) const { return (x - r) / (Tc_ * Tc_); }
  /// The reference ZMP that gives acceleration `a`: r = x - T_c^2 a [m].
  double reference_for(double x, double a) const { return x - Tc_ * Tc_ * a; }
  /// The DCM, x + T_c v [m]. Under a constant r its distance from r grows as exp(t / T_c).
  double dcm(const PendulumState& s) const { return s.x + Tc_ * s.v; }
  /// The factor by which the distance of the DCM from a constant ZMP grows in a time. A caller with the same time computes it once.
  struct Growth {
    double factor = 1.0, excess = 0.0;  ///< exp(time / T_c), and exp(time / T_c) - 1
  };
  Growth growth(double time) const;  ///< time [s]
  /// The constant reference ZMP that brings the DCM from `xi` to `xi_end` in `time` [s] > 0.
  double reference_to_reach(double xi, double xi_end, double time) const {
    return reference_to_reach(xi, xi_end, growth(time));
  }
  double reference_to_reach(double xi, double xi_end, const Growth& time) const {
    return (xi_end - xi * time.factor) / (1.0 - time.factor);
  }

  // The lateral orbit is the sway that repeats while the support changes between two feet `width` apart [m], once in each `period` [s], and
  // the middle between the feet moves sideways by `drift` in each period [m].
  /// Where the DCM of the lateral orbit is when the COM is half way between the feet: this far inside the foot that takes over next,
  /// width / (1 + exp(period / T_c)) [m]. `orbit_offset` is added where the orbit drifts.
  double orbit_inset(double width, double period) const { return orbit_inset(width, growth(period)); }
  double orbit_inset(double width, const Growth& period) const { return width / (1.0 + period.factor); }
  /// How much further along the drift that DCM is than without a drift: drift / (exp(period / T_c) - 1) [m].
  double orbit_offset(double drift, double period) const { return orbit_offset(drift, growth(period)); }
  double orbit_offset(double drift, const Growth& period) const { return drift / period.excess; }
  /// Lateral velocity of the orbit in the middle of a single support, drift / (2 T_c sinh(period / 2 T_c)) [m/s]; zero without a drift.
  double orbit_velocity(double drift, double period) const;

  /// Length of the first double support with which a COM at rest half way between the feet gets onto the lateral orbit [s].
  ///
  /// The ZMP stays for t_1 on the foot that swings first, then moves to the other; T_r later the lateral velocity is zero,
  /// and that must be the middle of the first single support: T_ds = t_1 + T_r - T_ss / 2.
  /// cosh(t_1/T_c) = (5 - 1/cosh^2(T/2T_c)) / 4, tanh(T_r/T_c) = sinh(t_1/T_c) / (2 - cosh(t_1/T_c)), T the step period.
  double first_double_support(double period, double T_ss) const;

 private:
  double Tc_;
};

/// Gives `over(dt)`, and computes it only if the pendulum or the time has changed since the last call.
class LastOver {
 public:
  const LinearInvertedPendulum::Over& operator()(const LinearInvertedPendulum& pendulum, double dt) {
    if (pendulum.Tc() != Tc_ || dt != dt_) {
      Tc_ = pendulum.Tc();
      dt_ = dt;
      over_ = pendulum.over(dt);
    }
    return over_;
  }

 private:
  double Tc_ = 0.0, dt_ = 0.0;
  LinearInvertedPendulum::Over over_;
};

}  // namespace zmpwalk
