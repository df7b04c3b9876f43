#include "zmpwalk/gait/lateral_motion.hpp"

#include <algorithm>

namespace zmpwalk {

LateralMotion::LateralMotion(bool feedback, double reach) : feedback_(feedback), reach_(reach) {}

void LateralMotion::reset(Side support) {
  support_ = support;
  awaits_ = true;
  decided_ = false;
}

void LateralMotion::begin_cycle(bool double_support_began) {
  if (double_support_began) awaits_ = true;
  if (!decided_) return;
  support_ = other(support_);
  awaits_ = decided_ = false;
}

double LateralMotion::check_switch(const LinearInvertedPendulum& pendulum, const PendulumState& now, double r,
                                   double other_foot, double T, double dt, bool last) {
  const auto w_T_after = [&](int cycles) {
    PendulumState s = pendulum.step(cycles * dt, now, r);
    s.x -= other_foot;
    return pendulum.velocity_after(T - cycles * dt, s);
  };
  // Too early, the COM would turn back before the middle of the step: w(T) then points away from the foot to come. Of the two
  // cycles on either side of w(T) = 0 the nearer one is taken: always the later one would be half a cycle late on average.
  const double next = w_T_after(1);
  decided_ = last || side_sign(other(support_)) * (next + w_T_after(2)) >= 0.0;
  return next;
}

double LateralMotion::reference(const LinearInvertedPendulum& pendulum, const PendulumState& state, double width,
                                double time, double period) const {
  if (!feedback_ || awaits_ || !(time > 0.0)) return 0.0;
  const double xi_end = -side_sign(support_) * pendulum.orbit_dcm(width, period);
  return std::clamp(pendulum.reference_to_reach(pendulum.dcm(state), xi_end, time), -reach_, reach_);
}

}  // namespace zmpwalk
