#pragma once

#include "zmpwalk/simulation.hpp"

namespace zmpwalk {

/// Times the parts of a control cycle while a robot walks: there is one row per cycle, and every part is measured in that cycle.
///
/// Columns, times in microseconds:
/// - `phase`: 0 in double, 1 in single support
/// - `in_loop`: the whole cycle, on the terms that mj_step1 has computed
/// - `from_scratch`: the whole cycle from the state alone, by a second controller
/// - `step`: mj_step1 and mj_step2 together
/// - `terms`, `terms_from_scratch`: reading the terms of the equation of motion, and computing them (`Robot`)
/// - `algebra`: torque, wrenches and ZMP, (1)-(15), on the direct path
/// - `textbook`: the same as printed, in one of `textbook_every` cycles, else NaN
/// - `iteration`: the loop of III-B to 1 mm from 20 mm away
/// - `other`: in_loop less terms and algebra, which is gait, tracking and checks
/// - `difference`: the largest relative difference of torque, contact wrench and ZMP between `algebra` and `textbook`; NaN where the latter did not run
class CycleBenchmark {
 public:
  /// @throws as WalkingController; InputError duration not > 0, or the model's integrator is Runge-Kutta, which has no halves
  CycleBenchmark(const mjModel* model, const RobotDescription& description, const WalkSettings& settings,
                 const VelocityProfile& profile);

  /// Walks from the start pose. @param progress as in Simulation::run
  std::vector<Column> run(double duration, int textbook_every, const std::function<bool(double)>& progress = {});

 private:
  WalkingController controller_, from_state_;
  Robot robot_, robot_from_state_;
  WholeBodyController direct_, textbook_;
  MjDataPtr data_;
};

/// Times a recorded walk beside bare physics: `Simulation::run` with every column recorded, and `mj_step` alone on the same states.
///
/// The walk goes first without being timed, and what it writes into `ctrl` and `qfrc_applied` is kept. Then it is walked again in
/// pieces of 20 ms; after each piece, `mj_step` alone takes the same steps from the same start in an mjData of its own, driven
/// by what was kept. So both are timed in turn, whatever else the machine does meanwhile.
///
/// Columns, one row a piece: `walk`, `bare`, microseconds per step; `difference`, the largest difference of qvel between the two at
/// the end of the piece, which is zero.
/// @param progress as in Simulation::run
/// @throws as CycleBenchmark; ModelError as Simulation
std::vector<Column> benchmark_walk(const mjModel* model, const RobotDescription& description,
                                   const WalkSettings& settings, const VelocityProfile& profile, double duration,
                                   const std::function<bool(double)>& progress = {});

}  // namespace zmpwalk
