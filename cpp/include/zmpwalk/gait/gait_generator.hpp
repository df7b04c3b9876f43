#pragma once

#include "zmpwalk/gait/footsteps.hpp"
#include "zmpwalk/gait/forward_orbit.hpp"
#include "zmpwalk/gait/known_ground.hpp"
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

/// What the gait needs to know of the robot in one cycle.
struct GaitInput {
  double t = 0.0;                                                  ///< time since the walk began [s]
  Vec2 com = Vec2::Zero(), dcom = Vec2::Zero();                    ///< "current" COM state of (16), (17), W [m, m/s]
  std::array<Vec3, 2> p_sole{Vec3::Zero(), Vec3::Zero()};          ///< sole centres, W [m]
  std::array<Mat3, 2> R_sole{Mat3::Identity(), Mat3::Identity()};  ///< sole orientations
  /// Velocity that the COM was to have now, W (2,) [m/s]: what it has beyond that, it got from a push. NaN where nothing is known of pushes.
  Vec2 dcom_expected = Vec2::Constant(kNaN);
  double behind = 0.0;    ///< how far the COM is behind the plan along the heading [m]
  double catch_up = 0.0;  ///< speed that the velocity tracker adds to the planned one to make up lost way [m/s]
  /// Height at which the swing sole meets the ground, W [m]. NaN takes the stance sole's height, which is lower where the load has sunk that sole
  /// into a soft contact.
  double ground = kNaN;
  Vec2 contact = Vec2::Constant(kNaN);  ///< whether each foot touches the ground: 1 yes, 0 no, NaN unknown
  bool uneven = false;                  ///< the ground has been felt to be uneven
  double pace = 1.0;                    ///< share of the wanted velocity to walk with, where feet slip
  double felt = 0.0;                    ///< how much higher than known ground is what is felt there [m]
};

/// The place of a sole with centre `p` and axes `R`.
Foothold foothold_of(const Vec3& p, const Mat3& R);
/// The places of both soles.
std::array<Foothold, 2> feet_of(const GaitInput& in);

/// What the gait asks for in one cycle.
///
/// The DCM is the divergent component of motion, COM + T_c times its velocity. The orbit is the steady walk over the support foot.
struct GaitOutput {
  GaitPhase phase;
  bool at_rest = false;  ///< the robot stands, and is not asked to walk
  Side support = kLeft;  ///< foot that carries the ZMP
  Side swing = kRight;   ///< foot that swings in this step, or will swing after its double support
  std::array<bool, 2> standing{true, true};
  Vec2 origin = Vec2::Zero();    ///< origin of the support frame S: the support sole's centre, W [m]
  double yaw = 0.0;              ///< heading of S: that of the support sole in W [rad]
  Vec2 ahead_S = Vec2::UnitX();  ///< x axis of S in W
  double heading = 0.0;          ///< heading of the frame H: that of the path in W [rad]
  Vec2 ahead = Vec2::UnitX();    ///< x axis of H in W
  Vec3 v_plan = Vec3::Zero();    ///< planned velocity (v_x, v_y, w_z) in H
  Vec2 ahead_M = Vec2::UnitX();  ///< x axis of M in W, which is H in the middle of the support foot's stance
  ZmpBounds
      room;  ///< bounds of the ZMP now, in S: those of the support sole; in double support sideways also all that lies between the feet
  ForwardOrbit orbit;         ///< orbit at the planned velocity, along the x axis of M
  double orbit_middle = 0.0;  ///< where the middle of the orbit is, from `origin` along the x axis of M [m]
  double dv_capture = 0.0;    ///< speed to add to the orbit's, so that the next step can catch the DCM [m/s]
  double orbit_ahead = 0.0;   ///< how far the orbit has the COM ahead of a motion with constant velocity now [m]
  double zmp_ahead =
      kNaN;  ///< the same along the x axis of M where steps fit known ground; NaN: the tracker says it [m]
  double zmp_lateral = 0.0;      ///< reference ZMP, from `origin` along the y axis of M [m]
  Vec2 zmp_rest = Vec2::Zero();  ///< reference ZMP of a robot at rest, W [m]
  double w_T = kNaN;             ///< w(T) of eq. 18, H, in double support before the switch [m/s]; else NaN
  double urgency =
      0.0;            ///< how far a push has taken the DCM from its plan: 0 as planned, 1 where everything is to help
  Foothold foothold;  ///< where the swing foot is to land, W; NaN in double support
  double stretch =
      0.0;  ///< largest distance along the ground of an ankle from below its hip, around this double support or the next [m]
  bool off_time = false;           ///< the swing foot has met the ground off its planned time, in this cycle
  bool known = false;              ///< the ground is known; what follows has a meaning only then
  std::array<SolePlace, 2> under;  ///< the known ground under each foot that stands
  SolePlace place;                 ///< and where the next foot lands: in double support, where it is expected to
  SwingTarget swing_target;        ///< desired motion of the swing sole; it has a meaning in single support only
};

