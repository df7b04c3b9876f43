#pragma once

#include <mujoco/mujoco.h>

#include "zmpwalk/robot/rules/model_rules.hpp"

namespace zmpwalk {

/// Adds what acts on the robot but is not in its equation of motion, so that no walk is wrong without saying so.
///
/// It refuses: a passive callback, plugins, flexes, adhesion, gravity compensation that carries the robot; equality constraints that tie
/// bodies of the robot or joints below the base; tendons that pull it to something else, rub, limit or drive a leg; actuators on bodies,
/// sites, cranks or the base, and actuators with a delay. It accepts: other trees, mocap bodies, fluids, springs and dampers (also of tendons), motors, servos
/// and muscles at joints and in arms' tendons, and constraints that couple joints of arms (`add_uncoupled`).
void add_unmodelled(const mjModel* m, const RobotParts& robot, Reasons& out);

/// Adds the equality constraints among the robot's other joints, and the limits of its tendons, that do not hold at the pose in `d`, for the posture
/// task keeps that pose. `d` must have gone through mj_kinematics and mj_tendon.
void add_uncoupled(const mjModel* m, int root_body, const mjData* d, Reasons& out);

}  // namespace zmpwalk
