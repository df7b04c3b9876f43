#pragma once

#include "zmpwalk/gait/schedule.hpp"
#include "zmpwalk/gait/velocity_profile.hpp"
#include "zmpwalk/robot/robot.hpp"
#include "zmpwalk/settings/settings.hpp"

namespace zmpwalk {

/// The reach of the legs: which velocities they can walk, and how far the COM must come down for a stride.
///
/// A knee bends by at least `least_knee`, so that the longest leg has l^2 = thigh^2 + shank^2 + 2 thigh shank cos(least_knee). With the hip
/// h over the ankle, the ankle can be sqrt(l^2 - h^2) ahead of or behind its hip. From that is taken how far the ankle is ahead of the hip
/// in the start pose already.
class LegReach {
 public:
  /// @param settings resolved   @param cadence how long steps take at a velocity
  LegReach(const Robot& robot, const WalkSettings& settings, const Cadence& cadence);

  /// Longest distance, along the ground, of an ankle from the point below its hip when the COM is lowered by `crouch` [m] -> [m].
  double along_ground(double crouch) const;
  /// Distance, along the ground, to which walking with `velocity` (v_x, v_y, w_z), H, takes an ankle from the point below its hip [m].
  ///
  /// In double support an ankle is v_x (T + T_ds)/2 ahead of or behind its hip, and at most |v_y| T beside it; T and T_ds are the
  /// cadence's for that velocity.
  double stride(const Vec3& velocity) const;
  /// How far the COM has to come down for a stride [m] -> [m], at most `crouch_limit`.
  /// @param lift  how much further up than on level ground the hip is from the lower foot [m]
  double crouch_for(double stride, double lift = 0.0) const;

  /// Share of the reach that walking with `velocity` uses. At 1 a knee is as straight as `least_knee` allows, or a hip is turned to its limit.
  double share(const Vec3& velocity) const;
  /// `velocity`, made smaller until its `share` is at most 1.
  Vec3 within(const Vec3& velocity) const;
  /// Largest v_x within reach [m/s].
  double speed_limit() const { return within({kTooFast, 0.0, 0.0}).x(); }

  /// @throws InputError  a knot of `profile` is faster than the legs reach; the message gives that velocity and the fastest one in reach
  void require_within(const VelocityProfile& profile) const;

 private:
  static constexpr double kTooFast = 10.0;  // no biped's walk [m/s]

  std::array<RobotLeg, 2> leg_;
  double hip_turn_;  // of the hips about the vertical [rad]
  double least_knee_, crouch_limit_, crouch_margin_;
  Cadence cadence_;
};

/// "a m/s, b m/s, c rad/s": a velocity (v_x, v_y, w_z) in messages.
std::string velocity_text(const Vec3& velocity);

}  // namespace zmpwalk
