#include "zmpwalk/gait/gait_generator.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "zmpwalk/math/rotation.hpp"

namespace zmpwalk {
namespace {

Foothold foothold_of(const Vec3& p, const Mat3& R) { return {p.head<2>(), yaw_of(R)}; }

std::array<Foothold, 2> feet_of(const GaitInput& in) {
  return {foothold_of(in.p_sole[kLeft], in.R_sole[kLeft]), foothold_of(in.p_sole[kRight], in.R_sole[kRight])};
}

Side first_swing(const WalkSettings& settings) { return settings.gait.first_swing; }

}  // namespace

Vec2 reference_zmp(const GaitOutput& gait, const LinearInvertedPendulum& pendulum, const VelocityTracker& tracker,
                   const Vec2& com, const Vec2& dcom) {
  if (gait.at_rest) return gait.zmp_rest;
  const Vec2 ahead = ahead_of(gait.heading);
  const double x = (com - gait.origin).dot(ahead), from_middle = x - gait.orbit_middle;
  const double a =
      gait.orbit.acceleration(from_middle) +
      tracker.acceleration(gait.orbit.velocity(from_middle) + gait.dv_capture, dcom.dot(ahead), gait.orbit_ahead);
  const double r = pendulum.reference_for(x, a);
  // What is beyond the bounds must not lean sideways where the sole points elsewhere than the walk.
  const double inside = std::clamp(r, gait.room.lower.x(), gait.room.upper.x());
  return gait.origin + inside * ahead + (r - inside) * ahead_of(gait.yaw) + gait.zmp_lateral * left_of(gait.heading);
}

GaitGenerator::GaitGenerator(const WalkSettings& settings, const VelocityProfile& profile, const SoleSize& sole,
                             const std::array<ZmpBounds, 2>& bounds)
    : settings_(settings),
      cadence_{{settings.gait.T_ds, settings.gait.T_ss},
               settings.gait.cadence_speed,
               settings.gait.cadence_exponent,
               settings.gait.cadence_double,
               {1.0, settings.gait.cadence_sideways, settings.gait.cadence_turning}},
      limits_{
          {settings.rate.forward_jump, settings.rate.sideways_jump, settings.rate.turning_jump},
          {settings.rate.forward_acceleration, settings.rate.sideways_acceleration, settings.rate.turning_acceleration},
          {settings.rate.forward_deceleration, settings.rate.sideways_acceleration,
           settings.rate.turning_acceleration}},
      profile_(settings.rate.limit ? profile.limited(limits_) : profile),
      plan_(profile_),
      schedule_(settings.gait.T_ds_first, settings.gait.T_ds, settings.gait.T_ss),
      footsteps_(settings, plan_, sole),
      lateral_(settings.zmp.lateral_feedback, settings.zmp.lateral_shift * 0.5 * sole.width),
      pendulum_(1.0, 1.0),
      bounds_(bounds) {
  plan_.reserve();
}

void GaitGenerator::reset(const GaitInput& start, const LinearInvertedPendulum& pendulum) {
  pendulum_ = pendulum;
  plan_ = profile_;
  plan_.reserve();
  allowance_ = limits_.jump;
  commanded_ = false;
  t_command_ = 0.0;
  closing_ = false;
  out_ = GaitOutput{};
  const std::array<Foothold, 2> feet = feet_of(start);
  out_.heading = feet[kLeft].yaw + 0.5 * wrap_angle(feet[kRight].yaw - feet[kLeft].yaw);
  footsteps_.reset(feet, out_.heading);
  out_.swing = out_.support = first_swing(settings_);
  lateral_.reset(out_.support);
  schedule_.begin(0, 0.0, settings_.gait.T_ds_first, cadence_.slow);
  out_.at_rest = true;  // until the first cycle finds that the plan moves
  out_.origin = start.p_sole[out_.support].head<2>();
  out_.yaw = yaw_of(start.R_sole[out_.support]);
  out_.room = room(start);
}

void GaitGenerator::command(const Vec3& velocity) {
  command_ = velocity;
  commanded_ = true;
}

void GaitGenerator::take_command(double t) {
  if (!commanded_) return;
  commanded_ = false;
  const Vec3 spent = (plan_.velocity(t) - plan_.velocity(t_command_)).cwiseAbs();
  allowance_ += ((t - t_command_) * limits_.acceleration - spent).cwiseMax(0.0);
  allowance_ = allowance_.cwiseMin(limits_.jump);
  const Vec3 before = plan_.velocity(t);
  plan_.steer(t, command_, limits_, allowance_);
  allowance_ = (allowance_ - (plan_.velocity(t) - before).cwiseAbs()).cwiseMax(0.0);
  t_command_ = t;
}

StepTimes GaitGenerator::times_at(double t) const {
  const double T = cadence_.slow.period();
  return cadence_.times(plan_.displacement(t, t + T) / T);
}

void GaitGenerator::begin_walk(const GaitInput& in) {
  const StepTimes times = times_at(in.t);
  out_.at_rest = false;
  out_.swing = first_swing(settings_);
  const double v_y = plan_.displacement(in.t, in.t + times.period()).y();
  if (v_y != 0.0) out_.swing = v_y > 0.0 ? kLeft : kRight;  // the foot on that side opens the way
  lateral_.reset(out_.swing);
  footsteps_.restart(feet_of(in));
  const bool slow = times.period() == cadence_.slow.period();
  const double T_ds = slow ? settings_.gait.T_ds_first : pendulum_.first_double_support(times.period(), times.T_ss);
  schedule_.begin(out_.phase.step, in.t, T_ds, times);
}

bool GaitGenerator::can_stand(const GaitInput& in) const {
  if (!out_.standing[kLeft] || !out_.standing[kRight]) return true;
  const double xi = (in.com + pendulum_.Tc() * in.dcom - out_.origin).dot(ahead_of(out_.yaw));
  return out_.room.lower.x() <= xi && xi <= out_.room.upper.x();
}

bool GaitGenerator::begin_phase(const GaitInput& in) {
  bool began = false;
  if (out_.at_rest) {
    // The first step lifts when the plan moves, and half of its double support has gone by.
    if (settings_.gait.stand && plan_.at_rest(in.t, in.t + 0.5 * settings_.gait.T_ds_first) && can_stand(in))
      return false;
    begin_walk(in);
    began = true;
  } else if (schedule_.landed(in.t)) {
    out_.swing = other(out_.swing);  // the foot that stood swings next
    began = true;
    if (closing_) {
      out_.at_rest = true;
      ++out_.phase.step;
      closing_ = false;
      return true;
    }
    schedule_.next(times_at(in.t));
    lateral_.begin_cycle(true);
    return true;
  }
  lateral_.begin_cycle(false);
  return began;
}

const GaitOutput& GaitGenerator::update(const GaitInput& in) {
  update_steps(in);
  if (out_.phase.phase == Phase::kDoubleSupport) return out_;
  if (lifted_) {
    const double z_land = std::isnan(in.ground) ? in.p_sole[other(out_.swing)].z() : in.ground;
    swing_foot_.begin(in.p_sole[out_.swing], in.R_sole[out_.swing], out_.phase.duration, z_land,
                      settings_.swing.height);
  }
  out_.swing_target = swing_foot_.update(out_.phase.time, settings_.control.dt, out_.foothold);
  return out_;
}

const GaitOutput& GaitGenerator::update_steps(const GaitInput& in) {
  footsteps_.advance(in.t, in.com);
  take_command(in.t);
  const bool began = begin_phase(in);
  out_.heading = footsteps_.heading();
  out_.v_plan = plan_.velocity(in.t);
  out_.standing = {true, true};
  out_.foothold = {Vec2::Constant(kNaN), kNaN};
  out_.w_T = kNaN;
  out_.zmp_lateral = 0.0;
  lifted_ = false;
  out_.stretch = 0.0;
  if (out_.at_rest) {
    const double since = began ? 0.0 : out_.phase.time + settings_.control.dt;
    out_.phase = {Phase::kDoubleSupport, out_.phase.step, since, since, kNaN, kNaN};
  } else {
    const bool was_single = out_.phase.phase == Phase::kSingleSupport && !began;
    out_.phase = schedule_.at(in.t);
    const bool single = out_.phase.phase == Phase::kSingleSupport;
    lifted_ = single && !was_single;
    if (began || lifted_) {
      const double t_mid = in.t + out_.phase.to_mid_double;
      period_ = times_at(t_mid).period();
    }
    out_.support = lateral_.support();
    out_.standing[out_.swing] = !single;
  }
  out_.origin = in.p_sole[out_.support].head<2>();
  out_.yaw = yaw_of(in.R_sole[out_.support]);
  out_.room = room(in);
  if (out_.at_rest) {
    // The ZMP leads the DCM back to the middle between the feet.
    const Vec2 middle = 0.5 * (in.p_sole[kLeft] + in.p_sole[kRight]).head<2>();
    const Vec2 xi = in.com + pendulum_.Tc() * in.dcom;
    out_.zmp_rest = xi + settings_.gait.stand_gain * (xi - middle);
    out_.orbit_ahead = out_.dv_capture = 0.0;
  } else {
    move_ahead(in);
    move_sideways(in);
    out_.stretch = stretch(in);
  }
  return out_;
}

ZmpBounds GaitGenerator::sole_room(const Vec3& velocity) const {
  ZmpBounds out = bounds_[out_.support];
  const double share = std::pow(cadence_.pace(velocity), settings_.zmp.sole_exponent);
  out.lower.x() *= share;
  out.upper.x() *= share;
  return out;
}

void GaitGenerator::move_ahead(const GaitInput& in) {
  const double period = schedule_.times().period(), half = 0.5 * period;
  const bool before_switch = out_.phase.phase == Phase::kDoubleSupport && lateral_.awaits_switch();
  const double since_middle =
      before_switch ? half - 0.5 * out_.phase.duration + out_.phase.time : -out_.phase.to_mid_single;
  out_.orbit = orbit(out_.v_plan, period);
  out_.orbit_middle = settings_.com.lead;
  out_.orbit_ahead = out_.orbit.ahead(std::clamp(since_middle, -half, half));
  capture(in, before_switch);
}

ForwardOrbit GaitGenerator::orbit(const Vec3& velocity, double period, bool end) const {
  const ZmpBounds sole = sole_room(velocity);
  const double middle = settings_.com.lead, ahead = sole.upper.x() - middle, behind = middle - sole.lower.x();
  return {pendulum_, velocity.x(), period, end ? (velocity.x() < 0.0 ? behind : ahead) : std::max(ahead, behind)};
}

ZmpBounds GaitGenerator::room(const GaitInput& in) const {
  ZmpBounds out = sole_room(out_.v_plan);
  if (!out_.standing[kLeft] || !out_.standing[kRight]) return out;
  const Side there = other(out_.support);
  return out.widened(bounds_[there], (in.p_sole[there].head<2>() - out_.origin).dot(left_of(out_.yaw)));
}

void GaitGenerator::capture(const GaitInput& in, bool before_switch) {
  // The next foot to take over: the one that swings, or one that has landed.
  const double dt = settings_.control.dt, period = before_switch ? schedule_.times().period() : period_;
  const double time =
      before_switch ? std::max(0.5 * out_.phase.duration - out_.phase.time, dt) : out_.phase.to_mid_double;
  const double t_mid = in.t + time, slope = time + pendulum_.Tc(),
               length = plan_.displacement(t_mid, t_mid + period).x();
  v_start_ = orbit({length / period, 0.0, 0.0}, period, true).end_velocity();
  xi_start_ = settings_.com.lead - 0.5 * length + pendulum_.Tc() * v_start_;
  const PendulumState next = roll_out(in, time);
  xi_next_ = pendulum_.dcm(next);
  v_next_ = next.v;
  if (settings_.steps.mode != Footsteps::kTied) return;
  // One step of Newton's a cycle: a COM faster by dv is dv time further then, and its DCM dv (time + T_c).
  const bool decided = out_.phase.phase == Phase::kSingleSupport &&
                       (closing_ || out_.phase.time > settings_.steps.freeze * out_.phase.duration);
  const Vec2 ahead = ahead_of(out_.heading);
  const double foot = before_switch ? (in.p_sole[other(out_.support)].head<2>() - out_.origin).dot(ahead)
                      : decided     ? (footsteps_.target().p - out_.origin).dot(ahead)
                                    : footsteps_.lead(out_.phase.step, t_mid, period);
  const double planned = foot + xi_start_, reach = settings_.steps.capture_distance;
  const double alone = xi_next_ - slope * out_.dv_capture;
  const double dv = out_.dv_capture + (std::clamp(alone, planned - reach, planned + reach) - xi_next_) / slope;
  out_.dv_capture = std::clamp(dv, -settings_.steps.capture_speed, settings_.steps.capture_speed);
}

double GaitGenerator::ahead_of_plan(const GaitInput& in) const {
  const double t_mid = in.t + out_.phase.to_mid_double;
  const double planned = (in.com - out_.origin).dot(ahead_of(out_.heading)) + plan_.displacement(in.t, t_mid).x() +
                         0.5 * plan_.displacement(t_mid, t_mid + period_).x() - settings_.com.lead;
  // An excess speed, up to this, is left to the ZMP over that foot: taken up by the foothold, a long step would make the next one short.
  const double excess = pendulum_.Tc() * (v_next_ - v_start_), give = settings_.steps.give;
  return xi_next_ - xi_start_ - planned - std::clamp(excess, give * out_.room.lower.x(), give * out_.room.upper.x());
}

PendulumState GaitGenerator::roll_out(const GaitInput& in, double time) const {
  // The pendulum (16) under the smooth tracker, its ZMP inside the bounds of the stance sole; by its DCM and its mirror image x - T_c v.
  constexpr int kPieces = 16;
  const double Tc = pendulum_.Tc(), dt = time / kPieces, grow = std::exp(dt / Tc);
  const double catch_up = -std::expm1(-dt / settings_.tracking.time) / dt;
  const Vec2 ahead = ahead_of(out_.heading);
  const PendulumState now{(in.com - out_.origin).dot(ahead), in.dcom.dot(ahead)};
  double xi = now.x + Tc * now.v, mirror = now.x - Tc * now.v;
  const bool smooth = plan_.smooth(in.t, in.t + time);
  const double v_now = out_.v_plan.x(), slope = smooth ? (plan_.velocity(in.t + time).x() - v_now) / time : 0.0;
  for (int k = 0; k < kPieces; ++k) {
    // as it is in the middle of the piece
    const double v = (xi - mirror) / (2.0 * Tc), x = 0.5 * (xi + mirror + dt * v), from_middle = x - out_.orbit_middle;
    const double t = (k + 0.5) * dt, faster = smooth ? slope * t : plan_.velocity(in.t + t).x() - v_now;
    const double dv = faster + in.catch_up + out_.dv_capture;
    const double a = out_.orbit.acceleration(from_middle) + catch_up * (out_.orbit.velocity(from_middle) + dv - v);
    const double r = std::clamp(pendulum_.reference_for(x, a), out_.room.lower.x(), out_.room.upper.x());
    xi = r + (xi - r) * grow;
    mirror = r + (mirror - r) / grow;
  }
  return {0.5 * (xi + mirror), (xi - mirror) / (2.0 * Tc)};
}

double GaitGenerator::stretch(const GaitInput& in) const {
  const bool single = out_.phase.phase == Phase::kSingleSupport;
  const Side landed = single ? out_.swing : other(out_.swing), lifting = other(landed);
  const Foothold from = foothold_of(in.p_sole[lifting], in.R_sole[lifting]);
  const Foothold to = single ? out_.foothold : foothold_of(in.p_sole[landed], in.R_sole[landed]);
  const double to_middle = single ? out_.phase.to_mid_double : 0.5 * out_.phase.duration - out_.phase.time;
  const double T_ds = single ? schedule_.times().T_ds : out_.phase.duration, Tc = pendulum_.Tc();
  const double sway = 0.5 * (to.p - from.p).norm() / Tc * std::tanh(0.5 * schedule_.times().period() / Tc);
  return footsteps_.stretch(to, landed, from, in.t + to_middle, T_ds, sway);
}

void GaitGenerator::move_sideways(const GaitInput& in) {
  const bool single = out_.phase.phase == Phase::kSingleSupport;
  const double dt = settings_.control.dt, time = out_.phase.to_mid_double, t_mid = in.t + time;
  const Side stance = other(out_.swing), to = other(out_.support);
  const Vec2 left = left_of(out_.heading);
  const auto across = [&](const Vec2& p) { return (p - out_.origin).dot(left); };
  const PendulumState y{across(in.com), in.dcom.dot(left)};
  const double xi = pendulum_.dcm(y), drift = footsteps_.drift(t_mid, period_);

  // The orbit's DCM in the middle of the next double support, for a foot that lands at `there`; before a stand, half way to it.
  const auto xi_end = [&](const Vec2& there) {
    if (closing_) return 0.5 * across(there);
    return across(there) + side_sign(out_.support) * pendulum_.orbit_inset(footsteps_.width(drift), period_) +
           pendulum_.orbit_offset(drift, period_);
  };
  if (single) {
    const Foothold foot = foothold_of(in.p_sole[stance], in.R_sole[stance]);
    if (lifted_) {
      footsteps_.begin_step(out_.phase.step, out_.swing, foot, t_mid, period_);
      closing_ = settings_.gait.stand && plan_.at_rest(in.t, schedule_.touch_down() + schedule_.times().T_ds) &&
                 footsteps_.close(out_.swing, foot, xi_next_);
    }
    const double aside = lateral_.miss(pendulum_, xi, xi_end(footsteps_.planned(out_.swing, t_mid, period_).p), time);
    out_.foothold =
        footsteps_.update(ahead_of_plan(in), aside, t_mid, period_, out_.phase.time / out_.phase.duration, dt);
  }
  if (lateral_.awaits_switch()) {
    if (single) return;
    const bool last = out_.phase.time + 1.5 * dt >= out_.phase.duration;
    const double w_orbit =
        pendulum_.orbit_velocity(footsteps_.drift(in.t, schedule_.times().period()), schedule_.times().period());
    out_.w_T = lateral_.check_switch(pendulum_, y, 0.0, across(in.p_sole[to].head<2>()), out_.phase.to_mid_single,
                                     w_orbit, dt, last);
    return;
  }
  const Vec2 there = single ? out_.foothold.p : footsteps_.planned(out_.swing, t_mid, period_).p;
  out_.zmp_lateral = lateral_.reference(pendulum_, xi, xi_end(there), time);
}

}  // namespace zmpwalk
