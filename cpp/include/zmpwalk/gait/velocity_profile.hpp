#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// How a profile goes from one knot to the next.
enum class Interpolation { kHold, kLinear };

/// How fast a planned velocity may change, each of (v_x, v_y, w_z): a change up to `jump` passes at once, what is more follows at
/// `acceleration`, or at `deceleration` where it slows down; at `acceleration` the `jump` also fills up again.
struct VelocityLimits {
  Vec3 jump = Vec3::Zero();          ///< [m/s, m/s, rad/s]
  Vec3 acceleration = Vec3::Zero();  ///< [m/s^2, m/s^2, rad/s^2]
  Vec3 deceleration = Vec3::Zero();  ///< [m/s^2, m/s^2, rad/s^2]
};

/// Planned velocity of the COM over time: (v_x, v_y, w_z) in the heading frame [m/s, m/s, rad/s]. Holds its last value.
///
/// Between two knots the velocity is linear; at a knot it may jump.
class VelocityProfile {
 public:
  /// @param t  knot times (n,) [s], from 0, strictly increasing   @param v  one velocity per knot
  /// @throws InputError  no knots, a time that does not increase, a first time that is not 0, NaN or infinity
  /// @throws DimensionError  t and v differ in length
  VelocityProfile(std::vector<double> t, std::vector<Vec3> v, Interpolation interpolation = Interpolation::kHold);

  /// The paper's experiment, section IV: 0.063, 0.156, 0.219, 0.25 m/s from 0, 0.8, 1.6, 2.4 s on.
  static VelocityProfile paper();

  /// The profile at one time, for several questions about it.
  struct Moment {
    double t = 0.0;                ///< [s]
    std::size_t segment = 0;       ///< that holds here
    Vec3 v = Vec3::Zero();         ///< velocity (3,)
    Vec3 integral = Vec3::Zero();  ///< of the velocity, from the first knot (3,)
  };
  Moment at(double t) const;
  Vec3 velocity(double t) const { return within(segment(t), t); }  ///< (3,) at time t [s]; before 0 as at 0
  Vec3 displacement(double t0, double t1) const;  ///< integral of the velocity from t0 to t1 (3,) [m, m, rad]
  /// Where a frame that moves with this velocity is at t1, seen from where it is at t0: (x, y, yaw) [m, m, rad].
  Vec3 travel(double t0, double t1) const { return travel(at(t0), at(t1)); }
  Vec3 travel(const Moment& from, const Moment& to) const;
  /// v_x at time `t` [s], not earlier than `from.t`; `from.segment` goes along for the next call.
  double forward_from(Moment& from, double t) const {
    while (from.segment + 1 < t_.size() && t + kEarly >= t_[from.segment + 1]) ++from.segment;
    return along(from.segment, t, 0);
  }
  bool at_rest(double t0, double t1) const;  ///< the velocity is zero from t0 to t1 [s]
  double max_speed() const;                  ///< largest |(v_x, v_y)| [m/s]

  /// This profile as a robot can follow it that stands at t = 0: no change faster than `limits`. Itself where none is.
  VelocityProfile limited(const VelocityLimits& limits) const;
  /// From now on towards `target`, within `limits`; forgets what was before `now`. Allocates nothing once `reserve` was called.
  /// @param allowance  what is left of `limits.jump` (3,)
  void steer(double now, const Vec3& target, const VelocityLimits& limits, const Vec3& allowance);
  void reserve();

  const std::vector<double>& t() const { return t_; }
  const std::vector<Vec3>& v() const { return v_; }  ///< at the knots, after a jump
  Interpolation interpolation() const { return interpolation_; }

 private:
  VelocityProfile() = default;
  // Control times are sums of steps: a knot counts as reached a nanosecond early.
  static constexpr double kEarly = 1e-9;
  std::size_t segment(double t) const;
  // The velocity, or one entry of it, that segment `i` has at time `t`.
  Vec3 within(std::size_t i, double t) const { return {along(i, t, 0), along(i, t, 1), along(i, t, 2)}; }
  double along(std::size_t i, double t, int axis) const {
    if (i + 1 == t_.size()) return v_[i][axis];
    const double s = std::clamp((t - t_[i]) / (t_[i + 1] - t_[i]), 0.0, 1.0);
    return v_[i][axis] + s * (end_[i][axis] - v_[i][axis]);
  }
  Vec3 integral(double t) const { return at(t).integral; }
  bool turns(const Moment& from, double t1) const;
  /// Appends a segment from (t, v), linear to `end` at t + length.
  void append(double t, const Vec3& v, const Vec3& end, double length);
  void follow(double t, double length, const Vec3& from, const Vec3& to, const VelocityLimits& limits, Vec3& v,
              Vec3& allowance);

  std::vector<double> t_;
  std::vector<Vec3> v_, end_;  // of each segment: at its knot, and where it ends
  std::vector<Vec3> sum_;      // integral up to each knot
  Interpolation interpolation_ = Interpolation::kHold;
};

}  // namespace zmpwalk
