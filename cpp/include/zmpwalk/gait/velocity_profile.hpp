#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// How a profile goes from one knot to the next: it keeps the velocity of the first and then jumps, or joins both by a line.
enum class Interpolation { kHold, kLinear };

/// How fast the planned velocity may change, for each of (v_x, v_y, w_z). A change up to `jump` is taken up at once. The rest follows at the rate
/// `acceleration`, or `deceleration` where the velocity goes towards zero. What has been used of `jump` comes back at the rate `acceleration`.
struct VelocityLimits {
  Vec3 jump = Vec3::Zero();          ///< [m/s, m/s, rad/s]
  Vec3 acceleration = Vec3::Zero();  ///< [m/s^2, m/s^2, rad/s^2]
  Vec3 deceleration = Vec3::Zero();  ///< [m/s^2, m/s^2, rad/s^2]
};

/// A velocity over time: (v_x, v_y, w_z) in the heading frame H [m/s, m/s, rad/s]. It keeps its last value for ever.
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

  /// The profile at one time. It is kept apart so that several questions about that time search for it once.
  struct Moment {
    double t = 0.0;                ///< [s]
    std::size_t segment = 0;       ///< number of the segment between two knots
    Vec3 v = Vec3::Zero();         ///< velocity (3,)
    Vec3 integral = Vec3::Zero();  ///< integral of the velocity from the first knot on (3,)
  };
  Moment at(double t) const;
  /// Velocity at time t [s] (3,); before 0 it is that at 0.
  Vec3 velocity(double t) const { return within(segment(t), t); }
  Vec3 displacement(double t0, double t1) const;  ///< integral of the velocity from t0 to t1 (3,) [m, m, rad]
  /// Where a frame that moves with this velocity is at t1, expressed in the frame as it is at t0: (x, y, yaw) [m, m, rad].
  Vec3 travel(double t0, double t1) const { return travel(at(t0), at(t1)); }
  Vec3 travel(const Moment& from, const Moment& to) const;
  /// v_x at time `t` [s], which is not before `from.t`. It moves `from.segment` on, so that the next call need not search.
  double forward_from(Moment& from, double t) const {
    while (from.segment + 1 < t_.size() && t + kEarly >= t_[from.segment + 1]) ++from.segment;
    return along(from.segment, t, 0);
  }
  bool at_rest(double t0, double t1) const;  ///< true where the velocity is zero from t0 to t1 [s]
  double max_speed() const;                  ///< largest |(v_x, v_y)| [m/s]

  /// This profile as a robot takes it up that stands at t = 0: it changes no faster than `limits`. Where it never does, it stays as it is.
  VelocityProfile limited(const VelocityLimits& limits) const;
  /// Goes towards `target` from the time `now` on, within `limits`, and forgets what was before. Allocates nothing once `reserve` was called.
  /// @param allowance  what is left of `limits.jump` (3,)
  void steer(double now, const Vec3& target, const VelocityLimits& limits, const Vec3& allowance);
  void reserve();  ///< sets memory aside for `steer`

  const std::vector<double>& t() const { return t_; }
  const std::vector<Vec3>& v() const { return v_; }  ///< at the knots, after a jump
  Interpolation interpolation() const { return interpolation_; }
  /// Whether w_z is other than 0 anywhere from `from` to the time `t1` [s].
  bool turns(const Moment& from, double t1) const;

 private:
  VelocityProfile() = default;
  // Control times are sums of time steps and carry rounding; therefore a knot counts as reached a nanosecond early.
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
