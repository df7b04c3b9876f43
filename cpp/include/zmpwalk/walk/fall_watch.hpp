#pragma once

#include "zmpwalk/control/dynamics.hpp"
#include "zmpwalk/gait/gait_generator.hpp"
#include "zmpwalk/settings/settings.hpp"
#include "zmpwalk/walk/record.hpp"

namespace zmpwalk {

/// Says when a walk has become a fall, measured against how the robot stood at the start.
class FallWatch {
 public:
  explicit FallWatch(const WalkSettings& settings);

  /// The walk starts here: the trunk upright as it is, the soles level as they are, the COM `com_height` over them [m].
  void reset(const Dynamics& dynamics, const Mat3& R_HB, double com_height);
  /// What the state of this instant is; kNone where the robot walks.
  Fall check(const Dynamics& dynamics, const GaitOutput& gait) const;

 private:
  double height_share_, tilt_, foot_tilt_;
  double com_height_ = 0.0;
  Mat3 R_HB_ = Mat3::Identity();                          // trunk in the heading frame at the start
  std::array<Vec3, 2> up_{Vec3::UnitZ(), Vec3::UnitZ()};  // normals of the soles at the start
};

}  // namespace zmpwalk
