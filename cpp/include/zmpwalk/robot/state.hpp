#pragma once

#include <array>
#include <vector>

#include "zmpwalk/control/external.hpp"
#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// What is measured or known of the robot beside position and velocity. NaN means unknown.
struct Sensed {
  /// Wrench of each foot on the ground, world axes, at the sole centre, left and right [N, N m].
  std::array<Vec6, 2> wrench{Vec6::Constant(kNaN), Vec6::Constant(kNaN)};
  /// 1 where a foot touches the ground, 0 where it does not; left and right.
  std::array<double, 2> contact{kNaN, kNaN};
  std::vector<ExternalWrench> external;  ///< known forces on the robot, such as the weight of what it carries
};

/// What a cycle knows of the robot: measured, estimated, or read from a simulator. Plain numbers.
///
/// The order of `q` and `dq` is MuJoCo's for a robot with a free base: base position in W (3), base quaternion (w, x, y, z), then the
/// joints; base velocity in world axes (3), base angular velocity in base axes (3), then the joints.
struct State : Sensed {
  State() = default;
  /// At rest, upright, at the origin. @param nv velocity coordinates, 6 + joints
  explicit State(int nv) : q(VecX::Unit(nv + 1, 3)), dq(VecX::Zero(nv)) {}

  double time = 0.0;  ///< [s]
  VecX q;             ///< (nv + 1,) [m, -, rad]
  VecX dq;            ///< (nv,) [m/s, rad/s]
};

/// What any state has to be. @param nv velocity coordinates of the robot
/// @throws DimensionError q or dq of another size; InputError time, position or velocity is not finite, or the base's quaternion has no length
void require_state(const State& state, int nv);

}  // namespace zmpwalk
