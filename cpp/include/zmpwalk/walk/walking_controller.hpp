#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>

#include "zmpwalk/control/external.hpp"
#include "zmpwalk/control/task_stack.hpp"
#include "zmpwalk/control/whole_body.hpp"
#include "zmpwalk/gait/gait_generator.hpp"
#include "zmpwalk/gait/joint_motion.hpp"
#include "zmpwalk/gait/plan.hpp"
#include "zmpwalk/gait/velocity_tracker.hpp"
#include "zmpwalk/math/mailbox.hpp"
#include "zmpwalk/robot/robot.hpp"
#include "zmpwalk/settings/settings.hpp"
#include "zmpwalk/walk/record.hpp"
#include "zmpwalk/zmp/bounds.hpp"
#include "zmpwalk/zmp/estimate.hpp"

namespace zmpwalk {

/// Where a cycle takes kinematics, inertia and bias forces from.
enum class Terms {
  kCompute,  ///< computes them from the state
  kInData    ///< `data` holds them: mj_step1 or mj_forward has just run for this state
};

/// One `update(data) -> CycleOutput` per control cycle: state in, torque out.
///
/// Reads the state, asks the gait where to go, turns the desired ZMP into a desired COM state (16), computes the torque that realises
/// it (1)-(8), estimates the ZMP of that torque (9)-(15), corrects the reference until both agree (III-B), writes the torque.
class WalkingController {
 public:
  /// @param model must outlive the controller
  /// @throws ModelError, InputError (settings, a profile faster than the legs reach)
  WalkingController(const mjModel* model, const RobotDescription& description,
                    const WalkSettings& settings = WalkSettings(),
                    const VelocityProfile& profile = VelocityProfile::paper());
  WalkingController(const WalkingController&) = delete;
  WalkingController& operator=(const WalkingController&) = delete;

  /// Reads the state in `data` and starts a walk there; moves nothing. @throws InputError the state is not finite
  void reset(const mjData* data);

  /// One physics step's worth of control: computes a torque when a control period has gone by, else holds; writes data->ctrl.
  ///
  /// With Terms::kInData nothing is computed twice; the torque has the same bits.
  /// @throws InputError the state is not finite, or the terms in `data` belong to another (nothing is changed); reset was
  ///         never called. Allocates nothing.
  const CycleOutput& update(mjData* data, Terms terms = Terms::kCompute);

  /// From the next cycle on, walk with this velocity in the heading frame instead of the profile's; until `reset`.
  ///
  /// May be called from any thread, while another updates. What the legs cannot reach is scaled down to `within_reach`; how fast
  /// the robot takes it up is limited (`forward_acceleration`, ...).
  /// @param velocity (v_x, v_y, w_z) [m/s, m/s, rad/s]. @throws InputError not finite
  void command(const Vec3& velocity);

  /// Joints outside the legs, and the trunk, follow `motion` from the last cycle on, reached within `motion_blend` without a jump; what it
  /// does not name goes back to the stand. `reset` begins the motion anew. Call it between cycles.
  /// @throws InputError a name that is no joint, or a leg's; a joint beyond its range, the trunk turned by more than half of
  ///         `fall_tilt`; posture_task off. Nothing is changed then.
  void move(const JointMotion& motion);
  const JointMotion& motion() const { return reference_.motion(); }

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
  long cycles() const { return (tick_ + ticks_per_cycle_ - 1) / ticks_per_cycle_; }

  /// Index of the frame of a body or site of the robot, where known forces may act: `Robot::watch`. Call it between cycles.
  int watch(const std::string& name) { return robot_.watch(name); }
  /// Known forces on the robot in the cycles that follow. @throws InputError  not finite, or at a frame that is not watched
  void set_external(const std::vector<ExternalWrench>& external);

  const CycleOutput& output() const { return out_; }
  // What the last cycle asked of the whole body.
  const Stance& stance() const { return stance_; }
  const TaskAccelerations& tasks() const { return f_star_; }  ///< the COM's x and y are `com_acceleration`
  const Vec2& com_acceleration() const { return f_xy_; }      ///< W [m/s^2]
  const WalkSettings& settings() const { return settings_; }
  const WholeBodyController& whole_body() const { return whole_body_; }
  const VelocityProfile& profile() const { return profile_; }
  const Robot& robot() const { return robot_; }
  double com_height() const { return com_height_; }                   ///< z_c over the soles [m]
  double Tc() const { return pendulum_.Tc(); }                        ///< [s]
  const ZmpBounds& bounds(Side side) const { return bounds_[side]; }  ///< in the sole's axes, about its centre

