#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "zmpwalk/control/limits.hpp"
#include "zmpwalk/control/task_stack.hpp"
#include "zmpwalk/control/tasks/com.hpp"
#include "zmpwalk/control/tasks/foot.hpp"
#include "zmpwalk/control/tasks/posture.hpp"
#include "zmpwalk/control/tasks/trunk.hpp"
#include "zmpwalk/control/whole_body.hpp"
#include "zmpwalk/gait/gait_generator.hpp"
#include "zmpwalk/gait/plan.hpp"
#include "zmpwalk/gait/velocity_tracker.hpp"
#include "zmpwalk/math/mailbox.hpp"
#include "zmpwalk/robot/contact_forces.hpp"
#include "zmpwalk/robot/robot.hpp"
#include "zmpwalk/settings/settings.hpp"
#include "zmpwalk/walk/arm_swing.hpp"
#include "zmpwalk/walk/body_motion.hpp"
#include "zmpwalk/walk/com_height.hpp"
#include "zmpwalk/walk/com_reference.hpp"
#include "zmpwalk/walk/command_limit.hpp"
#include "zmpwalk/walk/control_clock.hpp"
#include "zmpwalk/walk/cycle.hpp"
#include "zmpwalk/walk/damped_crouch.hpp"
#include "zmpwalk/walk/fall_prediction.hpp"
#include "zmpwalk/walk/fall_watch.hpp"
#include "zmpwalk/walk/felt_ground.hpp"
#include "zmpwalk/walk/grip.hpp"
#include "zmpwalk/walk/leg_reach.hpp"
#include "zmpwalk/walk/observer.hpp"
#include "zmpwalk/walk/record.hpp"
#include "zmpwalk/zmp/bounds.hpp"
#include "zmpwalk/zmp/estimate.hpp"

namespace zmpwalk {

/// Says from where a cycle takes kinematics, inertia and bias forces.
enum class Terms {
  kCompute,  ///< the cycle computes them from the state
  kInData    ///< `data` holds them already: mj_step1 or mj_forward has just run for this state
};

/// The walking controller: in each control cycle, `update(state)` takes the state of the robot and gives the joint torques.
///
/// It calls the other parts in order and decides nothing itself. Each cycle asks the gait where to go, turns the desired ZMP into a desired COM
/// state (16), computes the torque that leads there (1)-(8), estimates the ZMP of that torque (9)-(15), and corrects the reference until the
/// estimate is the desired ZMP (III-B). A state is plain numbers; `update(data)` reads it from a simulator and writes the torque there.
class WalkingController {
 public:
  /// @param model what the controller believes about the robot, which may differ from the robot that it walks; it must outlive the controller
  /// @throws ModelError  the robot cannot walk. InputError  a setting breaks its rule, or the profile is faster than reach, torques or friction allow
  WalkingController(const Model& model, const RobotDescription& description,
                    const WalkSettings& settings = WalkSettings(),
                    const VelocityProfile& profile = VelocityProfile::paper());
  WalkingController(const WalkingController&) = delete;
  WalkingController& operator=(const WalkingController&) = delete;

  /// Starts a walk from `state`, and moves nothing yet. @throws InputError  the state is not finite. DimensionError
  void reset(const State& state);
  /// The same for the state in `data`.
  void reset(const Data& data);

  /// Computes the torque for `state` and returns it as `tau` of the output. Nothing outside the controller changes.
  ///
  /// A new torque is computed when, by `state.time`, a control period has gone by since the last one; until then the last torque is held.
  /// @throws InputError  the state or its time is not finite, the time has gone back, or reset was never called. DimensionError.
  ///         Nothing is changed then. Allocates nothing.
  const CycleOutput& update(const State& state);
  /// Does the same for the state in `data`, and writes into `data` the control that gives the torque.
  ///
  /// With Terms::kInData nothing is computed twice, and the torque has the same bits.
  /// @param sensed  what is measured or known beside position and velocity. If the setting `touch_down` needs contacts that it leaves unknown, they
  ///                are read from `data` with Terms::kCompute, where the last step has left them.
  /// @throws as above, and InputError  the terms in `data` belong to another state
  const CycleOutput& update(const Data& data, Terms terms = Terms::kCompute, const Sensed& sensed = Sensed());

