#include "zmpwalk/walk/walking_controller.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "zmpwalk/control/momentum.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/math/rotation.hpp"
#include "zmpwalk/robot/robot_names.hpp"
#include "zmpwalk/zmp/reference_iteration.hpp"

namespace zmpwalk {
namespace {

double stand_height(const Dynamics& dyn) {
  return dyn.com.z() - 0.5 * (dyn.sole[kLeft].p_WF.z() + dyn.sole[kRight].p_WF.z());
}

RobotScale scale_of(const Robot& robot) {
  const Dynamics& dyn = robot.dynamics();
  const RobotLeg leg = robot.leg_at_stand(kLeft);
  RobotScale scale{stand_height(dyn), dyn.gravity.norm(), robot.model()->opt.timestep,
                   (dyn.sole[kLeft].p_WF - dyn.sole[kRight].p_WF).head<2>().norm()};
  // Law of cosines over hip, knee and ankle: d(length)/d(angle) = thigh shank sin(angle) / length.
  const double length = leg.hip_to_ankle.norm();
  const double cosine =
      (length * length - leg.thigh * leg.thigh - leg.shank * leg.shank) / (2.0 * leg.thigh * leg.shank);
  const int dof = robot.dof_address() + 6 + leg.knee;
  scale.hip_to_ankle = length;
  scale.knee_per_lift = length / (leg.thigh * leg.shank * std::sqrt(std::max(1.0 - cosine * cosine, 1e-4)));
  scale.knee_armature = robot.model()->dof_armature[dof];
  scale.knee_damping = robot.model()->dof_damping[dof];
  scale.knee_torque = robot.torque_limit()[leg.knee];
  return scale;
}

RobotDescription with_limits(RobotDescription description, const std::map<std::string, double>& limits) {
  for (const auto& [joint, limit] : limits) description.torque_limits[joint] = limit;
  return description;
}

SoleSize sole_of(const RobotDescription& description) {
  const auto& [left, right] = description.feet;
  return {std::max(left.length, right.length), std::min(left.width, right.width)};
}

std::string text_of(const Vec3& v) {
  return std::to_string(v.x()) + " m/s, " + std::to_string(v.y()) + " m/s, " + std::to_string(v.z()) + " rad/s";
}

double top_speed(const VelocityProfile& profile) {
  double top = 0.0;
  for (const Vec3& v : profile.v()) top = std::max(top, v.x());
  return top;
}

ZmpBounds bounds_of(const Robot& robot, Side side, const WalkSettings& settings) {
  const Foot& foot = robot.description().feet[side];
  const auto& leg = robot.leg_joints()[side];
  const Vec3 ankle = robot.ankle_in_sole(side);
  const Dynamics& dyn = robot.dynamics();
  const int pitch = robot.pitch_joint(side, 4, 6);
  const int roll = leg[4] == pitch ? leg[5] : leg[4];
  const SoleLimits limits{foot.length, foot.width, ankle.head<2>(), robot.torque_limit()[pitch],
                          robot.torque_limit()[roll]};
  return zmp_bounds(limits, dyn.mass * dyn.gravity.norm(), settings.zmp.sole_fraction,
                    settings.zmp.ankle_torque_fraction);
}

constexpr std::array<const char*, 3> kTrunkNames{"trunk_roll", "trunk_pitch", "trunk_yaw"};

}  // namespace

WalkingController::WalkingController(const mjModel* model, const RobotDescription& description,
                                     const WalkSettings& settings, const VelocityProfile& profile)
    : robot_(model, with_limits(description, settings.control.torque_limits)),
      reference_((VecX(robot_.joints() + 3) << robot_.stand(), Vec3::Zero()).finished()),
      profile_(profile),
      com_height_(stand_height(robot_.dynamics())),
      sole_(sole_of(description)),
      settings_(resolve(settings, scale_of(robot_), top_speed(profile))),
      pendulum_(com_height_, robot_.dynamics().gravity.norm()),
      bounds_{bounds_of(robot_, kLeft, settings_), bounds_of(robot_, kRight, settings_)},
      gait_(settings_, profile_, sole_, bounds_),
      tracker_(settings_.tracking.law, settings_.tracking.gain, settings_.tracking.time, settings_.tracking.deadband,
               settings_.tracking.catch_up_speed),
      whole_body_(robot_.nv(), robot_.leg_joints(),
                  {settings_.control.textbook, settings_.posture.task, settings_.contact.wrench_distribution,
                   settings_.contact.load_alone * 0.5 * sole_.width, settings_.contact.damping,
                   settings_.control.singular_damping, settings_.control.singular_pivot, settings_.control.kernel}),
      estimator_(robot_.nv()),
      hip_turn_(robot_.hip_turn()),
      R_HB_(Mat3::Identity()),
      kp_(settings_.com.kp_x, settings_.com.kp_y),
      kd_(settings_.com.kd_x, settings_.com.kd_y),
      R_S_(Mat2::Identity()),
      R_H_(Mat2::Identity()),
      swinging_(robot_.arm_joints()),
      c_(VecX::Zero(robot_.nv())),
      result_(whole_body_.result()),
      J_c_(RowMatX::Zero(12, robot_.nv())),
      drift_c_(VecX::Zero(12)) {
  if (model->opt.disableflags & (mjDSBL_CONTACT | mjDSBL_CONSTRAINT))
    throw ModelError("the model's option flags switch contacts off; walking needs them");
  if (settings_.arms.momentum > 0.0 && (swinging_.empty() || !settings_.posture.task))
    throw InputError("momentum_arms = " + std::to_string(settings_.arms.momentum) +
                     " needs the posture task and joints outside the legs that carry less than a fifth of the robot; 0 "
                     "does without");
  robot_.friction_velocity = settings_.control.friction_velocity;
  ticks_per_cycle_ = static_cast<int>(std::lround(settings_.control.dt / model->opt.timestep));
  f_star_.posture = VecX::Zero(robot_.joints());
  out_.tau = VecX::Zero(robot_.joints());
  for (auto& pose : out_.foot) pose.setZero();
  set_height(0.0);
  const Dynamics& dyn = robot_.dynamics();
  ground_ = dyn.com.z() - com_height_;
  start_ = gait_input(0.0, dyn.com.head<2>(), dyn.dcom.head<2>());
  check_profile();
}

GaitInput WalkingController::gait_input(double t, const Vec2& com, const Vec2& dcom) const {
  const auto& [left, right] = robot_.dynamics().sole;
  return {t,
          com,
          dcom,
          {left.p_WF, right.p_WF},
          {left.R_WF, right.R_WF},
          tracker_.catch_up(gait_.output().orbit_ahead),
          ground_};
}

WalkPlan WalkingController::plan(double duration, double dt) const {
  WalkSettings settings = settings_;
  settings.control.dt = dt;
  require_positive("dt", dt);
  return plan_walk(settings, profile_, pendulum_, bounds_, sole_, start_, duration);
}

double WalkingController::reach(double crouch) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Side side : kSides) {
    const RobotLeg leg = robot_.leg_at_stand(side);
    const double length_2 = leg.thigh * leg.thigh + leg.shank * leg.shank +
                            2.0 * leg.thigh * leg.shank * std::cos(settings_.com.least_knee);
    const double height = std::abs(leg.hip_to_ankle.y()) - crouch;
    least = std::min(least, std::sqrt(std::max(length_2 - height * height, 0.0)) - std::abs(leg.hip_to_ankle.x()));
  }
  return std::max(least, 0.0);
}

