#pragma once

#include <mujoco/mujoco.h>

#include <vector>

namespace zmpwalk {

/// The robot that is looked at: its free joint and the joints between base and soles.
struct RobotTree {
  int root_body;
  std::vector<int> chain_joints;  ///< waist and legs, MuJoCo numbers
};

/// Refuses what acts on the robot and is not in its equation of motion, so that no walk is silently wrong.
///
/// Refused: no or tilted gravity, a passive callback, plugins, flexes, adhesion; equality constraints that tie
/// bodies of the robot or joints below the base; tendons that pull it to something else, rub, limit or drive a leg; actuators on bodies,
/// sites, cranks, the base, or late ones. Fine: other trees, mocap bodies, fluids, springs and dampers (also of tendons), motors, servos
/// and muscles at joints and in arms' tendons, and constraints that couple joints of arms (`require_coupled_stand`).
///
/// @throws ModelError  names the thing, says why
void require_modelled(const mjModel* m, const RobotTree& robot);

/// Equality constraints among the robot's other joints, and limits of its tendons, hold at the pose in `d`, which the posture task keeps.
///
/// `d` after mj_kinematics and mj_tendon. @throws ModelError names the constraint and by how much it is off
void require_coupled_stand(const mjModel* m, const RobotTree& robot, const mjData* d);

}  // namespace zmpwalk
