#pragma once

#include <vector>

#include "zmpwalk/gait/gait_generator.hpp"
#include "zmpwalk/zmp/bounds.hpp"

namespace zmpwalk {

/// A walk that is computed ahead of time: what gait and pendulum do for a robot that follows them exactly. W, SI units.
struct WalkPlan {
  struct Step {
    Side foot = kLeft;
    double lift_off = 0.0, touch_down = 0.0;  ///< [s]
    Foothold place;                           ///< where it lands
  };
  std::vector<double> t;             ///< since the walk begins [s]
  std::vector<Vec2> com, dcom, zmp;  ///< at each t [m, m/s, m]; the ZMP stays there until the next t
  std::vector<int> support;          ///< foot that carries the ZMP: +1 left, -1 right
  std::vector<Step> steps;           ///< steps that land within the plan
};

/// Computes a plan: it runs gait, velocity tracker and pendulum (16), (17) over `duration` [s] in steps of settings.control.dt.
///
/// Along the heading the smooth tracker chooses the ZMP, and sideways the lateral motion with feedback, both inside the bounds. This is so whatever
/// law the settings name, for without a robot nothing in the paper's law keeps COM and feet together.
/// @param settings resolved   @param bounds of the ZMP in each sole, in its axes   @param start two standing feet
/// @throws InputError  the duration is not finite and > 0
WalkPlan plan_walk(const WalkSettings& settings, const VelocityProfile& profile, const LinearInvertedPendulum& pendulum,
                   const std::array<ZmpBounds, 2>& bounds, const SoleSize& sole, const GaitInput& start,
                   double duration);

}  // namespace zmpwalk
