#pragma once

#include <array>
#include <vector>

#include "zmpwalk/gait/foothold.hpp"
#include "zmpwalk/math/types.hpp"
#include "zmpwalk/zmp/plane.hpp"

namespace zmpwalk {

/// A plane piece of ground: a rectangle along the axes of W, as it is seen from above.
struct GroundPatch {
  Vec2 lower = Vec2::Zero(), upper = Vec2::Zero();  ///< its corners, W (2,) [m]
  double height = 0.0;                              ///< of its middle, W [m]
  Vec2 rise = Vec2::Zero();                         ///< how much higher it becomes per metre along x and along y (2,)
};

/// Height and slope of the ground at a place; not-a-number where there is no ground.
struct GroundPoint {
  double height = kNaN;              ///< W [m]
  Vec2 rise = Vec2::Zero();          ///< per metre along x and along y of W (2,)
  Plane plane(const Vec2& p) const;  ///< through the point of the ground at `p`
};

/// A place for a sole: the plane that fits the ground under it best, at its centre.
struct SolePlace : GroundPoint {
  Foothold at;
  bool good = false;  ///< the ground under the whole sole is flat, and no steeper than a sole stands on
};

/// Ground that the user knows: a height for each place, from plane patches or from heights on a grid.
///
/// Where patches overlap, the highest one counts. Between the points of a grid heights are bilinear. Nothing allocates after the construction.
class KnownGround {
 public:
  KnownGround() = default;  ///< nothing is known
  /// @throws InputError  a number is not finite, or a patch has no area
  explicit KnownGround(std::vector<GroundPatch> patches);
  /// Heights (rows along x, columns along y) of points `spacing` [m] apart, the first one at `corner`.
  /// @throws InputError  fewer than two rows or columns, a spacing that is not > 0, a number that is not finite
  KnownGround(const Vec2& corner, double spacing, RowMatX heights);

  bool known() const { return !patches_.empty() || heights_.size() > 0; }
  const std::vector<GroundPatch>& patches() const { return patches_; }  ///< none where heights are on a grid
  const RowMatX& heights() const { return heights_; }                   ///< of the grid; empty where there are patches
  const Vec2& corner() const { return corner_; }                        ///< of the grid (2,) [m]
  double spacing() const { return spacing_; }                           ///< of the grid [m]
  /// Moves all of it up by `rise` [m].
  void lift(double rise) { lift_ += rise; }
  GroundPoint at(const Vec2& p) const;
  /// The ground under a sole whose centre is at `p`, `margin` [m] larger than it is.
  SolePlace under(const Foothold& p, const SoleSize& sole, double margin) const;
  /// The good place nearest to `wanted`, at most `far` away along the heading, and half as far across [m]. Where there is none, the ground under
  /// `wanted`, which is not good.
  /// @param like  a place whose plane it has to lie on; null where it need not
  SolePlace nearest(const Foothold& wanted, const SoleSize& sole, double margin, double far,
                    const SolePlace* like = nullptr) const;

 private:
  /// The same place, away from an edge that is near ahead or behind, or between two.
  SolePlace amid(const SolePlace& place, const SoleSize& sole, double margin) const;

  struct Cells {
    Vec2 corner = Vec2::Zero();
    int rows = 0, columns = 0;
    std::vector<int> first, patch;  // the patches of cell i are patch[first[i]] up to patch[first[i + 1]]
  };

  std::vector<GroundPatch> patches_;
  Cells cells_;
  RowMatX heights_;
  Vec2 corner_ = Vec2::Zero();
  double spacing_ = 1.0, cell_ = 0.25, lift_ = 0.0;
};

/// Roll and pitch of a sole with the heading `yaw` on ground with this rise, R = R_z(yaw) R_y(pitch) R_x(roll) (2,) [rad].
Vec2 tilt_on(const Vec2& rise, double yaw);

}  // namespace zmpwalk
