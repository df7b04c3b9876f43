#pragma once

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

#include "robots.hpp"
#include "zmpwalk/simulation.hpp"
#include "zmpwalk/walk/walking_controller.hpp"

// Finished walks of the humanoid and their records.

namespace zmpwalk::testing {

/// A finished walk of the humanoid in the closed loop.
struct Walk {
  explicit Walk(double duration, const WalkSettings& s = WalkSettings(),
                const VelocityProfile& profile = VelocityProfile::paper(), const mjModel* m = mahru())
      : controller(m, describe(mahru()), s, profile), recorder(controller, duration), simulation(controller) {
    result = simulation.run(duration, recorder);
  }

  long rows() const { return static_cast<long>(recorder.rows()); }
  /// A column of the record, (rows, width).
  Eigen::Map<const RowMatX> column(const std::string& name) const {
    for (const Column& c : recorder.columns())
      if (c.name == name) return {c.values.data(), rows(), c.width};
    throw std::runtime_error("no column " + name);
  }
  /// The first row at or after time `t`.
  long row(double t) const { return std::lround(t / controller.settings().control.dt); }
  double com_x(double t) const { return column("com")(row(t), 0); }

  WalkingController controller;
  Recorder recorder;
  Simulation simulation;
  RunResult result;
};

/// A preset with something changed.
inline WalkSettings with(const std::function<void(WalkSettings&)>& change, const std::string& law = "default") {
  WalkSettings s(law);
  change(s);
  return s;
}

}  // namespace zmpwalk::testing
