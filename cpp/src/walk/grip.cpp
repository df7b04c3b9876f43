#include "zmpwalk/walk/grip.hpp"

#include <algorithm>
#include <cmath>

namespace zmpwalk {
namespace {

constexpr double kSlow =
    0.02;  // speed of a corner that is no slip yet: soles that turn reach two thirds of it [sqrt(g z_c)]
constexpr double kWay = 0.004;  // way beyond that speed from which on a foot has slipped [z_c]
constexpr double kRocks = 1.0;  // a sole rocks whose corners move up and down this times as fast as along the ground
constexpr double kExplained =
    0.3;  // share of the believed friction that was asked, beyond which it explains that a foot moves
constexpr double kHolds = 0.8;   // share of what was asked that is believed to hold
constexpr double kLeast = 0.05;  // friction is never believed to be less
// Times in T_c.
constexpr double kFalls = 0.4;      // time constant with which it falls while the foot slips
constexpr double kRecovers = 36.0;  // and with which it recovers
constexpr double kNeeds = 0.3;      // friction with which a walk goes as it likes
constexpr double kSlowest = 0.3;    // least share of the planned speed

}  // namespace

Grip::Grip(const WalkSettings& settings, const SoleSize& sole, double z_c, double gravity, double friction)
    : on_(settings.limits.feel_slip),
      dt_(settings.control.dt),
      radius_(0.5 * std::hypot(sole.length, sole.width)),
      slow_(kSlow * std::sqrt(gravity * z_c)),
      way_(kWay * z_c),
      fall_(kFalls * std::sqrt(z_c / gravity)),
      recover_(kRecovers * std::sqrt(z_c / gravity)),
      start_(friction),
      friction_{friction, friction} {}

void Grip::reset() {
  friction_ = {start_, start_};
  slipped_ = {};
  pace_ = 1.0;
}

bool Grip::update(const GaitOutput& gait, const Dynamics& dynamics, const Vec12& f_c) {
  if (!on_) return false;
  const Side side = gait.support;
  const Vec6& v = dynamics.sole[side].velocity;
  const double speed = v.head<2>().norm() + radius_ * std::abs(v[5]);
  // A sole that rocks moves along the ground too; one that is known to slip may rock as it likes.
  const bool rocks = friction_[side] == start_ && radius_ * v.segment<2>(3).norm() > kRocks * speed;
  const Vec6 w = f_c.segment<6>(6 * side);
  const double asked = w.head<2>().norm() + std::abs(w[5]) / radius_;
  const bool explained = friction_[side] == start_ && asked > kExplained * start_ * std::abs(w[2]);
  if (speed > slow_ && !rocks && !explained)
    slipped_[side] += (speed - slow_) * dt_;
  else
    slipped_[side] = 0.0;
  slipped_[other(side)] = 0.0;
  const bool slips = slipped_[side] > way_;
  if (!slips && friction_[kLeft] == start_ && friction_[kRight] == start_) return false;
  for (const Side each : kSides) {
    double& mu = friction_[each];
    if (slips && each == side) {
      mu = std::min(mu, kHolds * w.head<2>().norm() / std::abs(w.z()));
      mu = std::max(mu * (1.0 - dt_ / fall_), kLeast);
    } else if (mu < start_) {
      mu += dt_ / recover_ * (start_ - mu);
      if (start_ - mu < 1e-3 * start_) mu = start_;
    }
  }
  pace_ = std::clamp(friction() / std::min(kNeeds, start_), kSlowest, 1.0);
  return true;
}

}  // namespace zmpwalk
