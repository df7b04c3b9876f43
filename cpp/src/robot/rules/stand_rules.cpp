#include "zmpwalk/robot/rules/stand_rules.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <vector>

#include "zmpwalk/robot/robot.hpp"
#include "zmpwalk/robot/rules/leg_rules.hpp"
#include "zmpwalk/robot/rules/unmodelled.hpp"
#include "zmpwalk/robot/words.hpp"

namespace zmpwalk {
namespace {

constexpr double kStandTilt = 0.02;     // largest tilt of a sole in the start pose [rad]
constexpr double kStandHeight = 0.005;  // largest height of a sole over the ground in the start pose [m]
/// Least over largest singular value of a leg's Jacobian, lengths in units of the leg.
constexpr double kLeastMobility = 1e-3;

/// The leg's six columns of its sole's Jacobian.
Mat6 leg_jacobian(const Robot& robot, Side side) {
  Mat6 J;
  for (int i = 0; i < 6; ++i) J.col(i) = robot.dynamics().sole[side].J.col(6 + robot.leg_joints()[side][i]);
  return J;
}

std::string joint_names(const Robot& robot, Side side) {
  std::vector<std::string> names;
  for (const int j : robot.leg_joints()[side]) names.push_back("'" + robot.joint_names()[j] + "'");
  return listed(names);
}

bool can_move_everywhere(const Robot& robot, Side side) {
  Mat6 J = leg_jacobian(robot, side);
  const RobotLeg leg = robot.leg_at_stand(side);
  J.topRows<3>() /= leg.thigh + leg.shank;
  const Vec6 mobility = Eigen::JacobiSVD<Mat6>(J).singularValues();
  return mobility[5] > kLeastMobility * mobility[0];
}

void add_leg_at_stand(const Robot& robot, Side side, Reasons& out) {
  const std::string which = side == kLeft ? "left" : "right";
  const FrameState& sole = robot.dynamics().sole[side];
  const double tilt = std::acos(std::clamp(sole.R_WF(2, 2), -1.0, 1.0)), height = sole.p_WF.z();
  if (tilt > kStandTilt || std::abs(height) > kStandHeight) {
    out.push_back({"stand", "at the start pose the " + which + " sole is tilted by " + number(tilt) + " rad and " +
                                number(height) + " m over the ground; both soles must lie flat on z = 0"});
    if (tilt > kStandTilt) return;  // the directions of its axes say nothing while the sole is not level
  }
  const std::size_t before = out.size();
  const std::string leg = "the " + which + " leg (" + joint_names(robot, side) + ")";
  add_leg_axes(leg, leg_jacobian(robot, side).bottomRows<3>(), sole.R_WF.col(0), sole.R_WF.col(1), out);
  if (out.size() == before && !can_move_everywhere(robot, side))
    out.push_back({"stand", "the " + which +
                                " leg cannot move its sole in every direction at the start pose: its knee is straight, "
                                "or its six axes lack a roll, pitch or yaw"});
}

}  // namespace

Reasons stand_reasons(const Robot& robot, const mjData* d) {
  Reasons out;
  for (const Side side : kSides) add_leg_at_stand(robot, side, out);
  add_uncoupled(robot.model(), robot.root_body(), d, out);
  return out;
}

}  // namespace zmpwalk
