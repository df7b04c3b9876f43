#pragma once

#include <vector>

#include "zmpwalk/gait/pendulum.hpp"
#include "zmpwalk/settings/settings.hpp"

namespace zmpwalk {

/// The sway at one instant: places along the y axis of H (left), from the centre of the sole that carries the ZMP.
///
/// The DCM is the divergent component of motion, COM + T_c times its velocity. The orbit is the sway that repeats from step to step.
struct Sway {
  const WalkSettings& settings;
  const LinearInvertedPendulum& pendulum;
  Side support;                           ///< foot that carries the ZMP
  PendulumState now;                      ///< lateral COM state [m, m/s]
  double xi;                              ///< DCM of the COM now [m]
  double xi_end;                          ///< DCM of the orbit in the middle of the next double support [m]
  double time;                            ///< time until the middle of the next double support [s]
  LinearInvertedPendulum::Growth growth;  ///< growth of the DCM in that time; its excess is > 0
};

/// The sway before the support switches to the other foot, with the velocities that (18) expects in the middle of the next single support.
struct SwayToCome {
  double next, later;  ///< w(T) less the orbit's, for a switch in the next cycle and in the one after [m/s]
  double side;         ///< +1 where the other foot is the left one, -1 where it is the right one
  double time_left;    ///< time until the double support ends [s]
};

/// A lateral law, III-D: it decides where the ZMP is while the robot sways, and when the support switches. It has no memory.
///
/// To add one, write its function in `lateral_law.cpp` and give it a row in `all()`; its name is a value of `zmp.lateral_law` then.
struct LateralLaw {
  const char* name;
  const char* meaning;  ///< goes on after "'name', which"; without a full stop
  /// Reference ZMP from the support sole's centre [m], after the switch. `LateralMotion` keeps it within `zmp.lateral_shift`.
  double (*reference)(const Sway&);
  /// Whether the support switches with the next cycle. At the end of the double support it switches whatever this says.
  bool (*switches)(const SwayToCome&);

  /// Every law; the first is the default.
  static const std::vector<LateralLaw>& all();
  static const LateralLaw& of(LateralLawName name) { return all()[static_cast<std::size_t>(name)]; }
};

}  // namespace zmpwalk
