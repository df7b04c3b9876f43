#pragma once

#include <array>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "zmpwalk/control/limits.hpp"
#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// Why a walk ended, or why it is foreseen to end.
enum class Fall : int { kNone = 0, kHeight, kTilt, kFootTipped, kNonFinite, kNoContact, kDown, kLost, kFootSpun };
std::string to_string(Fall fall);

/// What keeps a commanded velocity down.
enum class SpeedLimit : int { kNone = 0, kReach, kHip, kKnee, kYawFriction, kFriction };
std::string to_string(SpeedLimit limit);

/// A fall that is foreseen: since when, why, and how far the DCM was then beyond what any foothold within reach can catch.
struct ForeseenFall {
  Fall cause = Fall::kNone;
  double time = kNaN;  ///< [s]
  double gap = kNaN;   ///< [m]
  double turn = 0.0;   ///< by which the standing foot had turned on the ground since it landed [rad]
  double tip = 0.0;    ///< by which it had tipped [rad]
  explicit operator bool() const { return cause != Fall::kNone; }
};
/// One sentence; empty where no fall is foreseen.
std::string to_string(const ForeseenFall& fall);

/// Everything that one cycle decided. Every number that a figure shows is here.
///
/// Unit, frame and meaning of each number stand once, in `visit_columns`.
struct CycleOutput {
  double t = 0.0;
  Vec3 com = Vec3::Zero(), dcom = Vec3::Zero();
  Vec3 com_des = Vec3::Zero(), dcom_des = Vec3::Zero();
  double heading = 0.0;
  Vec3 command = Vec3::Constant(kNaN);
  Vec3 v_plan = Vec3::Zero(), v_des = Vec3::Zero(), v_error_integral = Vec3::Zero();
  Vec2 zmp_des = Vec2::Zero(), zmp_ref = Vec2::Zero(), zmp_est = Vec2::Zero();
  Vec2 zmp_lower = Vec2::Zero(), zmp_upper = Vec2::Zero();
  Vec4 zmp_plane{0.0, 0.0, 1.0, 0.0};
  Vec2 zmp_first = Vec2::Constant(kNaN), zmp_slope = Vec2::Zero(), zmp_modified = Vec2::Zero();
  int phase = 0, support = 1, step = 0;
  bool at_rest = false;
  double phase_time = 0.0;
  double w_T = kNaN;
  int iterations = 0;
  Vec3 foothold = Vec3::Constant(kNaN);
  std::array<Eigen::Matrix<double, 7, 1>, 2> foot;
  VecX tau;
  Vec12 f_c = Vec12::Constant(kNaN);
  Vec3 disturbance = Vec3::Zero(), attitude_bias = Vec3::Zero();
  double ground = kNaN;
  bool uneven = false;
  double friction = kNaN;
  double torque_ratio = 0.0;
  bool saturated = false, damped = false;
  ActiveLimits limits;
  SpeedLimit command_limit = SpeedLimit::kNone;
  double fall_gap = kNaN;
  ForeseenFall foreseen;
  Fall fell = Fall::kNone;
  bool fresh = false;  ///< This call computed the torque. It is no column: only fresh cycles are recorded.
};

/// A cycle as the recorder sees it after the physics step: what the cycle decided, and what the simulation then showed.
struct RecordedCycle {
  const CycleOutput& out;
  Vec2 zmp_meas;
  Vec12 contact_wrench;
  int self_contacts;
  double joint_margin;
  Eigen::Map<const VecX> qpos, qvel;
};

/// The numbers that a column holds in each row: how many there are and what they are called.
struct Parts {
  int count;          ///< how many; with `and_nv`, how many more than nv
  const char* names;  ///< one after the other; with `and_nv`, what counts them
  bool and_nv = false;
  int width(int nv) const { return count + (and_nv ? nv : 0); }
};
inline constexpr Parts kOne{1, ""}, kXy{2, "x y"}, kXyz{3, "x y z"}, kPlanar{3, "x y yaw"}, kPlane{4, "nx ny nz d"},
    kPoseParts{7, "x y z qw qx qy qz"}, kJoints{-6, "joints", true}, kVelocities{0, "nv", true},
    kPositions{1, "nv + 1", true},
    kWrenches{12,
              "left_fx left_fy left_fz left_mx left_my left_mz right_fx right_fy right_fz right_mx right_my right_mz"};

