#pragma once

#include <vector>

#include "zmpwalk/gait/pendulum.hpp"
#include "zmpwalk/settings/settings.hpp"

namespace zmpwalk {

/// The sway at one instant, about the centre of the sole that carries the ZMP, along the walk's y (left).
struct Sway {
  const WalkSettings& settings;
  const LinearInvertedPendulum& pendulum;
  Side support;                           ///< foot that carries the ZMP
  PendulumState now;                      ///< lateral COM state [m, m/s]
  double xi;                              ///< its DCM [m]
  double xi_end;                          ///< DCM of the symmetric orbit in the middle of the next double support [m]
  double time;                            ///< until then [s]
  LinearInvertedPendulum::Growth growth;  ///< of the DCM until then; excess > 0
};

/// The sway before the support switches to the other foot, the velocities as (18) expects them in the middle of the next single support.
struct SwayToCome {
  double next, later;  ///< w(T) less the orbit's, for a switch in the next cycle and in the one after [m/s]
  double side;         ///< +1 where the other foot is the left one, -1 where it is the right one
  double time_left;    ///< of the double support [s]
};

/// A lateral law, III-D: where the ZMP is while the robot sways, and when the support switches. It has no memory.
///
/// To add one, write its function in `lateral_law.cpp` and give it a row in `all()`; its name is a value of `zmp.lateral_law` then.
struct LateralLaw {
  const char* name;
  const char* meaning;  ///< goes on after "'name', which"; without a full stop
  /// Reference ZMP about the support's sole centre [m]; asked after the switch. `LateralMotion` keeps it within `zmp.lateral_shift`.
  double (*reference)(const Sway&);
  /// Whether the support switches in the next cycle. It does whatever this says where the double support ends.
  bool (*switches)(const SwayToCome&);

  /// Every law; the first is the default.
  static const std::vector<LateralLaw>& all();
  static const LateralLaw& of(LateralLawName name) { return all()[static_cast<std::size_t>(name)]; }
};

}  // namespace zmpwalk
