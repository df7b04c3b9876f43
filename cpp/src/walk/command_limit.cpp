#include "zmpwalk/walk/command_limit.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <memory>

#include "zmpwalk/control/momentum.hpp"
#include "zmpwalk/gait/forward_orbit.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/math/rotation.hpp"

namespace zmpwalk {
namespace {

constexpr double kPeak =
    0.95;  // share of a torque limit that a steady step may ask for: what the walk adds takes the rest
constexpr double kSwingPeak =
    1.25;  // the same in the air, where the torque peaks for an instant and a foot that lags does no harm
constexpr double kOnTheSpot =
    1.1;  // what a robot that steps on the spot asks for already, and a little more, is no question of speed
constexpr int kNewton = 15;      // steps of the inverse kinematics
constexpr double kClose = 1e-6;  // residual at which it ends [m, rad]
constexpr double kTurn =
    0.8;  // a step turns by less: beyond it the plan, straight within a step, is no longer the walk [rad]
constexpr double kArmSwing = 0.5;  // how far an arm's joint swings to either side at most [rad]
constexpr int kBisections = 9;
constexpr double kAtLimit = 1e-9;  // a velocity this near to its limit is at the limit

/// What a velocity asks for, as shares of what there is.
struct Demand {
  double share = 0.0;
  SpeedLimit limit = SpeedLimit::kNone;
  int joint = -1;
  void take(double other, SpeedLimit what, int of = -1) {
    if (other > share) *this = {other, what, of};
  }
};

/// One robot in instants of a steady step, its left foot standing.
class Step {
 public:
  Step(const Robot& robot, const WalkSettings& settings, const Cadence& cadence, const LegReach& reach,
       const SoleSize& sole, const ZmpBounds& bounds, double z_c)
      : robot_(robot.model(), robot.description()),
        settings_(settings),
        cadence_(cadence),
        reach_(reach),
        sole_(sole),
        bounds_(bounds),
        middle_(place_with_room({bounds, bounds}, sole.length, 0.0)),
        z_c_(z_c),
        friction_(settings.limits.friction),
        whole_body_(robot.nv(), robot.leg_joints()),
        result_(whole_body_.result()),
        state_(robot.nv()) {
    robot_.friction_velocity = settings.control.friction_velocity;
    const Dynamics& dyn = robot_.dynamics();
    start_q_.resize(robot.nv() + 1);
    start_q_ = robot_.qpos();
    for (const Side side : kSides) sole_start_[side] = dyn.sole[side];
    f_star_.posture = VecX::Zero(robot.joints());
    c_ = VecX::Zero(robot.nv());
    for (int i = 0; i < 3; ++i) unknown_[i] = i;
    for (const Side side : kSides)
      for (int i = 0; i < 6; ++i) unknown_[3 + 6 * side + i] = 6 + robot.leg_joints()[side][i];
  }

