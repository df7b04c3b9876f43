#include "zmpwalk/gait/known_ground.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {
namespace {

constexpr int kAlong = 5, kAcross = 3;  // points of a sole at which the ground is looked at
constexpr double kSteepest = 0.47;      // rise of the steepest ground that a sole is set on: 25 degrees
// Shares of the sole's length.
constexpr double kFlat = 0.016;       // most that ground under a sole may differ from its plane
constexpr double kMove = 0.02;        // by which places are moved in a search
constexpr double kSamePlane = 0.008;  // most by which places of one plane differ from it
constexpr int kRoom = 4;              // moves that a place is to have before and behind it, or as much of both
constexpr double kBends = 0.1;        // and by so much more per distance: ground may be curved
constexpr std::size_t kMostCells = 1 << 16;

bool inside(const GroundPatch& patch, const Vec2& p) {
  return patch.lower.x() <= p.x() && p.x() < patch.upper.x() && patch.lower.y() <= p.y() && p.y() < patch.upper.y();
}

}  // namespace

Plane GroundPoint::plane(const Vec2& p) const {
  return Plane::through({p.x(), p.y(), height}, Vec3(-rise.x(), -rise.y(), 1.0).normalized());
}

Vec2 tilt_on(const Vec2& rise, double yaw) {
  const Vec2 ahead = ahead_of(yaw);
  const double pitch = -std::atan(rise.dot(ahead));
  return {std::atan(rise.dot(left_of(ahead)) * std::cos(pitch)), pitch};
}

KnownGround::KnownGround(std::vector<GroundPatch> patches) : patches_(std::move(patches)) {
  if (patches_.empty()) throw InputError("the ground has no patch; give at least one, or none of it");
  Vec2 lower = patches_[0].lower, upper = patches_[0].upper;
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    const GroundPatch& p = patches_[i];
    if (!p.lower.allFinite() || !p.upper.allFinite() || !std::isfinite(p.height) || !p.rise.allFinite())
      throw InputError("patch " + std::to_string(i) + " of the ground has a number that is not finite");
    if (!(p.lower.x() < p.upper.x() && p.lower.y() < p.upper.y()))
      throw InputError("patch " + std::to_string(i) + " of the ground has no area: its ranges must go upwards");
    lower = lower.cwiseMin(p.lower);
    upper = upper.cwiseMax(p.upper);
  }
  // A cell knows the patches that it touches, so that a place asks a few patches only.
  const auto cells = [&](int axis) { return static_cast<std::size_t>((upper - lower)[axis] / cell_) + 1; };
  while (cells(0) > kMostCells / cells(1)) cell_ *= 2.0;
  cells_.corner = lower;
  cells_.rows = static_cast<int>(cells(0));
  cells_.columns = static_cast<int>(cells(1));
  for (int i = 0; i < cells_.rows; ++i)
    for (int j = 0; j < cells_.columns; ++j) {
      cells_.first.push_back(static_cast<int>(cells_.patch.size()));
      const Vec2 from = lower + cell_ * Vec2(i, j);
      for (std::size_t k = 0; k < patches_.size(); ++k) {
        const GroundPatch& p = patches_[k];
        if (p.lower.x() <= from.x() + cell_ && p.upper.x() >= from.x() && p.lower.y() <= from.y() + cell_ &&
            p.upper.y() >= from.y())
          cells_.patch.push_back(static_cast<int>(k));
      }
    }
  cells_.first.push_back(static_cast<int>(cells_.patch.size()));
}

KnownGround::KnownGround(const Vec2& corner, double spacing, RowMatX heights)
    : heights_(std::move(heights)), corner_(corner), spacing_(spacing) {
  require_positive("spacing", spacing);
  if (heights_.rows() < 2 || heights_.cols() < 2)
    throw InputError("a grid of heights has at least two rows and two columns; this one has " +
                     std::to_string(heights_.rows()) + " and " + std::to_string(heights_.cols()));
  if (!heights_.allFinite() || !corner.allFinite())
    throw InputError("a grid of heights has a number that is not finite");
}

GroundPoint KnownGround::at(const Vec2& p) const {
  GroundPoint out;
  if (heights_.size() > 0) {
    const Vec2 u = (p - corner_) / spacing_;
    if (!(u.x() >= 0.0 && u.y() >= 0.0 && u.x() <= heights_.rows() - 1 && u.y() <= heights_.cols() - 1)) return out;
    const Eigen::Index i = std::min<Eigen::Index>(static_cast<Eigen::Index>(u.x()), heights_.rows() - 2),
                       j = std::min<Eigen::Index>(static_cast<Eigen::Index>(u.y()), heights_.cols() - 2);
    const double x = u.x() - i, y = u.y() - j;
    const double a = heights_(i, j), b = heights_(i + 1, j), c = heights_(i, j + 1), d = heights_(i + 1, j + 1);
    out.height = lift_ + (1.0 - y) * (a + x * (b - a)) + y * (c + x * (d - c));
    out.rise = Vec2((1.0 - y) * (b - a) + y * (d - c), (1.0 - x) * (c - a) + x * (d - b)) / spacing_;
    return out;
  }
  const Vec2 u = (p - cells_.corner) / cell_;
  if (!(u.x() >= 0.0 && u.y() >= 0.0 && u.x() < cells_.rows && u.y() < cells_.columns)) return out;
  const int cell = static_cast<int>(u.x()) * cells_.columns + static_cast<int>(u.y());
  for (int k = cells_.first[cell]; k < cells_.first[cell + 1]; ++k) {
    const GroundPatch& patch = patches_[cells_.patch[k]];
    if (!inside(patch, p)) continue;
    const double height = lift_ + patch.height + patch.rise.dot(p - 0.5 * (patch.lower + patch.upper));
    if (height <= out.height) continue;
    out.height = height;
    out.rise = patch.rise;
  }
  return out;
}

