#pragma once

#include <mujoco/mujoco.h>

#include "zmpwalk/robot/rules/model_rules.hpp"

namespace zmpwalk {

class Robot;

/// What is wrong with a robot's start pose: soles that are not level and on the ground, legs that cannot move their soles in every
/// direction, couplings of the model that do not hold there.
///
/// @param d  the start pose, which `robot` has read, after mj_tendon
Reasons stand_reasons(const Robot& robot, const mjData* d);

}  // namespace zmpwalk