  Demand demand(const Vec3& v) {
    Demand out;
    const StepTimes times = cadence_.times(v);
    const double T = times.period(), half = 0.5 * times.T_ss, crouch = reach_.crouch_for(reach_.stride(v));
    const double gravity = robot_.dynamics().gravity.norm(), height = z_c_ - crouch;
    const LinearInvertedPendulum pendulum(height, gravity);
    const double Tc = pendulum.Tc(), W = settings_.steps.width;
    const double pace = std::pow(cadence_.pace(v), settings_.zmp.sole_exponent);
    const double roll = pace * std::max(bounds_.upper.x() - middle_, middle_ - bounds_.lower.x());
    const ForwardOrbit orbit(pendulum, v.x(), T, roll);
    const double lift = settings_.swing.height, inset = 0.5 * W / std::cosh(0.5 * T / Tc);
    for (const double at : {-1.0, 0.0, 1.0}) {  // lift-off, middle, landing
      // Ahead the COM is on its orbit over the foot that stands, sideways it sways about it.
      const double t = at * half, turned = v.z() * t;
      const double x = v.x() * t + orbit.ahead(t), y = -inset * std::cosh(t / Tc);
      const Vec2 dcom(orbit.velocity(x), -inset * std::sinh(t / Tc) / Tc);
      const Vec2 zmp(middle_ + std::clamp(x - Tc * Tc * orbit.acceleration(x), -roll, roll), 0.0);
      out.take(std::abs(v.z()) * T / kTurn, SpeedLimit::kReach);
      // The foot in the air goes by cubic splines, from rest to rest; on a curve it stands turned by w_z T where it leaves and where it lands.
      const double T_ss = times.T_ss, yaw = at * v.z() * T;
      const Vec3 way(2.0 * v.x() * T + W * std::sin(v.z() * T), 2.0 * std::abs(v.y()) * T, 2.0 * v.z() * T);
      const Vec3 place(0.5 * at * way.x(), -0.5 * W * (1.0 + std::cos(yaw)) + 0.5 * at * way.y(),
                       at == 0.0 ? lift : 0.0);
      Vec6 velocity = Vec6::Zero(), acceleration = Vec6::Zero();
      if (at == 0.0) velocity << 1.5 / T_ss * way.head<2>(), 0, 0, 0, 1.5 / T_ss * way.z();
      acceleration << -6.0 * at / (T_ss * T_ss) * way.head<2>(), 6.0 * lift / (half * half), 0, 0,
          -6.0 * at / (T_ss * T_ss) * way.z();
      if (at == 0.0) acceleration.z() *= -1.0;
      if (!pose({middle_ + x, y, height}, dcom, place, velocity, {turned, yaw, v.z()}) || !in_range()) {
        out.take(2.0, SpeedLimit::kReach);
        continue;
      }
      f_star_.swing = acceleration;
      Stance stance;
      stance.standing = {true, false};
      stance.support = kLeft;
      const Dynamics& dyn = robot_.dynamics();
      whole_body_.prepare(dyn, stance, f_star_);
      const Vec2 origin = dyn.sole[kLeft].p_WF.head<2>();
      const Vec2 f_xy = whole_body_.zmp_slope().inverse() * (origin + zmp - whole_body_.zmp(Vec2::Zero()));
      whole_body_.solve(f_xy, result_);
      judge(zmp, T, out);
    }
    return out;
  }

 private:
  /// How far trunk and foot in the air are turned from the foot that stands, and how fast the trunk turns.
  struct Turn {
    double trunk, foot, rate;  // [rad, rad, rad/s]
  };

  /// Brings COM and soles to their places, from the start pose; false where they are out of reach.
  bool pose(const Vec3& com, const Vec2& dcom, const Vec3& place, const Vec6& velocity, const Turn& turn) {
    using Rows = Eigen::Matrix<double, 15, 15>;
    using Vec15 = Eigen::Matrix<double, 15, 1>;
    const Vec3 stands = sole_start_[kLeft].p_WF;
    const Mat3 R_S = rotation_z(yaw_of(sole_start_[kLeft].R_WF));  // the walk goes where the left foot points
    state_.q = start_q_;
    state_.dq.setZero();
    const Eigen::Quaterniond trunk = Eigen::Quaterniond(rotation_z(turn.trunk)) *
                                     Eigen::Quaterniond(start_q_[3], start_q_[4], start_q_[5], start_q_[6]);
    state_.q.segment<4>(3) << trunk.w(), trunk.x(), trunk.y(), trunk.z();
    const Mat3 R_foot = rotation_z(turn.foot);
    Rows J;
    Vec15 off;
    for (int i = 0;; ++i) {
      robot_.read(state_);
      const Dynamics& dyn = robot_.dynamics();
      for (const Side side : kSides) {
        const FrameState& sole = dyn.sole[side];
        const Vec3 wanted = side == kLeft ? stands : Vec3(stands + R_S * place);
        off.segment<3>(6 * side) = wanted - sole.p_WF;
        const Mat3& level = sole_start_[side].R_WF;
        off.segment<3>(6 * side + 3) = orientation_error(side == kLeft ? level : Mat3(R_foot * level), sole.R_WF);
        for (int k = 0; k < 15; ++k) J.block<6, 1>(6 * side, k) = sole.J.col(unknown_[k]);
      }
      off.tail<3>() = stands + R_S * com - dyn.com;
      for (int k = 0; k < 15; ++k) J.block<3, 1>(12, k) = dyn.J_com.col(unknown_[k]);
      const double error = off.cwiseAbs().maxCoeff();
      if (!std::isfinite(error) || i == kNewton) return false;
      if (error < kClose) break;
      Vec15 step = J.partialPivLu().solve(off);
      step *= std::min(1.0, 0.3 / std::max(step.cwiseAbs().maxCoeff(), 1e-12));
      state_.q.head<3>() += step.head<3>();
      for (int k = 3; k < 15; ++k) state_.q[unknown_[k] + 1] += step[k];
    }
    // The trunk's turning moves COM and soles along.
    state_.dq.segment<3>(3) = robot_.dynamics().R_WB.transpose() * Vec3(0, 0, turn.rate);
    robot_.read(state_);
    const Dynamics& dyn = robot_.dynamics();
    for (const Side side : kSides)
      off.segment<6>(6 * side) = -dyn.sole[side].J.middleCols<3>(3) * state_.dq.segment<3>(3);
    off.tail<3>() = -dyn.J_com.middleCols<3>(3) * state_.dq.segment<3>(3);
    off.segment<3>(6) += R_S * velocity.head<3>();
    off.segment<3>(9) += velocity.tail<3>();
    off.segment<2>(12) += R_S.topLeftCorner<2, 2>() * dcom;
    const Vec15 dq = J.partialPivLu().solve(off);
    for (int k = 0; k < 15; ++k) state_.dq[unknown_[k]] = dq[k];
    robot_.read(state_);
    return dq.allFinite();
  }

