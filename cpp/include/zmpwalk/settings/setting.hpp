#pragma once

#include <limits>
#include <string>

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

struct WalkSettings;

/// The quantities of a robot with which the defaults of the settings scale.
struct RobotScale {
  double com_height = 0.0;     ///< z_c, over the soles, at the start pose [m]
  double gravity = 0.0;        ///< g [m/s^2]
  double timestep = 0.0;       ///< of the model [s]
  double foot_distance = 0.0;  ///< lateral, at the start pose [m]
  double friction = 1.0;       ///< of the soles on the ground, in the model
  // What swinging the foot costs the knee; with these values it costs nothing.
  double hip_to_ankle = std::numeric_limits<double>::infinity();  ///< at the start pose, seen from the side [m]
  double knee_per_lift = 0.0;  ///< knee angle per shortening of that distance, at the start pose [rad/m]
  double knee_armature = 0.0;  ///< [kg m^2]
  double knee_damping = 0.0;   ///< [N m s/rad]
  double knee_torque = std::numeric_limits<double>::infinity();  ///< torque limit of the knee [N m]
};

/// Everything from which the rule of a default may compute its value.
struct Scale {
  Scale(const RobotScale& robot, const WalkSettings& settings, double top_speed);

  const RobotScale& robot;
  const WalkSettings&
      settings;      ///< settings that stand earlier in the table than the one in question have their values already
  double top_speed;  ///< highest speed at which the robot is to walk [m/s]
  double Tc;         ///< time constant of the pendulum, sqrt(z_c / g) [s]
  double speed;      ///< Froude number 1, sqrt(g z_c) [m/s]
  double period;     ///< period of a step, scaled from that of section IV and rounded to hundredths of a second [s]
  double rate;       ///< T_c of the robot of section IV divided by this robot's T_c
};

/// A quantity of the robot that defaults are multiples of: its name, and `factor` times it.
struct Quantity {
  const char* name;
  double (*times)(double factor, const Scale& scale);
};

namespace of {

inline constexpr Quantity kComHeight{"z_c", [](double f, const Scale& s) { return f * s.robot.com_height; }};
inline constexpr Quantity kGravity{"g", [](double f, const Scale& s) { return f * s.robot.gravity; }};
inline constexpr Quantity kFroudeSpeed{"sqrt(g z_c)", [](double f, const Scale& s) { return f * s.speed; }};
inline constexpr Quantity kTimeConstant{"T_c", [](double f, const Scale& s) { return f * s.Tc; }};
inline constexpr Quantity kPerTimeConstant{"/ T_c", [](double f, const Scale& s) { return f / s.Tc; }};
inline constexpr Quantity kPerTimeConstantSquared{"/ T_c^2",
                                                  [](double f, const Scale& s) { return f / (s.Tc * s.Tc); }};
inline constexpr Quantity kStepPeriod{"of a step's period, which is 0.8 s sqrt(z_c / 0.747 m)",
                                      [](double f, const Scale& s) { return f * s.period; }};
/// The gains were found on the robot of section IV; scaled like this they do the same on a robot that is faster or slower.
inline constexpr Quantity kStiffness{"(0.276 s / T_c)^2", [](double f, const Scale& s) { return f * s.rate * s.rate; }};
inline constexpr Quantity kDamping{"(0.276 s / T_c)", [](double f, const Scale& s) { return f * s.rate; }};

}  // namespace of

/// Default of a setting that depends on the robot: `factor` times a quantity, or a rule of its own.
struct Default {
  constexpr Default() = default;
  constexpr Default(double factor, const Quantity& of) : factor_(factor), of_(of) {}
  /// @param rule  in words; `times` is the rule itself and ignores its first argument
  constexpr Default(const char* rule, double (*times)(double, const Scale&)) : of_{rule, times} {}

  bool from_robot() const { return of_.times != nullptr; }
  double value(const Scale& scale) const { return of_.times(factor_, scale); }
  std::string text() const;

 private:
  double factor_ = kNaN;
  Quantity of_{"", nullptr};
};

/// The rule that a number keeps, in words that follow "it must be".
struct Range {
  const char* text;
  bool (*holds)(double);
};

namespace must_be {

inline constexpr Range kFinite{"finite", [](double x) { return std::isfinite(x); }};
inline constexpr Range kNotNegative{"finite and not negative", [](double x) { return std::isfinite(x) && x >= 0.0; }};
inline constexpr Range kPositive{"finite and greater than 0", [](double x) { return std::isfinite(x) && x > 0.0; }};
inline constexpr Range kShare{"in 0..1", [](double x) { return x >= 0.0 && x <= 1.0; }};
inline constexpr Range kAtLeastOne{"at least 1", [](double x) { return x >= 1.0; }};
/// A setting that is no number has no range: its type says what it may be.
inline constexpr Range kAnything{"", [](double) { return true; }};

}  // namespace must_be

/// One row of the table of settings.
struct Setting {
  const char* group;      ///< `tracking` of tracking.gain
  const char* name;       ///< in its group: `gain` of tracking.gain
  const char* flat;       ///< one word for it, unique among all settings: `tracker_gain`
  const char* unit;       ///< SI; "" where there is none
  Range range;            ///< of the number, or of each number of a list or table
  Default default_value;  ///< where it depends on the robot; else the member's initialiser is the default
  const char* meaning;    ///< what the setting is for, in sentences that stand alone

  std::string path() const { return std::string(group) + "." + name; }
  /// The name that messages use, with the flat name behind it where that differs: "tracking.gain (tracker_gain)".
  std::string both_names() const;
};

}  // namespace zmpwalk
