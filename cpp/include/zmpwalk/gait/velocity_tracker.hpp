#pragma once

#include "zmpwalk/gait/tracker_law.hpp"
#include "zmpwalk/settings/settings.hpp"

namespace zmpwalk {

/// Lets the velocity of the COM follow the planned one, along one axis (III-C).
///
/// It integrates I = integral of (v_des - v_plan), which is the way that the COM is ahead of its plan. A `TrackerLaw` decides what follows from I. The law
/// "bang_bang" is the paper's: while I is not zero, the desired ZMP is on a bound. The law "smooth" wants the velocity v_want = v_plan - k I, and
/// removes the error of the velocity in `time`: a = (v_want - v) / time. |k I| stays within `catch_up_speed`, because feet cannot make up a long way at
/// once.
class VelocityTracker {
 public:
  /// @param settings resolved. @throws InputError gain, time or deadband is not finite and > 0
  explicit VelocityTracker(const TrackingSettings& settings);

  void reset();
  const TrackerLaw& law() const { return *law_; }
  /// Where the law holds the ZMP in this cycle.
  Drive drive() const { return drive_; }
  /// Acceleration that the law asks of the pendulum for the planned velocity `v_plan` and the current velocity `v` [m/s] -> [m/s^2].
  /// @param ahead value that I is meant to have now [m]
  double acceleration(double v_plan, double v, double ahead = 0.0) const;
  /// Speed that is added to v_plan to make up lost way: -k (I - ahead), within `catch_up_speed` [m/s].
  double catch_up(double ahead = 0.0) const;
  /// Adds one cycle to the integral, and lets the law choose its next drive.
  void advance(double v_des, double v_plan, double dt);

  double integral() const { return integral_; }  ///< [m]

 private:
  TrackingSettings settings_;
  const TrackerLaw* law_;
  double integral_ = 0.0;
  Drive drive_ = Drive::kNone;
};

}  // namespace zmpwalk
