#pragma once

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// A plane in W: the points p with normal . p = offset. The default is the level ground at z = 0.
struct Plane {
  Vec3 normal = Vec3::UnitZ();  ///< of length 1, pointing out of the ground: normal.z() > 0
  double offset = 0.0;          ///< distance of the plane from the world's origin along the normal [m]

  /// The plane through `p` with this normal; without a normal, the level plane.
  static Plane through(const Vec3& p, const Vec3& normal = Vec3::UnitZ()) { return {normal, normal.dot(p)}; }

  /// Distance of `p` from the plane, positive above it [m].
  double distance(const Vec3& p) const { return normal.dot(p) - offset; }
  /// The point of the plane that is nearest to `p`.
  Vec3 project(const Vec3& p) const { return p - distance(p) * normal; }
  /// Height in W of the plane's point whose world x and y are `xy` [m].
  double height(const Vec2& xy) const { return (offset - normal.head<2>().dot(xy)) / normal.z(); }
  bool operator==(const Plane& other) const { return normal == other.normal && offset == other.offset; }
};

/// Eq. 14, 15 on any plane: the ZMP, the point P of `plane` about which the wrench has a moment along the normal only (3,) [m].
///
/// n x M_P = 0 with M_P = M - (P - s) x F gives P = s + (n x M + h F) / (n . F), where h is how far the plane is above s along n.
/// On a level plane through s that is x = -M_y / F_z and y = M_x / F_z from s, as printed. The point depends neither on the
/// choice of s nor on whether the wrench is the robot's on the ground or the ground's on the robot.
///
/// @param F  force [N]   @param M  moment about `s` [N m], world axes   @param s  any point in W [m]
Vec3 zmp_on_plane(const Vec3& F, const Vec3& M, const Vec3& s, const Plane& plane);

/// Eq. 14, 15 as printed: ZMP on the level plane through the point about which M is taken, from that point (2,) [m].
inline Vec2 zmp_of_wrench(const Vec3& F, const Vec3& M) { return zmp_on_plane(F, M, Vec3::Zero(), Plane{}).head<2>(); }

}  // namespace zmpwalk
