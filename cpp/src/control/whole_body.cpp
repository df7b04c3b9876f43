#include "zmpwalk/control/whole_body.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>

#include "zmpwalk/control/wrench_distribution.hpp"
#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

WholeBodyController::WholeBodyController(int nv, const std::array<std::vector<int>, 2>& legs,
                                         const WholeBodyOptions& options)
    : nv_(nv),
      legs_(legs),
      options_(options),
      ddq_(MatX3::Zero(nv, 3)),
      w_(MatX3::Zero(nv, 3)),
      F_(Mat3::Zero()),
      M_(Mat3::Zero()),
      tau_(MatX3::Zero(nv - 6, 3)),
      f_c_(MatX3::Zero(12, 3)) {
  for (int i = 0; i < 3; ++i) unknown_[i] = i;
  for (const Side side : kSides) {
    require_size("legs[side]", static_cast<long>(legs[side].size()), 6);
    for (int i = 0; i < 6; ++i) {
      if (legs[side][i] < 0 || legs[side][i] >= nv - 6)
        throw DimensionError("leg joint index " + std::to_string(legs[side][i]) + " is outside 0.." +
                             std::to_string(nv - 7));
      unknown_[3 + 6 * side + i] = 6 + legs[side][i];
    }
  }
  for (int j = 0; j < nv - 6; ++j)
    if (std::find(unknown_.begin() + 3, unknown_.end(), 6 + j) == unknown_.end()) posture_.push_back(j);
}

WholeBodyResult WholeBodyController::result() const {
  WholeBodyResult out;
  out.tau = VecX::Zero(nv_ - 6);
  out.ddq = VecX::Zero(nv_);
  return out;
}

void WholeBodyController::prepare(const Dynamics& dynamics, const Stance& stance, const TaskAccelerations& f_star) {
  require_size("dynamics.dq", dynamics.nv(), nv_);
  require_size("f_star.posture", f_star.posture.size(), nv_ - 6);
  if (!stance.standing[kLeft] && !stance.standing[kRight])
    throw InputError("no foot stands; walking needs at least one");
  dynamics_ = &dynamics;
  stance_ = stance;
  if (uses_textbook())
    prepare_textbook(f_star);
  else
    prepare_direct(f_star);
  for (int k = 0; k < 2; ++k) zmp_slope_.col(k) = zmp_of_wrench(F_.col(0), M_.col(k + 1));
  zmp_0_ = dynamics.sole[stance.support].p_WF.head<2>() + zmp_of_wrench(F_.col(0), M_.col(0));
}

void WholeBodyController::prepare_direct(const TaskAccelerations& f_star) {
  const Dynamics& dyn = *dynamics_;
  // Known rows of ddq: base rotation from the trunk task (base axes), posture joints from theirs.
  ddq_.setZero();
  ddq_.col(0).segment<3>(3).noalias() = dyn.R_WB.transpose() * f_star.trunk;
  for (const int j : posture_) ddq_(6 + j, 0) = f_star.posture[j];

  // K x = rhs for base translation and legs: sole rows (standing: at rest; swinging: f*), then COM rows.
  MatK K;
  MatK3 x = MatK3::Zero();
  int row = 0;
  for (const Side side : kSides) {
    const SoleState& sole = dyn.sole[side];
    for (int i = 0; i < kUnknowns; ++i) K.block<6, 1>(row, i) = sole.J.col(unknown_[i]);
    auto rhs = x.block<6, 1>(row, 0);
    if (stance_.standing[side])
      rhs = -sole.drift - damping_of(side) * sole.velocity;
    else
      rhs = f_star.swing - sole.drift;
    rhs.noalias() -= sole.J.middleCols<3>(3) * ddq_.block<3, 1>(3, 0);
    for (const int j : posture_) rhs -= sole.J.col(6 + j) * ddq_(6 + j, 0);
    row += 6;
  }
  for (int i = 0; i < kUnknowns; ++i) K.block<3, 1>(row, i) = dyn.J_com.col(unknown_[i]);
  auto rhs = x.block<3, 1>(row, 0);
  rhs = Vec3(0, 0, f_star.com.z()) - dyn.drift_com;
  rhs.noalias() -= dyn.J_com.middleCols<3>(3) * ddq_.block<3, 1>(3, 0);
  for (const int j : posture_) rhs -= dyn.J_com.col(6 + j) * ddq_(6 + j, 0);
  x(row, 1) = x(row + 1, 2) = 1.0;

  const Eigen::PartialPivLU<MatK> lu(K);
  damped_ = lu.matrixLU().diagonal().cwiseAbs().minCoeff() < options_.singular_pivot;
  if (damped_) {
    MatK gram = K * K.transpose();
    gram.diagonal().array() += options_.damping * options_.damping;
    x = K.transpose() * Eigen::LLT<MatK>(gram).solve(x);
  } else {
    x = lu.solve(x).eval();
  }
  for (int i = 0; i < kUnknowns; ++i) ddq_.row(unknown_[i]) = x.row(i);

  w_.noalias() = dyn.A * ddq_;
  w_.col(0) += dyn.b + dyn.g;
  // Base rows: the feet's forces add up to -w_1..3; their moment about the base, in base axes, to -w_4..6.
  F_ = -w_.topRows<3>();
  M_.noalias() = -(dyn.R_WB * w_.middleRows<3>(3));
  const Vec3 arm = dyn.p_WB - dyn.sole[stance_.support].p_WF;
  for (int k = 0; k < 3; ++k) M_.col(k) += arm.cross(F_.col(k));
}