  /// Commands a velocity: from the next cycle on the robot walks with it instead of the profile's, until `reset`.
  ///
  /// It may be called from any thread, also while another one calls `update`. A velocity that reach, torques or friction do not allow is scaled down
  /// (`command_limit().within`), and the robot takes it up no faster than `forward_acceleration` and the other settings of the group `rate` allow.
  /// @param velocity (v_x, v_y, w_z) in the heading frame H [m/s, m/s, rad/s]. @throws InputError  it is not finite
  void command(const Vec3& velocity);

  /// Tells the ground that the robot walks on; it counts from the next `reset` on, which throws InputError where the robot does not stand on it. Heights
  /// count from those of the soles there. A `KnownGround` that is empty takes back what was told. Call it between cycles.
  void know(const KnownGround& ground);
  const KnownGround& ground() const { return told_; }

  /// Lets joints outside the legs, and the trunk, follow `motion` from the last cycle on (`BodyMotion::follow`). `reset` begins the motion anew.
  /// Call it between cycles. @throws as `BodyMotion::follow`; nothing is changed then
  void move(const JointMotion& motion);
  const JointMotion& motion() const { return body_.motion(); }

  /// Lets the phase of the last cycle end `remaining` [s] after that cycle; see `GaitGenerator::retime`. Call it between cycles.
  /// @throws InputError  `remaining` is not finite and > 0
  void retime(double remaining) { gait_.retime(remaining); }

  /// Adds a task that the robot fulfils while it walks. Its effect rises from nothing within `blend`, from the next cycle on; `reset` keeps the task.
  ///
  /// The task moves the joints outside the legs, and uses what tasks of smaller `priority` leave free. The posture gets the rest. Call it between cycles.
  /// @param blend [s]; NaN takes the setting `motion_blend`
  /// @throws InputError  the robot has no such name, the task was added already, its weight is outside 0 to 1, or the settings leave the direct
  ///         path (textbook, posture_task, wrench_distribution). Nothing is changed then.
  void add(const std::shared_ptr<Task>& task, double blend = kNaN);
  /// Takes the task away: it loses its effect within `blend` [s], NaN as above. Call it between cycles. @throws InputError  it was not added
  void remove(const Task& task, double blend = kNaN);
  const TaskStack& added_tasks() const { return added_; }
  /// Control cycles since the last reset.
  long cycles() const { return clock_.cycles(); }
  /// Index of the frame of a body or site, at which a known force may act (`Robot::watch`). Call it between cycles.
  int watch(const std::string& name);

  const CycleOutput& output() const { return out_; }
  const GaitOutput& gait() const { return gait_.output(); }  ///< what the gait asked for in the last cycle
  // What the last cycle asked of the whole body.
  const Stance& stance() const { return stance_; }
  const TaskAccelerations& tasks() const { return f_star_; }  ///< the COM's x and y are `com_acceleration`
  const Vec2& com_acceleration() const { return f_xy_; }      ///< W [m/s^2]
  const WalkSettings& settings() const { return settings_; }
  const WholeBodyController& whole_body() const { return whole_body_; }
  const LimitKeeper& limits() const { return limits_; }
  const VelocityProfile& profile() const { return profile_; }
  const Robot& robot() const { return robot_; }
  const LegReach& reach() const { return reach_; }                      ///< says which velocities the legs can walk
  const CommandLimit& command_limit() const { return command_limit_; }  ///< says which velocities may be commanded
  double com_height() const { return height_.z_c(); }                   ///< z_c over the soles [m]
  double Tc() const { return height_.pendulum().Tc(); }                 ///< time constant of the pendulum [s]
  /// Bounds of the ZMP, in the sole's axes about its centre.
  const ZmpBounds& bounds(Side side) const { return bounds_[side]; }

