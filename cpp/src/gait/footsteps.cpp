#include "zmpwalk/gait/footsteps.hpp"

#include <algorithm>

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/math/rotation.hpp"

namespace zmpwalk {
namespace {

// Shares of the sole's length.
constexpr double kMargin = 0.03;  // that a sole keeps from edges of known ground
constexpr double kFar = 0.6;      // most by which a foothold is moved to a good place

}  // namespace

FootstepPlanner::FootstepPlanner(const WalkSettings& settings, const VelocityProfile& plan, const SoleSize& sole)
    : settings_(settings),
      plan_(&plan),
      sole_(sole),
      blend_(1.0 - std::exp(-settings.control.dt / settings.steps.filter_time)) {}

void FootstepPlanner::reset(const std::array<Foothold, 2>& feet, double heading) {
  planned_ = feet;
  now_ = plan_->at(0.0);
  path_ = PathPoint({Vec2::Zero(), heading});
  nominal_ = target_ = Foothold{};
  restart(feet);
}

void FootstepPlanner::restart(const std::array<Foothold, 2>& feet) { path_.p = 0.5 * (feet[kLeft].p + feet[kRight].p); }

void FootstepPlanner::advance(double t, const Vec2& com) {
  const VelocityProfile::Moment next = plan_->at(t);
  path_ = path_.moved(plan_->travel(now_, next));
  now_ = next;
  if (settings_.steps.mode != Footsteps::kTied) return;
  path_.p += ((com - path_.p).dot(path_.ahead) - settings_.com.lead) * path_.ahead;
}

PlannedStance FootstepPlanner::stance_at(double t_mid, double period) const {
  PlannedStance out{period, plan_->at(t_mid), plan_->at(t_mid + period), {}};
  out.path = path_.moved(plan_->travel(now_, out.mid));
  out.end.integral.x() += hurried_ * period;
  return out;
}

double FootstepPlanner::lead(int n, const PlannedStance& next) const {
  const std::vector<double>& lengths = settings_.steps.lengths;
  if (!lengths.empty()) return lengths[std::min<std::size_t>(n, lengths.size() - 1)];
  if (settings_.steps.mode == Footsteps::kAbsolute) return next.displacement().x();
  // Half of what the path does in either foot's stance.
  return 0.5 * (next.end.integral.x() - plan_->at(next.t_mid() - next.period).integral.x() + hurried_ * next.period);
}

PathPoint FootstepPlanner::planned(Side swing, const PlannedStance& next) const {
  const Vec3 stance = plan_->travel(next.mid, next.end);
  return next.path.moved(0.5 * stance).beside(0.5 * side_sign(swing) * width(stance.y()));
}

Vec2 FootstepPlanner::clear(const Foothold& place) const {
  const double turn = std::abs(wrap_angle(place.yaw - stance_.yaw));
  // The stance foot's half width, and how far the corner of a foot turned by `turn` reaches.
  const double apart =
      0.5 * (sole_.foot_width + sole_.foot_width * std::cos(turn) + sole_.foot_length * std::sin(turn));
  const Vec2 left = stance_.left();
  const double gap = side_sign(swing_) * (place.p - stance_.p).dot(left) - apart - settings_.steps.clearance;
  return gap < 0.0 ? Vec2(place.p - side_sign(swing_) * gap * left) : place.p;
}

Foothold FootstepPlanner::begin_step(int n, Side swing, const Foothold& stance, const PlannedStance& next,
                                     const SolePlace* place) {
  swing_ = swing;
  stance_ = PathPoint(stance);
  closing_ = false;
  const PathPoint plan = planned(swing, next);
  nominal_ = plan;
  if (settings_.steps.mode != Footsteps::kAbsolute || !settings_.steps.lengths.empty()) {
    const PathPoint from(settings_.steps.mode == Footsteps::kAbsolute ? planned_[other(swing)] : stance);
    // Leads are between the middles of the walk that the feet belong to: beside each other, both have the same.
    const double half = 0.5 * side_sign(swing) * width(next.drift());
    const Vec2 apart = plan.beside(-half).p - from.beside(half).p;
    nominal_.p += (lead(n, next) - apart.dot(plan.ahead)) * plan.ahead;
  }
  nominal_.p = clear(nominal_);
  if (ground_) {
    nominal_place_ = place_ = place ? *place : nearest(nominal_);
    if (place_.good) nominal_.p = place_.at.p;
  }
  planned_[swing] = nominal_;
  target_ = nominal_;
  return target_;
}

SolePlace FootstepPlanner::nearest(const Foothold& wanted, const SolePlace* like) const {
  return ground_->nearest(wanted, sole_, kMargin * sole_.length, kFar * sole_.length, like);
}

double FootstepPlanner::stretch(const Vec2& landed, Side side, const Vec2& lifting, const PlannedStance& at,
                                double T_ds, double sway) const {
  const Vec2 over = landed - lifting;
  const Vec2 moves =
      0.5 * T_ds * (at.mid.v.x() * at.path.ahead + at.mid.v.y() * at.path.left() + sway * over.normalized());
  const auto from_hip = [&](const Vec2& foot, Side of, const Vec2& move) {
    return (foot - move - at.path.beside(0.5 * side_sign(of) * settings_.steps.width).p).norm();
  };
  return std::max(from_hip(landed, side, -moves), from_hip(lifting, other(side), moves));
}

void FootstepPlanner::close(Side swing, const Foothold& stance, double xi) {
  const PathPoint beside = PathPoint(stance).beside(side_sign(swing) * settings_.steps.width);
  const double aside = (planned(swing, stance_at(now_.t, 0.0)).p - beside.p).dot(path_.left());
  const double missed = std::hypot(xi, aside);
  closing_ = missed <= settings_.gait.closing_distance &&
             std::abs(wrap_angle(path_.yaw - stance.yaw)) <= settings_.gait.closing_turn;
  if (closing_ && ground_) {
    const SolePlace there = ground_->under(beside, sole_, 0.0);
    closing_ = there.good;
    if (closing_) nominal_place_ = place_ = there;
  }
  if (closing_) nominal_ = target_ = beside;
}

Vec2 FootstepPlanner::off_nominal(double ahead_of_plan, double aside, const PathPoint& planned) const {
  const Vec2 off = planned.p + ahead_of_plan * planned.ahead - nominal_.p;
  return {off.dot(planned.ahead), off.dot(planned.left()) + aside};
}

const Foothold& FootstepPlanner::follow(const Vec2& off, const PathPoint& planned, const LandingRoom* ahead,
                                        const LandingRoom* beside) {
  const Vec2 left = planned.left();
  Foothold wanted = planned;
  wanted.p = nominal_.p + off.x() * planned.ahead + off.y() * left;
  // Within reach of the leg, and of the time that is left; where the plan goes, and where the foot goes already, it may go on.
  const auto within = [&](const Vec2& axis, const Vec2& foot, double reach, double far) {
    const double planned_there = (nominal_.p - stance_.p).dot(axis), now = (target_.p - stance_.p).dot(axis);
    const double by_itself = (foot - stance_.p).dot(axis), there = (wanted.p - stance_.p).dot(axis);
    const double lower =
        std::max(std::min(-reach, kLonger * planned_there), std::min({by_itself - far, now, planned_there}));
    const double upper =
        std::min(std::max(reach, kLonger * planned_there), std::max({by_itself + far, now, planned_there}));
    wanted.p += (std::max(std::min(there, upper), lower) - there) * axis;
  };
  if (ahead) within(planned.ahead, ahead->foot, settings_.steps.ahead_most, ahead->way.x());
  if (beside) within(left, beside->foot, settings_.steps.aside_most, beside->way.y());
  wanted.p = clear(wanted);
  if (ground_ && nominal_place_.good) {
    const SolePlace near = nearest(wanted, &nominal_place_);
    wanted.p = near.good ? near.at.p : nominal_.p;
  }
  target_.p += blend_ * (wanted.p - target_.p);
  target_.yaw += blend_ * wrap_angle(wanted.yaw - target_.yaw);
  if (ground_) place_ = ground_->under(target_, sole_, 0.0);
  return target_;
}

double FootstepPlanner::mismatch(double duration, const Cadence& cadence) const {
  if (settings_.steps.lengths.empty() || settings_.steps.mode == Footsteps::kTied) return 0.0;
  require_positive("duration", duration);
  const double slow = cadence.slow.period();
  double worst = 0.0, previous = 0.0, t = 0.0;
  for (int n = 0;; ++n) {
    const double period = cadence.times(plan_->displacement(t, t + slow) / slow).period();
    if (t + period > duration + 1e-9) return worst;
    // A step moves the middle of the feet by half of the leads before and after it. The plan's periods start at 0.
    const PlannedStance stance = stance_at(t, period);
    const double L = lead(n, stance);
    const double feet = 0.5 * (previous + L) / period;
    const double plan = stance.displacement().x() / period;
    if (std::abs(feet - plan) > std::abs(worst)) worst = feet - plan;
    previous = L;
    t += period;
  }
}

}  // namespace zmpwalk
