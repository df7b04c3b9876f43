#pragma once

#include <vector>

#include "zmpwalk/gait/schedule.hpp"
#include "zmpwalk/gait/velocity_profile.hpp"
#include "zmpwalk/math/types.hpp"
#include "zmpwalk/settings/settings.hpp"

namespace zmpwalk {

/// A place for a foot: sole centre in the horizontal plane and heading (x, y [m], yaw [rad]) in W.
struct Foothold {
  Vec2 p = Vec2::Zero();
  double yaw = 0.0;
};

/// Unit vectors of a heading `yaw` [rad].
Vec2 ahead_of(double yaw);
Vec2 left_of(double yaw);

/// Size of a sole [m].
struct SoleSize {
  double length = 0.0, width = 0.0;
};

/// Where the swing foot goes: one plan for COM and feet.
///
/// A path runs from the start with the planned velocity; a foot lands half its stance's travel ahead, half a width beside it, along
/// the path's heading there. Lengths are leads over the stance foot: a list of the user's or the paper's, or from the profile.
/// Along the heading, the anchor is the measured stance foot ("paper", "printed", "list"), the plan itself ("absolute"), or the
/// COM ("tied"): x_T = x + L/2 - com_lead + T_c (v - v_s), for the state x, v that the pendulum, its ZMP inside the bounds, will have in
/// the middle of the next double support, and the steady walk's v_s there: that walk then begins with its own DCM. Of the last term what is
/// within `foothold_give` of the bounds is left to the ZMP. Clamped about the nominal foothold and low-passed, until `foothold_freeze` of
/// the single support. Sideways it is the path, and what the DCM will be off its orbit. Feet never come closer than the soles' corners and
/// `foot_clearance` allow.
class FootstepPlanner {
 public:
  /// @param settings resolved   @param plan must outlive the planner   @param sole the larger of both
  FootstepPlanner(const WalkSettings& settings, const VelocityProfile& plan, const SoleSize& sole);

  /// @param feet  sole centres at the start, left and right; @param heading of the start [rad]
  void reset(const std::array<Foothold, 2>& feet, double heading);
  /// A walk begins again between `feet`, along the heading that the path has.
  void restart(const std::array<Foothold, 2>& feet);
  /// Moves the path on to time `t` [s]; where footholds are tied to the COM, the path goes along with `com` (2,) [m].
  void advance(double t, const Vec2& com);

  double heading() const { return path_.yaw; }  ///< of the path [rad]

  /// Lead of step `n` over the stance foot [m], where the double support after it is centred at `t_mid` [s].
  double lead(int n, double t_mid, double period) const;
  /// Where the plan has foot `swing` after a double support centred at `t_mid` [s].
  Foothold planned(Side swing, double t_mid, double period) const;
  /// Lateral displacement of the path in the period after `t_mid` [m].
  double drift(double t_mid, double period) const { return plan_->displacement(t_mid, t_mid + period).y(); }
  /// Lateral distance of feet in an orbit that drifts by `drift` a step [m]: the narrower step has step_width.
  double width(double drift) const { return settings_.steps.width + std::abs(drift); }

  /// Nominal foothold of step n, taken when the foot lifts. @param stance measured stance foot
  Foothold begin_step(int n, Side swing, const Foothold& stance, double t_mid, double period);
  /// The last step before a stand: beside the stance foot, where that is near enough to the path and to where the DCM will be, `xi`
  /// ahead of the stance foot [m]. Returns whether it is.
  bool close(Side swing, const Foothold& stance, double xi);

  /// Foothold for this cycle, tied to the COM where that is the setting.
  ///
  /// @param ahead_of_plan, aside  what the DCM will miss, along the heading and along the left [m]
  /// @param t_mid  middle of the next double support [s]   @param share of the single support that has gone by
  const Foothold& update(double ahead_of_plan, double aside, double t_mid, double period, double share, double dt);

  const Foothold& target() const { return target_; }
  /// How far the foot is from below its hip that is farther, as a double support, with its middle at `t_mid` and `T_ds` long, begins
  /// (foot `side`, which lands) or ends (the one that lifts) [m]. @param sway speed of the COM from foot to foot there [m/s]
  double stretch(const Foothold& landed, Side side, const Foothold& lifting, double t_mid, double T_ds,
                 double sway) const;

  /// Largest difference between the speed of the feet and the planned one in the steps of `duration` [s] -> [m/s]; 0 where the profile
  /// sets the steps.
  double mismatch(double duration, const Cadence& cadence) const;

 private:
  /// Moves `place` away from `stance` until the soles keep clear of each other.
  Foothold clear(Foothold place, Side swing, const Foothold& stance) const;

  WalkSettings settings_;
  const VelocityProfile* plan_;
  SoleSize sole_;
  double t_ = 0.0;
  Foothold path_;                    // middle of the walk now
  std::array<Foothold, 2> planned_;  // where the plan has the feet, for "absolute"
  Foothold nominal_, target_, stance_;
  Side swing_ = kLeft;
  bool closing_ = false;
};

}  // namespace zmpwalk
