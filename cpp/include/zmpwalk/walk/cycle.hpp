#pragma once

#include "zmpwalk/control/dynamics.hpp"
#include "zmpwalk/gait/gait_generator.hpp"
#include "zmpwalk/gait/pendulum.hpp"
#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// One control cycle as the laws of the walk see it: dynamics, gait, pendulum, the frames S and H, and the COM in S.
///
/// The support frame S has its origin at the support sole's centre and its x axis along that sole. The heading frame H has its x axis along the
/// path. Both are level. A member that ends in _S is expressed in S, one that ends in _W in the world.
struct Cycle {
  double t = 0.0;                                         ///< time since the walk began [s]
  const Dynamics* dynamics = nullptr;                     ///< of this instant
  const GaitOutput* gait = nullptr;                       ///< of this instant
  const LinearInvertedPendulum* pendulum = nullptr;       ///< of this instant's COM height
  Mat2 R_WS = Mat2::Identity(), R_WH = Mat2::Identity();  ///< axes of S and of H in W, horizontal part
  /// Shift of the COM by which the pendulum knows of known forces (`forced_pendulum`), W [m]. The COM in S, current and measured, has it.
  Vec2 shift = Vec2::Zero();
  Vec2 steadying = Vec2::Zero();  ///< shift of the reference ZMP against the rotation of a sole that rocks, W [m]
  Vec2 com_S = Vec2::Zero(), dcom_S = Vec2::Zero();            ///< "current" COM state of (16), (17) [m, m/s]
  Vec2 com_meas_S = Vec2::Zero(), dcom_meas_S = Vec2::Zero();  ///< measured COM state [m, m/s]

  /// The point of S that lies at `p_W` in the world, and the reverse [m].
  Vec2 to_S(const Vec2& p_W) const { return R_WS.transpose() * (p_W - gait->origin); }
  Vec2 to_W(const Vec2& p_S) const { return gait->origin + R_WS * p_S; }
};

/// Makes the cycle at time `t` [s].
/// @param com, dcom  "current" COM state of (16), W (2,) [m, m/s]
/// @param shift      `Cycle::shift`
Cycle cycle_of(double t, const Dynamics& dynamics, const GaitOutput& gait, const LinearInvertedPendulum& pendulum,
               const Vec2& com, const Vec2& dcom, const Vec2& shift);

}  // namespace zmpwalk
