#pragma once

#include <algorithm>

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// Position, velocity and acceleration of one coordinate.
struct Motion1 {
  double p = 0.0, v = 0.0, a = 0.0;

  bool at_zero() const { return p == 0.0 && v == 0.0 && a == 0.0; }
};

/// The cubic p(t) = c0 + c1 t + c2 t^2 + c3 t^3 that meets position and velocity at t = 0 and t = T.
///
/// Positions are in m (or rad), T in s. Before t = 0 and after T it keeps p and v of that end, and a is 0.
/// Source: the paper, section IV ("cubic spline function for each direction").
class Cubic {
 public:
  Cubic() = default;
  /// `T` <= 0 gives a cubic that is at its end already. It throws nothing.
  Cubic(double p0, double v0, double p1, double v1, double T) : c0_(p0), c1_(v0), T_(std::max(T, 0.0)) {
    if (T_ == 0.0) {
      c0_ = p1;
      c1_ = v1;
      return;
    }
    const double d = p1 - p0;
    c2_ = (3.0 * d / T_ - 2.0 * v0 - v1) / T_;
    c3_ = (v0 + v1 - 2.0 * d / T_) / (T_ * T_);
  }

  Motion1 at(double t) const {
    const bool inside = t >= 0.0 && t <= T_;
    const double s = std::clamp(t, 0.0, T_);
    return {c0_ + s * (c1_ + s * (c2_ + s * c3_)), c1_ + s * (2.0 * c2_ + s * 3.0 * c3_),
            inside ? 2.0 * c2_ + 6.0 * c3_ * s : 0.0};
  }
  double duration() const { return T_; }

 private:
  double c0_ = 0.0, c1_ = 0.0, c2_ = 0.0, c3_ = 0.0, T_ = 0.0;
};

/// Velocities at the knots (t_i, p_i) with which the cubics between them join in a continuous acceleration. The first and the last are zero.
///
/// Row i of the system: v_i-1 / h_i-1 + 2 (1 / h_i-1 + 1 / h_i) v_i + v_i+1 / h_i = 3 (d_i-1 / h_i-1^2 + d_i / h_i^2), with
/// h_i = t_i+1 - t_i, d_i = p_i+1 - p_i.
/// @param t increasing (n,)   @param p (n,). @return (n,)
VecX knot_velocities(const ConstVecRef& t, const ConstVecRef& p);

/// The quintic that leads from `start` at t = 0 to zero position, velocity and acceleration at t = T > 0; zero after. t >= 0.
Motion1 fade_out(const Motion1& start, double T, double t);

}  // namespace zmpwalk
