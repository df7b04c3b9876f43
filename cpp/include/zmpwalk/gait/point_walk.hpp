#pragma once

#include "zmpwalk/gait/gait_generator.hpp"
#include "zmpwalk/gait/velocity_tracker.hpp"

namespace zmpwalk {

/// What moves the COM along the heading while one foot carries the ZMP. Lengths are along H's x, from that foot's centre.
struct ForwardStance {
  ForwardOrbit orbit;
  double orbit_middle = 0.0;        ///< where the orbit has its middle [m]
  double tracker_time = 0.0;        ///< in which the smooth tracker removes a speed error [s]
  double catch_up = 0.0;            ///< speed beside the orbit's that the tracker asks for [m/s]
  double dv_capture = 0.0;          ///< and the capture, so that the next step catches the DCM [m/s]
  double lower = 0.0, upper = 0.0;  ///< where the ZMP may be: the foot's bounds along S's x, taken along H's [m]
};

/// The pendulum (16) under the smooth tracker, its ZMP inside the bounds: where `state` leads to in `time` [s] > 0.
/// @param now, then  moments of `plan`, `time` apart
PendulumState roll_out(const LinearInvertedPendulum& pendulum, const VelocityProfile& plan,
                       const VelocityProfile::Moment& now, const VelocityProfile::Moment& then, double time,
                       const PendulumState& state, const ForwardStance& stance);

/// How far the same pendulum moves ahead from a stand until the second foot lifts, where `plan` is walked `scale` times as fast [m].
///
/// Nothing turns here, and the tracker follows the plan without an orbit.
/// @param bounds of the ZMP in the sole   @param x_0 COM ahead of the feet's middle at the start [m]
double start_excursion(const WalkSettings& settings, const VelocityProfile& plan,
                       const LinearInvertedPendulum& pendulum, const ZmpBounds& bounds, double x_0, double scale);

/// A point mass on the pendulum (16), (17), walked by the gait and the smooth tracker: a robot that does exactly as it is told.
struct PointWalk {
  /// What the foot of a single support does.
  enum class Feet {
    kSwing,  ///< it follows its swing target
    kAtOnce  ///< it is where it will land as soon as it lifts; the swing target is not computed
  };

  /// @param settings resolved   @param bounds of each sole, in its axes   @param start two standing feet
  PointWalk(const WalkSettings& settings, const VelocityProfile& profile, const LinearInvertedPendulum& pendulum,
            const std::array<ZmpBounds, 2>& bounds, const SoleSize& sole, const GaitInput& start);

  /// One cycle: the gait decides for the state `in`, which then moves on by `dt`. Allocates nothing.
  const GaitOutput& step(Feet feet = Feet::kSwing);

  LinearInvertedPendulum pendulum;
  double dt;  ///< [s]
  LastOver over;
  VelocityTracker tracker;
  GaitGenerator gait;
  GaitInput in;             ///< the state
  Vec2 zmp = Vec2::Zero();  ///< of the last step, W [m]
};

}  // namespace zmpwalk
