#pragma once

#include "zmpwalk/control/whole_body.hpp"
#include "zmpwalk/gait/velocity_tracker.hpp"
#include "zmpwalk/settings/settings.hpp"
#include "zmpwalk/walk/cycle.hpp"

namespace zmpwalk {

/// What III-B and III-C decide in one cycle. Vectors are in the support frame S.
struct Reference {
  Vec2 x_d = Vec2::Zero(), v_d = Vec2::Zero();  ///< desired COM state of the next cycle, (16) [m, m/s]
  Vec2 f = Vec2::Zero();                        ///< commanded COM acceleration, (8) [m/s^2]
  Vec2 zmp_des = Vec2::Zero();                  ///< desired ZMP [m]
  Vec2 zmp_ref = Vec2::Zero();                  ///< reference ZMP of the pendulum [m]
  Vec2 zmp_est = Vec2::Zero();                  ///< ZMP estimated for `f` [m]
  Vec2 zmp_first = Vec2::Constant(kNaN);        ///< estimated ZMP of the first pass, on an axis that III-B changes [m]
  Vec2 zmp_slope = Vec2::Zero();                ///< d zmp_est / d zmp_ref of each axis
  Vec2 modified =
      Vec2::Zero();    ///< what III-B does on each axis: ZMP to the lower bound (-1) or upper (+1), or nothing (0)
  int iterations = 0;  ///< passes of III-B
};

/// Chooses the horizontal acceleration of the COM, so that it follows the planned velocity while the estimated ZMP stays inside its bounds.
///
/// `decide` does so in three steps. First it takes a COM state and acceleration from the pendulum, or from the planned velocity alone. Then it says where
/// the ZMP should be: where it is estimated for that acceleration, but inside its bounds; or on a bound, while the tracker's law drives it there. At last
/// (III-B) it finds the reference of the pendulum for which the estimated ZMP is the desired one.
class ComReference {
 public:
  /// @param settings resolved
  explicit ComReference(const WalkSettings& settings);

  /// Takes the pendulum of the present height of the COM.
  void set_pendulum(const LinearInvertedPendulum& pendulum);

  /// @param whole_body prepared for this instant: it gives the ZMP of an acceleration. Allocates nothing.
  Reference decide(const Cycle& cycle, const VelocityTracker& tracker, const WholeBodyController& whole_body) const;

 private:
  struct Desired {     // what a reference ZMP leads to, in S
    Vec2 x_d, v_d, f;  // COM state of the next cycle (16), and commanded acceleration (8)
  };
  Desired under(const Vec2& r, const Cycle& cycle) const;
  /// The desired velocity is the planned one, along x; returns the reference ZMP that this takes without III-B.
  double track_plan(const Cycle& cycle, Desired& c) const;
  Vec2 want(const Vec2& zmp, const ZmpBounds& room, Drive drive) const;

  bool modifies_, estimates_, bounds_lateral_, feed_forward_;
  Iteration iteration_;
  double dt_, threshold_;
  int max_iterations_;
  Vec2 kp_, kd_;
  LinearInvertedPendulum::Over over_dt_;  // of a control period
  Vec2 df_dr_ = Vec2::Zero();             // of (8) with (16), each axis [1/s^2]
};

}  // namespace zmpwalk