void WholeBodyController::prepare_textbook(const TaskAccelerations& f_star) {
  const Dynamics& dyn = *dynamics_;
  const bool both = stance_.both();
  const int joints = nv_ - 6, posture = options_.posture_task ? static_cast<int>(posture_.size()) : 0;

  RowMatX J_c(both ? 12 : 6, nv_);
  VecX drift_c(J_c.rows());
  int row = 0;
  for (const Side side : kSides) {
    if (!stance_.standing[side]) continue;
    J_c.middleRows<6>(row) = dyn.sole[side].J;
    drift_c.segment<6>(row) = dyn.sole[side].drift + damping_of(side) * dyn.sole[side].velocity;
    row += 6;
  }
  RowMatX J = RowMatX::Zero((both ? 6 : 12) + posture, nv_);
  VecX drift = VecX::Zero(J.rows()), f(J.rows());
  J.topRows<3>() = dyn.J_com;
  drift.head<3>() = dyn.drift_com;
  f.head<3>() = Vec3(0, 0, f_star.com.z());
  J.block<3, 3>(3, 3) = dyn.R_WB;
  f.segment<3>(3) = f_star.trunk;
  row = 6;
  if (!both) {
    const SoleState& sole = dyn.sole[stance_.swing()];
    J.middleRows<6>(row) = sole.J;
    drift.segment<6>(row) = sole.drift;
    f.segment<6>(row) = f_star.swing;
    row += 6;
  }
  for (int i = 0; i < posture; ++i, ++row) {
    J(row, 6 + posture_[i]) = 1.0;
    f[row] = f_star.posture[posture_[i]];
  }

  ContactSpace contact(nv_, static_cast<int>(J_c.rows()));
  contact.compute(dyn.A, dyn.b, dyn.g, J_c, drift_c);
  const TaskSpace task(contact, dyn.b, dyn.g, J, drift);
  tau_.col(0) = task.torque(task.force(f));
  tau_.rightCols<2>() = task.J_k.transpose() * task.Lambda.leftCols<2>();
  f_c_.setConstant(kNaN);
  const RowMatX JbarT = contact.JbarT_c().rightCols(joints);
  const int first = stance_.standing[kLeft] ? 0 : 6;
  contact.wrench(tau_.col(0), f_c_.block(first, 0, J_c.rows(), 1).col(0));
  f_c_.block(first, 1, J_c.rows(), 2) = JbarT * tau_.rightCols<2>();
  for (int k = 0; k < 3; ++k) {
    const Wrench total =
        total_wrench(f_c_.col(k), {dyn.sole[kLeft].p_WF, dyn.sole[kRight].p_WF}, dyn.sole[stance_.support].p_WF);
    F_.col(k) = total.F;
    M_.col(k) = total.M;
  }
  if (both) {
    V_n_ = task.V_n;
    G_ = JbarT * V_n_;
  }
  // Motion of the torque, from the equation of motion.
  VecX S_tau = VecX::Zero(nv_);
  for (int k = 0; k < 3; ++k) {
    S_tau.tail(joints) = tau_.col(k);
    VecX force = S_tau - J_c.transpose() * f_c_.block(first, k, J_c.rows(), 1);
    if (k == 0) force -= dyn.b + dyn.g;
    ddq_.col(k) = contact.A_inv() * force;
  }
  damped_ = false;
}

void WholeBodyController::solve(const Vec2& f_xy, WholeBodyResult& out) const {
  if (!dynamics_) throw InputError("solve was called before prepare");
  const Dynamics& dyn = *dynamics_;
  const Vec3 at(1.0, f_xy.x(), f_xy.y());
  out.ddq.noalias() = ddq_ * at;
  out.damped = damped_;

  const Vec3& s = dyn.sole[stance_.support].p_WF;
  const Vec3 F = F_ * at, M = M_ * at;
  out.f_c.setConstant(kNaN);
  if (stance_.both()) {
    Vec3 P = s;
    P.head<2>() += zmp_of_wrench(F, M);
    const Vec3 M_P = M - (P - s).cross(F);
    out.f_c = distribute_wrench(F, M_P, P, {dyn.sole[kLeft].p_WF, dyn.sole[kRight].p_WF}, stance_.lateral);
  } else {
    const Side side = stance_.standing[kLeft] ? kLeft : kRight;
    out.f_c.segment<3>(6 * side) = F;
    out.f_c.segment<3>(6 * side + 3) = M + (s - dyn.sole[side].p_WF).cross(F);
  }

  if (uses_textbook()) {
    out.tau.noalias() = tau_ * at;
    if (stance_.both()) {
      const Vec12 f_c = f_c_ * at;
      if (options_.wrench_distribution)
        out.tau += V_n_ * G_.colPivHouseholderQr().solve(out.f_c - f_c);
      else
        out.f_c = f_c;
    }
    return;
  }
  out.tau.noalias() = w_.bottomRows(nv_ - 6) * at;
  for (const Side side : kSides)
    if (stance_.standing[side])
      out.tau.noalias() += dyn.sole[side].J.rightCols(nv_ - 6).transpose() * out.f_c.segment<6>(6 * side);
}

}  // namespace zmpwalk
