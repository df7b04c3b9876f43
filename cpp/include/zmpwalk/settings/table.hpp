#pragma once

#include <map>
#include <string>
#include <vector>

#include "zmpwalk/settings/choices.hpp"
#include "zmpwalk/settings/setting.hpp"

// The table of settings. A group is a struct, and a setting is a member with its row: `rows` shows both to a visitor. The
// constructor, files, the command line, help texts, type stubs, defaults and range checks all follow from here.
//
// A member's initialiser is its default. Not-a-number means "from the robot"; the row then has the rule.

namespace zmpwalk {

/// Defaults that are no multiple of one quantity of the robot.
namespace defaults {
double time_step(double, const Scale& scale);
double first_double_support(double, const Scale& scale);
double cadence_exponent(double, const Scale& scale);
double feet_apart(double, const Scale& scale);
double step_height(double, const Scale& scale);
double friction(double, const Scale& scale);
}  // namespace defaults

struct GaitSettings {
  static constexpr const char* kGroup = "gait";
  static constexpr const char* kMeaning = "When a foot is lifted and set down, and when the robot stands.";

  double T_ds = kNaN, T_ss = kNaN, T_ds_first = kNaN;
  Side first_swing = kRight;
  double cadence_speed = kNaN, cadence_exponent = kNaN, cadence_double = 0.5;
  double cadence_sideways = 3.0, cadence_turning = kNaN;
  bool stand = true;
  double stand_gain = 1.0, closing_distance = kNaN, closing_turn = 0.05;
  TouchDown touch_down = TouchDown::kFelt;
  double touch_down_share = 0.5, touch_down_time = kNaN, touch_down_speed = kNaN;

  template <class Self, class Visitor>
  static void rows(Self& g, Visitor&& v) {
    v(g.T_ds, "T_ds", "T_ds", "s", must_be::kPositive, {0.2, of::kStepPeriod},
      "Double support time of a step: how long both feet stand between two swings.");
    v(g.T_ss, "T_ss", "T_ss", "s", must_be::kPositive, {0.8, of::kStepPeriod},
      "Single support time of a step: how long one foot is in the air.");
    v(g.T_ds_first, "T_ds_first", "T_ds_first", "s", must_be::kPositive,
      {"the time in which a COM at rest takes up the sway of the steady walk", defaults::first_double_support},
      "Length of the first double support, in which the COM leaves its rest. With the default its sway is the "
      "steady one from the first step on.");
    v(g.first_swing, "first_swing", "first_swing", "", must_be::kAnything, {}, "Foot that takes the first step.");
    v(g.cadence_speed, "cadence_speed", "cadence_speed", "m/s", must_be::kPositive, {0.1, of::kFroudeSpeed},
      "Speed up to which every step takes T_ss + T_ds, and a faster walk takes longer steps. Above it the steps "
      "come faster as well.");
    v(g.cadence_exponent, "cadence_exponent", "cadence_exponent", "", must_be::kNotNegative,
      {"0.4, or 0 where a list sets the lengths of the steps", defaults::cadence_exponent},
      "How much faster steps come above cadence_speed: a step takes (cadence_speed / speed)^cadence_exponent of "
      "T_ss + T_ds. With 0 all steps take the same time.");
    v(g.cadence_double, "cadence_double", "cadence_double", "", must_be::kNotNegative, {},
      "How much the double support's share of a step shrinks above cadence_speed: as (cadence_speed / "
      "speed)^cadence_double. With 0 the share stays.");
    v(g.cadence_sideways, "cadence_sideways", "cadence_sideways", "", must_be::kNotNegative, {},
      "Weight of the sideways velocity in the speed that is compared with cadence_speed: 1 m/s sideways counts as "
      "this many m/s forward.");
    v(g.cadence_turning, "cadence_turning", "cadence_turning", "m/rad", must_be::kNotNegative, {0.54, of::kComHeight},
      "Weight of turning in the speed that is compared with cadence_speed: 1 rad/s counts as this many m/s forward.");
    v(g.stand, "stand", "stand", "", must_be::kAnything, {},
      "Whether the robot stands still, feet side by side, while the planned velocity is zero. With false it steps "
      "on the spot.");
    v(g.stand_gain, "stand_gain", "stand_gain", "", must_be::kNotNegative, {},
      "How hard a standing robot is brought back over the middle between its feet: the ZMP goes beyond the DCM (COM "
      "+ T_c times its velocity) by this many times the DCM's distance from the middle.");
    v(g.closing_distance, "closing_distance", "closing_reach", "m", must_be::kNotNegative, {0.1, of::kComHeight},
      "A walk ends with a step that sets the foot beside the other one. That step is taken once the DCM (COM + T_c "
      "times its velocity) will be this near to the standing foot at its end.");
    v(g.closing_turn, "closing_turn", "closing_turn", "rad", must_be::kNotNegative, {},
      "A walk ends with a step that sets the foot beside the other one. That step is taken only where the headings "
      "of the path and of the standing foot differ by no more than this.");
    v(g.touch_down, "touch_down", "touch_down", "", must_be::kAnything, {},
      "What ends a step. 'felt': by time, but a foot that meets the ground well before its time stays there, and once "
      "feet have found the ground uneven it is felt for; then height and swing follow the ground. 'time' alone; or "
      "'contact': each step ends when the swing foot is felt to touch. A foot whose contact is not known, or was never "
      "felt, ends its step by time.");
    v(g.touch_down_share, "touch_down_share", "touch_down_share", "", must_be::kShare, {},
      "Share of the single support before which a contact of the swing foot does not end the step: a foot that has "
      "just lifted may scuff the ground. Not where touch_down is 'time'.");
    v(g.touch_down_time, "touch_down_time", "touch_down_time", "s", must_be::kNotNegative, {0.18, of::kTimeConstant},
      "How long a swing foot that meets no ground at its planned time goes on down, until the step ends by time. Not "
      "where touch_down is 'time'.");
    v(g.touch_down_speed, "touch_down_speed", "touch_down_speed", "m/s", must_be::kNotNegative,
      {0.037, of::kFroudeSpeed},
      "Speed at which a swing foot comes down onto the ground where touch_down is 'contact', and on ground that has "
      "been "
      "felt to be uneven. A foot that meets none at its planned time goes on at this speed, ever slower: within "
      "touch_down_time by two thirds of touch_down_speed times touch_down_time. By time, a foot lands at rest.");
  }
};

struct StepsSettings {
  static constexpr const char* kGroup = "steps";
  static constexpr const char* kMeaning = "Where the feet are set down.";

