#pragma once

#include "zmpwalk/gait/lateral_law.hpp"
#include "zmpwalk/gait/pendulum.hpp"
#include "zmpwalk/gait/schedule.hpp"
#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// Lateral motion, III-D: the COM sways between the feet, and the support switches from one foot to the other at the right instant.
///
/// A `LateralLaw` decides where the reference ZMP is, and when the support switches. The switch rule of the paper alone is neutrally stable: an
/// error at the start never decays. The law "orbit" (an addition to the paper) therefore shifts the reference ZMP by r_y, so that in the middle of the
/// next double support the DCM (COM + T_c times its velocity) is where the orbit that repeats has it. On that orbit r_y is zero. Positions
/// are along the y axis of H, from the support sole's centre.
class LateralMotion {
 public:
  /// @param most  largest |r_y| [m]
  LateralMotion(LateralLawName law, double most);

  /// @param support  foot that carries the ZMP at first: the one that swings first
  void reset(Side support);

  /// Decides, in double support before the switch, whether the support switches with the next cycle.
  ///
  /// @param now        lateral COM state about the support's sole centre [m, m/s]   @param r  reference ZMP there [m]
  /// @param other_foot sole centre of the foot that will carry the ZMP next, seen from the support's [m]
  /// @param T          time from now to the middle of the next single support [s]   @param dt control period [s]
  /// @param w_orbit    velocity that the orbit has at that time [m/s]; 0 in the paper, whose orbit does not drift
  /// @param time_left  time until the double support ends [s]; if it ends with this cycle, the next one switches whatever the law says
  /// @return           w(T), eq. 18, for a switch in the next cycle [m/s]
  double check_switch(const LinearInvertedPendulum& pendulum, const PendulumState& now, double r, double other_foot,
                      double T, double w_orbit, double dt, double time_left);

  /// Switches the support if the previous cycle decided so. Call it first in each cycle.
  void begin_cycle(bool double_support_began);
  /// Notes that the double support is over. A switch that is still due happens at once.
  void end_double_support();
  /// Lets the support switch with the next cycle, whatever the law says.
  void switch_now() { switch_ = Switch::kDecided; }

  /// Reference ZMP about the support's sole centre [m].
  double reference(const Sway& sway) const;

  /// How far the DCM will be from `sway.xi_end`, because |r_y| is bounded [m].
  double miss(const Sway& sway) const;

  Side support() const { return support_; }
  /// True in double support until the switch.
  bool awaits_switch() const { return switch_ != Switch::kTaken; }

 private:
  enum class Switch {
    kDue,      // the foot that will swing still carries the ZMP
    kDecided,  // the foot that will swing carries the ZMP for its last cycle
    kTaken     // the foot that will stand carries the ZMP
  };
  void take_switch();
  double wanted(const Sway& sway) const;  // reference ZMP without the bound

  const LateralLaw* law_;
  double most_;
  std::array<LastOver, 2> over_;  // one and two cycles
  Side support_ = kLeft;
  Switch switch_ = Switch::kDue;
};

}  // namespace zmpwalk
