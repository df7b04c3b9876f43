#include "zmpwalk/gait/capture_region.hpp"

#include <algorithm>
#include <cmath>

namespace zmpwalk {
namespace {

constexpr int kCandidates = 24;  // landing times that are looked at, from the earliest to the latest

}  // namespace

void CaptureRegion::set_pendulum(const LinearInvertedPendulum& pendulum) {
  if (pendulum.Tc() == Tc_) return;
  Tc_ = pendulum.Tc();
  const double shrink = std::exp(-reach_.least_time / Tc_);
  // Ahead the region h of a foot is that of the next one, a step earlier: h = a + (ahead + h - a) shrink.
  const double h = sole_.x() + reach_.ahead * shrink / (1.0 - shrink);
  hold_[0] = {-h, h};
  // Sideways the feet alternate. Towards the other foot the DCM may be b = w + (aside + c - w) shrink, away from it
  // c = w, or more where the foot after the next lands quickly and near: c = w + (b - near - w) shrink.
  const double w = sole_.y();
  double b = reach_.aside * shrink, c = 0.0;  // beyond the edges
  if (b > reach_.near) {
    b = shrink * (reach_.aside - reach_.near * shrink) / (1.0 - shrink * shrink);
    c = (b - reach_.near) * shrink;
  }
  hold_[1] = {-(w + b), w + c};
}

double CaptureRegion::gap_at(const std::array<CatchAxis, 2>& axes, double shrink, double shrink_both) const {
  double squares = 0.0;
  for (const CatchAxis& a : axes) {
    const Interval landing{a.place.lower + a.hold.lower, a.place.upper + a.hold.upper};
    const double off = before(before(landing, a.alone, shrink), a.both, shrink_both).outside(a.xi);
    squares += off * off;
  }
  return std::sqrt(squares);
}

double CaptureRegion::gap(const std::array<CatchAxis, 2>& axes, const CatchTimes& times) const {
  const double both = times.both > 0.0 ? std::exp(-times.both / Tc_) : 1.0;
  double least = gap_at(axes, std::exp(-times.planned / Tc_), both);
  if (least == 0.0 || !(times.most > times.least)) return least;
  double shrink = std::exp(-times.least / Tc_);
  const double later = std::exp(-(times.most - times.least) / kCandidates / Tc_);
  for (int i = 0; i <= kCandidates && least > 0.0; ++i, shrink *= later)
    least = std::min(least, gap_at(axes, shrink, both));
  return least;
}

}  // namespace zmpwalk
