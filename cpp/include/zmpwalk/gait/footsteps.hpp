#pragma once

#include <vector>

#include "zmpwalk/gait/foothold.hpp"
#include "zmpwalk/gait/known_ground.hpp"
#include "zmpwalk/gait/schedule.hpp"
#include "zmpwalk/gait/velocity_profile.hpp"
#include "zmpwalk/math/types.hpp"
#include "zmpwalk/settings/settings.hpp"

namespace zmpwalk {

/// A place with a heading, such as a point of the path, and the unit vector along that heading, which is computed once.
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

/// The plan around one stance: in the middle of the double support in which the foot takes over, and in the step period after it.
struct PlannedStance {
  double period = 0.0;               ///< step period after the double support [s]
  VelocityProfile::Moment mid, end;  ///< the plan in the middle of the double support, and one period later
  PathPoint path;                    ///< point of the path at `mid`

  double t_mid() const { return mid.t; }  ///< time of the middle of the double support [s]
  /// Displacement of the plan in the period, along the heading (3,) [m, m, rad].
  Vec3 displacement() const { return end.integral - mid.integral; }
  double drift() const { return displacement().y(); }  ///< lateral displacement of the path [m]
};

/// Where the foot in the air can still land.
struct LandingRoom {
  Vec2 foot = Vec2::Zero();  ///< where it comes by itself in the time left, W [m]
  Vec2 way = Vec2::Zero();   ///< how far from there it can be moved in that time, ahead and aside (2,) [m]
};

/// Decides where the swing foot lands, from the same plan that moves the COM.
///
/// The path begins where the walk begins and follows the planned velocity. In the plan, a foot lands ahead of the path by half the way that the path
/// goes while the foot stands, half a step width beside it, with the path's heading there. How far each step lands ahead of the stance foot (its
/// lead) comes from the plan, or from a list: the user's or the paper's.
///
/// `Footsteps` says from what that place is measured along the heading:
/// - from the measured stance foot ("paper", "printed", "list");
/// - from the plan itself ("absolute");
/// - from the COM ("tied"): x_T = x + L/2 - com_lead + T_c (v - v_s), with L the planned way in a period. x and v are where the pendulum, its ZMP inside
///   the bounds, will be in the middle of the next double support, and v_s is the velocity of the forward orbit there. So the orbit over the new foot
///   begins with just the DCM (COM + T_c times its velocity) that it needs. The part of the last term that a ZMP within `foothold_give` of the
///   bounds can make up for is left to the ZMP.
///
/// A tied foothold is kept near its nominal place and low-passed, and stays where it is after the share `foothold_freeze` of the single support. Sideways a
/// foot lands beside the path, shifted by what the DCM will be off its orbit. Feet never come closer to each other than the corners of the soles and
/// `foot_clearance` allow.
class FootstepPlanner {
 public:
  /// After a push, a step may be this times the planned one where the plan goes as far as the leg is said to reach.
  static constexpr double kLonger = 1.15;

  /// @param settings resolved   @param plan planned velocity; it must outlive the planner   @param sole size that both soles are taken to have
  FootstepPlanner(const WalkSettings& settings, const VelocityProfile& plan, const SoleSize& sole);

  /// From now on feet are set on good places of `ground`, which must outlive the planner; null: nothing is known of the ground.
  void know(const KnownGround* ground) { ground_ = ground; }
  /// The ground under the present target; meaningless where nothing is known.
  const SolePlace& place() const { return place_; }
  /// The good place nearest to `wanted` (`KnownGround::nearest`), for this robot's soles and the margin that they keep from edges.
  SolePlace nearest(const Foothold& wanted, const SolePlace* like = nullptr) const;

  /// Begins a walk. @param feet  sole centres at the start, left and right   @param heading of the path there [rad]
  void reset(const std::array<Foothold, 2>& feet, double heading);
  /// A robot that stood walks on from between `feet`, along the heading that the path has.
  void restart(const std::array<Foothold, 2>& feet);
  /// Moves the path on to time `t` [s]; where footholds are tied to the COM, the path goes along with `com` (2,) [m].
  void advance(double t, const Vec2& com);
  /// Notes that the plan has changed from now on.
  void replan() { now_ = plan_->at(now_.t); }

