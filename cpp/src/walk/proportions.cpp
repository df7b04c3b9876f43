#include "zmpwalk/walk/proportions.hpp"

#include <algorithm>
#include <cmath>

namespace zmpwalk {

double height_over_soles(const Dynamics& dyn) {
  return dyn.com.z() - 0.5 * (dyn.sole[kLeft].p_WF.z() + dyn.sole[kRight].p_WF.z());
}

RobotScale scale_of(const Robot& robot) {
  const Dynamics& dyn = robot.dynamics();
  const RobotLeg leg = robot.leg_at_stand(kLeft);
  RobotScale scale{height_over_soles(dyn), dyn.gravity.norm(), robot.timestep(),
                   (dyn.sole[kLeft].p_WF - dyn.sole[kRight].p_WF).head<2>().norm()};
  scale.friction = std::min(robot.sole_friction(kLeft), robot.sole_friction(kRight));
  // Law of cosines over hip, knee and ankle: d(length)/d(angle) = thigh shank sin(angle) / length.
  const double length = leg.hip_to_ankle.norm();
  const double cosine =
      (length * length - leg.thigh * leg.thigh - leg.shank * leg.shank) / (2.0 * leg.thigh * leg.shank);
  scale.hip_to_ankle = length;
  scale.knee_per_lift = length / (leg.thigh * leg.shank * std::sqrt(std::max(1.0 - cosine * cosine, 1e-4)));
  scale.knee_armature = leg.knee_armature;
  scale.knee_damping = leg.knee_damping;
  scale.knee_torque = robot.torque_limit()[leg.knee];
  return scale;
}

SoleSize common_sole(const Robot& robot) {
  constexpr double kRounding = 1e-6;  // [m]
  const auto& [left, right] = robot.description().feet;
  SoleSize out{std::max(left.length, right.length), std::min(left.width, right.width)};
  for (const Side side : kSides) {
    const Vec2 foot = 2.0 * robot.foot_reach(side);
    if (foot.x() > out.foot_length + kRounding) out.foot_length = foot.x();
    if (foot.y() > out.foot_width + kRounding) out.foot_width = foot.y();
  }
  return out;
}

RobotLimits limits_of(const Robot& robot, const WalkSettings& settings) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  RobotLimits limits;
  limits.torque = robot.torque_limit();
  for (int j = 0; j < robot.joints(); ++j) limits.range.push_back(robot.joint_range(j));
  for (const Side side : kSides) {
    const Foot& foot = robot.description().feet[side];
    // The ground turns a standing foot, and the foot that lands is to lie flat: an ankle's stop is left to the ankle.
    for (const int i : {4, 5}) limits.range[robot.leg_joints()[side][i]] = {-kInfinity, kInfinity};
    limits.sole[side] = {foot.length, foot.width, settings.limits.friction, settings.limits.twist};
  }
  limits.weight = robot.dynamics().mass * robot.dynamics().gravity.norm();
  limits.height = height_over_soles(robot.dynamics());
  limits.range_margin = settings.limits.range_margin;
  limits.range_rate = settings.limits.range_rate;
  return limits;
}

ZmpBounds bounds_of(const Robot& robot, Side side, const WalkSettings& settings, double sole_fraction) {
  const Foot& foot = robot.description().feet[side];
  const auto& leg = robot.leg_joints()[side];
  const Vec3 ankle = robot.ankle_in_sole(side);
  const Dynamics& dyn = robot.dynamics();
  const int pitch = robot.pitch_joint(side, 4, 6);
  const int roll = leg[4] == pitch ? leg[5] : leg[4];
  const SoleLimits limits{foot.length, foot.width, ankle.head<2>(), robot.torque_limit()[pitch],
                          robot.torque_limit()[roll]};
  return zmp_bounds(limits, dyn.mass * dyn.gravity.norm(), sole_fraction, settings.zmp.ankle_torque_fraction);
}

}  // namespace zmpwalk
