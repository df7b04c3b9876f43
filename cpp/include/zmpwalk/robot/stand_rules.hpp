#pragma once

#include <mujoco/mujoco.h>

#include <string>

#include "zmpwalk/robot/model_rules.hpp"

namespace zmpwalk {

class Robot;

/// Directions of a leg's six joint axes, hip to ankle: columns (3, 6) of unit vectors.
using LegAxes = Eigen::Matrix<double, 3, 6>;

/// Adds a leg whose fourth joint does not bend a knee, whose hip cannot pitch, or whose last two joints cannot pitch and roll the foot:
/// footholds, crouch and bounds of the ZMP take six joints as hip 3, knee 1, ankle 2. All directions in one frame, unit vectors.
///
/// @param leg  how the sentence calls it: "the left leg (l_hip_yaw, ...)"
void add_leg_axes(const std::string& leg, const LegAxes& axes, const Vec3& forward, const Vec3& left, Reasons& out);

/// What is wrong with a robot's start pose: soles that are not level and on the ground, legs that cannot move their soles in every
/// direction, couplings of the model that do not hold there.
///
/// @param d  the start pose, which `robot` has read, after mj_tendon
Reasons stand_reasons(const Robot& robot, const mjData* d);

}  // namespace zmpwalk