SolePlace KnownGround::under(const Foothold& place, const SoleSize& sole, double margin) const {
  SolePlace out;
  out.at = place;
  const Vec2 ahead = ahead_of(place.yaw), left = left_of(ahead);
  const Vec2 half(0.5 * sole.length + margin, 0.5 * sole.width + margin);
  std::array<double, kAlong * kAcross> h;
  double mean = 0.0, xh = 0.0, yh = 0.0, xx = 0.0, yy = 0.0;
  const auto point = [&](int i) {
    return Vec2(half.x() * (2.0 * (i / kAcross) / (kAlong - 1) - 1.0),
                half.y() * (2.0 * (i % kAcross) / (kAcross - 1) - 1.0));
  };
  for (int i = 0; i < kAlong * kAcross; ++i) {
    const Vec2 u = point(i);
    h[i] = at(place.p + u.x() * ahead + u.y() * left).height;
    if (std::isnan(h[i])) return out;
    mean += h[i] / (kAlong * kAcross);
    xh += u.x() * h[i];
    yh += u.y() * h[i];
    xx += u.x() * u.x();
    yy += u.y() * u.y();
  }
  const Vec2 rise(xh / xx, yh / yy);
  double off = 0.0;
  for (int i = 0; i < kAlong * kAcross; ++i) off = std::max(off, std::abs(h[i] - mean - rise.dot(point(i))));
  out.height = mean;
  out.rise = rise.x() * ahead + rise.y() * left;
  out.good = off < kFlat * sole.length && rise.norm() < kSteepest;
  if (!out.good) {
    const GroundPoint centre = at(place.p);
    out.height = centre.height;
    out.rise = centre.rise;
  }
  return out;
}

SolePlace KnownGround::nearest(const Foothold& wanted, const SoleSize& sole, double margin, double far,
                               const SolePlace* like) const {
  const Vec2 ahead = ahead_of(wanted.yaw), left = left_of(ahead);
  const auto fits = [&](const SolePlace& place) {
    if (!place.good || !like) return place.good;
    const Vec2 away = place.at.p - like->at.p;
    return std::abs(place.height - like->height - like->rise.dot(away)) <
           kSamePlane * sole.length + kBends * away.norm();
  };
  SolePlace best = under(wanted, sole, margin);
  if (fits(best)) return amid(best, sole, margin);
  best.good = false;
  double least = far * far;
  const double move = kMove * sole.length;
  const int most = static_cast<int>(far / move), aside = most / 2;
  for (int j = 0; j <= aside; j += 4)
    for (int i = 0; i <= most; ++i) {
      const double away = move * move * (i * i + j * j);
      if (away >= least) break;
      if (i == 0 && j == 0) continue;
      for (int sign = 0; sign < 4; ++sign) {
        if ((i == 0 && sign % 2) || (j == 0 && sign / 2)) continue;
        const double x = sign % 2 ? -i : i, y = sign / 2 ? -j : j;
        const SolePlace there = under({wanted.p + move * (x * ahead + y * left), wanted.yaw}, sole, margin);
        if (!fits(there)) continue;
        best = there;
        least = away;
        break;
      }
    }
  return best.good ? amid(best, sole, margin) : best;
}

SolePlace KnownGround::amid(const SolePlace& place, const SoleSize& sole, double margin) const {
  const double move = kMove * sole.length;
  const Vec2 ahead = ahead_of(place.at.yaw);
  const auto at_way = [&](int i) { return under({place.at.p + i * move * ahead, place.at.yaw}, sole, margin); };
  std::array<int, 2> free{kRoom, kRoom};
  for (const int k : {0, 1}) {
    const int sign = k ? 1 : -1;
    if (at_way(sign * kRoom).good) continue;
    for (free[k] = 0; free[k] < kRoom - 1 && at_way(sign * (free[k] + 1)).good;) ++free[k];
  }
  if (free[0] == free[1]) return place;
  const double shift = 0.5 * (free[1] - free[0]);
  return under({place.at.p + shift * move * ahead, place.at.yaw}, sole, margin);
}

}  // namespace zmpwalk
