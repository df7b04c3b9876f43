#include "zmpwalk/settings/settings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "zmpwalk/gait/pendulum.hpp"
#include "zmpwalk/math/error.hpp"

namespace zmpwalk {
namespace {

// The robot on which the gains were found: COM height 0.747 m, period 0.8 s (section IV), T_c 0.276 s.
constexpr double kReferenceHeight = 0.747;
constexpr double kReferencePeriod = 0.8;

/// The largest number that makes sense in a unit. Far beyond it sums overflow and loops do not end.
double largest(const std::string& unit) {
  static const std::map<std::string, double> most{{"m", 10.0},      {"s", 100.0},   {"rad", 100.0},
                                                  {"m/s", 100.0},   {"rad/s", 1e3}, {"m/s^2", 1e4},
                                                  {"rad/s^2", 1e5}, {"", 1e5},      {"N m", 1e9}};
  const auto found = most.find(unit);
  return found == most.end() ? 1e9 : found->second;
}

std::string number_of(double value) { return text_of(value); }
std::string number_of(int value) { return std::to_string(value); }

template <class Number>
void check(const std::string& name, Number value, const Setting& row) {
  if (!row.range.holds(value)) throw InputError(name + " = " + number_of(value) + "; it must be " + row.range.text);
  if (const double most = largest(row.unit); std::abs(static_cast<double>(value)) > most)
    throw InputError(name + " = " + number_of(value) + "; it must be at most " + text_of(most) +
                     (*row.unit ? " " : "") + row.unit);
}

/// Checks every number of a setting.
template <class T>
void check_all(const T& value, const Setting& row) {
  if constexpr (std::is_same_v<T, double> || std::is_same_v<T, int>)
    check(row.both_names(), value, row);
  else if constexpr (std::is_same_v<T, std::vector<double>>)
    for (const double x : value) check(row.both_names(), x, row);
  else if constexpr (std::is_same_v<T, std::map<std::string, double>>)
    for (const auto& [key, x] : value) check(row.path() + "." + key, x, row);
}

}  // namespace

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
  if (preset != "paper") throw InputError(no_such_word("law", preset, {"default", "paper"}));
  tracking.law = chosen<TrackerLawName>("tracking.law", "bang_bang");
  zmp.iteration = Iteration::kLoop;
  zmp.lateral_law = chosen<LateralLawName>("zmp.lateral_law", "paper");
  observer.on = false;
  zmp.bound_lateral = false;
  zmp.sole_exponent = 0.0;
  com.state = ComState::kDesired;
  com.feed_forward = false;
  com.crouch_limit = 0.0;
  // (8) alone lags by one cycle of k_d, so it needs stiffer gains than a law with feed-forward.
  com.kp_x = 400.0;
  com.kd_x = 40.0;
  com.kp_y = 1e4;
  com.kd_y = 200.0;
  steps.mode = Footsteps::kPaper;
  steps.lengths = paper_step_lengths();
  gait.cadence_exponent = gait.cadence_double = 0.0;
  gait.stand = false;
  contact.load_alone = 0.0;
  limits.keep = false;
  rate.limit = false;
}

std::string Default::text() const {
  if (std::isnan(factor_)) return of_.name;
  std::string number = std::to_string(factor_);
  number.erase(number.find_last_not_of('0') + 1);
  if (number.back() == '.') number.pop_back();
  return number + " " + of_.name;
}

Scale::Scale(const RobotScale& of, const WalkSettings& so_far, double v)
    : robot(of),
      settings(so_far),
      top_speed(v),
      Tc(LinearInvertedPendulum(of.com_height, of.gravity).Tc()),
      speed(std::sqrt(of.gravity * of.com_height)),
      period(std::round(100.0 * kReferencePeriod * std::sqrt(of.com_height / kReferenceHeight)) / 100.0),
      rate(LinearInvertedPendulum(kReferenceHeight, 9.81).Tc() / Tc) {}

