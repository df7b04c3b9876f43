#include "zmpwalk/gait/tracker_law.hpp"

#include <cmath>

namespace zmpwalk {
namespace {

// --- which acceleration is asked for

/// The speed error is removed within `tracking.time`.
double proportional(const Tracking& t) { return (t.v_plan + t.catch_up - t.v) / t.settings.time; }

// --- where the ZMP is driven to

Drive nowhere(const TrackedWay&) { return Drive::kNone; }

/// III-C: "until the integrated value becomes zero". In discrete time it steps over zero; what is left stays in the integral.
Drive to_a_bound(const TrackedWay& way) {
  if (way.drive != Drive::kNone) return way.before * way.now <= 0.0 ? Drive::kNone : way.drive;
  if (!(std::abs(way.now) > way.settings.deadband)) return Drive::kNone;
  return way.now < 0.0 ? Drive::kLower : Drive::kUpper;
}

}  // namespace

const std::vector<TrackerLaw>& TrackerLaw::all() {
  static const std::vector<TrackerLaw> laws{
      {"smooth", "accelerates in proportion to the error", false, proportional, nowhere},
      {"bang_bang", "drives the ZMP to its bounds until the error is gone, as III-C is printed", true, proportional,
       to_a_bound},
  };
  return laws;
}

const Choices<TrackerLawName>& choices(TrackerLawName) {
  static const Choices<TrackerLawName> names = choices_of<TrackerLawName>(TrackerLaw::all());
  return names;
}

}  // namespace zmpwalk
