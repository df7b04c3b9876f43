#pragma once

#include <array>

#include "zmpwalk/control/dynamics.hpp"
#include "zmpwalk/robot/robot.hpp"

namespace zmpwalk {

/// What the joints of a robot do that cannot keep from falling: the legs bend, every joint is damped, and the hips hold the trunk upright, so that the
/// robot comes down low and slowly.
///
///     tau_j = k_j (q_crouch - q) - d_j dq,  k_j = d_j / kTime,  cut to the joint's limit; at the hips also - d_j a_j . (e / kUpright - omega),
/// where a_j is the joint's axis, e the rotation vector that would set the trunk upright and omega its angular velocity, all in W.
/// It knows no contacts and solves nothing, so that it gives a torque in any position. A damper takes a joint's whole torque at kFullSpeed, or less
/// where a light limb would be shaken by a torque that is held for a control period.
class DampedCrouch {
 public:
  /// @param robot at its start pose   @param dt control period [s]
  DampedCrouch(const Robot& robot, double dt);

  /// Writes the torque (joints,) [N m] into `tau`; returns its largest ratio to a limit before it is cut. Allocates nothing.
  double crouch_torque(const Dynamics& dynamics, VecX& tau) const;

  const VecX& posture() const { return q_; }  ///< of the crouch (joints,) [rad]
  const VecX& damping() const { return d_; }  ///< d_j (joints,) [N m s/rad]

 private:
  VecX q_, d_, limit_;
  std::array<std::array<int, 3>, 2> hip_{};  // the first three joints of each leg
};

}  // namespace zmpwalk
