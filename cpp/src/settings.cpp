#include "zmpwalk/settings.hpp"

#include <algorithm>
#include <cmath>

#include "zmpwalk/gait/pendulum.hpp"
#include "zmpwalk/math/error.hpp"

namespace zmpwalk {
namespace {

// The robot on which the gains were found: COM height 0.747 m, period 0.8 s (section IV), T_c 0.276 s.
constexpr double kReferenceHeight = 0.747;
constexpr double kReferencePeriod = 0.8;

template <class Enum, std::size_t N>
std::string name_of(Enum value, const std::array<std::pair<Enum, const char*>, N>& names) {
  for (const auto& [v, name] : names)
    if (v == value) return name;
  return "?";
}

template <class Enum, std::size_t N>
Enum value_of(const std::string& name, const std::array<std::pair<Enum, const char*>, N>& names, const char* what) {
  std::string known;
  for (const auto& [v, n] : names) {
    if (name == n) return v;
    known += std::string(known.empty() ? "" : ", ") + n;
  }
  throw InputError(std::string(what) + " = '" + name + "' is unknown; there are: " + known);
}

constexpr std::array<std::pair<Footsteps, const char*>, 5> kFootsteps{{{Footsteps::kTied, "tied"},
                                                                       {Footsteps::kAbsolute, "absolute"},
                                                                       {Footsteps::kPaper, "paper"},
                                                                       {Footsteps::kPrinted, "printed"},
                                                                       {Footsteps::kList, "list"}}};
constexpr std::array<std::pair<ComState, const char*>, 2> kComState{
    {{ComState::kMeasured, "measured"}, {ComState::kDesired, "desired"}}};
constexpr std::array<std::pair<TrackerLaw, const char*>, 2> kTracker{
    {{TrackerLaw::kSmooth, "smooth"}, {TrackerLaw::kBangBang, "bang_bang"}}};
constexpr std::array<std::pair<Iteration, const char*>, 3> kIteration{
    {{Iteration::kClosedForm, "closed_form"}, {Iteration::kLoop, "loop"}, {Iteration::kNone, "none"}}};

}  // namespace

std::string to_string(Footsteps value) { return name_of(value, kFootsteps); }
std::string to_string(ComState value) { return name_of(value, kComState); }
std::string to_string(TrackerLaw value) { return name_of(value, kTracker); }
std::string to_string(Iteration value) { return name_of(value, kIteration); }
void from_string(const std::string& name, Footsteps& out) { out = value_of(name, kFootsteps, "footsteps"); }
void from_string(const std::string& name, ComState& out) { out = value_of(name, kComState, "com_state"); }
void from_string(const std::string& name, TrackerLaw& out) { out = value_of(name, kTracker, "tracker"); }
void from_string(const std::string& name, Iteration& out) { out = value_of(name, kIteration, "iteration"); }

const std::vector<double>& paper_step_lengths() {
  static const std::vector<double> lengths{0.1, 0.15, 0.2};
  return lengths;
}

const std::vector<double>& printed_step_lengths() {
  static const std::vector<double> lengths{0.1, 0.15, 0.2, 0.25};
  return lengths;
}

WalkSettings::WalkSettings(const std::string& preset) : law(preset) {
  if (preset == "default") return;
  if (preset != "paper") throw InputError("law = '" + preset + "' is unknown; there are: default, paper");
  tracker = TrackerLaw::kBangBang;
  iteration = Iteration::kLoop;
  com_state = ComState::kDesired;
  feed_forward = false;
  lateral_feedback = false;
  bound_lateral = false;
  footsteps = Footsteps::kPaper;
  step_lengths = paper_step_lengths();
  load_alone = 0.0;
  cadence_exponent = cadence_double = sole_exponent = 0.0;
  crouch_limit = 0.0;
  stand = false;
  rate_limit = false;
  // (8) alone lags by one cycle of k_d, so it needs stiffer gains than a law with feed-forward.
  com_x_kp = 400.0;
  com_x_kd = 40.0;
  com_y_kp = 1e4;
  com_y_kd = 200.0;
}

double knee_share(const RobotScale& robot, const WalkSettings& s, double lift, double speed) {
  if (!(robot.knee_per_lift > 0.0)) return 0.0;
  const double half = 0.5 * s.T_ss, T = s.T_ss + s.T_ds, x = 0.5 * speed * (T + s.T_ds);
  const double ddl = 6.0 * lift / (half * half) + x / robot.hip_to_ankle * 12.0 * speed * T / (s.T_ss * s.T_ss);
  const double dl = 1.5 * lift / half;
  return robot.knee_per_lift * (robot.knee_armature * ddl + robot.knee_damping * dl) / robot.knee_torque;
}

WalkSettings resolve(const WalkSettings& settings, const RobotScale& robot, double top_speed) {
  WalkSettings s = settings;
  const double Tc = LinearInvertedPendulum(robot.com_height, robot.gravity).Tc();
  const double Tc_ref = LinearInvertedPendulum(kReferenceHeight, 9.81).Tc();
  const auto fill = [](double& value, double from_robot) {
    if (std::isnan(value)) value = from_robot;
  };
  // Time scales with T_c: k_p with 1/T_c^2, k_d with 1/T_c; periods are kept to hundredths of a second.
  const double period = std::round(100.0 * kReferencePeriod * std::sqrt(robot.com_height / kReferenceHeight)) / 100.0;
  const double rate = Tc_ref / Tc;
  fill(s.control_dt, robot.timestep);
  fill(s.T_ds, 0.2 * period);
  fill(s.T_ss, 0.8 * period);
  require_positive("T_ds", s.T_ds);
  require_positive("T_ss", s.T_ss);
  fill(s.T_ds_first,
       LinearInvertedPendulum(robot.com_height, robot.gravity).first_double_support(s.T_ds + s.T_ss, s.T_ss));
  const double speed = std::sqrt(robot.gravity * robot.com_height);  // Froude number 1
  fill(s.cadence_speed, 0.1 * speed);
  fill(s.cadence_turning, 0.54 * robot.com_height);
  fill(s.closing_reach, 0.1 * robot.com_height);
  fill(s.forward_jump, 0.036 * speed);
  fill(s.sideways_jump, 0.03 * speed);
  fill(s.turning_jump, 0.07 / Tc);
  fill(s.forward_acceleration, 0.02 * robot.gravity);
  fill(s.forward_deceleration, 0.056 * robot.gravity);
  fill(s.sideways_acceleration, 0.025 * robot.gravity);
  fill(s.turning_acceleration, 0.08 / (Tc * Tc));
  fill(s.crouch_limit, 0.1 * robot.com_height);
  fill(s.crouch_time, 0.5 * Tc);
  fill(s.foot_clearance, 0.03 * robot.com_height);
  fill(s.tracker_gain, 1.38 / Tc);
  fill(s.tracker_time, 0.18 * Tc);
  fill(s.tracker_reach, 0.03 * speed);
  const auto gains = [&](double& kp, double& kd, double kp_ref, double kd_ref) {
    fill(kp, kp_ref * rate * rate);
    fill(kd, kd_ref * rate);
  };
  gains(s.com_x_kp, s.com_x_kd, 100.0, 20.0);
  gains(s.com_y_kp, s.com_y_kd, 100.0, 20.0);
  gains(s.com_z_kp, s.com_z_kd, 200.0, 28.0);
  gains(s.trunk_kp, s.trunk_kd, 300.0, 35.0);
  gains(s.swing_kp, s.swing_kd, 3600.0, 120.0);
  gains(s.posture_kp, s.posture_kd, 100.0, 20.0);
  gains(s.momentum_kp, s.momentum_kd, 20.0, 20.0);
  fill(s.motion_blend, 1.8 * Tc);
  fill(s.step_width, robot.foot_distance);
  // Rotor and damping take at most this share of the knee's torque, as long as that leaves a step of the least height.
  constexpr double kKneeShare = 0.6, kLeastHeight = 0.01;
  const double per_lift = knee_share(robot, s, 1.0, 0.0), left = kKneeShare - knee_share(robot, s, 0.0, top_speed);
  const double knee_lift =
      per_lift > 0.0 ? std::max(left / per_lift, kLeastHeight * robot.com_height) : robot.com_height;
  fill(s.step_height, std::min(0.0535 * robot.com_height, knee_lift));
  fill(s.foothold_reach, 0.25 * robot.com_height);
  fill(s.com_lead, 0.0134 * robot.com_height);
  fill(s.foothold_time, 0.18 * Tc);
  fill(s.capture_reach, 0.07 * robot.com_height);
  fill(s.capture_speed, 0.2 * speed);
  if (s.footsteps == Footsteps::kPaper) s.step_lengths = paper_step_lengths();
  if (s.footsteps == Footsteps::kPrinted) s.step_lengths = printed_step_lengths();
  if (s.footsteps == Footsteps::kTied) s.step_lengths.clear();
  fill(s.cadence_exponent, s.step_lengths.empty() ? 0.4 : 0.0);

  if (s.first_swing != "right" && s.first_swing != "left")
    throw InputError("first_swing = '" + s.first_swing + "' is unknown; there are: right, left");
  if (s.footsteps == Footsteps::kList && s.step_lengths.empty())
    throw InputError("footsteps = 'list' needs step_lengths, for example [0.1, 0.15, 0.2]");
  for (const double length : s.step_lengths) require_finite("step_lengths", length);
  for (const auto& [joint, limit] : s.torque_limits) require_positive(("torque_limits." + joint).c_str(), limit);
  const double ratio = s.control_dt / robot.timestep;
  if (!(ratio > 0.5) || std::abs(ratio - std::round(ratio)) > 1e-6)
    throw InputError("control_dt = " + std::to_string(s.control_dt) +
                     " s; it must be a multiple of the model's time step, " + std::to_string(robot.timestep) + " s");
  for (const auto& [name, value] : {std::pair<const char*, double>{"T_ds_first", s.T_ds_first},
                                    {"tracker_gain", s.tracker_gain},
                                    {"tracker_time", s.tracker_time},
                                    {"zmp_threshold", s.zmp_threshold},
                                    {"sole_fraction", s.sole_fraction},
                                    {"ankle_torque_fraction", s.ankle_torque_fraction},
                                    {"step_width", s.step_width},
                                    {"step_height", s.step_height},
                                    {"foothold_time", s.foothold_time},
                                    {"cadence_speed", s.cadence_speed},
                                    {"crouch_time", s.crouch_time},
                                    {"forward_acceleration", s.forward_acceleration},
                                    {"forward_deceleration", s.forward_deceleration},
                                    {"sideways_acceleration", s.sideways_acceleration},
                                    {"turning_acceleration", s.turning_acceleration},
                                    {"motion_blend", s.motion_blend},
                                    {"friction_velocity", s.friction_velocity},
                                    {"fall_height", s.fall_height},
                                    {"fall_tilt", s.fall_tilt},
                                    {"fall_foot_tilt", s.fall_foot_tilt},
                                    {"singular_damping", s.singular_damping}})
    require_positive(name, value);
  if (s.momentum_arms > 1.0)
    throw InputError("momentum_arms = " + std::to_string(s.momentum_arms) + "; it must be in 0..1");
  if (s.max_iterations < 1)
    throw InputError("max_iterations = " + std::to_string(s.max_iterations) + "; it must be at least 1");
  visit_settings(s, [](const char* name, auto& value, const char*, const char*) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>)
      if (!(value >= 0.0) || !std::isfinite(value))
        throw InputError(std::string(name) + " = " + std::to_string(value) + "; it must be finite and not negative");
  });
  return s;
}

}  // namespace zmpwalk
