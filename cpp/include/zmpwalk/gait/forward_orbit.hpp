#pragma once

#include <algorithm>
#include <cmath>

#include "zmpwalk/gait/pendulum.hpp"

namespace zmpwalk {

/// The pendulum's steady walk along the heading, over one stance foot: L = v T in each period T, the ZMP never further than `roll` from
/// the middle of its way.
///
/// Short steps need no more than that: the ZMP stays under the COM, whose velocity is v. In longer ones it rolls from -roll to +roll
/// (heel to toe), and before and after that the COM falls: slowest, v_0, over the foot, fastest, v_s, where the support changes. By symmetry
///     roll / v_0 + T_c asinh((L/2 - roll) / (T_c v_0)) = T/2,   v(x)^2 = v_0^2 + ((|x| - roll) / T_c)^2 beyond it.
class ForwardOrbit {
 public:
  ForwardOrbit() = default;
  /// @param v mean velocity [m/s]   @param period T [s] > 0   @param roll [m], below 0 taken as 0
  ForwardOrbit(const LinearInvertedPendulum& pendulum, double v, double period, double roll);
  /// Made for these very numbers: another one would be the same.
  bool is_for(const LinearInvertedPendulum& pendulum, double v, double period, double roll) const {
    return v == v_ && period == period_ && std::max(roll, 0.0) == roll_ && pendulum.Tc() == Tc_;
  }

  /// Where the COM is x past the middle [m] -> [m/s]; beyond L/2 as there.
  double velocity(double x) const {
    const double beyond = (std::min(std::abs(x), half_) - roll_) / Tc_;
    return beyond > 0.0 ? std::copysign(std::hypot(v_0_, beyond), v_) : v_0_;
  }
  /// There [m/s^2].
  double acceleration(double x) const {
    const double beyond = std::min(std::abs(x), half_) - roll_;
    return beyond > 0.0 ? std::copysign(beyond, x) / (Tc_ * Tc_) : 0.0;
  }
  double end_velocity() const { return velocity(half_); }  ///< v_s, where the support changes [m/s]
  /// How far the COM is ahead of steady motion with v, `t` after it was in the middle [s] -> [m].
  double ahead(double t) const;

 private:
  double Tc_ = 1.0, v_ = 0.0, v_0_ = 0.0, period_ = 0.0, half_ = 0.0, roll_ = 0.0;
};

}  // namespace zmpwalk
