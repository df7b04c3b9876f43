#include "zmpwalk/gait/footsteps.hpp"

#include <algorithm>
#include <cmath>

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/math/rotation.hpp"

namespace zmpwalk {
namespace {

/// `travel` (x, y, yaw) made from `from`.
Foothold moved(const Foothold& from, const Vec3& travel) {
  return {from.p + travel.x() * ahead_of(from.yaw) + travel.y() * left_of(from.yaw), from.yaw + travel.z()};
}

}  // namespace

Vec2 ahead_of(double yaw) { return {std::cos(yaw), std::sin(yaw)}; }
Vec2 left_of(double yaw) { return {-std::sin(yaw), std::cos(yaw)}; }

FootstepPlanner::FootstepPlanner(const WalkSettings& settings, const VelocityProfile& plan, const SoleSize& sole)
    : settings_(settings), plan_(&plan), sole_(sole) {}

void FootstepPlanner::reset(const std::array<Foothold, 2>& feet, double heading) {
  planned_ = feet;
  t_ = 0.0;
  path_.yaw = heading;
  nominal_ = target_ = Foothold{};
  restart(feet);
}

void FootstepPlanner::restart(const std::array<Foothold, 2>& feet) { path_.p = 0.5 * (feet[kLeft].p + feet[kRight].p); }

void FootstepPlanner::advance(double t, const Vec2& com) {
  path_ = moved(path_, plan_->travel(t_, t));
  t_ = t;
  if (settings_.steps.mode != Footsteps::kTied) return;
  const Vec2 ahead = ahead_of(path_.yaw);
  path_.p += ((com - path_.p).dot(ahead) - settings_.com.lead) * ahead;
}

double FootstepPlanner::lead(int n, double t_mid, double period) const {
  const std::vector<double>& lengths = settings_.steps.lengths;
  if (!lengths.empty()) return lengths[std::min<std::size_t>(n, lengths.size() - 1)];
  if (settings_.steps.mode == Footsteps::kAbsolute) return plan_->displacement(t_mid, t_mid + period).x();
  // Half of what the path does in either foot's stance.
  return 0.5 * plan_->displacement(t_mid - period, t_mid + period).x();
}

Foothold FootstepPlanner::planned(Side swing, double t_mid, double period) const {
  const Vec3 stance = plan_->travel(t_mid, t_mid + period);
  const Foothold middle = moved(moved(path_, plan_->travel(t_, t_mid)), 0.5 * stance);
  return moved(middle, {0.0, 0.5 * side_sign(swing) * width(stance.y()), 0.0});
}

Foothold FootstepPlanner::clear(Foothold place, Side swing, const Foothold& stance) const {
  const double turn = std::abs(wrap_angle(place.yaw - stance.yaw));
  // The stance sole's half width, and how far the corner of a sole turned by `turn` reaches.
  const double apart = 0.5 * (sole_.width + sole_.width * std::cos(turn) + sole_.length * std::sin(turn));
  const Vec2 left = left_of(stance.yaw);
  const double gap = side_sign(swing) * (place.p - stance.p).dot(left) - apart - settings_.steps.clearance;
  if (gap < 0.0) place.p -= side_sign(swing) * gap * left;
  return place;
}

Foothold FootstepPlanner::begin_step(int n, Side swing, const Foothold& stance, double t_mid, double period) {
  swing_ = swing;
  stance_ = stance;
  closing_ = false;
  const Foothold plan = planned(swing, t_mid, period);
  const Vec2 ahead = ahead_of(plan.yaw);
  nominal_ = plan;
  if (settings_.steps.mode != Footsteps::kAbsolute || !settings_.steps.lengths.empty()) {
    const Foothold& from = settings_.steps.mode == Footsteps::kAbsolute ? planned_[other(swing)] : stance;
    // Leads are between the middles of the walk that the feet belong to: beside each other, both have the same.
    const double half = 0.5 * side_sign(swing) * width(drift(t_mid, period));
    const Vec2 apart = moved(plan, {0.0, -half, 0.0}).p - moved(from, {0.0, half, 0.0}).p;
    nominal_.p += (lead(n, t_mid, period) - apart.dot(ahead)) * ahead;
  }
  nominal_ = clear(nominal_, swing, stance);
  planned_[swing] = nominal_;
  target_ = nominal_;
  return target_;
}

double FootstepPlanner::stretch(const Foothold& landed, Side side, const Foothold& lifting, double t_mid, double T_ds,
                                double sway) const {
  const Foothold middle = moved(path_, plan_->travel(t_, t_mid));
  const Vec2 over = landed.p - lifting.p, v_plan = plan_->velocity(t_mid).head<2>();
  const Vec2 moves =
      0.5 * T_ds * (v_plan.x() * ahead_of(middle.yaw) + v_plan.y() * left_of(middle.yaw) + sway * over.normalized());
  const auto from_hip = [&](const Foothold& foot, Side of, const Vec2& move) {
    return (foot.p - move - moved(middle, {0.0, 0.5 * side_sign(of) * settings_.steps.width, 0.0}).p).norm();
  };
  return std::max(from_hip(landed, side, -moves), from_hip(lifting, other(side), moves));
}

bool FootstepPlanner::close(Side swing, const Foothold& stance, double xi) {
  const Foothold beside = moved(stance, {0.0, side_sign(swing) * settings_.steps.width, 0.0});
  const double aside = (planned(swing, t_, 0.0).p - beside.p).dot(left_of(path_.yaw));
  const double missed = std::hypot(xi, aside);
  closing_ = missed <= settings_.gait.closing_distance &&
             std::abs(wrap_angle(path_.yaw - stance.yaw)) <= settings_.gait.closing_turn;
  if (closing_) nominal_ = target_ = beside;
  return closing_;
}

const Foothold& FootstepPlanner::update(double ahead_of_plan, double aside, double t_mid, double period, double share,
                                        double dt) {
  if (closing_ || settings_.steps.mode != Footsteps::kTied || share > settings_.steps.freeze) return target_;
  Foothold wanted = planned(swing_, t_mid, period);
  const Vec2 ahead = ahead_of(wanted.yaw), left = left_of(wanted.yaw);
  const double reach = settings_.steps.reach;
  const Vec2 off = wanted.p + ahead_of_plan * ahead_of(path_.yaw) - nominal_.p;
  wanted.p = nominal_.p + std::clamp(off.dot(ahead), -reach, reach) * ahead +
             (off.dot(left) + std::clamp(aside, -reach, reach)) * left;
  wanted = clear(wanted, swing_, stance_);
  const double blend = 1.0 - std::exp(-dt / settings_.steps.filter_time);
  target_.p += blend * (wanted.p - target_.p);
  target_.yaw += blend * wrap_angle(wanted.yaw - target_.yaw);
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
    const double L = lead(n, t, period);
    const double feet = 0.5 * (previous + L) / period;
    const double plan = plan_->displacement(t, t + period).x() / period;
    if (std::abs(feet - plan) > std::abs(worst)) worst = feet - plan;
    previous = L;
    t += period;
  }
}

}  // namespace zmpwalk
