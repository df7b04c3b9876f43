#pragma once

#include <mujoco/mujoco.h>

#include "zmpwalk/robot/rules/model_rules.hpp"

namespace zmpwalk {

class Robot;

/// What is wrong with a robot's start pose: a sole is not level or not on the ground, a leg cannot move its sole in every direction, or a coupling
/// of the model does not hold there.
///
/// @param d  the start pose, which `robot` has read, after mj_tendon
Reasons stand_reasons(const Robot& robot, const mjData* d);

}  // namespace zmpwalk
