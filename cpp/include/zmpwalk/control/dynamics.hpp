#pragma once

#include <vector>

#include "zmpwalk/control/sparsity.hpp"
#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// A frame F that is fixed to a body of the robot: its pose, its velocity, and its acceleration J ddq + drift.
struct FrameState {
  Vec3 p_WF = Vec3::Zero();      ///< position in W [m]
  Mat3 R_WF = Mat3::Identity();  ///< rotation, axes of F to world
  Vec6 velocity = Vec6::Zero();  ///< linear, angular, world axes [m/s, rad/s] = J dq
  Mat6X J;                       ///< (6, nv), linear rows first, world axes
  Vec6 drift = Vec6::Zero();     ///< Jdot dq [m/s^2, rad/s^2]
};

/// All that equations 1-15 need to know of the robot at one instant; plain numbers, no simulator.
///
/// Velocity order is MuJoCo's: base linear velocity in world axes (3), base angular velocity in base axes (3), then one
/// entry per joint. Sign convention: A ddq + b + g + J_c' f_c = S' tau, f_c the wrench of the robot **on** the ground.
struct Dynamics {
  /// @param nv  velocity coordinates, 6 + joints
  explicit Dynamics(int nv);

  int nv() const { return static_cast<int>(dq.size()); }
  int joints() const { return nv() - 6; }

  double mass = 0.0;                 ///< [kg]
  Vec3 gravity = Vec3(0, 0, -9.81);  ///< acceleration of gravity in W [m/s^2]; overwritten by the model's

  VecX q;               ///< joint positions (joints,) [rad or m], base excluded
  VecX dq;              ///< velocities (nv,)
  RowMatX A;            ///< inertia (nv, nv), armature included
  Sparsity A_sparsity;  ///< which entries of A may differ from zero; all, unless a robot knows better
  VecX b;               ///< velocity terms and passive joint forces, moved to the left side (nv,)
  VecX g;               ///< gravity (nv,)
  VecX drift_momentum;  ///< b without passive forces (nv,): its first three rows are M Jcom_dot dq

  Vec3 com = Vec3::Zero();        ///< [m]
  Vec3 dcom = Vec3::Zero();       ///< [m/s]
  Mat3X J_com;                    ///< (3, nv)
  Vec3 drift_com = Vec3::Zero();  ///< Jdot dq of the COM [m/s^2]

  Vec3 p_WB = Vec3::Zero();      ///< base position [m]
  Mat3 R_WB = Mat3::Identity();  ///< base rotation
  Vec3 omega_WB = Vec3::Zero();  ///< base angular velocity, world axes [rad/s]

  std::array<FrameState, 2> sole;  ///< left, right: origin at the sole's centre on the sole plane, x forward, z up
  std::vector<FrameState> frames;  ///< further frames that tasks and known forces ask for: `Robot::watch`

  // Known forces on the robot, which b holds already: see `apply_external`.
  Vec3 F_ext = Vec3::Zero();  ///< sum of the known forces, W [N]
  Vec3 M_ext = Vec3::Zero();  ///< moment of the known forces about the COM, W [N m]
};

}  // namespace zmpwalk
