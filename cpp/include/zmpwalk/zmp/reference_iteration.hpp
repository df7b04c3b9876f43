#pragma once

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// What III-B ends with: the reference ZMP for the pendulum, and how good it is.
struct ReferenceResult {
  Vec2 zmp_ref = Vec2::Zero();  ///< reference ZMP of the pendulum (16) [m]
  Vec2 zmp_est = Vec2::Zero();  ///< estimated ZMP that this reference leads to [m]
  int passes = 0;               ///< estimates computed
  bool converged = false;       ///< |zmp_des - zmp_est| < threshold on every axis asked for
};

/// The loop of III-B: it adds r_des - r_est(r_ref) to the reference r_ref, until the estimate r_est is the desired ZMP r_des (Fig. 2).
///
/// All ZMPs are in one frame, whichever the caller takes.
///
/// @param estimate  callable Vec2 r_ref -> Vec2 r_est [m]: (16), (7), (9), (14), (15)
/// @param zmp_des   desired ZMP [m]
/// @param r_ref     reference on the axes that are to stay as they are; the others start at zmp_des
/// @param axes      1 for an axis that is to be changed, else 0
/// @param threshold largest |r_des - r_est| that is good enough [m]; the paper's is 0.001
/// @param max_passes most passes of the loop
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

/// Where that loop ends, in closed form, for an estimate that is affine in the reference.
///
/// r_ref = r_des + slope^-1 (r_des - r_est(r_des)) on the axes that are to be changed. It takes two estimates; the second one confirms the result.
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
