#pragma once

#include "zmpwalk/control/dynamics.hpp"
#include "zmpwalk/settings/settings.hpp"
#include "zmpwalk/walk/record.hpp"

namespace zmpwalk {

/// Says whether the robot has fallen. It compares height and tilt of the trunk with how the robot stood at the start.
class FallWatch {
 public:
  explicit FallWatch(const WalkSettings& settings);

  /// The walk starts: as it is now, the trunk counts as upright. `R_HB` is its rotation in the heading frame, `com_height` the height of the COM
  /// over the soles [m].
  void reset(const Mat3& R_HB, double com_height);
  /// Why the state of this instant counts as a fall; kNone where it does not. @param floor  height from which that of the COM counts [m]
  Fall check(const Dynamics& dynamics, double floor) const;

 private:
  double height_share_, tilt_;
  double com_height_ = 0.0;
  Mat3 R_HB_ = Mat3::Identity();  // trunk in the heading frame at the start
};

}  // namespace zmpwalk
