#include "zmpwalk/walk/arm_swing.hpp"

#include <algorithm>

#include "zmpwalk/control/momentum.hpp"
#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

ArmSwing::ArmSwing(const Robot& robot, const WalkSettings& settings)
    : share_(settings.arms.momentum),
      kp_(settings.arms.kp),
      kd_(settings.arms.kd),
      reserve_(std::max(settings.arms.reserve, share_)),
      rise_(10.0 * settings.control.dt / settings.arms.reserve_time),
      fall_(settings.control.dt / settings.arms.reserve_time),
      arms_(robot.arm_joints()),
      swinging_(arms_),
      c_(VecX::Zero(robot.nv())),
      posture_(VecX::Zero(robot.joints())) {
  if (on() && (arms_.empty() || !settings.posture.task))
    throw InputError(
        "momentum_arms = " + std::to_string(share_) +
        " needs the posture task, and arms: joints outside the legs that carry less than a fifth of the robot; with 0 "
        "no arm swings");
  for (int j = 0; j < robot.joints(); ++j) range_.push_back(robot.joint_range(j));
}

void ArmSwing::leave_to(const MotionReference& reference) {
  swinging_.clear();
  for (const int j : arms_)
    if (!reference.names(j)) swinging_.push_back(j);
}

void ArmSwing::help(bool needed) {
  if (reserve_ > share_) helping_ = std::clamp(needed ? helping_ + rise_ : helping_ - fall_, 0.0, 1.0);
}

void ArmSwing::command(const Dynamics& dyn, const VecX& torque_limit, const Stance& stance, const Vec2& f_xy,
                       double turning, const MotionReference& reference, const TaskStack& tasks,
                       WholeBodyController& whole_body, TaskAccelerations& f_star) {
  posture_ = f_star.posture;
  for (const int j : swinging_) f_star.posture[j] = 0.0;
  whole_body.prepare(dyn, stance, f_star, &tasks);
  momentum_row(dyn, Vec3::UnitZ(), c_.transpose());
  // A robot that turns as planned keeps the momentum of turning as one body.
  double L_rest = c_.dot(dyn.dq) - turning * c_.segment<3>(3).dot(dyn.R_WB.row(2)), square = 0.0;
  for (const int j : swinging_) {
    L_rest -= c_[6 + j] * dyn.dq[6 + j];
    square += c_[6 + j] * c_[6 + j];
  }
  if (!(square > 0.0)) return;
  // Arms that did not swing before leave their posture as far as they have come to help.
  const double loose = share_ > 0.0 ? 1.0 : helping_,
               cancelled = share_ + (reserve_ - share_) * (share_ > 0.0 ? helping_ : 1.0);
  const double dL_rest = whole_body.yaw_moment(f_xy), share = -cancelled / square;
  for (const int j : swinging_) {
    const double q = dyn.q[j], dq = dyn.dq[6 + j], c_inv = share * c_[6 + j];
    const double ddq = reference.ddq()[j] + c_inv * dL_rest +
                       pd_acceleration(kp_, kd_, reference.q()[j] - q, reference.dq()[j] + c_inv * L_rest - dq);
    const auto [low, high] = range_[j];
    const double most = 0.5 * torque_limit[j] / dyn.A(6 + j, 6 + j);
    const double kept = std::clamp(std::clamp(ddq, -most, most), kd_ * (0.25 * kd_ * (low - q) - dq),
                                   kd_ * (0.25 * kd_ * (high - q) - dq));
    f_star.posture[j] = (1.0 - loose) * posture_[j] + loose * kept;
  }
}

}  // namespace zmpwalk
