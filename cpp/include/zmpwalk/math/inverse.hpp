#pragma once

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// Eigen-decomposition of a symmetric positive semi-definite matrix of known rank.
struct SymmetricFactors {
  RowMatX pinv;        ///< Moore-Penrose inverse (n, n)
  RowMatX null_space;  ///< orthonormal basis of the null space (n, n - rank)
};

/// Pseudo-inverse and null space of symmetric `W` (n, n), whose `rank` is known by counting.
///
/// The n - rank smallest eigenvalues count as zero, whatever their size: no threshold tells a small one that counts from rounding.
/// @throws DimensionError  W not square, or rank not in 0..n
SymmetricFactors factor_symmetric(const ConstMatRef& W, int rank);

/// Inverse of a symmetric positive definite matrix (n, n), symmetrised. @throws DimensionError, InputError if indefinite
RowMatX inverse_spd(const ConstMatRef& M);

}  // namespace zmpwalk
