#pragma once

#include <algorithm>
#include <array>

#include "zmpwalk/gait/pendulum.hpp"
#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// An interval of one horizontal axis [m].
struct Interval {
  double lower = 0.0, upper = 0.0;
  /// How far `x` is outside; 0 inside.
  double outside(double x) const { return std::max({lower - x, x - upper, 0.0}); }
};

/// One horizontal axis of a robot that wants to catch itself, as lengths from the foot that stands next alone, or alone already [m].
struct CatchAxis {
  double xi = 0.0;  ///< DCM now
  Interval both;    ///< where the ZMP may be while both feet stand
  Interval alone;   ///< where it may be while one foot stands
  Interval place;   ///< where the other foot can be set down then
  Interval hold;    ///< where the DCM may be, from that foot, so that the steps after it catch it
};

/// When the foot in the air can land [s].
struct CatchTimes {
  double both = 0.0;               ///< how long both feet still stand
  double planned = 0.0;            ///< from the lift-off, or from now where the foot is in the air
  double least = 0.0, most = 0.0;  ///< earliest and latest landing, from the same instant
};

/// What a leg can do in a step that catches the robot.
struct StepReach {
  double ahead = 0.0;       ///< farthest foothold ahead of the standing foot, or behind it [m]
  double aside = 0.0;       ///< farthest foothold beside it [m]
  double near = 0.0;        ///< nearest foothold beside it, so that the feet do not cross [m]
  double least_time = 0.0;  ///< shortest single support [s]
};

/// The capture region of the pendulum (16): the places of the DCM from which some sequence of steps within reach brings it to rest.
///
/// Under a ZMP z the DCM goes to z + (xi - z) exp(s / T_c) within s. So it arrives in [l, u] for some z in [z_l, z_u], if it is now in
/// [z_l + (l - z_l) exp(-s / T_c), z_u + (u - z_u) exp(-s / T_c)] (`before`). Applied from the last step to the first, this gives the region for any number of steps;
/// each axis by itself, which makes it larger, but with one landing time for both.
class CaptureRegion {
 public:
  /// Where the DCM has to be `shrink` = exp(-s / T_c) earlier, so that it can be in `then`.
  static Interval before(const Interval& then, const Interval& zmp, double shrink) {
    return {zmp.lower + (then.lower - zmp.lower) * shrink, zmp.upper + (then.upper - zmp.upper) * shrink};
  }

  /// @param reach of every later step   @param sole half length and half width that the ZMP may use (2,) [m]
  CaptureRegion(const StepReach& reach, const Vec2& sole) : reach_(reach), sole_(sole) {}

  /// Takes the pendulum; computes only where it has changed.
  void set_pendulum(const LinearInvertedPendulum& pendulum);
  /// Where the DCM may be, along x and away from the foot that stood before (2,), from a foot that has just landed: any number of steps follow it.
  const std::array<Interval, 2>& hold() const { return hold_; }
  const StepReach& reach() const { return reach_; }

  /// How far the DCM is outside the region, for the landing time that is best [m]; 0 inside. Allocates nothing.
  double gap(const std::array<CatchAxis, 2>& axes, const CatchTimes& times) const;

 private:
  double gap_at(const std::array<CatchAxis, 2>& axes, double shrink, double shrink_both) const;

  StepReach reach_;
  Vec2 sole_;
  double Tc_ = 0.0;
  std::array<Interval, 2> hold_;
};

}  // namespace zmpwalk