double knee_share(const RobotScale& robot, const WalkSettings& s, double lift, double speed) {
  if (!(robot.knee_per_lift > 0.0)) return 0.0;
  const double T_ss = s.gait.T_ss, half = 0.5 * T_ss, T = T_ss + s.gait.T_ds, x = 0.5 * speed * (T + s.gait.T_ds);
  const double ddl = 6.0 * lift / (half * half) + x / robot.hip_to_ankle * 12.0 * speed * T / (T_ss * T_ss);
  const double dl = 1.5 * lift / half;
  return robot.knee_per_lift * (robot.knee_armature * ddl + robot.knee_damping * dl) / robot.knee_torque;
}

namespace defaults {

double time_step(double, const Scale& scale) { return scale.robot.timestep; }

double first_double_support(double, const Scale& scale) {
  const auto& [T_ds, T_ss] = std::tie(scale.settings.gait.T_ds, scale.settings.gait.T_ss);
  return LinearInvertedPendulum(scale.robot.com_height, scale.robot.gravity).first_double_support(T_ds + T_ss, T_ss);
}

double cadence_exponent(double, const Scale& scale) { return scale.settings.steps.lengths.empty() ? 0.4 : 0.0; }

double feet_apart(double, const Scale& scale) { return scale.robot.foot_distance; }

double friction(double, const Scale& scale) { return scale.robot.friction; }

double step_height(double, const Scale& scale) {
  // Rotor and damping of the knee may take this share of its torque; the step height is lowered for that, but not below the least height.
  constexpr double kKneeShare = 0.6, kLeastHeight = 0.01;
  const RobotScale& robot = scale.robot;
  const double per_lift = knee_share(robot, scale.settings, 1.0, 0.0),
               left = kKneeShare - knee_share(robot, scale.settings, 0.0, scale.top_speed);
  const double knee_lift =
      per_lift > 0.0 ? std::max(left / per_lift, kLeastHeight * robot.com_height) : robot.com_height;
  return std::min(0.0535 * robot.com_height, knee_lift);
}

}  // namespace defaults

WalkSettings resolve(const WalkSettings& settings, const RobotScale& robot, double top_speed) {
  WalkSettings s = settings;
  if (s.steps.mode == Footsteps::kPaper) s.steps.lengths = paper_step_lengths();
  if (s.steps.mode == Footsteps::kPrinted) s.steps.lengths = printed_step_lengths();
  if (s.steps.mode == Footsteps::kTied) s.steps.lengths.clear();
  if (s.steps.mode == Footsteps::kList && s.steps.lengths.empty())
    throw InputError(
        "steps.mode (footsteps) = 'list' needs steps.lengths (step_lengths), for example [0.1, 0.15, 0.2]");
  const Scale scale(robot, s, top_speed);
  visit_settings(s, [&](auto& value, const Setting& row) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>)
      if (std::isnan(value) && row.default_value.from_robot()) value = row.default_value.value(scale);
    check_all(value, row);
  });
  for (const auto& [name, share] : {std::pair("zmp.sole_fraction (sole_fraction)", s.zmp.sole_fraction),
                                    std::pair("zmp.whole_fraction (whole_sole_fraction)", s.zmp.whole_fraction)})
    if (share > 1.0)
      throw InputError(std::string(name) + " = " + text_of(share) + "; it is a share of the sole, at most 1");
  if (s.swing.height > robot.com_height || s.steps.width > 4.0 * robot.com_height)
    throw InputError("swing.height (step_height) = " + text_of(s.swing.height) +
                     " m, steps.width (step_width) = " + text_of(s.steps.width) +
                     " m; they are at most once and four times the COM's height, " + text_of(robot.com_height) + " m");
  const double ratio = s.control.dt / robot.timestep;
  if (!(ratio > 0.5) || std::abs(ratio - std::round(ratio)) > 1e-6)
    throw InputError("control.dt (control_dt) = " + std::to_string(s.control.dt) +
                     " s; it must be a multiple of the model's time step, " + std::to_string(robot.timestep) + " s");
  return s;
}

}  // namespace zmpwalk
