#pragma once

// Includes nothing: see src/control/kernel/loops.hpp.

namespace zmpwalk {

/// The cycle's inner loops on plain arrays, built once for each vector unit of the processor.
///
/// One row of four numbers, written [4], holds what is affine in the horizontal COM acceleration (f*_x, f*_y): the value at
/// f* = 0, the two slopes, and a zero that fills the register. The builds agree to rounding (fused multiply and add).
struct Kernel {
  const char* name;  ///< "x86-64", "x86-64-v3" (AVX2, FMA), "x86-64-v4" (AVX-512); elsewhere "generic"

  /// out -= J v: J (6, n) column after column, v (n,), out (6,).
  void (*subtract_product)(int n, const double* J, const double* v, double* out);

  /// Solves M Y = R by elimination with row pivots, for M (6, 6) and R (6,)[4]: the six rows of `system` hold six numbers of M,
  /// two unused ones that are finite, and four of R, which become Y.
  /// @returns the smallest pivot's size; 0, or less than what it is compared with, means that Y is not to be used
  double (*solve_leg)(double* system);

  /// Y = A X: A (n, n) symmetric, row after row; X, Y (n,)[4]. Entries of A outside `spans` (`Sparsity::spans`) are taken as zero.
  void (*multiply)(int n, const double* A, const int* spans, const double* X, double* Y);

  /// tau_i = w_i . at + J_left_i . f_left + J_right_i . f_right: w (n,)[4], at [4], J (6, n) column after column, f (6,).
  void (*joint_torque)(int n, const double* w, const double* at, const double* J_left, const double* f_left,
                       const double* J_right, const double* f_right, double* tau);
};

}  // namespace zmpwalk