double WalkingController::stride(const Vec3& velocity) const {
  const StepTimes times = gait_.cadence().times(velocity);
  const double along = 0.5 * (times.period() + times.T_ds) * velocity.x(), aside = times.period() * velocity.y();
  return std::hypot(along, aside);
}

double WalkingController::reach_share(const Vec3& velocity) const {
  const StepTimes times = gait_.cadence().times(velocity);
  const double turn = 0.5 * (times.period() + times.T_ds) * velocity.z();
  return std::max(stride(velocity) / reach(settings_.com.crouch_limit), std::abs(turn) / hip_turn_);
}

double WalkingController::crouch_for(double stride) const {
  const double wanted = settings_.com.crouch_margin * stride;
  if (wanted <= reach(0.0)) return 0.0;
  double less = 0.0, enough = settings_.com.crouch_limit;
  for (int i = 0; i < 12; ++i) {
    const double middle = 0.5 * (less + enough);
    (reach(middle) >= wanted ? enough : less) = middle;
  }
  return enough;
}

void WalkingController::set_height(double crouch) {
  pendulum_ = LinearInvertedPendulum(com_height_ - crouch, robot_.dynamics().gravity.norm());
  const double dt = settings_.control.dt, Tc = pendulum_.Tc();
  for (int i = 0; i < 2; ++i)
    df_dr_[i] = (settings_.com.feed_forward ? -1.0 / (Tc * Tc) : 0.0) -
                pd_acceleration(kp_[i], kd_[i], std::cosh(dt / Tc) - 1.0, std::sinh(dt / Tc) / Tc);
}

