#include "zmpwalk/walk/walking_controller.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "zmpwalk/gait/point_walk.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/math/rotation.hpp"
#include "zmpwalk/robot/robot_names.hpp"
#include "zmpwalk/walk/proportions.hpp"

namespace zmpwalk {
namespace {

RobotDescription with_limits(RobotDescription description, const std::map<std::string, double>& limits) {
  for (const auto& [joint, limit] : limits) description.torque_limits[joint] = limit;
  return description;
}

/// Inertia of a foot about its ankle's axes, rotors included, per weight of the robot, I / (m g) [m s^2].
double foot_inertia(const Robot& robot) {
  const Dynamics& dyn = robot.dynamics();
  double most = 0.0;
  for (const Side side : kSides)
    for (const int joint : {robot.leg_joints()[side][4], robot.leg_joints()[side][5]})
      most = std::max(most, dyn.A(6 + joint, 6 + joint));
  return most / (dyn.mass * dyn.gravity.norm());
}

/// How much further than on level ground the hip is over the lower foot, half way between a foot and the next one on known ground [m].
double lift_of(const GaitOutput& gait) {
  if (!gait.known || gait.at_rest) return 0.0;
  const Side stance = other(gait.swing);
  const double next = std::abs(gait.place.height - gait.under[stance].height);
  const bool both = gait.phase.phase == Phase::kDoubleSupport;
  return 0.5 * std::max(next, both ? std::abs(gait.under[gait.swing].height - gait.under[stance].height) : 0.0);
}

double whole_fraction(const WalkSettings& s) { return std::max(s.zmp.whole_fraction, s.zmp.sole_fraction); }

double top_speed(const VelocityProfile& profile) {
  double top = 0.0;
  for (const Vec3& v : profile.v()) top = std::max(top, v.x());
  return top;
}

/// A walk begins on the feet. @throws InputError  the COM lies lower than the soles or hardly over them
void require_upright(const Dynamics& dyn) {
  constexpr double kLeastHeight = 0.01;  // [m]
  const double z_c = height_over_soles(dyn);
  if (!std::isfinite(z_c)) throw InputError("the robot's position is too large a number for its COM to be known");
  if (z_c < kLeastHeight)
    throw InputError("the COM lies " + std::to_string(z_c) +
                     " m over the soles: the robot is upside down or lies on the ground; place it on its feet first");
}

/// Between two calls a robot moves about as far as its speed takes it. One that was put somewhere else has begun another walk.
/// @param robot  in the state of the last cycle  @param elapsed  since then [s]. @throws InputError
void require_continuous(const Robot& robot, const State& state, double elapsed) {
  constexpr double kLeap = 0.25;  // more than any reset of an odometry [m]
  const double moved = (state.q.head<3>() - robot.qpos().head<3>()).norm();
  const double speed = std::max(robot.qvel().head<3>().norm(), state.dq.head<3>().norm());
  if (moved > kLeap + 3.0 * speed * elapsed)
    throw InputError("the base has jumped by " + std::to_string(moved) +
                     " m since the last update: the robot was placed elsewhere; call reset to start a walk anew");
}

}  // namespace

WalkingController::WalkingController(const Model& model, const RobotDescription& description,
                                     const WalkSettings& settings, const VelocityProfile& profile)
    : robot_(model, with_limits(description, settings.control.torque_limits)),
      profile_(profile),
      sole_(common_sole(robot_)),
      settings_(resolve(settings, scale_of(robot_), top_speed(profile))),
      bounds_{bounds_of(robot_, kLeft, settings_, settings_.zmp.sole_fraction),
              bounds_of(robot_, kRight, settings_, settings_.zmp.sole_fraction)},
      whole_{bounds_of(robot_, kLeft, settings_, whole_fraction(settings_)),
             bounds_of(robot_, kRight, settings_, whole_fraction(settings_))},
      height_(height_over_soles(robot_.dynamics()), robot_.dynamics().gravity.norm(), settings_),
      ground_(settings_, sole_, height_.z_c(), height_.pendulum().Tc(), foot_inertia(robot_)),
      grip_(settings_, sole_, height_.z_c(), robot_.dynamics().gravity.norm(), settings_.limits.friction),
      gait_(settings_, profile_, sole_, bounds_, whole_),
      reach_(robot_, settings_, gait_.cadence()),
      command_limit_(robot_, settings_, gait_.cadence(), reach_, sole_, bounds_[kLeft], height_.z_c()),
      tracker_(settings_.tracking),
      reference_(settings_),
      body_(robot_, settings_),
      arms_(robot_, settings_),
      whole_body_(robot_.nv(), robot_.leg_joints(),
                  {settings_.control.textbook, settings_.posture.task, settings_.contact.wrench_distribution,
                   settings_.contact.load_alone * 0.5 * sole_.width, settings_.contact.damping,
                   settings_.control.singular_damping, settings_.control.singular_pivot, settings_.control.kernel,
                   settings_.control.singular_task}),
      limits_(limits_of(robot_, settings_), whole_body_),
      estimator_(robot_.nv()),
      foresight_(settings_, sole_,
                 {bounds_of(robot_, kLeft, settings_, 1.0), bounds_of(robot_, kRight, settings_, 1.0)}),
      crouch_(robot_, settings_.control.dt),
      fall_(settings_),
      observer_(settings_, robot_.dynamics().gravity.norm()),
      attitude_(settings_, robot_.dynamics().gravity.norm()),
      clock_(settings_.control.dt),
      posture_task_(robot_.joints()),
      state_(robot_.nv()),
      result_(whole_body_.result()),
      J_c_(RowMatX::Zero(12, robot_.nv())),
      drift_c_(VecX::Zero(12)) {
  robot_.friction_velocity = settings_.control.friction_velocity;
  com_task_.kp.z() = settings_.com.kp_z;
  com_task_.kd.z() = settings_.com.kd_z;
  trunk_task_.kp = settings_.trunk.kp;
  trunk_task_.kd = settings_.trunk.kd;
  foot_task_.kp = settings_.swing.kp;
  foot_task_.kd = settings_.swing.kd;
  posture_task_.kp = settings_.posture.kp;
  posture_task_.kd = settings_.posture.kd;
  f_star_.posture = VecX::Zero(robot_.joints());
  out_.tau = VecX::Zero(robot_.joints());
  for (auto& pose : out_.foot) pose.setZero();
  reference_.set_pendulum(height_.pendulum());
  const Dynamics& dyn = robot_.dynamics();
  height_.reset(height_.z_c(), dyn.com.z() - height_.z_c());
  ground_.reset(height_.ground());
  start_ = gait_input(0.0, dyn.com.head<2>(), dyn.dcom.head<2>());
  require_startable();
}

GaitInput WalkingController::gait_input(double t, const Vec2& com, const Vec2& dcom) const {
  const auto& [left, right] = robot_.dynamics().sole;
  GaitInput in;
  in.t = t;
  in.com = com;
  in.dcom = dcom;
  if (settings_.com.state == ComState::kMeasured) in.dcom_expected = dcom_expected_;
  in.p_sole = {left.p_WF, right.p_WF};
  in.R_sole = {left.R_WF, right.R_WF};
  in.catch_up = tracker_.catch_up(gait_.output().orbit_ahead);
  in.behind = gait_.output().orbit_ahead - tracker_.integral();
  // On uneven ground a foot lands at the height of the stance foot, as far as is known.
  in.uneven = ground_.uneven();
  in.felt = ground_.felt();
  in.pace = grip_.pace();
  if (settings_.gait.touch_down != TouchDown::kContact && !in.uneven) in.ground = ground_.height();
  return in;
}

WalkPlan WalkingController::plan(double duration, double dt) const {
  WalkSettings settings = settings_;
  settings.control.dt = dt;
  require_positive("dt", dt);
  return plan_walk(settings, profile_, height_.pendulum(), bounds_, sole_, start_, duration);
}

void WalkingController::command(const Vec3& velocity) {
  if (!velocity.allFinite())
    throw InputError("command (" + velocity_text(velocity) +
                     ") is not finite; it is (v_x, v_y, w_z) [m/s, m/s, rad/s]");
  SpeedLimit bites;
  const Vec3 possible = command_limit_.within(velocity, &bites);
  bites_ = bites;
  mailbox_.put(possible);
}

void WalkingController::move(const JointMotion& motion) {
  body_.follow(motion);
  arms_.leave_to(body_.reference());
}

void WalkingController::add(const std::shared_ptr<Task>& task, double blend) {
  whole_body_.require_tasks_possible();
  NamesOfRobot names(robot_);
  task->attach(names);
  added_.add(task, robot_.nv(), std::isnan(blend) ? settings_.posture.motion_blend : blend);
  whole_body_.reserve(added_);
}

void WalkingController::remove(const Task& task, double blend) {
  added_.remove(task, std::isnan(blend) ? settings_.posture.motion_blend : blend);
  whole_body_.reserve(added_);
}

int WalkingController::watch(const std::string& name) {
  const int frame = robot_.watch(name);
  state_.external.reserve(
      robot_.dynamics().frames.size());  // a cycle that is told of a force at each frame then allocates nothing
  return frame;
}

void WalkingController::require_external(const std::vector<ExternalWrench>& external) const {
  for (const ExternalWrench& each : external) {
    if (!each.wrench.allFinite()) throw InputError("an external force or moment is not finite");
    if (each.frame < 0 || each.frame >= static_cast<int>(robot_.dynamics().frames.size()))
      throw InputError("an external force acts at frame " + std::to_string(each.frame) + ", which is not watched");
  }
}

double WalkingController::knee_share(double speed) const {
  return zmpwalk::knee_share(scale_of(robot_), settings_, settings_.swing.height, speed);
}

double WalkingController::plan_mismatch(double duration) const {
  return gait_.footsteps().mismatch(duration, gait_.cadence());
}

void WalkingController::require_startable() const {
  command_limit_.require_within(profile_);
  // When the robot starts from a stand, the COM must not run away from the first stance foot before the second foot stands.
  const double room = reach_.along_ground(0.0);
  const double at_rest = std::abs(start_excursion(0.0));
  if (at_rest <= room && start_excursion(1.0) <= room) return;
  if (at_rest > room)
    throw InputError("the COM would run " + std::to_string(at_rest) + " m away even at rest, the legs reach " +
                     std::to_string(room) +
                     " m: at the start pose it lies too far from the feet's middle, or the ankles are "
                     "too weak to hold it there");
  double possible = 0.0, impossible = 1.0;
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (possible + impossible);
    (start_excursion(middle) <= room ? possible : impossible) = middle;
  }
  throw InputError("the profile starts too fast: from a stand the COM would run " +
                   std::to_string(start_excursion(1.0)) + " m ahead of the first stance foot, the legs reach " +
                   std::to_string(room) + " m; the same profile times " + std::to_string(possible) +
                   " is slow enough, and so is a gentler ramp");
}

