#pragma once

#include "zmpwalk/math/types.hpp"
#include "zmpwalk/settings/settings.hpp"

namespace zmpwalk {

/// What the tracker asks of the ZMP this cycle.
enum class Drive : int {
  kLower = -1,  ///< ZMP to its lower bound: accelerate until the integral is zero
  kNone = 0,    ///< track; keep the ZMP inside its bounds
  kUpper = 1,   ///< ZMP to its upper bound: decelerate until the integral is zero
};

/// Planned-velocity tracking along one axis, III-C.
///
/// Integrates I = integral of (v_des - v_plan). The bang-bang law is the paper's: while I is not zero the desired ZMP sits on a bound.
/// The smooth law asks for v_want = v_plan - k I and removes the speed error in `time`: a = (v_want - v) / time; it needs no modes.
/// k I stays within `catch_up_speed`: a robot whose feet could not follow catches up slowly.
class VelocityTracker {
 public:
  /// @param gain k [1/s]  @param time [s]  @param deadband |I| that counts as zero before a drive starts [m]. @throws InputError not finite and > 0
  /// @param catch_up_speed largest |k I| [m/s]
  VelocityTracker(TrackerLaw law, double gain, double time, double deadband,
                  double catch_up_speed = std::numeric_limits<double>::infinity());

  void reset();
  /// Bang-bang law: what the state of the integral asks for.
  Drive drive() const { return drive_; }
  /// Smooth law: acceleration [m/s^2] for planned velocity `v_plan` and current velocity `v` [m/s].
  /// @param ahead what I is meant to be now [m]
  double acceleration(double v_plan, double v, double ahead = 0.0) const;
  /// Smooth law: what it adds to v_plan, -k (I - ahead) within `catch_up_speed` [m/s].
  double catch_up(double ahead = 0.0) const;
  /// Adds one cycle to the integral and, for the bang-bang law, takes the next mode.
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
