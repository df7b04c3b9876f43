#pragma once

#include "zmpwalk/gait/lateral_law.hpp"
#include "zmpwalk/gait/pendulum.hpp"
#include "zmpwalk/gait/schedule.hpp"
#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// Lateral motion, III-D: swing between the feet, switch support at the right instant.
///
/// A `LateralLaw` decides where the reference ZMP is, and when to switch. The switch rule alone is neutrally stable: an error in the start
/// never decays. The law "orbit" (an addition to the paper) shifts the reference ZMP by r_y so that the DCM arrives where the symmetric
/// orbit has it in the middle of the next double support; r_y is zero on that orbit.
class LateralMotion {
 public:
  /// @param most  largest |r_y| [m]
  LateralMotion(LateralLawName law, double most);

  /// @param support  foot that carries the ZMP at first: the one that swings first
  void reset(Side support);

  /// Decides, in double support and before the switch, whether the next cycle switches.
  ///
  /// @param now        lateral COM state about the support's sole centre [m, m/s]   @param r  reference ZMP there [m]
  /// @param other_foot sole centre of the foot to come, seen from the support's [m]
  /// @param T          from now to the middle of the next single support [s]        @param dt control period [s]
  /// @param w_orbit    velocity that the orbit has there [m/s]; 0 in the paper, whose orbit does not drift
  /// @param time_left  of the double support [s]; where it ends with this cycle the next one switches, whatever the law says
  /// @return           w(T), eq. 18, for a switch in the next cycle [m/s]
  double check_switch(const LinearInvertedPendulum& pendulum, const PendulumState& now, double r, double other_foot,
                      double T, double w_orbit, double dt, double time_left);

  /// Takes a switch that was decided in the previous cycle; call first in each cycle.
  void begin_cycle(bool double_support_began);
  /// The double support is over: a switch that is still due is taken at once.
  void end_double_support();

  /// Reference ZMP about the support's sole centre [m].
  double reference(const Sway& sway) const;

  /// By how much the DCM will miss `sway.xi_end`, because |r_y| is bounded [m].
  double miss(const Sway& sway) const;

  Side support() const { return support_; }
  /// True in double support until the switch.
  bool awaits_switch() const { return switch_ != Switch::kTaken; }

 private:
  enum class Switch {
    kDue,      // the foot that will swing still carries the ZMP
    kDecided,  // it does so for the last cycle
    kTaken     // the foot that stands carries it
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