void WalkingController::move_height(double t, double stretch) {
  // Ahead of the speed by a step, or for where the feet are to stand; critically damped.
  const VelocityProfile& plan = gait_.plan();
  const double ahead = gait_.cadence().slow.period(), rate = 1.0 / settings_.com.crouch_time, dt = settings_.control.dt;
  const double wanted = crouch_for(std::max({stride(plan.velocity(t)), stride(plan.velocity(t + ahead)), stretch}));
  if (wanted == 0.0 && crouch_ == 0.0) return;
  ddcrouch_ = rate * (rate * (wanted - crouch_) - 2.0 * dcrouch_);
  crouch_ += dcrouch_ * dt;
  dcrouch_ += ddcrouch_ * dt;
  if (wanted == 0.0 && std::abs(crouch_) < 1e-6 && std::abs(dcrouch_) < 1e-6) crouch_ = dcrouch_ = ddcrouch_ = 0.0;
  set_height(crouch_);
  gait_.set_pendulum(pendulum_);
}

Vec3 WalkingController::within_reach(const Vec3& velocity) const {
  if (reach_share(velocity) <= 1.0) return velocity;
  double possible = 0.0, impossible = 1.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (possible + impossible);
    (reach_share(middle * velocity) <= 1.0 ? possible : impossible) = middle;
  }
  return possible * velocity;
}

void WalkingController::command(const Vec3& velocity) {
  if (!velocity.allFinite())
    throw InputError("command (" + text_of(velocity) + ") is not finite; it is (v_x, v_y, w_z) [m/s, m/s, rad/s]");
  mailbox_.put(within_reach(velocity));
}

double WalkingController::knee_share(double speed) const {
  return zmpwalk::knee_share(scale_of(robot_), settings_, settings_.swing.height, speed);
}

void WalkingController::check_profile() const {
  for (const Vec3& v : profile_.v())
    if (reach_share(v) > 1.0)
      throw InputError("the profile asks for (v_x, v_y, w_z) = (" + text_of(v) +
                       "); this robot's legs reach as far as (" + text_of(within_reach(v)) + ") at a step period of " +
                       std::to_string(gait_.cadence().times(v).period()) + " s, and " + std::to_string(speed_limit()) +
                       " m/s straight ahead");
  // From a stand, the COM may not run away from the first stance foot before the second stands.
  const double room = reach(0.0);
  if (start_excursion(1.0) <= room) return;
  if (start_excursion(0.0) > room)
    throw InputError("the COM would run " + std::to_string(start_excursion(0.0)) +
                     " m away even at rest, the legs reach " + std::to_string(room) +
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
                   " would do, or a gentler ramp");
}

