#pragma once

#include <memory>
#include <string>
#include <vector>

#include "zmpwalk/control/dynamics.hpp"
#include "zmpwalk/control/external.hpp"
#include "zmpwalk/robot/actuation.hpp"
#include "zmpwalk/robot/computed_terms.hpp"
#include "zmpwalk/robot/description.hpp"
#include "zmpwalk/robot/mujoco.hpp"
#include "zmpwalk/robot/state.hpp"

namespace zmpwalk {

/// Geometry of a leg at the start pose, seen from the side (x forward, z up): the pitch axes of hip, knee and ankle, and the knee's drive.
struct RobotLeg {
  double thigh = 0.0;                ///< hip to knee [m]
  double shank = 0.0;                ///< knee to ankle [m]
  Vec2 hip_to_ankle = Vec2::Zero();  ///< [m]
  int knee = 0;                      ///< joint index
  double knee_armature = 0.0;        ///< rotor inertia seen at the knee [kg m^2]
  double knee_damping = 0.0;         ///< [N m s/rad]
};

/// One robot in a MuJoCo model. It translates MuJoCo's mjModel and mjData into `Dynamics`, and torques back into mjData.
///
/// Given a state alone, it computes the terms in an mjData of its own, without collisions and without the constraint solver. `m` must outlive it.
class Robot {
 public:
  /// @throws ModelError  the robot cannot walk: it gives every reason of `model_reasons`, or if there is none, those of `stand_reasons`
  Robot(const Model& m, const RobotDescription& description);

  /// Reads the robot's state out of `d` and computes every term of `dynamics()`. Allocates nothing.
  ///
  /// A, b and g come from mj_crb, mj_rne and mj_passive; Jdot dq is the acceleration of a frame with ddq = 0, summed along its leg.
  /// Dry friction of a joint enters b as c tanh(dq / friction_velocity).
  void read(const Data& d);
  /// The same from numbers alone: the same bits for the same q and dq. Allocates nothing.
  void read(const State& state);
  /// Writes position, velocity and time of the robot in `d` into `out`; its sensed values stay as they are. Allocates nothing.
  void observe(const Data& d, State& out) const;
  /// Does what `read` does, with the same bits, but takes the terms that `d` holds already: call it right after mj_step1 or mj_forward.
  /// Allocates nothing.
  void read_computed(const Data& d);
  /// @throws InputError  qpos or qvel in `d` have been changed since the terms in `d` were computed (`ComputedTerms`). Allocates nothing otherwise.
  void require_computed(const Data& d) const;
  const Dynamics& dynamics() const { return dynamics_; }

  /// Index in `dynamics().frames` of the frame of a body or a site. Every `read` fills that frame in from then on. It allocates, so call it outside
  /// the cycle.
  ///
  /// A body's name is looked for first. The same name gives the same index.
  /// @throws InputError  the robot has neither a body nor a site of that name; the message says which there are
  int watch(const std::string& name);
  /// Adds known forces to the dynamics (`zmpwalk::apply_external`), until the next read. Allocates nothing. @throws InputError  no such frame
  void apply_external(const std::vector<ExternalWrench>& external);
  /// Changes the dynamics to those of a disturbed robot (`zmpwalk::apply_disturbance`), until the next read. Allocates nothing.
  void apply_disturbance(const Disturbance& disturbance) { zmpwalk::apply_disturbance(dynamics_, disturbance); }
  /// The robot's own part of qpos (nv + 1,) and qvel (nv,), as last read.
  Eigen::Map<const VecX> qpos() const;
  Eigen::Map<const VecX> qvel() const;

  /// @throws InputError  `d` was made for a model of another size. Allocates nothing otherwise.
  void require_data(const Data& d) const;
  /// True where every position and velocity of the robot in `d` is finite.
  bool is_finite(const Data& d) const;

  /// Writes joint torques (joints,) [N m] for the state in `d`: `Actuation::write`. Allocates nothing.
  void write_torque(const ConstVecRef& tau, const Data& d) const { actuation_.write(tau, d, data_); }

