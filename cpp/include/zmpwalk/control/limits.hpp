#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "zmpwalk/control/least_change.hpp"
#include "zmpwalk/control/whole_body.hpp"

namespace zmpwalk {

/// A sole, as large and as rough as it is.
struct SoleGrip {
  double length = 0.0, width = 0.0;  ///< along its x and y [m]
  double friction = 0.0;             ///< tangential force per normal force that does not slip yet
  double twist =
      1.0;  ///< moment about the normal that is allowed, in shares of what friction holds with the load centred
};

/// What a sole can give, as linear rows: rows * wrench >= 0, where wrench is the ground's on the robot, in the sole's axes about its centre.
///
/// The sole presses and does not pull (1 row); the force along it is within the friction (8 rows, an octagon in the circle); the centre of
/// pressure is on it (4); its corners, each with its own friction, can hold the moment about the normal (8). The last are those of S.
/// Caron, Q.-C. Pham and Y. Nakamura, "Stability of surface contacts for humanoid robots", ICRA 2015; see `sole_rows`.
enum class SoleLimit : int { kLoad = 0, kFriction, kCop, kYaw };
inline constexpr int kSoleRows = 21;
using SoleRows = Eigen::Matrix<double, kSoleRows, 6>;

/// The rows of `SoleLimit`. With half sizes X, Y and a corner's friction k along each axis, a force f at the corners (x_i, y_i) obeys
///
///   sum of (Y -+ y_i) (k f_iz -+ f_ix) + (X +- x_i) (k f_iz -+ f_iy) >= 0,
///
/// since no bracket is negative; the sums are F and M, and give k (X + Y) F_z -+ ... >= +-M_z. k is the friction times
/// sqrt(X^2 + Y^2) / (X + Y), with which a pure twist about the centre slips where every corner slips on its circle.
///
/// @param weight  m g [N], by which rows are divided; rows of moments by half the sole's size too
SoleRows sole_rows(const SoleGrip& grip, double weight);
/// Which limit row i of `sole_rows` is.
SoleLimit sole_limit(int row);

/// The limits that hold a torque back, as bits.
struct ActiveLimits {
  int feet = 0;              ///< bit 4 side + SoleLimit
  std::int64_t torques = 0;  ///< bit j: torque of joint j
  std::int64_t ranges = 0;   ///< bit j: range of joint j

  static constexpr int kJoints = 53;  ///< that bits can name: a record keeps them as floating-point numbers
  bool any() const { return feet != 0 || torques != 0 || ranges != 0; }
  /// Whether the yaw friction of a sole is one of them.
  bool holds_yaw() const { return (feet >> static_cast<int>(SoleLimit::kYaw) & 0x11) != 0; }
  /// In words, as "torque of l_knee", "range of r_hip_yaw", "friction of the left sole".
  std::vector<std::string> names(const std::vector<std::string>& joints) const;
};

/// What a robot's torque and motion must keep to.
struct RobotLimits {
  VecX torque;                                   ///< of each joint [N m], infinite where there is none
  std::vector<std::pair<double, double>> range;  ///< of each joint [rad or m], infinite where there is none
  std::array<SoleGrip, 2> sole;
  double weight = 0.0;        ///< m g [N]
  double height = 0.0;        ///< z_c of the COM over the soles [m]
  double range_margin = 0.0;  ///< how far from the end of its range a joint stops [rad or m]
  double range_rate = 0.0;    ///< k of `LimitKeeper` [1/s]
};

/// The torque nearest to that of the closed form that keeps all limits.
///
/// Nearest is said of the tasks: they give way as `TaskGive` says, until
///   - every torque of a leg's joint is within its limit; those of the other joints are not looked at,
///   - every standing sole gives a wrench that it can, `sole_rows`,
///   - every joint of a leg can still stop before the end of its range: ddq <= k (k/4 (end - q) - dq), which comes to rest there as a critically
///     damped joint does; the same at the other end.
/// Motion, wrenches and torque are affine in what gives, so that this is `LeastChange`; what comes out satisfies the equations of motion
/// as the closed form does. Where no motion keeps all limits, the soles' and ranges' give, by as little as it takes.
class LimitKeeper {
 public:
  using Change = Eigen::Matrix<double, TaskSlack::kColumns, 1>;

  /// @param limits  of the robot   @param whole_body  whose results are to be kept; it outlives this
  /// @throws InputError  a sole without size or friction, a rate or weight that is not positive
  LimitKeeper(const RobotLimits& limits, const WholeBodyController& whole_body);

  /// Brings `out`, the closed form's result for the instant that `whole_body` was prepared for, within the limits. Allocates nothing.
  ///
  /// @returns false where that is not possible; `out` is then as it was
  bool keep(const Dynamics& dynamics, const Stance& stance, WholeBodyResult& out);

  /// Lets the sole `side` give no more than this friction > 0 from now on. Allocates nothing.
  void set_friction(Side side, double friction);

  const ActiveLimits& active() const { return active_; }  ///< those that held the last torque back
  /// What the last call has changed, in the sizes of `give()`; zero where nothing was.
  const Change& change() const { return change_; }
  /// By how much the last torque breaks limits of soles and ranges, in shares of them, because no motion keeps all; where one does, this
  /// is less than 1e-5.
  double excess() const { return excess_; }
  const TaskGive& give() const { return give_; }
  int passes() const { return least_.passes(); }  ///< of the last `LeastChange`

 private:
  using SoleRoom = Eigen::Matrix<double, kSoleRows, 1>;  // of the rows, in shares of their limits
  enum class Kind { kTorque, kRange, kSole };
  struct Named {
    Kind kind;
    int which;  // joint, or kSoleRows side + row of the sole
  };

  bool are_kept(const Dynamics& dynamics, const Stance& stance, const WholeBodyResult& out);
  SoleRoom sole_room(Side side, const WholeBodyResult& out) const;
  bool solve(const Stance& stance, WholeBodyResult& out);
  void note(const Named& row);

  RobotLimits limits_;
  const WholeBodyController* whole_body_;
  std::array<SoleRows, 2> sole_rows_;
  TaskGive give_;
  // Of this instant: bounds of ddq, and the room of the soles' rows at the closed form's torque.
  VecX upper_, lower_;
  std::array<SoleRoom, 2> sole_room_;
  TaskSlack slack_;
  LeastChange least_;
  std::array<Named, LeastChange::kRows> named_;
  ActiveLimits active_;
  Change change_ = Change::Zero();
  double excess_ = 0.0;
};

}  // namespace zmpwalk
