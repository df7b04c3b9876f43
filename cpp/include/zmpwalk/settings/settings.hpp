#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include "zmpwalk/settings/table.hpp"

namespace zmpwalk {

/// Every gain, bound and switch of the walk, in groups. `table.hpp` says what each is for.
///
/// SI units. Not-a-number means "from the robot": `resolve` fills it in when a controller is made.
struct WalkSettings {
  /// @param law  preset, "default" or "paper" (the literal law of the paper); everything can be set afterwards
  /// @throws InputError  unknown preset
  explicit WalkSettings(const std::string& law = "default");

  std::string law;

  GaitSettings gait;
  StepsSettings steps;
  SwingSettings swing;
  ComSettings com;
  ZmpSettings zmp;
  TrackingSettings tracking;
  RateSettings rate;
  TrunkSettings trunk;
  PostureSettings posture;
  ArmsSettings arms;
  ContactSettings contact;
  ControlSettings control;
  LimitsSettings limits;
  ObserverSettings observer;
  CommandSettings command;
  FallSettings fall;
};

/// Calls `v(group)` for every group of `s`.
template <class Settings, class Visitor>
void visit_groups(Settings& s, Visitor&& v) {
  v(s.gait), v(s.steps), v(s.swing), v(s.com), v(s.zmp), v(s.tracking), v(s.rate), v(s.trunk), v(s.posture), v(s.arms),
      v(s.contact), v(s.control), v(s.limits), v(s.observer), v(s.command), v(s.fall);
}

/// Calls `v(member, row)` for every setting of a group.
template <class Group, class Visitor>
void visit_group(Group& group, Visitor&& v) {
  group.rows(group, [&](auto& member, const char* name, const char* flat, const char* unit, const Range& range,
                        const Default& default_value, const char* meaning) {
    v(member, Setting{group.kGroup, name, flat, unit, range, default_value, meaning});
  });
}

/// Calls `v(member, row)` for every setting of `s`, group by group.
template <class Settings, class Visitor>
void visit_settings(Settings& s, Visitor&& v) {
  visit_groups(s, [&](auto& group) { visit_group(group, v); });
}

/// Share of the knee's torque limit that its own rotor and damping take as the swing foot leaves the ground.
///
/// The cubic splines of the swing foot start with the accelerations 6 h / (T_ss/2)^2 upward and 6 (2 v T) / T_ss^2 forward. The forward one
/// shortens the leg by x / l of it, where the hip is x = v (T + T_ds) / 2 ahead of the ankle.
/// @param s its T_ss and T_ds are used   @param lift h [m]   @param speed v [m/s]
double knee_share(const RobotScale& robot, const WalkSettings& s, double lift, double speed);

/// Replaces every NaN in `settings` by the robot's value, and checks them all.
/// @param top_speed  highest speed at which the robot is to walk [m/s]
/// @throws InputError  a value breaks a rule; the message gives name, value and rule
WalkSettings resolve(const WalkSettings& settings, const RobotScale& robot, double top_speed = 0.0);

/// What to tell someone who asked for a setting that does not exist: the nearest names, or the groups if none is near.
std::string no_such_setting(const std::string& name);

/// How far each step of section IV lands ahead of the stance foot: corrected (0.1, 0.15, 0.2, 0.2, ...), and as printed (0.25 from the fourth on) [m].
const std::vector<double>& paper_step_lengths();
const std::vector<double>& printed_step_lengths();

}  // namespace zmpwalk
