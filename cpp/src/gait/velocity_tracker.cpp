#include "zmpwalk/gait/velocity_tracker.hpp"

#include <algorithm>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

VelocityTracker::VelocityTracker(const TrackingSettings& settings)
    : settings_(settings), law_(&TrackerLaw::of(settings.law)) {
  require_positive("tracker_gain", settings.gain);
  require_positive("tracker_time", settings.time);
  require_positive("tracker_deadband", settings.deadband);
}

void VelocityTracker::reset() {
  integral_ = 0.0;
  drive_ = Drive::kNone;
}

double VelocityTracker::acceleration(double v_plan, double v, double ahead) const {
  return law_->acceleration({settings_, v_plan, v, catch_up(ahead)});
}

double VelocityTracker::catch_up(double ahead) const {
  return std::clamp(-settings_.gain * (integral_ - ahead), -settings_.catch_up_speed, settings_.catch_up_speed);
}

void VelocityTracker::advance(double v_des, double v_plan, double dt) {
  const double before = integral_;
  integral_ += (v_des - v_plan) * dt;
  drive_ = law_->drive({settings_, before, integral_, drive_});
}

}  // namespace zmpwalk
