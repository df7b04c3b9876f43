#include "zmpwalk/control/task_solver.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace zmpwalk {
namespace {

constexpr int kMostSweeps = 30;        // bound on the sweeps of rotations; a handful is enough
constexpr double kOrthogonal = 1e-30;  // squared cosine of two rows that count as orthogonal

/// Turns the rows of M (m, n) until they are orthogonal, and the right sides e (m, 3) with them: M y = e keeps its solutions.
template <class M, class E>
void orthogonalise_rows(M&& rows, E&& e) {
  const auto m = rows.rows();
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    bool turned = false;
    for (Eigen::Index i = 0; i + 1 < m; ++i)
      for (Eigen::Index j = i + 1; j < m; ++j) {
        const double a = rows.row(i).squaredNorm(), b = rows.row(j).squaredNorm(), c = rows.row(i).dot(rows.row(j));
        if (c * c <= kOrthogonal * a * b) continue;
        turned = true;
        // One-sided Jacobi: two angles make the two rows orthogonal; this is the smaller one.
        const double zeta = (b - a) / (2.0 * c);
        const double tangent = std::copysign(1.0, zeta) / (std::abs(zeta) + std::sqrt(1.0 + zeta * zeta));
        const double cosine = 1.0 / std::sqrt(1.0 + tangent * tangent), sine = cosine * tangent;
        const auto turn = [&](auto&& x) {
          for (Eigen::Index k = 0; k < x.cols(); ++k) {
            const double x_i = x(i, k), x_j = x(j, k);
            x(i, k) = cosine * x_i - sine * x_j;
            x(j, k) = sine * x_i + cosine * x_j;
          }
        };
        turn(rows);
        turn(e);
      }
    if (!turned) return;
  }
}

}  // namespace

TaskSolver::TaskSolver(const std::array<int, kUnknowns>& unknown, const std::vector<int>& posture)
    : unknown_(unknown), posture_(posture) {
  const auto n = static_cast<Eigen::Index>(posture.size());
  C_ = RowMatX::Zero(kUnknowns, n);
  N_ = RowMatX::Zero(n, n);
  step_ = VecX::Zero(n);
  da_ = sum_ = Matrix3::Zero(n, 3);
}

void TaskSolver::reserve(const TaskStack& stack) {
  const auto n = static_cast<Eigen::Index>(posture_.size());
  reduced_.clear();
  for (const TaskStack::Entry& entry : stack.entries())
    reduced_.push_back({RowMatX::Zero(entry.rows.rows(), n), Matrix3::Zero(entry.rows.rows(), 3), 0.0});
  M_ = RowMatX::Zero(stack.most_rows(), n);
  error_ = Matrix3::Zero(stack.most_rows(), 3);
}

void TaskSolver::prepare(const Dynamics& dyn, const Rows& K, double damping) {
  using Column = Eigen::Matrix<double, kUnknowns, 1>;
  const auto solve_all = [&](const auto& solve) {
    for (std::size_t j = 0; j < posture_.size(); ++j) {
      const int dof = 6 + posture_[j];
      Column k;
      k << dyn.sole[kLeft].J.col(dof), dyn.sole[kRight].J.col(dof), dyn.J_com.col(dof);
      C_.col(static_cast<Eigen::Index>(j)) = -solve(k);
    }
  };
  if (damping > 0.0) {
    Rows gram = K * K.transpose();
    gram.diagonal().array() += damping * damping;
    const Eigen::LLT<Rows> llt(gram);
    solve_all([&](const Column& k) { return Column(K.transpose() * llt.solve(k)); });
  } else {
    const Eigen::PartialPivLU<Rows> lu(K);
    solve_all([&](const Column& k) { return Column(lu.solve(k)); });
  }
}

bool TaskSolver::fits(const TaskStack& stack) const {
  if (reduced_.size() != stack.entries().size()) return false;
  for (std::size_t k = 0; k < reduced_.size(); ++k)
    if (reduced_[k].G.rows() != stack.entries()[k].rows.rows()) return false;
  return true;
}

void TaskSolver::correct(const TaskStack& stack, double singular, Affine& ddq) {
  const auto n = static_cast<Eigen::Index>(posture_.size());
  for (std::size_t k = 0; k < stack.entries().size(); ++k) {
    const TaskStack::Entry& entry = stack.entries()[k];
    if (!(entry.activation > 0.0)) continue;
    auto& [G, e, size] = reduced_[k];
    const RowMatX& J = entry.rows.J;
    for (Eigen::Index j = 0; j < n; ++j) G.col(j) = J.col(6 + posture_[static_cast<std::size_t>(j)]);
    for (int i = 0; i < kUnknowns; ++i) G.noalias() += J.col(unknown_[i]).lazyProduct(C_.row(i));
    size = G.norm();
    e = -J.lazyProduct(ddq.leftCols<3>());
    e.col(0) += entry.rows.f_star - entry.rows.drift;
  }

  // The activations, in rising order, cut 0..1 into pieces. On each piece the tasks with a larger activation are a stack of their own.
  sum_.setZero();
  for (double below = 0.0;;) {
    double next = std::numeric_limits<double>::infinity();
    for (const TaskStack::Entry& entry : stack.entries())
      if (entry.activation > below) next = std::min(next, entry.activation);
    if (!std::isfinite(next)) break;
    descend(stack, below, next - below, singular);
    below = next;
  }

  for (Eigen::Index j = 0; j < n; ++j) ddq.row(6 + posture_[static_cast<std::size_t>(j)]).head<3>() += sum_.row(j);
  for (int i = 0; i < kUnknowns; ++i) ddq.row(unknown_[i]).head<3>() += C_.row(i).lazyProduct(sum_);
}

void TaskSolver::descend(const TaskStack& stack, double above, double share, double singular) {
  N_.setIdentity();
  da_.setZero();
  for (std::size_t k = 0; k < stack.entries().size(); ++k) {
    if (!(stack.entries()[k].activation > above)) continue;
    const auto& [G, e, size] = reduced_[k];
    auto M = M_.topRows(G.rows());
    auto error = error_.topRows(G.rows());
    M = G.lazyProduct(N_);
    error = e - G.lazyProduct(da_);
    orthogonalise_rows(M, error);
    const double least = singular * size;
    for (Eigen::Index i = 0; i < G.rows(); ++i) {
      const double square = M.row(i).squaredNorm();
      const double damped = square + 0.25 * std::max(least * least - square, 0.0);
      if (!(damped > 0.0)) continue;  // no joint outside the legs moves the task
      step_ = N_.lazyProduct(M.row(i).transpose());
      step_ /= damped;
      da_ += step_.lazyProduct(error.row(i));
      N_ -= step_.lazyProduct(M.row(i));
    }
  }
  sum_ += share * da_;
}

}  // namespace zmpwalk
