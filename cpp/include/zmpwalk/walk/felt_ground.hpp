#pragma once

#include "zmpwalk/control/dynamics.hpp"
#include "zmpwalk/gait/gait_generator.hpp"
#include "zmpwalk/settings/settings.hpp"
#include "zmpwalk/walk/height_plan.hpp"

namespace zmpwalk {

/// What the walk finds out about the ground by its feet: whether it is uneven, and how high it is.
///
/// Ground counts as uneven once the lowest corner of the foot that carries, or of a foot that meets it off its planned time, is higher or lower
/// than the ground that is followed. On even ground nothing is followed, and a walk keeps its bits. On uneven ground height h and its rate follow the
/// sole of the foot that carries by a critically damped low-pass, h'' = (h_sole - h) / T^2 - 2 h' / T. Ground that stays level counts as even again
/// after some steps.
class FeltGround {
 public:
  /// @param settings resolved   @param sole of either foot   @param z_c height of the COM over the soles [m]   @param Tc time constant of the pendulum [s]
  /// @param inertia of a foot about its ankle, rotor included, per weight of the robot, I / (m g) [m s^2]
  FeltGround(const WalkSettings& settings, const SoleSize& sole, double z_c, double Tc, double inertia);

  /// The walk starts anew on even ground whose height in W is `height` [m].
  void reset(double height);
  /// Goes on by one cycle, from what the gait has decided in it. On known ground what is felt counts from there, and the height is that of `HeightPlan` and
  /// what is felt beyond it. @param period of the steps [s]
  void update(const GaitOutput& gait, const Dynamics& dynamics, double period);

  /// Shift of the reference ZMP against the rotation of a stance sole that rocks on an edge of uneven ground, W (2,) [m]:
  /// -D (w_y, -w_x), with the angular velocity w of the sole in W, D = 0.05 z_c T_c + 3.2 I / (m g T_c). Beside an edge the torque would turn the sole faster and faster, and the impacts
  /// at either side would make the pendulum throw it back.
  Vec2 steadying(const GaitOutput& gait, const Dynamics& dynamics) const;

  bool uneven() const { return uneven_; }
  double height() const { return start_ + rise(); }        ///< of the ground that is followed, W [m]
  double felt() const { return h_; }                       ///< beyond known ground [m]
  double rise() const { return plan_.rise() + h_; }        ///< since the start [m]
  double drise() const { return plan_.drise() + dh_; }     ///< [m/s]
  double ddrise() const { return plan_.ddrise() + ddh_; }  ///< [m/s^2]

 private:
  SoleSize sole_;
  HeightPlan plan_;
  bool feels_;
  double dt_, higher_, lower_, time_, calm_time_, damping_;
  double start_ = 0.0;
  bool uneven_ = false;
  double h_ = 0.0, dh_ = 0.0, ddh_ = 0.0, level_ = 0.0, calm_ = 0.0;
};

}  // namespace zmpwalk
