#pragma once

#include "zmpwalk/gait/gait_generator.hpp"

namespace zmpwalk {

/// Height of the ground under the COM, as a walk over known ground plans it: with feet that rise from step to step, the COM rises evenly.
///
/// In the middle of the double support between a foot at z_0 and the next one at z_1 the height is (z_0 + z_1) / 2 and its rate (z_1 - z_0) / T, with
/// the step period T. So the COM rises ahead of the leg that lifts it. On the way there the height is a cubic, which is
/// computed anew in each cycle from where the height is.
class HeightPlan {
 public:
  explicit HeightPlan(double dt = 0.0, double Tc = 0.0) : dt_(dt), Tc_(Tc) {}
  /// Begins on feet whose ground has the height `start` in W [m].
  void reset(double start);
  /// Goes on by one cycle. @param period of the steps [s]
  void update(const GaitOutput& gait, double period);

  double rise() const { return h_; }      ///< since the start [m]
  double drise() const { return dh_; }    ///< [m/s]
  double ddrise() const { return ddh_; }  ///< [m/s^2]

 private:
  double dt_, Tc_, start_ = 0.0;
  double h_ = 0.0, dh_ = 0.0, ddh_ = 0.0;
};

}  // namespace zmpwalk
