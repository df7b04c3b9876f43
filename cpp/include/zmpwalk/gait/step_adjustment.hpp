#pragma once

#include "zmpwalk/gait/pendulum.hpp"
#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// One horizontal axis of the step under way, as lengths from the support foot [m].
struct StepAxis {
  double xi = 0.0;                              ///< DCM now
  double zmp_lower = 0.0, zmp_upper = 0.0;      ///< where the ZMP may be until the swing foot takes over
  double place = 0.0;                           ///< where the swing foot is planned to land at the planned time
  double drift = 0.0;                           ///< by how much that place moves when the foot lands later [m/s]
  double place_lower = 0.0, place_upper = 0.0;  ///< where the leg can set it down
  double foot = 0.0;                            ///< where the swing foot is now
  double foot_velocity = 0.0;                   ///< its velocity [m/s]
  double foot_acceleration = 0.0;               ///< largest acceleration that it may take [m/s^2]
  double offset = 0.0;  ///< of the DCM from the landed foot when it takes over, in the walk as planned
  double give = 0.0;    ///< how far the DCM may miss: the ZMP over the next foot makes up for that much
};

/// What the choice of a landing time has to respect.
struct StepLimits {
  double planned = 0.0;    ///< time until the foot lands as planned, from now; negative where that is over [s]
  double current = 0.0;    ///< time until the foot lands as decided so far, from now [s]
  double least = 0.0;      ///< earliest landing that the leg can make, from now [s]
  double most = 0.0;       ///< latest landing that may be waited for, from now [s]
  double take_over = 0.0;  ///< from the landing until the foot carries the ZMP [s]
};

/// What a landing time is judged by; see `StepAdjustment::cost`.
struct StepWeights {
  double place = 0.04;  ///< of a foothold that is moved [m^2/m^2]
  double time = 0.01;   ///< of a landing time that is moved [m^2/s^2]
  double band = 1e-4;   ///< another landing time is taken only where it costs this much less [m^2]
};

/// Chooses when the swing foot lands, from the DCM, so that the DCM can be held over the foot that has landed.
///
/// Under a ZMP r the DCM goes to xi_end = r + (xi - r) exp(s / T_c) until the landed foot takes over, s from now. For r within its bounds that is
/// an interval; footholds within reach plus the planned offset are another. Where the two do not meet, their gap, less what the next foot gives, is
/// what the DCM will miss. The best time has the least  gap_x^2 + gap_y^2 + w_place moved^2 + w_time (t - planned)^2.  In a walk that nothing disturbs that
/// is zero at the planned time, which then stays.
class StepAdjustment {
 public:
  explicit StepAdjustment(const StepWeights& weights = {}) : weights_(weights) {}

  /// Cost of landing `time` [s] > 0 from now [m^2].
  double cost(const LinearInvertedPendulum& pendulum, const std::array<StepAxis, 2>& axes, const StepLimits& limits,
              double time) const;
  /// The time until the landing that is best, from now [s]. Allocates nothing.
  double time(const LinearInvertedPendulum& pendulum, const std::array<StepAxis, 2>& axes,
              const StepLimits& limits) const;

 private:
  StepWeights weights_;
};

}  // namespace zmpwalk