/// Reference ZMP of the smooth law for the COM state `com`, `dcom`, W (2,) [m].
///
/// Along the x axis of M (the path in the middle of the stance) it is the ZMP that gives the pendulum the acceleration that `tracker` asks for; along the
/// y axis it is that of the lateral motion. For a robot at rest it is the ZMP that keeps the COM over the middle between the feet.
Vec2 reference_zmp(const GaitOutput& gait, const LinearInvertedPendulum& pendulum, const VelocityTracker& tracker,
                   const Vec2& com, const Vec2& dcom);

/// The gait: it decides from time and COM which foot stands, when the support switches, where feet land and how the swing foot moves there. It knows
/// neither torques nor the simulator.
///
/// It walks while the planned velocity is not zero, and stands, feet side by side, while it is.
class GaitGenerator {
 public:
  /// @param settings resolved   @param profile velocity to walk with; changes that are too fast for the steps are slowed down
  /// @param sole size that both soles are taken to have   @param bounds of the ZMP in each sole, in its axes
  /// @param whole  the bounds that hold when the robot has been pushed
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
  /// Takes the pendulum of a COM that has come to another height.
  void set_pendulum(const LinearInvertedPendulum& pendulum) { pendulum_ = pendulum; }
  /// From the next reset on the robot walks on `ground`, which must outlive the gait; null: nothing is known of the ground.
  void know(const KnownGround* ground) { ground_ = ground; }
  /// Commands a velocity (v_x, v_y, w_z) in H: from the next cycle on the plan goes towards it, whatever the profile says. Allocates nothing.
  void command(const Vec3& velocity);
  /// Lets the phase of the last cycle end `remaining` [s] after that cycle, whatever pushes the robot. The swing foot goes on without a jump. A robot
  /// that stands is in no phase and stays as it is. Allocates nothing. @throws InputError  `remaining` is not finite and > 0
  void retime(double remaining);
  /// Goes on by one cycle. Allocates nothing.
  const GaitOutput& update(const GaitInput& in);
  /// Does the same without the path of the swing foot, which a plan does not need: `swing_target` stays as it was. Allocates nothing.
  const GaitOutput& update_steps(const GaitInput& in);

  const GaitOutput& output() const { return out_; }  ///< of the last cycle
  const VelocityProfile& plan() const { return plan_; }
  const Schedule& schedule() const { return schedule_; }
  const FootstepPlanner& footsteps() const { return footsteps_; }
  const Cadence& cadence() const { return cadence_; }

