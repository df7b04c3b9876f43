#include "zmpwalk/gait/plan.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/math/rotation.hpp"

namespace zmpwalk {

WalkPlan plan_walk(const WalkSettings& given, const VelocityProfile& profile, const LinearInvertedPendulum& pendulum,
                   const std::array<ZmpBounds, 2>& bounds, const SoleSize& sole, const GaitInput& start,
                   double duration) {
  require_positive("duration", duration);
  const double dt = given.control.dt;
  const auto count = static_cast<std::size_t>(std::ceil(duration / dt - 1e-9));
  WalkPlan plan;
  plan.t.reserve(count);
  plan.com.reserve(count);
  plan.dcom.reserve(count);
  plan.zmp.reserve(count);
  plan.support.reserve(count);
  WalkSettings settings = given;
  settings.zmp.lateral_feedback = true;
  GaitGenerator gait(settings, profile, sole, bounds);
  VelocityTracker tracker(TrackerLaw::kSmooth, settings.tracking.gain, settings.tracking.time,
                          settings.tracking.deadband, settings.tracking.catch_up_speed);
  GaitInput in = start;
  gait.reset(in, pendulum);
  bool swinging = false;
  for (std::size_t k = 0; k < count; ++k) {
    in.t = static_cast<double>(k) * dt;
    in.catch_up = tracker.catch_up(gait.output().orbit_ahead);
    const GaitOutput& now = gait.update_steps(in);
    const bool single = now.phase.phase == Phase::kSingleSupport;
    if (single && !swinging) plan.steps.push_back({now.swing, in.t, in.t + now.phase.duration, {}});
    if (single) {  // the foot is where it will land; nobody looks before
      plan.steps.back().place = now.foothold;
      in.p_sole[now.swing].head<2>() = now.foothold.p;
      in.R_sole[now.swing] = rotation_z(now.foothold.yaw);
    }
    swinging = single;

    const Mat2 R = rotation_z(now.yaw).topLeftCorner<2, 2>();
    const Vec2 wanted = reference_zmp(now, pendulum, tracker, in.com, in.dcom);
    const Vec2 zmp = now.origin + R * now.room.clamp(R.transpose() * (wanted - now.origin));

    plan.t.push_back(in.t);
    plan.com.push_back(in.com);
    plan.dcom.push_back(in.dcom);
    plan.zmp.push_back(zmp);
    plan.support.push_back(static_cast<int>(side_sign(now.support)));
    const PendulumState x = pendulum.step(dt, {in.com.x(), in.dcom.x()}, zmp.x()),
                        y = pendulum.step(dt, {in.com.y(), in.dcom.y()}, zmp.y());
    in.com << x.x, y.x;
    in.dcom << x.v, y.v;
    if (now.at_rest)
      tracker.reset();
    else
      tracker.advance(in.dcom.dot(ahead_of(now.heading)), now.v_plan.x(), dt);
  }
  if (!plan.steps.empty() && plan.steps.back().touch_down > duration) plan.steps.pop_back();
  return plan;
}

}  // namespace zmpwalk
