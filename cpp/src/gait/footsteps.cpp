#include "zmpwalk/gait/footsteps.hpp"

#include <algorithm>
#include <cmath>

namespace zmpwalk {
namespace {

Vec2 direction(double yaw) { return {std::cos(yaw), std::sin(yaw)}; }
Vec2 leftward(double yaw) { return {-std::sin(yaw), std::cos(yaw)}; }

}  // namespace

FootstepPlanner::FootstepPlanner(const WalkSettings& settings, const VelocityProfile& profile)
    : settings_(settings), profile_(&profile) {}

void FootstepPlanner::reset(const std::array<Foothold, 2>& feet, double heading) {
  planned_ = feet;
  heading_ = heading;
  origin_ = 0.5 * (feet[kLeft].p + feet[kRight].p);
  nominal_ = target_ = Foothold{};
}

double FootstepPlanner::lead(int n, double t_mid, double period) const {
  const std::vector<double>& lengths = settings_.step_lengths;
  if (!lengths.empty()) return lengths[std::min<std::size_t>(n, lengths.size() - 1)];
  return profile_->displacement(t_mid, t_mid + period).x();
}

Foothold FootstepPlanner::begin_step(int n, Side swing, const Foothold& stance, double t_mid, double period) {
  const Vec2 ahead = direction(heading_), left = leftward(heading_);
  const double L = lead(n, t_mid, period);
  const Foothold& from = settings_.footsteps == Footsteps::kAbsolute ? planned_[other(swing)] : stance;
  nominal_ = {from.p + L * ahead + side_sign(swing) * settings_.step_width * left, heading_};
  if (settings_.footsteps == Footsteps::kAbsolute && settings_.step_lengths.empty()) {
    // Plan the COM from the start, and put the foot half a lead ahead of where the plan has it in mid double support.
    const double x = profile_->displacement(0.0, t_mid).x() + 0.5 * L;
    nominal_.p += (x - (nominal_.p - origin_).dot(ahead)) * ahead;
  }
  planned_[swing] = nominal_;
  target_ = nominal_;
  return target_;
}

const Foothold& FootstepPlanner::update(const Vec2& com, const Vec2& dcom, double t, double t_mid, double period,
                                        double Tc, double share, double dt) {
  if (settings_.footsteps != Footsteps::kTied || share > settings_.foothold_freeze) return target_;
  const Vec2 ahead = direction(heading_);
  const double v_plan = profile_->velocity(t).x();
  const double L = lead(0, t_mid, period);
  const double x_T = com.dot(ahead) + profile_->displacement(t, t_mid).x() + Tc * (dcom.dot(ahead) - v_plan) + 0.5 * L -
                     settings_.com_lead;
  const double reach = settings_.foothold_reach;
  const double wanted = std::clamp(x_T - nominal_.p.dot(ahead), -reach, reach);
  const double now = (target_.p - nominal_.p).dot(ahead);
  const double blend = 1.0 - std::exp(-dt / settings_.foothold_time);
  target_.p += blend * (wanted - now) * ahead;
  return target_;
}

double FootstepPlanner::mismatch(int steps, double period) const {
  if (settings_.step_lengths.empty() || settings_.footsteps == Footsteps::kTied) return 0.0;
  double worst = 0.0, previous = 0.0;
  for (int n = 0; n < steps; ++n) {
    // A step moves the middle of the feet by half of the leads before and after it. The plan's periods start at 0.
    const double L = lead(n, 0.0, period);
    const double feet = 0.5 * (previous + L) / period;
    const double plan = profile_->displacement(n * period, (n + 1) * period).x() / period;
    if (std::abs(feet - plan) > std::abs(worst)) worst = feet - plan;
    previous = L;
  }
  return worst;
}

}  // namespace zmpwalk