  const PathPoint& path() const { return path_; }              ///< point of the path now
  double heading() const { return path_.yaw; }                 ///< heading of the path in W [rad]
  const VelocityProfile::Moment& now() const { return now_; }  ///< the plan at the present time

  /// The plan around a double support with its middle at `t_mid` [s], and in the `period` [s] after it.
  PlannedStance stance_at(double t_mid, double period) const;
  /// Steps are to be longer than the plan's by `speed` times their period [m/s].
  void hurry(double speed) { hurried_ = speed; }
  double hurried() const { return hurried_; }

  /// How far step `n` lands ahead of the stance foot, where the double support after it is that of `next` [m].
  double lead(int n, const PlannedStance& next) const;
  /// Where the plan puts the foot `swing` for the period of `next`, in which it stands.
  PathPoint planned(Side swing, const PlannedStance& next) const;
  /// Lateral distance between the feet, where the path goes sideways by `drift` in each step [m]: the narrower one of two steps has step_width.
  double width(double drift) const { return settings_.steps.width + std::abs(drift); }

  /// Chooses the nominal foothold of step n, when the foot lifts. @param stance measured place of the stance foot
  /// @param place  good place of known ground where it is to be; null where the plan says it
  Foothold begin_step(int n, Side swing, const Foothold& stance, const PlannedStance& next,
                      const SolePlace* place = nullptr);
  /// Makes this step the closing step, which sets the foot beside the stance foot so that the robot can stand. It does so only where that place is
  /// near enough to the path and to where the DCM will be, `xi` ahead of the stance foot [m].
  void close(Side swing, const Foothold& stance, double xi);
  bool closing() const { return closing_; }  ///< true where this step is the closing step
  /// Notes that the foot has landed.
  void end_step() { closing_ = false; }

  /// True where the foothold still follows the COM after this share of the single support: it is tied, not frozen yet, and no closing step.
  bool follows(double share) const {
    return !closing_ && settings_.steps.mode == Footsteps::kTied && share <= settings_.steps.freeze;
  }
  /// How far from its nominal place, ahead and to the left [m], a foothold that `follows` the COM has to land to catch the DCM.
  ///
  /// @param ahead_of_plan, aside  the same from its planned place [m]   @param planned  where the plan puts this foot
  Vec2 off_nominal(double ahead_of_plan, double aside, const PathPoint& planned) const;
  /// Moves that foothold there, and returns it.
  ///
  /// @param off  see `off_nominal`   @param ahead, beside  what the foot in the air can reach bounds, with the reach of the leg, how far it moves along
  /// the plan or across it; null where it need not
  const Foothold& follow(const Vec2& off, const PathPoint& planned, const LandingRoom* ahead = nullptr,
                         const LandingRoom* beside = nullptr);

  const Foothold& target() const { return target_; }
  /// Distance along the ground of an ankle from the point below its hip: the larger one of the foot `side` as it lands and of the other foot as it
  /// lifts [m]. The double support in between is `T_ds` [s] long and has its middle as in `at`.
  /// @param landed, lifting sole centres of both feet, W   @param sway sideways speed of the COM there [m/s]
  double stretch(const Vec2& landed, Side side, const Vec2& lifting, const PlannedStance& at, double T_ds,
                 double sway) const;

  /// Largest difference between the speed of the feet and the planned one in the steps of `duration` [s] -> [m/s]; 0 where the plan sets the
  /// lengths of the steps.
  double mismatch(double duration, const Cadence& cadence) const;

 private:
  /// Moves `place` away from the stance foot until the soles keep clear of each other.
  Vec2 clear(const Foothold& place) const;

  WalkSettings settings_;
  const VelocityProfile* plan_;
  SoleSize sole_;
  double blend_;  // share of its distance that the low-pass moves a foothold in one cycle
  VelocityProfile::Moment now_;
  PathPoint path_;                   // point of the path now
  std::array<Foothold, 2> planned_;  // where the plan puts the feet, for "absolute"
  Foothold nominal_, target_;
  const KnownGround* ground_ = nullptr;
  SolePlace place_, nominal_place_;
  PathPoint stance_;
  Side swing_ = kLeft;
  bool closing_ = false;
  double hurried_ = 0.0;
};

}  // namespace zmpwalk
