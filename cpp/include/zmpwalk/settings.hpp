#pragma once

#include <map>
#include <string>
#include <vector>

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

enum class Footsteps { kTied, kAbsolute, kPaper, kPrinted, kList };
enum class ComState { kMeasured, kDesired };
enum class TrackerLaw { kSmooth, kBangBang };
enum class Iteration { kClosedForm, kLoop, kNone };

/// Every gain, bound and switch of the walk. Not-a-number means "from the robot": resolved when a controller is made.
///
/// SI units. `law` picks a preset ("default" or "paper"); everything can be set afterwards. Names, units and reasons are
/// listed once, in `visit_settings`.
struct WalkSettings {
  /// @throws InputError unknown preset
  explicit WalkSettings(const std::string& law = "default");

  std::string law;

  // The cycle
  double control_dt = kNaN, T_ds = kNaN, T_ss = kNaN, T_ds_first = kNaN;
  std::string first_swing = "right";
  double cadence_speed = kNaN, cadence_exponent = kNaN, cadence_double = 0.5, cadence_sideways = 3.0,
         cadence_turning = kNaN;
  bool stand = true;
  double stand_gain = 1.0, closing_reach = kNaN, closing_turn = 0.05;
  // How fast the planned velocity may change
  bool rate_limit = true;
  double forward_jump = kNaN, sideways_jump = kNaN, turning_jump = kNaN;
  double forward_acceleration = kNaN, forward_deceleration = kNaN, sideways_acceleration = kNaN,
         turning_acceleration = kNaN;
  // Velocity tracking (III-C) and the reference ZMP (III-B)
  TrackerLaw tracker = TrackerLaw::kSmooth;
  double tracker_gain = kNaN, tracker_time = kNaN, tracker_reach = kNaN, tracker_deadband = 2e-4;
  bool zmp_modification = true;
  Iteration iteration = Iteration::kClosedForm;
  double zmp_threshold = 1e-3;
  int max_iterations = 200;
  double sole_fraction = 0.72, sole_exponent = 0.5, ankle_torque_fraction = 0.9;
  bool bound_lateral = true;
  // COM
  double least_knee = 0.3, crouch_limit = kNaN, crouch_margin = 1.2, crouch_time = kNaN;
  ComState com_state = ComState::kMeasured;
  bool feed_forward = true;
  double com_x_kp = kNaN, com_x_kd = kNaN, com_y_kp = kNaN, com_y_kd = kNaN, com_z_kp = kNaN, com_z_kd = kNaN;
  // Lateral motion (III-D)
  bool lateral_feedback = true;
  double lateral_reach = 0.4;
  // Footsteps and the swing foot
  Footsteps footsteps = Footsteps::kTied;
  std::vector<double> step_lengths;
  double step_width = kNaN, foot_clearance = kNaN, step_height = kNaN, foothold_reach = kNaN, com_lead = kNaN,
         foothold_time = kNaN, foothold_give = 0.3, foothold_freeze = 0.7, capture_reach = kNaN, capture_speed = kNaN;
  bool swing_feed_forward = true;
  double swing_kp = kNaN, swing_kd = kNaN;
  // The other tasks, double support
  double trunk_kp = kNaN, trunk_kd = kNaN, posture_kp = kNaN, posture_kd = kNaN;
  double motion_blend = kNaN, momentum_arms = 0.0, momentum_kp = kNaN, momentum_kd = kNaN;
  bool posture_task = true, wrench_distribution = true, textbook = false;
  double load_alone = 0.7, contact_damping = 100.0;
  double singular_damping = 1e-3, singular_pivot = 1e-2;
  double friction_velocity = 0.02;
  std::string kernel = "auto";
  std::map<std::string, double> torque_limits;
  // A fall
  double fall_height = 0.8, fall_tilt = 0.8, fall_foot_tilt = 0.3;
};

