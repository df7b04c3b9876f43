#include "zmpwalk/gait/swing_foot.hpp"

#include <algorithm>
#include <cmath>

#include "zmpwalk/math/rotation.hpp"

namespace zmpwalk {
namespace {

constexpr double kLevel =
    1e-3;  // lift-off and landing that differ by less in height are level: a sole sinks into the ground under load [m]
constexpr double kLeastShare =
    0.2;  // least rate of an own time that is held back, as a share of the mean rate to its end
constexpr double kShortest = 1e-6;  // blend [s]: a rate that must change at once
constexpr double kStop = 1e-3;      // slowest rate of the own time
// A steep swing: shares of its duration until which it only rises, and from which on it is over its place; least share of the time left that its way
// there takes.
constexpr double kRises = 0.15, kThere = 0.88, kLeastLeft = 0.3;
constexpr double kTilts = 0.1, kTilted = 0.9;  // shares of its duration in which a sole turns to the ground's tilt

Motion1 sum(const Motion1& a, const Motion1& b) { return {a.p + b.p, a.v + b.v, a.a + b.a}; }

/// The same motion seen in another time: `m` runs by the own time `own`.
Motion1 in_time(const Motion1& m, const Motion1& own) { return {m.p, m.v * own.v, m.a * own.v * own.v + m.v * own.a}; }

/// Velocity at a knot p, `h_0` after (p_0, v_0) and `h_1` before (p_1, v_1), such that the cubics on both sides have one acceleration there.
double knot_velocity(double p_0, double v_0, double h_0, double p, double h_1, double p_1, double v_1) {
  return (3.0 * ((p - p_0) / (h_0 * h_0) + (p_1 - p) / (h_1 * h_1)) - v_0 / h_0 - v_1 / h_1) / (2.0 / h_0 + 2.0 / h_1);
}

}  // namespace

Motion1 OwnTime::at(double t) const {
  const double since = t - start_;
  if (untouched()) return {t, 1.0, 0.0};
  if (since >= blend_) return {end_ - rate_ * (landing_ - t), rate_, 0.0};
  // The rate goes from from_.v, changing by from_.a, to rate_, where it rests without a bend: a quartic, whose integral is the own time.
  const double u = since / blend_, d = rate_ - from_.v, a = from_.a * blend_;
  const double c2 = 6.0 * d - 3.0 * a, c3 = 3.0 * a - 8.0 * d, c4 = 3.0 * d - a;
  return {from_.p + blend_ * u * (from_.v + u * (a / 2.0 + u * (c2 / 3.0 + u * (c3 / 4.0 + u * c4 / 5.0)))),
          from_.v + u * (a + u * (c2 + u * (c3 + u * c4))),
          (a + u * (2.0 * c2 + u * (3.0 * c3 + u * 4.0 * c4))) / blend_};
}

void OwnTime::retime(double t, double left) {
  from_ = at(t);
  const double way = end_ - from_.p;
  start_ = t;
  landing_ = t + left;
  // In the blend the own time goes on by blend (0.4 from_.v + 0.6 rate + 0.05 blend from_.a). It takes all the time that is left, unless the rate
  // after it were to fall below a share of the mean rate.
  const double least = kLeastShare * way / left;
  blend_ = from_.v > least ? std::min(left, (way - least * left) / (0.4 * (from_.v - least))) : left;
  blend_ = std::max(blend_, kShortest);
  rate_ = std::max((way - blend_ * (0.4 * from_.v + 0.05 * blend_ * from_.a)) / (left - 0.4 * blend_), kStop);
}

void SwingFoot::begin(const Vec3& p, const Mat3& R, double duration, double z_land, double height, double speed,
                      bool steep, const Vec2& tilt) {
  SwingShape shape;
  shape.starts = steep ? kRises : 0.0;
  shape.arrives = steep ? kThere : 1.0;
  shape.tilts = !std::isnan(tilt.x());
  shape.tilt = tilt;
  shape.top = std::max(p.z(), z_land) + height;
  begin(p, R, duration, z_land, shape, speed);
}

void SwingFoot::begin(const Vec3& p, const Mat3& R, double duration, double z_land, const SwingShape& shape,
                      double speed) {
  starts_ = shape.starts;
  arrives_ = shape.arrives;
  tilts_ = shape.tilts;
  from_tilt_ = {std::atan2(R(2, 1), R(2, 2)), -std::asin(std::clamp(R(2, 0), -1.0, 1.0))};
  to_tilt_ = shape.tilt;
  fly(p, R, duration, z_land, shape.top, shape.rise, speed);
}

void SwingFoot::fly(const Vec3& p, const Mat3& R, double duration, double z_land, double top, double rise,
                    double speed) {
  time_ = OwnTime(duration);
  duration_ = duration;
  z_land_ = z_moved_ = z_land;
  sinks_ = false;
  // Between ends at different heights, the longer way takes more time: at the top both cubics have one acceleration.
  const double up = std::sqrt(top - p.z()), down = std::sqrt(top - z_land);
  rise_ = duration * (!std::isnan(rise) ? rise : std::abs(p.z() - z_land) < kLevel ? 0.5 : up / (up + down));
  const double fall = duration - rise_;
  const double v_top = speed > 0.0 ? knot_velocity(p.z(), 0.0, rise_, top, fall, z_land, -speed) : 0.0;
  up_ = Cubic(p.z(), 0.0, top, v_top, rise_);
  down_ = Cubic(top, v_top, z_land, -speed, fall);
  next_ = {Motion1{p.x(), 0.0, 0.0}, Motion1{p.y(), 0.0, 0.0}, Motion1{yaw_of(R), 0.0, 0.0}};
  target_ = SwingTarget{};
  target_.p = p;
  target_.R = rotation_z(yaw_ = next_[2].p);
}

Motion1 SwingFoot::height(const Motion1& own) const {
  const double since = std::clamp(own.p, 0.0, duration_);  // a phase begins up to a nanosecond before its time
  return since < rise_ ? up_.at(since) : down_.at(since - rise_);
}

void SwingFoot::sink(double t, double time) {
  // A foot that is late goes on from the end of its splines as it ended.
  const double late = std::max(t - time_.landing(), 0.0);
  const Motion1 own = time_.at(t - late);
  for (int i = 0; i < 4; ++i) {
    const Motion1 end = in_time(i < 3 ? next_[i] : height(own), own);
    const Motion1 now{end.p + late * (end.v + 0.5 * late * end.a), end.v + late * end.a, end.a};
    sinking_[i] = Cubic(now.p, now.v, i < 3 ? to_[i] : z_land_ + 2.0 / 3.0 * end.v * time, 0.0, time);
    beside_[i] = now.a - sinking_[i].at(0.0).a;
  }
  since_ = t;
  sunk_ = t + time;
  sinks_ = true;
}

void SwingFoot::tilt(const Motion1& own, const Motion1& yaw) {
  const double from = kTilts * duration_, time = (kTilted - kTilts) * duration_;
  std::array<Motion1, 2> angle;
  for (int i = 0; i < 2; ++i)
    angle[i] = in_time(Cubic(from_tilt_[i], 0.0, to_tilt_[i], 0.0, time).at(std::clamp(own.p - from, 0.0, time)), own);
  const Turning turn = turning(angle[0], angle[1], yaw);
  target_.R = turn.R;
  target_.omega = turn.omega;
  target_.alpha = turn.alpha;
  yaw_ = yaw.p;
}

const SwingTarget& SwingFoot::update(double t, double dt, const Foothold& foothold) {
  std::array<Motion1, 4> now;  // x, y, yaw, z
  if (sinks_) {
    for (int i = 0; i < 4; ++i)
      now[i] = sum(sinking_[i].at(t - since_), fade_out({0.0, 0.0, beside_[i]}, sunk_ - since_, t - since_));
  } else {
    const Motion1 own = time_.at(t);
    const bool rises = starts_ > 0.0 && own.p < starts_ * duration_;
    double left = duration_ - own.p;
    if (arrives_ < 1.0) left = std::max(arrives_ * duration_ - own.p, kLeastLeft * left);
    const double step = time_.step(t, dt);
    to_ = {foothold.p.x(), foothold.p.y(), next_[2].p + wrap_angle(foothold.yaw - next_[2].p)};
    for (int i = 0; i < 3; ++i) {
      if (rises) {
        now[i] = {next_[i].p, 0.0, 0.0};
        continue;
      }
      const Cubic spline(next_[i].p, next_[i].v, to_[i], 0.0, left);
      now[i] = in_time({next_[i].p, next_[i].v, spline.at(0.0).a}, own);
      next_[i] = spline.at(std::min(step, left));
    }
    now[3] = in_time(height(own), own);
    if (z_moved_ != z_land_) {
      const Motion1 share = in_time(Cubic(0.0, 0.0, 1.0, 0.0, duration_).at(std::clamp(own.p, 0.0, duration_)), own);
      const double moved = z_moved_ - z_land_;
      now[3] = sum(now[3], {moved * share.p, moved * share.v, moved * share.a});
    }
  }
  const auto& [x, y, yaw, z] = now;
  target_.p << x.p, y.p, z.p;
  target_.v << x.v, y.v, z.v;
  target_.a << x.a, y.a, z.a;
  if (tilts_) {
    tilt(time_.at(t), yaw);
    return target_;
  }
  if (yaw.p != yaw_) target_.R = rotation_z(yaw_ = yaw.p);
  target_.omega.z() = yaw.v;
  target_.alpha.z() = yaw.a;
  return target_;
}

}  // namespace zmpwalk
