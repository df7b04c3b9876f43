#include "zmpwalk/walk/control_clock.hpp"

#include <cmath>
#include <string>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {
namespace {

/// Times are sums of time steps and carry rounding: a period counts as over when all but this share of it has gone by.
constexpr double kEarly = 1e-3;

/// Nobody walks on after this long without a new torque [s].
constexpr double kLongestGap = 0.5;

}  // namespace

void ControlClock::reset(double time) {
  start_ = last_ = next_ = time;
  started_ = true;
  cycles_ = 0;
}

void ControlClock::require_started() const {
  if (!started_) throw InputError("update was called before reset: reset reads the state in which the walk begins");
}

void ControlClock::require(double time) const {
  if (!std::isfinite(time)) throw InputError("the state's time is " + std::to_string(time) + "; it must be finite");
  if (time < last_)
    throw InputError("time has gone back from " + std::to_string(last_) + " s to " + std::to_string(time) +
                     " s; call reset to start a walk anew");
  if (time - last_ > kLongestGap)
    throw InputError("time has jumped from " + std::to_string(last_) + " s to " + std::to_string(time) +
                     " s; call update in every time step, and reset to start a walk anew");
}

bool ControlClock::due(double time) const { return time >= next_ - kEarly * control_dt_; }

void ControlClock::tick(double time) {
  last_ = time;
  ++cycles_;
  // The next period counts from when this one was due, so that rounding does not add up; after a gap it counts from now.
  next_ = time - next_ < control_dt_ ? next_ + control_dt_ : time + control_dt_;
}

}  // namespace zmpwalk