/// Calls `v(name, member, unit, meaning)` for every setting of `s`, in one order, for tables, keywords and files.
template <class Settings, class Visitor>
void visit_settings(Settings& s, Visitor&& v) {
  v("control_dt", s.control_dt, "s", "control period, a multiple of the model's time step; NaN: the model's time step");
  v("T_ds", s.T_ds, "s", "double support time; NaN: one fifth of the step period, which goes as sqrt(COM height)");
  v("T_ss", s.T_ss, "s", "single support time; NaN: four fifths of the step period");
  v("T_ds_first", s.T_ds_first, "s", "first double support; NaN: computed so that the lateral orbit starts symmetric");
  v("first_swing", s.first_swing, "", "foot that swings first, 'right' or 'left'");
  v("cadence_speed", s.cadence_speed, "m/s",
    "speed up to which steps take T_ds + T_ss and grow longer; NaN: 0.1 of sqrt(g COM height)");
  v("cadence_exponent", s.cadence_exponent, "",
    "above it, steps take (cadence_speed / speed)^cadence_exponent of that; 0: always the same; NaN: 0.4, and 0 "
    "where a list sets the lengths");
  v("cadence_double", s.cadence_double, "",
    "and the double support's share of a step goes as (cadence_speed / speed)^cadence_double");
  v("cadence_sideways", s.cadence_sideways, "", "what 1 m/s sideways counts as forward, for the cadence");
  v("cadence_turning", s.cadence_turning, "m/rad",
    "what 1 rad/s counts as forward, for the cadence; NaN: 0.54 of the COM height");
  v("stand", s.stand, "", "stand, feet side by side, while the profile is zero; False: step on the spot");
  v("stand_gain", s.stand_gain, "", "standing: how far the ZMP goes beyond the DCM, per distance from the middle");
  v("closing_reach", s.closing_reach, "m",
    "the last step goes beside the stance foot where the DCM will be this near; NaN: 0.1 of the COM height");
  v("closing_turn", s.closing_turn, "rad", "and where the headings of path and stance foot differ by no more");
  v("rate_limit", s.rate_limit, "", "limit how fast the planned velocity changes; False: take profiles as they are");
  v("forward_jump", s.forward_jump, "m/s", "change of v_x that passes at once; NaN: 0.036 of sqrt(g COM height)");
  v("sideways_jump", s.sideways_jump, "m/s", "change of v_y that passes at once; NaN: 0.03 of sqrt(g COM height)");
  v("turning_jump", s.turning_jump, "rad/s", "change of w_z that passes at once; NaN: 0.07 / T_c");
  v("forward_acceleration", s.forward_acceleration, "m/s^2", "at which v_x grows beyond that; NaN: 0.02 g");
  v("forward_deceleration", s.forward_deceleration, "m/s^2", "at which v_x goes back to zero; NaN: 0.056 g");
  v("sideways_acceleration", s.sideways_acceleration, "m/s^2", "at which v_y follows beyond that; NaN: 0.025 g");
  v("turning_acceleration", s.turning_acceleration, "rad/s^2", "at which w_z follows beyond that; NaN: 0.08 / T_c^2");
  v("tracker", s.tracker, "", "velocity tracker: 'smooth' or 'bang_bang' (III-C as printed)");
  v("tracker_gain", s.tracker_gain, "1/s",
    "smooth tracker: speed asked for per metre of integrated error; NaN: 1.38 / T_c");
  v("tracker_time", s.tracker_time, "s", "smooth tracker: time in which a speed error is removed; NaN: 0.18 T_c");
  v("tracker_reach", s.tracker_reach, "m/s",
    "smooth tracker: largest speed beside the planned one that removes an integrated error; NaN: 0.03 of sqrt(g COM "
    "height)");
  v("tracker_deadband", s.tracker_deadband, "m",
    "bang-bang tracker: integrated error that counts as zero before a drive starts");
  v("zmp_modification", s.zmp_modification, "",
    "keep the estimated ZMP inside its bounds (III-B, III-C); False: track v_plan blindly");
  v("iteration", s.iteration, "",
    "how the reference ZMP is found: 'closed_form' or 'loop' (III-B), or 'none': the desired ZMP as the pendulum has "
    "it, the "
    "estimate changes nothing");
  v("zmp_threshold", s.zmp_threshold, "m", "|desired - estimated ZMP| at which the loop ends (section IV)");
  v("max_iterations", s.max_iterations, "", "bound of the loop");
  v("sole_fraction", s.sole_fraction, "", "share of the sole that the ZMP may use");
  v("sole_exponent", s.sole_exponent, "",
    "above cadence_speed the ZMP uses less of the sole's length, as (cadence_speed / speed)^sole_exponent: at its "
    "edges the contact chatters");
  v("ankle_torque_fraction", s.ankle_torque_fraction, "", "share of the ankle's torque limit that may hold the ZMP");
  v("bound_lateral", s.bound_lateral, "", "bound the lateral ZMP too; the paper bounds the sagittal one only");
  v("least_knee", s.least_knee, "rad",
    "knee angle that the plan keeps: room for what it does not know, as swing leg and pelvis move the hips against the "
    "COM");
  v("crouch_limit", s.crouch_limit, "m", "how far the COM may come down for long steps; NaN: 0.1 of its height");
  v("crouch_margin", s.crouch_margin, "",
    "the COM comes down until the legs reach this many times as far as the feet are from the hips in double support");
  v("crouch_time", s.crouch_time, "s", "time constant of that; NaN: 0.5 T_c");
  v("com_state", s.com_state, "", "'current' COM state in (16), (17): 'measured' or 'desired' (the previous one)");
  v("feed_forward", s.feed_forward, "", "add the pendulum's acceleration to (8)");
  v("com_x_kp", s.com_x_kp, "1/s^2", "COM, forward; NaN: scaled with 1/T_c^2");
  v("com_x_kd", s.com_x_kd, "1/s", "COM, forward; NaN: scaled with 1/T_c");
  v("com_y_kp", s.com_y_kp, "1/s^2", "COM, lateral");
  v("com_y_kd", s.com_y_kd, "1/s", "COM, lateral");
  v("com_z_kp", s.com_z_kp, "1/s^2", "COM, height");
  v("com_z_kd", s.com_z_kd, "1/s", "COM, height");
  v("lateral_feedback", s.lateral_feedback, "",
    "shift the lateral reference ZMP so that the orbit repeats; False: (17) alone");
  v("lateral_reach", s.lateral_reach, "", "largest such shift, as a share of the half sole width");
  v("footsteps", s.footsteps, "", "'tied' to the COM, 'absolute', 'paper', 'printed' or 'list' (step_lengths)");
  v("step_lengths", s.step_lengths, "m", "lead of each step over the stance foot, the last one repeated");
  v("step_width", s.step_width, "m", "lateral distance of the feet; NaN: as they stand at the start");
  v("foot_clearance", s.foot_clearance, "m",
    "least distance of the soles' edges sideways; NaN: 0.03 of the COM height");
  v("step_height", s.step_height, "m",
    "height of the swing foot; NaN: 0.0535 of the COM height, less (to 0.01) where the knee's rotor and damping would "
    "take "
    "over 0.6 of its torque at the profile's top speed");
  v("foothold_reach", s.foothold_reach, "m",
    "tied footholds: largest distance from the nominal foothold; NaN: 0.25 of the COM height");
  v("com_lead", s.com_lead, "m",
    "tied footholds: how far the COM rides ahead of the middle of the feet, so that a foot is not loaded on its heel; "
    "NaN: 0.0134 of the COM height");
  v("foothold_time", s.foothold_time, "s",
    "tied footholds: time constant of the low-pass on the target; NaN: 0.18 T_c");
  v("foothold_give", s.foothold_give, "",
    "tied footholds: an excess speed moves the DCM; up to this share of the bounds the ZMP of the next stance takes it "
    "up, what is more moves the foothold");
  v("foothold_freeze", s.foothold_freeze, "",
    "tied footholds: share of the single support after which the target stands");
  v("capture_reach", s.capture_reach, "m",
    "tied footholds: how far the DCM may be from where the plan has it as the next foot takes over: beyond, the COM's "
    "speed yields; NaN: 0.07 of the COM height");
  v("capture_speed", s.capture_speed, "m/s", "by how much it yields at most; NaN: 0.2 of sqrt(g COM height)");
  v("swing_feed_forward", s.swing_feed_forward, "", "add the spline's acceleration to the swing foot's task");
  v("swing_kp", s.swing_kp, "1/s^2", "swing foot, position and orientation");
  v("swing_kd", s.swing_kd, "1/s", "swing foot, position and orientation");
  v("trunk_kp", s.trunk_kp, "1/s^2", "trunk orientation");
  v("trunk_kd", s.trunk_kd, "1/s", "trunk orientation");
  v("posture_kp", s.posture_kp, "1/s^2", "joints that are in no leg");
  v("posture_kd", s.posture_kd, "1/s", "joints that are in no leg");
  v("motion_blend", s.motion_blend, "s",
    "time in which a joint motion takes over from the reference before it; NaN: 1.8 T_c");
  v("momentum_arms", s.momentum_arms, "",
    "share of the yaw momentum of legs and trunk that the arms swing to cancel, 0 to 1; joints that a motion names do "
    "not swing");
  v("momentum_kp", s.momentum_kp, "1/s^2", "swinging arms: spring to the posture");
  v("momentum_kd", s.momentum_kd, "1/s", "swinging arms: rate at which the robot's yaw momentum is brought to zero");
  v("posture_task", s.posture_task, "", "stack the posture of waist and arms");
  v("wrench_distribution", s.wrench_distribution, "",
    "share the load of two standing feet; False: minimum-norm torque");
  v("load_alone", s.load_alone, "",
    "double support: while the ZMP is this near to a sole's centre line, in half sole widths, that foot carries "
    "everything: a foot that just landed chatters under a light load");
  v("contact_damping", s.contact_damping, "1/s",
    "damping of the velocity of a standing foot that does not carry the ZMP: without load it would drift off the "
    "ground");
  v("textbook", s.textbook, "", "equations 1-13 as printed instead of the direct path: slower, the same numbers");
  v("singular_damping", s.singular_damping, "", "damping of the motion where a leg is straight");
  v("singular_pivot", s.singular_pivot, "", "pivot below which a leg counts as straight");
  v("friction_velocity", s.friction_velocity, "rad/s",
    "joint speed below which dry friction is taken as proportional to speed");
  v("kernel", s.kernel, "",
    "build of the inner loops: 'auto', the best that this processor runs, or one of build_info()['kernels']");
  v("torque_limits", s.torque_limits, "N m",
    "torque limits by joint name, in place of the robot's own; a motor still gives no more than the model lets "
    "through");
  v("fall_height", s.fall_height, "",
    "COM height over the support foot, as a share of the start's, that counts as a fall");
  v("fall_tilt", s.fall_tilt, "rad", "trunk tilt that counts as a fall");
  v("fall_foot_tilt", s.fall_foot_tilt, "rad", "tilt of the foot that stands alone that counts as a fall");
}