double WalkingController::start_excursion(double scale) const {
  // The pendulum under the smooth tracker, its ZMP held inside the bounds of the foot that carries it, up to the second lift-off.
  const VelocityProfile& plan = gait_.plan();
  const double dt = settings_.control.dt, period = settings_.gait.T_ds + settings_.gait.T_ss;
  const double t_end = settings_.gait.T_ds_first + period, t_switch = t_end - 0.5 * settings_.gait.T_ds;
  const double foothold =
      scale * (plan.displacement(0.0, t_switch) + 0.5 * plan.displacement(t_switch, t_switch + period)).x();
  VelocityTracker tracker(TrackerLaw::kSmooth, settings_.tracking.gain, settings_.tracking.time,
                          settings_.tracking.deadband);
  const Dynamics& dyn = robot_.dynamics();
  const Vec3 middle = 0.5 * (dyn.sole[kLeft].p_WF + dyn.sole[kRight].p_WF);
  const double x_0 = (dyn.com - middle).head<2>().norm();
  PendulumState s{x_0, 0.0};
  for (double t = 0.0; t < t_end; t += dt) {
    const double v_plan = scale * plan.velocity(t).x(), foot = t < t_switch ? 0.0 : foothold;
    const double wanted = pendulum_.reference_for(s.x, tracker.acceleration(v_plan, s.v));
    const double r = std::clamp(wanted, foot + bounds_[kLeft].lower.x(), foot + bounds_[kLeft].upper.x());
    s = pendulum_.step(dt, s, r);
    tracker.advance(s.v, v_plan, dt);
  }
  return s.x - x_0;
}

double WalkingController::plan_mismatch(double duration) const {
  return gait_.footsteps().mismatch(duration, gait_.cadence());
}

void WalkingController::reset(const mjData* data) {
  robot_.require_data(data);
  if (!robot_.is_finite(data))
    throw InputError("data holds a position or velocity that is not finite; place the robot first");
  robot_.read(data);
  const Dynamics& dyn = robot_.dynamics();
  t_start_ = data->time;
  tick_ = 0;
  ground_ = dyn.com.z() - stand_height(dyn);
  com_height_ = stand_height(dyn);
  crouch_ = dcrouch_ = ddcrouch_ = 0.0;
  set_height(0.0);
  com_des_ = dyn.com.head<2>();
  dcom_des_ = dyn.dcom.head<2>();
  start_ = gait_input(0.0, com_des_, dcom_des_);
  gait_.reset(start_, pendulum_);
  tracker_.reset();
  Vec3 stale;
  mailbox_.take(stale);
  VecX tau = std::move(out_.tau);
  out_ = CycleOutput{};
  out_.tau = std::move(tau);
  for (auto& pose : out_.foot) pose.setZero();
  const Vec3 forward = dyn.sole[kLeft].R_WF.col(0) + dyn.sole[kRight].R_WF.col(0);
  R_HB_ = rotation_z(std::atan2(forward.y(), forward.x())).transpose() * dyn.R_WB;
  for (const Side side : kSides) up_[side] = dyn.sole[side].R_WF.col(2);
  reference_.reset();
  added_.reset();
  whole_body_.reserve(added_);
  f_xy_.setZero();
  started_ = true;
}

int WalkingController::coordinate(const std::string& name) const {
  std::string known;
  for (int j = 0; j < robot_.joints(); ++j) {
    if (robot_.is_leg_joint(j)) {
      if (robot_.joint_names()[j] == name)
        throw InputError("the motion moves '" + name + "', a joint of a leg: the walk moves those");
      continue;
    }
    if (robot_.joint_names()[j] == name) return j;
    known += robot_.joint_names()[j] + ", ";
  }
  for (int i = 0; i < 3; ++i)
    if (name == kTrunkNames[i]) return robot_.joints() + i;
  throw InputError("the motion moves '" + name + "', which this robot does not have; there are: " + known +
                   "trunk_roll, trunk_pitch, trunk_yaw");
}

void WalkingController::move(const JointMotion& motion) {
  if (!settings_.posture.task && !motion.names().empty())
    throw InputError("posture_task is off: nothing would follow a motion");
  std::vector<int> entry;
  for (const std::string& name : motion.names()) {
    const int i = coordinate(name);
    const double tilt = 0.5 * settings_.fall.tilt;
    const auto [low, high] = i < robot_.joints() ? robot_.joint_range(i) : std::make_pair(-tilt, tilt);
    const JointMotion::Extent extent = motion.extent(static_cast<int>(entry.size()));
    const bool below = extent.low < low;
    if (below || extent.high > high)
      throw InputError("the motion brings '" + name + "' to " + std::to_string(below ? extent.low : extent.high) +
                       " rad at t = " + std::to_string(below ? extent.t_low : extent.t_high) + " s; its range is " +
                       std::to_string(low) + " to " + std::to_string(high) +
                       " rad, between the knots of the spline too");
    entry.push_back(i);
  }
  reference_.start(motion, std::move(entry), settings_.posture.motion_blend);
  swinging_.clear();
  for (const int j : robot_.arm_joints())
    if (!reference_.names(j)) swinging_.push_back(j);
}

