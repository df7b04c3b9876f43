#pragma once

#include "zmpwalk/control/dynamics.hpp"

namespace zmpwalk {

/// A known force on the robot, from something that it carries, pushes or is pushed by.
struct ExternalWrench {
  int frame = 0;               ///< index in `Dynamics::frames`
  Vec6 wrench = Vec6::Zero();  ///< force and moment on the robot at the frame's origin, world axes [N, N m]
};

/// Adds the known force w to `dynamics`: with A ddq + b + g + J_c' f_c = S' tau + J' w, b becomes b - J' w.
///
/// Everything that is computed from these terms then takes the force into account: the torque, and both ways to the estimated ZMP. The torque still
/// leads to the motion that was asked for. Allocates nothing. @throws InputError  there is no such frame
void apply_external(Dynamics& dynamics, const ExternalWrench& external);

/// What a robot does beside what its model says, as far as it has been found.
struct Disturbance {
  Vec2 acceleration = Vec2::Zero();  ///< of the COM by an unknown horizontal force, W [m/s^2]
  double weight = 1.0;               ///< its mass over the model's
  bool none() const { return acceleration.isZero(0.0) && weight == 1.0; }
};

/// Lets `dynamics` be those of the disturbed robot: all of its masses are `weight` times the model's, and the force acts at its COM.
///
/// Torque, estimated ZMP and pendulum then take both into account, as they do with known forces. Rotors are scaled too, which are no part of the
/// weight. Allocates nothing.
void apply_disturbance(Dynamics& dynamics, const Disturbance& disturbance);

/// The pendulum (16) under a known force. It is the free pendulum with a COM that appears shifted, and with another gravity.
struct ForcedPendulum {
  Vec2 shift = Vec2::Zero();  ///< W [m]
  double gravity = 0.0;       ///< [m/s^2]; T_c^2 = z_c / gravity
};

/// The pendulum under the forces that `dynamics` knows of, over a support plane at height `ground` [m].
///
/// With N = m g - F_z the ground's normal force, h = z - ground, and M the moment of the known force F about the COM x, the moments about the
/// ZMP r vanish. The links' angular momentum left out, as (16) does, the sagittal one reads
///
///   (r_x - x) N = M_y - h (m x'' - F_x),   thus   x'' = N / (m h) (x + (M_y + h F_x) / N - r_x),
///
/// the lateral one the same with -M_x in place of M_y. That is the free pendulum, x'' = (g / h) (x - r), of the COM x + shift under the gravity
/// N / m: shift = ((M_y + h F_x) / N, (h F_y - M_x) / N). To stand, the COM has to lean against the force by as much.
///
/// A robot that is lifted by its whole weight is no pendulum: N is taken as no less than a tenth of m g.
ForcedPendulum forced_pendulum(const Dynamics& dynamics, double ground);

}  // namespace zmpwalk
