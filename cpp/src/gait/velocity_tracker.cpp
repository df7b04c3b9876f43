#include "zmpwalk/gait/velocity_tracker.hpp"

#include <algorithm>
#include <cmath>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

VelocityTracker::VelocityTracker(TrackerLaw law, double gain, double time, double deadband, double catch_up_speed)
    : law_(law), gain_(gain), time_(time), deadband_(deadband), catch_up_speed_(catch_up_speed) {
  require_positive("tracker_gain", gain);
  require_positive("tracker_time", time);
  require_positive("tracker_deadband", deadband);
}

void VelocityTracker::reset() {
  integral_ = 0.0;
  drive_ = Drive::kNone;
}

double VelocityTracker::acceleration(double v_plan, double v, double ahead) const {
  return (v_plan + catch_up(ahead) - v) / time_;
}

double VelocityTracker::catch_up(double ahead) const {
  return std::clamp(-gain_ * (integral_ - ahead), -catch_up_speed_, catch_up_speed_);
}

void VelocityTracker::advance(double v_des, double v_plan, double dt) {
  const double before = integral_;
  integral_ += (v_des - v_plan) * dt;
  if (law_ == TrackerLaw::kSmooth) return;
  // III-C: "until the integrated value becomes zero". In discrete time it steps over zero; what is left stays in the integral.
  if (drive_ != Drive::kNone) {
    if (before * integral_ <= 0.0) drive_ = Drive::kNone;
  } else if (std::abs(integral_) > deadband_) {
    drive_ = integral_ < 0.0 ? Drive::kLower : Drive::kUpper;
  }
}

}  // namespace zmpwalk