  Footsteps mode = Footsteps::kTied;
  std::vector<double> lengths;
  double width = kNaN, clearance = kNaN, shift = kNaN, filter_time = kNaN, give = 0.3, freeze = 0.7;
  double capture_distance = kNaN, capture_speed = kNaN;
  bool timing = true;
  double ahead_most = kNaN, aside_most = kNaN, least_time = kNaN, wait_time = kNaN;

  template <class Self, class Visitor>
  static void rows(Self& g, Visitor&& v) {
    v(g.mode, "mode", "footsteps", "", must_be::kAnything, {},
      "What decides where a foot lands: 'tied' follows the COM, which keeps the walk balanced; 'absolute' takes the "
      "places of the plan; 'paper' and 'printed' take the step lengths of section IV, corrected and as printed; "
      "'list' takes steps.lengths. Python and files take a list of lengths here as well.");
    v(g.lengths, "lengths", "step_lengths", "m", must_be::kFinite, {},
      "How far each step lands ahead of the standing foot, one number per step; the last one repeats. Tied "
      "footsteps do not use it.");
    v(g.width, "width", "step_width", "m", must_be::kPositive, {"as the feet stand at the start", defaults::feet_apart},
      "Distance of the two feet from each other, sideways.");
    v(g.clearance, "clearance", "foot_clearance", "m", must_be::kNotNegative, {0.03, of::kComHeight},
      "Least gap that a step leaves between the edges of the two feet, sideways.");
    v(g.shift, "shift", "foothold_reach", "m", must_be::kNotNegative, {0.25, of::kComHeight},
      "How far a tied foothold moves from its nominal place to keep the robot balanced, whatever the foot in the air "
      "does. A longer way, and any way of a robot that has been pushed, is bounded by the reach of the leg and by "
      "where "
      "the foot in the air can still get to.");
    v(g.filter_time, "filter_time", "foothold_time", "s", must_be::kPositive, {0.18, of::kTimeConstant},
      "Time constant of the low-pass through which a tied foothold moves while the foot is in the air.");
    v(g.give, "give", "foothold_give", "", must_be::kNotNegative, {},
      "A COM that is faster or slower than planned needs another foothold or another ZMP. Up to this share of its "
      "bounds the ZMP over the next foot makes up for it; only the rest moves a tied foothold. With 0 each long "
      "step would be followed by a short one.");
    v(g.freeze, "freeze", "foothold_freeze", "", must_be::kNotNegative, {},
      "Share of the single support after which a tied foothold stays where it is, so that the foot lands calmly.");
    v(g.capture_distance, "capture_distance", "capture_reach", "m", must_be::kNotNegative, {0.07, of::kComHeight},
      "How far the DCM (COM + T_c times its velocity) may be from its planned place when the next foot takes over, "
      "with tied footsteps. Beyond that, or where the ZMP over that foot could not hold it, the tracked speed yields, "
      "so that the next step still catches the robot.");
    v(g.capture_speed, "capture_speed", "capture_speed", "m/s", must_be::kNotNegative, {0.2, of::kFroudeSpeed},
      "Most that the tracked speed yields, either way, to keep the DCM within capture_distance of its plan.");
    v(g.timing, "timing", "step_timing", "", must_be::kAnything, {},
      "Whether a robot that has been pushed changes the time of its step, uses the whole sole, and steps out of a "
      "stand to catch itself. Only with tied footsteps.");
    v(g.ahead_most, "ahead_most", "step_ahead_most", "m", must_be::kPositive, {0.6, of::kComHeight},
      "How far ahead of the standing foot, or behind it, a foot may be set down to catch the robot.");
    v(g.aside_most, "aside_most", "step_aside_most", "m", must_be::kPositive, {0.67, of::kComHeight},
      "How far beside the standing foot a foot may be set down to catch the robot.");
    v(g.least_time, "least_time", "step_least_time", "s", must_be::kPositive, {1.1, of::kTimeConstant},
      "Shortest single support of a step that catches the robot.");
    v(g.wait_time, "wait_time", "step_wait_time", "s", must_be::kNotNegative, {3.0, of::kTimeConstant},
      "How much longer than planned a foot may stay in the air, while the ZMP brings the DCM (COM + T_c times its "
      "velocity) back over the standing foot.");
  }
};

struct SwingSettings {
  static constexpr const char* kGroup = "swing";
  static constexpr const char* kMeaning = "How the foot in the air moves.";

