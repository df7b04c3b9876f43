#pragma once

#include <memory>
#include <vector>

#include "zmpwalk/control/task.hpp"

namespace zmpwalk {

/// The tasks that a user has added, in the order of their priority, each with an activation that rises and falls smoothly.
///
/// Call `add` and `remove` between cycles; they may allocate. `update` belongs to the cycle and allocates nothing.
class TaskStack {
 public:
  TaskStack() = default;
  ~TaskStack();
  TaskStack(const TaskStack&) = delete;
  TaskStack& operator=(const TaskStack&) = delete;

  struct Entry {
    std::shared_ptr<Task> task;
    TaskRows rows;
    double activation = 0.0;  ///< 0: has no effect; the task's weight: acts in full
    double from = 0.0, to = 0.0, since = 0.0, blend = 0.0;
    bool waits = true;   ///< the next update begins its blend
    bool begins = true;  ///< the next update calls `Task::begin`
  };

  /// @param task   its names have been looked up (`Task::attach`)
  /// @param blend  time within which the task reaches its weight [s], > 0. A task that is fading out comes back from where it is.
  /// @throws InputError  the task is in this or another stack, its weight is not within 0 to 1, blend is not > 0
  void add(const std::shared_ptr<Task>& task, int nv, double blend);
  /// The task loses its effect within `blend` [s]. @throws InputError  it is not in the stack; blend is not > 0
  void remove(const Task& task, double blend);
  /// The walk starts anew: tasks that are fading out are dropped, and the others begin again.
  void reset();

  /// Computes activations and rows for this instant.
  void update(const TaskInput& in);

  /// True where no task has an effect.
  bool idle() const { return idle_; }
  const std::vector<Entry>& entries() const { return entries_; }
  /// Largest number of rows of one task.
  int most_rows() const;

 private:
  Entry* find(const Task& task);
  template <class Spent>
  void drop(Spent&& spent);

  std::vector<Entry> entries_;
  bool idle_ = true;
};

}  // namespace zmpwalk