void WalkingController::add(const std::shared_ptr<Task>& task, double blend) {
  NamesOfRobot names(robot_);
  task->attach(names);
  added_.add(task, robot_.nv(), std::isnan(blend) ? settings_.posture.motion_blend : blend);
  whole_body_.reserve(added_);
}

void WalkingController::remove(const Task& task, double blend) {
  added_.remove(task, std::isnan(blend) ? settings_.posture.motion_blend : blend);
  whole_body_.reserve(added_);
}

void WalkingController::set_external(const std::vector<ExternalWrench>& external) {
  for (const ExternalWrench& each : external) {
    if (!each.wrench.allFinite()) throw InputError("an external force or moment is not finite");
    if (each.frame < 0 || each.frame >= static_cast<int>(robot_.dynamics().frames.size()))
      throw InputError("an external force acts at frame " + std::to_string(each.frame) + ", which is not watched");
  }
  external_ = external;
}

const CycleOutput& WalkingController::update(mjData* data, Terms terms) {
  if (!started_) throw InputError("update was called before reset(data)");
  robot_.require_data(data);
  if (!robot_.is_finite(data)) throw InputError("data holds a position or velocity that is not finite");
  const bool fresh = tick_ % ticks_per_cycle_ == 0;
  if (fresh && terms == Terms::kInData) robot_.require_computed(data);
  out_.fresh = fresh;
  ++tick_;
  if (!out_.fresh) {
    robot_.write_torque(out_.tau, data);
    return out_;
  }
  if (terms == Terms::kInData)
    robot_.read_computed(data);
  else
    robot_.read(data);
  robot_.apply_external(external_);
  const Dynamics& dyn = robot_.dynamics();
  const double t = data->time - t_start_;
  const bool measured = settings_.com.state == ComState::kMeasured;
  shift_ = forced_pendulum(dyn, ground_).shift;

  const GaitInput in = gait_input(t, Vec2((measured ? Vec2(dyn.com.head<2>()) : com_des_) + shift_),
                                  measured ? Vec2(dyn.dcom.head<2>()) : dcom_des_);
  if (Vec3 live; mailbox_.take(live) && live != out_.command) gait_.command(out_.command = live);
  const GaitOutput& gait = gait_.update(in);
  move_height(t, gait.stretch);
  R_S_ = rotation_z(gait.yaw).topLeftCorner<2, 2>();
  R_H_ = rotation_z(gait.heading).topLeftCorner<2, 2>();
  const auto to_S = [&](const Vec2& p) { return Vec2(R_S_.transpose() * p); };
  x_ = to_S(in.com - gait.origin);
  v_ = to_S(in.dcom);
  x_meas_ = to_S(dyn.com.head<2>() + shift_ - gait.origin);
  v_meas_ = to_S(dyn.dcom.head<2>());

  out_.t = data->time;
  out_.com = dyn.com;
  out_.dcom = dyn.dcom;
  out_.heading = gait.heading;
  out_.at_rest = gait.at_rest;
  out_.v_plan = gait.v_plan;
  out_.phase = static_cast<int>(gait.phase.phase);
  out_.support = static_cast<int>(side_sign(gait.support));
  out_.step = gait.phase.step;
  out_.phase_time = gait.phase.time;
  out_.w_T = gait.w_T;
  out_.foothold << gait.foothold.p, gait.foothold.yaw;
  for (const Side side : kSides) {
    const Eigen::Quaterniond q(dyn.sole[side].R_WF);
    out_.foot[side] << dyn.sole[side].p_WF, q.w(), q.x(), q.y(), q.z();
  }

  reference_.update(t);
  added_.update({dyn, t, gait.heading, gait.v_plan.z()});
  task_accelerations(gait);
  stance_.standing = gait.standing;
  stance_.support = gait.support;
  stance_.lateral << -std::sin(gait.heading), std::cos(gait.heading), 0.0;
  if (settings_.arms.momentum > 0.0) swing_arms(gait);
  whole_body_.prepare(dyn, stance_, f_star_, &added_);
  choose_reference(gait);
  whole_body_.solve(f_xy_, result_);
  out_.f_c = result_.f_c;
  out_.damped = result_.damped;
  clip_torque(gait);
  check_fall(gait);
  robot_.write_torque(out_.tau, data);
  return out_;
}

