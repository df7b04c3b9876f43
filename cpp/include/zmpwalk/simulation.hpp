#pragma once

#include <functional>
#include <string>
#include <vector>

#include "zmpwalk/robot/contact_forces.hpp"
#include "zmpwalk/walk/walking_controller.hpp"

namespace zmpwalk {

/// One column of a trace: `width` numbers a row, rows one after the other.
struct Column {
  std::string name;
  int width;
  std::vector<double> values;
};

/// Keeps what cycles record as columns: those of `visit_columns`, in its order. Row k holds the state before step k and what was decided for it.
class Recorder {
 public:
  /// @param controller must outlive the recorder   @param duration length of the walk for which memory is set aside, so that `add` does not allocate [s]
  explicit Recorder(const WalkingController& controller, double duration = 0.0);

  /// Adds one row, if `out` is a new cycle. Call right after mj_step: `data` then holds the contact forces of this cycle.
  void add(const CycleOutput& out, const mjData* data);

  /// Marks the last row as a fall that shows only after the step: the state is not finite, or no foot touches the ground.
  void mark_fall();

  const std::vector<Column>& columns() const { return columns_; }
  /// The columns themselves; the recorder is of no more use.
  std::vector<Column> take_columns() { return std::move(columns_); }
  std::size_t rows() const { return rows_; }
  /// Contact forces of the last row.
  const MeasuredContact& contact() const { return contact_; }

 private:
  const WalkingController* controller_;
  std::vector<Column> columns_;
  std::size_t rows_ = 0;
  MeasuredContact contact_;
};

/// How a run ended.
struct RunResult {
  Fall fell = Fall::kNone;
  double fall_time = kNaN;       ///< [s]
  bool stopped = false;          ///< a callback asked for it
  double wall_time = 0.0;        ///< [s]
  std::vector<double> cycle_us;  ///< time of each control cycle [us]
};

/// The closed loop in C++: in each time step the controller gives torques, MuJoCo moves the robot, and the recorder takes a row.
class Simulation {
 public:
  /// Places the robot at its start pose on z = 0 in an mjData of its own. `controller` must outlive the simulation.
  /// @throws ModelError  a foot that touches nothing there
  explicit Simulation(WalkingController& controller);
  ~Simulation();

  /// Walks until `duration` [s], a fall, or a stop.
  ///
  /// @param recorder  gets one row per control cycle
  /// @param progress  called about every `progress_interval` [s of wall time] with the simulation time; returns false to stop
  /// @param after_cycle  called after the first cycle's `update` and then every `cycle_interval` [s], before the step; false to stop
  /// @throws InputError duration is not finite and > 0
  RunResult run(double duration, Recorder& recorder, const std::function<bool(double)>& progress = {},
                double progress_interval = 0.1, const std::function<bool(const CycleOutput&)>& after_cycle = {},
                double cycle_interval = 0.0);

  mjData* data() { return data_.get(); }

 private:
  WalkingController& controller_;
  MjDataPtr data_;
};

}  // namespace zmpwalk
