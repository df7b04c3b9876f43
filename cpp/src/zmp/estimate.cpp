#include "zmpwalk/zmp/estimate.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

Vec2 zmp_of_wrench(const Vec3& F, const Vec3& M) {
  const double x = -M.y() / F.z();  // Eq. (14)
  const double y = M.x() / F.z();   // Eq. (15)
  return {x, y};
}

Wrench total_wrench(const Vec12& f_c, const std::array<Vec3, 2>& c, const Vec3& s) {
  Wrench total;
  for (const Side side : kSides) {
    const Vec3 F = f_c.segment<3>(6 * side);
    if (std::isnan(F.z())) continue;
    total.F += F;
    total.M += f_c.segment<3>(6 * side + 3) + (c[side] - s).cross(F);
  }
  return total;
}

ZmpEstimator::ZmpEstimator(int nv) : single_(nv, 6), double_(nv, 12) { c_.fill(Vec3::Zero()); }

void ZmpEstimator::update(const ConstMatRef& A, const ConstVecRef& b, const ConstVecRef& g, const ConstMatRef& J_c,
                          const ConstVecRef& drift_c, const std::array<bool, 2>& standing, const std::array<Vec3, 2>& c,
                          Side support) {
  if (!standing[kLeft] && !standing[kRight]) throw InputError("no foot stands; a ZMP needs at least one");
  both_ = standing[kLeft] && standing[kRight];
  (both_ ? double_ : single_).compute(A, b, g, J_c, drift_c);
  standing_ = standing;
  c_ = c;
  support_ = support;
}

ZmpEstimate ZmpEstimator::estimate(const ConstVecRef& tau) const {
  require_size("tau", tau.size(), contact_space().J_c().cols() - 6);
  ZmpEstimate out;
  if (both_)
    double_.wrench(tau, out.f_c);
  else
    single_.wrench(tau, out.f_c.segment<6>(standing_[kLeft] ? 0 : 6));
  const Vec3& s = c_[support_];
  const Wrench total = total_wrench(out.f_c, c_, s);
  out.in_contact = std::abs(total.F.z()) >= kMinNormalForce;
  if (out.in_contact) out.zmp = s.head<2>() + zmp_of_wrench(total.F, total.M);
  return out;
}

}  // namespace zmpwalk
