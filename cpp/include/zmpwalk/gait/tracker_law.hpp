#pragma once

#include <vector>

#include "zmpwalk/settings/settings.hpp"

namespace zmpwalk {

/// What the tracker asks of the ZMP this cycle.
enum class Drive : int {
  kLower = -1,  ///< ZMP to its lower bound: accelerate until the integral is zero
  kNone = 0,    ///< track; keep the ZMP inside its bounds
  kUpper = 1,   ///< ZMP to its upper bound: decelerate until the integral is zero
};

/// Velocity tracking at one instant, along the walk's x.
struct Tracking {
  const TrackingSettings& settings;
  double v_plan;  ///< planned velocity [m/s]
  double v;       ///< the COM's current one [m/s]
  double
      catch_up;  ///< what it takes beside v_plan to make up lost way: -k (I - ahead) within `tracking.catch_up_speed` [m/s]
};

/// I = integral of (v_des - v_plan) at the end of a cycle [m].
struct TrackedWay {
  const TrackingSettings& settings;
  double before, now;  ///< I at the end of the cycle before, and of this one [m]
  Drive drive;         ///< of this cycle
};

/// A law of III-C: how the COM's velocity follows the planned one. It has no memory; `VelocityTracker` keeps I and the drive.
///
/// To add one, write its functions in `tracker_law.cpp` and give it a row in `all()`; its name is a value of `tracking.law` then.
struct TrackerLaw {
  const char* name;
  const char* meaning;  ///< goes on after "'name', which"; without a full stop
  /// Whether the COM's desired velocity is the planned one itself. Else the pendulum is asked for `acceleration`.
  bool follows_plan;
  /// COM acceleration [m/s^2]. A law that follows the plan needs it for what the pendulum does across a sole that points elsewhere.
  double (*acceleration)(const Tracking&);
  /// What the next cycle asks of the ZMP, beside its staying inside the bounds.
  Drive (*drive)(const TrackedWay&);

  /// Every law; the first is the default.
  static const std::vector<TrackerLaw>& all();
  static const TrackerLaw& of(TrackerLawName name) { return all()[static_cast<std::size_t>(name)]; }
};

}  // namespace zmpwalk
