#include "zmpwalk/zmp/contact.hpp"

#include <Eigen/LU>
#include <cmath>

namespace zmpwalk {
namespace {

constexpr double kLeastLean =
    1e-6;  // feet one above the other define no common plane; then the mean of their normals is taken

}  // namespace

Vec2 Contact::to_world(const Vec2& p_F) const { return p_WF.head<2>() + R_WF.topLeftCorner<2, 2>() * p_F; }

Vec2 Contact::to_sole(const Vec2& p) const { return R_WF.topLeftCorner<2, 2>().inverse() * (p - p_WF.head<2>()); }

Vec2 Contact::cop(const Vec6& f) const {
  const Vec3 P = zmp_on_plane(f.head<3>(), f.tail<3>(), p_WF, Plane::through(p_WF, R_WF.col(2)));
  return (R_WF.transpose() * (P - p_WF)).head<2>();
}

bool Contact::can_carry(const Vec6& f) const {
  const Vec3 F = R_WF.transpose() * f.head<3>();
  const Vec2 p = cop(f);
  return F.z() < 0.0 && std::abs(p.x()) <= 0.5 * length && std::abs(p.y()) <= 0.5 * width &&
         F.head<2>().norm() <= -friction * F.z();
}

Plane common_plane(const std::array<Contact, 2>& feet, Side support) {
  const auto& [left, right] = feet;
  const Vec3& s = feet[support].p_WF;
  if (!left.standing || !right.standing || left.ground == right.ground)
    return Plane::through(s, feet[support].ground.normal);
  const Vec3 u = left.ground.project(left.p_WF) - right.ground.project(right.p_WF);
  const Vec3 mean = 0.5 * (left.ground.normal + right.ground.normal);
  const Vec3 n = mean - u * (u.dot(mean) / u.squaredNorm());
  return Plane::through(s, n.norm() > kLeastLean ? n.normalized() : mean.normalized());
}

}  // namespace zmpwalk
