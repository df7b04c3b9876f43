#include "zmpwalk/gait/lateral_motion.hpp"

#include <algorithm>

namespace zmpwalk {

LateralMotion::LateralMotion(LateralLawName law, double most) : law_(&LateralLaw::of(law)), most_(most) {}

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
                                   double other_foot, double T, double w_orbit, double dt, double time_left) {
  const auto off_orbit_after = [&](int cycles) {
    PendulumState s = pendulum.step(over_[cycles - 1](pendulum, cycles * dt), now, r);
    s.x -= other_foot;
    return pendulum.velocity_after(T - cycles * dt, s) - w_orbit;
  };
  const SwayToCome sway{off_orbit_after(1), off_orbit_after(2), side_sign(other(support_)), time_left};
  const bool last = time_left <= 1.5 * dt;
  switch_ = last || law_->switches(sway) ? Switch::kDecided : Switch::kDue;
  return sway.next + w_orbit;
}

double LateralMotion::wanted(const Sway& sway) const {
  return awaits_switch() || !(sway.growth.excess > 0.0) ? 0.0 : law_->reference(sway);
}

double LateralMotion::reference(const Sway& sway) const { return std::clamp(wanted(sway), -most_, most_); }

double LateralMotion::miss(const Sway& sway) const {
  const double r = wanted(sway);
  return (r - std::clamp(r, -most_, most_)) * sway.growth.excess;
}

}  // namespace zmpwalk
