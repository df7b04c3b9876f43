#include "zmpwalk/gait/plan.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/math/rotation.hpp"

namespace zmpwalk {

WalkPlan plan_walk(const WalkSettings& given, const VelocityProfile& profile, const LinearInvertedPendulum& pendulum,
                   const std::array<ZmpBounds, 2>& bounds, double half_sole_width, const GaitInput& start,
                   double duration) {
  require_positive("duration", duration);
  const double dt = given.control_dt;
  const auto count = static_cast<std::size_t>(std::ceil(duration / dt - 1e-9));
  WalkPlan plan;
  plan.t.reserve(count);
  plan.com.reserve(count);
  plan.dcom.reserve(count);
  plan.zmp.reserve(count);
  plan.support.reserve(count);
  WalkSettings settings = given;
  settings.lateral_feedback = true;
  GaitGenerator gait(settings, profile, half_sole_width);
  VelocityTracker tracker(TrackerLaw::kSmooth, settings.tracker_gain, settings.tracker_time, settings.tracker_deadband);
  GaitInput in = start;
  gait.reset(in, pendulum);
  bool swinging = false;
  for (std::size_t k = 0; k < count; ++k) {
    in.t = static_cast<double>(k) * dt;
    const GaitOutput& now = gait.update_steps(in);
    const bool single = now.phase.phase == Phase::kSingleSupport;
    if (single && !swinging) plan.steps.push_back({now.swing, in.t, in.t + now.phase.duration, {}});
    if (single) {  // the foot is where it will land; nobody looks before
      plan.steps.back().place = now.foothold;
      in.p_sole[now.swing].head<2>() = now.foothold.p;
      in.R_sole[now.swing] = rotation_z(now.foothold.yaw);
    }
    swinging = single;

    const Mat2 R = rotation_z(now.heading).topLeftCorner<2, 2>();
    const Vec2 x = R.transpose() * (in.com - now.origin), v = R.transpose() * in.dcom;
    const double v_plan = profile.velocity(in.t).x();
    ZmpBounds room = bounds[now.support];
    if (!single) {
      const Side there = other(now.support);
      const double across = (R.transpose() * (in.p_sole[there].head<2>() - now.origin)).y();
      room = room.widened(bounds[there], across);
    }
    const double sagittal_zmp = pendulum.reference_for(x.x(), tracker.acceleration(v_plan, v.x()));
    const Vec2 zmp = room.clamp(Vec2(sagittal_zmp, now.zmp_lateral));

    plan.t.push_back(in.t);
    plan.com.push_back(in.com);
    plan.dcom.push_back(in.dcom);
    plan.zmp.push_back(now.origin + R * zmp);
    plan.support.push_back(static_cast<int>(side_sign(now.support)));
    const PendulumState sagittal = pendulum.step(dt, {x.x(), v.x()}, zmp.x()),
                        lateral = pendulum.step(dt, {x.y(), v.y()}, zmp.y());
    tracker.advance(sagittal.v, v_plan, dt);
    in.com = now.origin + R * Vec2(sagittal.x, lateral.x);
    in.dcom = R * Vec2(sagittal.v, lateral.v);
  }
  if (!plan.steps.empty() && plan.steps.back().touch_down > duration) plan.steps.pop_back();
  return plan;
}

}  // namespace zmpwalk
