#include "zmpwalk/walk/body_motion.hpp"

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {
namespace {

constexpr std::array<const char*, 3> kTrunkNames{"trunk_roll", "trunk_pitch", "trunk_yaw"};

}  // namespace

BodyMotion::BodyMotion(const Robot& robot, const WalkSettings& settings)
    : robot_(&robot),
      reference_((VecX(robot.joints() + 3) << robot.stand(), Vec3::Zero()).finished()),
      posture_task_(settings.posture.task),
      blend_(settings.posture.motion_blend),
      tilt_(0.5 * settings.fall.tilt) {}

int BodyMotion::coordinate(const std::string& name) const {
  std::string known;
  for (int j = 0; j < robot_->joints(); ++j) {
    if (robot_->is_leg_joint(j)) {
      if (robot_->joint_names()[j] == name)
        throw InputError("the motion moves '" + name + "', a joint of a leg: the walk moves those");
      continue;
    }
    if (robot_->joint_names()[j] == name) return j;
    known += robot_->joint_names()[j] + ", ";
  }
  for (int i = 0; i < 3; ++i)
    if (name == kTrunkNames[i]) return robot_->joints() + i;
  throw InputError("the motion moves '" + name + "', which this robot does not have; there are: " + known +
                   "trunk_roll, trunk_pitch, trunk_yaw");
}

void BodyMotion::follow(const JointMotion& motion) {
  if (!posture_task_ && !motion.names().empty()) throw InputError("posture_task is off: nothing would follow a motion");
  std::vector<int> entry;
  for (const std::string& name : motion.names()) {
    const int i = coordinate(name);
    const auto [low, high] = i < robot_->joints() ? robot_->joint_range(i) : std::make_pair(-tilt_, tilt_);
    const JointMotion::Extent extent = motion.extent(static_cast<int>(entry.size()));
    const bool below = extent.low < low;
    if (below || extent.high > high)
      throw InputError("the motion brings '" + name + "' to " + std::to_string(below ? extent.low : extent.high) +
                       " rad at t = " + std::to_string(below ? extent.t_low : extent.t_high) + " s; its range is " +
                       std::to_string(low) + " to " + std::to_string(high) +
                       " rad, between the knots of the spline too");
    entry.push_back(i);
  }
  reference_.start(motion, std::move(entry), blend_);
}

}  // namespace zmpwalk
