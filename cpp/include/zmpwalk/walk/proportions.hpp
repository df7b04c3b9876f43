#pragma once

#include "zmpwalk/gait/footsteps.hpp"
#include "zmpwalk/robot/robot.hpp"
#include "zmpwalk/settings/settings.hpp"
#include "zmpwalk/zmp/bounds.hpp"

namespace zmpwalk {

/// Height of the COM over the middle of both sole centres [m]: z_c of (16) where the robot stands.
double height_over_soles(const Dynamics& dynamics);

/// The lengths, times and knee data that default settings scale with, for `robot` at its start pose.
RobotScale scale_of(const Robot& robot);

/// The sole that both feet stand for where feet must keep clear of each other: the longer length, the narrower width.
SoleSize common_sole(const RobotDescription& description);

/// Where the ZMP may be in the sole of `side`: what the share `sole_fraction` of it and the ankle's torque allow, see `zmp_bounds`.
/// @throws InputError where nothing is left
ZmpBounds bounds_of(const Robot& robot, Side side, const WalkSettings& settings, double sole_fraction);

}  // namespace zmpwalk