  /// Share of the legs' reach that walking with `velocity` takes: beside 1 the knee is nearly straight, or the hip turned to its end.
  ///
  /// In double support an ankle is v_x (T + T_ds)/2 ahead of or behind its hip, at most |v_y| T beside it, and turned by
  /// w_z (T + T_ds)/2; T and T_ds are the cadence's for that velocity. The knees bend up to `crouch_limit` for it.
  double reach_share(const Vec3& velocity) const;
  /// `velocity`, made smaller until its `reach_share` is at most 1.
  Vec3 within_reach(const Vec3& velocity) const;
  /// Largest v_x within reach [m/s].
  double speed_limit() const { return within_reach({kTooFast, 0.0, 0.0}).x(); }
  /// Share of the knee's torque limit that its own rotor and damping take at lift-off when walking at `speed` [m/s]; see `zmpwalk::knee_share`.
  double knee_share(double speed) const;
  /// Largest difference between the speed of a footstep list and of the profile within `duration` [s]; 0 where steps follow the profile [m/s].
  double plan_mismatch(double duration) const;
  /// Footsteps, COM and ZMP ahead of time, from where the last reset was, else from the start pose.
  /// @param duration [s]   @param dt time step of the plan [s]. @throws InputError not finite and > 0
  WalkPlan plan(double duration, double dt) const;

 private:
  static constexpr double kTooFast = 10.0;  // no biped's walk [m/s]
  struct Desired {                          // what a reference ZMP leads to, in S
    Vec2 x_d, v_d, f;                       // next COM state (16), commanded acceleration (8)
  };
  Desired desired(const Vec2& r) const;
  GaitInput gait_input(double t, const Vec2& com, const Vec2& dcom) const;
  void task_accelerations(const GaitOutput& gait);
  void swing_arms(const GaitOutput& gait);
  int coordinate(const std::string& name) const;
  void choose_reference(const GaitOutput& gait);
  void clip_torque(const GaitOutput& gait);
  void check_fall(const GaitOutput& gait);
  double stride(const Vec3& velocity) const;  // how far along the ground `velocity` takes an ankle from its hip [m]
  double reach(double crouch) const;          // how far the legs reach that way with the COM lowered by `crouch` [m]
  double crouch_for(double stride) const;     // how far the COM has to come down for it [m]
  void set_height(double crouch);             // the pendulum's, and what follows from it
  void move_height(double t, double stretch);
  void check_profile() const;
  double start_excursion(double scale) const;  // of the COM from the first stance foot, for the plan times `scale` [m]

  Robot robot_;
  MotionReference reference_;  // of the joints, then the trunk's roll, pitch, yaw
  VelocityProfile profile_;
  double com_height_;
  SoleSize sole_;
  WalkSettings settings_;
  LinearInvertedPendulum pendulum_;
  std::array<ZmpBounds, 2> bounds_;
  GaitGenerator gait_;
  VelocityTracker tracker_;
  WholeBodyController whole_body_;
  ZmpEstimator estimator_;
  TaskStack added_;
  std::vector<ExternalWrench> external_;

  double hip_turn_;  // of the hips about the vertical [rad]
  Mailbox mailbox_;

  // State of a walk
  bool started_ = false;
  double t_start_ = 0.0;
  GaitInput start_;
  int ticks_per_cycle_ = 1;
  long tick_ = 0;
  double ground_ = 0.0;  // height of the soles at the start
  double crouch_ = 0.0, dcrouch_ = 0.0,
         ddcrouch_ = 0.0;   // how far the COM is to be under com_height_, and its derivatives
  Mat3 R_HB_;               // trunk in the heading frame at the start
  std::array<Vec3, 2> up_;  // normals of the soles at the start
  Vec2 com_des_ = Vec2::Zero(), dcom_des_ = Vec2::Zero();  // previous desired state, W
  Vec2 shift_ = Vec2::Zero();                              // of the pendulum's COM by known forces, W

  // Of this cycle
  Vec2 x_, v_;            // "current" COM state of (16), S
  Vec2 x_meas_, v_meas_;  // measured, S
  Vec2 kp_, kd_, df_dr_;
  Mat2 R_S_, R_H_;
  Vec2 f_xy_ = Vec2::Zero();  // commanded COM acceleration, W
  Stance stance_;
  TaskAccelerations f_star_;
  std::vector<int> swinging_;  // arm joints that no motion names
  VecX c_;                     // row of the yaw momentum
  WholeBodyResult result_;
  CycleOutput out_;
  RowMatX J_c_;
  VecX drift_c_;
};

}  // namespace zmpwalk
