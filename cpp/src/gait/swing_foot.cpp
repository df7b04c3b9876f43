#include "zmpwalk/gait/swing_foot.hpp"

#include <algorithm>
#include <cmath>

#include "zmpwalk/math/rotation.hpp"

namespace zmpwalk {
namespace {

constexpr double kLevel =
    1e-3;  // lift-off and landing that differ by less in height are level: a sole sinks into the ground under load [m]
constexpr double kBlend = 0.1;  // own time takes up its new rate within this [s], or sooner
constexpr double kStop = 1e-3;  // slowest rate of the own time

Motion1 sum(const Motion1& a, const Motion1& b) { return {a.p + b.p, a.v + b.v, a.a + b.a}; }

/// The same motion seen in another time: `m` runs by the own time `own`.
Motion1 in_time(const Motion1& m, const Motion1& own) {
  return {m.p, m.v * own.v, m.a * own.v * own.v + m.v * own.a};
}

/// Velocity at a knot p, `h_0` after (p_0, v_0) and `h_1` before (p_1, v_1), such that the cubics on both sides have one acceleration there.
double knot_velocity(double p_0, double v_0, double h_0, double p, double h_1, double p_1, double v_1) {
  return (3.0 * ((p - p_0) / (h_0 * h_0) + (p_1 - p) / (h_1 * h_1)) - v_0 / h_0 - v_1 / h_1) / (2.0 / h_0 + 2.0 / h_1);
}

}  // namespace

Motion1 OwnTime::at(double t) const {
  const double since = t - start_;
  if (!(blend_ > 0.0) || since >= blend_) return {end_ - rate_ * (landing_ - t), rate_, 0.0};
  // The rate goes from from_.v, changing by from_.a, to rate_, where it rests: a cubic, whose integral is the own time.
  const double u = since / blend_, d = rate_ - from_.v, a = from_.a * blend_;
  const double c2 = 3.0 * d - 2.0 * a, c3 = a - 2.0 * d;
  return {from_.p + blend_ * u * (from_.v + u * (a / 2.0 + u * (c2 / 3.0 + u * c3 / 4.0))),
          from_.v + u * (a + u * (c2 + u * c3)), (a + u * (2.0 * c2 + u * 3.0 * c3)) / blend_};
}

void OwnTime::retime(double t, double left) {
  from_ = at(t);
  const double way = end_ - from_.p;
  start_ = t;
  landing_ = t + left;
  // In the blend the own time goes on by blend (from_.v + rate) / 2 + blend^2 from_.a / 12.
  blend_ = std::min({kBlend, 0.5 * left, from_.v > 0.0 ? way / from_.v : kBlend});
  rate_ = std::max((way - blend_ * (from_.v / 2.0 + blend_ * from_.a / 12.0)) / (left - 0.5 * blend_), kStop);
}

void SwingFoot::begin(const Vec3& p, const Mat3& R, double duration, double z_land, double height, double speed) {
  time_ = OwnTime(duration);
  duration_ = duration;
  z_land_ = z_land;
  speed_ = speed;
  sinks_ = false;
  const double top = std::max(p.z(), z_land) + height;
  // Between ends at different heights, the longer way takes more time: at the top both cubics have one acceleration.
  const double up = std::sqrt(top - p.z()), down = std::sqrt(top - z_land);
  rise_ = duration * (std::abs(p.z() - z_land) < kLevel ? 0.5 : up / (up + down));
  const double fall = duration - rise_;
  const double v_top = speed > 0.0 ? knot_velocity(p.z(), 0.0, rise_, top, fall, z_land, -speed) : 0.0;
  up_ = Cubic(p.z(), 0.0, top, v_top, rise_);
  down_ = Cubic(top, v_top, z_land, -speed, fall);
  next_ = {Motion1{p.x(), 0.0, 0.0}, Motion1{p.y(), 0.0, 0.0}, Motion1{yaw_of(R), 0.0, 0.0}};
  target_ = SwingTarget{};
  target_.p = p;
  target_.R = rotation_z(yaw_ = next_[2].p);
}

Motion1 SwingFoot::height(double t, const Motion1& own) const {
  if (sinks_) return sum(sinking_.at(t - since_), fade_out({0.0, 0.0, beside_}, sunk_ - since_, t - since_));
  const double since = std::clamp(own.p, 0.0, duration_);  // a phase begins up to a nanosecond before its time
  return in_time(since < rise_ ? up_.at(since) : down_.at(since - rise_), own);
}

void SwingFoot::sink(double t, double time) {
  // A foot that is late goes on from the end of its splines as it ended.
  const double late = std::max(t - time_.landing(), 0.0);
  const Motion1 end = height(t - late, time_.at(t - late));
  const double v = end.v + late * end.a, p = end.p + late * (end.v + 0.5 * late * end.a);
  sinking_ = Cubic(p, v, z_land_ + 2.0 / 3.0 * v * time, 0.0, time);
  beside_ = end.a - sinking_.at(0.0).a;
  for (Motion1& m : next_) m.v = 0.0;
  since_ = t;
  sunk_ = t + time;
  sinks_ = true;
}

const SwingTarget& SwingFoot::update(double t, double dt, const Foothold& foothold) {
  const Motion1 own = time_.at(t);
  const double left = duration_ - own.p, step = time_.at(t + dt).p - own.p;
  const double yaw_there = next_[2].p + wrap_angle(foothold.yaw - next_[2].p);
  const std::array<double, 3> to{foothold.p.x(), foothold.p.y(), yaw_there};
  std::array<Motion1, 3> now;
  for (int i = 0; i < 3; ++i) {
    const Cubic spline(next_[i].p, next_[i].v, to[i], 0.0, left);
    now[i] = in_time({next_[i].p, next_[i].v, spline.at(0.0).a}, own);
    next_[i] = spline.at(std::min(step, left));
  }
  const auto& [x, y, yaw] = now;
  const Motion1 z = height(t, own);
  target_.p << x.p, y.p, z.p;
  target_.v << x.v, y.v, z.v;
  target_.a << x.a, y.a, z.a;
  if (yaw.p != yaw_) target_.R = rotation_z(yaw_ = yaw.p);
  target_.omega.z() = yaw.v;
  target_.alpha.z() = yaw.a;
  return target_;
}

}  // namespace zmpwalk
