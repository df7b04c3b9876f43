#pragma once

#include "zmpwalk/gait/pendulum.hpp"
#include "zmpwalk/gait/velocity_profile.hpp"
#include "zmpwalk/settings/settings.hpp"
#include "zmpwalk/walk/leg_reach.hpp"

namespace zmpwalk {

/// Desired height of the COM over the ground, and the pendulum of that height.
///
/// The COM stands at z_c; long steps take longer legs, so that it comes down by a crouch c, critically damped towards what the stride
/// asks for: c'' = rate (rate (c_wanted - c) - 2 c'), rate = 1 / crouch_time. T_c = sqrt(z_c / g) follows the height, and the gravity that known
/// forces leave.
class ComHeight {
 public:
  /// @param z_c height over the soles [m]   @param gravity [m/s^2]   @param settings resolved
  ComHeight(double z_c, double gravity, const WalkSettings& settings);

  /// Starts anew, under no known force, at `z_c` over a ground at `ground` [m].
  void reset(double z_c, double ground);
  /// One cycle on, at time `t` of the walk [s]. Returns whether the height has changed.
  ///
  /// @param stretch  how far an ankle is to be from below its hip [m]   @param ahead  how early the COM comes down before a speed [s]
  bool update(double t, double stretch, const VelocityProfile& plan, const LegReach& reach, double ahead);

  /// The pendulum is under `gravity` [m/s^2] > 0 from now on (`forced_pendulum`). Returns whether that is another.
  bool weigh(double gravity);

  double z_c() const { return z_c_; }                    ///< over the soles, without crouch [m]
  double ground() const { return ground_; }              ///< height of the soles at the start, in W [m]
  double z() const { return ground_ + z_c_ - crouch_; }  ///< desired, in W [m]
  double dz() const { return -dcrouch_; }                ///< [m/s]
  double ddz() const { return -ddcrouch_; }              ///< [m/s^2]
  const LinearInvertedPendulum& pendulum() const { return pendulum_; }

 private:
  double free_gravity_, gravity_, dt_, rate_;
  double z_c_, ground_ = 0.0;
  double crouch_ = 0.0, dcrouch_ = 0.0, ddcrouch_ = 0.0;
  LinearInvertedPendulum pendulum_;
};

}  // namespace zmpwalk