/// What the defaults scale with.
struct RobotScale {
  double com_height = 0.0;     ///< over the soles, at the start pose [m]
  double gravity = 0.0;        ///< [m/s^2]
  double timestep = 0.0;       ///< of the model [s]
  double foot_distance = 0.0;  ///< lateral, at the start pose [m]
  // What it costs the knee to swing the foot; nothing by default.
  double hip_to_ankle = std::numeric_limits<double>::infinity();  ///< at the start pose, seen from the side [m]
  double knee_per_lift = 0.0;  ///< knee angle per shortening of that distance, at the start pose [rad/m]
  double knee_armature = 0.0;  ///< [kg m^2]
  double knee_damping = 0.0;   ///< [N m s/rad]
  double knee_torque = std::numeric_limits<double>::infinity();  ///< limit [N m]
};

/// Share of the knee's torque limit that its own rotor and damping take as the swing foot leaves the ground.
///
/// The cubics start with 6 h / (T_ss/2)^2 upward and 6 (2 v T) / T_ss^2 forward; the latter shortens the leg by x / l of it, where
/// the hip is x = v (T + T_ds) / 2 ahead of the ankle.
/// @param s T_ss, T_ds set   @param lift h [m]   @param speed v [m/s]
double knee_share(const RobotScale& robot, const WalkSettings& s, double lift, double speed);

/// `settings` with every NaN replaced by the robot's value, all checked.
/// @param top_speed  that the robot is to walk at [m/s]
/// @throws InputError  a value that breaks a rule: the message gives name, value and rule
WalkSettings resolve(const WalkSettings& settings, const RobotScale& robot, double top_speed = 0.0);

/// Lead lengths of section IV, corrected (0.1, 0.15, 0.2, 0.2, ...) and as printed (0.25 from the fourth on) [m].
const std::vector<double>& paper_step_lengths();
const std::vector<double>& printed_step_lengths();

// Names of the choices, for Python and messages. @throws InputError unknown name, naming those that exist
std::string to_string(Footsteps value);
std::string to_string(ComState value);
std::string to_string(TrackerLaw value);
std::string to_string(Iteration value);
void from_string(const std::string& name, Footsteps& out);
void from_string(const std::string& name, ComState& out);
void from_string(const std::string& name, TrackerLaw& out);
void from_string(const std::string& name, Iteration& out);

}  // namespace zmpwalk