double WalkingController::start_excursion(double scale) const {
  const auto& [left, right] = robot_.dynamics().sole;
  const Vec2 off = (robot_.dynamics().com - 0.5 * (left.p_WF + right.p_WF)).head<2>();
  const Vec2 ahead = (left.R_WF.col(0) + right.R_WF.col(0)).head<2>().normalized();
  const double behind = -off.dot(ahead);
  const double x_0 = behind > std::abs(off.dot(left_of(ahead))) ? -off.norm() : off.norm();
  return zmpwalk::start_excursion(settings_, gait_.plan(), height_.pendulum(), bounds_[kLeft], x_0, scale);
}

void WalkingController::reset(const State& state) {
  require_state(state, robot_.nv());
  robot_.read(state);
  require_upright(robot_.dynamics());
  clock_.reset(state.time);
  start();
}

void WalkingController::reset(const Data& data) {
  robot_.require_data(data);
  if (!robot_.is_finite(data))
    throw InputError("data holds a position or velocity that is not finite; place the robot first");
  robot_.observe(data, state_);
  reset(state_);
}

void WalkingController::start() {
  const Dynamics& dyn = robot_.dynamics();
  const double z_c = height_over_soles(dyn);
  height_.reset(z_c, dyn.com.z() - z_c);
  ground_.reset(height_.ground());
  reference_.set_pendulum(height_.pendulum());
  com_des_ = dyn.com.head<2>();
  dcom_des_ = dyn.dcom.head<2>();
  dcom_expected_.setConstant(kNaN);
  trunk_task_.softness = 0.0;
  stand_on_known_ground();
  grip_.reset();
  for (const Side side : kSides) limits_.set_friction(side, grip_.friction(side));
  start_ = gait_input(0.0, com_des_, dcom_des_);
  gait_.reset(start_, height_.pendulum());
  arms_.reset();
  tracker_.reset();
  mailbox_.clear();
  VecX tau = std::move(out_.tau);
  out_ = CycleOutput{};
  out_.tau = std::move(tau);
  for (auto& pose : out_.foot) pose.setZero();
  const Vec3 forward = dyn.sole[kLeft].R_WF.col(0) + dyn.sole[kRight].R_WF.col(0);
  trunk_task_.R_HB = rotation_z(std::atan2(forward.y(), forward.x())).transpose() * dyn.R_WB;
  foresight_.reset(start_.R_sole);
  fall_.reset(trunk_task_.R_HB, z_c);
  body_.reset();
  added_.reset();
  whole_body_.reserve(added_);
  f_xy_.setZero();
  observer_.reset(dyn.dcom);
  attitude_.reset(dyn.R_WB);
}

