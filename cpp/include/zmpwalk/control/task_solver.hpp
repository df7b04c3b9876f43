#pragma once

#include <vector>

#include "zmpwalk/control/dynamics.hpp"
#include "zmpwalk/control/task_stack.hpp"

namespace zmpwalk {

/// The user's tasks, solved in the space that the walk leaves free: the accelerations a of the joints outside the legs.
///
/// Contacts, swing foot, COM and trunk (the walk's own tasks, 18 rows) are square with the base and the legs (18 coordinates), so that
/// whatever those joints do, base and legs answer it: a change da of a changes ddq by C da, and leaves these 18 rows as they are. Task k
/// thus reads G_k da = e_k with G_k = J_k C and e_k = f*_k - drift_k - J_k ddq, where ddq is the motion without the user's tasks, its
/// posture included. Each task acts in what those before it leave free,
///
///   da_k = da_k-1 + N_k-1 (G_k N_k-1)^+ (e_k - G_k da_k-1),   N_k = N_k-1 (I - (G_k N_k-1)^+ G_k N_k-1),   da_0 = 0, N_0 = I,
///
/// so that the posture, from which da is counted, is the lowest level. Everything is affine in f_xy, as the motion is: three columns.
///
/// The pseudo-inverse comes from orthogonal rows (one-sided Jacobi rotations). A singular value s below a least one, s_0, is damped,
/// 1/s becoming s / (s^2 + (s_0^2 - s^2) / 4): exact above, continuous there, zero where s is zero. s_0 is a share of the size of G_k,
/// so that it does not depend on the units of the rows.
///
/// Activations s_k between 0 and 1 mix whole stacks: da = integral over u from 0 to 1 of the da of the tasks with s_k > u. That is
/// continuous in every s_k, is the stack itself where all are 1, and lets no task of activation 0 take anything from another.
class TaskSolver {
 public:
  static constexpr int kUnknowns = 15;  ///< base translation and two legs
  using Affine = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;
  using Rows = Eigen::Matrix<double, kUnknowns, kUnknowns>;

  /// @param unknown  velocity coordinates of the base's translation and of the legs
  /// @param posture  joints outside the legs (indices without the base)
  TaskSolver(const std::array<int, kUnknowns>& unknown, const std::vector<int>& posture);

  /// Sets memory aside for these tasks; outside the cycle, after each change of the stack.
  void reserve(const TaskStack& stack);
  /// True where `reserve` has seen these tasks.
  bool fits(const TaskStack& stack) const;

  /// How base and legs answer the joints outside the legs, K C = -K_posture: K are the rows of both soles and the COM.
  ///
  /// @param damping  of the least-squares answer, 0 for the exact one [1 in rows of K]
  void prepare(const Dynamics& dynamics, const Rows& K, double damping);

  /// Adds to `ddq` (nv)[4], the motion without the tasks, what the tasks change. Allocates nothing.
  ///
  /// @param singular  s_0 over the Frobenius norm of G_k
  void correct(const TaskStack& stack, double singular, Affine& ddq);

 private:
  using Matrix3 = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
  struct Reduced {  // one task in the space of a
    RowMatX G;      // (m, joints outside the legs)
    Matrix3 e;      // (m, 3)
    double size;    // of G
  };

  void descend(const TaskStack& stack, double above, double share, double singular);

  std::array<int, kUnknowns> unknown_;
  std::vector<int> posture_;
  RowMatX C_;  // (unknowns, posture)
  std::vector<Reduced> reduced_;
  RowMatX M_, N_;
  VecX step_;  // N M_i'
  Matrix3 error_, da_, sum_;
};

}  // namespace zmpwalk
