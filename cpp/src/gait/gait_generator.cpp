#include "zmpwalk/gait/gait_generator.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "zmpwalk/gait/point_walk.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/math/rotation.hpp"

namespace zmpwalk {
namespace {

/// Share of the ZMP's bounds over the next foot within which the DCM is to be when that foot takes over. A DCM beyond them cannot be held there; the rest is
/// for what the plan does not know.
constexpr double kHeld = 0.8;
/// Share of `steps.capture_distance` by which it may be off its plan all the same: the plan of a fast walk goes to the edge of those bounds.
constexpr double kAlways = 0.1;
constexpr double kOffTime =
    0.072;                     // a foot that touches the ground this long before its time has met it off its time [T_c]
constexpr double kLift = 1.7;  // how much higher a foot is lifted on uneven ground
constexpr double kAgree = 0.03;  // by how much the slopes under both soles may differ, for the ground to slope so
constexpr double kGoesOn = 0.5;  // share of the way to the foothold along which such a slope is taken to go on
constexpr double kSoft = 0.4;    // time constant with which the tracked speed yields there [T_c]

Side first_swing(const WalkSettings& settings) { return settings.gait.first_swing; }

WalkSettings with_lead(WalkSettings settings, const SoleSize& sole, const std::array<ZmpBounds, 2>& bounds) {
  settings.com.lead = place_with_room(bounds, sole.length, settings.com.lead);
  return settings;
}

}  // namespace

Foothold foothold_of(const Vec3& p, const Mat3& R) { return {p.head<2>(), yaw_of(R)}; }

std::array<Foothold, 2> feet_of(const GaitInput& in) {
  return {foothold_of(in.p_sole[kLeft], in.R_sole[kLeft]), foothold_of(in.p_sole[kRight], in.R_sole[kRight])};
}

Vec2 reference_zmp(const GaitOutput& gait, const LinearInvertedPendulum& pendulum, const VelocityTracker& tracker,
                   const Vec2& com, const Vec2& dcom) {
  if (gait.at_rest) return gait.zmp_rest;
  const double x = (com - gait.origin).dot(gait.ahead_M), from_middle = x - gait.orbit_middle;
  const double a =
      gait.orbit.acceleration(from_middle) + tracker.acceleration(gait.orbit.velocity(from_middle) + gait.dv_capture,
                                                                  dcom.dot(gait.ahead_M), gait.orbit_ahead);
  const double r = std::isnan(gait.zmp_ahead) ? pendulum.reference_for(x, a) : gait.zmp_ahead;  // along M's x
  // The bounds are along S's x: what is beyond them must not lean sideways where the sole points elsewhere than the walk.
  const double inside = std::clamp(r, gait.room.lower.x(), gait.room.upper.x());
  return gait.origin + inside * gait.ahead_M + (r - inside) * gait.ahead_S + gait.zmp_lateral * left_of(gait.ahead_M);
}

GaitGenerator::GaitGenerator(const WalkSettings& settings, const VelocityProfile& profile, const SoleSize& sole,
                             const std::array<ZmpBounds, 2>& bounds, const std::array<ZmpBounds, 2>& whole)
    : settings_(with_lead(settings, sole, bounds)),
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
      footsteps_(settings_, plan_, sole),
      lateral_(settings.zmp.lateral_law, settings.zmp.lateral_shift * 0.5 * sole.width),
      pendulum_(1.0, 1.0),
      bounds_(bounds),
      whole_(whole),
      stand_ahead_(place_with_room(bounds, sole.length, 0.0)),
      least_apart_(sole.foot_width + settings.steps.clearance),
      recovers_(settings.steps.timing && settings.steps.mode == Footsteps::kTied),
      sole_(sole) {
  plan_.reserve();
}

void GaitGenerator::reset(const GaitInput& start, const LinearInvertedPendulum& pendulum) {
  pendulum_ = pendulum;
  plan_ = profile_;
  plan_.reserve();
  allowance_ = limits_.jump;
  commanded_ = false;
  t_command_ = 0.0;
  felt_ = {false, false};
  pushed_way_.setZero();
  pushed_ = off_plan_ = 0.0;
  alone_ = false;
  footsteps_.end_step();
  footsteps_.know(ground_);
  fits_ = steered_ = slowed_ = told_ = false;
  out_ = GaitOutput{};
  out_.known = ground_ != nullptr;
  const std::array<Foothold, 2> feet = feet_of(start);
  out_.heading = feet[kLeft].yaw + 0.5 * wrap_angle(feet[kRight].yaw - feet[kLeft].yaw);
  footsteps_.reset(feet, out_.heading);
  out_.ahead = footsteps_.path().ahead;
  out_.swing = out_.support = first_swing(settings_);
  lateral_.reset(out_.support);
  schedule_.begin(0, 0.0, settings_.gait.T_ds_first, cadence_.slow);
  out_.at_rest = true;  // until the first cycle finds that the plan moves
  out_.origin = start.p_sole[out_.support].head<2>();
  out_.yaw = yaw_of(start.R_sole[out_.support]);
  out_.ahead_S = ahead_of(out_.yaw);
  sole_room_ = sole_room(out_.v_plan);
  out_.room = room(start, bounds_, sole_room_);
}

void GaitGenerator::command(const Vec3& velocity) {
  command_ = velocity;
  commanded_ = true;
}

void GaitGenerator::retime(double remaining) {
  require_positive("remaining", remaining);
  if (out_.at_rest) return;
  schedule_.retime(footsteps_.now().t, remaining);
  retimed_ = true;
}

void GaitGenerator::take_command(double t) {
  if (!commanded_) return;
  commanded_ = false;
  wanted_ = command_;
  told_ = true;
  if (fits_ || slowed_) return;  // the next step fits it to the ground
  steered_ = false;
  steer(t, command_);
}

void GaitGenerator::steer(double t, const Vec3& target) {
  const Vec3 spent = (plan_.velocity(t) - plan_.velocity(t_command_)).cwiseAbs();
  allowance_ += ((t - t_command_) * limits_.acceleration - spent).cwiseMax(0.0);
  allowance_ = allowance_.cwiseMin(limits_.jump);
  const Vec3 before = plan_.velocity(t);
  plan_.steer(t, target, limits_, allowance_);
  footsteps_.replan();
  allowance_ = (allowance_ - (plan_.velocity(t) - before).cwiseAbs()).cwiseMax(0.0);
  t_command_ = t;
}

StepTimes GaitGenerator::times_at(double t) const {
  const double T = cadence_.slow.period();
  if (fits_) return cadence_.slow;
  return cadence_.times(plan_.displacement(t, t + T) / T);
}

void GaitGenerator::begin_walk(const GaitInput& in) {
  const StepTimes times = times_at(in.t);
  starting_ = true;
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
  const double xi = (in.com + pendulum_.Tc() * in.dcom - out_.origin).dot(out_.ahead_S);
  return out_.room.lower.x() <= xi && xi <= out_.room.upper.x();
}

bool GaitGenerator::has_landed(const GaitInput& in) {
  const bool due = schedule_.landed(in.t);
  out_.off_time = false;
  if (settings_.gait.touch_down == TouchDown::kFelt && out_.phase.phase == Phase::kSingleSupport)
    return is_felt(in, due);
  if (settings_.gait.touch_down == TouchDown::kTime || out_.phase.phase == Phase::kDoubleSupport) return due;
  const double contact = in.contact[out_.swing], since = in.t - schedule_.lift_off(), dt = settings_.control.dt;
  const bool touches = contact > 0.5, flies = contact < 0.5;  // neither, where it is not known
  if (flies && swing_ == Swing::kLifting) swing_ = Swing::kAirborne;
  if (!due) {
    const bool early =
        touches && swing_ == Swing::kAirborne && since >= settings_.gait.touch_down_share * out_.phase.duration;
    if (early) schedule_.land(in.t);
    return early;
  }
  if (!flies || !felt_[out_.swing] || schedule_.waited() + dt > settings_.gait.touch_down_time) return true;
  schedule_.wait(in.t + dt);
  if (swing_ != Swing::kOverdue) swing_foot_.sink(since, settings_.gait.touch_down_time);
  swing_ = Swing::kOverdue;
  return false;
}

bool GaitGenerator::is_felt(const GaitInput& in, bool due) {
  const GaitSettings& gait = settings_.gait;
  const double contact = in.contact[out_.swing], since = in.t - schedule_.lift_off(), dt = settings_.control.dt;
  const bool touches = contact > 0.5, flies = contact < 0.5;  // neither, where it is not known
  if (flies && swing_ == Swing::kLifting) swing_ = Swing::kAirborne;
  if (touches && swing_ == Swing::kOverdue) return true;
  if (!due) {
    if (!touches || swing_ != Swing::kAirborne || since < gait.touch_down_share * out_.phase.duration) return false;
    out_.off_time = schedule_.touch_down() - in.t > kOffTime * pendulum_.Tc();
    if (!in.uneven && !out_.off_time) return false;  // it comes down calmly, and has touched a little early
    schedule_.land(in.t);
    return true;
  }
  // On even ground a foot lands at rest, and touches when it is loaded: that it flies says nothing there.
  const bool waits = in.uneven && flies && felt_[out_.swing] && swing_ != Swing::kLifting;
  if (!waits || schedule_.waited() + dt > gait.touch_down_time) return true;
  schedule_.wait(in.t + dt);
  if (swing_ != Swing::kOverdue) swing_foot_.sink(since, gait.touch_down_time);
  swing_ = Swing::kOverdue;
  out_.off_time = schedule_.waited() > 0.5 * kOffTime * pendulum_.Tc();
  return false;
}

GaitGenerator::Began GaitGenerator::begin_phase(const GaitInput& in) {
  for (const Side side : kSides) felt_[side] |= in.contact[side] > 0.5;
  if (out_.at_rest) {
    // The first step lifts when the plan moves, and half of its double support has gone by.
    const bool pushed = recovers_ && off_the_feet(in);
    if (!pushed && settings_.gait.stand && plan_.at_rest(in.t, in.t + 0.5 * settings_.gait.T_ds_first) && can_stand(in))
      return Began::kNothing;
    if (pushed)
      begin_catching(in);
    else
      begin_walk(in);
    lateral_.begin_cycle(false);
    return Began::kDoubleSupport;
  }
  if (has_landed(in)) {
    out_.swing = other(out_.swing);  // the foot that stood swings next
    const bool stands = footsteps_.closing();
    footsteps_.end_step();
    if (stands) return Began::kStand;
    schedule_.next(times_at(in.t));
    lateral_.begin_cycle(true);
    return Began::kDoubleSupport;
  }
  lateral_.begin_cycle(false);
  return Began::kNothing;
}

const GaitOutput& GaitGenerator::update(const GaitInput& in) {
  update_steps(in);
  if (out_.phase.phase == Phase::kSingleSupport) move_swing_foot(in);
  return out_;
}

Vec2 GaitGenerator::felt_slope(const GaitInput& in) const {
  std::array<Vec2, 2> rise;
  for (const Side side : kSides) {
    const Vec3 up = in.R_sole[side].col(2);
    rise[side] = -up.head<2>() / up.z();
  }
  const auto& [left, right] = rise;
  return (left - right).norm() < kAgree ? Vec2(0.5 * (left + right)) : Vec2::Zero();
}

void GaitGenerator::move_swing_foot(const GaitInput& in) {
  const double t = out_.phase.time, duration = out_.phase.duration;
  if (began_ == Began::kSingleSupport) {
    const double z_land = std::isnan(in.ground) ? in.p_sole[other(out_.swing)].z() : in.ground;
    const bool feels = in.uneven || settings_.gait.touch_down == TouchDown::kContact;
    const double height = (in.uneven ? kLift : 1.0) * settings_.swing.height;
    const double speed = feels ? settings_.gait.touch_down_speed : 0.0;
    const SwingShape shape = ground_ ? clearing_shape(in) : SwingShape{};
    shaped_ = !std::isnan(shape.top);
    if (!shaped_) {
      const Vec2 slope = in.uneven ? felt_slope(in) : Vec2::Zero();
      const double rise = kGoesOn * slope.dot(out_.foothold.p - in.p_sole[other(out_.swing)].head<2>());
      const Vec2 tilt = in.uneven ? tilt_on(slope, out_.foothold.yaw) : Vec2::Constant(kNaN);
      swing_foot_.begin(in.p_sole[out_.swing], in.R_sole[out_.swing], duration, z_land + rise, height, speed, in.uneven,
                        tilt);
    } else {
      swing_foot_.begin(in.p_sole[out_.swing], in.R_sole[out_.swing], duration, out_.place.height + in.felt, shape,
                        speed);
    }
  } else if (swing_ != Swing::kOverdue && duration != swing_foot_.duration()) {
    swing_foot_.replan(t, duration - t);
  }
  if (ground_ && shaped_) swing_foot_.land_at(out_.place.height + in.felt);
  out_.swing_target = swing_foot_.update(t, settings_.control.dt, out_.foothold);
}

const GaitOutput& GaitGenerator::update_steps(const GaitInput& in) {
  footsteps_.advance(in.t, in.com);
  take_command(in.t);
  began_ = begin_phase(in);
  out_.heading = footsteps_.heading();
  out_.ahead = out_.ahead_M = footsteps_.path().ahead;
  out_.v_plan = footsteps_.now().v;
  out_.standing = {true, true};
  out_.foothold = {Vec2::Constant(kNaN), kNaN};
  out_.w_T = kNaN;
  zmp_lateral_ = out_.zmp_lateral;
  out_.zmp_lateral = 0.0;
  out_.zmp_ahead = kNaN;
  out_.stretch = 0.0;
  if (began_ == Began::kStand) {
    out_.at_rest = true;
    ++out_.phase.step;
  }
  if (out_.at_rest) {
    const double since = began_ == Began::kStand ? 0.0 : out_.phase.time + settings_.control.dt;
    out_.phase = {Phase::kDoubleSupport, out_.phase.step, since, since, kNaN, kNaN};
  } else {
    const bool was_single = out_.phase.phase == Phase::kSingleSupport && began_ == Began::kNothing;
    out_.phase = schedule_.at(in.t);
    const bool single = out_.phase.phase == Phase::kSingleSupport;
    if (single && !was_single) {
      began_ = Began::kSingleSupport;
      swing_ = Swing::kLifting;
      lateral_.end_double_support();
    }
    if (began_ != Began::kNothing) {
      period_ = times_at(in.t + out_.phase.to_mid_double).period();
      retimed_ = false;
    }
    out_.support = lateral_.support();
    out_.standing[out_.swing] = !single;
  }
  out_.origin = in.p_sole[out_.support].head<2>();
  out_.yaw = yaw_of(in.R_sole[out_.support]);
  out_.ahead_S = ahead_of(out_.yaw);
  if (recovers_) feel_pushes(in);
  sole_room_ = sole_room(out_.v_plan);
  out_.room = room(in, bounds_, sole_room_);
  if (ground_) look_at_ground(in);
  if (began_ == Began::kDoubleSupport && (ground_ || steered_ || in.pace < 1.0)) fit_plan(in);
  if (out_.at_rest) {
    if (recovers_) out_.room = room(in, whole_, whole_[out_.support]);
    // The ZMP leads the DCM back to the middle between the feet.
    const Vec2 middle = 0.5 * (in.p_sole[kLeft] + in.p_sole[kRight]).head<2>() + stand_ahead_ * out_.ahead;
    const Vec2 xi = in.com + pendulum_.Tc() * in.dcom;
    out_.zmp_rest = xi + settings_.gait.stand_gain * (xi - middle);
    out_.orbit_ahead = out_.dv_capture = 0.0;
    out_.urgency = pushed_ > 0.0 ? urgency(off_stand(xi - middle)) : 0.0;
  } else {
    move_ahead(in);
    move_sideways(in);
    out_.stretch = stretch(in);
    if (recovers_) recover(in);
  }
  return out_;
}

ZmpBounds GaitGenerator::sole_room(const Vec3& velocity) const {
  ZmpBounds out = bounds_[out_.support];
  const double pace = cadence_.pace(velocity);
  if (pace == 1.0) return out;
  const double share = std::pow(pace, settings_.zmp.sole_exponent);
  out.lower.x() = stand_ahead_ + share * (out.lower.x() - stand_ahead_);
  out.upper.x() = stand_ahead_ + share * (out.upper.x() - stand_ahead_);
  return out;
}

void GaitGenerator::move_ahead(const GaitInput& in) {
  footsteps_.hurry(regain(in));
  const double period = schedule_.times().period(), half = 0.5 * period, dt = settings_.control.dt;
  const bool awaits = before_switch();
  const double since_middle = awaits ? half - 0.5 * out_.phase.duration + out_.phase.time : -out_.phase.to_mid_single;
  const double time = awaits ? std::max(0.5 * out_.phase.duration - out_.phase.time, dt) : out_.phase.to_mid_double;
  next_ = footsteps_.stance_at(in.t + time, awaits ? period : period_);
  turn(in, since_middle);
  const double v = speed_in_M(out_.v_plan, out_.support, turn_, period);
  take_orbit(out_.orbit, sole_room_, v + footsteps_.hurried(), period);
  out_.orbit_middle = settings_.com.lead;
  out_.orbit_ahead = out_.orbit.ahead(std::clamp(since_middle, -half, half));
  capture(in, time);
  if (fits_) meet_place(in, time);
}

void GaitGenerator::turn(const GaitInput& in, double since_middle) {
  // What is commanded after the middle of a stance turns the stances to come, not this one. A robot that begins to walk shifts its load to the
  // first foot without having stood on the other one alone.
  if (starting_ && before_switch())
    heading_M_ = next_.path.yaw;
  else if (const double middle = in.t - since_middle; middle >= in.t)
    heading_M_ = out_.heading + (plan_.turns(footsteps_.now(), middle) ? plan_.displacement(in.t, middle).z() : 0.0);
  turn_ = next_.path.yaw - heading_M_;
  if (heading_M_ != out_.heading) out_.ahead_M = ahead_of(heading_M_);
  next_turn_ = 0.5 * next_.displacement().z();
  ahead_next_ = next_turn_ == 0.0 ? next_.path.ahead : ahead_of(next_.path.yaw + next_turn_);
}

double GaitGenerator::speed_in_M(const Vec3& v, Side side, double angle, double period) const {
  if (angle == 0.0) return v.x();
  const double Tc = pendulum_.Tc();
  const double sway = 0.5 * footsteps_.width(v.y() * period) / Tc * std::tanh(0.5 * period / Tc);
  return v.x() * std::cos(angle) + side_sign(side) * sway * std::sin(angle);
}

void GaitGenerator::take_orbit(ForwardOrbit& orbit, const ZmpBounds& sole, double v, double period, bool end) const {
  const double middle = settings_.com.lead, ahead = sole.upper.x() - middle, behind = middle - sole.lower.x();
  const double roll = end ? std::min(ahead, behind) : std::max(ahead, behind);
  if (!orbit.is_for(pendulum_, v, period, roll)) orbit = {pendulum_, v, period, roll};
}

ZmpBounds GaitGenerator::room(const GaitInput& in, const std::array<ZmpBounds, 2>& bounds,
                              const ZmpBounds& support) const {
  if (!out_.standing[kLeft] || !out_.standing[kRight] || alone_) return support;
  const Side there = other(out_.support);
  return support.widened(bounds[there], (in.p_sole[there].head<2>() - out_.origin).dot(left_of(out_.ahead_S)));
}

void GaitGenerator::capture(const GaitInput& in, double time) {
  const double period = next_.period, slope = time + pendulum_.Tc();
  const double v_mean = speed_in_M(next_.displacement() / period, other(out_.support), next_turn_, period);
  const double length = next_turn_ == 0.0 ? next_.displacement().x() : v_mean * period;
  take_orbit(next_orbit_, sole_room({v_mean, 0.0, 0.0}), v_mean, period, true);
  v_start_ = next_orbit_.end_velocity();
  xi_start_ = settings_.com.lead - 0.5 * length + pendulum_.Tc() * v_start_;
  const ForwardStance stance{out_.orbit,      out_.orbit_middle,   settings_.tracking.time, in.catch_up,
                             out_.dv_capture, out_.room.lower.x(), out_.room.upper.x()};
  const PendulumState state{(in.com - out_.origin).dot(out_.ahead_M), in.dcom.dot(out_.ahead_M)};
  PendulumState then = roll_out(pendulum_, plan_, footsteps_.now(), next_.mid, time, state, stance);
  xi_sideways_ = 0.0;
  if (turn_ != 0.0 || next_turn_ != 0.0) {
    const Vec2 left = left_of(out_.ahead_M);
    const PendulumState aside{(in.com - out_.origin).dot(left), in.dcom.dot(left)};
    const PendulumState swayed = pendulum_.step(pendulum_.over(time), aside, before_switch() ? 0.0 : zmp_lateral_);
    // From M into that of the next foot.
    const double c = out_.ahead_M.dot(ahead_next_), s = left.dot(ahead_next_);
    xi_sideways_ = s * pendulum_.dcm(then);
    then = {c * then.x + s * swayed.x, c * then.v + s * swayed.v};
  }
  xi_next_ = pendulum_.dcm(then);
  v_next_ = then.v;
  if (settings_.steps.mode != Footsteps::kTied) return;
  // One step of Newton's a cycle: a COM faster by dv is dv time further then, and its DCM dv (time + T_c).
  const bool decided = out_.phase.phase == Phase::kSingleSupport &&
                       (footsteps_.closing() || out_.phase.time > settings_.steps.freeze * out_.phase.duration);
  const double foot = before_switch() ? (in.p_sole[other(out_.support)].head<2>() - out_.origin).dot(ahead_next_)
                      : fits_         ? (out_.place.at.p - out_.origin).dot(ahead_next_)
                      : decided       ? (footsteps_.target().p - out_.origin).dot(ahead_next_)
                                      : planned_lead();
  const double planned = foot + xi_start_, near = settings_.steps.capture_distance;
  // Near its plan, and where the ZMP over the next foot can hold it.
  const ZmpBounds& there = bounds_[other(out_.support)];
  const double least = std::max(planned - near, std::min(planned - kAlways * near, foot + kHeld * there.lower.x()));
  const double most = std::min(planned + near, std::max(planned + kAlways * near, foot + kHeld * there.upper.x()));
  const double alone = xi_next_ - slope * out_.dv_capture;
  const double dv = out_.dv_capture + (std::clamp(alone, least, most) - xi_next_) / slope;
  const double wanted = std::clamp(dv, -settings_.steps.capture_speed, settings_.steps.capture_speed);
  // A leap of the speed is a leap of the ZMP, over which a sole tips that has not found ground under all of it.
  const auto share = [&] { return -std::expm1(-settings_.control.dt / (kSoft * pendulum_.Tc())); };
  out_.dv_capture = in.uneven ? out_.dv_capture + share() * (wanted - out_.dv_capture) : wanted;
}

double GaitGenerator::planned_lead() const {
  const double lead = footsteps_.lead(out_.phase.step, next_);
  if (next_turn_ == 0.0) return lead;
  const double aside = side_sign(other(out_.support)) * footsteps_.width(next_.drift());
  return lead * std::cos(next_turn_) + aside * std::sin(next_turn_);
}

double GaitGenerator::ahead_of_plan(const GaitInput& in, const Vec2& planned) const {
  const double to_middle = (next_.mid.integral - footsteps_.now().integral).x();
  const double there = turn_ == 0.0 && next_turn_ == 0.0 ? (in.com - out_.origin).dot(out_.ahead) + to_middle +
                                                               0.5 * next_.displacement().x() - settings_.com.lead
                                                         : (planned - out_.origin).dot(ahead_next_);
  // An excess speed, up to this, is left to the ZMP over that foot: taken up by the foothold, a long step would make the next one short.
  const double excess = pendulum_.Tc() * (v_next_ - v_start_), give = settings_.steps.give;
  return xi_next_ - xi_start_ - there - std::clamp(excess, give * out_.room.lower.x(), give * out_.room.upper.x());
}

double GaitGenerator::stretch(const GaitInput& in) {
  const bool single = out_.phase.phase == Phase::kSingleSupport;
  const Side landed = single ? out_.swing : other(out_.swing), lifting = other(landed);
  const Vec2 from = in.p_sole[lifting].head<2>(), to = single ? out_.foothold.p : Vec2(in.p_sole[landed].head<2>());
  const double to_middle = single ? out_.phase.to_mid_double : 0.5 * out_.phase.duration - out_.phase.time;
  const double T_ds = single ? schedule_.times().T_ds : out_.phase.duration, Tc = pendulum_.Tc();
  const double period = schedule_.times().period(), t_mid = in.t + to_middle;
  if (period != sway_period_ || Tc != sway_Tc_) {
    sway_ = std::tanh(0.5 * period / Tc);
    sway_period_ = period;
    sway_Tc_ = Tc;
  }
  const double sway = 0.5 * (to - from).norm() / Tc * sway_;
  return footsteps_.stretch(to, landed, from, t_mid == next_.t_mid() ? next_ : footsteps_.stance_at(t_mid, 0.0), T_ds,
                            sway);
}

void GaitGenerator::move_sideways(const GaitInput& in) {
  const bool single = out_.phase.phase == Phase::kSingleSupport;
  const double Tc = pendulum_.Tc();
  const Vec2 left = left_of(out_.ahead_M);
  const PendulumState y{(in.com - out_.origin).dot(left), in.dcom.dot(left)};
  if (before_switch()) {
    const Vec2 left_next = left_of(ahead_next_);
    const PendulumState then{(in.com - out_.origin).dot(left_next), in.dcom.dot(left_next)};
    const double dt = settings_.control.dt, period = schedule_.times().period();
    const double drift = plan_.displacement(in.t, in.t + period).y();
    const double foot = (in.p_sole[other(out_.support)].head<2>() - out_.origin).dot(left_next);
    const double w_orbit = pendulum_.orbit_velocity(drift, period);
    out_.w_T = lateral_.check_switch(pendulum_, then, 0.0, foot, out_.phase.to_mid_single, w_orbit, dt,
                                     out_.phase.duration - out_.phase.time);
    return;
  }
  if (single) starting_ = alone_ = false;
  if (period_ != orbit_period_ || Tc != orbit_Tc_) {
    orbit_growth_ = pendulum_.growth(period_);
    orbit_period_ = period_;
    orbit_Tc_ = Tc;
  }
  const bool turns = turn_ != 0.0 || next_turn_ != 0.0;
  const LinearInvertedPendulum::Growth until = pendulum_.growth(out_.phase.to_mid_double);
  const double xi = pendulum_.dcm(y), drift = next_.drift();
  // The orbit's DCM in the middle of the next double support, for a foot that lands at `there`; before a stand, half way to it.
  const auto xi_end = [&](const Vec2& there) {
    const double y_there = (there - out_.origin).dot(left_of(ahead_next_));
    if (footsteps_.closing()) return 0.5 * y_there;
    const double inset = side_sign(out_.support) * pendulum_.orbit_inset(footsteps_.width(drift), orbit_growth_) +
                         pendulum_.orbit_offset(drift, orbit_growth_);
    if (!turns) return y_there + inset;
    // From the next foot's M into M.
    const double curve = 2.0 * Tc * next_.mid.v.x() * std::sin(next_turn_) / orbit_growth_.excess;
    return (y_there + std::cos(next_turn_) * inset + curve + xi_sideways_) / out_.ahead_M.dot(ahead_next_);
  };
  const auto sway = [&](const Vec2& there) {
    return Sway{settings_, pendulum_, out_.support, y, xi, xi_end(there), out_.phase.to_mid_double, until};
  };
  if (single) {
    if (began_ == Began::kSingleSupport) {
      planned_landing_ = schedule_.touch_down();
      const Side stance = other(out_.swing);
      const Foothold foot = foothold_of(in.p_sole[stance], in.R_sole[stance]);
      footsteps_.begin_step(out_.phase.step, out_.swing, foot, next_, fits_ ? &out_.place : nullptr);
      if (settings_.gait.stand && plan_.at_rest(in.t, schedule_.touch_down() + schedule_.times().T_ds))
        footsteps_.close(out_.swing, foot, xi_next_);
    }
    if (footsteps_.follows(decided_share(in))) {
      const PathPoint planned = footsteps_.planned(out_.swing, next_);
      Vec2 off = footsteps_.off_nominal(ahead_of_plan(in, planned.p), lateral_.miss(sway(planned.p)), planned);
      if (fits_ && pushed_ == 0.0) off.x() = 0.0;
      // A long way is bounded by what the leg and the foot in the air can do.
      const bool pushed = pushed_ > 0.0, far_ahead = pushed || std::abs(off.x()) > settings_.steps.shift,
                 far_beside = pushed || std::abs(off.y()) > settings_.steps.shift;
      LandingRoom reachable;
      if (far_ahead || far_beside) reachable = landing_room(in);
      footsteps_.follow(off, planned, far_ahead ? &reachable : nullptr, far_beside ? &reachable : nullptr);
    }
    out_.foothold = footsteps_.target();
    if (ground_) out_.place = footsteps_.place();
  }
  const Vec2 there = single ? out_.foothold.p : footsteps_.planned(out_.swing, next_).p;
  out_.zmp_lateral = lateral_.reference(sway(there));
  xi_offset_ = xi_end(there) - (there - out_.origin).dot(left);
  xi_planned_ = xi_end(there) / until.factor;
}

}  // namespace zmpwalk