  const Model& model() const { return m_; }
  double timestep() const;  ///< of the model [s]
  const RobotDescription& description() const { return description_; }
  int nv() const { return nv_; }
  int joints() const { return nv_ - 6; }
  int qpos_address() const { return qpos0_; }
  int dof_address() const { return dof0_; }
  int root_body() const { return root_body_; }
  int foot_body(Side side) const { return foot_body_[side]; }
  /// True for bodies that are the foot or hang from it.
  bool is_foot(Side side, int body) const;
  bool is_robot(int body) const;
  /// True for the bodies of both legs: those that the first leg joint turns, and what hangs from them.
  bool is_leg(int body) const;
  const std::vector<std::string>& joint_names() const { return joint_names_; }
  /// How the torque of each joint reaches MuJoCo (joints,).
  const std::vector<JointDrive>& drives() const { return actuation_.drives(); }
  /// Torque limits of the joints (joints,) [N m]: the description's, else the model's; infinity where there is none.
  const VecX& torque_limit() const { return torque_limit_; }
  /// Joint index (0-based, base excluded) of each leg joint, hip to ankle.
  const std::array<std::vector<int>, 2>& leg_joints() const { return leg_joints_; }
  bool is_leg_joint(int joint) const;
  /// Joints that count as those of arms (indices): they are outside the legs and carry less than a fifth of the robot's mass, as a waist does not.
  const std::vector<int>& arm_joints() const { return arm_joints_; }
  /// Lower and upper limit of a joint [rad or m]; infinite where it has none.
  std::pair<double, double> joint_range(int joint) const;
  /// Joint positions of the start pose (joints,).
  const VecX& stand() const { return stand_; }
  /// Position of the ankle's axes in the sole frame, where the torque limits of the ankle act [m].
  Vec3 ankle_in_sole(Side side) const { return ankle_F_[side]; }
  /// Friction between a sole and the ground in the model: the least of the foot's geoms against the world's, as MuJoCo pairs them; that of
  /// the foot alone where the model has no ground.
  double sole_friction(Side side) const;
  /// How far a foot reaches from its sole's centre: ahead or behind, and towards the other foot, along the sole's axes at the start pose [m].
  /// The shapes that collide count, of the foot and of what hangs from it; 0 without any.
  Vec2 foot_reach(Side side) const;
  /// Geometry of a leg at the start pose.
  RobotLeg leg_at_stand(Side side) const { return leg_[side]; }
  /// Sole centre in W, from the body poses that `d` holds (after mj_step: those of the state before it) [m].
  Vec3 sole_centre(Side side, const Data& d) const;
  /// Distance to its limit of the joint that is nearest to one in `d` [rad or m]; infinity if no joint has a limit.
  double joint_margin(const Data& d) const;
  /// How far both hips can turn about the vertical from the start pose, either way: the smallest distance to one of their limits [rad].
  double hip_turn() const { return hip_turn_; }
  /// Of the leg joints [first, last), the one whose axis lies closest to the sole's y at the start pose (joint index).
  int pitch_joint(Side side, int first, int last) const { return joint_about(1, side, first, last); }

  /// Speed below which dry friction is taken as proportional to speed [rad/s].
  double friction_velocity = 0.02;

 private:
  /// Of the leg joints [first, last), the one whose axis lies closest to the sole's axis `axis` at the start pose.
  int joint_about(int axis, Side side, int first, int last) const;

  struct BodyFrame {
    std::string name;
    int body;
    Vec3 p_BF;  // in the body
    Mat3 R_BF;
    std::vector<int> dofs;  // robot's dof indices that move it, from the root on
  };
  BodyFrame frame_on(const std::string& name, int body, const Vec3& p_BF, const double* q_BF) const;
  void copy_state(const double* q, const double* dq);  // into the robot's own mjData
  void compute();  // every term of `dynamics()`, from the state in the robot's own mjData
  void collect(const Data& d);
  void read_frame(const BodyFrame& frame, const Data& d, FrameState& out) const;

  Model m_;
  RobotDescription description_;
  OwnData data_;
  Dynamics dynamics_;
  int nv_, qpos0_, dof0_, root_body_;
  std::array<int, 2> foot_body_{};
  std::array<BodyFrame, 2> frame_;
  std::vector<BodyFrame> watched_;
  std::vector<std::string> joint_names_;
  ComputedTerms computed_terms_;
  Actuation actuation_;
  bool tendon_forces_ = false;
  VecX torque_limit_, stand_;
  std::array<std::vector<int>, 2> leg_joints_;
  std::vector<int> arm_joints_;
  std::array<Vec3, 2> ankle_F_;
  std::array<RobotLeg, 2> leg_;
  double hip_turn_ = std::numeric_limits<double>::infinity();
};

}  // namespace zmpwalk
