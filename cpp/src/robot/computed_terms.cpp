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

using ConstVecMap = Eigen::Map<const VecX>;

/// Largest distance of two rotations' matrices from each other, entry by entry; `q` (w, x, y, z) needs no length of one.
double distance(const double* q, const ConstRowMat3Map& R) {
  const double w = q[0], x = q[1], y = q[2], z = q[3], s = 2.0 / (w * w + x * x + y * y + z * z);
  Mat3 of_q;
  of_q << 1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y),  //
      s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x),      //
      s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y);
  return (of_q - R).cwiseAbs().maxCoeff();
}

}  // namespace

ComputedTerms::ComputedTerms(const Model& m, int root_body)
    : m_(m), root_body_(root_body), qpos0_(m.jnt_qposadr[m.body_jntadr[root_body]]), dof0_(m.body_dofadr[root_body]) {
  std::vector<bool> has_motor(m.njnt, false);
  std::vector<std::vector<double>> gears;
  for (int a = 0; a < m.nu; ++a) {
    if (m.actuator_trntype[a] != mj::kByJoint) continue;
    const int joint = m.actuator_trnid[2 * a], kind = m.jnt_type[joint];
    const double gear = m.actuator_gear[6 * a];
    if (m.body_rootid[m.jnt_bodyid[joint]] != root_body || (kind != mj::kHinge && kind != mj::kSlide) || gear == 0.0 ||
        has_motor[joint])
      continue;
    has_motor[joint] = true;
    const int qpos = m.jnt_qposadr[joint], dof = m.jnt_dofadr[joint];
    const auto follows = [&](const Motors& last) {
      return last.actuator + last.count == a && last.qpos + last.count == qpos && last.dof + last.count == dof;
    };
    if (motors_.empty() || !follows(motors_.back())) {
      motors_.push_back({a, qpos, dof, 0, {}, 0.0});
      gears.emplace_back();
    }
    ++motors_.back().count;
    gears.back().push_back(gear);
  }
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    motors_[i].gear = ConstVecMap(gears[i].data(), motors_[i].count);
    motors_[i].tolerance = kRounding * std::max(motors_[i].gear.cwiseAbs().maxCoeff(), 1.0);
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
  return distance(p + 3, ConstRowMat3Map(d.xmat + 9 * root_body_)) > kRounding;
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
  bool moved = base_moved(d), sped = base_sped(d), unsure = false;
  for (const Motors& each : motors_) {
    const auto off = [&](const double* of_motors, const double* of_joints) {
      return (ConstVecMap(of_motors + each.actuator, each.count) -
              each.gear.cwiseProduct(ConstVecMap(of_joints, each.count)))
                 .cwiseAbs()
                 .maxCoeff() > each.tolerance;
    };
    moved |= off(d.actuator_length, d.qpos + each.qpos);
    unsure |= off(d.actuator_velocity, d.qvel + each.dof);
  }
  for (const int body : unmotored_) sped |= !is_of_qvel(d, body);
  // Where the model's actuation is switched off, newer versions leave the motors without a speed.
  if (unsure)
    for (int body = root_body_ + 1; body < m_.nbody; ++body)
      if (m_.body_rootid[body] == root_body_ && m_.body_dofnum[body] > 0) sped |= !is_of_qvel(d, body);
  if (moved || sped)
    throw InputError(std::string("data's computed terms belong to another state than its ") +
                     (moved ? "qpos" : "qvel") +
                     ": call mj_step1 or mj_forward before this update, or let it compute them itself");
}

}  // namespace zmpwalk
