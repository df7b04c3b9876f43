#pragma once

#include <string>
#include <vector>

#include "zmpwalk/robot/contact_forces.hpp"
#include "zmpwalk/robot/state.hpp"
#include "zmpwalk/walk/walking_controller.hpp"

namespace zmpwalk {

/// One column of a trace: `width` numbers a row, rows one after the other.
struct Column {
  std::string name;
  int width;
  std::vector<double> values;
};

/// How many rows to set memory aside for: those of `duration`, of a long one only the first. @param dt of a row [s]
std::size_t rows_within(double duration, double dt);

/// Keeps what cycles record as columns: those of `visit_columns`, in its order. Row k holds the state before step k and what was decided for it.
class Recorder {
 public:
  /// @param controller must outlive the recorder   @param duration length of the walk for which memory is set aside, so that `add` does not allocate [s]
  /// @param only_last   keep the last row alone, for a caller who looks at a walk now and then
  explicit Recorder(const WalkingController& controller, double duration = 0.0, bool only_last = false);

  /// Adds one row, if `out` is a new cycle. Call right after mj_step: `data` then holds the contact forces of this cycle.
  void add(const CycleOutput& out, const Data& data);
  /// The same where what walks is not what the controller believes in, or is told of: `robot` walks, and `state` is its own before the step.
  void add(const CycleOutput& out, const Data& data, const Robot& robot, const State& state);

  /// Marks the last row as a fall that shows only after the step: the state is not finite, or no foot touches the ground.
  void mark_fall();

  const std::vector<Column>& columns() const { return columns_; }
  /// The columns themselves; the recorder is of no more use.
  std::vector<Column> take_columns() { return std::move(columns_); }
  std::size_t rows() const { return rows_; }
  /// Contact forces of the last row.
  const MeasuredContact& contact() const { return contact_; }

 private:
  void add(const CycleOutput& out, const Data& data, const Robot& robot, const Eigen::Map<const VecX>& q,
           const Eigen::Map<const VecX>& dq);

  const WalkingController* controller_;
  std::vector<Column> columns_;
  std::size_t rows_ = 0;  // that were added
  bool only_last_;
  MeasuredContact contact_;
};

}  // namespace zmpwalk