void WalkingController::know(const KnownGround& ground) { told_ = ground; }

void WalkingController::stand_on_known_ground() {
  known_ = told_;
  stance_.ground = {};
  if (!known_.known()) {
    gait_.know(nullptr);
    return;
  }
  const auto& [left, right] = robot_.dynamics().sole;
  const double under = 0.5 * (known_.at(left.p_WF.head<2>()).height + known_.at(right.p_WF.head<2>()).height);
  if (std::isnan(under))
    throw InputError("the robot does not stand on the ground that is known: its soles are at (" +
                     text_of(left.p_WF.x()) + ", " + text_of(left.p_WF.y()) + ") m and (" + text_of(right.p_WF.x()) +
                     ", " + text_of(right.p_WF.y()) + ") m; let the ground reach under them");
  // Known heights count from the soles, whatever the world's origin is and however deep they sink in.
  known_.lift(height_.ground() - under);
  gait_.know(&known_);
}

const CycleOutput& WalkingController::update(const State& state) {
  clock_.require_started();
  require_state(state, robot_.nv());
  require_external(state.external);
  clock_.require(state.time);
  require_continuous(robot_, state, elapsed(state.time));
  out_.fresh = clock_.due(state.time);
  if (!out_.fresh) {
    clock_.hold(state.time);
    return out_;
  }
  state_.q = state.q;
  state_.dq = state.dq;
  robot_.read(believe() ? state_ : state);
  cycle(state);
  return out_;
}

