#pragma once

#include <string>
#include <vector>

#include "zmpwalk/gait/joint_motion.hpp"
#include "zmpwalk/robot/robot.hpp"
#include "zmpwalk/settings/settings.hpp"

namespace zmpwalk {

/// What arms, waist and trunk follow while the legs walk: a `JointMotion` by names, checked against the robot.
///
/// Coordinates are the robot's joints, then the trunk's roll, pitch, yaw: its turn from where it stands, in the heading frame.
class BodyMotion {
 public:
  /// @param settings resolved
  BodyMotion(const Robot& robot, const WalkSettings& settings);

  /// Follows `motion` from the last `update` on, reached within `motion_blend` without a jump; what it does not name goes back to the stand.
  /// @throws InputError a name that is no joint, or a leg's; a joint beyond its range, the trunk turned by more than half of
  ///         `fall_tilt`; posture_task off. Nothing is changed then.
  void follow(const JointMotion& motion);
  void reset() { reference_.reset(); }
  /// @param t since the walk began [s]. Allocates nothing.
  void update(double t) { reference_.update(t); }

  const JointMotion& motion() const { return reference_.motion(); }
  const MotionReference& reference() const { return reference_; }
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
