#pragma once

#include <cmath>

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// Unit vector along a heading `yaw` [rad], and the one to its left.
inline Vec2 ahead_of(double yaw) { return {std::cos(yaw), std::sin(yaw)}; }
inline Vec2 left_of(double yaw) { return {-std::sin(yaw), std::cos(yaw)}; }
/// The unit vector to the left of the unit vector `ahead`.
inline Vec2 left_of(const Vec2& ahead) { return {-ahead.y(), ahead.x()}; }
/// The axes of a level frame whose x axis is the unit vector `ahead`, as a matrix (2, 2): p_W = axes_of(ahead) p.
inline Mat2 axes_of(const Vec2& ahead) { return (Mat2() << ahead.x(), -ahead.y(), ahead.y(), ahead.x()).finished(); }

/// A place for a foot: its sole's centre in the horizontal plane, and its heading (x, y [m], yaw [rad]) in W.
struct Foothold {
  Vec2 p = Vec2::Zero();
  double yaw = 0.0;
};

/// Size of a sole [m], and of the foot as it is seen from above, which keeps clear of the other one.
struct SoleSize {
  double length = 0.0, width = 0.0;
  double foot_length = length, foot_width = width;
};

}  // namespace zmpwalk
