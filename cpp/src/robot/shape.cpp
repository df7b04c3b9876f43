#include "zmpwalk/robot/shape.hpp"

#include <algorithm>
#include <cmath>

namespace zmpwalk {

double Shape::extent(const Vec3& towards) const {
  const Eigen::Map<const Vec3> size(m.geom_size + 3 * geom);
  switch (m.geom_type[geom]) {
    case mj::kSphere:
      return size[0];
    case mj::kCapsule:
      return size[0] + size[1] * std::abs(towards.z());
    case mj::kCylinder:
      return size[0] * towards.head<2>().norm() + size[1] * std::abs(towards.z());
    case mj::kEllipsoid:
      return size.cwiseProduct(towards).norm();
    case mj::kBox:
      return size.dot(towards.cwiseAbs());
    case mj::kMesh: {
      const int mesh = m.geom_dataid[geom];
      const float* vertex = m.mesh_vert + 3 * m.mesh_vertadr[mesh];
      double farthest = 0.0;
      for (int i = 0; i < m.mesh_vertnum[mesh]; ++i, vertex += 3)
        farthest = std::max(farthest, towards.dot(Vec3(vertex[0], vertex[1], vertex[2])));
      return farthest;
    }
    default:
      return 0.0;
  }
}

}  // namespace zmpwalk
