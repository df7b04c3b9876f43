#include "zmpwalk/control/contact_space.hpp"

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

ContactSpace::ContactSpace(int nv, int rows)
    : A_llt_(nv),
      J_c_(RowMatX::Zero(rows, nv)),
      Lambda_c_(RowMatX::Zero(rows, rows)),
      JbarT_c_(RowMatX::Zero(rows, nv)),
      AinvJT_(MatX::Zero(nv, rows)),
      gram_(MatX::Zero(rows, rows)),
      gram_llt_(rows),
      drift_c_(VecX::Zero(rows)),
      mu_c_(VecX::Zero(rows)),
      p_c_(VecX::Zero(rows)) {}

void ContactSpace::compute(const ConstMatRef& A, const ConstVecRef& b, const ConstVecRef& g, const ConstMatRef& J_c,
                           const ConstVecRef& drift_c) {
  const long nv = J_c_.cols(), rows = J_c_.rows();
  require_shape("A", A.rows(), A.cols(), nv, nv);
  require_size("b", b.size(), nv);
  require_size("g", g.size(), nv);
  require_shape("J_c", J_c.rows(), J_c.cols(), rows, nv);
  require_size("drift_c", drift_c.size(), rows);
  J_c_ = J_c;
  drift_c_ = drift_c;
  A_llt_.compute(A);
  AinvJT_ = J_c_.transpose();
  A_llt_.solveInPlace(AinvJT_);
  gram_.noalias() = J_c_ * AinvJT_;
  gram_llt_.compute(gram_);
  Lambda_c_.setIdentity();
  gram_llt_.solveInPlace(Lambda_c_);                     // Eq. (10)
  JbarT_c_.noalias() = Lambda_c_ * AinvJT_.transpose();  // Eq. (13)
  mu_c_.noalias() = JbarT_c_ * b;
  mu_c_.noalias() -= Lambda_c_ * drift_c_;  // Eq. (11)
  p_c_.noalias() = JbarT_c_ * g;            // Eq. (12)
}

void ContactSpace::wrench(const ConstVecRef& tau, Eigen::Ref<VecX> f_c) const {
  f_c.noalias() = JbarT_c_.rightCols(tau.size()) * tau;  // Eq. (9)
  f_c -= mu_c_ + p_c_;
}

RowMatX ContactSpace::N_c() const {
  return RowMatX::Identity(J_c_.cols(), J_c_.cols()) - J_c_.transpose() * JbarT_c_;  // Eq. (2)
}

RowMatX ContactSpace::A_inv() const { return A_llt_.solve(MatX::Identity(J_c_.cols(), J_c_.cols())); }

}  // namespace zmpwalk