void WalkingController::task_accelerations(const GaitOutput& gait) {
  const Dynamics& dyn = robot_.dynamics();
  const WalkSettings& s = settings_;
  f_star_.com.z() =
      pd_acceleration(s.com.kp_z, s.com.kd_z, ground_ + com_height_ - crouch_ - dyn.com.z(), -dcrouch_ - dyn.dcom.z()) -
      ddcrouch_;
  const int n = dyn.joints();
  const auto& [q_ref, dq_ref, ddq_ref] = std::tie(reference_.q(), reference_.dq(), reference_.ddq());
  const auto angle = [&](int i) { return Motion1{q_ref[n + i], dq_ref[n + i], ddq_ref[n + i]}; };
  const Turning trunk = turning(angle(0), angle(1), angle(2));
  const Mat3 R_WH = rotation_z(gait.heading);
  const Vec3 heading_rate(0.0, 0.0, gait.v_plan.z());
  f_star_.trunk = R_WH * trunk.alpha + heading_rate.cross(R_WH * trunk.omega);
  f_star_.trunk += pd_acceleration(s.trunk.kp, s.trunk.kd, orientation_error(R_WH * trunk.R * R_HB_, dyn.R_WB),
                                   Vec3(R_WH * trunk.omega + heading_rate - dyn.omega_WB));
  f_star_.posture = ddq_ref.head(n);
  f_star_.posture +=
      pd_acceleration(s.posture.kp, s.posture.kd, q_ref.head(n) - dyn.q, dq_ref.head(n) - dyn.dq.tail(n));
  if (gait.phase.phase == Phase::kDoubleSupport) return;
  const FrameState& sole = dyn.sole[gait.swing];
  const SwingTarget& target = gait.swing_target;
  Vec6 error, rate;
  error << target.p - sole.p_WF, orientation_error(target.R, sole.R_WF);
  rate << target.v, target.omega;
  f_star_.swing = pd_acceleration(s.swing.kp, s.swing.kd, error, Vec6(rate - sole.velocity));
  if (s.swing.feed_forward) {
    f_star_.swing.head<3>() += target.a;
    f_star_.swing.tail<3>() += target.alpha;
  }
}

void WalkingController::swing_arms(const GaitOutput& gait) {
  // dL_z = c_a ddq_a + what the rest does while the arms keep their speed; the arms cancel the latter and bring L_z to zero
  // with k_d: ddq_a = -c_a+ dL_rest + k_d (-c_a+ L_rest - dq_a) + k_p (q_ref - q_a).
  const Dynamics& dyn = robot_.dynamics();
  const double kp = settings_.arms.kp, kd = settings_.arms.kd;
  for (const int j : swinging_) f_star_.posture[j] = 0.0;
  whole_body_.prepare(dyn, stance_, f_star_, &added_);
  momentum_row(dyn, Vec3::UnitZ(), c_.transpose());
  // A robot that turns as planned keeps the momentum of turning as one body.
  double L_rest = c_.dot(dyn.dq) - gait.v_plan.z() * c_.segment<3>(3).dot(dyn.R_WB.row(2)), square = 0.0;
  for (const int j : swinging_) {
    L_rest -= c_[6 + j] * dyn.dq[6 + j];
    square += c_[6 + j] * c_[6 + j];
  }
  if (!(square > 0.0)) return;
  const double dL_rest = whole_body_.yaw_moment(f_xy_), share = -settings_.arms.momentum / square;
  for (const int j : swinging_) {
    const double q = dyn.q[j], dq = dyn.dq[6 + j], c_inv = share * c_[6 + j];
    const double ddq = reference_.ddq()[j] + c_inv * dL_rest +
                       pd_acceleration(kp, kd, reference_.q()[j] - q, reference_.dq()[j] + c_inv * L_rest - dq);
    // A limit is approached as a critically damped joint would.
    const auto [low, high] = robot_.joint_range(j);
    f_star_.posture[j] = std::clamp(ddq, kd * (0.25 * kd * (low - q) - dq), kd * (0.25 * kd * (high - q) - dq));
  }
}

