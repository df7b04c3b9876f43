#pragma once

#include <functional>
#include <string>

#include "zmpwalk/control/task.hpp"
#include "zmpwalk/control/tasks/pose.hpp"
#include "zmpwalk/math/spline.hpp"

namespace zmpwalk {

/// Which part of a frame's pose a task controls.
enum class FramePart { kPosition, kOrientation, kPose };

/// The frame in which a reference is given. It decides whether the reference moves along with the robot.
enum class RelativeTo {
  kWorld,  ///< W
  kWalk,   ///< origin at the COM, x along the walk's heading, z up
  kTrunk   ///< the base's own frame
};

/// A frame of the robot (of a body or of a site) follows a pose.
///
/// The reference is constant (`set` once), changes from cycle to cycle with its velocity and acceleration (`set` in each), or is a function of time
/// (`follow`). Without a reference the frame stays where it is when the task begins. The task begins without a jump: its reference starts at
/// the frame's pose and velocity, and goes over into the given one within the blend time, along a quintic.
class FrameTask : public Task {
 public:
  /// @param frame  name of a body or site   @param kp [1/s^2]  @param kd [1/s]
  /// @throws InputError  a gain is negative or not finite
  explicit FrameTask(std::string frame, FramePart part = FramePart::kPose, RelativeTo relative_to = RelativeTo::kWorld,
                     double kp = 400.0, double kd = 40.0);

  /// From the next cycle on, the reference is this one. @throws InputError not finite, or R is no rotation
  void set(const PoseReference& reference);
  /// The reference is a function of the time since the task began [s].
  void follow(std::function<PoseReference(double)> reference) { function_ = std::move(reference); }
  /// The reference of the last cycle, in the frame to which it is relative.
  const PoseReference& reference() const { return reference_; }

  int rows() const override { return part_ == FramePart::kPose ? 6 : 3; }
  void attach(RobotNames& names) override { frame_ = names.frame(name_); }
  void begin(const TaskInput& in, double blend) override;
  void compute(const TaskInput& in, TaskRows& out) override;

 private:
  struct Carrier;  // the frame that the reference is relative to
  PoseReference faded(double t) const;

  std::string name_;
  FramePart part_;
  RelativeTo relative_to_;
  double kp_, kd_;
  int frame_ = -1;
  bool given_ = false;
  PoseReference reference_;
  std::function<PoseReference(double)> function_;
  // What the frame's pose and the reference differ by where the task begins.
  std::array<Motion1, 3> away_;
  Motion1 turned_;
  Vec3 turn_axis_ = Vec3::UnitX();
  double t_begin_ = 0.0, blend_ = 1.0;
};

}  // namespace zmpwalk
