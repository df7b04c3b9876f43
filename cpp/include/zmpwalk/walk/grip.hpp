#pragma once

#include <algorithm>
#include <array>

#include "zmpwalk/control/dynamics.hpp"
#include "zmpwalk/gait/gait_generator.hpp"
#include "zmpwalk/settings/settings.hpp"

namespace zmpwalk {

/// What the walk finds out about the friction under its feet: a foot that moves along the ground while it carries slips.
///
/// A sole slips where the point at which the force asked of it acts moves along the ground, for more than a small way. A sole that turns about that
/// point, by its yaw moment or over an edge, does not. What was asked while it slid, (|F_xy| + |M_z| / r) / F_z with M_z about that point and r half the
/// sole's diagonal, is more than friction holds: two thirds of the most of it are believed from then on, and recover slowly. While friction is low, the
/// plan slows down. Nothing is changed where no foot slips, or where half of the believed friction was asked: such a sole has met a limit that is known.
/// Works with `limits.feel_slip`.
class Grip {
 public:
  /// @param sole of either foot   @param z_c height of the COM over the soles [m]   @param gravity [m/s^2]   @param friction that is believed at first
  Grip(const WalkSettings& settings, const SoleSize& sole, double z_c, double gravity, double friction);

  void reset();
  /// Goes on by one cycle.
  /// @param f_c  robot on ground, of the last cycle, force and moment of each foot [N, N m]
  /// @returns whether the friction of a foot has changed
  bool update(const GaitOutput& gait, const Dynamics& dynamics, const Vec12& f_c);

  double friction(Side side) const { return friction_[side]; }  ///< under a foot, as far as is known
  double friction() const { return std::min(friction_[kLeft], friction_[kRight]); }
  /// Share of the planned speed that this friction allows.
  double pace() const { return pace_; }

 private:
  bool on_;
  double dt_, ahead_, aside_, slow_, way_, recover_, start_;
  std::array<double, 2> friction_, slipped_{}, asked_{};
  double pace_ = 1.0;
};

}  // namespace zmpwalk