const CycleOutput& WalkingController::update(const Data& data, Terms terms, const Sensed& sensed) {
  clock_.require_started();
  robot_.require_data(data);
  if (!robot_.is_finite(data)) throw InputError("data holds a position or velocity that is not finite");
  require_external(sensed.external);
  robot_.observe(data, state_);
  clock_.require(state_.time);
  require_continuous(robot_, state_, elapsed(state_.time));
  const bool due = clock_.due(state_.time);
  if (due && terms == Terms::kInData) robot_.require_computed(data);
  out_.fresh = due;
  if (due) {
    if (!believe() && terms == Terms::kInData)
      robot_.read_computed(data);
    else
      robot_.read(state_);
    static_cast<Sensed&>(state_) = sensed;
    // Contacts that the caller does not know are read from the last step. They are gone where mj_step1 has run.
    if (settings_.gait.touch_down != TouchDown::kTime && terms == Terms::kCompute) feel(measure_contact(robot_, data));
    cycle(state_);
  } else {
    clock_.hold(state_.time);
  }
  robot_.write_torque(out_.tau, data);
  return out_;
}

bool WalkingController::believe() { return attitude_.correct(state_.q.segment<4>(3), state_.dq.segment<3>(3)); }

void WalkingController::observe_disturbance() {
  const Dynamics& dyn = robot_.dynamics();
  const GaitOutput& gait = gait_.output();
  const bool frozen = out_.fell != Fall::kNone || out_.saturated;
  observer_.update(dyn.dcom, frozen);
  if (!frozen && gait.phase.phase == Phase::kSingleSupport)
    attitude_.look_for_bias(dyn.R_WB, dyn.sole[gait.support].R_WF.col(2), observer_.found().head<2>());
  robot_.apply_disturbance(observer_.disturbance());
  out_.disturbance = observer_.made_up_for();
  out_.attitude_bias = attitude_.bias();
}

void WalkingController::feel(const MeasuredContact& contact) {
  const Sensed felt = felt_by(contact);
  for (const Side side : kSides) {
    if (!std::isnan(state_.contact[side])) continue;
    state_.wrench[side] = felt.wrench[side];
    state_.contact[side] = felt.contact[side];
  }
}

