#include "zmpwalk/robot/actuation.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "zmpwalk/robot/mujoco_compat.hpp"
#include "zmpwalk/robot/words.hpp"

namespace zmpwalk {
namespace {

using mujoco_compat::control_address;
using mujoco_compat::force_address;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double gear(const mjModel* m, int actuator) { return m->actuator_gear[6 * force_address(m, actuator)]; }
double gain(const mjModel* m, int actuator) { return m->actuator_gainprm[mjNGAIN * actuator]; }
const mjtNum* bias(const mjModel* m, int actuator) { return m->actuator_biasprm + mjNBIAS * actuator; }

/// True where the force of the actuator is gain ctrl + bias, all of the same instant.
bool is_affine(const mjModel* m, int a) {
  const bool known_bias = m->actuator_biastype[a] == mjBIAS_NONE || m->actuator_biastype[a] == mjBIAS_AFFINE;
  return m->actuator_gaintype[a] == mjGAIN_FIXED && known_bias && m->actuator_dyntype[a] == mjDYN_NONE &&
         mujoco_compat::is_immediate(m, a) && gain(m, a) != 0.0;
}

/// True where the force of the actuator is gain ctrl: it is a plain torque motor.
bool is_motor(const mjModel* m, int a) {
  const mjtNum* b = bias(m, a);
  const bool no_bias = m->actuator_biastype[a] == mjBIAS_NONE || (b[0] == 0.0 && b[1] == 0.0 && b[2] == 0.0);
  return is_affine(m, a) && no_bias && gear(m, a) != 0.0;
}

std::string kind_of(const mjModel* m, int a) {
  const mjtNum* b = bias(m, a);
  if (m->actuator_gaintype[a] == mjGAIN_MUSCLE) return "muscle";
  if (is_motor(m, a)) return "motor";
  if (m->actuator_biastype[a] == mjBIAS_AFFINE && b[1] != 0.0) return "position servo";
  if (m->actuator_biastype[a] == mjBIAS_AFFINE && b[2] != 0.0) return "velocity servo";
  return "actuator";
}

/// Largest torque that the range of the control, or of the force, lets through both ways; infinity without a range [N m].
double limit_by_control(const mjModel* m, int a) {
  const int control = control_address(m, a);
  if (!is_motor(m, a) || !m->actuator_ctrllimited[control]) return kInfinity;
  const mjtNum* range = m->actuator_ctrlrange + 2 * control;
  return std::abs(gear(m, a) * gain(m, a)) * std::min(-range[0], range[1]);
}
double limit_by_force(const mjModel* m, int a) {
  if (!m->actuator_forcelimited[a]) return kInfinity;
  const mjtNum* range = m->actuator_forcerange + 2 * a;
  return std::abs(gear(m, a)) * std::min(-range[0], range[1]);
}

}  // namespace

const char* range_without_rest(const mjModel* m, int actuator) {
  if (!(limit_by_control(m, actuator) > 0.0)) return "ctrl";
  return limit_by_force(m, actuator) > 0.0 ? nullptr : "force";
}

bool turns_joint(const mjModel* m, int actuator, int joint) {
  const int kind = m->actuator_trntype[actuator];
  return (kind == mjTRN_JOINT || kind == mjTRN_JOINTINPARENT) && m->actuator_trnid[2 * actuator] == joint;
}

std::vector<int> tree_joints(const mjModel* m, int root) {
  std::vector<int> joints;
  for (int j = 0; j < m->njnt; ++j)
    if (m->body_rootid[m->jnt_bodyid[j]] == root && m->jnt_type[j] != mjJNT_FREE) joints.push_back(j);
  return joints;
}

std::vector<int> tendon_joints(const mjModel* m, int tendon) {
  std::vector<int> joints, bodies;
  for (int w = m->tendon_adr[tendon]; w < m->tendon_adr[tendon] + m->tendon_num[tendon]; ++w) {
    const int object = m->wrap_objid[w];
    if (m->wrap_type[w] == mjWRAP_JOINT)
      joints.push_back(object);
    else if (m->wrap_type[w] == mjWRAP_SITE)
      bodies.push_back(m->site_bodyid[object]);
    else if (m->wrap_type[w] == mjWRAP_SPHERE || m->wrap_type[w] == mjWRAP_CYLINDER)
      bodies.push_back(m->geom_bodyid[object]);
  }
  // A joint changes the path where some of its bodies hang from the joint and some do not.
  for (int j = 0; j < m->njnt; ++j) {
    const auto hangs = [&](int body) {
      while (body > 0 && body != m->jnt_bodyid[j]) body = m->body_parentid[body];
      return body > 0;
    };
    const auto count = std::count_if(bodies.begin(), bodies.end(), hangs);
    if (count > 0 && count < static_cast<long>(bodies.size())) joints.push_back(j);
  }
  return joints;
}

Actuation::Actuation(const mjModel* m, const std::vector<int>& joints, const std::map<std::string, double>& limits)
    : m_(m) {
  const int root_body = m->body_rootid[m->jnt_bodyid[joints.front()]];
  const int root = m->body_jntadr[root_body];
  qpos0_ = m->jnt_qposadr[root];
  dof0_ = m->jnt_dofadr[root];
  nv_ = 6 + static_cast<int>(joints.size());
  nq_ = nv_ + 1;
  std::map<int, std::vector<int>> pulled;  // joint -> actuators that act on it through a tendon
  for (int a = 0; a < mujoco_compat::actuator_count(m); ++a)
    if (m->actuator_trntype[a] == mjTRN_TENDON)
      for (const int j : tendon_joints(m, m->actuator_trnid[2 * a])) pulled[j].push_back(a);

  std::set<int> silenced;
  for (const int joint : joints) {
    const std::string name = object_name(m, mjOBJ_JOINT, joint);
    std::vector<int> acting;
    double model_limit = 0.0;
    for (int a = 0; a < mujoco_compat::actuator_count(m); ++a)
      if (turns_joint(m, a, joint)) {
        acting.push_back(a);
        model_limit += std::min(limit_by_control(m, a), limit_by_force(m, a));
      }
    if (acting.empty()) model_limit = kInfinity;
    acting.insert(acting.end(), pulled[joint].begin(), pulled[joint].end());
    model_limit = std::min(model_limit, mujoco_compat::joint_force_limit(m, joint));

    JointDrive drive;
    drive.limit = model_limit;
    const auto limit = limits.find(name);
    if (limit != limits.end()) drive.limit = limit->second;
    const bool by_gravity = mujoco_compat::compensates_gravity_by_actuator(m, joint);
    const auto named = [&](int a) { return kind_of(m, a) + " '" + object_name(m, mjOBJ_ACTUATOR, a) + "'"; };
    if (acting.size() == 1 && turns_joint(m, acting[0], joint) && is_motor(m, acting[0]) && !by_gravity) {
      drive.control = control_address(m, acting[0]);
      drive.scale = gear(m, acting[0]) * gain(m, acting[0]);
      drive.limit = std::min(drive.limit, model_limit);
      drive.path = named(acting[0]);
    } else {
      silenced.insert(acting.begin(), acting.end());
      drive.path = acting.empty()       ? "qfrc_applied: it has no actuator"
                   : acting.size() == 1 ? "qfrc_applied: " + named(acting[0]) + " is silenced"
                                        : "qfrc_applied: its " + std::to_string(acting.size()) +
                                              " actuators are silenced (" + named(acting[0]) + ", ...)";
    }
    subtracts_ = subtracts_ || (drive.control < 0 && (!acting.empty() || by_gravity));
    dofs_.push_back(m->jnt_dofadr[joint]);
    drives_.push_back(std::move(drive));
  }
  silenced_.assign(silenced.begin(), silenced.end());
}

void Actuation::write(const ConstVecRef& tau, mjData* d, mjData* own) const {
  if (subtracts_) silence(d, own);
  for (std::size_t j = 0; j < drives_.size(); ++j) {
    const JointDrive& drive = drives_[j];
    const double torque = tau[static_cast<Eigen::Index>(j)];
    if (drive.control >= 0)
      d->ctrl[drive.control] = torque / drive.scale;
    else
      d->qfrc_applied[dofs_[j]] = torque - own->qfrc_actuator[dofs_[j]];
  }
}

void Actuation::silence(mjData* d, mjData* own) const {
  std::copy_n(d->qpos + qpos0_, nq_, own->qpos + qpos0_);
  std::copy_n(d->qvel + dof0_, nv_, own->qvel + dof0_);
  std::copy_n(d->act, m_->na, own->act);
  mj_kinematics(m_, own);
  mj_comPos(m_, own);
  mj_tendon(m_, own);
  mj_transmission(m_, own);
  mj_fwdVelocity(m_, own);
  for (const int a : silenced_) {
    const int control = control_address(m_, a), force = force_address(m_, a);
    for (int i = 0; i < mujoco_compat::control_count(m_, a); ++i) own->ctrl[control + i] = d->ctrl[control + i] = 0.0;
    if (!is_affine(m_, a) || m_->actuator_biastype[a] == mjBIAS_NONE) continue;
    const mjtNum* b = bias(m_, a);
    const double at_rest = b[0] + b[1] * own->actuator_length[force] + b[2] * own->actuator_velocity[force];
    own->ctrl[control] = d->ctrl[control] = -at_rest / gain(m_, a);
  }
  mj_fwdActuation(m_, own);
}

}  // namespace zmpwalk
