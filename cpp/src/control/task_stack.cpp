#include "zmpwalk/control/task_stack.hpp"

#include <algorithm>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {
namespace {

/// From 0 to 1 while s goes from 0 to 1, with speed and acceleration zero at both ends.
double smooth_step(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * s * (10.0 + s * (6.0 * s - 15.0));
}

bool is_leaving(const TaskStack::Entry& entry) { return entry.to == 0.0; }

bool is_spent(const TaskStack::Entry& entry) { return is_leaving(entry) && entry.activation == 0.0; }

}  // namespace

TaskStack::~TaskStack() {
  for (Entry& entry : entries_) entry.task->stack_ = nullptr;
}

TaskStack::Entry* TaskStack::find(const Task& task) {
  for (Entry& entry : entries_)
    if (entry.task.get() == &task) return &entry;
  return nullptr;
}

template <class Spent>
void TaskStack::drop(Spent&& spent) {
  for (Entry& entry : entries_)
    if (spent(entry)) entry.task->stack_ = nullptr;
  entries_.erase(std::remove_if(entries_.begin(), entries_.end(), spent), entries_.end());
}

void TaskStack::add(const std::shared_ptr<Task>& task, int nv, double blend) {
  require_positive("blend", blend);
  if (!(task->weight > 0.0 && task->weight <= 1.0))
    throw InputError("the task's weight is " + std::to_string(task->weight) +
                     "; it must be more than 0, and at most 1");
  if (task->stack_ && task->stack_ != this) throw InputError("this task belongs to another controller");
  drop(is_spent);
  if (Entry* entry = find(*task)) {
    if (!is_leaving(*entry)) throw InputError("this task has been added already");
    entry->from = entry->activation;
    entry->to = task->weight;
    entry->blend = blend;
    entry->waits = true;
    return;
  }
  const auto after = [&](const Entry& entry) { return entry.task->priority > task->priority; };
  const auto place = std::find_if(entries_.begin(), entries_.end(), after);
  task->stack_ = this;
  entries_.insert(place, {task, TaskRows(task->rows(), nv), 0.0, 0.0, task->weight, 0.0, blend});
}

void TaskStack::remove(const Task& task, double blend) {
  require_positive("blend", blend);
  Entry* entry = find(task);
  if (!entry || is_leaving(*entry)) throw InputError("this task has not been added, or has been removed since");
  entry->from = entry->activation;
  entry->to = 0.0;
  entry->blend = blend;
  entry->waits = true;
  drop(is_spent);
}

void TaskStack::reset() {
  drop(is_leaving);
  for (Entry& entry : entries_) {
    entry.activation = entry.from = 0.0;
    entry.waits = entry.begins = true;
  }
  idle_ = true;
}

void TaskStack::update(const TaskInput& in) {
  idle_ = true;
  for (Entry& entry : entries_) {
    if (entry.waits) entry.since = in.t;
    if (entry.begins) entry.task->begin(in, entry.blend);
    entry.waits = entry.begins = false;
    entry.activation = entry.from + (entry.to - entry.from) * smooth_step((in.t - entry.since) / entry.blend);
    if (is_leaving(entry) && entry.activation == 0.0) continue;
    entry.task->compute(in, entry.rows);
    if (entry.activation > 0.0) idle_ = false;
  }
}

int TaskStack::most_rows() const {
  int most = 0;
  for (const Entry& entry : entries_) most = std::max(most, entry.rows.rows());
  return most;
}

}  // namespace zmpwalk
