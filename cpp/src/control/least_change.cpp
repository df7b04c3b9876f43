#include "zmpwalk/control/least_change.hpp"

#include "zmpwalk/math/error.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#include <eiquadprog/eiquadprog-rt.hpp>
#pragma GCC diagnostic pop

namespace zmpwalk {

struct LeastChange::Method {
  Method() {
    solver.setMaxIter(kPasses);
    solver.is_inverse_provided_ = true;
  }
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW

  eiquadprog::solvers::RtEiquadprog<kUnknowns, 0, kRows> solver;
  Eigen::Matrix<double, kUnknowns, kUnknowns> I = Eigen::Matrix<double, kUnknowns, kUnknowns>::Identity();
  Y zero = Y::Zero(), y = Y::Zero();
  Eigen::Matrix<double, 0, kUnknowns> no_rows;
  Eigen::Matrix<double, 0, 1> nothing;
  Eigen::Matrix<double, kRows, kUnknowns> C;
  Eigen::Matrix<double, kRows, 1> c;
};

LeastChange::LeastChange() : method_(std::make_unique<Method>()) { begin(); }

LeastChange::~LeastChange() = default;

void LeastChange::begin() {
  rows_ = 0;
  method_->C.setZero();  // a row that is not there asks for nothing
  method_->c.setOnes();
}

int LeastChange::add(double c, const Row& C) {
  if (rows_ == kRows)
    throw InputError("LeastChange has " + std::to_string(kRows) + " rows already, and room for no more");
  method_->c[rows_] = c;
  method_->C.row(rows_) = C;
  return rows_++;
}

const LeastChange::Y& LeastChange::y() const { return method_->y; }

int LeastChange::passes() const { return method_->solver.getIteratios(); }

bool LeastChange::solve() {
  Method& m = *method_;
  m.solver.m_J.setIdentity();  // the square is y' y: there is nothing to factorise
  const auto status = m.solver.solve_quadprog(m.I, m.zero, m.no_rows, m.nothing, m.C, m.c, m.y);
  active_.fill(false);
  if (status != eiquadprog::solvers::RT_EIQUADPROG_OPTIMAL || !m.y.allFinite()) return false;
  for (int k = 0; k < m.solver.getActiveSetSize(); ++k) {
    const int row = m.solver.getActiveSet()[k];
    active_[static_cast<std::size_t>(row)] = true;
  }
  return true;
}

}  // namespace zmpwalk
