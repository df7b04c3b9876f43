#pragma once

#include <mujoco/mujoco.h>

#include <optional>
#include <string>
#include <vector>

#include "zmpwalk/math/types.hpp"
#include "zmpwalk/robot/description.hpp"

// The rules that a model, a robot in it and its description must keep, so that the robot can walk. Each rule stands in this folder and
// nowhere else: whoever looks for a robot asks here what is wrong with it.

namespace zmpwalk {

/// One thing that keeps a robot from walking.
struct Reason {
  std::string
      rule;  ///< "gravity", "time step", "contacts", "callback", "names", "base", "leg", "leg axes", "sole", "joint", "motor",
             ///< "stand", "body", "equality", "tendon" or "actuator"
  std::string text;  ///< one sentence: what is wrong, with names and values, and what would work
};
using Reasons = std::vector<Reason>;

/// A leg by MuJoCo's numbers.
struct LegParts {
  std::string side;          ///< "left" or "right"; empty where it is not known yet
  int foot = -1;             ///< body that carries the sole, or -1 where the model has no such body
  std::vector<int> joints;   ///< hip to ankle; -1 where the model has no such joint
  std::optional<Vec2> sole;  ///< length and width [m]; none where they are not known yet
};

/// A robot by MuJoCo's numbers: what the rules about its tree look at.
struct RobotParts {
  int root_body = -1;          ///< outermost body of its tree
  std::vector<LegParts> legs;  ///< two
  Vec3 forward =
      Vec3::Zero();  ///< its level direction in the pose that comes with it (W); zero where it is not known yet
};

/// What is wrong with the model itself: its gravity, time step or contacts, or that the tree with most joints is fixed to the world.
Reasons model_reasons(const mjModel* m);

/// What is wrong with the model and with a robot in it: also base, legs, soles, joints, motors, and what acts on the robot without being modelled.
///
/// `upright` is a pose, after mj_kinematics and mj_comPos, in which the feet are level and look `forward`. If both are given, the directions of the
/// legs' axes are checked too. Without a pose `stand_reasons` checks them later.
Reasons model_reasons(const mjModel* m, const RobotParts& robot, const mjData* upright = nullptr);

/// The same for the robot that a description names. It also checks that the names exist, the start pose and the torque limits.
Reasons model_reasons(const mjModel* m, const RobotDescription& description);

/// Joints between the base and the feet: legs, and a waist that they hang from.
std::vector<int> chain_joints(const mjModel* m, const RobotParts& robot);

/// Does nothing where there is no reason. @throws ModelError  there are reasons; it carries all of them
void require_none(const Reasons& reasons);

}  // namespace zmpwalk