  bool in_range() const {
    for (const Side side : kSides)
      for (const int j : robot_.leg_joints()[side]) {
        const auto [low, high] = robot_.joint_range(j);
        const double q = robot_.dynamics().q[j];
        if (q < low || q > high) return false;
      }
    return true;
  }

  void judge(const Vec2& zmp, double period, Demand& out) {
    const VecX& limit = robot_.torque_limit();
    for (const Side side : kSides) {
      const auto& leg = robot_.leg_joints()[side];
      const double peak = side == kLeft ? kPeak : kSwingPeak;
      // What the ankles of the foot that stands can give bounds its ZMP already; in the air an ankle that lags only tilts the foot.
      for (int i = 0; i < 4; ++i)
        out.take(std::abs(result_.tau[leg[i]]) / (peak * limit[leg[i]]), i < 3 ? SpeedLimit::kHip : SpeedLimit::kKnee,
                 leg[i]);
    }
    const Vec3 F = result_.f_c.segment<3>(0), M = result_.f_c.segment<3>(3);
    const double load = -F.z();
    if (!(load > 0.0)) return out.take(2.0, SpeedLimit::kFriction);
    const Mat2 R_S = axes_of(ahead_of(yaw_of(sole_start_[kLeft].R_WF)));
    const Vec2 r = R_S * zmp;
    const double moment = std::abs(M.z() - (r.x() * F.y() - r.y() * F.x())), pull = F.head<2>().norm() / load;
    out.take(pull / friction_, SpeedLimit::kFriction);
    // Arms that come to help cancel what their torque and their room let them.
    double arms = 0.0;
    if (settings_.posture.task && settings_.arms.reserve > 0.0) {
      const Dynamics& dyn = robot_.dynamics();
      momentum_row(dyn, Vec3::UnitZ(), c_.transpose());
      const double rate = M_PI / period;
      for (const int j : robot_.arm_joints()) {
        const auto [low, high] = robot_.joint_range(j);
        const double room = std::clamp(std::min(high - dyn.q[j], dyn.q[j] - low), 0.0, kArmSwing);
        arms += std::abs(c_[6 + j]) * std::min(0.5 * limit[j] / dyn.A(6 + j, 6 + j), room * rate * rate);
      }
    }
    const double turning = std::max((1.0 - settings_.arms.reserve) * moment, moment - arms);
    // What of the friction the pull leaves works at the arm by which the load lies from the ZMP, when the corners carry it.
    const double left = std::sqrt(std::max(1.0 - std::pow(pull / friction_, 2), 0.01));
    out.take(turning / load / (friction_ * left * arm(zmp)), SpeedLimit::kYawFriction);
  }

