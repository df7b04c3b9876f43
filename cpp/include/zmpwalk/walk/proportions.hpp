#pragma once

#include "zmpwalk/control/limits.hpp"
#include "zmpwalk/gait/footsteps.hpp"
#include "zmpwalk/robot/robot.hpp"
#include "zmpwalk/settings/settings.hpp"
#include "zmpwalk/zmp/bounds.hpp"

namespace zmpwalk {

/// Height of the COM over the middle between both sole centres [m]; where the robot stands, it is z_c of (16).
double height_over_soles(const Dynamics& dynamics);

/// Lengths, times and data of the knee at the start pose of `robot`. The defaults of the settings scale with them.
RobotScale scale_of(const Robot& robot);

/// The one size that the gait takes both soles to have: the longer length and the narrower width of the two, and the larger ones of the feet
/// (`Robot::foot_reach`), which may stick out over their soles.
SoleSize common_sole(const Robot& robot);

/// Where the ZMP may be in the sole of `side`: what the share `sole_fraction` of it and the ankle's torque allow, see `zmp_bounds`.
/// @throws InputError where nothing is left
ZmpBounds bounds_of(const Robot& robot, Side side, const WalkSettings& settings, double sole_fraction);

/// What the torque of `robot` keeps to. @param settings resolved
RobotLimits limits_of(const Robot& robot, const WalkSettings& settings);

}  // namespace zmpwalk
