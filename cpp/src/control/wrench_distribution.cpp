#include "zmpwalk/control/wrench_distribution.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace zmpwalk {
namespace {

constexpr double kMostAlone =
    0.45;  // largest `alone` as a share of the feet's distance; between the two zones the load goes over without a jump

}  // namespace

Vec12 distribute_wrench(const Vec3& F, const Vec3& M_P, const Vec3& P, const std::array<Vec3, 2>& c, const Vec3& along,
                        double alone) {
  Vec3 axis = along;
  double span = (c[kLeft] - c[kRight]).dot(axis), margin = std::min(alone / std::abs(span), kMostAlone);
  if (std::abs(span) < 0.5 * (c[kLeft] - c[kRight]).norm()) {  // feet nearly in line: share along the line between them
    axis = c[kLeft] - c[kRight];
    span = axis.squaredNorm();
    margin = std::min(alone / std::sqrt(span), kMostAlone);
  }
  const double a_left = std::clamp(((P - c[kRight]).dot(axis) / span - margin) / (1.0 - 2.0 * margin), 0.0, 1.0);
  const std::array<double, 2> a{a_left, 1.0 - a_left};
  const Vec3 delta = P - (a[kLeft] * c[kLeft] + a[kRight] * c[kRight]);
  Vec12 f;
  for (const Side side : kSides) {
    const Vec3 F_i = a[side] * F;
    f.segment<3>(6 * side) = F_i;
    f.segment<3>(6 * side + 3) = delta.cross(F_i) + a[side] * M_P;
  }
  return f;
}

}  // namespace zmpwalk