  double height = kNaN;
  bool feed_forward = true;
  double kp = kNaN, kd = kNaN;
  double ahead_acceleration = kNaN, aside_acceleration = kNaN;

  template <class Self, class Visitor>
  static void rows(Self& g, Visitor&& v) {
    v(g.height, "height", "step_height", "m", must_be::kPositive,
      {"0.0535 z_c, or less (down to 0.01 z_c) where the knee's rotor and damping would take over 0.6 of its "
       "torque at the walk's top speed",
       defaults::step_height},
      "Height to which a step lifts the foot.");
    v(g.feed_forward, "feed_forward", "swing_feed_forward", "", must_be::kAnything, {},
      "Whether the acceleration of the planned swing is added to that which corrects the foot's error. Without it "
      "the foot lags behind its path.");
    v(g.kp, "kp", "swing_kp", "1/s^2", must_be::kNotNegative, {3600.0, of::kStiffness},
      "Stiffness with which the foot in the air is held on its path: acceleration per error, in position and "
      "orientation.");
    v(g.kd, "kd", "swing_kd", "1/s", must_be::kNotNegative, {120.0, of::kDamping},
      "Damping with which the foot in the air is held on its path: acceleration per velocity error, in position and "
      "orientation.");
    v(g.ahead_acceleration, "ahead_acceleration", "swing_ahead_acceleration", "m/s^2", must_be::kPositive,
      {1.5, of::kGravity},
      "Acceleration, forward or backward, that a foothold may ask of the foot in the air beyond its way by itself. "
      "More would turn the standing foot on the ground, and push the COM the other way.");
    v(g.aside_acceleration, "aside_acceleration", "swing_aside_acceleration", "m/s^2", must_be::kPositive,
      {4.0, of::kGravity},
      "Acceleration, sideways, that a foothold may ask of the foot in the air beyond its way by itself.");
  }
};

struct ComSettings {
  static constexpr const char* kGroup = "com";
  static constexpr const char* kMeaning = "How the centre of mass (COM) is moved: forward, sideways and in height.";

  ComState state = ComState::kMeasured;
  bool feed_forward = true;
  double kp_x = kNaN, kd_x = kNaN, kp_y = kNaN, kd_y = kNaN, kp_z = kNaN, kd_z = kNaN;
  double lead = kNaN, least_knee = 0.3, crouch_limit = kNaN, crouch_margin = 1.2, crouch_time = kNaN;

