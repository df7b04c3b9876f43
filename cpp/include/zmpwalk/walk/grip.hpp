#pragma once

#include <algorithm>
#include <array>

#include "zmpwalk/control/dynamics.hpp"
#include "zmpwalk/gait/gait_generator.hpp"
#include "zmpwalk/settings/settings.hpp"

namespace zmpwalk {

/// What the walk finds out about the friction under its feet: a foot that moves along the ground while it carries slips.
///
/// A sole slips whose corners have moved along the ground faster than quiet walks turn them, for more than a small way. Then the friction under that
/// foot is no more than what the torque asked of it, |F_xy| / F_z, and falls on while it slips. It recovers slowly. While it is low, the
/// plan slows down. Where no foot slips, nothing is changed; nor is it where the friction that is believed explains that a sole moves, since most of it
/// was asked for. Works with `limits.feel_slip`.
class Grip {
 public:
  /// @param sole of either foot   @param z_c height of the COM over the soles [m]   @param gravity [m/s^2]   @param friction that is believed at first
  Grip(const WalkSettings& settings, const SoleSize& sole, double z_c, double gravity, double friction);

  void reset();
  /// Goes on by one cycle. @param f_c  robot on ground, of the last cycle, force and moment of each foot [N, N m]
  /// @returns whether the friction of a foot has changed
  bool update(const GaitOutput& gait, const Dynamics& dynamics, const Vec12& f_c);

  double friction(Side side) const { return friction_[side]; }  ///< under a foot, as far as is known
  double friction() const { return std::min(friction_[kLeft], friction_[kRight]); }
  /// Share of the planned speed that this friction allows.
  double pace() const { return pace_; }

 private:
  bool on_;
  double dt_, radius_, slow_, way_, fall_, recover_, start_;
  std::array<double, 2> friction_, slipped_{};
  double pace_ = 1.0;
};

}  // namespace zmpwalk
