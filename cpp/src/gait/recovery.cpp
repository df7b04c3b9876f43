// What the gait does when the robot is pushed: the parts of GaitGenerator that a quiet walk never feels.

#include <algorithm>
#include <cmath>

#include "zmpwalk/gait/capture_region.hpp"
#include "zmpwalk/gait/gait_generator.hpp"

namespace zmpwalk {
namespace {

// Distances of the DCM from its plan, as shares of the sole's half length or half width.
constexpr double kCalm = 0.3;   // up to here the ZMP keeps to its usual bounds: changes of speed make as much
constexpr double kAlarm = 0.7;  // from here on it may use the whole sole

constexpr double kNarrow = 0.5;  // share of the width that the ZMP gives up where the length matters more
constexpr double kSide = 0.4;    // the ZMP at this share of the half width, or less, is nowhere near a corner

// Ways of the DCM that pushes have caused, in the same shares.
constexpr double kFelt = 0.15;    // landings, noise and wrong masses make as much
constexpr double kCounts = 0.4;   // from here on a push counts fully
constexpr double kForget = 10.0;  // time constant with which a push is forgotten, in T_c: that of some steps

constexpr double kPushed = 0.5;       // urgency from which the robot counts as pushed
constexpr double kFreezeLate = 0.95;  // share of the single support until which a pushed robot moves its foothold
constexpr double kBeside = 0.5;  // of `steps.aside_most`: so far beside a foot the DCM may come that carries at once

// Times in T_c.
constexpr double kDecided = 0.36;  // a foot that is to land this soon keeps its time, so that it lands calmly
constexpr double kTakenUp = 0.07;  // within this a new landing time is taken up; noise would shake the foot otherwise
constexpr double kSame = 0.004;    // landing times that differ by less are the same
constexpr int kLift = 3;  // control cycles of double support in which a standing robot shifts its load before it steps

/// How far `x` along the sole lies outside of where the ZMP may be [m].
double outside(const ZmpBounds& sole, double x) { return Interval{sole.lower.x(), sole.upper.x()}.outside(x); }

/// 0 up to 0, 1 from 1 on, smooth in between.
double smooth_step(double x) {
  const double s = std::clamp(x, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

}  // namespace

double GaitGenerator::regain(const GaitInput& in) const {
  if (!recovers_ || out_.at_rest || starting_) return 0.0;
  const TrackingSettings& tracking = settings_.tracking;
  const double far = std::max(std::abs(in.behind) - tracking.regain_from, 0.0);
  if (far == 0.0 || plan_.at_rest(in.t, in.t + schedule_.times().period())) return 0.0;  // it stands where it can
  return std::copysign(std::min(tracking.regain_gain * far, tracking.regain_speed), in.behind);
}

Vec2 GaitGenerator::swing_velocity() const {
  if (began_ == Began::kSingleSupport) return Vec2::Zero();
  return out_.swing_target.v.head<2>();
}

Vec2 GaitGenerator::swing_acceleration() const {
  return {settings_.swing.ahead_acceleration, settings_.swing.aside_acceleration};
}

LandingRoom GaitGenerator::landing_room(const GaitInput& in) const {
  const double time = schedule_.touch_down() - in.t;
  return {in.p_sole[out_.swing].head<2>() + 0.5 * time * swing_velocity(), swing_acceleration() * (time * time / 6.0)};
}

bool GaitGenerator::off_the_feet(const GaitInput& in) const {
  if (!out_.standing[kLeft] || !out_.standing[kRight]) return false;
  const Vec2 xi = axes_of(out_.ahead_S).transpose() * (in.com + pendulum_.Tc() * in.dcom - out_.origin);
  return xi != room(in, whole_, whole_[out_.support]).clamp(xi);
}

void GaitGenerator::begin_catching(const GaitInput& in) {
  const Vec2 middle = 0.5 * (in.p_sole[kLeft] + in.p_sole[kRight]).head<2>();
  const double aside = (in.com + pendulum_.Tc() * in.dcom - middle).dot(left_of(out_.ahead));
  out_.at_rest = starting_ = false;
  out_.swing = aside > 0.0 ? kRight : kLeft;
  lateral_.reset(out_.swing);
  footsteps_.restart(feet_of(in));
  schedule_.begin(out_.phase.step, in.t, kLift * settings_.control.dt, times_at(in.t));
}

void GaitGenerator::feel_pushes(const GaitInput& in) {
  const double Tc = pendulum_.Tc();
  if (in.dcom_expected.allFinite())
    pushed_way_ += Tc * (in.dcom - in.dcom_expected) - settings_.control.dt / (kForget * Tc) * pushed_way_;
  const Vec2 way = axes_of(out_.ahead_S).transpose() * pushed_way_,
             whole = 0.5 * (whole_[out_.support].upper - whole_[out_.support].lower);
  pushed_ = smooth_step((way.cwiseAbs().cwiseQuotient(whole).maxCoeff() - kFelt) / (kCounts - kFelt));
  // An edge of the ground pushes as well, unnoticed: the ZMP stays at it, wherever the torque would have it.
  if (off_plan_ > kCalm && !out_.at_rest && !starting_)
    pushed_ = std::max(pushed_, smooth_step((off_plan_ - kCalm) / (kAlarm - kCalm)));
}

Vec2 GaitGenerator::off_plan(const GaitInput& in) const {
  const Vec2 left = left_of(out_.ahead_M), from = in.com - out_.origin, &whole = whole_[out_.support].upper;
  const double Tc = pendulum_.Tc(), x = from.dot(out_.ahead_M) - out_.orbit_middle;
  const double ahead =
      Tc * (in.dcom.dot(out_.ahead_M) - out_.orbit.velocity(x)) / (0.5 * (sole_room_.upper.x() - sole_room_.lower.x()));
  const double aside = before_switch() ? 0.0 : ((from + Tc * in.dcom).dot(left) - xi_planned_) / whole.y();
  return {ahead, aside};
}

Vec2 GaitGenerator::off_stand(const Vec2& off) const {
  return (axes_of(out_.ahead_S).transpose() * off).cwiseQuotient(0.5 * (out_.room.upper - out_.room.lower));
}

double GaitGenerator::urgency(const Vec2& off) const {
  return starting_ ? 0.0 : pushed_ * smooth_step((off.cwiseAbs().maxCoeff() - kCalm) / (kAlarm - kCalm));
}

double GaitGenerator::decided_share(const GaitInput& in) const {
  const double share = out_.phase.time / out_.phase.duration;
  if (pushed_ == 0.0 || began_ == Began::kSingleSupport) return share;
  // A force that goes on leaves the COM on its orbit, but ahead of its time. What tells is where the DCM will be over the next foot.
  const double xi = xi_next_ - (footsteps_.target().p - out_.origin).dot(ahead_next_);
  if (outside(bounds_[out_.swing], xi) == 0.0 && urgency(off_plan(in)) < kPushed) return share;
  return share * std::min(settings_.steps.freeze / kFreezeLate, 1.0);
}

bool GaitGenerator::is_nearer_landed(const GaitInput& in, double off) const {
  const Side landed = other(out_.support);
  const double Tc = pendulum_.Tc();
  const Vec2 xi = in.com + Tc * in.dcom - out_.origin, foot = in.p_sole[landed].head<2>() - out_.origin;
  const double x = xi.dot(out_.ahead_M), there = foot.dot(out_.ahead_M);
  if (off * there <= 0.0 || outside(whole_[landed], x - there) >= outside(whole_[out_.support], x)) return false;
  // The ZMP then leaves the other foot for good: beside this one the DCM runs away until the next step, which must reach it.
  const double beside = side_sign(out_.support) * (xi - foot).dot(left_of(out_.ahead_M)) - whole_[landed].upper.y();
  const double until = out_.phase.duration - out_.phase.time + settings_.steps.least_time;
  return beside * std::exp(until / Tc) <= kBeside * settings_.steps.aside_most;
}

void GaitGenerator::recover(const GaitInput& in) {
  out_.urgency = 0.0;
  off_plan_ = in.uneven ? off_plan(in).cwiseAbs().maxCoeff() : 0.0;
  if (pushed_ == 0.0) return;
  adjust_time(in);
  // Sideways the whole sole serves at once: the foot that could catch the robot there is seldom in time.
  const ZmpBounds whole = room(in, whole_, whole_[out_.support]);
  const Vec2 off = off_plan(in);
  const double share = out_.urgency = urgency(off);
  if (before_switch() && share >= kPushed && is_nearer_landed(in, off.x())) {
    lateral_.switch_now();
    alone_ = true;
  }
  const Vec2 shares(share, pushed_);
  out_.room.lower += shares.cwiseProduct(whole.lower - out_.room.lower);
  out_.room.upper += shares.cwiseProduct(whole.upper - out_.room.upper);
  // In a corner of the sole the ZMP would tip the foot. The axis along which the DCM is further off keeps its room.
  if (std::abs(off.x()) > std::abs(off.y())) {
    const double narrow = 1.0 - share * kNarrow;
    out_.room.lower.y() *= narrow;
    out_.room.upper.y() *= narrow;
    out_.zmp_lateral = std::clamp(out_.zmp_lateral, out_.room.lower.y(), out_.room.upper.y());
  }
  const double beside = std::abs(out_.zmp_lateral) / whole_[out_.support].upper.y();
  const double keep = 1.0 - share * settings_.zmp.corner_cut * smooth_step((beside - kSide) / (1.0 - kSide));
  out_.room.lower.x() *= keep;
  out_.room.upper.x() *= keep;
}

void GaitGenerator::adjust_time(const GaitInput& in) {
  if (out_.phase.phase != Phase::kSingleSupport || footsteps_.closing() || swing_ == Swing::kOverdue || retimed_)
    return;
  const double Tc = pendulum_.Tc(), left = schedule_.touch_down() - in.t;
  if (left < kDecided * Tc) return;
  const StepsSettings& steps = settings_.steps;
  StepLimits limits;
  limits.planned = planned_landing_ - in.t;
  limits.current = left;
  limits.least = std::max(steps.least_time - out_.phase.time, kDecided * Tc);
  limits.most = std::max(limits.planned + steps.wait_time, limits.least);
  limits.take_over = 0.5 * schedule_.times().T_ds;

  const Mat2 to_M = axes_of(out_.ahead_M).transpose();
  const ZmpBounds& whole = whole_[out_.support];
  const Vec2 xi = to_M * (in.com + Tc * in.dcom - out_.origin);
  const Vec2 foot = to_M * (in.p_sole[out_.swing].head<2>() - out_.origin), velocity = to_M * swing_velocity();
  const Vec2 drift(out_.v_plan.x(), 0.0);
  const Vec2 place = to_M * (out_.foothold.p - out_.origin) + (limits.planned - left) * drift;
  const double near = side_sign(out_.swing) * least_apart_, far = side_sign(out_.swing) * steps.aside_most;
  const double ahead_most = std::max(steps.ahead_most, std::abs(place.x()));
  const Vec2 lower(-ahead_most, std::min(near, far)), upper(ahead_most, std::max(near, far));
  const Vec2 offset(xi_start_, xi_offset_), give(steps.capture_distance, 0.0);
  const Vec2 acceleration = swing_acceleration();
  std::array<StepAxis, 2> axes;
  for (int i = 0; i < 2; ++i)
    axes[i] = {xi[i],    whole.lower[i], whole.upper[i], place[i],        drift[i],  lower[i],
               upper[i], foot[i],        velocity[i],    acceleration[i], offset[i], give[i]};
  const double best = adjustment_.time(pendulum_, axes, limits);
  if (std::abs(best - left) < kSame * Tc) return;
  const double taken_up = -std::expm1(-settings_.control.dt / (kTakenUp * Tc));
  schedule_.retime(in.t, left + taken_up * (best - left));
}

}  // namespace zmpwalk
