#include "zmpwalk/walk/fall_prediction.hpp"

#include <algorithm>
#include <cmath>

namespace zmpwalk {
namespace {

constexpr double kCosSpun = -0.75;  // a foot that has turned by 2.4 rad while it stood alone has lost its grip

constexpr double kLands = 0.36;  // a foot that is to land within this catches one that tips [T_c]

double angle(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); }

Interval hull(const Interval& a, const Interval& b) { return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)}; }

}  // namespace

FallPrediction::FallPrediction(const WalkSettings& settings, const SoleSize& sole,
                               const std::array<ZmpBounds, 2>& bounds)
    : on_(settings.fall.foresee),
      steps_(settings.steps.timing && settings.steps.mode == Footsteps::kTied),
      margin_(settings.fall.margin),
      confirm_time_(settings.fall.confirm_time),
      cos_foot_tilt_(std::cos(settings.fall.foot_tilt)),
      dt_(settings.control.dt),
      wait_time_(settings.steps.wait_time),
      bounds_(bounds),
      region_({settings.steps.ahead_most, settings.steps.aside_most, sole.foot_width + settings.steps.clearance,
               settings.steps.least_time},
              0.5 * Vec2(sole.length, sole.width)) {}

void FallPrediction::reset(const std::array<Mat3, 2>& R_sole) {
  for (const Side side : kSides) up_[side] = R_sole[side].col(2);
  gap_ = kNaN;
  cos_tip_ = cos_turn_ = 1.0;
  lost_ = tipped_ = spun_ = 0.0;
  alone_ = false;
  fall_ = ForeseenFall{};
}

const ForeseenFall& FallPrediction::update(double t, const GaitGenerator& gait, const GaitInput& in,
                                           const LinearInvertedPendulum& pendulum) {
  if (!on_) return fall_;
  Tc_ = pendulum.Tc();
  region_.set_pendulum(pendulum);
  gap_ = gap_of(gait, in);
  watch_foot(gait.output(), in, gait.schedule().touch_down());
  if (fall_) return fall_;
  const auto holds = [&](bool now, double& since) {
    since = now ? since + dt_ : 0.0;
    return since > confirm_time_;
  };
  const bool lost = holds(gap_ > margin_, lost_), tipped = holds(cos_tip_ < cos_foot_tilt_, tipped_),
             spun = holds(cos_turn_ < kCosSpun, spun_);
  if (lost || tipped || spun)
    fall_ = {lost     ? Fall::kLost
             : tipped ? Fall::kFootTipped
                      : Fall::kFootSpun,
             t, gap_, angle(cos_turn_), angle(cos_tip_)};
  return fall_;
}

void FallPrediction::watch_foot(const GaitOutput& gait, const GaitInput& in, double touch_down) {
  const bool alone = gait.phase.phase == Phase::kSingleSupport;
  // Where the ground goes down, the sole turns over the edge until the other foot lands.
  const bool lands = touch_down - in.t < kLands * Tc_;
  const Mat3& R = in.R_sole[gait.support];
  if (alone && (!alone_ || gait.support != support_)) forward_ = R.topLeftCorner<2, 1>();
  alone_ = alone;
  support_ = gait.support;
  cos_tip_ = alone && !lands ? R.col(2).dot(up_[gait.support]) : 1.0;
  cos_turn_ = alone ? forward_.dot(R.topLeftCorner<2, 1>()) : 1.0;
}

std::array<Interval, 2> FallPrediction::room(const GaitInput& in, Side side, const Vec2& ahead,
                                             const Vec2& origin) const {
  // The box around the turned rectangle.
  const Vec2 from = in.p_sole[side].head<2>() - origin, forward = in.R_sole[side].topLeftCorner<2, 1>();
  const ZmpBounds& b = bounds_[side];
  const double c = forward.dot(ahead), s = forward.dot(left_of(ahead));
  const double x = from.dot(ahead), y = from.dot(left_of(ahead));
  const auto along = [](double middle, double a, const Vec2& u, double d, const Vec2& v) {
    return Interval{middle + std::min(a * u.x(), a * u.y()) + std::min(d * v.x(), d * v.y()),
                    middle + std::max(a * u.x(), a * u.y()) + std::max(d * v.x(), d * v.y())};
  };
  const Vec2 long_side(b.lower.x(), b.upper.x()), wide_side(b.lower.y(), b.upper.y());
  return {along(x, c, long_side, -s, wide_side), along(y, s, long_side, c, wide_side)};
}

double FallPrediction::gap_of(const GaitGenerator& gait, const GaitInput& in) const {
  const GaitOutput& out = gait.output();
  if (!out.at_rest) return step_gap(gait, in, other(out.swing));
  const double stands = stand_gap(in, out.ahead, in.com + Tc_ * in.dcom);
  if (!steps_ || stands == 0.0) return stands;
  return std::min({stands, step_gap(gait, in, kLeft), step_gap(gait, in, kRight)});
}

double FallPrediction::stand_gap(const GaitInput& in, const Vec2& ahead, const Vec2& xi) const {
  const auto left = room(in, kLeft, ahead, xi), right = room(in, kRight, ahead, xi);
  return std::hypot(hull(left[0], right[0]).outside(0.0), hull(left[1], right[1]).outside(0.0));
}

double FallPrediction::step_gap(const GaitGenerator& gait, const GaitInput& in, Side stance) const {
  const GaitOutput& out = gait.output();
  const Side swing = other(stance);
  const double side = side_sign(swing);
  const Vec2 origin = in.p_sole[stance].head<2>(), left = left_of(out.ahead);
  const Vec2 xi = in.com + Tc_ * in.dcom - origin;
  const std::array<Interval, 2> alone = room(in, stance, out.ahead, origin);
  std::array<Interval, 2> both = alone;
  const bool single = out.phase.phase == Phase::kSingleSupport;
  if (!single) {
    const std::array<Interval, 2> there = room(in, swing, out.ahead, origin);
    for (int i = 0; i < 2; ++i) both[i] = hull(alone[i], there[i]);
  }
  // The leg can do what the gait plans, and a little more.
  const StepReach& reach = region_.reach();
  const Vec2 plan = single ? Vec2(FootstepPlanner::kLonger * (out.foothold.p - origin)) : Vec2::Zero();
  const double ahead = std::max(reach.ahead, std::abs(plan.dot(out.ahead)));
  const double aside = std::max(reach.aside, side * plan.dot(left)), near = std::min(reach.near, aside);
  const Interval across = region_.hold()[1];
  const std::array<CatchAxis, 2> axes{
      CatchAxis{xi.dot(out.ahead), both[0], alone[0], {-ahead, ahead}, region_.hold()[0]},
      side > 0.0 ? CatchAxis{xi.dot(left), both[1], alone[1], {near, aside}, across}
                 : CatchAxis{xi.dot(left), both[1], alone[1], {-aside, -near}, {-across.upper, -across.lower}}};

  CatchTimes times;
  const StepTimes& step = gait.schedule().times();
  const double since = single ? out.phase.time : 0.0;
  times.both = single || out.at_rest ? 0.0 : std::max(out.phase.duration - out.phase.time, 0.0);
  times.planned = single ? std::max(gait.schedule().touch_down() - in.t, 0.0) : step.T_ss;
  times.least = times.most = times.planned;
  if (steps_) {
    times.least = std::clamp(reach.least_time - since, 0.0, times.planned);
    times.most += wait_time_;
  }
  return region_.gap(axes, times);
}

}  // namespace zmpwalk
