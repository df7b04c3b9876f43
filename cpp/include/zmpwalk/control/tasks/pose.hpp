#pragma once

#include "zmpwalk/control/dynamics.hpp"
#include "zmpwalk/control/task_space.hpp"
#include "zmpwalk/math/rotation.hpp"

namespace zmpwalk {

/// Where a frame is to be and how it is to move, in world axes or in those of the frame to which the reference is relative.
struct PoseReference {
  Vec3 p = Vec3::Zero();             ///< position [m]
  Mat3 R = Mat3::Identity();         ///< orientation
  Vec6 velocity = Vec6::Zero();      ///< linear, angular [m/s, rad/s]
  Vec6 acceleration = Vec6::Zero();  ///< linear, angular, fed forward [m/s^2, rad/s^2]
};

/// Commanded acceleration of a frame (6,), linear then angular, world axes: (8) for its pose error, plus the acceleration of the reference.
inline Vec6 pose_acceleration(const PoseReference& reference, const FrameState& frame, double kp, double kd) {
  Vec6 error;
  error << reference.p - frame.p_WF, orientation_error(reference.R, frame.R_WF);
  return pd_acceleration(kp, kd, error, Vec6(reference.velocity - frame.velocity)) + reference.acceleration;
}

}  // namespace zmpwalk
