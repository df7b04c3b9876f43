#pragma once

#include <memory>
#include <string>

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
#include "zmpwalk/walk/control_clock.hpp"
#include "zmpwalk/walk/cycle.hpp"
#include "zmpwalk/walk/fall_watch.hpp"
#include "zmpwalk/walk/leg_reach.hpp"
#include "zmpwalk/walk/record.hpp"
#include "zmpwalk/zmp/bounds.hpp"
#include "zmpwalk/zmp/estimate.hpp"

namespace zmpwalk {

/// Where a cycle takes kinematics, inertia and bias forces from.
enum class Terms {
  kCompute,  ///< computes them from the state
  kInData    ///< `data` holds them: mj_step1 or mj_forward has just run for this state
};

/// One `update(state) -> CycleOutput` per control cycle: state in, torque out.
///
/// It conducts and decides nothing itself. Each cycle asks the gait where to go, turns the desired ZMP into a desired COM state (16),
/// computes the torque that realises it (1)-(8), estimates the ZMP of that torque (9)-(15), and corrects the reference until both
/// agree (III-B). A state is plain numbers; where it comes from a simulator, `update(data)` reads it and writes the torque.
class WalkingController {
 public:
  /// @param model must outlive the controller: what the controller believes about the robot, which may differ from the robot it walks
  /// @throws ModelError, InputError (settings, a profile faster than the legs reach)
  WalkingController(const mjModel* model, const RobotDescription& description,
                    const WalkSettings& settings = WalkSettings(),
                    const VelocityProfile& profile = VelocityProfile::paper());
  WalkingController(const WalkingController&) = delete;
  WalkingController& operator=(const WalkingController&) = delete;

  /// Starts a walk from `state`; moves nothing. @throws InputError the state is not finite, DimensionError
  void reset(const State& state);
  /// The same for the state in `data`.
  void reset(const mjData* data);

  /// The torque for `state`, in `output().tau`; nothing outside the controller changes.
  ///
  /// A new torque is computed when a control period has gone by since the last, by `state.time`; until then the last one is held.
  /// @throws InputError the state is not finite, its time is not, or has gone back; reset was never called. DimensionError.
  ///         Nothing is changed then. Allocates nothing.
  const CycleOutput& update(const State& state);
  /// The same for the state in `data`, in which it sets the control that gives the torque.
  ///
  /// With Terms::kInData nothing is computed twice; the torque has the same bits.
  /// @param sensed  what is felt or known beside position and velocity. Contacts that it leaves unknown are read from `data` with
  ///                Terms::kCompute, where the last step has left them, if `touch_down` asks for them.
  /// @throws as above, and InputError where the terms in `data` belong to another state
  const CycleOutput& update(mjData* data, Terms terms = Terms::kCompute, const Sensed& sensed = Sensed());

  /// From the next cycle on, walk with this velocity in the heading frame instead of the profile's; until `reset`.
  ///
  /// May be called from any thread, while another updates. What the legs cannot reach is scaled down to `reach().within`; how fast
  /// the robot takes it up is limited (`forward_acceleration`, ...).
  /// @param velocity (v_x, v_y, w_z) [m/s, m/s, rad/s]. @throws InputError not finite
  void command(const Vec3& velocity);

  /// Joints outside the legs, and the trunk, follow `motion` from the last cycle on: `BodyMotion::follow`. `reset` begins the motion anew.
  /// Call it between cycles. @throws as there; nothing is changed then
  void move(const JointMotion& motion);
  const JointMotion& motion() const { return body_.motion(); }

  /// The phase under way at the last cycle ends `remaining` [s] after that cycle; see `GaitGenerator::retime`. Call it between cycles.
  /// @throws InputError  `remaining` is not finite and > 0
  void retime(double remaining) { gait_.retime(remaining); }

