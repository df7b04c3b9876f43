#pragma once

#include "zmpwalk/gait/pendulum.hpp"

namespace zmpwalk {

/// The pendulum's steady walk along the heading, over one stance foot: L = v T in each period T, the ZMP never further than `reach` from
/// the middle of its travel.
///
/// Short steps need no more than that: the ZMP stays under the COM, whose velocity is v. In longer ones it rolls from -reach to +reach
/// (heel to toe), and before and after that the COM falls: slowest, v_0, over the foot, fastest, v_s, where the support changes. By symmetry
///     reach / v_0 + T_c asinh((L/2 - reach) / (T_c v_0)) = T/2,   v(x)^2 = v_0^2 + ((|x| - reach) / T_c)^2 beyond the reach.
class ForwardOrbit {
 public:
  ForwardOrbit() = default;
  /// @param v mean velocity [m/s]   @param period T [s] > 0   @param reach [m], below 0 taken as 0
  ForwardOrbit(const LinearInvertedPendulum& pendulum, double v, double period, double reach);

  double velocity(double x) const;      ///< where the COM is x past the middle [m] -> [m/s]; beyond L/2 as there
  double acceleration(double x) const;  ///< there [m/s^2]
  double end_velocity() const { return velocity(half_); }  ///< v_s, where the support changes [m/s]
  /// How far the COM is ahead of steady motion with v, `t` after it was in the middle [s] -> [m].
  double ahead(double t) const;

 private:
  double Tc_ = 1.0, v_ = 0.0, v_0_ = 0.0, half_ = 0.0, reach_ = 0.0;
};

}  // namespace zmpwalk
