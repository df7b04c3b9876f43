#pragma once

#include <string>
#include <vector>

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// How a profile goes from one knot to the next.
enum class Interpolation { kHold, kLinear };

/// Planned velocity of the COM over time: (v_x, v_y, w_z) in the heading frame [m/s, m/s, rad/s]. Holds its last value.
class VelocityProfile {
 public:
  /// @param t  knot times (n,) [s], from 0, strictly increasing   @param v  one velocity per knot
  /// @throws InputError  no knots, a time that does not increase, a first time that is not 0, NaN or infinity
  /// @throws DimensionError  t and v differ in length
  VelocityProfile(std::vector<double> t, std::vector<Vec3> v, Interpolation interpolation = Interpolation::kHold);

  /// The paper's experiment, section IV: 0.063, 0.156, 0.219, 0.25 m/s from 0, 0.8, 1.6, 2.4 s on.
  static VelocityProfile paper();

  Vec3 velocity(double t) const;                  ///< (3,) at time t [s]; before 0 as at 0
  Vec3 displacement(double t0, double t1) const;  ///< integral of the velocity from t0 to t1 (3,) [m, m, rad]
  double max_speed() const;                       ///< largest |(v_x, v_y)| [m/s]

  const std::vector<double>& t() const { return t_; }
  const std::vector<Vec3>& v() const { return v_; }
  Interpolation interpolation() const { return interpolation_; }

 private:
  std::size_t segment(double t) const;
  Vec3 integral(double t) const;

  std::vector<double> t_;
  std::vector<Vec3> v_;
  std::vector<Vec3> sum_;  // integral up to each knot
  Interpolation interpolation_;
};

}  // namespace zmpwalk