void WalkingController::cycle(const State& state) {
  robot_.apply_external(state.external);
  observe_disturbance();
  const Dynamics& dyn = robot_.dynamics();
  const double t = clock_.since_start(state.time);
  clock_.tick(state.time);
  out_.t = state.time;
  if (out_.foreseen && settings_.fall.crouch) return crouch();

  // Where the walk is now, and where COM and feet are to go.
  const bool measured = settings_.com.state == ComState::kMeasured;
  const Vec2 com = measured ? Vec2(dyn.com.head<2>()) : com_des_,
             dcom = measured ? Vec2(dyn.dcom.head<2>()) : dcom_des_;
  const ForcedPendulum forced = forced_pendulum(dyn, ground_.height());
  if (height_.weigh(forced.gravity)) follow_pendulum();
  if (Vec3 live; mailbox_.take(live)) {
    out_.command_limit = bites_;
    if (live != out_.command) gait_.command(out_.command = live);
  }
  GaitInput in = gait_input(t, com + forced.shift, dcom);
  in.contact << state.contact[kLeft], state.contact[kRight];
  const GaitOutput& gait = gait_.update(in);
  ground_.update(gait, dyn, gait_.schedule().times().period());
  feel_grip(gait);
  // A force that has not lasted is over soon: the fall is foreseen without it.
  const Vec2 recent = recent_force();
  in.com -= (dyn.com.z() - ground_.height()) / forced.gravity * recent;
  out_.foreseen = foresight_.update(state.time, gait_, in, height_.pendulum());
  out_.fall_gap = foresight_.gap();
  if (height_.update(t, gait.stretch, gait_.plan(), reach_, gait_.cadence().slow.period(), lift_of(gait)))
    follow_pendulum();
  Cycle cycle = cycle_of(t, dyn, gait, height_.pendulum(), com, dcom, forced.shift);
  cycle.steadying = ground_.steadying(gait, dyn);

  // What the whole body is to do, apart from the COM's x and y.
  body_.update(t);
  added_.update({dyn, t, gait.heading, gait.v_plan.z()});
  command_tasks(cycle);
  stance_.standing = gait.standing;
  stance_.support = gait.support;
  if (gait.known)
    for (const Side side : kSides) stance_.ground[side] = gait.under[side].plane(gait.under[side].at.p);
  stance_.lateral << left_of(gait.ahead), 0.0;
  arms_.help(out_.limits.holds_yaw());
  if (arms_.on())
    arms_.command(dyn, robot_.torque_limit(), stance_, f_xy_, gait.v_plan.z(), body_.reference(), added_, whole_body_,
                  f_star_);
  whole_body_.prepare(dyn, stance_, f_star_, &added_);

  // III-C, (16) and III-B choose the COM's x and y by the ZMP that they lead to. (1)-(8) give the torque, (9)-(15) its ZMP.
  decide_reference(cycle);
  observer_.command({f_xy_.x(), f_xy_.y(), f_star_.com.z()});
  whole_body_.solve(f_xy_, result_);
  limit_torque(gait);
  // Nor does it explain what the COM does: a weak push would pass for a steady force, and after it the walk would not know that it was pushed.
  dcom_expected_ =
      dyn.dcom.head<2>() + settings_.control.dt * (horizontal_force(dyn, gait.standing) / dyn.mass - recent);
  note(cycle);
}

Vec2 WalkingController::recent_force() const {
  // On uneven ground the edges push, and what they add up to is no push from outside.
  if (ground_.uneven()) return Vec2::Zero();
  return observer_.made_up_for().head<2>() - observer_.steady();
}

void WalkingController::feel_grip(const GaitOutput& gait) {
  // A sole that rocks on uneven ground moves along it without slipping.
  const bool begins = ground_.uneven() && grip_.pace() == 1.0;
  if (!begins && grip_.update(gait, robot_.dynamics(), out_.f_c))
    for (const Side side : kSides) limits_.set_friction(side, grip_.friction(side));
  out_.friction = grip_.friction();
}

Vec2 WalkingController::horizontal_force(const Dynamics& dyn, const std::array<bool, 2>& standing) const {
  Vec2 force = dyn.F_ext.head<2>();
  for (const Side side : kSides)
    if (standing[side]) force -= out_.f_c.segment<2>(6 * side);
  return force;
}

void WalkingController::follow_pendulum() {
  reference_.set_pendulum(height_.pendulum());
  gait_.set_pendulum(height_.pendulum());
}

