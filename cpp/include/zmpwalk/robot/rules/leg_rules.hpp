#pragma once

#include <set>
#include <string>

#include "zmpwalk/robot/rules/model_rules.hpp"

namespace zmpwalk {

/// Directions of a leg's six joint axes, hip to ankle: columns (3, 6) of unit vectors.
using LegAxes = Eigen::Matrix<double, 3, 6>;

/// Adds a reason for a leg whose fourth joint does not bend a knee, whose hip cannot pitch, or whose last two joints cannot pitch and roll the
/// foot. Footholds, crouch and bounds of the ZMP rely on three joints in the hip, one in the knee and two in the ankle. All directions are unit
/// vectors in one frame.
///
/// @param leg  how the sentence calls it: "the left leg (l_hip_yaw, ...)"
void add_leg_axes(const std::string& leg, const LegAxes& axes, const Vec3& forward, const Vec3& left, Reasons& out);

/// Adds what is wrong with the two legs and their soles. Each leg must have six hinges from hip to ankle and a foot that can touch the ground and is
/// no point foot. Where a pose is given, the directions of the axes are checked too (`model_reasons` says which pose).
///
/// @param taken  the joints that belong to legs
void add_legs(const mjModel* m, const RobotParts& robot, const mjData* upright, std::set<int>& taken, Reasons& out);

/// How sentences call a foot: "the left foot", or "the foot" where its side is not known.
std::string foot_of(const LegParts& leg);

}  // namespace zmpwalk