  template <class Self, class Visitor>
  static void rows(Self& g, Visitor&& v) {
    v(g.state, "state", "com_state", "", must_be::kAnything, {},
      "What counts as the COM's current state in the pendulum (16), (17): the 'measured' one, or the one that was "
      "'desired' in the cycle before.");
    v(g.feed_forward, "feed_forward", "feed_forward", "", must_be::kAnything, {},
      "Whether the pendulum's acceleration is added to the COM's commanded acceleration (8). Without it the COM is "
      "one cycle late and takes stiffer gains.");
    v(g.kp_x, "kp_x", "com_x_kp", "1/s^2", must_be::kNotNegative, {100.0, of::kStiffness},
      "Stiffness of the COM's motion forward: acceleration per position error in (8).");
    v(g.kd_x, "kd_x", "com_x_kd", "1/s", must_be::kNotNegative, {20.0, of::kDamping},
      "Damping of the COM's motion forward: acceleration per velocity error in (8).");
    v(g.kp_y, "kp_y", "com_y_kp", "1/s^2", must_be::kNotNegative, {100.0, of::kStiffness},
      "Stiffness of the COM's motion sideways: acceleration per position error in (8).");
    v(g.kd_y, "kd_y", "com_y_kd", "1/s", must_be::kNotNegative, {20.0, of::kDamping},
      "Damping of the COM's motion sideways: acceleration per velocity error in (8).");
    v(g.kp_z, "kp_z", "com_z_kp", "1/s^2", must_be::kNotNegative, {200.0, of::kStiffness},
      "Stiffness of the COM's height: acceleration per position error in (8).");
    v(g.kd_z, "kd_z", "com_z_kd", "1/s", must_be::kNotNegative, {28.0, of::kDamping},
      "Damping of the COM's height: acceleration per velocity error in (8).");
    v(g.lead, "lead", "com_lead", "m", must_be::kNotNegative, {0.0134, of::kComHeight},
      "How far the COM rides ahead of the middle between the feet, with tied footsteps. So a foot that has just "
      "landed is not loaded on its heel, where the contact settles slowly.");
    v(g.least_knee, "least_knee", "least_knee", "rad", must_be::kNotNegative, {},
      "Smallest knee angle that the plan allows, so that no leg becomes straight. It leaves room for what the plan "
      "does not know: swing leg and pelvis move the hips against the COM.");
    v(g.crouch_limit, "crouch_limit", "crouch_limit", "m", must_be::kNotNegative, {0.1, of::kComHeight},
      "How far the COM may come down so that the legs reach far enough for long steps.");
    v(g.crouch_margin, "crouch_margin", "crouch_margin", "", must_be::kNotNegative, {},
      "For long steps the COM comes down until the legs reach this many times as far as the feet are from under the "
      "hips in double support.");
    v(g.crouch_time, "crouch_time", "crouch_time", "s", must_be::kPositive, {0.5, of::kTimeConstant},
      "Time constant with which the COM comes down for long steps and rises after them.");
  }
};

struct ZmpSettings {
  static constexpr const char* kGroup = "zmp";
  static constexpr const char* kMeaning =
      "Where the ZMP may be, and how the reference ZMP is found that puts it there (III-B, III-D).";

  bool modification = true;
  Iteration iteration = Iteration::kClosedForm;
  double threshold = 1e-3;
  int max_iterations = 200;
  double sole_fraction = 0.72, sole_exponent = 0.5, ankle_torque_fraction = 0.9;
  bool bound_lateral = true;
  LateralLawName lateral_law{};
  double lateral_shift = 1.6;
  double whole_fraction = 0.95, corner_cut = 0.3;

  template <class Self, class Visitor>
  static void rows(Self& g, Visitor&& v) {
    v(g.modification, "modification", "zmp_modification", "", must_be::kAnything, {},
      "Whether the estimated ZMP is kept inside its bounds (III-B, III-C). With false the planned velocity is "
      "tracked blindly.");
    v(g.iteration, "iteration", "iteration", "", must_be::kAnything, {},
      "How the reference ZMP is found that puts the estimated ZMP where it is desired: in 'closed_form', or by the "
      "'loop' that III-B prints. With 'none' the pendulum's ZMP is taken as it is, and the estimate changes "
      "nothing.");
    v(g.threshold, "threshold", "zmp_threshold", "m", must_be::kPositive, {},
      "The reference ZMP is good enough once the estimated ZMP is this near to the desired one (section IV).");
    v(g.max_iterations, "max_iterations", "max_iterations", "", must_be::kAtLeastOne, {},
      "Most passes of the loop of III-B in one control cycle, which then goes on with what it has.");
    v(g.sole_fraction, "sole_fraction", "sole_fraction", "", must_be::kPositive, {},
      "Share of the sole's length and width that the ZMP may use. The rest is a margin: a foot whose ZMP is at its "
      "edge tips.");
    v(g.sole_exponent, "sole_exponent", "sole_exponent", "", must_be::kNotNegative, {},
      "How much less of the sole's length the ZMP uses above cadence_speed: (cadence_speed / speed)^sole_exponent "
      "of it. At the sole's ends the contact of a fast walk chatters.");
    v(g.ankle_torque_fraction, "ankle_torque_fraction", "ankle_torque_fraction", "", must_be::kPositive, {},
      "Share of an ankle's torque limit that may hold the ZMP away from the ankle. Where ankles are weak this, not "
      "the sole, bounds the ZMP.");
    v(g.bound_lateral, "bound_lateral", "bound_lateral", "", must_be::kAnything, {},
      "Whether the ZMP is kept inside its bounds sideways too. The paper bounds it forward only.");
    v(g.lateral_law, "lateral_law", "lateral_law", "", must_be::kAnything, {},
      "Law by which the reference ZMP is shifted sideways from the middle of the sole that carries it (III-D).");
    v(g.lateral_shift, "lateral_shift", "lateral_reach", "", must_be::kNotNegative, {},
      "Largest sideways shift of the reference ZMP that the lateral law may ask for, as a share of half the sole's "
      "width.");
    v(g.whole_fraction, "whole_fraction", "whole_sole_fraction", "", must_be::kPositive, {},
      "Share of the sole's length and width that the ZMP may use when the robot has been pushed. It takes the place of "
      "sole_fraction as the DCM (COM + T_c times its velocity) leaves its plan.");
    v(g.corner_cut, "corner_cut", "corner_cut", "", must_be::kShare, {},
      "Share of the sole's length that the ZMP gives up where it is at the sole's side: in a corner of the sole it "
      "would "
      "tip the foot.");
  }
};

struct TrackingSettings {
  static constexpr const char* kGroup = "tracking";
  static constexpr const char* kMeaning = "How the walk follows the planned velocity (III-C).";