void WalkingController::command_tasks(const Cycle& cycle) {
  const Dynamics& dyn = robot_.dynamics();
  const GaitOutput& gait = *cycle.gait;
  const int n = dyn.joints();
  const MotionReference& ref = body_.reference();
  com_task_.p.z() = height_.z() + (ground_.height() - height_.ground());
  com_task_.v.z() = height_.dz() + ground_.drise();
  com_task_.a.z() = height_.ddz() + ground_.ddrise();
  f_star_.com.z() = com_task_.acceleration(dyn).z();
  trunk_task_.turn = turning(body_.at(n), body_.at(n + 1), body_.at(n + 2));
  Mat3 R_WH = Mat3::Identity();
  R_WH.topLeftCorner<2, 2>() = cycle.R_WH;
  soften_trunk(gait.urgency, R_WH);
  f_star_.trunk = trunk_task_.acceleration(dyn, R_WH, gait.v_plan.z());
  posture_task_.q = ref.q().head(n);
  posture_task_.dq = ref.dq().head(n);
  posture_task_.ddq = ref.ddq().head(n);
  posture_task_.acceleration(dyn, f_star_.posture);
  if (gait.phase.phase == Phase::kDoubleSupport) return;
  const SwingTarget& target = gait.swing_target;
  foot_task_.side = gait.swing;
  foot_task_.reference.p = target.p;
  foot_task_.reference.R = target.R;
  foot_task_.reference.velocity << target.v, target.omega;
  if (settings_.swing.feed_forward) foot_task_.reference.acceleration << target.a, target.alpha;
  f_star_.swing = foot_task_.acceleration(dyn);
}

void WalkingController::soften_trunk(double urgency, const Mat3& R_WH) {
  if (!settings_.trunk.yields || (urgency == 0.0 && trunk_task_.softness == 0.0)) return;
  // Times in T_c, so that every robot yields as the one for which they were found.
  constexpr double kRate = 0.55, kMost = 0.23, kHold = 3.6;
  constexpr double kNone = 1e-4;  // what is left of the softness is not worth a blend
  const double Tc = height_.pendulum().Tc();
  TrunkTask& trunk = trunk_task_;
  trunk.soft_rate = kRate / Tc;
  trunk.soft_most = kMost / (Tc * Tc);
  // Stiff gains would throw back a trunk that is still turned.
  constexpr double kUpright = 0.05;  // [rad]
  const bool back = trunk.softness == 0.0 || trunk.error(robot_.dynamics(), R_WH).norm() < kUpright;
  const double left = back ? trunk.softness * (1.0 - settings_.control.dt / (kHold * Tc)) : trunk.softness;
  // A force that goes on would tip a soft trunk over.
  const bool steady = !observer_.made_up_for().head<2>().isZero(0.0);
  trunk.softness = steady ? left : std::max(urgency, left);
  if (trunk.softness < kNone) trunk.softness = 0.0;
}

void WalkingController::decide_reference(const Cycle& cycle) {
  const GaitOutput& gait = *cycle.gait;
  const Reference r = reference_.decide(cycle, tracker_, whole_body_);
  f_xy_ = cycle.R_WS * r.f;
  com_des_ = cycle.to_W(r.x_d) - cycle.shift;
  dcom_des_ = cycle.R_WS * r.v_d;
  out_.zmp_des = cycle.to_W(r.zmp_des);
  out_.zmp_est = cycle.to_W(r.zmp_est);
  out_.zmp_ref = cycle.to_W(r.zmp_ref);
  out_.zmp_first.setConstant(kNaN);
  for (int i = 0; i < 2; ++i)
    if (r.modified[i] != 0.0) out_.zmp_first[i] = cycle.to_W(r.zmp_first)[i];
  out_.zmp_slope = r.zmp_slope;
  out_.zmp_modified = r.modified;
  out_.iterations = r.iterations;
  out_.com_des << com_des_, com_task_.p.z();
  out_.dcom_des << dcom_des_, com_task_.v.z();
  out_.v_des << cycle.R_WH.transpose() * dcom_des_, gait.v_plan.z();
  if (gait.at_rest || !std::isnan(gait.zmp_ahead))
    tracker_.reset();
  else
    tracker_.advance(out_.v_des.x(), gait.v_plan.x(), settings_.control.dt);
  out_.v_error_integral.x() = tracker_.integral();
}

