#pragma once

#include <array>
#include <string>

#include "zmpwalk/control/whole_body.hpp"
#include "zmpwalk/gait/footsteps.hpp"
#include "zmpwalk/gait/schedule.hpp"
#include "zmpwalk/robot/robot.hpp"
#include "zmpwalk/settings/settings.hpp"
#include "zmpwalk/walk/leg_reach.hpp"
#include "zmpwalk/walk/record.hpp"
#include "zmpwalk/zmp/bounds.hpp"

namespace zmpwalk {

/// The largest velocity along one axis, and what limits it.
struct AxisLimit {
  double most = 0.0;  ///< [m/s or rad/s]
  SpeedLimit limit = SpeedLimit::kNone;
  std::string joint;  ///< whose torque limits it; empty where none does
};

/// Which velocities the robot can walk: within the reach of its legs, the torques of its joints, and the friction under its soles.
///
/// When it is made, it computes postures, torques and the contact wrench of the instants of a steady step that ask most, for velocities along each axis:
/// lift-off and landing, when the leg is thrown and caught and the ZMP is at the end of the sole, and the middle of the swing, when the joints are fastest. The
/// posture comes from COM and soles by inverse kinematics, the torques from (1)-(7). A velocity (v_x, v_y, w_z) is possible where
///     |v_x| / most_x + |v_y| / most_y + |w_z| / most_z <= 1,  and within reach.
class CommandLimit {
 public:
  /// @param settings resolved   @param bounds of the ZMP in the sole   @param z_c height of the COM over the soles [m]
  CommandLimit(const Robot& robot, const WalkSettings& settings, const Cadence& cadence, const LegReach& reach,
               const SoleSize& sole, const ZmpBounds& bounds, double z_c);

  /// `velocity`, made smaller until it is possible. `limit`, if given, gets what bites. Allocates nothing.
  Vec3 within(const Vec3& velocity, SpeedLimit* limit = nullptr) const;
  /// @throws InputError  a knot of `profile` asks for more; the message gives that velocity, the fastest possible one, and what limits it
  void require_within(const VelocityProfile& profile) const;

  bool on() const { return on_; }
  /// Forward, backward, sideways, turning.
  const std::array<AxisLimit, 4>& axes() const { return axes_; }

 private:
  const AxisLimit& axis(int i, double v) const { return axes_[i == 0 ? (v < 0.0) : i + 1]; }
  double share(const Vec3& velocity) const;  // the sum above

  bool on_;
  LegReach reach_;
  std::array<AxisLimit, 4> axes_;
};

/// "torque of l_knee", "friction against sliding": what limits, in words.
std::string to_string(const AxisLimit& axis);

}  // namespace zmpwalk