  TrackerLawName law{};
  double gain = kNaN, time = kNaN, catch_up_speed = kNaN, deadband = 2e-4;
  double regain_from = kNaN, regain_gain = kNaN, regain_speed = kNaN;

  template <class Self, class Visitor>
  static void rows(Self& g, Visitor&& v) {
    v(g.law, "law", "tracker", "", must_be::kAnything, {}, "Law by which the COM's velocity follows the planned one.");
    v(g.gain, "gain", "tracker_gain", "1/s", must_be::kPositive, {1.38, of::kPerTimeConstant},
      "How fast the smooth law makes up lost way: speed that it adds per metre behind the plan.");
    v(g.time, "time", "tracker_time", "s", must_be::kPositive, {0.18, of::kTimeConstant},
      "Time constant with which the smooth law removes an error of the speed.");
    v(g.catch_up_speed, "catch_up_speed", "tracker_reach", "m/s", must_be::kNotNegative, {0.03, of::kFroudeSpeed},
      "Largest speed that the smooth law adds or takes away to make up lost or gained way. Feet cannot make up a long "
      "way in one step.");
    v(g.deadband, "deadband", "tracker_deadband", "m", must_be::kPositive, {},
      "How far the COM may be ahead of its plan or behind it before the bang-bang law drives it back. A drive ends a "
      "little beyond the plan, since time is discrete; without a deadband that would start the next drive.");
    v(g.regain_from, "regain_from", "regain_from", "m", must_be::kNotNegative, {0.08, of::kComHeight},
      "How far the COM must be behind its plan, or ahead of it, before steps become longer or shorter to make up for "
      "it. "
      "A push can cost half a metre. Only with tied footsteps.");
    v(g.regain_gain, "regain_gain", "regain_gain", "1/s", must_be::kNotNegative, {0.14, of::kPerTimeConstant},
      "Speed that those steps add per metre beyond regain_from.");
    v(g.regain_speed, "regain_speed", "regain_speed", "m/s", must_be::kNotNegative, {0.045, of::kFroudeSpeed},
      "Largest speed that those steps add or take away.");
  }
};

struct RateSettings {
  static constexpr const char* kGroup = "rate";
  static constexpr const char* kMeaning =
      "How fast the planned velocity may change, whatever a profile or command asks for at once.";

  bool limit = true;
  double forward_jump = kNaN, sideways_jump = 0.0, turning_jump = kNaN;
  double forward_acceleration = kNaN, forward_deceleration = kNaN;
  double sideways_acceleration = kNaN, turning_acceleration = kNaN;

  template <class Self, class Visitor>
  static void rows(Self& g, Visitor&& v) {
    v(g.limit, "limit", "rate_limit", "", must_be::kAnything, {},
      "Whether the planned velocity changes no faster than steps can follow. With false profiles and commands are "
      "taken as they are.");
    v(g.forward_jump, "forward_jump", "forward_jump", "m/s", must_be::kNotNegative, {0.036, of::kFroudeSpeed},
      "Change of the forward velocity v_x that is taken up at once. A larger one follows at forward_acceleration or "
      "forward_deceleration.");
    v(g.sideways_jump, "sideways_jump", "sideways_jump", "m/s", must_be::kNotNegative, {},
      "Change of the sideways velocity v_y that is taken up at once. A larger one follows at sideways_acceleration.");
    v(g.turning_jump, "turning_jump", "turning_jump", "rad/s", must_be::kNotNegative, {0.07, of::kPerTimeConstant},
      "Change of the turning velocity w_z that is taken up at once. A larger one follows at turning_acceleration.");
    v(g.forward_acceleration, "forward_acceleration", "forward_acceleration", "m/s^2", must_be::kPositive,
      {0.02, of::kGravity}, "Rate at which the forward velocity v_x moves away from zero.");
    v(g.forward_deceleration, "forward_deceleration", "forward_deceleration", "m/s^2", must_be::kPositive,
      {0.056, of::kGravity}, "Rate at which the forward velocity v_x goes back to zero.");
    v(g.sideways_acceleration, "sideways_acceleration", "sideways_acceleration", "m/s^2", must_be::kPositive,
      {0.025, of::kGravity}, "Rate at which the sideways velocity v_y changes.");
    v(g.turning_acceleration, "turning_acceleration", "turning_acceleration", "rad/s^2", must_be::kPositive,
      {0.08, of::kPerTimeConstantSquared}, "Rate at which the turning velocity w_z changes.");
  }
};

struct TrunkSettings {
  static constexpr const char* kGroup = "trunk";
  static constexpr const char* kMeaning = "How the trunk is kept upright and along the path.";

  double kp = kNaN, kd = kNaN;
  bool yields = true;