  /// Share of the knee's torque limit that its own rotor and damping take at lift-off when walking at `speed` [m/s]; see `zmpwalk::knee_share`.
  double knee_share(double speed) const;
  /// Largest difference between the speed of a list of footsteps and that of the profile within `duration` [s] -> [m/s]; 0 where the steps follow
  /// the profile.
  double plan_mismatch(double duration) const;
  /// Computes footsteps, COM and ZMP of the walk ahead of time, from the state of the last reset; before any reset, from the start pose.
  /// @param duration [s]   @param dt time step of the plan [s]. @throws InputError  one of them is not finite and > 0
  WalkPlan plan(double duration, double dt) const;

 private:
  GaitInput gait_input(double t, const Vec2& com, const Vec2& dcom) const;
  void require_startable() const;
  double start_excursion(double scale) const;  // of the COM from the first stance foot, for the plan times `scale` [m]
  void require_external(const std::vector<ExternalWrench>& external) const;
  void stand_on_known_ground();
  void start();  // a walk begins with the dynamics of this instant
  double elapsed(double time) const { return clock_.cycles() ? time - out_.t : clock_.since_start(time); }
  void feel(const MeasuredContact& contact);  // where the state does not know better
  bool believe();  // puts the attitude that is believed into state_; false where it is the measured one
  void cycle(const State& state);
  void observe_disturbance();
  void follow_pendulum();  // gait and reference take that of the COM's height and of the known forces
  void command_tasks(const Cycle& cycle);
  // A robot that has been pushed does not hold its trunk upright at once: that would take the ZMP that holds the DCM.
  void soften_trunk(double urgency, const Mat3& R_WH);
  void decide_reference(const Cycle& cycle);
  // That of the ground and of known forces on the robot, W [N].
  /// What the observer makes up for that has not lasted yet, W (2,) [m/s^2].
  Vec2 recent_force() const;
  Vec2 horizontal_force(const Dynamics& dyn, const std::array<bool, 2>& standing) const;
  void feel_grip(const GaitOutput& gait);
  void limit_torque(const GaitOutput& gait);
  void cut_torque(const GaitOutput& gait);
  void note(const Cycle& cycle);  // into the output
  void note_body();               // what is measured, and whether the robot has fallen
  void crouch();                  // the cycle of a robot that cannot keep from falling

  Robot robot_;
  VelocityProfile profile_;
  SoleSize sole_;
  WalkSettings settings_;
  std::array<ZmpBounds, 2> bounds_, whole_;  // usual, and when pushed
  ComHeight height_;
  FeltGround ground_;
  Grip grip_;
  KnownGround told_, known_;  // by the user, and as the walk has it
  GaitGenerator gait_;
  LegReach reach_;
  CommandLimit command_limit_;
  VelocityTracker tracker_;
  ComReference reference_;
  BodyMotion body_;
  ArmSwing arms_;
  WholeBodyController whole_body_;
  LimitKeeper limits_;
  ZmpEstimator estimator_;
  TaskStack added_;  // by the user
  FallPrediction foresight_;
  DampedCrouch crouch_;
  FallWatch fall_;
  DisturbanceObserver observer_;
  AttitudeObserver attitude_;
  ControlClock clock_;
  Mailbox mailbox_;
  std::atomic<SpeedLimit> bites_{SpeedLimit::kNone};  // into what is in the mailbox

  // The walk's own tasks but for the COM's x and y, each with its reference and gains.
  ComTask com_task_;
  TrunkTask trunk_task_;
  FootTask foot_task_;
  PostureTask posture_task_;

  GaitInput start_;
  Vec2 com_des_ = Vec2::Zero(), dcom_des_ = Vec2::Zero();  // previous desired state, W
  Vec2 dcom_expected_ = Vec2::Constant(kNaN);  // what the torque of the last cycle makes of the COM's velocity, W
  State state_;                                // of this instant
  // What this cycle asks of the whole body, and what comes of it.
  Stance stance_;
  TaskAccelerations f_star_;
  Vec2 f_xy_ = Vec2::Zero();  // commanded COM acceleration, W
  WholeBodyResult result_;
  CycleOutput out_;
  RowMatX J_c_;
  VecX drift_c_;
};

}  // namespace zmpwalk