WalkingController::Desired WalkingController::desired(const Vec2& r) const {
  Desired c;
  const double dt = settings_.control.dt;
  for (int i = 0; i < 2; ++i) {
    const PendulumState next = pendulum_.step(dt, {x_[i], v_[i]}, r[i]);
    c.x_d[i] = next.x;
    c.v_d[i] = next.v;
    c.f[i] = (settings_.com.feed_forward ? pendulum_.acceleration(x_[i], r[i]) : 0.0) +
             pd_acceleration(kp_[i], kd_[i], next.x - x_meas_[i], next.v - v_meas_[i]);
  }
  return c;
}

void WalkingController::choose_reference(const GaitOutput& gait) {
  const double dt = settings_.control.dt;
  const auto to_W = [&](const Vec2& p) { return Vec2(gait.origin + R_S_ * p); };
  const auto estimate_of = [&](const Vec2& f) {
    return Vec2(R_S_.transpose() * (whole_body_.zmp(R_S_ * f) - gait.origin));
  };

  // What velocity tracking alone asks for.
  const bool smooth = tracker_.law() == TrackerLaw::kSmooth && settings_.zmp.modification;
  const Vec2 com = gait.origin + R_S_ * x_, dcom = R_S_ * v_;
  Vec2 r = R_S_.transpose() * (reference_zmp(gait, pendulum_, tracker_, com, dcom) - gait.origin);
  // Without III-B nobody asks the whole body: the ZMP is where the pendulum has it.
  const bool estimates = settings_.zmp.iteration != Iteration::kNone;
  Desired c = desired(r);
  if (!smooth && !gait.at_rest) {  // the desired velocity is the planned one, which stands: nothing to feed forward
    const double v_plan = (R_S_.transpose() * R_H_ * gait.v_plan.head<2>()).x();
    c.x_d.x() = x_.x() + v_plan * dt;
    c.v_d.x() = v_plan;
    c.f.x() = pd_acceleration(kp_.x(), kd_.x(), c.x_d.x() - x_meas_.x(), c.v_d.x() - v_meas_.x());
    r.x() = estimates ? 0.0 : pendulum_.reference_for(x_.x(), c.f.x());
  }
  Vec2 zmp = estimates ? estimate_of(c.f) : r;
  Vec2 wanted = zmp;

  const ZmpBounds& bounds = gait.room;
  if (settings_.zmp.modification) {
    const Vec2 inside = bounds.clamp(zmp);
    wanted.x() = inside.x();
    if (settings_.zmp.bound_lateral) wanted.y() = inside.y();
    if (tracker_.drive() == Drive::kLower) wanted.x() = bounds.lower.x();
    if (tracker_.drive() == Drive::kUpper) wanted.x() = bounds.upper.x();
  }
  out_.zmp_modified.setZero();
  Vec2 axes = Vec2::Zero();
  for (int i = 0; i < 2; ++i)
    if (wanted[i] != zmp[i]) {
      axes[i] = 1.0;
      out_.zmp_modified[i] = wanted[i] == bounds.lower[i] ? -1.0 : 1.0;
    }
  const Mat2 slope = R_S_.transpose() * whole_body_.zmp_slope() * R_S_ * df_dr_.asDiagonal();
  out_.zmp_slope = slope.diagonal();
  out_.zmp_first.setConstant(kNaN);
  out_.iterations = 0;
  Vec2 reference = r;
  if (!smooth && axes.x() == 0.0) reference.x() = zmp.x();  // tracking: no pendulum along x
  if (axes.any()) {
    // An axis that is left alone keeps its command.
    const Vec2 kept = c.f;
    const auto estimate = [&](const Vec2& r_ref) {
      const Vec2 f = axes.cwiseProduct(desired(r_ref).f) + (Vec2::Ones() - axes).cwiseProduct(kept);
      return estimate_of(f);
    };
    const Vec2 first = estimate(axes.cwiseProduct(wanted) + (Vec2::Ones() - axes).cwiseProduct(r));
    const ReferenceResult found =
        !estimates
            ? ReferenceResult{Vec2(axes.cwiseProduct(wanted) + (Vec2::Ones() - axes).cwiseProduct(r)), first, 1, false}
        : settings_.zmp.iteration == Iteration::kLoop
            ? iterate_reference(estimate, wanted, r, axes, settings_.zmp.threshold, settings_.zmp.max_iterations)
            : solve_reference(estimate, wanted, r, axes, slope, settings_.zmp.threshold);
    const Desired modified = desired(found.zmp_ref);
    for (int i = 0; i < 2; ++i) {
      if (axes[i] == 0.0) continue;
      c.x_d[i] = modified.x_d[i];
      c.v_d[i] = modified.v_d[i];
      c.f[i] = modified.f[i];
      reference[i] = found.zmp_ref[i];
      out_.zmp_first[i] = to_W(first)[i];
    }
    zmp = found.zmp_est;
    out_.iterations = found.passes;
  }

  f_xy_ = R_S_ * c.f;
  out_.zmp_des = to_W(axes.cwiseProduct(wanted) + (Vec2::Ones() - axes).cwiseProduct(estimates ? zmp : r));
  out_.zmp_est = to_W(estimates ? zmp : estimate_of(c.f));
  out_.zmp_ref = to_W(reference);
  out_.zmp_lower = to_W(bounds.lower);
  out_.zmp_upper = to_W(bounds.upper);
  com_des_ = to_W(c.x_d) - shift_;
  dcom_des_ = R_S_ * c.v_d;
  out_.com_des << com_des_, ground_ + com_height_ - crouch_;
  out_.dcom_des << dcom_des_, -dcrouch_;
  out_.v_des << R_H_.transpose() * dcom_des_, gait.v_plan.z();
  if (gait.at_rest)
    tracker_.reset();
  else
    tracker_.advance(out_.v_des.x(), gait.v_plan.x(), dt);
  out_.v_error_integral.x() = tracker_.integral();
}

