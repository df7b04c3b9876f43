#pragma once

#include "zmpwalk/control/contact_space.hpp"
#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// Eq. 8: commanded acceleration of a proportional-derivative task, f* = k_p (x_d - x) + k_d (v_d - v).
///
/// @param kp [1/s^2]  @param kd [1/s]  @param position_error x_d - x  @param velocity_error v_d - v
template <class P, class V>
auto pd_acceleration(double kp, double kd, const P& position_error, const V& velocity_error) {
  return kp * position_error + kd * velocity_error;  // Eq. (8)
}

/// Equations 1 and 3-7 as they are printed, (7) corrected. This is their definition, with which tests compare every faster form.
///
/// It forms dense inverses and allocates. A walk takes the direct path of `WholeBodyController`, which gives the same numbers.
struct TaskSpace {
  /// @param contact  contact space of the same instant, already computed
  /// @param b, g     (nv,)   @param J (m, nv) stacked task Jacobian   @param drift (m,) = Jdot dq
  /// @throws DimensionError; InputError where the tasks are in conflict (Lambda does not exist)
  TaskSpace(const ContactSpace& contact, const ConstVecRef& b, const ConstVecRef& g, const ConstMatRef& J,
            const ConstVecRef& drift);

  RowMatX Lambda;  ///< task inertia under contact (m, m)
  RowMatX JbarT;   ///< transpose of the dynamically consistent inverse of J (m, nv)
  VecX mu;         ///< velocity forces in task space (m,)
  VecX p;          ///< gravity in task space (m,)
  RowMatX J_k;     ///< modified task Jacobian (m, joints), which turns a task force into joint torques
  RowMatX N_k;     ///< a joint torque that is multiplied by it leaves the tasks alone (joints, joints)
  RowMatX V_n;     ///< torques that change nothing but the contact wrenches: internal forces (joints, rows - 6)

  /// Eq. 1: task force F (m,) for commanded acceleration f* (m,).
  VecX force(const ConstVecRef& f_star) const;
  /// Eq. 7: joint torque (joints,) for task force F (m,).
  VecX torque(const ConstVecRef& F) const;
};

}  // namespace zmpwalk
