#include "zmpwalk/gait/velocity_profile.hpp"

#include <algorithm>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

VelocityProfile::VelocityProfile(std::vector<double> t, std::vector<Vec3> v, Interpolation interpolation)
    : t_(std::move(t)), v_(std::move(v)), interpolation_(interpolation) {
  if (t_.empty()) throw InputError("a velocity profile has no knots; it needs at least one, at t = 0");
  require_size("v", static_cast<long>(v_.size()), static_cast<long>(t_.size()));
  for (std::size_t i = 0; i < t_.size(); ++i) {
    const std::string where = "knot " + std::to_string(i);
    if (!std::isfinite(t_[i]) || !v_[i].allFinite())
      throw InputError("velocity profile, " + where + ": time or velocity is not finite");
    if (i == 0 && t_[0] != 0.0)
      throw InputError("velocity profile starts at t = " + std::to_string(t_[0]) + " s; it must start at 0");
    if (i > 0 && !(t_[i] > t_[i - 1]))
      throw InputError("velocity profile, " + where + ": t = " + std::to_string(t_[i]) + " s does not come after " +
                       std::to_string(t_[i - 1]) + " s; times must increase");
  }
  sum_.assign(t_.size(), Vec3::Zero());
  for (std::size_t i = 1; i < t_.size(); ++i) {
    const Vec3 mean = interpolation_ == Interpolation::kHold ? v_[i - 1] : Vec3(0.5 * (v_[i - 1] + v_[i]));
    sum_[i] = sum_[i - 1] + (t_[i] - t_[i - 1]) * mean;
  }
}

VelocityProfile VelocityProfile::paper() {
  return VelocityProfile({0.0, 0.8, 1.6, 2.4}, {{0.063, 0, 0}, {0.156, 0, 0}, {0.219, 0, 0}, {0.25, 0, 0}});
}

std::size_t VelocityProfile::segment(double t) const {
  // Control times are sums of steps: a knot counts as reached a nanosecond early.
  const auto next = std::upper_bound(t_.begin(), t_.end(), t + 1e-9);
  return next == t_.begin() ? 0 : static_cast<std::size_t>(next - t_.begin()) - 1;
}

Vec3 VelocityProfile::velocity(double t) const {
  const std::size_t i = segment(t);
  if (interpolation_ == Interpolation::kHold || i + 1 == t_.size()) return v_[i];
  const double s = std::clamp((t - t_[i]) / (t_[i + 1] - t_[i]), 0.0, 1.0);
  return (1.0 - s) * v_[i] + s * v_[i + 1];
}

Vec3 VelocityProfile::integral(double t) const {
  const std::size_t i = segment(t);
  return sum_[i] + 0.5 * (t - t_[i]) * (v_[i] + velocity(t));
}

Vec3 VelocityProfile::displacement(double t0, double t1) const { return integral(t1) - integral(t0); }

double VelocityProfile::max_speed() const {
  double speed = 0.0;
  for (const Vec3& v : v_) speed = std::max(speed, v.head<2>().norm());
  return speed;
}

}  // namespace zmpwalk
