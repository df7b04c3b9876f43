#pragma once

#include <mujoco/mujoco.h>

#include "zmpwalk/robot/rules/model_rules.hpp"

namespace zmpwalk {

/// Adds what acts on the robot and is not in its equation of motion, so that no walk is silently wrong.
///
/// Refused: a passive callback, plugins, flexes, adhesion, gravity compensation that carries the robot; equality constraints that tie
/// bodies of the robot or joints below the base; tendons that pull it to something else, rub, limit or drive a leg; actuators on bodies,
/// sites, cranks, the base, or late ones. Fine: other trees, mocap bodies, fluids, springs and dampers (also of tendons), motors, servos
/// and muscles at joints and in arms' tendons, and constraints that couple joints of arms (`add_uncoupled`).
void add_unmodelled(const mjModel* m, const RobotParts& robot, Reasons& out);

/// Adds equality constraints among the robot's other joints, and limits of its tendons, that do not hold at the pose in `d`, which the
/// posture task keeps. `d` after mj_kinematics and mj_tendon.
void add_uncoupled(const mjModel* m, int root_body, const mjData* d, Reasons& out);

}  // namespace zmpwalk
