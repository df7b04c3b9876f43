#include "zmpwalk/gait/point_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "zmpwalk/math/rotation.hpp"

namespace zmpwalk {
namespace {

TrackingSettings smooth(TrackingSettings settings) {
  settings.law = chosen<TrackerLawName>("tracking.law", "smooth");
  return settings;
}

}  // namespace

PendulumState roll_out(const LinearInvertedPendulum& pendulum, const VelocityProfile& plan,
                       const VelocityProfile::Moment& now, const VelocityProfile::Moment& then, double time,
                       const PendulumState& state, const ForwardStance& stance) {
  // The pendulum of (16) in pieces, by the DCM and its mirror image x - T_c v: each leaves, or nears, the ZMP exponentially.
  constexpr int kPieces = 16;
  const double Tc = pendulum.Tc(), dt = time / kPieces, grow = std::exp(dt / Tc);
  const double share =
      -std::expm1(-dt / stance.tracker_time) / dt;  // mean rate in a piece at which an error of the speed goes [1/s]
  double xi = state.x + Tc * state.v, mirror = state.x - Tc * state.v;
  const bool smooth = now.segment == then.segment;
  const double v_now = now.v.x(), slope = smooth ? (then.v.x() - v_now) / time : 0.0;
  VelocityProfile::Moment reached = now;
  for (int k = 0; k < kPieces; ++k) {
    // The ZMP that is asked for in the middle of the piece stays for all of it.
    const double v = (xi - mirror) / (2.0 * Tc), x = 0.5 * (xi + mirror + dt * v),
                 from_middle = x - stance.orbit_middle;
    const double since = (k + 0.5) * dt;
    const double faster = smooth ? slope * since : plan.forward_from(reached, now.t + since) - v_now;
    const double beside = faster + stance.catch_up + stance.dv_capture;
    const double a = stance.orbit.acceleration(from_middle) + share * (stance.orbit.velocity(from_middle) + beside - v);
    const double r = std::clamp(pendulum.reference_for(x, a), stance.lower, stance.upper);
    xi = r + (xi - r) * grow;
    mirror = r + (mirror - r) / grow;
  }
  return {0.5 * (xi + mirror), (xi - mirror) / (2.0 * Tc)};
}

double start_excursion(const WalkSettings& settings, const VelocityProfile& plan,
                       const LinearInvertedPendulum& pendulum, const ZmpBounds& bounds, double x_0, double scale) {
  const double dt = settings.control.dt, period = settings.gait.T_ds + settings.gait.T_ss;
  const double t_end = settings.gait.T_ds_first + period, t_switch = t_end - 0.5 * settings.gait.T_ds;
  const double foothold =
      scale * (plan.displacement(0.0, t_switch) + 0.5 * plan.displacement(t_switch, t_switch + period)).x();
  TrackingSettings free = settings.tracking;
  free.catch_up_speed = std::numeric_limits<double>::infinity();
  VelocityTracker tracker(smooth(free));
  PendulumState s{x_0, 0.0};
  for (double t = 0.0; t < t_end; t += dt) {
    const double v_plan = scale * plan.velocity(t).x(), foot = t < t_switch ? 0.0 : foothold;
    const double wanted = pendulum.reference_for(s.x, tracker.acceleration(v_plan, s.v));
    s = pendulum.step(dt, s, std::clamp(wanted, foot + bounds.lower.x(), foot + bounds.upper.x()));
    tracker.advance(s.v, v_plan, dt);
  }
  return s.x - x_0;
}

PointWalk::PointWalk(const WalkSettings& settings, const VelocityProfile& profile,
                     const LinearInvertedPendulum& of_robot, const std::array<ZmpBounds, 2>& bounds,
                     const SoleSize& sole, const GaitInput& start)
    : pendulum(of_robot),
      dt(settings.control.dt),
      tracker(smooth(settings.tracking)),
      gait(settings, profile, sole, bounds),
      in(start) {
  gait.reset(in, pendulum);
}

const GaitOutput& PointWalk::step(Feet feet) {
  in.catch_up = tracker.catch_up(gait.output().orbit_ahead);
  const GaitOutput& now = feet == Feet::kSwing ? gait.update(in) : gait.update_steps(in);
  const Mat2 R_S = axes_of(now.ahead_S);
  const Vec2 wanted = reference_zmp(now, pendulum, tracker, in.com, in.dcom);
  zmp = now.origin + R_S * now.room.clamp(R_S.transpose() * (wanted - now.origin));
  const LinearInvertedPendulum::Over& in_dt = over(pendulum, dt);
  for (int i = 0; i < 2; ++i) {
    const PendulumState s = pendulum.step(in_dt, {in.com[i], in.dcom[i]}, zmp[i]);
    in.com[i] = s.x;
    in.dcom[i] = s.v;
  }
  if (now.at_rest)
    tracker.reset();
  else
    tracker.advance(in.dcom.dot(now.ahead), now.v_plan.x(), dt);
  in.t += dt;
  if (now.phase.phase == Phase::kSingleSupport) {
    if (feet == Feet::kSwing) {
      in.p_sole[now.swing] = now.swing_target.p;
      in.R_sole[now.swing] = now.swing_target.R;
    } else {
      in.p_sole[now.swing].head<2>() = now.foothold.p;
      in.R_sole[now.swing] = rotation_z(now.foothold.yaw);
    }
  }
  return now;
}

}  // namespace zmpwalk
