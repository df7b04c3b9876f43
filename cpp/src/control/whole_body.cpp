#include "zmpwalk/control/whole_body.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>

#include "zmpwalk/control/wrench_distribution.hpp"
#include "zmpwalk/math/error.hpp"

namespace zmpwalk {
namespace {

/// Joints that are in no leg. @throws DimensionError  a leg of other than six joints, or one that is not there
std::vector<int> outside_the_legs(int nv, const std::array<std::vector<int>, 2>& legs) {
  std::vector<bool> in_leg(static_cast<std::size_t>(nv - 6));
  for (const auto& leg : legs) {
    require_size("legs[side]", static_cast<long>(leg.size()), 6);
    for (const int joint : leg) {
      if (joint < 0 || joint >= nv - 6)
        throw DimensionError("leg joint index " + std::to_string(joint) + " is outside 0.." + std::to_string(nv - 7));
      in_leg[static_cast<std::size_t>(joint)] = true;
    }
  }
  std::vector<int> out;
  for (int j = 0; j < nv - 6; ++j)
    if (!in_leg[static_cast<std::size_t>(j)]) out.push_back(j);
  return out;
}

/// Velocity coordinates of the base's translation, then of the legs.
std::array<int, TaskSolver::kUnknowns> unknowns_of(const std::array<std::vector<int>, 2>& legs) {
  std::array<int, TaskSolver::kUnknowns> out{0, 1, 2};
  for (const Side side : kSides)
    for (int i = 0; i < 6; ++i) out[3 + 6 * side + i] = 6 + legs[side][i];
  return out;
}

}  // namespace

TaskSlack::TaskSlack(int nv)
    : f_c(Eigen::Matrix<double, 12, kColumns>::Zero()), leg_ddq(Legs::Zero()), leg_tau(Legs::Zero()) {
  ddq.fill(TaskSolver::Affine::Zero(nv, 4));
  w.fill(TaskSolver::Affine::Zero(nv, 4));
}

WholeBodyController::WholeBodyController(int nv, const std::array<std::vector<int>, 2>& legs,
                                         const WholeBodyOptions& options)
    : nv_(nv),
      legs_(legs),
      posture_(outside_the_legs(nv, legs)),
      unknown_(unknowns_of(legs)),
      options_(options),
      task_solver_(unknown_, posture_),
      kernel_(&kernel(options.kernel)),
      known_(VecX::Zero(nv)),
      ddq_(Affine::Zero(nv, 4)),
      w_(Affine::Zero(nv, 4)),
      F_(Mat3::Zero()),
      M_(Mat3::Zero()),
      tau_(MatX3::Zero(nv - 6, 3)),
      f_c_(MatX3::Zero(12, 3)) {}

WholeBodyResult WholeBodyController::result() const {
  WholeBodyResult out;
  out.tau = VecX::Zero(nv_ - 6);
  out.ddq = VecX::Zero(nv_);
  return out;
}

void WholeBodyController::require_tasks_possible() const {
  if (uses_textbook())
    throw InputError("tasks need the direct path: textbook off, posture_task and wrench_distribution on");
}

void WholeBodyController::reserve(const TaskStack& tasks) { task_solver_.reserve(tasks); }

void WholeBodyController::prepare(const Dynamics& dynamics, const Stance& stance, const TaskAccelerations& f_star,
                                  const TaskStack* tasks) {
  require_size("dynamics.dq", dynamics.nv(), nv_);
  require_size("f_star.posture", f_star.posture.size(), nv_ - 6);
  if (!stance.standing[kLeft] && !stance.standing[kRight])
    throw InputError("no foot stands; walking needs at least one");
  if (tasks && !task_solver_.fits(*tasks)) throw InputError("these tasks are not those that reserve() was called with");
  if (tasks && !tasks->idle()) require_tasks_possible();
  dynamics_ = &dynamics;
  stance_ = stance;
  for (const Side side : kSides) {
    const auto& sole = dynamics.sole[side];
    feet_[side] = {sole.p_WF, sole.R_WF, stance.standing[side], stance.ground[side]};
  }
  plane_ = common_plane(feet_, stance.support);
  if (uses_textbook())
    prepare_textbook(f_star);
  else
    prepare_direct(f_star, tasks);
  expand_zmp();
}

void WholeBodyController::expand_zmp() {
  // P(f) = s + n x M(f) / (n F(f)) for the plane through s. With p_k = n x M_k / (n F_0) and d_k = n F_k / (n F_0) that is
  // P(f) = s + (p_0 + sum p_k f_k) / (1 + d f) = s + p_0 + sum (p_k - p_0 d_k) f_k / (1 + d f). F_z is the same for every f.
  const Vec3 &s = feet_[stance_.support].p_WF, &n = plane_.normal, F_0 = F_.col(0);
  const Vec3 P_0 = zmp_on_plane(F_0, M_.col(0), s, plane_);
  zmp_0_ = P_0.head<2>();
  for (int k = 0; k < 2; ++k) {
    load_slope_[k] = n.head<2>().dot(F_.col(k + 1).head<2>()) / n.dot(F_0);
    const Vec3 p_k = zmp_on_plane(F_0, M_.col(k + 1), Vec3::Zero(), {n, 0.0});
    zmp_slope_.col(k) = (p_k - load_slope_[k] * (P_0 - s)).head<2>();
  }
}

void WholeBodyController::prepare_direct(const TaskAccelerations& f_star, const TaskStack* tasks) {
  const Dynamics& dyn = *dynamics_;
  // Known entries of ddq: base rotation from the trunk task (base axes), posture joints from theirs.
  known_.segment<3>(3).noalias() = dyn.R_WB.transpose() * f_star.trunk;
  for (const int j : posture_) known_[6 + j] = f_star.posture[j];

  // Sole rows (standing: at rest; swinging: f*), COM rows.
  MotionRows rows;
  for (const Side side : kSides) {
    const FrameState& sole = dyn.sole[side];
    if (stance_.standing[side])
      rows.sole[side] = -sole.drift - damping_of(side) * sole.velocity;
    else
      rows.sole[side] = f_star.swing - sole.drift;
    kernel_->subtract_product(nv_, sole.J.data(), known_.data(), rows.sole[side].data());
  }
  rows.com = Vec3(0, 0, f_star.com.z()) - dyn.drift_com;
  rows.com -= dyn.J_com.lazyProduct(known_);

  ddq_.col(0) = known_;
  if (tasks_acted_) ddq_.middleCols<2>(1).setZero();  // else the slopes of what is known are zero already
  tasks_acted_ = tasks && !tasks->idle();
  if (!solve_by_leg(rows)) solve_together(rows);
  if (tasks_acted_) {
    task_solver_.prepare(dyn, rows_together(), damped_ ? options_.damping : 0.0);
    task_solver_.correct(*tasks, options_.singular_task, ddq_);
  }

  kernel_->multiply(nv_, dyn.A.data(), dyn.A_sparsity.spans(), ddq_.data(), w_.data());
  w_.col(0) += dyn.b + dyn.g;
  // Base rows: the feet's forces add up to -w_1..3; their moment about the base, in base axes, to -w_4..6.
  F_ = -w_.topLeftCorner<3, 3>();
  M_.noalias() = -(dyn.R_WB * w_.block<3, 3>(3, 0));
  const Vec3 arm = dyn.p_WB - dyn.sole[stance_.support].p_WF;
  for (int k = 0; k < 3; ++k) M_.col(k) += arm.cross(F_.col(k));
}

bool WholeBodyController::solve_by_leg(const MotionRows& rows) {
  // Rows of a sole: [I; 0] x_b + J_leg x_leg = r, so x_leg = y - Y x_b with [y, Y] = J_leg^-1 [r, [I; 0]].
  // Rows of the COM: x_b + sum of J_com,leg x_leg = r_com + [f_xy; 0], so (I - sum J_com,leg Y) x_b = r_com - sum J_com,leg y + [f_xy; 0].
  const Dynamics& dyn = *dynamics_;
  std::array<Eigen::Matrix<double, 6, 12, Eigen::RowMajor>, 2> system;  // [J_leg, 0, r, [I; 0]] becomes [., ., y, Y]
  Mat3 S = Mat3::Identity();
  Vec3 r = rows.com;
  for (const Side side : kSides) {
    Eigen::Matrix<double, 3, 6> J_com;
    for (int i = 0; i < 6; ++i) {
      const int dof = 6 + legs_[side][i];
      system[side].col(i) = dyn.sole[side].J.col(dof);
      J_com.col(i) = dyn.J_com.col(dof);
    }
    system[side].middleCols<2>(6).setZero();
    system[side].col(8) = rows.sole[side];
    system[side].rightCols<3>().setIdentity();
    if (!(kernel_->solve_leg(system[side].data()) >= options_.singular_pivot)) return false;
    r.noalias() -= J_com.lazyProduct(system[side].col(8));
    S.noalias() -= J_com.lazyProduct(system[side].rightCols<3>());
  }
  const double determinant = S.determinant();
  if (!(std::abs(determinant) >= options_.singular_pivot)) return false;
  const Mat3 S_inv = S.inverse();
  Mat3 x_b;  // columns: value, slope in x, slope in y
  x_b << S_inv * r, S_inv.leftCols<2>();
  ddq_.topLeftCorner<3, 3>() = x_b;
  for (const Side side : kSides) {
    Eigen::Matrix<double, 6, 3> x = -system[side].rightCols<3>().lazyProduct(x_b);
    x.col(0) += system[side].col(8);
    for (int i = 0; i < 6; ++i) ddq_.row(6 + legs_[side][i]).head<3>() = x.row(i);
  }
  damped_ = false;
  return true;
}

TaskSolver::Rows WholeBodyController::rows_together() const {
  const Dynamics& dyn = *dynamics_;
  TaskSolver::Rows K;
  for (int i = 0; i < kUnknowns; ++i)
    K.col(i) << dyn.sole[kLeft].J.col(unknown_[i]), dyn.sole[kRight].J.col(unknown_[i]), dyn.J_com.col(unknown_[i]);
  return K;
}

void WholeBodyController::solve_together(const MotionRows& rows) {
  // K x = rhs for base translation and legs at once: a straight leg alone may be singular where all together are not.
  const TaskSolver::Rows K = rows_together();
  Eigen::Matrix<double, kUnknowns, 3> x = Eigen::Matrix<double, kUnknowns, 3>::Zero();
  x.col(0) << rows.sole[kLeft], rows.sole[kRight], rows.com;
  x(12, 1) = x(13, 2) = 1.0;

  const Eigen::PartialPivLU<TaskSolver::Rows> lu(K);
  damped_ = lu.matrixLU().diagonal().cwiseAbs().minCoeff() < options_.singular_pivot;
  if (damped_) {
    TaskSolver::Rows gram = K * K.transpose();
    gram.diagonal().array() += options_.damping * options_.damping;
    x = K.transpose() * Eigen::LLT<TaskSolver::Rows>(gram).solve(x);
  } else {
    x = lu.solve(x).eval();
  }
  for (int i = 0; i < kUnknowns; ++i) ddq_.row(unknown_[i]).head<3>() = x.row(i);
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
    const FrameState& sole = dyn.sole[stance_.swing()];
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

double WholeBodyController::yaw_moment(const Vec2& f_xy) const {
  if (!dynamics_) throw InputError("yaw_moment was called before prepare");
  const Vec3 at(1.0, f_xy.x(), f_xy.y()), arm = dynamics_->com - dynamics_->sole[stance_.support].p_WF, F = F_ * at;
  return arm.cross(F).z() - M_.row(2).dot(at) + dynamics_->M_ext.z();
}

void WholeBodyController::solve(const Vec2& f_xy, WholeBodyResult& out) const {
  if (!dynamics_) throw InputError("solve was called before prepare");
  const Dynamics& dyn = *dynamics_;
  const Vec3 at(1.0, f_xy.x(), f_xy.y());
  const Eigen::Vector4d at_4(1.0, f_xy.x(), f_xy.y(), 0.0);
  out.ddq = ddq_.lazyProduct(at_4);
  out.damped = damped_;

  const Vec3& s = dyn.sole[stance_.support].p_WF;
  const Vec3 F = F_ * at, M = M_ * at;
  out.f_c.setConstant(kNaN);
  if (stance_.both()) {
    const Vec3 P = zmp_on_plane(F, M, s, plane_);
    const Vec3 M_P = M - (P - s).cross(F);
    out.f_c = distribute_wrench(F, M_P, P, {dyn.sole[kLeft].p_WF, dyn.sole[kRight].p_WF}, stance_.lateral,
                                options_.load_alone);
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
  std::array<Vec6, 2> f;
  for (const Side side : kSides)
    f[side] = stance_.standing[side] ? Vec6(out.f_c.segment<6>(6 * side)) : Vec6(Vec6::Zero());
  kernel_->joint_torque(nv_ - 6, w_.row(6).data(), at_4.data(), dyn.sole[kLeft].J.col(6).data(), f[kLeft].data(),
                        dyn.sole[kRight].J.col(6).data(), f[kRight].data(), out.tau.data());
}

Vec2 WholeBodyController::zmp_of(const Vec12& f_c) const {
  const Vec3& s = feet_[stance_.support].p_WF;
  const Wrench total = total_wrench(f_c, {feet_[kLeft].p_WF, feet_[kRight].p_WF}, s);
  return zmp_on_plane(total.F, total.M, s, plane_).head<2>();
}

bool WholeBodyController::answers_by_leg(const Answers& rhs, Answers& x) const {
  // As in `solve_by_leg`, for many right sides: with the inverse of each J_leg.
  const Dynamics& dyn = *dynamics_;
  std::array<Eigen::Matrix<double, 6, 6>, 2> inverse;
  Mat3 S = Mat3::Identity();
  Eigen::Matrix<double, 3, TaskSlack::kColumns> r = rhs.bottomRows<3>();
  for (const Side side : kSides) {
    Eigen::Matrix<double, 3, 6> J_com;
    Eigen::Matrix<double, 6, 12, Eigen::RowMajor> system = Eigen::Matrix<double, 6, 12, Eigen::RowMajor>::Zero();
    for (int i = 0; i < 6; ++i) J_com.col(i) = dyn.J_com.col(6 + legs_[side][i]);
    for (const int first : {0, 2}) {
      for (int i = 0; i < 6; ++i) system.col(i) = dyn.sole[side].J.col(6 + legs_[side][i]);
      system.rightCols<4>().setZero();
      system.block<4, 4>(first, 8).setIdentity();
      if (!(kernel_->solve_leg(system.data()) >= options_.singular_pivot)) return false;
      inverse[side].middleCols<4>(first) = system.rightCols<4>();
    }
    x.middleRows<6>(3 + 6 * side) = inverse[side].lazyProduct(rhs.middleRows<6>(6 * side));
    r -= J_com.lazyProduct(x.middleRows<6>(3 + 6 * side));
    S -= J_com.lazyProduct(inverse[side].leftCols<3>());
  }
  if (!(std::abs(S.determinant()) >= options_.singular_pivot)) return false;
  x.topRows<3>() = S.inverse().lazyProduct(r);
  for (const Side side : kSides)
    x.middleRows<6>(3 + 6 * side) -= inverse[side].leftCols<3>().lazyProduct(x.topRows<3>());
  return true;
}

void WholeBodyController::answers_together(const Answers& rhs, Answers& x) const {
  const TaskSolver::Rows K = rows_together();
  if (damped_) {
    TaskSolver::Rows gram = K * K.transpose();
    gram.diagonal().array() += options_.damping * options_.damping;
    x = K.transpose() * Eigen::LLT<TaskSolver::Rows>(gram).solve(rhs);
  } else {
    x = Eigen::PartialPivLU<TaskSolver::Rows>(K).solve(rhs);
  }
}

void WholeBodyController::slack(const TaskGive& give, const WholeBodyResult& now, TaskSlack& out) const {
  const Dynamics& dyn = *dynamics_;
  const bool both = stance_.both();
  // Rows of both soles and of the COM: what is asked of them, less what the trunk's turn does to them.
  Answers rhs = Answers::Zero(), x;
  rhs(12, 0) = rhs(13, 1) = give.com;
  rhs(14, 2) = give.height;
  const Mat3 turn = give.trunk * dyn.R_WB.transpose();  // columns of the base's rotation, in its axes
  for (const Side side : kSides) rhs.block<6, 3>(6 * side, 3) = -dyn.sole[side].J.middleCols<3>(3).lazyProduct(turn);
  rhs.block<3, 3>(12, 3) = -dyn.J_com.middleCols<3>(3).lazyProduct(turn);
  if (!both)
    for (int k = 0; k < 6; ++k) rhs(6 * stance_.swing() + k, 6 + k) = k < 3 ? give.swing : give.swing_angular;
  if (damped_ || !answers_by_leg(rhs, x)) answers_together(rhs, x);

  const Vec3& s = dyn.sole[stance_.support].p_WF;
  const Vec3 base = dyn.p_WB - s;
  Eigen::Matrix<double, 3, TaskSlack::kColumns> F, M;  // of both feet, the moment about s
  for (int g = 0; g < TaskSlack::kGroups; ++g) {
    TaskSolver::Affine &ddq = out.ddq[g], &w = out.w[g];
    for (int i = 0; i < kUnknowns; ++i) ddq.row(unknown_[i]) = x.block<1, 4>(i, 4 * g);
    for (int c = 0; c < 4; ++c) {
      const int k = 4 * g + c;
      ddq.col(c).segment<3>(3) = k >= 3 && k < 6 ? Vec3(turn.col(k - 3)) : Vec3(Vec3::Zero());
    }
    kernel_->multiply(nv_, dyn.A.data(), dyn.A_sparsity.spans(), ddq.data(), w.data());
    F.middleCols<4>(4 * g) = -w.topRows<3>();
    M.middleCols<4>(4 * g) = -dyn.R_WB.lazyProduct(w.middleRows<3>(3));
  }
  out.leg_ddq = x.bottomRows<12>();
  for (int k = 0; k < TaskSlack::kColumns; ++k) M.col(k) += base.cross(F.col(k));

  // Wrenches from the base's rows, torques from the joints' rows.
  const double left = both ? now.f_c[2] / (now.f_c[2] + now.f_c[8]) : 1.0;
  const Vec3 middle = 0.5 * (dyn.sole[kLeft].p_WF + dyn.sole[kRight].p_WF);
  for (const Side side : kSides) {
    auto f = out.f_c.middleRows<6>(6 * side);
    f.setZero();
    const Vec3 &p = dyn.sole[side].p_WF, arm = s - p;
    const double share = side == kLeft || !both ? left : 1.0 - left;
    for (int k = 0; stance_.standing[side] && k < TaskSlack::kColumns; ++k) {
      f.col(k) << share * F.col(k), share * (M.col(k) + arm.cross(F.col(k)));
      if (!both || k < 6) continue;
      Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
      (k < 9 ? force : moment)[k % 3] = side_sign(side) * (k < 9 ? give.load_force : give.load_moment);
      f.col(k) << force, moment + (middle - p).cross(force);
    }
    for (int i = 0; i < 6; ++i) {
      const int dof = 6 + legs_[side][i];
      auto tau = out.leg_tau.row(6 * side + i);
      tau << out.w[0].row(dof), out.w[1].row(dof), out.w[2].row(dof);
      if (stance_.standing[side]) tau += dyn.sole[side].J.col(dof).transpose().lazyProduct(f);
    }
  }
}

void WholeBodyController::apply(const TaskSlack& slack, const Eigen::Matrix<double, TaskSlack::kColumns, 1>& y,
                                WholeBodyResult& out) const {
  const Dynamics& dyn = *dynamics_;
  const int joints = nv_ - 6;
  for (int g = 0; g < TaskSlack::kGroups; ++g) {
    const Eigen::Vector4d y_g = y.segment<4>(4 * g);
    out.ddq += slack.ddq[g].lazyProduct(y_g);
    out.tau += slack.w[g].bottomRows(joints).lazyProduct(y_g);
  }
  for (const Side side : kSides) {
    if (!stance_.standing[side]) continue;
    const Vec6 f = slack.f_c.middleRows<6>(6 * side).lazyProduct(y);
    out.f_c.segment<6>(6 * side) += f;
    out.tau += dyn.sole[side].J.rightCols(joints).transpose().lazyProduct(f);
  }
}

}  // namespace zmpwalk
