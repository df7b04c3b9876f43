#pragma once

#include <algorithm>
#include <cmath>

#include "zmpwalk/gait/pendulum.hpp"

namespace zmpwalk {

/// The steady walk of the pendulum along the heading, while one foot carries the ZMP: the COM goes L = v T in each period T, and this repeats.
///
/// Places x are from the middle of that way, which lies over the stance foot. The ZMP stays within `roll` of the middle. In short steps it stays under
/// the COM all the time, whose velocity is then v throughout. In longer steps the ZMP rolls from -roll to +roll (heel to toe) while the COM passes
/// over it at its slowest velocity v_0; before and after that the COM falls away from the ZMP, and is fastest, v_s, where the support changes.
/// By symmetry
///     roll / v_0 + T_c asinh((L/2 - roll) / (T_c v_0)) = T/2,   v(x)^2 = v_0^2 + ((|x| - roll) / T_c)^2 where |x| > roll.
class ForwardOrbit {
 public:
  ForwardOrbit() = default;
  /// @param v mean velocity [m/s]   @param period T [s] > 0   @param roll [m]; a negative one is taken as 0
  ForwardOrbit(const LinearInvertedPendulum& pendulum, double v, double period, double roll);
  /// True where this orbit was made for the same numbers, so that a new one would be equal.
  bool is_for(const LinearInvertedPendulum& pendulum, double v, double period, double roll) const {
    return v == v_ && period == period_ && std::max(roll, 0.0) == roll_ && pendulum.Tc() == Tc_;
  }

  /// Velocity of the orbit where the COM is x past the middle [m] -> [m/s]. Beyond L/2 it stays what it is there.
  double velocity(double x) const {
    const double beyond = (std::min(std::abs(x), half_) - roll_) / Tc_;
    return beyond > 0.0 ? std::copysign(std::hypot(v_0_, beyond), v_) : v_0_;
  }
  /// Acceleration of the orbit at the same place [m/s^2].
  double acceleration(double x) const {
    const double beyond = std::min(std::abs(x), half_) - roll_;
    return beyond > 0.0 ? std::copysign(beyond, x) / (Tc_ * Tc_) : 0.0;
  }
  double end_velocity() const { return velocity(half_); }  ///< v_s, the velocity where the support changes [m/s]
  /// How far the COM is ahead of a motion with the constant velocity v, at the time `t` after it was in the middle [s] -> [m].
  double ahead(double t) const;

 private:
  double Tc_ = 1.0, v_ = 0.0, v_0_ = 0.0, period_ = 0.0, half_ = 0.0, roll_ = 0.0;
};

}  // namespace zmpwalk
