#pragma once

#include <vector>

#include "zmpwalk/settings/settings.hpp"

namespace zmpwalk {

/// Where a tracker's law holds the ZMP in a cycle.
enum class Drive : int {
  kLower = -1,  ///< on the lower bound, so that the COM speeds up until the integral is zero
  kNone = 0,    ///< on no bound: the ZMP only has to stay inside its bounds
  kUpper = 1,   ///< on the upper bound, so that the COM slows down until the integral is zero
};

/// The velocities at one instant, along the x axis of H (the path).
struct Tracking {
  const TrackingSettings& settings;
  double v_plan;  ///< planned velocity [m/s]
  double v;       ///< current velocity of the COM [m/s]
  double
      catch_up;  ///< speed to add to v_plan to make up lost way: -k (I - ahead) within `tracking.catch_up_speed` [m/s]
};

/// The way that the COM is ahead of its plan, I = integral of (v_des - v_plan), at the end of a cycle [m].
struct TrackedWay {
  const TrackingSettings& settings;
  double before, now;  ///< I at the end of the cycle before, and of this one [m]
  Drive drive;         ///< drive of this cycle
};

/// A law of III-C: it decides how the COM's velocity follows the planned one. It has no memory; `VelocityTracker` keeps I and the drive.
///
/// To add one, write its functions in `tracker_law.cpp` and give it a row in `all()`; its name is a value of `tracking.law` then.
struct TrackerLaw {
  const char* name;
  const char* meaning;  ///< goes on after "'name', which"; without a full stop
  /// Whether the COM's desired velocity is the planned one itself. Otherwise the pendulum gets the `acceleration`.
  bool follows_plan;
  /// COM acceleration [m/s^2]. A law that follows the plan gives it too: a sole that is turned against the path needs it sideways.
  double (*acceleration)(const Tracking&);
  /// Where the next cycle holds the ZMP.
  Drive (*drive)(const TrackedWay&);

  /// Every law; the first is the default.
  static const std::vector<TrackerLaw>& all();
  static const TrackerLaw& of(TrackerLawName name) { return all()[static_cast<std::size_t>(name)]; }
};

}  // namespace zmpwalk