  template <class Self, class Visitor>
  static void rows(Self& g, Visitor&& v) {
    v(g.kp, "kp", "trunk_kp", "1/s^2", must_be::kNotNegative, {300.0, of::kStiffness},
      "Stiffness of the trunk's orientation: angular acceleration per angle of error.");
    v(g.kd, "kd", "trunk_kd", "1/s", must_be::kNotNegative, {35.0, of::kDamping},
      "Damping of the trunk's orientation: angular acceleration per error of angular velocity.");
    v(g.yields, "yields", "trunk_yields", "", must_be::kAnything, {},
      "Whether the trunk of a robot that has been pushed comes back upright slowly. A trunk that is held stiffly takes "
      "the ZMP away from where it would hold the DCM (COM + T_c times its velocity), and turns the standing foot.");
  }
};

struct PostureSettings {
  static constexpr const char* kGroup = "posture";
  static constexpr const char* kMeaning = "How the joints outside the legs (waist, arms, head) are moved.";

  bool task = true;
  double kp = kNaN, kd = kNaN, motion_blend = kNaN;

  template <class Self, class Visitor>
  static void rows(Self& g, Visitor&& v) {
    v(g.task, "task", "posture_task", "", must_be::kAnything, {},
      "Whether the joints outside the legs are controlled. With false their motion is left to the torque of least "
      "norm.");
    v(g.kp, "kp", "posture_kp", "1/s^2", must_be::kNotNegative, {100.0, of::kStiffness},
      "Stiffness of the joints outside the legs: acceleration per angle of error.");
    v(g.kd, "kd", "posture_kd", "1/s", must_be::kNotNegative, {20.0, of::kDamping},
      "Damping of the joints outside the legs: acceleration per error of joint velocity.");
    v(g.motion_blend, "motion_blend", "motion_blend", "s", must_be::kPositive, {1.8, of::kTimeConstant},
      "Time in which a new joint motion takes over from the one before it.");
  }
};

struct ArmsSettings {
  static constexpr const char* kGroup = "arms";
  static constexpr const char* kMeaning = "How the arms swing so that the robot does not turn about the vertical.";

  double momentum = 0.0, kp = kNaN, kd = kNaN, reserve = 1.0, reserve_time = kNaN;

  template <class Self, class Visitor>
  static void rows(Self& g, Visitor&& v) {
    v(g.momentum, "momentum", "momentum_arms", "", must_be::kShare, {},
      "Share of the yaw momentum of legs and trunk that the arms cancel by swinging, 0 to 1. Joints that a motion "
      "names do not swing.");
    v(g.kp, "kp", "momentum_kp", "1/s^2", must_be::kNotNegative, {20.0, of::kStiffness},
      "Stiffness of the spring that brings swinging arms back to their posture: acceleration per angle.");
    v(g.kd, "kd", "momentum_kd", "1/s", must_be::kNotNegative, {20.0, of::kDamping},
      "Rate at which swinging arms bring the robot's yaw momentum to zero.");
    v(g.reserve, "reserve", "arms_reserve", "", must_be::kShare, {},
      "Share of the yaw momentum that the arms cancel, where this is more than momentum, while the yaw friction of a "
      "sole holds the torque back, so that the foot does not spin. With 0 they never help.");
    v(g.reserve_time, "reserve_time", "arms_reserve_time", "s", must_be::kPositive, {2.0, of::kTimeConstant},
      "Time in which the arms return to their posture once the soles hold the yaw moment again. They come to help in a "
      "tenth of it.");
  }
};

struct ContactSettings {
  static constexpr const char* kGroup = "contact";
  static constexpr const char* kMeaning = "How the feet that stand carry the robot.";

  bool wrench_distribution = true;
  double load_alone = 0.7, damping = 100.0;

  template <class Self, class Visitor>
  static void rows(Self& g, Visitor&& v) {
    v(g.wrench_distribution, "wrench_distribution", "wrench_distribution", "", must_be::kAnything, {},
      "Whether two standing feet share the load by the place of the ZMP between them. With false the torque of "
      "least norm decides, which ignores that feet cannot pull.");
    v(g.load_alone, "load_alone", "load_alone", "", must_be::kNotNegative, {},
      "In double support one foot carries everything while the ZMP is this near to its centre line, in half sole "
      "widths. A foot that has just landed would chatter under a light load.");
    v(g.damping, "damping", "contact_damping", "1/s", must_be::kNotNegative, {},
      "Damping of the velocity of a standing foot that does not carry the ZMP. Without a load it would drift off "
      "the ground.");
  }
};

struct ControlSettings {
  static constexpr const char* kGroup = "control";
  static constexpr const char* kMeaning = "How the torque is computed, how often, and within which limits.";

  double dt = kNaN;
  bool textbook = false;
  double singular_damping = 1e-3, singular_pivot = 1e-2, singular_task = 5e-3, friction_velocity = 0.02;
  std::string kernel = "auto";
  std::map<std::string, double> torque_limits;

