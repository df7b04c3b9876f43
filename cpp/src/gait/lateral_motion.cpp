#include "zmpwalk/gait/lateral_motion.hpp"

#include <algorithm>

namespace zmpwalk {

LateralMotion::LateralMotion(bool feedback, double most) : feedback_(feedback), most_(most) {}

void LateralMotion::reset(Side support) {
  support_ = support;
  switch_ = Switch::kDue;
}

void LateralMotion::begin_cycle(bool double_support_began) {
  if (switch_ == Switch::kDecided) take_switch();
  if (double_support_began) switch_ = Switch::kDue;
}

void LateralMotion::end_double_support() {
  if (awaits_switch()) take_switch();
}

void LateralMotion::take_switch() {
  support_ = other(support_);
  switch_ = Switch::kTaken;
}

double LateralMotion::check_switch(const LinearInvertedPendulum& pendulum, const PendulumState& now, double r,
                                   double other_foot, double T, double w_orbit, double dt, bool last) {
  const auto off_orbit_after = [&](int cycles) {
    PendulumState s = pendulum.step(over_[cycles - 1](pendulum, cycles * dt), now, r);
    s.x -= other_foot;
    return pendulum.velocity_after(T - cycles * dt, s) - w_orbit;
  };
  // Too early, the COM would turn back before the middle of the step: w(T) then points away from the foot to come. Of the two
  // cycles on either side of w(T) = 0 the nearer one is taken: always the later one would be half a cycle late on average.
  const double next = off_orbit_after(1);
  const bool decided = last || side_sign(other(support_)) * (next + off_orbit_after(2)) >= 0.0;
  switch_ = decided ? Switch::kDecided : Switch::kDue;
  return next + w_orbit;
}

double LateralMotion::reference(const LinearInvertedPendulum& pendulum, double xi, double xi_end,
                                const LinearInvertedPendulum::Growth& time) const {
  if (!feedback_ || awaits_switch() || !(time.excess > 0.0)) return 0.0;
  return std::clamp(pendulum.reference_to_reach(xi, xi_end, time), -most_, most_);
}

double LateralMotion::miss(const LinearInvertedPendulum& pendulum, double xi, double xi_end,
                           const LinearInvertedPendulum::Growth& time) const {
  if (!feedback_ || awaits_switch() || !(time.excess > 0.0)) return 0.0;
  const double r = pendulum.reference_to_reach(xi, xi_end, time);
  return (std::clamp(r, -most_, most_) - r) * -time.excess;
}

}  // namespace zmpwalk
