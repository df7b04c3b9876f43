#pragma once

#include <vector>

#include "zmpwalk/control/whole_body.hpp"
#include "zmpwalk/gait/joint_motion.hpp"
#include "zmpwalk/robot/robot.hpp"
#include "zmpwalk/settings/settings.hpp"

namespace zmpwalk {

/// Swings the arms against the yaw momentum (angular momentum about the vertical) of legs and trunk; an addition to the paper.
///
/// The row c of the yaw momentum, L_z = c dq, is split into the part of the swinging joints, c_a dq_a, and the rest. The arms get
///     ddq_a = -c_a^+ dL_rest + k_d (-c_a^+ L_rest - dq_a) + k_p (q_ref - q_a).
/// The first term cancels what the rest of the body does, the second brings L_z to zero at the rate k_d, and the third is a soft spring
/// that brings the arms home. A joint that comes near to its limit is slowed down as a critically damped joint would be.
///
/// It takes at most half of its torque for its acceleration, however noisy the measured momentum is.
///
/// Arms that do not swing, or little, are a reserve: while the yaw friction of a sole holds the torque back, they come to help, and
/// return to what they did before.
class ArmSwing {
 public:
  /// @param settings resolved
  /// @throws InputError momentum_arms > 0 for a robot without arms, or without the posture task
  ArmSwing(const Robot& robot, const WalkSettings& settings);

  /// Whether the arms swing now: the settings ask for it, or a sole does.
  bool on() const { return share_ > 0.0 || (helping_ > 0.0 && !swinging_.empty()); }
  void reset() { helping_ = 0.0; }
  /// Once a cycle: whether the yaw friction of a sole holds the torque back.
  void help(bool needed);
  /// Joints that `reference` names follow it and do not swing.
  void leave_to(const MotionReference& reference);
  /// Writes the accelerations of the swinging joints into `f_star.posture`, where those of the posture task stand. Allocates nothing.
  ///
  /// @param f_xy COM acceleration of the cycle before, W (2,) [m/s^2]   @param turning planned rate of turning w_z [rad/s]   @param tasks of the user's, which the arms swing around
  void command(const Dynamics& dynamics, const VecX& torque_limit, const Stance& stance, const Vec2& f_xy,
               double turning, const MotionReference& reference, const TaskStack& tasks,
               WholeBodyController& whole_body, TaskAccelerations& f_star);

 private:
  double share_, kp_, kd_, reserve_, rise_, fall_;  // the last two per cycle
  double helping_ = 0.0;                            // how far the reserve has come in, 0 to 1
  std::vector<int> arms_, swinging_;  // joints of the arms, and those of them that no motion names (indices)
  std::vector<std::pair<double, double>> range_;  // lower and upper limit of each joint [rad]
  VecX c_;                                        // row c of the yaw momentum (nv,)
  VecX posture_;                                  // what the posture task asks for (nv - 6,)
};

}  // namespace zmpwalk
