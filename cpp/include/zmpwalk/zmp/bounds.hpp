#pragma once

#include <algorithm>

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// Where the ZMP may go, as a rectangle in the axes of a sole, about the sole's centre (2,) [m]: x forward, y left.
struct ZmpBounds {
  Vec2 lower = Vec2::Zero();
  Vec2 upper = Vec2::Zero();

  Vec2 clamp(const Vec2& zmp) const { return zmp.cwiseMax(lower).cwiseMin(upper); }
  /// Two standing feet: sideways the ZMP may also be within the other foot's bounds, `across` from this sole [m], or between.
  ZmpBounds widened(const ZmpBounds& other, double across) const {
    ZmpBounds out = *this;
    out.lower.y() = std::min(lower.y(), across + other.lower.y());
    out.upper.y() = std::max(upper.y(), across + other.upper.y());
    return out;
  }
};

/// Sole and ankle of one foot, as far as the ZMP cares.
struct SoleLimits {
  double length = 0.0;        ///< of the sole [m]
  double width = 0.0;         ///< of the sole [m]
  Vec2 ankle = Vec2::Zero();  ///< ankle axes in the sole frame (x of the pitch axis, y of the roll axis) [m]
  double pitch_torque = 0.0;  ///< limit of the ankle's pitch joint [N m]; infinity for none
  double roll_torque = 0.0;   ///< limit of the ankle's roll joint [N m]; infinity for none
};

/// Designed bounds: the sole shrunk to `sole_fraction`, cut with what the ankle can hold, p_ankle +- `torque_fraction` tau_max / (m g).
///
/// @param weight m g [N]
/// @throws InputError where nothing is left: the message gives the numbers
ZmpBounds zmp_bounds(const SoleLimits& sole, double weight, double sole_fraction, double torque_fraction);

}  // namespace zmpwalk
