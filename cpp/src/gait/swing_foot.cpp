#include "zmpwalk/gait/swing_foot.hpp"

#include <algorithm>
#include <cmath>

#include "zmpwalk/math/rotation.hpp"

namespace zmpwalk {
namespace {

constexpr double kLevel =
    1e-3;  // lift-off and landing that differ by less in height are level: a sole sinks into the ground under load [m]
constexpr double kAtTop = 1e-6;  // a foot nearer to its top than this counts as there [s]

Motion1 sum(const Motion1& a, const Motion1& b) { return {a.p + b.p, a.v + b.v, a.a + b.a}; }

/// Velocity at a knot p, `h_0` after (p_0, v_0) and `h_1` before (p_1, v_1), such that the cubics on both sides have one acceleration there.
double knot_velocity(double p_0, double v_0, double h_0, double p, double h_1, double p_1, double v_1) {
  return (3.0 * ((p - p_0) / (h_0 * h_0) + (p_1 - p) / (h_1 * h_1)) - v_0 / h_0 - v_1 / h_1) / (2.0 / h_0 + 2.0 / h_1);
}

}  // namespace

void SwingFoot::begin(const Vec3& p, const Mat3& R, double duration, double z_land, double height, double speed) {
  duration_ = duration;
  z_land_ = z_land;
  speed_ = speed;
  top_ = std::max(p.z(), z_land) + height;
  start_ = fade_ = 0.0;
  // Between ends at different heights, the longer way takes more time: at the top both cubics have one acceleration.
  const double up = std::sqrt(top_ - p.z()), down = std::sqrt(top_ - z_land);
  rise_ = duration * (std::abs(p.z() - z_land) < kLevel ? 0.5 : up / (up + down));
  const double fall = duration - rise_;
  const double v_top = speed > 0.0 ? knot_velocity(p.z(), 0.0, rise_, top_, fall, z_land, -speed) : 0.0;
  up_ = Cubic(p.z(), 0.0, top_, v_top, rise_);
  down_ = Cubic(top_, v_top, z_land, -speed, fall);
  to_ << p.head<2>(), yaw_of(R);
  for (int i = 0; i < 3; ++i) next_[i] = {to_[i], 0.0, 0.0};
  target_ = SwingTarget{};
  target_.p = p;
  target_.R = rotation_z(yaw_ = to_.z());
}

Motion1 SwingFoot::height(double t) const {
  const double since = std::max(t - start_, 0.0);  // a phase begins up to a nanosecond before its time
  return since < rise_ ? up_.at(since) : down_.at(since - rise_);
}

void SwingFoot::sink(double t, double time) {
  z_land_ -= 2.0 / 3.0 * speed_ * time;
  speed_ = 0.0;
  replan(t, time);
}

void SwingFoot::replan(double t, double left) {
  // A foot that is late goes on from the end of its splines as it ended.
  const double late = std::max(t - duration_, 0.0);
  const auto now = [&](int i, const Motion1& spline) {
    const Motion1 gone{spline.p + late * (spline.v + 0.5 * late * spline.a), spline.v + late * spline.a, spline.a};
    return fade_ > 0.0 ? sum(gone, fade_out({0.0, 0.0, beside_[i]}, fade_, t - start_)) : gone;
  };
  for (int i = 0; i < 3; ++i) {
    const Motion1 from = next_[i] = now(i, next_[i]);
    beside_[i] = from.a - Cubic(from.p, from.v, to_[i], 0.0, left).at(0.0).a;
  }
  const Motion1 z = now(3, height(std::min(t, duration_)));
  const double to_top = start_ + rise_ - t;
  if (to_top > kAtTop) {
    rise_ = to_top * left / (duration_ - t);
    const double fall = left - rise_, v_top = knot_velocity(z.p, z.v, rise_, top_, fall, z_land_, -speed_);
    up_ = Cubic(z.p, z.v, top_, v_top, rise_);
    down_ = Cubic(top_, v_top, z_land_, -speed_, fall);
    beside_[3] = z.a - up_.at(0.0).a;
  } else {
    rise_ = 0.0;
    down_ = Cubic(z.p, z.v, z_land_, -speed_, left);
    beside_[3] = z.a - down_.at(0.0).a;
  }
  duration_ = t + left;
  start_ = t;
  fade_ = left;
}

const SwingTarget& SwingFoot::update(double t, double dt, const Foothold& foothold) {
  const double left = duration_ - t;
  to_ << foothold.p, next_[2].p + wrap_angle(foothold.yaw - next_[2].p);
  std::array<Motion1, 4> now;  // x, y, yaw, z
  for (int i = 0; i < 3; ++i) {
    const Cubic spline(next_[i].p, next_[i].v, to_[i], 0.0, left);
    now[i] = {next_[i].p, next_[i].v, spline.at(0.0).a};
    next_[i] = spline.at(std::min(dt, left));
  }
  now[3] = height(t);
  if (fade_ > 0.0)
    for (int i = 0; i < 4; ++i) now[i] = sum(now[i], fade_out({0.0, 0.0, beside_[i]}, fade_, t - start_));
  const auto& [x, y, yaw, z] = now;
  target_.p << x.p, y.p, z.p;
  target_.v << x.v, y.v, z.v;
  target_.a << x.a, y.a, z.a;
  if (yaw.p != yaw_) target_.R = rotation_z(yaw_ = yaw.p);
  target_.omega.z() = yaw.v;
  target_.alpha.z() = yaw.a;
  return target_;
}

}  // namespace zmpwalk
