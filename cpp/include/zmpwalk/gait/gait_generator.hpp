#pragma once

#include "zmpwalk/gait/footsteps.hpp"
#include "zmpwalk/gait/lateral_motion.hpp"
#include "zmpwalk/gait/pendulum.hpp"
#include "zmpwalk/gait/schedule.hpp"
#include "zmpwalk/gait/swing_foot.hpp"
#include "zmpwalk/gait/velocity_profile.hpp"
#include "zmpwalk/settings.hpp"

namespace zmpwalk {

/// What the gait needs to see of the robot.
struct GaitInput {
  double t = 0.0;                                                  ///< since the walk began [s]
  Vec2 com = Vec2::Zero(), dcom = Vec2::Zero();                    ///< "current" COM state of (16), (17), W [m, m/s]
  std::array<Vec3, 2> p_sole{Vec3::Zero(), Vec3::Zero()};          ///< sole centres, W [m]
  std::array<Mat3, 2> R_sole{Mat3::Identity(), Mat3::Identity()};  ///< sole orientations
  /// Height at which the swing sole meets the ground [m]; NaN: the stance sole's, which the load has sunk into a soft contact.
  double ground = kNaN;
};

/// What the gait asks for in one cycle.
struct GaitOutput {
  GaitPhase phase;
  Side support = kLeft;  ///< foot that carries the ZMP
  Side swing = kRight;   ///< foot of this step that swings, or will
  std::array<bool, 2> standing{true, true};
  Vec2 origin = Vec2::Zero();  ///< of the support frame S: support sole's centre, W [m]
  double heading = 0.0;        ///< of S: its x axis in W [rad]
  double zmp_lateral = 0.0;    ///< reference ZMP along S's y [m]
  double w_T = kNaN;           ///< Eq. 18 in double support before the switch [m/s], else NaN
  Foothold foothold;           ///< of the swing foot; NaN in double support
  SwingTarget swing_target;    ///< meaningful in single support
};

/// The gait: phases, support switch, footholds and swing foot, from time and the COM. Knows no torque and no simulator.
class GaitGenerator {
 public:
  /// @param settings resolved   @param profile must outlive the generator   @param half_sole_width [m]
  GaitGenerator(const WalkSettings& settings, const VelocityProfile& profile, double half_sole_width);

  /// Starts a walk from two standing feet. @param pendulum of this robot
  void reset(const GaitInput& start, const LinearInvertedPendulum& pendulum);
  /// One cycle. Allocates nothing.
  const GaitOutput& update(const GaitInput& in);
  /// The same without the swing foot's path, for a plan: `swing_target` keeps what it was. Allocates nothing.
  const GaitOutput& update_steps(const GaitInput& in);

  const Schedule& schedule() const { return schedule_; }
  const FootstepPlanner& footsteps() const { return footsteps_; }

 private:
  WalkSettings settings_;
  Schedule schedule_;
  FootstepPlanner footsteps_;
  LateralMotion lateral_;
  SwingFoot swing_foot_;
  LinearInvertedPendulum pendulum_;
  GaitOutput out_;
  bool changed_ = false;  // a phase began with this cycle
};

}  // namespace zmpwalk
