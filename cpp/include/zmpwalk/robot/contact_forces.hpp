#pragma once

#include "zmpwalk/math/types.hpp"
#include "zmpwalk/robot/mujoco_types.hpp"
#include "zmpwalk/robot/robot.hpp"
#include "zmpwalk/robot/state.hpp"
#include "zmpwalk/zmp/plane.hpp"

namespace zmpwalk {

/// The contact forces that MuJoCo has computed. After a step they belong to the state **before** it.
struct MeasuredContact {
  Vec12 wrench = Vec12::Constant(
      kNaN);  ///< robot on ground, left then right, at the sole centres, world axes; NaN without contact
  std::array<Vec3, 2> sole{Vec3::Zero(), Vec3::Zero()};  ///< sole centres of that same state, W [m]
  int self_contacts = 0;                                 ///< contacts between two bodies of the robot
};

/// Sums the contact forces between each foot and everything that is not the robot. Allocates nothing.
MeasuredContact measure_contact(const Robot& robot, const mjData* d);

/// What the feet feel of them: the wrench of each foot, and whether it touches. Allocates nothing.
Sensed felt_by(const MeasuredContact& contact);

/// World x and y of the ZMP of those forces on `plane` (2,) [m], NaN without contact. Allocates nothing.
Vec2 measured_zmp(const MeasuredContact& contact, const Plane& plane);
/// The same on a level plane. It lies at the height of the soles, weighted by the load that each carries.
Vec2 measured_zmp(const MeasuredContact& contact);

}  // namespace zmpwalk
