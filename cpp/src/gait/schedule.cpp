#include "zmpwalk/gait/schedule.hpp"

#include <algorithm>
#include <cmath>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

Schedule::Schedule(double T_ds_first, double T_ds, double T_ss) : T_ds_first_(T_ds_first), T_ds_(T_ds), T_ss_(T_ss) {
  require_positive("T_ds_first", T_ds_first);
  require_positive("T_ds", T_ds);
  require_positive("T_ss", T_ss);
}

GaitPhase Schedule::at(double t) const {
  constexpr double kTick = 1e-9;  // control times are sums of steps: a boundary counts as reached a nanosecond early
  GaitPhase out;
  const int landed = static_cast<int>(std::floor((t - T_ds_first_ - T_ss_ + kTick) / period())) + 1;
  out.step = std::max(landed, 0);
  const double lift = lift_off(out.step);
  if (t + kTick >= lift) {
    out.phase = Phase::kSingleSupport;
    out.time = t - lift;
    out.duration = T_ss_;
  } else {
    out.duration = out.step == 0 ? T_ds_first_ : T_ds_;
    out.time = t - (lift - out.duration);
  }
  out.to_mid_single = lift + 0.5 * T_ss_ - t;
  out.to_mid_double = lift + T_ss_ + 0.5 * T_ds_ - t;
  return out;
}

}  // namespace zmpwalk
