#pragma once

#include <algorithm>
#include <array>

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// The rectangle in which the zero moment point (ZMP) is to stay, in the axes of a sole about its centre (2,) [m]: x forward, y left.
struct ZmpBounds {
  Vec2 lower = Vec2::Zero();
  Vec2 upper = Vec2::Zero();

  /// The point of the rectangle that is nearest to `zmp`.
  Vec2 clamp(const Vec2& zmp) const { return zmp.cwiseMax(lower).cwiseMin(upper); }
  /// The bounds for two standing feet: sideways the ZMP may also be between the soles, or within the bounds of the other foot, whose sole
  /// centre is `across` to the left of this one [m].
  ZmpBounds widened(const ZmpBounds& other, double across) const {
    ZmpBounds out = *this;
    out.lower.y() = std::min(lower.y(), across + other.lower.y());
    out.upper.y() = std::max(upper.y(), across + other.upper.y());
    return out;
  }
};

/// The place along x nearest to `wanted`, about the soles' centres, from which the ZMP of either foot can go a fifth of a sole ahead and as much
/// behind; the middle of what both feet allow where there is less [m]. @param sole_length [m]
double place_with_room(const std::array<ZmpBounds, 2>& bounds, double sole_length, double wanted);

/// What limits the ZMP under one foot: the size of the sole, and the torque of the ankle.
struct SoleLimits {
  double length = 0.0;        ///< of the sole [m]
  double width = 0.0;         ///< of the sole [m]
  Vec2 ankle = Vec2::Zero();  ///< ankle axes in the sole frame (x of the pitch axis, y of the roll axis) [m]
  double pitch_torque = 0.0;  ///< limit of the ankle's pitch joint [N m]; infinity for none
  double roll_torque = 0.0;   ///< limit of the ankle's roll joint [N m]; infinity for none
};

/// Bounds of the ZMP in one sole: `sole_fraction` of length and width, cut to what the ankle can hold, p_ankle +- `torque_fraction` tau_max / (m g).
///
/// @param weight m g [N]
/// @throws InputError  sole and ankle leave no place for the ZMP; the message gives the numbers
ZmpBounds zmp_bounds(const SoleLimits& sole, double weight, double sole_fraction, double torque_fraction);

}  // namespace zmpwalk
