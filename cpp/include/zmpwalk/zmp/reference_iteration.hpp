#pragma once

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// What III-B ends with.
struct ReferenceResult {
  Vec2 zmp_ref = Vec2::Zero();  ///< reference of the pendulum (16)
  Vec2 zmp_est = Vec2::Zero();  ///< estimate it leads to
  int passes = 0;               ///< estimates computed
  bool converged = false;       ///< |zmp_des - zmp_est| < threshold on every axis asked for
};

/// The loop of III-B: r_ref <- r_ref + r_des - r_est(r_ref) until they agree (Fig. 2).
///
/// @param estimate  callable Vec2 r_ref -> Vec2 r_est [m]: (16), (7), (9), (14), (15)
/// @param zmp_des   desired ZMP [m]
/// @param r_ref     where to start on the axes that are not asked for; the others start at zmp_des
/// @param axes      1 where an axis is asked for, else 0
/// @param threshold [m]; the paper's is 0.001
/// @param max_passes bound of the loop
template <class Estimate>
ReferenceResult iterate_reference(Estimate&& estimate, const Vec2& zmp_des, const Vec2& r_ref, const Vec2& axes,
                                  double threshold, int max_passes) {
  ReferenceResult out;
  out.zmp_ref = axes.cwiseProduct(zmp_des) + (Vec2::Ones() - axes).cwiseProduct(r_ref);
  while (out.passes < max_passes) {
    out.zmp_est = estimate(out.zmp_ref);
    ++out.passes;
    const Vec2 error = axes.cwiseProduct(zmp_des - out.zmp_est);
    out.converged = error.cwiseAbs().maxCoeff() < threshold;
    if (out.converged) break;
    out.zmp_ref += error;
  }
  return out;
}

/// The fixed point of that loop in closed form, for an estimate that is affine in the reference.
///
/// r_ref = r_des + slope^-1 (r_des - r_est(r_des)) on the axes asked for. Two estimates; the second confirms.
/// @param slope d r_est / d r_ref (2, 2)
template <class Estimate>
ReferenceResult solve_reference(Estimate&& estimate, const Vec2& zmp_des, const Vec2& r_ref, const Vec2& axes,
                                const Mat2& slope, double threshold) {
  ReferenceResult out;
  out.zmp_ref = axes.cwiseProduct(zmp_des) + (Vec2::Ones() - axes).cwiseProduct(r_ref);
  const Vec2 error = axes.cwiseProduct(zmp_des - estimate(out.zmp_ref));
  Mat2 S = axes.asDiagonal() * slope * axes.asDiagonal();
  S.diagonal() += Vec2::Ones() - axes;
  const double det = S(0, 0) * S(1, 1) - S(0, 1) * S(1, 0);
  out.zmp_ref += Vec2(S(1, 1) * error.x() - S(0, 1) * error.y(), S(0, 0) * error.y() - S(1, 0) * error.x()) / det;
  out.zmp_est = estimate(out.zmp_ref);
  out.passes = 2;
  out.converged = axes.cwiseProduct(zmp_des - out.zmp_est).cwiseAbs().maxCoeff() < threshold;
  return out;
}

}  // namespace zmpwalk
