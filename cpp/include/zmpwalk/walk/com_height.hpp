#pragma once

#include "zmpwalk/gait/pendulum.hpp"
#include "zmpwalk/gait/velocity_profile.hpp"
#include "zmpwalk/settings/settings.hpp"
#include "zmpwalk/walk/leg_reach.hpp"

namespace zmpwalk {

/// Decides how high the COM is over the ground, and keeps the pendulum of that height.
///
/// A standing robot has its COM at z_c. Long steps need longer legs; for them the COM comes down by a crouch c, which approaches the wanted
/// one without overshoot: c'' = rate (rate (c_wanted - c) - 2 c') with rate = 1 / crouch_time. T_c = sqrt(z_c / g) follows the height, and the gravity that
/// known forces leave.
class ComHeight {
 public:
  /// @param z_c height over the soles [m]   @param gravity [m/s^2]   @param settings resolved
  ComHeight(double z_c, double gravity, const WalkSettings& settings);

  /// The walk starts anew, under no known force and without a crouch: `z_c` over the soles [m], which stand at the height `ground` in W [m].
  void reset(double z_c, double ground);
  /// Goes on by one cycle, at time `t` of the walk [s]. Returns whether the height has changed.
  ///
  /// @param stretch  distance, along the ground, of an ankle from below its hip that the present step needs [m]
  /// @param ahead    how long before the plan asks for a speed the COM begins to come down for it [s]
  /// @param lift     how much further up the hip is there than on level ground [m]
  bool update(double t, double stretch, const VelocityProfile& plan, const LegReach& reach, double ahead,
              double lift = 0.0);

  /// Puts the pendulum under `gravity` [m/s^2] > 0 from now on (`forced_pendulum`). Returns whether that has changed.
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
