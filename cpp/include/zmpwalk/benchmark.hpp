#pragma once

#include "zmpwalk/simulation.hpp"

namespace zmpwalk {

/// Times every part of a walk's cycles side by side: one row per control cycle, each part measured in that cycle.
///
/// Columns, times in microseconds: `phase` (0 double, 1 single support); `in_loop`, the whole cycle on the terms of mj_step1;
/// `from_scratch`, the whole cycle on the state alone, by a second controller; `step`, mj_step1 and mj_step2 together;
/// `terms`, `terms_from_scratch`: reading them (Robot); `algebra`: (1)-(13) and (15), `textbook`: the same as printed, each
/// `textbook_every` cycles, else NaN; `iteration`: the loop of III-B to 1 mm from 20 mm away; `other`: in_loop less terms and algebra,
/// which is gait, tracking, checks. `difference` is the largest relative difference of torque, contact wrench and ZMP between `algebra`
/// and `textbook`, NaN where the latter did not run.
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

}  // namespace zmpwalk
