#pragma once

#include "zmpwalk/math/types.hpp"
#include "zmpwalk/robot/mujoco_types.hpp"
#include "zmpwalk/robot/robot.hpp"

namespace zmpwalk {

/// What MuJoCo's contacts say after a step: they belong to the state **before** it.
struct MeasuredContact {
  Vec12 wrench = Vec12::Constant(
      kNaN);  ///< robot on ground, left then right, at the sole centres, world axes; NaN without contact
  std::array<Vec3, 2> sole{Vec3::Zero(), Vec3::Zero()};  ///< sole centres of that same state, W [m]
  int self_contacts = 0;                                 ///< contacts between two bodies of the robot
};

/// Sums the contact forces between each foot and everything that is not the robot. Allocates nothing.
MeasuredContact measure_contact(const Robot& robot, const mjData* d);

/// ZMP of those forces in W (2,) [m], NaN without contact.
///
/// Taken on the horizontal plane at `plane` [m]; NaN: the load-weighted height of the soles, which with one foot is its own.
Vec2 measured_zmp(const MeasuredContact& contact, double plane = kNaN);

}  // namespace zmpwalk