  /// Mean distance from the ZMP of the sole's corners, which share the load so that it lies at the ZMP [m].
  double arm(const Vec2& zmp) const {
    const double a = 0.5 * sole_.length, w = 0.5 * sole_.width;
    double mean = 0.0;
    for (const double x : {-a, a})
      for (const double y : {-w, w})
        mean += 0.25 * (1.0 + zmp.x() / x) * (1.0 + zmp.y() / y) * std::hypot(x - zmp.x(), y - zmp.y());
    return mean;
  }

  Robot robot_;
  WalkSettings settings_;
  Cadence cadence_;
  const LegReach& reach_;
  SoleSize sole_;
  ZmpBounds bounds_;
  double middle_;  // over which the COM rides, as in GaitGenerator: the ZMP has room ahead and behind [m]
  double z_c_, friction_;
  WholeBodyController whole_body_;
  WholeBodyResult result_;
  State state_;
  TaskAccelerations f_star_;
  VecX start_q_, c_;  // c: row of the yaw momentum
  std::array<FrameState, 2> sole_start_;
  std::array<int, 15> unknown_{};
};

}  // namespace

CommandLimit::CommandLimit(const Robot& robot, const WalkSettings& settings, const Cadence& cadence,
                           const LegReach& reach, const SoleSize& sole, const ZmpBounds& bounds, double z_c)
    : on_(settings.command.limit), reach_(reach) {
  constexpr double kTooFast = 10.0;  // no biped's walk [m/s, rad/s]
  const std::array<Vec3, 4> directions{Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  std::unique_ptr<Step> step;
  double allowed = settings.command.share;
  if (on_) {
    step = std::make_unique<Step>(robot, settings, cadence, reach, sole, bounds, z_c);
    allowed = std::max(allowed, kOnTheSpot * step->demand(Vec3::Zero()).share);
  }
  for (int i = 0; i < 4; ++i) {
    AxisLimit& axis = axes_[i];
    axis.most = reach.within(kTooFast * directions[i]).norm();
    axis.limit = SpeedLimit::kReach;
    if (!on_) continue;
    double possible = 0.0, impossible = axis.most;
    Demand demand = step->demand(impossible * directions[i]);
    if (demand.share <= allowed) continue;
    for (int k = 0; k < kBisections; ++k) {
      const double middle = 0.5 * (possible + impossible);
      const Demand at = step->demand(middle * directions[i]);
      if (at.share <= allowed) {
        possible = middle;
      } else {
        impossible = middle;
        demand = at;
      }
    }
    axis.most = possible;
    axis.limit = demand.limit;
    if (demand.joint >= 0) axis.joint = robot.joint_names()[demand.joint];
  }
}

double CommandLimit::share(const Vec3& velocity) const {
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
    if (velocity[i] != 0.0) sum += std::abs(velocity[i]) / axis(i, velocity[i]).most;
  return sum;
}

Vec3 CommandLimit::within(const Vec3& velocity, SpeedLimit* limit) const {
  Vec3 out = velocity;
  SpeedLimit bites = SpeedLimit::kNone;
  if (const double whole = on_ ? share(velocity) : 0.0; whole >= 1.0 - kAtLimit) {
    if (whole > 1.0 + kAtLimit) out /= whole;
    double most = 0.0;
    for (int i = 0; i < 3; ++i) {
      const AxisLimit& each = axis(i, velocity[i]);
      if (const double part = std::abs(velocity[i]) / each.most; part > most) {
        most = part;
        bites = each.limit;
      }
    }
  }
  out = reach_.within(out);
  if (reach_.share(out) >= 1.0 - kAtLimit) bites = SpeedLimit::kReach;
  if (limit) *limit = bites;
  return out;
}

void CommandLimit::require_within(const VelocityProfile& profile) const {
  for (const Vec3& v : profile.v())
    if (on_ && share(v) > 1.0 + kAtLimit) {
      SpeedLimit bites;
      const Vec3 possible = within(v, &bites);
      throw InputError("the profile asks for (v_x, v_y, w_z) = (" + velocity_text(v) + "); the " + to_string(bites) +
                       " allows (" + velocity_text(possible) +
                       "). A larger command.share, or command.limit = false, lets it try");
    }
  reach_.require_within(profile);
}

std::string to_string(const AxisLimit& axis) {
  return axis.joint.empty() ? to_string(axis.limit) : "torque of " + axis.joint;
}

}  // namespace zmpwalk
