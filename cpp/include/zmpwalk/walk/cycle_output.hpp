#pragma once

#include <array>
#include <string>

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// Why a walk ended.
enum class Fall : int { kNone = 0, kHeight, kTilt, kFootTipped, kNonFinite, kNoContact };
std::string to_string(Fall fall);

/// Everything one cycle decided; every number that a figure shows. SI, W, unless said.
struct CycleOutput {
  double t = 0.0;                                           ///< simulation time of the state [s]
  Vec3 com = Vec3::Zero(), dcom = Vec3::Zero();             ///< measured
  Vec3 com_des = Vec3::Zero(), dcom_des = Vec3::Zero();     ///< for the next cycle: x_d, v_d of (16), (17)
  double heading = 0.0;                                     ///< of the walk, in W [rad]
  Vec3 command = Vec3::Constant(kNaN);                      ///< live command in force; NaN while the profile leads
  Vec3 v_plan = Vec3::Zero();                               ///< planned velocity (v_x, v_y, w_z), heading frame
  Vec3 v_des = Vec3::Zero();                                ///< desired velocity, heading frame
  Vec3 v_error_integral = Vec3::Zero();                     ///< integral of v_des - v_plan [m, m, rad]
  Vec2 zmp_des = Vec2::Zero();                              ///< desired
  Vec2 zmp_ref = Vec2::Zero();                              ///< reference of the pendulum
  Vec2 zmp_est = Vec2::Zero();                              ///< estimated from the torque
  Vec2 zmp_lower = Vec2::Zero(), zmp_upper = Vec2::Zero();  ///< designed bounds
  Vec2 zmp_first =
      Vec2::Constant(kNaN);          ///< estimate of the first pass (r_ref = r_des); NaN where the ZMP was left alone
  Vec4 zmp_plane{0, 0, 1, 0};        ///< the plane that every zmp_* lies on: normal, and its distance from the origin
  Vec2 zmp_slope = Vec2::Zero();     ///< d zmp_est / d zmp_ref, each axis
  Vec2 zmp_modified = Vec2::Zero();  ///< -1 brought to the lower bound, +1 to the upper, 0 left alone
  int phase = 0;                     ///< 0 double, 1 single support
  int support = 1;                   ///< +1 left, -1 right
  int step = 0;
  bool at_rest = false;                             ///< stands, and is not asked to walk
  double phase_time = 0.0;                          ///< [s]
  double w_T = kNaN;                                ///< Eq. 18 [m/s]
  int iterations = 0;                               ///< passes of III-B; 0 where the ZMP was left alone
  Vec3 foothold = Vec3::Constant(kNaN);             ///< target of the swing foot: x, y, yaw
  std::array<Eigen::Matrix<double, 7, 1>, 2> foot;  ///< sole poses: position, quaternion (w, x, y, z); left, right
  VecX tau;                                         ///< (nu of the robot,) in the order of its joints [N m]
  Vec12 f_c = Vec12::Constant(kNaN);                ///< expected contact wrenches, robot on ground, left then right
  double torque_ratio = 0.0;                        ///< largest |tau| / limit
  bool saturated = false;                           ///< a torque was cut to its limit
  bool damped = false;                              ///< a straight leg damped the motion
  bool fresh = false;  ///< computed in this call; false where the torque of an earlier one is held
  Fall fell = Fall::kNone;
};

}  // namespace zmpwalk
