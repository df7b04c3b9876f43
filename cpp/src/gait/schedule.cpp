#include "zmpwalk/gait/schedule.hpp"

#include <algorithm>
#include <cmath>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {
namespace {

constexpr double kTick = 1e-9;  // control times are sums of steps: a boundary counts as reached a nanosecond early

}  // namespace

double Cadence::pace(const Vec3& velocity) const {
  const double v = weight.cwiseProduct(velocity).norm();
  return v > speed ? speed / v : 1.0;
}

StepTimes Cadence::times(const Vec3& velocity) const {
  const double fast = pace(velocity);
  if (fast == 1.0) return slow;
  const double period = slow.period() * std::pow(fast, exponent);
  const double T_ds = period * slow.T_ds / slow.period() * std::pow(fast, double_exponent);
  return {T_ds, period - T_ds};
}

Schedule::Schedule(double T_ds_first, double T_ds, double T_ss)
    : lift_off_(T_ds_first), T_ds_before_(T_ds_first), times_{T_ds, T_ss} {
  require_positive("T_ds_first", T_ds_first);
  require_positive("T_ds", T_ds);
  require_positive("T_ss", T_ss);
}

void Schedule::begin(int n, double t, double T_ds_first, const StepTimes& times) {
  step_ = n;
  lift_off_ = t + T_ds_first;
  T_ds_before_ = T_ds_first;
  waited_ = 0.0;
  times_ = times;
}

bool Schedule::landed(double t) const { return t + kTick >= touch_down(); }

void Schedule::next(const StepTimes& times) {
  ++step_;
  T_ds_before_ = times_.T_ds;
  lift_off_ += times_.T_ss + times_.T_ds;
  waited_ = 0.0;
  times_ = times;
}

void Schedule::land(double t) {
  const double single = t - lift_off_;
  if (!(single > 0.0)) return;
  times_.T_ds += std::max(times_.T_ss - single, 0.0);
  times_.T_ss = single;
}

void Schedule::wait(double t) {
  const double later = t - touch_down();
  if (!(later > 0.0)) return;
  times_.T_ss = t - lift_off_;
  waited_ += later;
}

void Schedule::retime(double t, double remaining) {
  require_positive("remaining", remaining);
  const bool single = t + kTick >= lift_off_;
  const double later = t + remaining - (single ? touch_down() : lift_off_);
  if (std::abs(later) <= kTick) return;
  if (single) {
    times_.T_ss += later;
  } else {
    lift_off_ += later;
    T_ds_before_ += later;
  }
}

GaitPhase Schedule::at(double t) const {
  GaitPhase out;
  out.step = step_;
  if (t + kTick >= lift_off_) {
    out.phase = Phase::kSingleSupport;
    out.time = t - lift_off_;
    out.duration = times_.T_ss;
  } else {
    out.duration = T_ds_before_;
    out.time = t - (lift_off_ - T_ds_before_);
  }
  out.to_mid_single = lift_off_ + 0.5 * times_.T_ss - t;
  out.to_mid_double = lift_off_ + times_.T_ss + 0.5 * times_.T_ds - t;
  return out;
}

}  // namespace zmpwalk