/// The one table of everything that is recorded: calls `v(name, get, parts, unit, frame, meaning)` for each column, in order.
///
/// The recorder, the properties of CycleOutput in Python, the attributes of a Trace and docs/columns.md are made from it. A new column is a
/// member above and a row here; the line that decides its value fills it. `get` reads a CycleOutput, or a RecordedCycle where the value is known
/// only after the step; see `column_value`. Frames are those of NOTATION. The meaning is one sentence that stands alone.
template <class Visitor>
void visit_columns(Visitor&& v) {
  using Out = CycleOutput;
  using After = RecordedCycle;  // once the step is done
  v("t", &Out::t, kOne, "s", "", "Time in the simulation of the state that this cycle read.");
  v("com", &Out::com, kXyz, "m", "W", "Measured position of the centre of mass (COM).");
  v("dcom", &Out::dcom, kXyz, "m/s", "W", "Measured velocity of the COM.");
  v("com_des", &Out::com_des, kXyz, "m", "W",
    "Position of the COM that the next cycle should find; eq. (16) gives its x and y.");
  v("dcom_des", &Out::dcom_des, kXyz, "m/s", "W",
    "Velocity of the COM that the next cycle should find; eq. (16) gives its x and y.");
  v("heading", &Out::heading, kOne, "rad", "W",
    "Direction in which the path leads, as an angle from the world's x axis.");
  v("command", &Out::command, kPlanar, "m/s, rad/s", "H",
    "Live velocity command that is in force; it is NaN while the velocity profile leads.");
  v(
      "command_limit", [](const Out& out) { return static_cast<int>(out.command_limit); }, kOne, "", "",
      "What keeps the live command down: 0 nothing, 1 the reach of the legs, 2 torque of a hip, 3 of a knee, 4 "
      "friction against turning on the sole, 5 friction against sliding.");
  v("v_plan", &Out::v_plan, kPlanar, "m/s, rad/s", "H",
    "Planned velocity: that of the command or the profile, changed no faster than the steps can follow.");
  v("v_des", &Out::v_des, kPlanar, "m/s, rad/s", "H",
    "Desired velocity: horizontal velocity of the COM that the next cycle should find, and the planned turning rate.");
  v("v_error_integral", &Out::v_error_integral, kPlanar, "m, rad", "H",
    "Integral over time of v_des minus v_plan, which velocity tracking (III-C) brings back to zero; it is taken along"
    " x alone and is zero in the other two.");
  v("zmp_des", &Out::zmp_des, kXy, "m", "W",
    "Desired ZMP: the bound that III-B brings the ZMP to, or the estimate itself where the ZMP is left alone.");
  v("zmp_ref", &Out::zmp_ref, kXy, "m", "W", "Reference ZMP: the ZMP that the pendulum of eq. (16) is given.");
  v("zmp_est", &Out::zmp_est, kXy, "m", "W",
    "ZMP that the torque of this cycle will produce, estimated before it is sent (eq. 14, 15).");
  v("zmp_meas", &After::zmp_meas, kXy, "m", "W",
    "ZMP of the contact forces that MuJoCo applied under this torque, on the plane of the estimate through the sole as "
    "the contacts found it; it is NaN without contact.");
  v("zmp_lower", &Out::zmp_lower, kXy, "m", "W",
    "Corner of the designed bounds of the ZMP that lies at their lower end along both axes of the support sole.");
  v("zmp_upper", &Out::zmp_upper, kXy, "m", "W",
    "Corner of the designed bounds of the ZMP that lies at their upper end along both axes of the support sole.");
  v("zmp_plane", &Out::zmp_plane, kPlane, "m", "W",
    "Plane that every zmp_* lies on, as the points p with n . p = d: its unit normal n, which has no unit, and d.");
  v("zmp_first", &Out::zmp_first, kXy, "m", "W",
    "Estimated ZMP of the first pass of III-B, whose reference is the desired ZMP; it is NaN where the ZMP is left "
    "alone.");
  v("zmp_slope", &Out::zmp_slope, kXy, "", "S",
    "Derivative of the estimated ZMP with respect to the reference ZMP, along each axis of the support sole.");
  v("zmp_modified", &Out::zmp_modified, kXy, "", "S",
    "What III-B does along each axis of the support sole: -1 brings the ZMP to the lower bound, +1 to the upper "
    "bound, 0 leaves it alone.");
  v("phase", &Out::phase, kOne, "", "", "Phase of the step: 0 is double support, 1 is single support.");
  v("support", &Out::support, kOne, "", "", "Foot that carries the ZMP: +1 is the left foot, -1 the right foot.");
  v("step", &Out::step, kOne, "", "",
    "Number of the step, from 0 on; a step is a double support and the single support after it.");
  v("at_rest", &Out::at_rest, kOne, "", "", "Whether the robot stands and is not asked to walk.");
  v("phase_time", &Out::phase_time, kOne, "s", "", "Time since the phase began.");
  v("w_T", &Out::w_T, kOne, "m/s", "H",
    "Lateral velocity that the COM would have in the middle of the next single support if the ZMP switched feet now "
    "(eq. 18); it is NaN while no switch is awaited.");
  v("iterations", &Out::iterations, kOne, "", "", "Number of passes of III-B; it is 0 where the ZMP is left alone.");
  v("foothold", &Out::foothold, kPlanar, "m, rad", "W",
    "Place and direction in which the swing foot is to land; it is NaN in double support.");
  v(
      "foot_left", [](const Out& out) -> const auto& { return out.foot[kLeft]; }, kPoseParts, "m", "W",
      "Pose of the left sole: position of its centre, and unit quaternion of its axes.");
  v(
      "foot_right", [](const Out& out) -> const auto& { return out.foot[kRight]; }, kPoseParts, "m", "W",
      "Pose of the right sole: position of its centre, and unit quaternion of its axes.");
  v("tau", &Out::tau, kJoints, "N m", "", "Torque that is sent to each joint.");
  v("f_c", &Out::f_c, kWrenches, "N, N m", "W",
    "Wrench of the robot on the ground that is expected under each foot, at the centre of its sole; f_z < 0 where the"
    " foot carries, and a foot in the air has NaN.");
  v("contact_wrench", &After::contact_wrench, kWrenches, "N, N m", "W",
    "Wrench of the robot on the ground that MuJoCo's contacts gave under each foot, at the centre of its sole; a foot"
    " without contact has NaN.");
  v("disturbance", &Out::disturbance, kXyz, "m/s^2", "W",
    "Steady acceleration of the COM that the command does not explain and that is made up for: x and y as a force, z "
    "as "
    "a mass that differs from the model's.");
  v("attitude_bias", &Out::attitude_bias, kXyz, "rad", "B",
    "Rotation vector of the bias that was found in the measured attitude and is taken out of it.");
  v("ground", &Out::ground, kOne, "m", "W",
    "Height of the ground that the walk follows: that of the soles at the start until the ground is felt to be "
    "uneven.");
  v("uneven", &Out::uneven, kOne, "", "", "Whether the ground has been felt to be uneven.");
  v("friction", &Out::friction, kOne, "", "",
    "Friction that the feet are believed to have; it falls where a foot slips, and recovers slowly.");
  v("torque_ratio", &Out::torque_ratio, kOne, "", "",
    "Largest ratio of a joint's torque to its limit, before limits are kept or torques cut.");
  v("saturated", &Out::saturated, kOne, "", "",
    "Whether a torque was cut to its limit, because no motion keeps the limits or because keep_limits is off.");
  v(
      "limit_soles", [](const Out& out) { return out.limits.feet; }, kOne, "", "",
      "Limits of the soles that held the torque back, as a sum: 1 load, 2 friction, 4 centre of pressure, 8 yaw "
      "friction "
      "of the left sole, and 16 times these of the right one.");
  v(
      "limit_torques", [](const Out& out) { return out.limits.torques; }, kOne, "", "",
      "Joints whose torque limit held the torque back, as a sum: 2^j for joint j, from 0 on.");
  v(
      "limit_ranges", [](const Out& out) { return out.limits.ranges; }, kOne, "", "",
      "Joints whose range held the torque back, as a sum: 2^j for joint j, from 0 on.");
  v("damped", &Out::damped, kOne, "", "", "Whether the motion was damped because a leg is nearly straight.");
  v("self_contacts", &After::self_contacts, kOne, "", "",
    "Number of contacts between two bodies of the robot while this torque acted.");
  v("joint_margin", &After::joint_margin, kOne, "rad or m", "",
    "Distance from its limit of the joint that is nearest to one, after this torque acted; it is infinite without "
    "limits.");
  v("fall_gap", &Out::fall_gap, kOne, "m", "",
    "How far the DCM (COM + T_c times its velocity) is beyond what any foothold within reach can catch; it is 0 where "
    "one "
    "can, and NaN where falls are not foreseen.");
  v(
      "fall_foreseen", [](const Out& out) { return static_cast<bool>(out.foreseen); }, kOne, "", "",
      "Whether a fall is foreseen; it stays so until the walk is started anew.");
  v(
      "fell", [](const Out& out) { return out.fell != Fall::kNone; }, kOne, "", "",
      "Whether the robot has fallen, which ends the walk.");
  v("qpos", &After::qpos, kPositions, "m, rad", "W",
    "Configuration of the robot as the cycle began, as in MuJoCo: position and unit quaternion of the base, then the "
    "joints.");
  v("qvel", &After::qvel, kVelocities, "m/s, rad/s", "W",
    "Velocity of the robot as the cycle began, as in MuJoCo: of the base, its rotation in its own axes, then of the "
    "joints.");
}

/// True where a cycle decides the column by itself: then it is also a property of CycleOutput in Python.
template <class Get>
inline constexpr bool is_decided = std::is_invocable_v<const Get&, const CycleOutput&>;

/// What `get` of a column reads.
template <class Get>
decltype(auto) column_value(const Get& get, const RecordedCycle& cycle) {
  if constexpr (is_decided<Get>)
    return std::invoke(get, cycle.out);
  else
    return std::invoke(get, cycle);
}

/// A row of the table as a plain value.
struct RecordedColumn {
  std::string name;
  Parts parts;
  std::string unit, frame, meaning;
  bool decided;  ///< by the cycle itself; else it is known only after the step
  /// Meaning, size, names of the parts, unit and frame in words.
  std::string text() const;
};
/// The table, in the order of the record.
std::vector<RecordedColumn> recorded_columns();

}  // namespace zmpwalk
