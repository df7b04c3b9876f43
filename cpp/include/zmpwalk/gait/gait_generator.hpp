#pragma once

#include "zmpwalk/gait/footsteps.hpp"
#include "zmpwalk/gait/forward_orbit.hpp"
#include "zmpwalk/gait/lateral_motion.hpp"
#include "zmpwalk/gait/pendulum.hpp"
#include "zmpwalk/gait/schedule.hpp"
#include "zmpwalk/gait/step_adjustment.hpp"
#include "zmpwalk/gait/swing_foot.hpp"
#include "zmpwalk/gait/velocity_profile.hpp"
#include "zmpwalk/gait/velocity_tracker.hpp"
#include "zmpwalk/settings/settings.hpp"
#include "zmpwalk/zmp/bounds.hpp"

namespace zmpwalk {

/// What the gait needs to see of the robot.
struct GaitInput {
  double t = 0.0;                                                  ///< since the walk began [s]
  Vec2 com = Vec2::Zero(), dcom = Vec2::Zero();                    ///< "current" COM state of (16), (17), W [m, m/s]
  std::array<Vec3, 2> p_sole{Vec3::Zero(), Vec3::Zero()};          ///< sole centres, W [m]
  std::array<Mat3, 2> R_sole{Mat3::Identity(), Mat3::Identity()};  ///< sole orientations
  double catch_up = 0.0;  ///< speed beside the planned one that the tracker asks for [m/s]
  /// Height at which the swing sole meets the ground [m]; NaN: the stance sole's, which the load has sunk into a soft contact.
  double ground = kNaN;
  Vec2 contact = Vec2::Constant(kNaN);  ///< of each foot with the ground: 1 touching, 0 not, NaN unknown
};

/// What the gait asks for in one cycle.
struct GaitOutput {
  GaitPhase phase;
  bool at_rest = false;  ///< stands, and is not asked to walk
  Side support = kLeft;  ///< foot that carries the ZMP
  Side swing = kRight;   ///< foot of this step that swings, or will
  std::array<bool, 2> standing{true, true};
  Vec2 origin = Vec2::Zero();    ///< of the support frame S: support sole's centre, W [m]
  double yaw = 0.0;              ///< of S: the support sole's heading in W [rad]
  Vec2 ahead_S = Vec2::UnitX();  ///< x axis of S in W
  double heading = 0.0;          ///< of the walk, H: that of the path in W [rad]
  Vec2 ahead = Vec2::UnitX();    ///< x axis of H in W
  Vec3 v_plan = Vec3::Zero();    ///< planned velocity (v_x, v_y, w_z) in H
  ZmpBounds room;  ///< where the ZMP may be, in S: inside the support sole; sideways, two feet hold it all between them
  ForwardOrbit orbit;            ///< over the support foot, at the planned velocity
  double orbit_middle = 0.0;     ///< its middle, from `origin` along H's x [m]
  double dv_capture = 0.0;       ///< speed beside the orbit's that leaves the DCM where the next step catches it [m/s]
  double orbit_ahead = 0.0;      ///< how far that orbit has the COM ahead of steady motion now [m]
  double zmp_lateral = 0.0;      ///< reference ZMP about `origin` along H's y [m]
  Vec2 zmp_rest = Vec2::Zero();  ///< at rest: reference ZMP, W [m]
  double w_T = kNaN;             ///< Eq. 18 in double support before the switch [m/s], else NaN
  Foothold foothold;             ///< of the swing foot; NaN in double support
  double stretch = 0.0;  ///< how far an ankle will be from below its hip around this double support, or the next [m]
  SwingTarget swing_target;  ///< meaningful in single support
};

/// Reference ZMP of the smooth law for the COM state `com`, `dcom`, W (2,) [m]: along H's x what `tracker` asks of the pendulum, along
/// its y what the lateral motion asks; at rest, what keeps the COM in the middle.
Vec2 reference_zmp(const GaitOutput& gait, const LinearInvertedPendulum& pendulum, const VelocityTracker& tracker,
                   const Vec2& com, const Vec2& dcom);

/// The gait: phases, support switch, footholds and swing foot, from time and the COM. Knows no torque and no simulator.
///
/// It walks while the plan moves and stands, feet side by side, while it does not.
class GaitGenerator {
 public:
  /// @param settings resolved   @param profile planned velocity; what changes too fast is limited   @param sole the larger of both
  /// @param bounds of the ZMP, of each sole, in its axes   @param whole  the same when the robot has been pushed
  GaitGenerator(const WalkSettings& settings, const VelocityProfile& profile, const SoleSize& sole,
                const std::array<ZmpBounds, 2>& bounds, const std::array<ZmpBounds, 2>& whole);
  /// The same where `bounds` are all that there is.
  GaitGenerator(const WalkSettings& settings, const VelocityProfile& profile, const SoleSize& sole,
                const std::array<ZmpBounds, 2>& bounds)
      : GaitGenerator(settings, profile, sole, bounds, bounds) {}
  GaitGenerator(const GaitGenerator&) = delete;
  GaitGenerator& operator=(const GaitGenerator&) = delete;