  template <class Self, class Visitor>
  static void rows(Self& g, Visitor&& v) {
    v(g.dt, "dt", "control_dt", "s", must_be::kPositive, {"the model's time step", defaults::time_step},
      "Control period: a new torque is computed this often and held in between. It must be a multiple of the "
      "model's time step.");
    v(g.textbook, "textbook", "textbook", "", must_be::kAnything, {},
      "Whether equations (1) to (13) are computed as printed instead of on the direct path. It is slower and gives "
      "the same numbers.");
    v(g.singular_damping, "singular_damping", "singular_damping", "", must_be::kPositive, {},
      "Damping that keeps the joints' motion bounded where a leg is straight.");
    v(g.singular_pivot, "singular_pivot", "singular_pivot", "", must_be::kNotNegative, {},
      "Smallest pivot of a leg's equations below which that leg counts as straight.");
    v(g.singular_task, "singular_task", "singular_task", "", must_be::kShare, {},
      "How far a task of your own may be from impossible before it is met in part only: the motion that it asks for is "
      "damped in directions in which the joints outside the legs move it by less than this share of its size. So it "
      "stays bounded where an arm is stretched out. With 0 nothing is damped.");
    v(g.friction_velocity, "friction_velocity", "friction_velocity", "rad/s", must_be::kPositive, {},
      "Joint speed below which dry friction is taken as proportional to the speed, so that it does not jump where a "
      "joint turns around.");
    v(g.kernel, "kernel", "kernel", "", must_be::kAnything, {},
      "Build of the inner loops: 'auto' takes the best that this processor runs, and build_info()['kernels'] names "
      "those that there are. They agree to rounding.");
    v(g.torque_limits, "torque_limits", "torque_limits", "N m", must_be::kPositive, {},
      "Torque limits by joint name, in place of the robot's own. A motor still gives no more than the model lets "
      "through.");
  }
};

struct LimitsSettings {
  static constexpr const char* kGroup = "limits";
  static constexpr const char* kMeaning =
      "What a torque must keep to: the joints' torques and ranges, and what the soles can hold.";

  bool keep = true, feel_slip = false;
  double friction = kNaN, twist = 1.0, range_margin = 0.0, range_rate = kNaN;

  template <class Self, class Visitor>
  static void rows(Self& g, Visitor&& v) {
    v(g.keep, "keep", "keep_limits", "", must_be::kAnything, {},
      "Whether the nearest torque that keeps the limits is found where the closed form's torque would break one: the "
      "tasks give way, first the swing foot, then the trunk, the COM's height, and last its horizontal acceleration. "
      "With false torques are cut to their limits, and nothing else is kept.");
    v(g.friction, "friction", "friction", "", must_be::kPositive,
      {"that of the soles in the model", defaults::friction},
      "Friction of the soles: tangential force per normal force that they can hold.");
    v(g.feel_slip, "feel_slip", "feel_slip", "", must_be::kAnything, {},
      "Whether a sole that slides while it carries lowers the friction that is believed, and with it the planned "
      "speed. With true the robot walks on over ice; but soles that slide a little as they land, as they do where the "
      "measured attitude is off by 2 degrees, pass for slipping ones, and it slows down.");
    v(g.twist, "twist", "twist_share", "", must_be::kPositive, {},
      "Moment about the vertical that a sole may give, as a share of what its friction holds while it turns about its "
      "centre. With more than 1 the foot turns a little where it must.");
    v(g.range_margin, "range_margin", "range_margin", "rad", must_be::kNotNegative, {},
      "How far from the ends of its range a joint comes to rest.");
    v(g.range_rate, "range_rate", "range_rate", "1/s", must_be::kPositive, {120.0, of::kDamping},
      "How fast a joint may still move towards the end of its range: it comes to rest there as a critically damped "
      "joint of this damping does. A small rate brakes early.");
  }
};

struct ObserverSettings {
  static constexpr const char* kGroup = "observer";
  static constexpr const char* kMeaning =
      "What the controller finds out about what it does not know: steady forces, wrong masses, a biased attitude, "
      "noise.";

  bool on = true;
  double time = kNaN, speed_noise = kNaN, tolerance = kNaN, force_most = kNaN, weight_most = 0.35, push = kNaN;
  double attitude_time = kNaN, attitude_noise = 1e-3;
  double bias_time = kNaN, bias_most = 0.09, sole_tilt = 4e-3;