void WalkingController::limit_torque(const GaitOutput& gait) {
  const VecX& limit = robot_.torque_limit();
  out_.torque_ratio = (result_.tau.cwiseAbs().array() / limit.array()).maxCoeff();
  out_.damped = result_.damped;
  out_.saturated = false;
  out_.limits = {};
  const bool keeps = settings_.limits.keep && whole_body_.is_direct();
  if (keeps && limits_.keep(robot_.dynamics(), stance_, result_)) out_.limits = limits_.active();
  if ((result_.tau.array().abs() > limit.array()).any() || !result_.tau.allFinite()) {
    cut_torque(gait);
    return;
  }
  out_.tau = result_.tau;
  out_.f_c = result_.f_c;
  if (out_.limits.any()) out_.zmp_est = whole_body_.zmp_of(result_.f_c);
}

void WalkingController::cut_torque(const GaitOutput& gait) {
  const VecX& limit = robot_.torque_limit();
  out_.tau = result_.tau.cwiseMax(-limit).cwiseMin(limit);
  out_.saturated = true;
  // The estimate is that of the torque that is sent, hence (9) of the cut torque.
  const Dynamics& dyn = robot_.dynamics();
  int rows = 0;
  for (const Side side : kSides) {
    if (!gait.standing[side]) continue;
    J_c_.middleRows<6>(rows) = dyn.sole[side].J;
    drift_c_.segment<6>(rows) = dyn.sole[side].drift;
    rows += 6;
  }
  estimator_.update(dyn.A, dyn.b, dyn.g, J_c_.topRows(rows), drift_c_.head(rows), whole_body_.feet(), gait.support);
  const ZmpEstimate cut = estimator_.estimate(out_.tau);
  out_.f_c = cut.f_c;
  out_.zmp_est = cut.zmp;
}

void WalkingController::note(const Cycle& cycle) {
  const GaitOutput& gait = *cycle.gait;
  out_.heading = gait.heading;
  out_.at_rest = gait.at_rest;
  out_.v_plan = gait.v_plan;
  out_.phase = static_cast<int>(gait.phase.phase);
  out_.support = static_cast<int>(side_sign(gait.support));
  out_.step = gait.phase.step;
  out_.phase_time = gait.phase.time;
  out_.ground = ground_.height();
  out_.uneven = ground_.uneven();
  out_.w_T = gait.w_T;
  out_.foothold << gait.foothold.p, gait.foothold.yaw;
  out_.zmp_lower = cycle.to_W(gait.room.lower);
  out_.zmp_upper = cycle.to_W(gait.room.upper);
  out_.zmp_plane << whole_body_.zmp_plane().normal, whole_body_.zmp_plane().offset;
  note_body();
}

void WalkingController::note_body() {
  const Dynamics& dyn = robot_.dynamics();
  out_.com = dyn.com;
  out_.dcom = dyn.dcom;
  for (const Side side : kSides) {
    const Eigen::Quaterniond q(dyn.sole[side].R_WF);
    out_.foot[side] << dyn.sole[side].p_WF, q.w(), q.x(), q.y(), q.z();
  }
  // Over known ground a foot is lifted onto the next tread, and may stand far over the other one.
  const double highest = std::max(dyn.sole[kLeft].p_WF.z(), dyn.sole[kRight].p_WF.z());
  const Fall fall = fall_.check(dyn, gait_.output().known ? ground_.height() : highest);
  if (!out_.tau.allFinite()) {
    out_.fell = Fall::kNonFinite;
    out_.tau.setZero();
  } else if (fall != Fall::kNone) {
    out_.fell = fall;
  }
}

void WalkingController::crouch() {
  out_.torque_ratio = crouch_.crouch_torque(robot_.dynamics(), out_.tau);
  out_.saturated = out_.torque_ratio > 1.0;
  // Nothing else is decided any more.
  out_.zmp_des = out_.zmp_ref = out_.zmp_est = out_.zmp_lower = out_.zmp_upper = Vec2::Constant(kNaN);
  out_.zmp_first = Vec2::Constant(kNaN);
  out_.zmp_modified.setZero();
  out_.iterations = 0;
  out_.com_des = out_.dcom_des = out_.foothold = Vec3::Constant(kNaN);
  out_.v_plan = out_.v_des = Vec3::Zero();
  out_.f_c.setConstant(kNaN);
  out_.w_T = out_.fall_gap = kNaN;
  out_.damped = out_.at_rest = false;
  note_body();
}

}  // namespace zmpwalk