  /// Starts a walk from two standing feet. @param pendulum of this robot
  void reset(const GaitInput& start, const LinearInvertedPendulum& pendulum);
  /// The COM has come to another height.
  void set_pendulum(const LinearInvertedPendulum& pendulum) { pendulum_ = pendulum; }
  /// From the next cycle on towards `velocity` (v_x, v_y, w_z), whatever the profile says. Allocates nothing.
  void command(const Vec3& velocity);
  /// The phase under way at the last cycle ends `remaining` [s] after that cycle, whatever it was to take; a stand is no phase. The swing
  /// foot goes on without a jump. Allocates nothing. @throws InputError  `remaining` is not finite and > 0
  void retime(double remaining);
  /// One cycle. Allocates nothing.
  const GaitOutput& update(const GaitInput& in);
  /// The same without the swing foot's path, for a plan: `swing_target` keeps what it was. Allocates nothing.
  const GaitOutput& update_steps(const GaitInput& in);

  const GaitOutput& output() const { return out_; }  ///< of the last cycle
  const VelocityProfile& plan() const { return plan_; }
  const Schedule& schedule() const { return schedule_; }
  const FootstepPlanner& footsteps() const { return footsteps_; }
  const Cadence& cadence() const { return cadence_; }

 private:
  StepTimes times_at(double t) const;  // of a step that begins at t
  void take_command(double t);
  enum class Began { kNothing, kStand, kDoubleSupport, kSingleSupport };
  Began begin_phase(const GaitInput& in);  // what begins with this cycle
  void begin_walk(const GaitInput& in);
  bool has_landed(const GaitInput& in);
  void move_swing_foot(const GaitInput& in);
  void move_ahead(const GaitInput& in);
  void move_sideways(const GaitInput& in);
  ZmpBounds room(const GaitInput& in, const std::array<ZmpBounds, 2>& bounds, const ZmpBounds& support) const;
  ZmpBounds sole_room(const Vec3& velocity) const;  // of the support foot alone
  /// How far the DCM has left the plan: 0 as planned, 1 where the ZMP is to use the whole sole.
  double urgency(const GaitInput& in) const;
  void widen_room(const GaitInput& in);
  void adjust_time(const GaitInput& in);
  /// Over the support foot. The ZMP may roll as far as the sole goes on its longer side; `end`: as it does at the end of a stance.
  void take_orbit(ForwardOrbit& orbit, const ZmpBounds& sole, double v, double period, bool end = false) const;
  void capture(const GaitInput& in, double time);
  /// How much further than planned the next foot has to stand, so that the steady walk begins there [m].
  double ahead_of_plan(const GaitInput& in) const;
  double stretch(const GaitInput& in);
  /// In double support, while the foot that swung last has not taken over.
  bool before_switch() const { return out_.phase.phase == Phase::kDoubleSupport && lateral_.awaits_switch(); }
  double across(const Vec3& p) const { return (p.head<2>() - out_.origin).dot(left_of(out_.ahead)); }
  bool can_stand(const GaitInput& in) const;  // the DCM is inside the bounds of the feet, which stand side by side

  WalkSettings settings_;
  Cadence cadence_;
  VelocityLimits limits_;
  VelocityProfile profile_, plan_;
  Schedule schedule_;
  FootstepPlanner footsteps_;
  LateralMotion lateral_;
  SwingFoot swing_foot_;
  LinearInvertedPendulum pendulum_;
  std::array<ZmpBounds, 2> bounds_, whole_;
  StepAdjustment adjustment_;
  double planned_landing_ = 0.0;  // of the foot in the air, before any adjustment [s]
  double xi_planned_ = 0.0;       // lateral DCM now on the orbit, along H's y [m]
  double xi_offset_ = 0.0;        // lateral DCM from the next foot when it takes over, on the orbit [m]
  GaitOutput out_;
  ZmpBounds sole_room_;      // of the support foot at the planned velocity
  PlannedStance next_;       // of the next foot to take over: the one that swings, or one that has landed
  ForwardOrbit next_orbit_;  // over that foot
  double sway_ = 0.0, sway_period_ = 0.0, sway_Tc_ = 0.0;  // tanh(T / 2 T_c), and for which T and T_c
  double orbit_period_ = 0.0, orbit_Tc_ = 0.0;
  LinearInvertedPendulum::Growth orbit_growth_;  // of the DCM in `period_`, and for which T and T_c
  // Speed and DCM in the middle of the next double support, from the support foot along the heading [m/s, m]; and as the steady walk over
  // the next foot has them then, from that foot.
  double v_next_ = 0.0, xi_next_ = 0.0, v_start_ = 0.0, xi_start_ = 0.0;
  Began began_ = Began::kNothing;  // with this cycle
  enum class Swing {
    kLifting,   // it has not been felt off the ground
    kAirborne,  // it has
    kOverdue    // it met no ground where it should have, and goes on down
  };
  Swing swing_ = Swing::kLifting;
  std::array<bool, 2> felt_{false, false};  // the foot's contact has been measured in this walk
  double period_ = 0.0;                     // of the step after this [s]
  Vec3 command_, allowance_;
  bool commanded_ = false;
  double t_command_ = 0.0;
};

}  // namespace zmpwalk
