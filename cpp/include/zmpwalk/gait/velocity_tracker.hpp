#pragma once

#include "zmpwalk/gait/tracker_law.hpp"
#include "zmpwalk/settings/settings.hpp"

namespace zmpwalk {

/// Planned-velocity tracking along one axis, III-C.
///
/// Integrates I = integral of (v_des - v_plan); a `TrackerLaw` decides what follows from it. The law "bang_bang" is the paper's: while I is not
/// zero the desired ZMP sits on a bound. The law "smooth" asks for v_want = v_plan - k I and removes the speed error in `time`:
/// a = (v_want - v) / time; it needs no modes. k I stays within `catch_up_speed`: a robot whose feet could not follow catches up slowly.
class VelocityTracker {
 public:
  /// @param settings resolved. @throws InputError gain, time or deadband is not finite and > 0
  explicit VelocityTracker(const TrackingSettings& settings);

  void reset();
  const TrackerLaw& law() const { return *law_; }
  /// What the law asks of the ZMP in this cycle.
  Drive drive() const { return drive_; }
  /// What the law asks of the pendulum for planned velocity `v_plan` and current velocity `v` [m/s]: an acceleration [m/s^2].
  /// @param ahead what I is meant to be now [m]
  double acceleration(double v_plan, double v, double ahead = 0.0) const;
  /// What it takes beside v_plan to make up lost way, -k (I - ahead) within `catch_up_speed` [m/s].
  double catch_up(double ahead = 0.0) const;
  /// Adds one cycle to the integral and takes the law's next drive.
  void advance(double v_des, double v_plan, double dt);

  double integral() const { return integral_; }  ///< [m]

 private:
  TrackingSettings settings_;
  const TrackerLaw* law_;
  double integral_ = 0.0;
  Drive drive_ = Drive::kNone;
};

}  // namespace zmpwalk
