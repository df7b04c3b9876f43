#include "zmpwalk/zmp/plane.hpp"

namespace zmpwalk {

Vec3 zmp_on_plane(const Vec3& F, const Vec3& M, const Vec3& s, const Plane& plane) {
  const Vec3& n = plane.normal;
  const double load = n.dot(F), h = -plane.distance(s);
  Vec3 P;
  P.x() = s.x() + (n.y() * M.z() - n.z() * M.y() + h * F.x()) / load;  // Eq. (14)
  P.y() = s.y() + (n.z() * M.x() - n.x() * M.z() + h * F.y()) / load;  // Eq. (15)
  P.z() = s.z() + (n.x() * M.y() - n.y() * M.x() + h * F.z()) / load;
  return P;
}

}  // namespace zmpwalk
