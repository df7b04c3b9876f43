#pragma once

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <vector>

#include "zmpwalk/control/contact_space.hpp"
#include "zmpwalk/control/dynamics.hpp"
#include "zmpwalk/control/kernel_choice.hpp"
#include "zmpwalk/control/task_solver.hpp"
#include "zmpwalk/control/task_space.hpp"
#include "zmpwalk/control/task_stack.hpp"
#include "zmpwalk/zmp/estimate.hpp"

namespace zmpwalk {

/// Commanded accelerations f* of the walk's own tasks.
struct TaskAccelerations {
  Vec3 com = Vec3::Zero();    ///< COM, W [m/s^2]
  Vec3 trunk = Vec3::Zero();  ///< base orientation, world axes [rad/s^2]
  Vec6 swing = Vec6::Zero();  ///< swing sole, linear then angular, world axes; used where one foot stands
  VecX posture;               ///< (joints,) [rad/s^2]; entries of leg joints are not used
};

/// Which feet stand, on what ground, and which of them carries the ZMP.
struct Stance {
  std::array<bool, 2> standing{true, true};
  Side support = kLeft;
  Vec3 lateral = Vec3::UnitY();   ///< horizontal direction in which two feet share the load
  std::array<Plane, 2> ground{};  ///< under the left and the right foot; only how they lie to each other matters
  bool both() const { return standing[kLeft] && standing[kRight]; }
  Side swing() const { return standing[kLeft] ? kRight : kLeft; }  ///< meaningful where one foot stands
};

/// How the torque is found. A walk takes these defaults; other values show what an ingredient is for.
struct WholeBodyOptions {
  bool textbook = false;  ///< equations 1-13 as printed instead of the direct path
  bool posture_task =
      true;  ///< waist and arms follow the posture; without it the torque of least norm decides their motion
  bool wrench_distribution =
      true;  ///< two feet share the load by the place of the ZMP; without it the torque of least norm decides
  double load_alone = 0.0;       ///< distance of the ZMP from a sole centre within which that foot carries all load [m]
  double contact_damping = 0.0;  ///< of a standing foot that does not carry the ZMP [1/s]: without load it would drift
  double damping = 1e-3;         ///< of the least-squares motion where a leg is straight [1 in rows of K]
  double singular_pivot = 1e-2;  ///< pivot below which the legs count as singular
  std::string kernel = "auto";   ///< build of the inner loops, see `kernels()`
  double singular_task =
      5e-3;  ///< share of a user's task's size below which its singular values are damped, see `TaskSolver`
};

/// Torque, motion and contact wrenches of one cycle.
struct WholeBodyResult {
  VecX tau;  ///< (joints,) [N m]
  VecX ddq;  ///< (nv,)
  Vec12 f_c =
      Vec12::Constant(kNaN);  ///< robot on ground, left then right, at the sole centres, world axes; NaN in the air
  bool damped = false;        ///< a leg was near singular and the motion was damped
};

/// How easily each task gives way where limits force it to: the change that counts as much as one of any other.
///
/// Changes are counted in these sizes and their squares are added up: what has the largest size gives first. The feet's share of the
/// load is no task and gives first of all; then the swing foot, the trunk, the height of the COM, and last what keeps the balance, the
/// COM's horizontal acceleration.
struct TaskGive {
  double com = 0.3, height = 3.0;              ///< [m/s^2]
  double trunk = 30.0;                         ///< [rad/s^2]
  double swing = 20.0, swing_angular = 200.0;  ///< [m/s^2], [rad/s^2]
  double load_force = 1.0, load_moment = 1.0;  ///< that one foot takes over from the other [N], [N m]
};

/// How motion, wrenches and torque answer a change of what the tasks ask for; each column in the size of `TaskGive`.
///
/// Columns 0-2: COM x, y, z; 3-5: trunk; 6-11: swing sole, linear then angular, or in double support the force and moment that the left
/// foot takes over from the right, about the middle between the sole centres. All along the world's axes. The rows of the legs are those
/// of the six joints of the left leg, then of the right one.
struct TaskSlack {
  static constexpr int kColumns = 12, kGroups = kColumns / 4;
  using Legs = Eigen::Matrix<double, 12, kColumns, Eigen::RowMajor>;

