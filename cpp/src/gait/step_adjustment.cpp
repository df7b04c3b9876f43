#include "zmpwalk/gait/step_adjustment.hpp"

#include <algorithm>
#include <cmath>

namespace zmpwalk {
namespace {

constexpr int kCandidates = 32;  // landing times that are looked at, from the earliest to the latest

/// Distance of `x` from the interval [lower, upper]; 0 inside.
double outside(double x, double lower, double upper) { return std::max({lower - x, x - upper, 0.0}); }

}  // namespace

double StepAdjustment::cost(const LinearInvertedPendulum& pendulum, const std::array<StepAxis, 2>& axes,
                            const StepLimits& limits, double time) const {
  const double grow = pendulum.growth(std::max(time + limits.take_over, 0.0)).factor;
  const double later = time - limits.planned;
  double cost = weights_.time * later * later;
  for (const StepAxis& a : axes) {
    // Where the foot would have to land, for a ZMP at either bound.
    const double first = a.zmp_upper + (a.xi - a.zmp_upper) * grow - a.offset,
                 last = a.zmp_lower + (a.xi - a.zmp_lower) * grow - a.offset;
    const double planned = a.place + a.drift * later;
    const double wanted = std::clamp(planned, first, std::max(first, last));
    // The planned place itself is always within reach; in the time left the foot comes only so far.
    const double way = a.foot_acceleration * time * time / 6.0, middle = a.foot + 0.5 * time * a.foot_velocity;
    const double lower = std::min(std::max(a.place_lower, middle - way), a.place_upper),
                 upper = std::max(std::min(a.place_upper, middle + way), lower);
    const double place = std::clamp(wanted, std::min(lower, planned), std::max(upper, planned));
    const double gap = std::max(outside(place, first, last) - a.give, 0.0), moved = place - planned;
    cost += gap * gap + weights_.place * moved * moved;
  }
  return cost;
}

double StepAdjustment::time(const LinearInvertedPendulum& pendulum, const std::array<StepAxis, 2>& axes,
                            const StepLimits& limits) const {
  const auto at = [&](double t) { return cost(pendulum, axes, limits, t); };
  const double planned = std::max(limits.planned, limits.least);
  if (at(planned) <= weights_.band) return planned;
  double best = std::clamp(limits.current, limits.least, std::max(limits.most, limits.least));
  double least = at(best) - weights_.band;
  for (int i = 0; i <= kCandidates; ++i) {
    const double t = limits.least + (limits.most - limits.least) * i / kCandidates;
    if (const double c = at(t); c < least) {
      least = c;
      best = t;
    }
  }
  return best;
}

}  // namespace zmpwalk
