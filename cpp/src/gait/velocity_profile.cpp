#include "zmpwalk/gait/velocity_profile.hpp"

#include <algorithm>
#include <cmath>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

/// No walk is faster [m/s, rad/s] or lasts longer [s]; with larger numbers the sums of a plan overflow.
constexpr double kFastest = 1e3, kLongest = 1e9;

}  // namespace

VelocityProfile::VelocityProfile(std::vector<double> t, std::vector<Vec3> v, Interpolation interpolation)
    : t_(std::move(t)), v_(std::move(v)), interpolation_(interpolation) {
  if (t_.empty()) throw InputError("a velocity profile has no knots; it needs at least one, at t = 0");
  require_size("v", static_cast<long>(v_.size()), static_cast<long>(t_.size()));
  for (std::size_t i = 0; i < t_.size(); ++i) {
    const std::string where = "knot " + std::to_string(i);
    if (!std::isfinite(t_[i]) || !v_[i].allFinite())
      throw InputError("velocity profile, " + where + ": time or velocity is not finite");
    if (std::abs(t_[i]) > kLongest || v_[i].cwiseAbs().maxCoeff() > kFastest)
      throw InputError("velocity profile, " + where +
                       ": time or velocity is too large; a time is at most 1e9 s, a velocity 1000 m/s or 1000 rad/s");
    if (i == 0 && t_[0] != 0.0)
      throw InputError("velocity profile starts at t = " + std::to_string(t_[0]) + " s; it must start at 0");
    if (i > 0 && !(t_[i] > t_[i - 1]))
      throw InputError("velocity profile, " + where + ": t = " + std::to_string(t_[i]) + " s does not come after " +
                       std::to_string(t_[i - 1]) + " s; times must increase");
  }
  end_ = v_;
  if (interpolation_ == Interpolation::kLinear) std::copy(v_.begin() + 1, v_.end(), end_.begin());
  sum_.assign(t_.size(), Vec3::Zero());
  for (std::size_t i = 1; i < t_.size(); ++i)
    sum_[i] = sum_[i - 1] + 0.5 * (t_[i] - t_[i - 1]) * (v_[i - 1] + end_[i - 1]);
}

VelocityProfile VelocityProfile::paper() {
  return VelocityProfile({0.0, 0.8, 1.6, 2.4}, {{0.063, 0, 0}, {0.156, 0, 0}, {0.219, 0, 0}, {0.25, 0, 0}});
}

std::size_t VelocityProfile::segment(double t) const {
  if (t + kEarly >= t_.back()) return t_.size() - 1;
  const auto next = std::upper_bound(t_.begin(), t_.end(), t + kEarly);
  return next == t_.begin() ? 0 : static_cast<std::size_t>(next - t_.begin()) - 1;
}

VelocityProfile::Moment VelocityProfile::at(double t) const {
  const std::size_t i = segment(t);
  const Vec3 v = within(i, t);
  return {t, i, v, sum_[i] + 0.5 * (t - t_[i]) * (v_[i] + v)};
}

Vec3 VelocityProfile::displacement(double t0, double t1) const { return integral(t1) - integral(t0); }

Vec3 VelocityProfile::travel(const Moment& from, const Moment& to) const {
  const Vec3 straight = to.integral - from.integral;
  if (!turns(from, to.t)) return straight;
  // A piece of about kPiece turns by so little that it is taken to move straight, along the heading in its middle.
  constexpr double kPiece = 0.1;  // [s]; at 0.5 rad/s a piece's chord is its arc within 1e-4
  const int pieces = static_cast<int>(std::ceil((to.t - from.t) / kPiece));
  Vec3 out(0.0, 0.0, straight.z()), last = from.integral;
  for (int k = 1; k <= pieces; ++k) {
    const Vec3 now = integral(from.t + k * (to.t - from.t) / pieces);
    const double yaw = 0.5 * (last.z() + now.z()) - from.integral.z();
    const double c = std::cos(yaw), s = std::sin(yaw), dx = now.x() - last.x(), dy = now.y() - last.y();
    out.x() += c * dx - s * dy;
    out.y() += s * dx + c * dy;
    last = now;
  }
  return out;
}

bool VelocityProfile::turns(const Moment& from, double t1) const {
  for (std::size_t i = from.segment; i < t_.size() && (i == from.segment || t_[i] < t1); ++i)
    if (v_[i].z() != 0.0 || end_[i].z() != 0.0) return true;
  return false;
}

