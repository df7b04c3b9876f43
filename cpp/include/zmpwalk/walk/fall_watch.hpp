#pragma once

#include "zmpwalk/control/dynamics.hpp"
#include "zmpwalk/gait/gait_generator.hpp"
#include "zmpwalk/settings/settings.hpp"
#include "zmpwalk/walk/record.hpp"

namespace zmpwalk {

/// Says whether the robot has fallen. It compares height, tilt of the trunk and tilt of the support sole with how the robot stood at the start.
class FallWatch {
 public:
  explicit FallWatch(const WalkSettings& settings);

  /// The walk starts: as they are now, the trunk counts as upright and the soles as level. `R_HB` is the trunk's rotation in the heading frame,
  /// `com_height` the height of the COM over the soles [m].
  void reset(const Dynamics& dynamics, const Mat3& R_HB, double com_height);
  /// Why the state of this instant counts as a fall; kNone where it does not.
  Fall check(const Dynamics& dynamics, const GaitOutput& gait) const;

 private:
  double height_share_, tilt_, foot_tilt_;
  double com_height_ = 0.0;
  Mat3 R_HB_ = Mat3::Identity();                          // trunk in the heading frame at the start
  std::array<Vec3, 2> up_{Vec3::UnitZ(), Vec3::UnitZ()};  // normals of the soles at the start
};

}  // namespace zmpwalk