void WalkingController::clip_torque(const GaitOutput& gait) {
  const VecX& limit = robot_.torque_limit();
  out_.torque_ratio = (result_.tau.cwiseAbs().array() / limit.array()).maxCoeff();
  out_.saturated = !(out_.torque_ratio <= 1.0);
  out_.tau = result_.tau.cwiseMax(-limit).cwiseMin(limit);
  if (!out_.saturated) return;
  // The estimate speaks of the torque that is sent: (9) with the cut torque.
  const Dynamics& dyn = robot_.dynamics();
  int rows = 0;
  for (const Side side : kSides) {
    if (!gait.standing[side]) continue;
    J_c_.middleRows<6>(rows) = dyn.sole[side].J;
    drift_c_.segment<6>(rows) = dyn.sole[side].drift;
    rows += 6;
  }
  estimator_.update(dyn.A, dyn.b, dyn.g, J_c_.topRows(rows), drift_c_.head(rows), gait.standing,
                    {dyn.sole[kLeft].p_WF, dyn.sole[kRight].p_WF}, gait.support);
  const ZmpEstimate cut = estimator_.estimate(out_.tau);
  out_.f_c = cut.f_c;
  out_.zmp_est = cut.zmp;
}

void WalkingController::check_fall(const GaitOutput& gait) {
  const Dynamics& dyn = robot_.dynamics();
  const double height = dyn.com.z() - std::max(dyn.sole[kLeft].p_WF.z(), dyn.sole[kRight].p_WF.z());
  const double tilt = std::acos(std::clamp((dyn.R_WB * R_HB_.transpose())(2, 2), -1.0, 1.0));
  if (!out_.tau.allFinite()) {
    out_.fell = Fall::kNonFinite;
    out_.tau.setZero();
  } else if (height < settings_.fall.height * com_height_) {
    out_.fell = Fall::kHeight;
  } else if (tilt > settings_.fall.tilt) {
    out_.fell = Fall::kTilt;
  } else if (gait.phase.phase == Phase::kSingleSupport &&
             dyn.sole[gait.support].R_WF.col(2).dot(up_[gait.support]) < std::cos(settings_.fall.foot_tilt)) {
    out_.fell = Fall::kFootTipped;
  }
}

}  // namespace zmpwalk
