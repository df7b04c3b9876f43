#include "zmpwalk/math/inverse.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

SymmetricFactors factor_symmetric(const ConstMatRef& W, int rank) {
  const int n = static_cast<int>(W.rows());
  require_shape("W", W.rows(), W.cols(), n, n);
  if (rank < 0 || rank > n)
    throw DimensionError("rank = " + std::to_string(rank) + "; it must be in 0.." + std::to_string(n));
  const Eigen::SelfAdjointEigenSolver<MatX> eigen(0.5 * (W + W.transpose()));  // ascending eigenvalues
  const MatX& V = eigen.eigenvectors();
  const auto range = V.rightCols(rank);
  return {range * eigen.eigenvalues().tail(rank).cwiseInverse().asDiagonal() * range.transpose(), V.leftCols(n - rank)};
}

RowMatX inverse_spd(const ConstMatRef& M) {
  require_shape("M", M.rows(), M.cols(), M.rows(), M.rows());
  const Eigen::LLT<MatX> llt(M);
  if (llt.info() != Eigen::Success) throw InputError("the matrix is not symmetric positive definite");
  const MatX inverse = llt.solve(MatX::Identity(M.rows(), M.cols()));
  return 0.5 * (inverse + inverse.transpose());
}

}  // namespace zmpwalk