  /// From the next cycle on, `task` is met while the robot walks, its effect rising from nothing within `blend`; it outlives `reset`.
  ///
  /// It acts with the joints outside the legs, in what tasks of smaller `priority` leave free; the posture takes the rest. Call it between cycles.
  /// @param blend [s]; NaN takes the setting `motion_blend`
  /// @throws InputError  a name that the robot does not have, a task that is there already, a weight outside 0 to 1, settings that
  ///         leave the direct path (textbook, posture_task, wrench_distribution). Nothing is changed then.
  void add(const std::shared_ptr<Task>& task, double blend = kNaN);
  /// The task loses its effect within `blend` [s], NaN as above. Call it between cycles. @throws InputError  it is not there
  void remove(const Task& task, double blend = kNaN);
  const TaskStack& added_tasks() const { return added_; }
  /// Control cycles since the last reset.
  long cycles() const { return clock_.cycles(); }
  /// Index of the frame of a body or site of the robot, where known forces may act: `Robot::watch`. Call it between cycles.
  int watch(const std::string& name);

  const CycleOutput& output() const { return out_; }
  const GaitOutput& gait() const { return gait_.output(); }  ///< what the gait asked for in the last cycle
  // What the last cycle asked of the whole body.
  const Stance& stance() const { return stance_; }
  const TaskAccelerations& tasks() const { return f_star_; }  ///< the COM's x and y are `com_acceleration`
  const Vec2& com_acceleration() const { return f_xy_; }      ///< W [m/s^2]
  const WalkSettings& settings() const { return settings_; }
  const WholeBodyController& whole_body() const { return whole_body_; }
  const VelocityProfile& profile() const { return profile_; }
  const Robot& robot() const { return robot_; }
  const LegReach& reach() const { return reach_; }                    ///< which velocities the legs can walk
  double com_height() const { return height_.z_c(); }                 ///< z_c over the soles [m]
  double Tc() const { return height_.pendulum().Tc(); }               ///< [s]
  const ZmpBounds& bounds(Side side) const { return bounds_[side]; }  ///< in the sole's axes, about its centre

  /// Share of the knee's torque limit that its own rotor and damping take at lift-off when walking at `speed` [m/s]; see `zmpwalk::knee_share`.
  double knee_share(double speed) const;
  /// Largest difference between the speed of a footstep list and of the profile within `duration` [s]; 0 where steps follow the profile [m/s].
  double plan_mismatch(double duration) const;
  /// Footsteps, COM and ZMP ahead of time, from where the last reset was, else from the start pose.
  /// @param duration [s]   @param dt time step of the plan [s]. @throws InputError not finite and > 0
  WalkPlan plan(double duration, double dt) const;

 private:
  GaitInput gait_input(double t, const Vec2& com, const Vec2& dcom) const;
  void require_startable() const;
  double start_excursion(double scale) const;  // of the COM from the first stance foot, for the plan times `scale` [m]
  void require_external(const std::vector<ExternalWrench>& external) const;
  void start();                               // a walk begins with the dynamics of this instant
  void feel(const MeasuredContact& contact);  // where the state does not know better
  void cycle(const State& state);
  void follow_pendulum();  // gait and reference take that of the COM's height and of the known forces
  void command_tasks(const Cycle& cycle);
  void decide_reference(const Cycle& cycle);
  void limit_torque(const GaitOutput& gait);
  void note(const Cycle& cycle);  // into the output

  Robot robot_;
  VelocityProfile profile_;
  SoleSize sole_;
  WalkSettings settings_;
  std::array<ZmpBounds, 2> bounds_;
  ComHeight height_;
  GaitGenerator gait_;
  LegReach reach_;
  VelocityTracker tracker_;
  ComReference reference_;
  BodyMotion body_;
  ArmSwing arms_;
  WholeBodyController whole_body_;
  ZmpEstimator estimator_;
  TaskStack added_;  // by the user
  FallWatch fall_;
  ControlClock clock_;
  Mailbox mailbox_;

  // The walk's own tasks but for the COM's x and y, each with its reference and gains.
  ComTask com_task_;
  TrunkTask trunk_task_;
  FootTask foot_task_;
  PostureTask posture_task_;

  GaitInput start_;
  Vec2 com_des_ = Vec2::Zero(), dcom_des_ = Vec2::Zero();  // previous desired state, W
  State state_;                                            // of this instant
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