  template <class Self, class Visitor>
  static void rows(Self& g, Visitor&& v) {
    v(g.on, "on", "disturbance_observer", "", must_be::kAnything, {},
      "Whether the walk makes up for steady forces, wrong masses, and noise or bias of the measured attitude. A walk "
      "that knows everything keeps its bits.");
    v(g.time, "time", "observer_time", "s", must_be::kPositive, {0.18, of::kTimeConstant},
      "Time constant with which a disturbance is found: an acceleration of the COM that the command does not explain. "
      "Where the measured speed is noisy, it grows up to four times.");
    v(g.speed_noise, "speed_noise", "observer_speed_noise", "m/s", must_be::kPositive, {0.0092, of::kFroudeSpeed},
      "Change of the COM's speed from cycle to cycle that the command does not explain, as root of its mean square, up "
      "to which the speed counts as measured without noise.");
    v(g.tolerance, "tolerance", "observer_tolerance", "m/s^2", must_be::kNotNegative, {0.015, of::kGravity},
      "A disturbance is made up for where it is larger than this, and less by this: contacts that give way a little "
      "are none.");
    v(g.force_most, "force_most", "observer_force_most", "m/s^2", must_be::kNotNegative, {0.13, of::kGravity},
      "Most that is made up for of a steady horizontal disturbance, along either axis.");
    v(g.weight_most, "weight_most", "observer_weight_most", "", must_be::kShare, {},
      "Most that the robot is taken to be heavier or lighter than its model says, as a share of its mass.");
    v(g.push, "push", "observer_push", "m/s^2", must_be::kPositive, {0.16, of::kGravity},
      "A horizontal disturbance that is larger than this is a push and not steady: what was found before it is held.");
    v(g.attitude_time, "attitude_time", "attitude_time", "s", must_be::kPositive, {1.1, of::kTimeConstant},
      "Time constant with which a noisy attitude of the base corrects the one that its angular velocity leads to.");
    v(g.attitude_noise, "attitude_noise", "attitude_noise", "rad", must_be::kNotNegative, {},
      "Angle between the measured attitude and the one that the angular velocity leads to from the cycle before, as "
      "root of its mean square, up to which the attitude is taken as it is measured.");
    v(g.bias_time, "bias_time", "attitude_bias_time", "s", must_be::kPositive, {1.8, of::kTimeConstant},
      "Time constant with which a bias of the measured attitude is found.");
    v(g.bias_most, "bias_most", "attitude_bias_most", "rad", must_be::kNotNegative, {},
      "Most that is made up for of a bias of the measured attitude.");
    v(g.sole_tilt, "sole_tilt", "attitude_sole_tilt", "rad", must_be::kNotNegative, {},
      "Tilt of the standing sole from level that shows no bias yet: contacts give way a little.");
  }
};

struct CommandSettings {
  static constexpr const char* kGroup = "command";
  static constexpr const char* kMeaning = "Which velocities may be commanded.";

  bool limit = true;
  double share = 1.0;

  template <class Self, class Visitor>
  static void rows(Self& g, Visitor&& v) {
    v(g.limit, "limit", "command_limit", "", must_be::kAnything, {},
      "Whether commands and profiles are kept within what the torques of the legs and the friction under the soles "
      "give. With false only the reach of the legs limits them.");
    v(g.share, "share", "command_share", "", must_be::kPositive, {},
      "Share of those torques and that friction that a commanded velocity may use. More than 1 allows faster walks, "
      "which cut torques and slide.");
  }
};

struct FallSettings {
  static constexpr const char* kGroup = "fall";
  static constexpr const char* kMeaning = "What counts as a fall, when one is foreseen, and what the robot does then.";

  double height = 0.8, tilt = 0.8, foot_tilt = 0.45;
  bool foresee = true, crouch = true;
  double margin = kNaN, confirm_time = kNaN;

  template <class Self, class Visitor>
  static void rows(Self& g, Visitor&& v) {
    v(g.height, "height", "fall_height", "", must_be::kPositive, {},
      "The robot has fallen where its COM is less high over the support foot than this share of its height at the "
      "start.");
    v(g.tilt, "tilt", "fall_tilt", "rad", must_be::kPositive, {},
      "The robot has fallen where its trunk tilts by more than this.");
    v(g.foot_tilt, "foot_tilt", "fall_foot_tilt", "rad", must_be::kPositive, {},
      "A fall is foreseen where the only foot that stands tilts by more than this, as it tips over its edge.");
    v(g.foresee, "foresee", "fall_foresee", "", must_be::kAnything, {},
      "Whether a fall is foreseen: it is certain once no foothold within reach, and no time of landing, can catch the "
      "DCM (COM + T_c times its velocity) any more.");
    v(g.crouch, "crouch", "fall_crouch", "", must_be::kAnything, {},
      "Whether the robot crouches once a fall is foreseen: the legs bend and every joint is damped, until the walk is "
      "started anew. With false it walks on as if nothing were foreseen.");
    v(g.margin, "margin", "fall_margin", "m", must_be::kNotNegative, {0.03, of::kComHeight},
      "How far the DCM must be beyond what any foothold within reach can catch before the fall counts as certain. "
      "Trunk, arms and what the pendulum does not know may bring back that much.");
    v(g.confirm_time, "confirm_time", "fall_confirm_time", "s", must_be::kNotNegative, {0.04, of::kTimeConstant},
      "How long the DCM must be that far off without a break before the fall counts as certain: a noisy measurement "
      "alone fells nobody.");
  }
};

}  // namespace zmpwalk
