#pragma once

#include <cmath>
#include <vector>

#include "zmpwalk/gait/schedule.hpp"
#include "zmpwalk/gait/velocity_profile.hpp"
#include "zmpwalk/math/types.hpp"
#include "zmpwalk/settings/settings.hpp"

namespace zmpwalk {

/// Unit vectors of a heading `yaw` [rad].
inline Vec2 ahead_of(double yaw) { return {std::cos(yaw), std::sin(yaw)}; }
inline Vec2 left_of(double yaw) { return {-std::sin(yaw), std::cos(yaw)}; }
/// The unit vector to the left of the unit vector `ahead`.
inline Vec2 left_of(const Vec2& ahead) { return {-ahead.y(), ahead.x()}; }
/// The axes of a frame whose x axis is the unit vector `ahead`: p_W = axes p (2, 2).
inline Mat2 axes_of(const Vec2& ahead) { return (Mat2() << ahead.x(), -ahead.y(), ahead.y(), ahead.x()).finished(); }

/// A place for a foot: sole centre in the horizontal plane and heading (x, y [m], yaw [rad]) in W.
struct Foothold {
  Vec2 p = Vec2::Zero();
  double yaw = 0.0;
};

/// The same with the unit vector of its heading, which is computed once.
struct PathPoint : Foothold {
  PathPoint() = default;
  explicit PathPoint(const Foothold& at) : Foothold(at), ahead(ahead_of(at.yaw)) {}

  Vec2 left() const { return left_of(ahead); }
  /// The point that `travel` (x, y, yaw) leads to from here.
  PathPoint moved(const Vec3& travel) const {
    PathPoint out = *this;
    out.p = p + travel.x() * ahead + travel.y() * left();
    out.yaw += travel.z();
    if (travel.z() != 0.0) out.ahead = ahead_of(out.yaw);
    return out;
  }
  /// The point `y` to the left of here [m].
  PathPoint beside(double y) const { return moved({0.0, y, 0.0}); }

  Vec2 ahead = Vec2::UnitX();
};

/// Size of a sole [m].
struct SoleSize {
  double length = 0.0, width = 0.0;
};

/// What the plan has around one double support, whose middle it is, and in the period after it.
struct PlannedStance {
  double period = 0.0;               ///< [s]
  VelocityProfile::Moment mid, end;  ///< of the plan: in the middle of the double support, and a period later
  PathPoint path;                    ///< middle of the walk at `mid`

  double t_mid() const { return mid.t; }  ///< [s]
  Vec3 displacement() const {
    return end.integral - mid.integral;
  }  ///< in the period, along the heading (3,) [m, m, rad]
  double drift() const { return displacement().y(); }  ///< lateral displacement of the path [m]
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
  /// The plan has changed from now on.
  void replan() { now_ = plan_->at(now_.t); }

  const PathPoint& path() const { return path_; }              ///< middle of the walk now
  double heading() const { return path_.yaw; }                 ///< of the path [rad]
  const VelocityProfile::Moment& now() const { return now_; }  ///< of the plan

  /// What the plan has around a double support with its middle at `t_mid` [s], and in the `period` [s] after it.
  PlannedStance stance_at(double t_mid, double period) const;

  /// Lead of step `n` over the stance foot, where the double support after it is that of `next` [m].
  double lead(int n, const PlannedStance& next) const;
  /// Where the plan has foot `swing` when it is the one that stands in the period of `next`.
  PathPoint planned(Side swing, const PlannedStance& next) const;
  /// Lateral distance of feet in an orbit that drifts by `drift` a step [m]: the narrower step has step_width.
  double width(double drift) const { return settings_.steps.width + std::abs(drift); }

  /// Nominal foothold of step n, taken when the foot lifts. @param stance measured stance foot
  Foothold begin_step(int n, Side swing, const Foothold& stance, const PlannedStance& next);
  /// The last step before a stand: beside the stance foot, where that is near enough to the path and to where the DCM will be, `xi`
  /// ahead of the stance foot [m].
  void close(Side swing, const Foothold& stance, double xi);
  bool closing() const { return closing_; }  ///< this step is the last before a stand
  /// The foot has landed.
  void end_step() { closing_ = false; }

  /// Whether the foothold still follows the COM: tied to it, after this share of the single support.
  bool follows(double share) const {
    return !closing_ && settings_.steps.mode == Footsteps::kTied && share <= settings_.steps.freeze;
  }
  /// Foothold for this cycle, where it `follows` the COM.
  ///
  /// @param ahead_of_plan, aside  what the DCM will miss, along the heading and along the left [m]
  /// @param planned  where the plan has this foot
  const Foothold& follow(double ahead_of_plan, double aside, const PathPoint& planned);

  const Foothold& target() const { return target_; }
  /// How far the foot is from below its hip that is farther, as a double support, with its middle as in `at` and `T_ds` long, begins
  /// (foot `side`, which lands) or ends (the one that lifts) [m].
  /// @param landed, lifting sole centres, W   @param sway speed of the COM from foot to foot there [m/s]
  double stretch(const Vec2& landed, Side side, const Vec2& lifting, const PlannedStance& at, double T_ds,
                 double sway) const;

  /// Largest difference between the speed of the feet and the planned one in the steps of `duration` [s] -> [m/s]; 0 where the profile
  /// sets the steps.
  double mismatch(double duration, const Cadence& cadence) const;

 private:
  /// Moves `place` away from the stance foot until the soles keep clear of each other.
  Vec2 clear(const Foothold& place) const;

  WalkSettings settings_;
  const VelocityProfile* plan_;
  SoleSize sole_;
  double blend_;  // of the target's low-pass, a cycle
  VelocityProfile::Moment now_;
  PathPoint path_;                   // middle of the walk now
  std::array<Foothold, 2> planned_;  // where the plan has the feet, for "absolute"
  Foothold nominal_, target_;
  PathPoint stance_;
  Side swing_ = kLeft;
  bool closing_ = false;
};

}  // namespace zmpwalk
