#pragma once

namespace zmpwalk {

/// Position, velocity and acceleration of one coordinate.
struct Motion1 {
  double p = 0.0, v = 0.0, a = 0.0;
};

/// The cubic p(t) = c0 + c1 t + c2 t^2 + c3 t^3 that meets position and velocity at t = 0 and t = T.
///
/// Lengths in m (or rad), T in s. Past its ends it holds: p and v of the end, a = 0.
/// Source: the paper, section IV ("cubic spline function for each direction").
class Cubic {
 public:
  Cubic() = default;
  /// @throws nothing; `T` <= 0 gives a cubic that already is at its end.
  Cubic(double p0, double v0, double p1, double v1, double T);

  Motion1 at(double t) const;
  double duration() const { return T_; }

 private:
  double c0_ = 0.0, c1_ = 0.0, c2_ = 0.0, c3_ = 0.0, T_ = 0.0;
};

}  // namespace zmpwalk
