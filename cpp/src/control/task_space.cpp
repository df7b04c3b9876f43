#include "zmpwalk/control/task_space.hpp"

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/math/inverse.hpp"

namespace zmpwalk {

TaskSpace::TaskSpace(const ContactSpace& contact, const ConstVecRef& b, const ConstVecRef& g, const ConstMatRef& J,
                     const ConstVecRef& drift) {
  const long nv = contact.J_c().cols(), m = J.rows(), joints = nv - 6;
  require_size("b", b.size(), nv);
  require_size("g", g.size(), nv);
  require_shape("J", J.rows(), J.cols(), m, nv);
  require_size("drift", drift.size(), m);
  const RowMatX A_inv = contact.A_inv();
  const RowMatX AinvNc = A_inv * contact.N_c();
  const RowMatX B = 0.5 * (AinvNc + AinvNc.transpose());  // symmetric by (2), (13)

  Lambda = inverse_spd(J * B * J.transpose());  // Eq. (3)
  JbarT = Lambda * J * B;                       // Eq. (4)
  mu = JbarT * b - Lambda * drift +
       Lambda * J * A_inv * contact.J_c().transpose() * contact.Lambda_c() * contact.drift_c();  // Eq. (5)
  p = JbarT * g;                                                                                 // Eq. (6)

  // (J^k)' = W^+ S B J' with W = S B S'; W loses exactly rows(J_c) - 6 ranks: those of the internal forces.
  const int internal = static_cast<int>(contact.J_c().rows()) - 6;
  const SymmetricFactors W = factor_symmetric(B.bottomRightCorner(joints, joints), static_cast<int>(joints) - internal);
  J_k = J * B.rightCols(joints) * W.pinv;
  V_n = W.null_space;
  N_k = RowMatX::Identity(joints, joints) - J_k.transpose() * JbarT.rightCols(joints);
}

VecX TaskSpace::force(const ConstVecRef& f_star) const {
  require_size("f_star", f_star.size(), Lambda.rows());
  return Lambda * f_star + mu + p;  // Eq. (1)
}

VecX TaskSpace::torque(const ConstVecRef& F) const {
  require_size("F", F.size(), Lambda.rows());
  return J_k.transpose() * F;  // Eq. (7), corrected: mu and p are forces already, so Lambda multiplies f* alone
}

}  // namespace zmpwalk
