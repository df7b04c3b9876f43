#include "zmpwalk/walk/com_reference.hpp"

#include "zmpwalk/zmp/reference_iteration.hpp"

namespace zmpwalk {

ComReference::ComReference(const WalkSettings& settings)
    : modifies_(settings.zmp.modification),
      estimates_(settings.zmp.iteration != Iteration::kNone),
      bounds_lateral_(settings.zmp.bound_lateral),
      feed_forward_(settings.com.feed_forward),
      iteration_(settings.zmp.iteration),
      dt_(settings.control.dt),
      threshold_(settings.zmp.threshold),
      max_iterations_(settings.zmp.max_iterations),
      kp_(settings.com.kp_x, settings.com.kp_y),
      kd_(settings.com.kd_x, settings.com.kd_y) {}

void ComReference::set_pendulum(const LinearInvertedPendulum& pendulum) {
  over_dt_ = pendulum.over(dt_);
  const PendulumState per_r = pendulum.step(over_dt_, {0.0, 0.0}, 1.0);  // (16) is linear
  for (int i = 0; i < 2; ++i)
    df_dr_[i] =
        (feed_forward_ ? pendulum.acceleration(0.0, 1.0) : 0.0) + pd_acceleration(kp_[i], kd_[i], per_r.x, per_r.v);
}

ComReference::Desired ComReference::under(const Vec2& r, const Cycle& cycle) const {
  Desired c;
  for (int i = 0; i < 2; ++i) {
    const PendulumState next = cycle.pendulum->step(over_dt_, {cycle.com_S[i], cycle.dcom_S[i]}, r[i]);
    c.x_d[i] = next.x;
    c.v_d[i] = next.v;
    c.f[i] = (feed_forward_ ? cycle.pendulum->acceleration(cycle.com_S[i], r[i]) : 0.0) +
             pd_acceleration(kp_[i], kd_[i], next.x - cycle.com_meas_S[i], next.v - cycle.dcom_meas_S[i]);
  }
  return c;
}

double ComReference::track_plan(const Cycle& cycle, Desired& c) const {
  const double v_plan = (cycle.R_WS.transpose() * cycle.R_WH * cycle.gait->v_plan.head<2>()).x();
  c.x_d.x() = cycle.com_S.x() + v_plan * dt_;
  c.v_d.x() = v_plan;
  c.f.x() = pd_acceleration(kp_.x(), kd_.x(), c.x_d.x() - cycle.com_meas_S.x(), c.v_d.x() - cycle.dcom_meas_S.x());
  return cycle.pendulum->reference_for(cycle.com_S.x(), c.f.x());
}

Vec2 ComReference::want(const Vec2& zmp, const ZmpBounds& room, Drive drive) const {
  Vec2 wanted = zmp;
  if (!modifies_) return wanted;
  const Vec2 inside = room.clamp(zmp);
  wanted.x() = inside.x();
  if (bounds_lateral_) wanted.y() = inside.y();
  if (drive == Drive::kLower) wanted.x() = room.lower.x();
  if (drive == Drive::kUpper) wanted.x() = room.upper.x();
  return wanted;
}

Reference ComReference::decide(const Cycle& cycle, const VelocityTracker& tracker,
                               const WholeBodyController& whole_body) const {
  const GaitOutput& gait = *cycle.gait;
  const Mat2& R_WS = cycle.R_WS;
  const auto estimate_of = [&](const Vec2& f) { return cycle.to_S(whole_body.zmp(R_WS * f)); };

  // What velocity tracking alone asks for.
  const bool by_pendulum = !tracker.law().follows_plan && modifies_;
  const Vec2 com = cycle.to_W(cycle.com_S), dcom = R_WS * cycle.dcom_S;
  Vec2 r = cycle.to_S(reference_zmp(gait, *cycle.pendulum, tracker, com, dcom) + cycle.steadying);
  Desired c = under(r, cycle);
  if (!by_pendulum &&
      !gait.at_rest) {  // the desired velocity is the planned one, which stands: nothing to feed forward
    const double r_plan = track_plan(cycle, c);
    r.x() = estimates_ ? 0.0 : r_plan;
  }
  // Without III-B nobody asks the whole body: the ZMP is where the pendulum has it.
  Vec2 zmp = estimates_ ? estimate_of(c.f) : r;
  const Vec2 wanted = want(zmp, gait.room, tracker.drive());

  Reference out;
  Vec2 axes = Vec2::Zero();
  for (int i = 0; i < 2; ++i)
    if (wanted[i] != zmp[i]) {
      axes[i] = 1.0;
      out.modified[i] = wanted[i] == gait.room.lower[i] ? -1.0 : 1.0;
    }
  const Vec2 rest = Vec2::Ones() - axes;
  const auto per_reference = [&](const Mat2& per_f) {
    return Mat2(R_WS.transpose() * per_f * R_WS * df_dr_.asDiagonal());
  };
  out.zmp_slope = per_reference(whole_body.zmp_slope()).diagonal();
  out.zmp_ref = r;
  if (!by_pendulum && axes.x() == 0.0) out.zmp_ref.x() = zmp.x();  // tracking: no pendulum along x
  if (axes.any()) {
    // III-B on the axes that are to change; an axis that is left alone keeps its command.
    const Vec2 kept = c.f;
    const auto command = [&](const Vec2& r_ref) {
      return Vec2(axes.cwiseProduct(under(r_ref, cycle).f) + rest.cwiseProduct(kept));
    };
    const auto estimate = [&](const Vec2& r_ref) { return estimate_of(command(r_ref)); };
    const Vec2 start = axes.cwiseProduct(wanted) + rest.cwiseProduct(r), f_start = command(start);
    const Vec2 first = estimate_of(f_start);
    ReferenceResult found{start, first, 1, false};
    if (estimates_ && iteration_ == Iteration::kLoop)
      found = iterate_reference(estimate, wanted, r, axes, threshold_, max_iterations_);
    else if (estimates_)
      found = solve_reference(estimate, wanted, r, axes,
                              per_reference(whole_body.zmp_slope(cycle.to_W(wanted), R_WS * f_start)), threshold_);
    const Desired modified = under(found.zmp_ref, cycle);
    for (int i = 0; i < 2; ++i) {
      if (axes[i] == 0.0) continue;
      c.x_d[i] = modified.x_d[i];
      c.v_d[i] = modified.v_d[i];
      c.f[i] = modified.f[i];
      out.zmp_ref[i] = found.zmp_ref[i];
    }
    out.zmp_first = first;
    zmp = found.zmp_est;
    out.iterations = found.passes;
  }
  out.x_d = c.x_d;
  out.v_d = c.v_d;
  out.f = c.f;
  out.zmp_des = axes.cwiseProduct(wanted) + rest.cwiseProduct(estimates_ ? zmp : r);
  out.zmp_est = estimates_ ? zmp : estimate_of(c.f);
  return out;
}

}  // namespace zmpwalk
