#include "zmpwalk/walk/damped_crouch.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace zmpwalk {
namespace {

constexpr double kBend = 1.2;       // of the knees beyond the start pose, half of it at hip and ankle [rad]
constexpr double kTime = 0.35;      // in which a joint without load comes to its place [s]
constexpr double kUpright = 0.1;    // in which the hips set a trunk upright that nothing else turns [s]
constexpr double kFullSpeed = 4.0;  // at which a damper takes the whole torque of its joint [rad/s]
constexpr double kLight = 0.4;      // largest share of its speed that a damper takes from a free joint in one period
constexpr double kRoom = 0.1;       // that a crouched joint keeps from its limit [rad]

}  // namespace

DampedCrouch::DampedCrouch(const Robot& robot, double dt)
    : q_(robot.stand()), d_(robot.joints()), limit_(robot.torque_limit()) {
  const Dynamics& dyn = robot.dynamics();
  const MatX inverse = MatX(dyn.A).inverse();
  const double weight = dyn.mass * dyn.gravity.norm(), height = dyn.com.z() - dyn.sole[kLeft].p_WF.z();
  for (int j = 0; j < robot.joints(); ++j) {
    const double whole = std::isfinite(limit_[j]) ? limit_[j] : weight * height;
    d_[j] = std::min(whole / kFullSpeed, kLight / (inverse(6 + j, 6 + j) * dt));
  }
  for (const Side side : kSides) {
    const std::vector<int>& leg = robot.leg_joints()[side];
    std::copy_n(leg.begin(), 3, hip_[side].begin());
    const int knee = leg[3];
    const auto bend = [&](int j, double angle) {
      // A turn about the sole's y bends a leg as a knee bends; the joint may turn the other way around.
      const double axis = dyn.sole[side].J.col(6 + j).tail<3>().dot(dyn.sole[side].R_WF.col(1));
      const auto [low, high] = robot.joint_range(j);
      const double wanted = q_[j] + std::copysign(angle, axis * angle);
      if (low + kRoom < high - kRoom) q_[j] = std::clamp(wanted, low + kRoom, high - kRoom);
    };
    bend(knee, kBend);
    bend(robot.pitch_joint(side, 0, 3), -0.5 * kBend);
    bend(robot.pitch_joint(side, 4, 6), -0.5 * kBend);
  }
}

double DampedCrouch::crouch_torque(const Dynamics& dynamics, VecX& tau) const {
  tau = d_.cwiseProduct((q_ - dynamics.q) / kTime - dynamics.dq.tail(tau.size()));
  // A hip turns the leg against the trunk.
  const Vec3 lean = dynamics.R_WB.col(2).cross(Vec3::UnitZ()), turn = lean / kUpright - dynamics.omega_WB;
  for (const Side side : kSides)
    for (const int j : hip_[side]) tau[j] -= d_[j] * dynamics.sole[side].J.col(6 + j).tail<3>().dot(turn);
  const double ratio = tau.cwiseAbs().cwiseQuotient(limit_).maxCoeff();
  tau = tau.cwiseMax(-limit_).cwiseMin(limit_);
  return ratio;
}

}  // namespace zmpwalk