  explicit TaskSlack(int nv);

  std::array<TaskSolver::Affine, kGroups> ddq;  ///< (nv,)[4], four columns in each, as `Kernel` wants them
  std::array<TaskSolver::Affine, kGroups> w;    ///< A ddq (nv,)[4]
  Eigen::Matrix<double, 12, kColumns> f_c;      ///< left then right, zero where a foot is in the air
  Legs leg_ddq, leg_tau;
};

/// Computes the joint torques of a biped that give COM, trunk, swing foot and posture their commanded accelerations while the standing feet keep still.
///
/// With posture stacked the motion is fully determined (single support 6 + 25 rows, double support 12 + 19, for 31
/// coordinates), so the torque of (1)-(7) follows without pseudo-inverses: [J_c; J] ddq = [-drift_c; f* - drift] gives ddq,
/// the base rows of A ddq + h + J_c' f_c = S' tau give the total contact wrench, its exact sharing the wrench of each foot,
/// and the joint rows the torque. `TaskSpace` is the definition; both give the same numbers. Given the base's translation, each
/// leg follows from its own sole's six rows; the three rows of the COM then fix that translation.
///
/// Everything is affine in the horizontal COM acceleration (f*_x, f*_y), and F_z does not depend on it. So `prepare` does the work once per instant, and
/// `zmp` and `solve` then cost next to nothing for each acceleration. Only the ZMP on a tilted plane is not affine, see `zmp`.
class WholeBodyController {
 public:
  /// @param nv    velocity coordinates
  /// @param legs  joint indices of the two legs, six each, left and right
  /// @throws DimensionError; InputError an unknown kernel
  WholeBodyController(int nv, const std::array<std::vector<int>, 2>& legs, const WholeBodyOptions& options = {});

  /// Takes one instant. x and y of `f_star.com` are not used here. The direct path allocates nothing.
  ///
  /// @param tasks  the user's tasks, updated for this instant; the motion then goes through `TaskSolver` too
  /// @throws InputError no foot stands; tasks that `reserve` has not seen, or on another than the direct path; DimensionError
  void prepare(const Dynamics& dynamics, const Stance& stance, const TaskAccelerations& f_star,
               const TaskStack* tasks = nullptr);
  /// Sets memory aside for `tasks`, outside the cycle, after each change of them.
  void reserve(const TaskStack& tasks);
  /// @throws InputError  the options leave the direct path, which alone knows tasks
  void require_tasks_possible() const;

  /// Eq. 9-15 for COM acceleration `f_xy` (2,) [m/s^2]: world x and y of the ZMP on `zmp_plane` (2,) [m].
  ///
  /// Total force F and moment are affine in f_xy, and (14), (15) divide by the load n . F along the plane's normal n. On a level
  /// plane that is F_z, which the stacked COM height fixes: the ZMP is affine in f_xy. On a tilted plane the load is
  /// n . F_0 (1 + d . f_xy) with d = -m (n_x, n_y) / (n . F_0), and zmp = zmp_0 + D f_xy / (1 + d . f_xy), without approximation.
  Vec2 zmp(const Vec2& f_xy) const { return zmp_0_ + zmp_slope_ * f_xy / (1.0 + load_slope_.dot(f_xy)); }
  /// D of `zmp`: d zmp / d f_xy (2, 2) [s^2], on a level plane everywhere, on a tilted one at f_xy = 0.
  const Mat2& zmp_slope() const { return zmp_slope_; }
  /// The slope with which III-B's closed form is exact on any plane (2, 2) [s^2]: (D - (zmp_des - zmp_0) d') / (1 + d . f_xy).
  ///
  /// For the f with zmp(f) = zmp_des it is zmp_des - zmp(f_xy) = slope (f - f_xy), however far f_xy is from f, because zmp(f) = zmp_des
  /// is linear in f; row i alone holds where axis i alone is asked for. At zmp_des = zmp(f_xy) it is the derivative there; on a
  /// level plane it is D everywhere.
  Mat2 zmp_slope(const Vec2& zmp_des, const Vec2& f_xy) const {
    return (zmp_slope_ - (zmp_des - zmp_0_) * load_slope_.transpose()) / (1.0 + load_slope_.dot(f_xy));
  }
  /// The plane that the ZMP is taken on: `common_plane` of the feet, through the support sole's centre.
  const Plane& zmp_plane() const { return plane_; }
  /// The feet as `prepare` found them, left and right: sole poses, which stand, and their ground.
  const std::array<Contact, 2>& feet() const { return feet_; }

