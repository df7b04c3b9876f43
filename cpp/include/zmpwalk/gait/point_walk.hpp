#pragma once

#include "zmpwalk/gait/gait_generator.hpp"
#include "zmpwalk/gait/velocity_tracker.hpp"

namespace zmpwalk {

/// What moves the COM along the heading while one foot carries the ZMP. Lengths are along the x axis of H (the heading frame), from that foot's centre.
struct ForwardStance {
  ForwardOrbit orbit;
  double orbit_middle = 0.0;  ///< middle of the orbit [m]
  double tracker_time = 0.0;  ///< time in which the smooth tracker removes an error of the speed [s]
  double catch_up = 0.0;      ///< speed that the tracker adds to the orbit's to make up lost way [m/s]
  double dv_capture =
      0.0;  ///< speed that is added so that the next step catches the DCM (COM + T_c times its velocity) [m/s]
  double lower = 0.0, upper = 0.0;  ///< where the ZMP may be: the foot's bounds along S's x, taken along H's [m]
};

/// Where the pendulum (16) is `time` [s] > 0 after `state`, when the smooth tracker moves it and its ZMP stays inside the bounds.
/// @param now, then  the plan at both ends of that time
PendulumState roll_out(const LinearInvertedPendulum& pendulum, const VelocityProfile& plan,
                       const VelocityProfile::Moment& now, const VelocityProfile::Moment& then, double time,
                       const PendulumState& state, const ForwardStance& stance);

/// How far the pendulum moves ahead from a stand until the second foot lifts, if the robot walks `scale` times as fast as `plan` [m].
///
/// The path is taken as straight, and the tracker follows the plan without an orbit.
/// @param bounds of the ZMP in the sole   @param x_0 COM ahead of the feet's middle at the start [m]
double start_excursion(const WalkSettings& settings, const VelocityProfile& plan,
                       const LinearInvertedPendulum& pendulum, const ZmpBounds& bounds, double x_0, double scale);

/// A walk of a point mass on the pendulum (16), (17), which gait and smooth tracker move like a robot that follows them exactly.
struct PointWalk {
  /// What the swing foot does.
  enum class Feet {
    kSwing,  ///< it follows its path through the air
    kAtOnce  ///< as soon as it lifts, it is where it will land; its path is not computed
  };

  /// @param settings resolved   @param bounds of each sole, in its axes   @param start two standing feet
  PointWalk(const WalkSettings& settings, const VelocityProfile& profile, const LinearInvertedPendulum& pendulum,
            const std::array<ZmpBounds, 2>& bounds, const SoleSize& sole, const GaitInput& start);

  /// Goes on by one cycle: the gait decides for the state `in`, and then that state moves on by `dt`. Allocates nothing.
  const GaitOutput& step(Feet feet = Feet::kSwing);

  LinearInvertedPendulum pendulum;
  double dt;  ///< [s]
  LastOver over;
  VelocityTracker tracker;
  GaitGenerator gait;
  GaitInput in;             ///< state of the point mass and of its feet
  Vec2 zmp = Vec2::Zero();  ///< ZMP of the last cycle, W [m]
};

}  // namespace zmpwalk
