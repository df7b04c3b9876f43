#include "zmpwalk/walk/com_height.hpp"

#include <algorithm>
#include <cmath>

namespace zmpwalk {

ComHeight::ComHeight(double z_c, double gravity, const WalkSettings& settings)
    : free_gravity_(gravity),
      gravity_(gravity),
      dt_(settings.control.dt),
      rate_(1.0 / settings.com.crouch_time),
      z_c_(z_c),
      pendulum_(z_c, gravity) {}

void ComHeight::reset(double z_c, double ground) {
  z_c_ = z_c;
  ground_ = ground;
  crouch_ = dcrouch_ = ddcrouch_ = 0.0;
  gravity_ = free_gravity_;
  pendulum_ = LinearInvertedPendulum(z_c_, gravity_);
}

bool ComHeight::weigh(double gravity) {
  if (gravity == gravity_) return false;
  gravity_ = gravity;
  pendulum_ = LinearInvertedPendulum(z_c_ - crouch_, gravity_);
  return true;
}

bool ComHeight::update(double t, double stretch, const VelocityProfile& plan, const LegReach& reach, double ahead,
                       double lift) {
  const double wanted = reach.crouch_for(
      std::max({reach.stride(plan.velocity(t)), reach.stride(plan.velocity(t + ahead)), stretch}), lift);
  if (wanted == 0.0 && crouch_ == 0.0) return false;
  ddcrouch_ = rate_ * (rate_ * (wanted - crouch_) - 2.0 * dcrouch_);
  crouch_ += dcrouch_ * dt_;
  dcrouch_ += ddcrouch_ * dt_;
  if (wanted == 0.0 && std::abs(crouch_) < 1e-6 && std::abs(dcrouch_) < 1e-6) crouch_ = dcrouch_ = ddcrouch_ = 0.0;
  pendulum_ = LinearInvertedPendulum(z_c_ - crouch_, gravity_);
  return true;
}

}  // namespace zmpwalk
