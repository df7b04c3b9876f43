#pragma once

#include "zmpwalk/math/types.hpp"
#include "zmpwalk/settings/settings.hpp"

namespace zmpwalk {

/// What the bang-bang law does with the ZMP in this cycle.
enum class Drive : int {
  kLower = -1,  ///< it holds the ZMP on the lower bound, so that the COM speeds up until the integral is zero
  kNone = 0,    ///< it follows the planned velocity and keeps the ZMP inside its bounds
  kUpper = 1,   ///< it holds the ZMP on the upper bound, so that the COM slows down until the integral is zero
};

/// Lets the velocity of the COM follow the planned one, along one axis (III-C).
///
/// It integrates I = integral of (v_des - v_plan), which is the way that the COM is ahead of its plan. The bang-bang law is the paper's: while I is not
/// zero, the desired ZMP is on a bound. The smooth law wants the velocity v_want = v_plan - k I, and removes the error of the velocity in `time`:
/// a = (v_want - v) / time. |k I| stays within `catch_up_speed`, because feet cannot make up a long way at once.
class VelocityTracker {
 public:
  /// @param gain k [1/s]  @param time [s]  @param deadband |I| that counts as zero before a drive starts [m]. @throws InputError not finite and > 0
  /// @param catch_up_speed largest |k I| [m/s]
  VelocityTracker(TrackerLaw law, double gain, double time, double deadband,
                  double catch_up_speed = std::numeric_limits<double>::infinity());

  void reset();
  /// What the bang-bang law does now.
  Drive drive() const { return drive_; }
  /// Acceleration of the smooth law for the planned velocity `v_plan` and the current velocity `v` [m/s] -> [m/s^2].
  /// @param ahead value that I is meant to have now [m]
  double acceleration(double v_plan, double v, double ahead = 0.0) const;
  /// Speed that the smooth law adds to v_plan: -k (I - ahead), within `catch_up_speed` [m/s].
  double catch_up(double ahead = 0.0) const;
  /// Adds one cycle to the integral, and chooses what the bang-bang law does next.
  void advance(double v_des, double v_plan, double dt);

  double integral() const { return integral_; }  ///< [m]
  TrackerLaw law() const { return law_; }

 private:
  TrackerLaw law_;
  double gain_, time_, deadband_, catch_up_speed_;
  double integral_ = 0.0;
  Drive drive_ = Drive::kNone;
};

}  // namespace zmpwalk
