#include "zmpwalk/gait/gait_generator.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "zmpwalk/math/rotation.hpp"

namespace zmpwalk {
namespace {

Foothold foothold_of(const Vec3& p, const Mat3& R) { return {p.head<2>(), yaw_of(R)}; }

}  // namespace

GaitGenerator::GaitGenerator(const WalkSettings& settings, const VelocityProfile& profile, double half_sole_width)
    : settings_(settings),
      schedule_(settings.T_ds_first, settings.T_ds, settings.T_ss),
      footsteps_(settings, profile),
      lateral_(settings.lateral_feedback, settings.lateral_reach * half_sole_width),
      pendulum_(1.0, 1.0) {}

void GaitGenerator::reset(const GaitInput& start, const LinearInvertedPendulum& pendulum) {
  pendulum_ = pendulum;
  out_ = GaitOutput{};
  out_.swing = settings_.first_swing == "left" ? kLeft : kRight;
  out_.support = out_.swing;
  const Foothold left = foothold_of(start.p_sole[kLeft], start.R_sole[kLeft]);
  const Foothold right = foothold_of(start.p_sole[kRight], start.R_sole[kRight]);
  out_.heading = left.yaw + 0.5 * wrap_angle(right.yaw - left.yaw);
  lateral_.reset(out_.support);
  footsteps_.reset({left, right}, out_.heading);
}

const GaitOutput& GaitGenerator::update(const GaitInput& in) {
  update_steps(in);
  if (out_.phase.phase == Phase::kDoubleSupport) return out_;
  if (changed_) {
    const double z_land = std::isnan(in.ground) ? in.p_sole[other(out_.swing)].z() : in.ground;
    swing_foot_.begin(in.p_sole[out_.swing], in.R_sole[out_.swing], out_.phase.duration, z_land, settings_.step_height);
  }
  out_.swing_target = swing_foot_.update(out_.phase.time, settings_.control_dt, out_.foothold);
  return out_;
}

const GaitOutput& GaitGenerator::update_steps(const GaitInput& in) {
  const GaitPhase before = out_.phase;
  out_.phase = schedule_.at(in.t);
  const bool single = out_.phase.phase == Phase::kSingleSupport;
  changed_ = out_.phase.phase != before.phase || out_.phase.step != before.step;
  const double t_mid = in.t + out_.phase.to_mid_double;
  const double dt = settings_.control_dt;

  if (changed_ && !single) out_.swing = other(out_.swing);  // the foot that stood swings next
  lateral_.begin_cycle(changed_ && !single);
  out_.support = lateral_.support();
  out_.standing = {true, true};
  out_.origin = in.p_sole[out_.support].head<2>();
  out_.foothold = {Vec2::Constant(kNaN), kNaN};
  out_.w_T = kNaN;

  if (single) {
    const Side stance = other(out_.swing);
    out_.standing[out_.swing] = false;
    if (changed_)
      footsteps_.begin_step(out_.phase.step, out_.swing, foothold_of(in.p_sole[stance], in.R_sole[stance]), t_mid,
                            schedule_.period());
    out_.foothold = footsteps_.update(in.com, in.dcom, in.t, t_mid, schedule_.period(), pendulum_.Tc(),
                                      out_.phase.time / out_.phase.duration, dt);
  }

  // Lateral motion about the support's sole centre, along the left of the heading.
  const Vec2 left(-std::sin(out_.heading), std::cos(out_.heading));
  const PendulumState y{(in.com - out_.origin).dot(left), in.dcom.dot(left)};
  const Side to = other(out_.support);
  const Vec2 there = single ? out_.foothold.p : Vec2(in.p_sole[to].head<2>());
  out_.zmp_lateral = lateral_.reference(pendulum_, y, std::abs((there - out_.origin).dot(left)),
                                        out_.phase.to_mid_double, schedule_.period());
  if (!single && lateral_.awaits_switch()) {
    const bool last = out_.phase.time + 1.5 * dt >= out_.phase.duration;
    const double across = (in.p_sole[to].head<2>() - out_.origin).dot(left);
    out_.w_T = lateral_.check_switch(pendulum_, y, out_.zmp_lateral, across, out_.phase.to_mid_single, dt, last);
  }
  return out_;
}

}  // namespace zmpwalk
