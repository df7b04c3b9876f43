#include "zmpwalk/control/least_change.hpp"

#include <algorithm>
#include <numeric>

#include "zmpwalk/math/error.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#include <eiquadprog/eiquadprog-rt.hpp>
#pragma GCC diagnostic pop

namespace zmpwalk {
namespace {

constexpr double kTolerance = 1e-7;  // of a row that the method did not get

}  // namespace

template <int N, int M>
struct LeastChange::Method {
  using Solver = eiquadprog::solvers::RtEiquadprog<N, 0, M>;

  Method() {
    solver.setMaxIter(kPasses);
    solver.is_inverse_provided_ = true;
  }
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW

  Solver solver;
  Eigen::Matrix<double, N, N> I = Eigen::Matrix<double, N, N>::Identity();
  Eigen::Matrix<double, N, 1> zero = Eigen::Matrix<double, N, 1>::Zero(), y;
  Eigen::Matrix<double, 0, N> no_rows;
  Eigen::Matrix<double, 0, 1> nothing;
  Eigen::Matrix<double, M, N> C;
  Eigen::Matrix<double, M, 1> c;
};

LeastChange::LeastChange(int rows)
    : capacity_(rows),
      C_(RowMatX::Zero(rows, kMost)),
      c_(VecX::Zero(rows)),
      y_(VecX::Zero(kMost)),
      order_(static_cast<std::size_t>(rows)),
      active_(static_cast<std::size_t>(rows), false),
      few_(std::make_unique<Few>()),
      many_(std::make_unique<Many>()) {}

LeastChange::~LeastChange() = default;

void LeastChange::begin(int unknowns) {
  if (unknowns < 1 || unknowns > kMost)
    throw InputError("LeastChange has " + std::to_string(unknowns) + " unknowns; it may have 1 to " +
                     std::to_string(kMost));
  unknowns_ = unknowns;
  rows_ = 0;
}

int LeastChange::add(double c) {
  if (rows_ == capacity_)
    throw InputError("LeastChange has " + std::to_string(capacity_) + " rows already, and room for no more");
  c_[rows_] = c;
  return rows_++;
}

Eigen::Ref<Eigen::RowVectorXd> LeastChange::row(int i) { return C_.row(i).head(unknowns_); }

Eigen::Ref<const VecX> LeastChange::y() const { return y_.head(unknowns_); }

template <int N, int M>
bool LeastChange::solve(Method<N, M>& method) {
  // The rows that are nearest to being broken; a row that is not there asks for nothing.
  const auto first = order_.begin(), last = first + rows_;
  std::iota(first, last, 0);
  const int taken = std::min(rows_, M);
  if (taken < rows_) std::nth_element(first, first + taken, last, [&](int i, int j) { return c_[i] < c_[j]; });
  method.C.setZero();
  method.c.setOnes();
  for (int k = 0; k < taken; ++k) {
    method.C.row(k).head(unknowns_) = C_.row(order_[k]).head(unknowns_);
    method.c[k] = c_[order_[k]];
  }
  method.solver.m_J.setIdentity();  // the square is y' y: there is nothing to factorise
  const auto status =
      method.solver.solve_quadprog(method.I, method.zero, method.no_rows, method.nothing, method.C, method.c, method.y);
  passes_ = method.solver.getIteratios();
  left_out_ = false;
  if (status != eiquadprog::solvers::RT_EIQUADPROG_OPTIMAL || !method.y.allFinite()) return false;

  y_.head(unknowns_) = method.y.head(unknowns_);
  std::fill_n(active_.begin(), rows_, false);
  for (int k = 0; k < method.solver.getActiveSetSize(); ++k) active_[order_[method.solver.getActiveSet()[k]]] = true;
  for (int k = 0; k < rows_; ++k)
    left_out_ |= !(c_[k] + C_.row(k).head(unknowns_).dot(y_.head(unknowns_)) >= -kTolerance);
  return !left_out_;
}

bool LeastChange::solve() {
  if (unknowns_ > kFew) return solve(*many_);
  return solve(*few_) || (left_out_ && solve(*many_));
}

}  // namespace zmpwalk
