#include "zmpwalk/walk/grip.hpp"

#include <algorithm>
#include <cmath>

namespace zmpwalk {
namespace {

constexpr double kSlow = 0.02;      // speed that is no slip yet; soles that turn reach two thirds of it [sqrt(g z_c)]
constexpr double kWay = 0.004;      // way beyond that speed from which on a foot has slipped [z_c]
constexpr double kCarries = 0.2;    // share of the weight from which on a foot counts as carrying
constexpr double kExplained = 0.5;  // share of the believed friction; a sole that moves under more has met its limit
constexpr double kHolds = 0.65;     // share of what was asked while a sole slid, that is believed to hold
constexpr double kLeast = 0.05;     // friction is never believed to be less
constexpr double kRecovers = 36.0;  // time constant with which it recovers [T_c]
constexpr double kNeeds = 0.3;      // friction with which a walk goes as it likes
constexpr double kSlowest = 0.3;    // least share of the planned speed

}  // namespace

Grip::Grip(const WalkSettings& settings, const SoleSize& sole, double z_c, double gravity, double friction)
    : on_(settings.limits.feel_slip),
      dt_(settings.control.dt),
      ahead_(0.5 * sole.length),
      aside_(0.5 * sole.width),
      slow_(kSlow * std::sqrt(gravity * z_c)),
      way_(kWay * z_c),
      recover_(kRecovers * std::sqrt(z_c / gravity)),
      start_(friction),
      friction_{friction, friction} {}

void Grip::reset() {
  friction_ = {start_, start_};
  slipped_ = asked_ = {};
  pace_ = 1.0;
}

bool Grip::update(const GaitOutput& gait, const Dynamics& dynamics, const Vec12& f_c) {
  if (!on_) return false;
  const Side side = gait.support;
  const Vec6 w = f_c.segment<6>(6 * side);
  const bool carries = -w[2] > kCarries * dynamics.mass * dynamics.gravity.norm();
  // Where the force acts: a sole that turns about that point, by its yaw moment or over an edge, does not slip.
  const Vec2 at = carries ? Vec2(std::clamp(-w[4] / w[2], -ahead_, ahead_), std::clamp(w[3] / w[2], -aside_, aside_))
                          : Vec2::Zero();
  const Vec6& v = dynamics.sole[side].velocity;
  const double speed = (v.head<2>() + v[5] * left_of(at)).norm();
  const double twist = std::abs(w[5] - at.x() * w[1] + at.y() * w[0]) / std::hypot(ahead_, aside_);
  const double holds = (w.head<2>().norm() + twist) / std::abs(w[2]);
  const bool explained = friction_[side] == start_ && holds > kExplained * start_;
  // What was asked while it slid is more than friction holds.
  if (carries && speed > slow_ && !explained) {
    slipped_[side] += (speed - slow_) * dt_;
    asked_[side] = std::max(asked_[side], holds);
  } else {
    slipped_[side] = asked_[side] = 0.0;
  }
  slipped_[other(side)] = asked_[other(side)] = 0.0;
  const bool slips = slipped_[side] > way_;
  if (!slips && friction_[kLeft] == start_ && friction_[kRight] == start_) return false;
  for (const Side each : kSides) {
    double& mu = friction_[each];
    if (slips && each == side) {
      mu = std::max(std::min(mu, kHolds * asked_[side]), kLeast);
    } else if (mu < start_) {
      mu += dt_ / recover_ * (start_ - mu);
      if (start_ - mu < 1e-3 * start_) mu = start_;
    }
  }
  pace_ = std::clamp(friction() / std::min(kNeeds, start_), kSlowest, 1.0);
  return true;
}

}  // namespace zmpwalk
