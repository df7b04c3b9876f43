#pragma once

#include "zmpwalk/math/types.hpp"
#include "zmpwalk/robot/mujoco.hpp"

namespace zmpwalk {

/// The shape of one geom of a model.
struct Shape {
  const Model& m;
  int geom;

  /// How far it reaches from its origin in a direction, a unit vector in its own axes [m]. Planes and height fields have no end, and count as points.
  double extent(const Vec3& towards) const;
};

}  // namespace zmpwalk
