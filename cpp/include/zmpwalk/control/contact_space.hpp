#pragma once

#include <Eigen/Cholesky>

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// How joint torques act on the ground through the standing feet: the contact space, equations 2 and 9-13.
///
/// f_c, mu_c and p_c follow A ddq + b + g + J_c' f_c = S' tau: f_c is the wrench of the robot **on** the ground, six entries
/// (force, moment) per foot at its sole centre, world axes.
class ContactSpace {
 public:
  /// @param nv    velocity coordinates
  /// @param rows  contact rows: 6 per standing foot
  ContactSpace(int nv, int rows);

  /// @param A (nv, nv) inertia   @param b, g (nv,) velocity and gravity terms
  /// @param J_c (rows, nv)       @param drift_c (rows,) = Jdot_c dq
  /// @throws DimensionError. Allocates nothing.
  void compute(const ConstMatRef& A, const ConstVecRef& b, const ConstVecRef& g, const ConstMatRef& J_c,
               const ConstVecRef& drift_c);

  /// Eq. 9: wrench of the robot on the ground that joint torque `tau` (joints,) [N m] produces, into `f_c` (rows,). Allocates nothing.
  void wrench(const ConstVecRef& tau, Eigen::Ref<VecX> f_c) const;

  const RowMatX& Lambda_c() const { return Lambda_c_; }  ///< contact inertia (rows, rows)
  /// Transpose of the dynamically consistent inverse of J_c (rows, nv).
  const RowMatX& JbarT_c() const { return JbarT_c_; }
  const VecX& mu_c() const { return mu_c_; }        ///< velocity forces in contact space (rows,)
  const VecX& p_c() const { return p_c_; }          ///< gravity in contact space (rows,)
  const RowMatX& J_c() const { return J_c_; }       ///< contact Jacobian (rows, nv)
  const VecX& drift_c() const { return drift_c_; }  ///< Jdot_c dq (rows,)
  RowMatX N_c() const;                              ///< contact null space, eq. 2 (nv, nv); allocates
  RowMatX A_inv() const;                            ///< inverse of the inertia (nv, nv); allocates

 private:
  Eigen::LLT<MatX> A_llt_;
  RowMatX J_c_, Lambda_c_, JbarT_c_;
  MatX AinvJT_, gram_;
  Eigen::LLT<MatX> gram_llt_;
  VecX drift_c_, mu_c_, p_c_;
};

}  // namespace zmpwalk
