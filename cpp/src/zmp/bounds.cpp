#include "zmpwalk/zmp/bounds.hpp"

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

ZmpBounds zmp_bounds(const SoleLimits& sole, double weight, double sole_fraction, double torque_fraction) {
  require_positive("weight", weight);
  const Vec2 half = 0.5 * sole_fraction * Vec2(sole.length, sole.width);
  const Vec2 by_ankle = torque_fraction / weight * Vec2(sole.pitch_torque, sole.roll_torque);
  ZmpBounds out;
  out.lower = (-half).cwiseMax(sole.ankle - by_ankle);
  out.upper = half.cwiseMin(sole.ankle + by_ankle);
  for (int i = 0; i < 2; ++i)
    if (!(out.lower[i] < out.upper[i]))
      throw InputError(std::string("no room for the ZMP along ") + (i == 0 ? "x" : "y") + ": the sole allows +-" +
                       std::to_string(half[i]) + " m, the ankle " + std::to_string(sole.ankle[i]) + " +- " +
                       std::to_string(by_ankle[i]) + " m; a larger sole_fraction or a stronger ankle gives room");
  return out;
}

double place_with_room(const std::array<ZmpBounds, 2>& bounds, double sole_length, double wanted) {
  constexpr double kRoom = 0.2;  // [sole_length]
  const double lower = std::max(bounds[0].lower.x(), bounds[1].lower.x());
  const double upper = std::min(bounds[0].upper.x(), bounds[1].upper.x());
  const double least = lower + kRoom * sole_length, most = upper - kRoom * sole_length;
  return least < most ? std::clamp(wanted, least, most) : 0.5 * (lower + upper);
}

}  // namespace zmpwalk
