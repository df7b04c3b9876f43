#include "zmpwalk/robot/robot.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/robot/mujoco.hpp"
#include "zmpwalk/robot/rules/stand_rules.hpp"
#include "zmpwalk/robot/shape.hpp"
#include "zmpwalk/robot/words.hpp"

namespace zmpwalk {
namespace {

using ConstVec3Map = Eigen::Map<const Vec3>;
using ConstRowMat3Map = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

ConstVec3Map vec3(const double* p) { return ConstVec3Map(p); }

int checked_root(const Model& m, const RobotDescription& description) {
  description.check(m);
  return description.free_joint(m);
}

/// Velocity coordinates of the kinematic tree whose root body is `root`; MuJoCo keeps a tree's dofs together.
int tree_nv(const Model& m, int root) {
  int count = 0;
  for (int i = 0; i < m.nv; ++i) count += m.body_rootid[m.dof_bodyid[i]] == root;
  return count;
}

constexpr double kArmShare =
    0.2;  // largest share of the robot's mass that a joint of an arm carries; a waist carries more

}  // namespace

Robot::Robot(const Model& m, const RobotDescription& description)
    : m_(m),
      description_(description),
      data_(m_),
      dynamics_(tree_nv(m, m.jnt_bodyid[checked_root(m, description)])),
      nv_(dynamics_.nv()),
      computed_terms_(m, m.jnt_bodyid[checked_root(m, description)]),
      actuation_(m, tree_joints(m, m.jnt_bodyid[checked_root(m, description)]), description.torque_limits) {
  const int root = description.free_joint(m);
  root_body_ = m.jnt_bodyid[root];
  qpos0_ = m.jnt_qposadr[root];
  dof0_ = m.jnt_dofadr[root];

  std::vector<int> parent(nv_);
  for (int i = 0; i < nv_; ++i) parent[i] = std::max(m.dof_parentid[dof0_ + i] - dof0_, -1);
  dynamics_.A_sparsity = Sparsity::of_tree(parent);

  stand_ = VecX::Zero(joints());
  torque_limit_ = VecX::Zero(joints());
  for (int j = 0; j < joints(); ++j) {
    joint_names_.push_back(object_name(m, mj::kJoint, m.dof_jntid[dof0_ + 6 + j]));
    stand_[j] = description.stand_joints.at(joint_names_[j]);
    torque_limit_[j] = drives()[j].limit;
  }
  for (int t = 0; t < m.ntendon; ++t)
    tendon_forces_ = tendon_forces_ || m.tendon_stiffness[t] != 0.0 || m.tendon_damping[t] != 0.0;
  for (const Side side : kSides) {
    const Foot& foot = description.feet[side];
    foot_body_[side] = mj::name2id(m, mj::kBody, foot.body.c_str());
    frame_[side] = frame_on(foot.body, foot_body_[side], foot.sole_pos, foot.sole_quat.data());
    for (const std::string& name : foot.leg_joints)
      leg_joints_[side].push_back(m.jnt_dofadr[mj::name2id(m, mj::kJoint, name.c_str())] - dof0_ - 6);
  }
  for (int j = 0; j < joints(); ++j) {
    const int body = m.dof_bodyid[dof0_ + 6 + j];
    if (!is_leg_joint(j) && m.body_subtreemass[body] < kArmShare * m.body_subtreemass[root_body_])
      arm_joints_.push_back(j);
  }
  // Ankle position in the sole frame, at the start pose (it does not depend on the ankle's angle to first order).
  description.place(m, data_, 0.0);
  read(data_);
  for (const Side side : kSides) {
    const int ankle = m.dof_jntid[dof0_ + 6 + leg_joints_[side].back()];
    const FrameState& sole = dynamics_.sole[side];
    ankle_F_[side] = sole.R_WF.transpose() * (vec3(data_.xanchor + 3 * ankle) - sole.p_WF);
    const auto anchor = [&](int j) {
      const double* p = data_.xanchor + 3 * m.dof_jntid[dof0_ + 6 + j];
      const Vec3 p_F = sole.R_WF.transpose() * vec3(p);
      return Vec2(p_F.x(), p_F.z());
    };
    const Vec2 hip = anchor(pitch_joint(side, 0, 3)), knee = anchor(leg_joints_[side][3]),
               foot = anchor(pitch_joint(side, 4, 6));
    const int knee_dof = dof0_ + 6 + leg_joints_[side][3];
    leg_[side] = {(knee - hip).norm(),  (foot - knee).norm(),     foot - hip,
                  leg_joints_[side][3], m.dof_armature[knee_dof], m.dof_damping[knee_dof]};
    const int yaw = joint_about(2, side, 0, 3), id = m.dof_jntid[dof0_ + 6 + yaw];
    if (m.jnt_limited[id])
      hip_turn_ = std::min({hip_turn_, stand_[yaw] - m.jnt_range[2 * id], m.jnt_range[2 * id + 1] - stand_[yaw]});
  }
  mj::tendon(m, data_);
  require_none(stand_reasons(*this, data_));
}

Robot::BodyFrame Robot::frame_on(const std::string& name, int body, const Vec3& p_BF, const double* q_BF) const {
  const Mat3 R_BF = Eigen::Quaterniond(q_BF[0], q_BF[1], q_BF[2], q_BF[3]).normalized().toRotationMatrix();
  BodyFrame frame{name, body, p_BF, R_BF, {}};
  std::vector<int> chain;
  for (int b = body; b > 0; b = m_.body_parentid[b]) chain.push_back(b);
  for (auto b = chain.rbegin(); b != chain.rend(); ++b)
    for (int k = 0; k < m_.body_dofnum[*b]; ++k) frame.dofs.push_back(m_.body_dofadr[*b] + k - dof0_);
  return frame;
}

int Robot::watch(const std::string& name) {
  for (std::size_t i = 0; i < watched_.size(); ++i)
    if (watched_[i].name == name) return static_cast<int>(i);
  constexpr double kNoTurn[4] = {1, 0, 0, 0};
  const int body = mj::name2id(m_, mj::kBody, name.c_str()), site = mj::name2id(m_, mj::kSite, name.c_str());
  if (body > 0 && is_robot(body)) {
    watched_.push_back(frame_on(name, body, Vec3::Zero(), kNoTurn));
  } else if (site >= 0 && is_robot(m_.site_bodyid[site])) {
    watched_.push_back(frame_on(name, m_.site_bodyid[site], vec3(m_.site_pos + 3 * site), m_.site_quat + 4 * site));
  } else {
    std::string known;
    for (int b = 1; b < m_.nbody; ++b)
      if (is_robot(b)) known += object_name(m_, mj::kBody, b) + ", ";
    for (int s = 0; s < m_.nsite; ++s)
      if (is_robot(m_.site_bodyid[s])) known += object_name(m_, mj::kSite, s) + ", ";
    throw InputError("the robot has no body or site '" + name + "'; there are: " + known.substr(0, known.size() - 2));
  }
  dynamics_.frames.emplace_back();
  dynamics_.frames.back().J = Mat6X::Zero(6, nv_);
  read(data_);
  return static_cast<int>(watched_.size()) - 1;
}

void Robot::apply_external(const std::vector<ExternalWrench>& external) {
  for (const ExternalWrench& each : external) zmpwalk::apply_external(dynamics_, each);
}

int Robot::joint_about(int axis, Side side, int first, int last) const {
  const FrameState& sole = dynamics_.sole[side];
  const auto share = [&](int i) {
    return std::abs(sole.J.col(6 + leg_joints_[side][i]).tail<3>().dot(sole.R_WF.col(axis)));
  };
  int best = first;
  for (int i = first + 1; i < last; ++i)
    if (share(i) > share(best)) best = i;
  return leg_joints_[side][best];
}

Eigen::Map<const VecX> Robot::qpos() const { return {data_.qpos + qpos0_, nv_ + 1}; }

Eigen::Map<const VecX> Robot::qvel() const { return {data_.qvel + dof0_, nv_}; }

double Robot::timestep() const { return *m_.timestep; }

bool Robot::is_robot(int body) const { return m_.body_rootid[body] == root_body_; }

bool Robot::is_foot(Side side, int body) const {
  for (; body > 0; body = m_.body_parentid[body])
    if (body == foot_body_[side]) return true;
  return false;
}

bool Robot::is_leg(int body) const {
  for (; body > 0; body = m_.body_parentid[body])
    for (const auto& leg : leg_joints_)
      if (m_.dof_bodyid[dof0_ + 6 + leg.front()] == body) return true;
  return false;
}

void Robot::require_data(const Data& d) const { require_same_model(data_, d); }

bool Robot::is_finite(const Data& d) const {
  // Zero times infinity is not a number, and a sum with such a term is none.
  const Eigen::Map<const VecX> q(d.qpos + qpos0_, nv_ + 1), dq(d.qvel + dof0_, nv_);
  return (0.0 * q).sum() + (0.0 * dq).sum() == 0.0;
}

void Robot::read(const Data& d) {
  if (d.handle != data_.handle) copy_state(d.qpos + qpos0_, d.qvel + dof0_);
  compute();
}

void Robot::read(const State& state) {
  copy_state(state.q.data(), state.dq.data());
  compute();
}

void Robot::observe(const Data& d, State& out) const {
  out.time = *d.time;
  out.q = Eigen::Map<const VecX>(d.qpos + qpos0_, nv_ + 1);
  out.dq = Eigen::Map<const VecX>(d.qvel + dof0_, nv_);
}

void Robot::copy_state(const double* q, const double* dq) {
  std::copy_n(q, nv_ + 1, data_.qpos + qpos0_);
  std::copy_n(dq, nv_, data_.qvel + dof0_);
}

void Robot::compute() {
  const Data& own = data_;
  mj::kinematics(m_, own);
  mj::com_pos(m_, own);
  mj::compute_inertia(m_, own);
  if (tendon_forces_) {  // mj_passive needs the lengths and speeds of the tendons
    mj::tendon(m_, own);
    mj::fwd_velocity(m_, own);
  } else {
    mj::com_vel(m_, own);
    mj::passive(m_, own);
    mj::rne(m_, own, 0, own.qfrc_bias);
  }
  collect(own);
}

void Robot::require_computed(const Data& d) const { computed_terms_.require(d); }

void Robot::read_computed(const Data& d) {
  copy_state(d.qpos + qpos0_, d.qvel + dof0_);
  collect(d);
}

void Robot::collect(const Data& d) {
  Dynamics& out = dynamics_;
  out.mass = m_.body_subtreemass[root_body_];
  out.gravity = vec3(m_.gravity);
  out.q = Eigen::Map<const VecX>(d.qpos + qpos0_ + 7, nv_ - 6);
  out.dq = Eigen::Map<const VecX>(d.qvel + dof0_, nv_);
  mj::inertia(m_, d, dof0_, nv_, out.A.data());

  // Uniform gravity is a uniform acceleration of the base: g = -A [gravity; 0].
  out.g.noalias() = out.A.leftCols<3>() * (-out.gravity);
  out.drift_momentum = Eigen::Map<const VecX>(d.qfrc_bias + dof0_, nv_) - out.g;
  out.b = out.drift_momentum - Eigen::Map<const VecX>(d.qfrc_passive + dof0_, nv_);
  const bool rubs = !(*m_.disableflags & m_.no_frictionloss);
  for (int i = 6; i < nv_; ++i) {
    const double friction = m_.dof_frictionloss[dof0_ + i];
    if (rubs && friction > 0.0) out.b[i] += friction * std::tanh(out.dq[i] / friction_velocity);
  }

  out.com = vec3(d.subtree_com + 3 * root_body_);
  out.J_com = out.A.topRows<3>() / out.mass;  // linear momentum M dcom is conjugate to the base's translation
  out.dcom.noalias() = out.J_com * out.dq;
  out.drift_com = out.drift_momentum.head<3>() / out.mass;

  out.p_WB = vec3(d.xpos + 3 * root_body_);
  out.R_WB = ConstRowMat3Map(d.xmat + 9 * root_body_);
  out.omega_WB.noalias() = out.R_WB * out.dq.segment<3>(3);
  for (const Side side : kSides) read_frame(frame_[side], d, out.sole[side]);
  for (std::size_t i = 0; i < watched_.size(); ++i) read_frame(watched_[i], d, out.frames[i]);
  out.F_ext.setZero();
  out.M_ext.setZero();
}

void Robot::read_frame(const BodyFrame& frame, const Data& d, FrameState& out) const {
  const Mat3 R_WB = ConstRowMat3Map(d.xmat + 9 * frame.body);
  out.R_WF.noalias() = R_WB * frame.R_BF;
  out.p_WF = vec3(d.xpos + 3 * frame.body);
  out.p_WF.noalias() += R_WB * frame.p_BF;

  // MuJoCo keeps spatial velocities (angular, linear) about the COM of the tree.
  const Vec3 arm = out.p_WF - vec3(d.subtree_com + 3 * root_body_);
  for (const int i : frame.dofs) {
    const double* cdof = d.cdof + 6 * (dof0_ + i);
    out.J.col(i).head<3>() = vec3(cdof + 3) + vec3(cdof).cross(arm);
    out.J.col(i).tail<3>() = vec3(cdof);
  }
  const double* cvel = d.cvel + 6 * frame.body;
  const Vec3 omega = vec3(cvel);
  const Vec3 v = vec3(cvel + 3) + omega.cross(arm);
  out.velocity << v, omega;

  // Acceleration of the frame with ddq = 0: the spatial drift summed from the root, then moved to the frame's origin.
  Vec3 angular = Vec3::Zero(), linear = Vec3::Zero();
  for (const int i : frame.dofs) {
    const double* cdof_dot = d.cdof_dot + 6 * (dof0_ + i);
    const double dq = d.qvel[dof0_ + i];
    angular += dq * vec3(cdof_dot);
    linear += dq * vec3(cdof_dot + 3);
  }
  out.drift << linear + angular.cross(arm) + omega.cross(v), angular;
}

Vec3 Robot::sole_centre(Side side, const Data& d) const {
  const BodyFrame& frame = frame_[side];
  return vec3(d.xpos + 3 * frame.body) + ConstRowMat3Map(d.xmat + 9 * frame.body) * frame.p_BF;
}

double Robot::joint_margin(const Data& d) const {
  double margin = std::numeric_limits<double>::infinity();
  for (int j = 0; j < joints(); ++j) {
    const auto [low, high] = joint_range(j);
    const double q = d.qpos[qpos0_ + 7 + j];
    margin = std::min({margin, q - low, high - q});
  }
  return margin;
}

double Robot::sole_friction(Side side) const {
  const auto meet = [&](int a, int b) {
    return (m_.geom_contype[a] & m_.geom_conaffinity[b]) || (m_.geom_contype[b] & m_.geom_conaffinity[a]);
  };
  double least = std::numeric_limits<double>::infinity(), own = least;
  for (int a = 0; a < m_.ngeom; ++a) {
    if (!is_foot(side, m_.geom_bodyid[a]) || !(m_.geom_contype[a] || m_.geom_conaffinity[a])) continue;
    own = std::min(own, m_.geom_friction[3 * a]);
    for (int b = 0; b < m_.ngeom; ++b) {
      if (m_.body_weldid[m_.geom_bodyid[b]] != 0 || !meet(a, b)) continue;
      const int prior = m_.geom_priority[a] - m_.geom_priority[b];
      const double of_a = m_.geom_friction[3 * a], of_b = m_.geom_friction[3 * b];
      least = std::min(least, prior > 0 ? of_a : prior < 0 ? of_b : std::max(of_a, of_b));
    }
  }
  return std::isfinite(least) ? least : own;
}

Vec2 Robot::foot_reach(Side side) const {
  OwnData at_stand(m_);
  description_.place(m_, at_stand, 0.0);
  mj::kinematics(m_, at_stand);
  const BodyFrame& frame = frame_[side];
  const Mat3 R_WF = Mat3(ConstRowMat3Map(at_stand.xmat + 9 * frame.body)) * frame.R_BF;
  const Vec3 p_WF = sole_centre(side, at_stand);
  Vec2 reach = Vec2::Zero();
  for (int g = 0; g < m_.ngeom; ++g) {
    const int body = m_.geom_bodyid[g];
    if (!is_foot(side, body) || !(m_.geom_contype[g] || m_.geom_conaffinity[g])) continue;
    const Mat3 R_FB = R_WF.transpose() * ConstRowMat3Map(at_stand.xmat + 9 * body);
    const double* q = m_.geom_quat + 4 * g;
    const Mat3 R_FG = R_FB * Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
    const Vec3 p = R_WF.transpose() * (vec3(at_stand.xpos + 3 * body) - p_WF) + R_FB * vec3(m_.geom_pos + 3 * g);
    const Shape shape{m_, g};
    const auto far = [&](const Vec3& towards) { return towards.dot(p) + shape.extent(R_FG.transpose() * towards); };
    const Vec3 ahead = Vec3::UnitX(), inwards = -side_sign(side) * Vec3::UnitY();
    reach = reach.cwiseMax(Vec2(std::max(far(ahead), far(-ahead)), far(inwards)));
  }
  return reach;
}

std::pair<double, double> Robot::joint_range(int joint) const {
  const int id = m_.dof_jntid[dof0_ + 6 + joint];
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!m_.jnt_limited[id]) return {-kInfinity, kInfinity};
  return {m_.jnt_range[2 * id], m_.jnt_range[2 * id + 1]};
}

bool Robot::is_leg_joint(int joint) const {
  for (const auto& leg : leg_joints_)
    if (std::find(leg.begin(), leg.end(), joint) != leg.end()) return true;
  return false;
}

}  // namespace zmpwalk
