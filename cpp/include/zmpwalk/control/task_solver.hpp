#pragma once

#include <vector>

#include "zmpwalk/control/dynamics.hpp"
#include "zmpwalk/control/task_stack.hpp"

namespace zmpwalk {

/// Solves the user's tasks with what the walk leaves free: the accelerations a of the joints outside the legs.
///
/// The walk's own tasks are contacts, swing foot, COM and trunk. They have 18 rows, as many as base and legs have coordinates. So base and
/// legs can answer whatever the other joints do: a change da of a changes ddq by C da and leaves these 18 rows as they are. Task k
/// thus reads G_k da = e_k with G_k = J_k C and e_k = f*_k - drift_k - J_k ddq, where ddq is the motion without the user's tasks but with
/// the posture. Each task uses only what the tasks before it leave free:
///
///   da_k = da_k-1 + N_k-1 (G_k N_k-1)^+ (e_k - G_k da_k-1),   N_k = N_k-1 (I - (G_k N_k-1)^+ G_k N_k-1),   da_0 = 0, N_0 = I.
///
/// The posture comes last, because da is counted from it. Everything is affine in f_xy, as the motion is, and has three columns.
///
/// The pseudo-inverse is taken of rows that are made orthogonal (one-sided Jacobi rotations). A singular value s below a least one, s_0, is damped:
/// 1/s becomes s / (s^2 + (s_0^2 - s^2) / 4), which is exact from s_0 on, continuous there, and zero where s is zero. s_0 is a share of the size
/// of G_k, so that it does not depend on the units of the rows.
///
/// Activations s_k between 0 and 1 mix whole stacks: da = integral over u from 0 to 1 of the da of the tasks with s_k > u. This is
/// continuous in every s_k, it is the stack itself where all s_k are 1, and a task of activation 0 takes nothing from another.
class TaskSolver {
 public:
  static constexpr int kUnknowns = 15;  ///< base translation and two legs
  using Affine = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;
  using Rows = Eigen::Matrix<double, kUnknowns, kUnknowns>;

  /// @param unknown  velocity coordinates of the base's translation and of the legs
  /// @param posture  joints outside the legs (indices without the base)
  TaskSolver(const std::array<int, kUnknowns>& unknown, const std::vector<int>& posture);

  /// Sets memory aside for these tasks. Call it outside the cycle, after each change of the stack.
  void reserve(const TaskStack& stack);
  /// True where `reserve` has seen these tasks.
  bool fits(const TaskStack& stack) const;

  /// Computes C, how base and legs answer the joints outside the legs: K C = -K_posture, where K are the rows of both soles and of the COM.
  ///
  /// @param damping  of the least-squares answer, 0 for the exact one [1 in rows of K]
  void prepare(const Dynamics& dynamics, const Rows& K, double damping);

  /// Adds what the tasks change to `ddq` (nv)[4], the motion without them. Allocates nothing.
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
