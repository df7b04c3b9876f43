#include "zmpwalk/gait/plan.hpp"

#include <algorithm>
#include <cmath>

#include "zmpwalk/gait/point_walk.hpp"
#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

WalkPlan plan_walk(const WalkSettings& given, const VelocityProfile& profile, const LinearInvertedPendulum& pendulum,
                   const std::array<ZmpBounds, 2>& bounds, const SoleSize& sole, const GaitInput& start,
                   double duration) {
  require_positive("duration", duration);
  constexpr double kMostRows = 1e7, kLongest = 0.1;  // a longer time step goes over a double support [s]
  const double dt = given.control.dt;
  require_positive("dt", dt);
  if (!(duration / dt <= kMostRows))
    throw InputError(
        "a plan over this duration, at this time step, has more than ten million rows: choose a shorter "
        "duration or a longer time step");
  if (dt > kLongest)
    throw InputError("dt is " + std::to_string(dt) + " s; a plan takes time steps of at most " +
                     std::to_string(kLongest) + " s");
  const auto count = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(duration / dt - 1e-9)));
  WalkPlan plan;
  plan.t.reserve(count);
  plan.com.reserve(count);
  plan.dcom.reserve(count);
  plan.zmp.reserve(count);
  plan.support.reserve(count);
  WalkSettings settings = given;
  settings.zmp.lateral_law = chosen<LateralLawName>("zmp.lateral_law", "orbit");
  PointWalk walk(settings, profile, pendulum, bounds, sole, start);
  bool swinging = false;
  for (std::size_t k = 0; k < count; ++k) {
    const double t = walk.in.t = static_cast<double>(k) * dt;
    plan.t.push_back(t);
    plan.com.push_back(walk.in.com);
    plan.dcom.push_back(walk.in.dcom);
    const GaitOutput& now = walk.step(PointWalk::Feet::kAtOnce);
    plan.zmp.push_back(walk.zmp);
    plan.support.push_back(static_cast<int>(side_sign(now.support)));
    const bool single = now.phase.phase == Phase::kSingleSupport;
    if (single && !swinging) plan.steps.push_back({now.swing, t, t + now.phase.duration, {}});
    if (single) plan.steps.back().place = now.foothold;
    swinging = single;
  }
  if (!plan.steps.empty() && plan.steps.back().touch_down > duration) plan.steps.pop_back();
  return plan;
}

}  // namespace zmpwalk