bool VelocityProfile::at_rest(double t0, double t1) const {
  for (std::size_t first = segment(t0), i = first; i < t_.size() && (i == first || t_[i] < t1); ++i)
    if (!v_[i].isZero(0.0) || !end_[i].isZero(0.0)) return false;
  return true;
}

double VelocityProfile::max_speed() const {
  double speed = 0.0;
  for (const Vec3& v : v_) speed = std::max(speed, v.head<2>().norm());
  return speed;
}

void VelocityProfile::append(double t, const Vec3& v, const Vec3& end, double length) {
  if (!t_.empty())
    sum_.push_back(sum_.back() + 0.5 * (t - t_.back()) * (v_.back() + end_.back()));
  else
    sum_.push_back(Vec3::Zero());
  t_.push_back(t);
  v_.push_back(v);
  end_.push_back(std::isinf(length) ? v : end);
}

void VelocityProfile::follow(double t, double length, const Vec3& from, const Vec3& to, const VelocityLimits& limits,
                             Vec3& v, Vec3& allowance) {
  const Vec3 slope = std::isinf(length) ? Vec3(Vec3::Zero()) : Vec3((to - from) / length);
  Vec3 target = from;
  std::array<bool, 3> on;
  for (int i = 0; i < 3; ++i) {
    const double jump = std::clamp(target[i] - v[i], -allowance[i], allowance[i]);
    on[i] = std::abs(target[i] - v[i]) <= allowance[i];
    v[i] = on[i] ? target[i] : v[i] + jump;
    allowance[i] -= std::abs(jump);
  }
  double left = length;
  while (left > 0.0) {
    double dt = left;
    Vec3 rate;
    std::array<double, 3> caught, stopped;
    for (int i = 0; i < 3; ++i) {
      const double lag = target[i] - v[i], towards = lag != 0.0 ? lag : slope[i];
      const bool slows = towards * v[i] < 0.0;
      const double a = slows ? limits.deceleration[i] : limits.acceleration[i];
      caught[i] = stopped[i] = kForever;
      if (on[i] && std::abs(slope[i]) <= a) {
        rate[i] = slope[i];
        if (slows && std::abs(slope[i]) > limits.acceleration[i]) stopped[i] = -v[i] / slope[i];
      } else {
        on[i] = false;
        rate[i] = std::copysign(a, towards);
        const double closing = lag / (rate[i] - slope[i]);
        if (lag != 0.0 && closing > 0.0) caught[i] = closing;
        if (slows)
          stopped[i] = -v[i] / rate[i];  // it slows down until the velocity is zero, and then speeds up the other way
      }
      dt = std::min({dt, caught[i], stopped[i]});
    }
    Vec3 end = v;
    for (int i = 0; i < 3; ++i) {
      if (!std::isinf(dt)) {
        target[i] = dt == left ? to[i] : target[i] + slope[i] * dt;
        end[i] = on[i] ? target[i] : v[i] + rate[i] * dt;
      }
      if (caught[i] <= dt) {
        on[i] = true;
        end[i] = target[i];
      } else if (stopped[i] <= dt) {
        end[i] = 0.0;
        if (on[i]) target[i] = 0.0;
      }
      const double spent = std::abs(end[i] - v[i]);
      allowance[i] = std::min(limits.jump[i], allowance[i] + std::max(limits.acceleration[i] * dt - spent, 0.0));
    }
    append(t, v, end, dt);
    v = end;
    if (std::isinf(dt)) break;
    t += dt;
    left = left - dt > 1e-9 || std::isinf(left) ? left - dt : 0.0;
  }
}

VelocityProfile VelocityProfile::limited(const VelocityLimits& limits) const {
  VelocityProfile out;
  out.interpolation_ = interpolation_;
  Vec3 v = Vec3::Zero(), allowance = limits.jump;
  for (std::size_t i = 0; i < t_.size(); ++i)
    out.follow(t_[i], i + 1 < t_.size() ? t_[i + 1] - t_[i] : kForever, v_[i], end_[i], limits, v, allowance);
  return out;
}

void VelocityProfile::reserve() {
  constexpr std::size_t kSegments = 16;  // a new target needs at most four segments
  t_.reserve(kSegments);
  v_.reserve(kSegments);
  end_.reserve(kSegments);
  sum_.reserve(kSegments);
}

void VelocityProfile::steer(double now, const Vec3& target, const VelocityLimits& limits, const Vec3& allowance) {
  Vec3 v = velocity(now), left = allowance;
  t_.clear();
  v_.clear();
  end_.clear();
  sum_.clear();
  follow(now, kForever, target, target, limits, v, left);
}

}  // namespace zmpwalk