 private:
  StepTimes times_at(double t) const;  // durations of a step that begins at t [s]
  void take_command(double t);
  enum class Began { kNothing, kStand, kDoubleSupport, kSingleSupport };
  Began begin_phase(const GaitInput& in);  // what begins with this cycle
  void begin_walk(const GaitInput& in);
  bool has_landed(const GaitInput& in);
  bool is_felt(const GaitInput& in, bool due);  // the landing, where touch_down is "felt"
  void move_swing_foot(const GaitInput& in);
  void move_ahead(const GaitInput& in);
  void move_sideways(const GaitInput& in);
  ZmpBounds room(const GaitInput& in, const std::array<ZmpBounds, 2>& bounds, const ZmpBounds& support) const;
  ZmpBounds sole_room(const Vec3& velocity) const;  // of the support foot alone
  // What follows is for known ground (known_steps.cpp).
  void look_at_ground(const GaitInput& in);  // where a step begins
  void fit_plan(const GaitInput& in);        // the velocity to what the ground allows
  void meet_place(const GaitInput& in, double time);
  /// Speed with which the next steps meet good places, `wanted` where they do so by themselves; notes the first of them.
  double fitting_speed(const GaitInput& in, double wanted);
  double misfit(const GaitInput& in, double speed, double wanted, bool& plane, std::array<SolePlace, 2>& first) const;
  void steer(double t, const Vec3& target);
  /// Slope that both soles feel, rise per way along x and y; zero where they do not agree, as over edges.
  Vec2 felt_slope(const GaitInput& in) const;
  SwingShape clearing_shape(const GaitInput& in) const;
  // What follows is for a robot that has been pushed (recovery.cpp); a walk that nothing pushes keeps its times and bounds, whatever is commanded.
  void feel_pushes(const GaitInput& in);
  void recover(const GaitInput& in);
  void adjust_time(const GaitInput& in);  // of the landing
  /// In double support before the switch: whether the DCM, pushed by `off` ahead or back, is nearer to where the ZMP may be in the foot that has landed
  /// than in the one that has stood. Then that foot is to carry at once: each moment over the other one drives the DCM further away.
  bool is_nearer_landed(const GaitInput& in, double off) const;
  /// Share of the single support that counts against `steps.freeze`: a pushed robot decides on its foothold later.
  double decided_share(const GaitInput& in) const;
  /// How far the DCM has left its plan, ahead and aside, in shares of half the room that the ZMP has there.
  Vec2 off_plan(const GaitInput& in) const;
  Vec2 off_stand(const Vec2& off) const;  // the same of a robot at rest, its DCM `off` from between the feet, W [m]
  /// How much that alarms, and pushes are its cause: 0 not at all, 1 where the ZMP is to use the whole sole.
  double urgency(const Vec2& off) const;
  /// Speed that steps add to the planned one, to make up way that a push has cost or given [m/s].
  double regain(const GaitInput& in) const;
  Vec2 swing_velocity() const;      // of the swing foot, W [m/s]
  Vec2 swing_acceleration() const;  // most that a foothold may ask of it, ahead and aside (2,) [m/s^2]
  LandingRoom landing_room(const GaitInput& in) const;
  bool off_the_feet(const GaitInput& in) const;  // the DCM of a robot that stands has left its soles: it must step
  void begin_catching(const GaitInput& in);      // from a stand
  /// Over the support foot. The ZMP may roll as far as the sole goes on its longer side; `end`: as far as it does on both, at the end of one stance and
  /// at the beginning of the next.
  void take_orbit(ForwardOrbit& orbit, const ZmpBounds& sole, double v, double period, bool end = false) const;
  void capture(const GaitInput& in, double time);
  double planned_lead() const;  ///< of the next foot from the support foot, along the next foot's M [m]
  /// How much further ahead than `planned` the next foot has to land, so that the orbit over it begins with the DCM that the COM will have [m].
  double ahead_of_plan(const GaitInput& in, const Vec2& planned) const;
  double stretch(const GaitInput& in);
  /// True in double support while the foot that has just landed does not carry the ZMP yet.
  bool before_switch() const { return out_.phase.phase == Phase::kDoubleSupport && lateral_.awaits_switch(); }
  /// On a curved path: the axes and the forward speeds of this stance and the next.
  void turn(const GaitInput& in, double since_middle);
  /// Forward speed along M of a stance of the foot `side`, at whose end H has turned by `angle` from M [m/s].
  double speed_in_M(const Vec3& v, Side side, double angle, double period) const;
  bool can_stand(const GaitInput& in) const;  // true where the feet are side by side and the DCM is inside their bounds

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
  double stand_ahead_;  // where a standing robot has its DCM, from the middle between the soles along the heading [m]
  double least_apart_;  // middles of feet beside each other, so that they keep clear [m]
  bool recovers_;       // from pushes
  StepAdjustment adjustment_;
  bool starting_ = true;            // the walk has begun from a stand, and no foot has lifted yet
  bool retimed_ = false;            // by the caller, in this phase: its time is theirs, and stays
  Vec2 pushed_way_ = Vec2::Zero();  // way of the DCM that pushes have caused and that is not forgotten yet, W [m]
  double pushed_ = 0.0;             // how much that counts: 0 not at all, 1 fully
  double off_plan_ = 0.0;           // how far the DCM is from its plan on uneven ground, as a share of the sole
  bool alone_ = false;              // the foot that has landed carries at once, and the other one nothing
  double planned_landing_ = 0.0;    // time at which the foot in the air lands if nothing disturbs it [s]
  double xi_planned_ = 0.0;         // where the lateral orbit has the DCM now, from the support foot along H's y [m]
  double xi_offset_ = 0.0;  // where it has the DCM when the next foot takes over, from that foot along H's y [m]
  GaitOutput out_;
  ZmpBounds sole_room_;      // bounds of the support foot at the planned velocity
  PlannedStance next_;       // stance of the foot that takes over next: the one that swings, or one that has landed
  ForwardOrbit next_orbit_;  // orbit over that foot
  double sway_ = 0.0, sway_period_ = 0.0, sway_Tc_ = 0.0;  // tanh(T / 2 T_c), and for which T and T_c
  double orbit_period_ = 0.0, orbit_Tc_ = 0.0;
  LinearInvertedPendulum::Growth orbit_growth_;  // of the DCM in `period_`, and for which T and T_c
  // Velocity and DCM that the COM will have in the middle of the next double support, the DCM from the support foot along the heading [m/s, m]. And
  // those with which the orbit over the next foot begins at that time, its DCM from that foot.
  double v_next_ = 0.0, xi_next_ = 0.0, v_start_ = 0.0, xi_start_ = 0.0;
  Vec2 ahead_next_ = Vec2::UnitX();  // x axis of the next foot's M, W
  double heading_M_ = 0.0;           // of M [rad]
  double turn_ = 0.0,
         next_turn_ = 0.0;         // of the path from the middle of this stance to its end, and of the next one [rad]
  double xi_sideways_ = 0.0;       // what the DCM along M then adds to minus that along the next M's y [m]
  double zmp_lateral_ = 0.0;       // `zmp_lateral` of the cycle before [m]
  Began began_ = Began::kNothing;  // what began with this cycle
  enum class Swing {
    kLifting,   // the foot has not been felt off the ground yet
    kAirborne,  // the foot has been felt off the ground
    kOverdue    // the foot met no ground where it should have, and goes on down
  };
  Swing swing_ = Swing::kLifting;
  std::array<bool, 2> felt_{false, false};  // whether the contact of each foot has been measured in this walk
  double period_ = 0.0;                     // period of the step after this one [s]
  const KnownGround* ground_ = nullptr;
  SoleSize sole_;
  bool fits_ = false;     // steps fit the ground ahead, which is not one plane
  double after_ = 0.0;    // length of the step after the next one, along the path [m]
  bool shaped_ = false;   // the swing clears ground that is not level
  bool slowed_ = false;   // where feet slip
  bool told_ = false;     // a velocity has been commanded
  bool steered_ = false;  // the plan goes with a speed that fits, and not by the profile
  Vec3 wanted_, steered_to_;
  Vec3 command_, allowance_;
  bool commanded_ = false;
  double t_command_ = 0.0;
};

}  // namespace zmpwalk
