#pragma once

#include <vector>

#include "zmpwalk/gait/gait_generator.hpp"
#include "zmpwalk/gait/velocity_tracker.hpp"
#include "zmpwalk/zmp/bounds.hpp"

namespace zmpwalk {

/// A walk ahead of time: what gait and pendulum do for a robot that does as it is told. W, SI.
struct WalkPlan {
  struct Step {
    Side foot = kLeft;
    double lift_off = 0.0, touch_down = 0.0;  ///< [s]
    Foothold place;                           ///< where it lands
  };
  std::vector<double> t;             ///< since the walk begins [s]
  std::vector<Vec2> com, dcom, zmp;  ///< at each t; the ZMP stands until the next t
  std::vector<int> support;          ///< +1 left, -1 right
  std::vector<Step> steps;           ///< those that land within the plan
};

/// Rolls gait, velocity tracker and pendulum (16), (17) forward over `duration` [s] in steps of settings.control.dt.
///
/// The ZMP along x is what the smooth tracker asks of the pendulum, along y what the lateral motion with feedback asks, both
/// inside the bounds, whatever the law: the literal one has nothing that keeps COM and feet together without the robot.
/// @param settings resolved   @param bounds of each sole, in its axes   @param start two standing feet
/// @throws InputError  duration not finite and > 0
WalkPlan plan_walk(const WalkSettings& settings, const VelocityProfile& profile, const LinearInvertedPendulum& pendulum,
                   const std::array<ZmpBounds, 2>& bounds, const SoleSize& sole, const GaitInput& start,
                   double duration);

}  // namespace zmpwalk
