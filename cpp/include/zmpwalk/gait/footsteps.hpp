#pragma once

#include <vector>

#include "zmpwalk/gait/velocity_profile.hpp"
#include "zmpwalk/math/types.hpp"
#include "zmpwalk/settings.hpp"

namespace zmpwalk {

/// A place for a foot: sole centre in the horizontal plane and heading (x, y [m], yaw [rad]) in W.
struct Foothold {
  Vec2 p = Vec2::Zero();
  double yaw = 0.0;
};

/// Where the swing foot goes.
///
/// Lengths are leads over the stance foot: a list of the user's or the paper's, or from the profile (planned displacement over
/// the coming period). Anchors are the measured stance foot ("paper", "printed", "list"), the plan itself ("absolute"), or the
/// COM ("tied"): x_T = x + planned displacement until the middle of the next double support + T_c (v - v_plan) + L/2 - com_lead, clamped about
/// the nominal foothold and low-passed, until `foothold_freeze` of the single support.
class FootstepPlanner {
 public:
  /// @param settings resolved   @param profile must outlive the planner
  FootstepPlanner(const WalkSettings& settings, const VelocityProfile& profile);

  /// @param feet  sole centres at the start, left and right; @param heading of the start [rad]
  void reset(const std::array<Foothold, 2>& feet, double heading);

  /// Lead of step `n` over the stance foot [m], for a walk whose next double support is centred at `t_mid` [s].
  double lead(int n, double t_mid, double period) const;

  /// Nominal foothold of step n, taken when the foot lifts. @param stance measured stance foot
  Foothold begin_step(int n, Side swing, const Foothold& stance, double t_mid, double period);

  /// Foothold for this cycle, tied to the COM where that is the setting.
  ///
  /// @param com, dcom  COM in the horizontal plane, W   @param t time [s]   @param share of the single support that has gone by
  const Foothold& update(const Vec2& com, const Vec2& dcom, double t, double t_mid, double period, double Tc,
                         double share, double dt);

  const Foothold& target() const { return target_; }

  /// Largest difference between the speed of the feet and the planned one over `steps` steps [m/s]; 0 where the profile sets the steps.
  double mismatch(int steps, double period) const;

 private:
  WalkSettings settings_;
  const VelocityProfile* profile_;
  double heading_ = 0.0;
  Vec2 origin_ = Vec2::Zero();       // middle of the feet at the start
  std::array<Foothold, 2> planned_;  // where the plan has the feet, for "absolute"
  Foothold nominal_, target_;
};

}  // namespace zmpwalk
