#include "zmpwalk/zmp/estimate.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

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
                          const ConstVecRef& drift_c, const std::array<Contact, 2>& feet, Side support) {
  const auto& [left, right] = feet;
  if (!left.standing && !right.standing) throw InputError("no foot stands; a ZMP needs at least one");
  both_ = left.standing && right.standing;
  (both_ ? double_ : single_).compute(A, b, g, J_c, drift_c);
  left_ = left.standing;
  c_ = {left.p_WF, right.p_WF};
  support_ = support;
  plane_ = common_plane(feet, support);
}

ZmpEstimate ZmpEstimator::estimate(const ConstVecRef& tau) const {
  require_size("tau", tau.size(), contact_space().J_c().cols() - 6);
  ZmpEstimate out;
  if (both_)
    double_.wrench(tau, out.f_c);
  else
    single_.wrench(tau, out.f_c.segment<6>(left_ ? 0 : 6));
  const Vec3& s = c_[support_];
  const Wrench total = total_wrench(out.f_c, c_, s);
  out.in_contact = std::abs(plane_.normal.dot(total.F)) >= kMinNormalForce;
  if (out.in_contact) out.zmp = zmp_on_plane(total.F, total.M, s, plane_).head<2>();
  return out;
}

}  // namespace zmpwalk
