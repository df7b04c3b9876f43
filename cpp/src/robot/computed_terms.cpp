#include "zmpwalk/robot/computed_terms.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/math/types.hpp"

namespace zmpwalk {
namespace {

constexpr double kRounding = 1e-9;  // of numbers of the size of one

using ConstVec3Map = Eigen::Map<const Vec3>;
using ConstVec6Map = Eigen::Map<const Vec6>;
using ConstRowMat3Map = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

bool differ(double a, double b) { return std::abs(a - b) > kRounding * (1.0 + std::abs(b)); }

}  // namespace

ComputedTerms::ComputedTerms(const Model& m, int root_body)
    : m_(m), root_body_(root_body), qpos0_(m.jnt_qposadr[m.body_jntadr[root_body]]), dof0_(m.body_dofadr[root_body]) {
  std::vector<bool> has_motor(m.njnt, false);
  for (int a = 0; a < m.nu; ++a) {
    if (m.actuator_trntype[a] != mj::kByJoint) continue;
    const int joint = m.actuator_trnid[2 * a], kind = m.jnt_type[joint];
    const double gear = m.actuator_gear[6 * a];
    if (m.body_rootid[m.jnt_bodyid[joint]] != root_body || (kind != mj::kHinge && kind != mj::kSlide) || gear == 0.0)
      continue;
    if (!has_motor[joint]) motored_.push_back({a, m.jnt_qposadr[joint], m.jnt_dofadr[joint], gear});
    has_motor[joint] = true;
  }
  for (int joint = 0; joint < m.njnt; ++joint) {
    const int body = m.jnt_bodyid[joint];
    const bool is_new = unmotored_.empty() || unmotored_.back() != body;
    if (body != root_body && m.body_rootid[body] == root_body && !has_motor[joint] && is_new)
      unmotored_.push_back(body);
  }
}

bool ComputedTerms::base_moved(const Data& d) const {
  const double *p = d.qpos + qpos0_, *at = d.xpos + 3 * root_body_;
  if (p[0] != at[0] || p[1] != at[1] || p[2] != at[2]) return true;
  const Eigen::Quaterniond q(p[3], p[4], p[5], p[6]);
  const ConstRowMat3Map R_WB(d.xmat + 9 * root_body_);
  return (q.normalized().toRotationMatrix() - R_WB).cwiseAbs().maxCoeff() > kRounding;
}

bool ComputedTerms::base_sped(const Data& d) const {
  // MuJoCo keeps spatial velocities (angular, linear) about the COM of the tree, and the base's angular velocity in its own axes.
  const ConstVec3Map v(d.qvel + dof0_), omega_B(d.qvel + dof0_ + 3);
  const double* cvel = d.cvel + 6 * root_body_;
  const ConstVec3Map omega(cvel), v_com(cvel + 3);
  const Vec3 arm = ConstVec3Map(d.subtree_com + 3 * root_body_) - ConstVec3Map(d.xpos + 3 * root_body_);
  const Vec3 turn = ConstRowMat3Map(d.xmat + 9 * root_body_) * omega_B, at_com = v + turn.cross(arm);
  const double size = 1.0 + turn.squaredNorm() + at_com.squaredNorm();
  return (turn - omega).squaredNorm() + (at_com - v_com).squaredNorm() > kRounding * kRounding * size;
}

bool ComputedTerms::is_of_qvel(const Data& d, int body) const {
  Vec6 cvel = ConstVec6Map(d.cvel + 6 * m_.body_parentid[body]);
  for (int i = m_.body_dofadr[body]; i < m_.body_dofadr[body] + m_.body_dofnum[body]; ++i)
    cvel += ConstVec6Map(d.cdof + 6 * i) * d.qvel[i];
  return (cvel - ConstVec6Map(d.cvel + 6 * body)).norm() <= kRounding * (1.0 + cvel.norm());
}

void ComputedTerms::require(const Data& d) const {
  bool moved = base_moved(d), sped = base_sped(d);
  for (const Motored& each : motored_) {
    moved |= differ(d.actuator_length[each.actuator], each.gear * d.qpos[each.qpos]);
    sped |= differ(d.actuator_velocity[each.actuator], each.gear * d.qvel[each.dof]);
  }
  for (const int body : unmotored_) sped |= !is_of_qvel(d, body);
  if (moved || sped)
    throw InputError(std::string("data's computed terms belong to another state than its ") +
                     (moved ? "qpos" : "qvel") +
                     ": call mj_step1 or mj_forward before this update, or let it compute them itself");
}

}  // namespace zmpwalk