  /// d/dt L_z for COM acceleration `f_xy` [N m]: the vertical moment about the COM of the ground and of known forces. Affine in f_xy.
  double yaw_moment(const Vec2& f_xy) const;

  /// Eq. 1-7: torque for COM acceleration `f_xy`. Writes into `out`, whose vectors are sized by `result()`.
  void solve(const Vec2& f_xy, WholeBodyResult& out) const;

  /// What changes with the tasks' accelerations at this instant; on the direct path alone. Allocates nothing.
  ///
  /// A change of the total wrench is shared by two feet as they share the load in `now`. User's tasks are not kept by these changes.
  void slack(const TaskGive& give, const WholeBodyResult& now, TaskSlack& out) const;
  /// Changes `out` by the columns of `slack` times y (TaskSlack::kColumns,).
  void apply(const TaskSlack& slack, const Eigen::Matrix<double, TaskSlack::kColumns, 1>& y,
             WholeBodyResult& out) const;
  /// World x and y of the ZMP of the feet's wrenches on `zmp_plane` (2,) [m]: eq. 14, 15.
  Vec2 zmp_of(const Vec12& f_c) const;
  /// True where torque, motion and wrenches are known to be affine in the tasks: on the direct path.
  bool is_direct() const { return !uses_textbook(); }
  const std::array<std::vector<int>, 2>& legs() const { return legs_; }

  WholeBodyResult result() const;
  const WholeBodyOptions& options() const { return options_; }

 private:
  static constexpr int kUnknowns = TaskSolver::kUnknowns;  // base translation and two legs
  // What is affine in f_xy: value at f_xy = 0, slope in x, slope in y; the fourth column is zero (see Kernel).
  using Affine = TaskSolver::Affine;
  struct MotionRows {  // right sides of the rows of the soles and the COM, the known entries of ddq brought over
    std::array<Vec6, 2> sole;
    Vec3 com;
  };

  /// Velocity damping of a standing sole [1/s]: none on the support, whose contact holds it.
  double damping_of(Side side) const { return side == stance_.support ? 0.0 : options_.contact_damping; }
  void prepare_direct(const TaskAccelerations& f_star, const TaskStack* tasks);
  bool solve_by_leg(const MotionRows& rows);
  void solve_together(const MotionRows& rows);
  using Answers = Eigen::Matrix<double, kUnknowns, TaskSlack::kColumns>;
  bool answers_by_leg(const Answers& rhs, Answers& x) const;
  void answers_together(const Answers& rhs, Answers& x) const;
  TaskSolver::Rows rows_together() const;
  void prepare_textbook(const TaskAccelerations& f_star);
  void expand_zmp();
  bool uses_textbook() const { return options_.textbook || !options_.posture_task || !options_.wrench_distribution; }

  int nv_;
  std::array<std::vector<int>, 2> legs_;
  std::vector<int> posture_;  // joints that are in no leg
  std::array<int, kUnknowns> unknown_{};
  WholeBodyOptions options_;

  const Dynamics* dynamics_ = nullptr;
  Stance stance_;
  std::array<Contact, 2> feet_;
  Plane plane_;
  bool damped_ = false, tasks_acted_ = false;
  TaskSolver task_solver_;
  const Kernel* kernel_;
  VecX known_;      // entries of ddq that the trunk and posture tasks fix
  Affine ddq_, w_;  // w = A ddq + h
  Mat3 F_, M_;      // total wrench about the support sole, columns as in Affine
  Vec2 zmp_0_ = Vec2::Zero();
  Vec2 load_slope_ = Vec2::Zero();  // d of `zmp`; zero on a level plane
  Mat2 zmp_slope_ = Mat2::Zero();
  MatX3 tau_, f_c_;  // textbook path: torque and contact wrench, columns as in Affine
  RowMatX V_n_, G_;  // textbook path, two feet: internal torques and what they do to f_c
};

}  // namespace zmpwalk
