#pragma once

#include <string>
#include <vector>

#include "zmpwalk/math/types.hpp"
#include "zmpwalk/robot/mujoco_types.hpp"
#include "zmpwalk/robot/robot.hpp"

namespace zmpwalk {

/// A constant force and torque on a body for a while. They come from outside: neither the controller nor its model is told.
struct Push {
  double t = 0.0;              ///< when it begins [s]
  double duration = 0.0;       ///< [s]
  std::string body;            ///< at whose centre of mass it acts; empty takes `trunk_body`
  Vec6 wrench = Vec6::Zero();  ///< force, then torque, W [N, N m]
};

/// The body that a push is given to where none is named: the first whose name holds "torso" or "trunk", in small letters or capital,
/// else the root body.
int trunk_body(const Robot& robot);

/// The pushes of a run, and how they reach MuJoCo: through xfrc_applied, which acts at the centre of mass of a body.
class Pushes {
 public:
  explicit Pushes(const Robot& robot) : robot_(&robot) {}

  /// @throws InputError  a time, duration, force or torque that is not finite, a time below 0, a duration below the model's timestep, a body that
  ///         the robot does not have. Nothing is changed then.
  void add(const Push& push);
  /// Sets the forces of the step that begins at `t` [s] in `d`. A push acts in the steps that begin in [t, t + duration), times rounded to
  /// the timestep. Nothing is written where no push was ever added. Allocates nothing.
  void apply(double t, mjData* d) const;

 private:
  struct Acting {
    Push push;
    int body;
  };
  const Robot* robot_;
  std::vector<Acting> pushes_;
};

}  // namespace zmpwalk
