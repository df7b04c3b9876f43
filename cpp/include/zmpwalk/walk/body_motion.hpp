#pragma once

#include <string>
#include <vector>

#include "zmpwalk/gait/joint_motion.hpp"
#include "zmpwalk/robot/robot.hpp"
#include "zmpwalk/settings/settings.hpp"

namespace zmpwalk {

/// The motion that arms, waist and trunk follow while the legs walk: a `JointMotion`, whose names are checked against the robot.
///
/// It has one coordinate for each joint of the robot, and then three for roll, pitch and yaw of the trunk. These turn the trunk from its
/// orientation in the start pose; their axes are those of the heading frame H.
class BodyMotion {
 public:
  /// @param settings resolved
  BodyMotion(const Robot& robot, const WalkSettings& settings);

  /// Follows `motion` from the last `update` on. The reference goes over into it without a jump, within the setting `motion_blend`. Joints that it
  /// does not name go back to the start pose.
  /// @throws InputError  a name is no joint or is a joint of a leg, a joint goes beyond its range, the trunk turns by more than half of
  ///         `fall_tilt`, or the setting `posture_task` is off. Nothing is changed then.
  void follow(const JointMotion& motion);
  /// The walk starts anew, and with it the motion.
  void reset() { reference_.reset(); }
  /// Computes the reference of this cycle. @param t time since the walk began [s]. Allocates nothing.
  void update(double t) { reference_.update(t); }

  const JointMotion& motion() const { return reference_.motion(); }
  const MotionReference& reference() const { return reference_; }
  /// Reference of one coordinate in this cycle: position, velocity, acceleration.
  Motion1 at(int coordinate) const {
    return {reference_.q()[coordinate], reference_.dq()[coordinate], reference_.ddq()[coordinate]};
  }

 private:
  int coordinate(const std::string& name) const;

  const Robot* robot_;
  MotionReference reference_;
  bool posture_task_;
  double blend_, tilt_;
};

}  // namespace zmpwalk
