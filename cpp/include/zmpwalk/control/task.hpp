#pragma once

#include <string>
#include <utility>

#include "zmpwalk/control/dynamics.hpp"

namespace zmpwalk {

/// Throws InputError unless a gain is finite and not negative.
void require_gain(const char* name, double gain);

class TaskStack;

/// What a task may know of one control cycle.
struct TaskInput {
  const Dynamics& dynamics;
  double t = 0.0;             ///< since the walk was reset [s]
  double heading = 0.0;       ///< of the walk, in W [rad]
  double heading_rate = 0.0;  ///< planned [rad/s]
};

/// The rows of one task at one instant. The robot is to move with J ddq + drift = f_star.
struct TaskRows {
  TaskRows(int rows, int nv) : J(RowMatX::Zero(rows, nv)), drift(VecX::Zero(rows)), f_star(VecX::Zero(rows)) {}

  int rows() const { return static_cast<int>(drift.size()); }

  RowMatX J;    ///< (m, nv)
  VecX drift;   ///< Jdot dq (m,)
  VecX f_star;  ///< commanded acceleration f* (m,)
};

/// Finds the numbers of a robot's frames and joints by name. A task asks for them when it is added, outside the cycle.
class RobotNames {
 public:
  virtual ~RobotNames() = default;
  /// Index in `Dynamics::frames` of the frame of a body or site; the frame is read in every cycle from then on.
  /// @throws InputError  the robot has neither of that name
  virtual int frame(const std::string& name) = 0;
  /// Index of a joint outside the legs. @throws InputError  there is none of that name
  virtual int joint(const std::string& name) = 0;
  /// Lower and upper limit of a joint [rad or m]; infinite where it has none.
  virtual std::pair<double, double> joint_range(int joint) = 0;
  /// The robot as it was read last, for a task that computes itself once when it is attached.
  virtual const Dynamics& dynamics() const = 0;
};

/// Something that the robot is to do: the Jacobian of what is to move, and the acceleration that it is to have.
///
/// The solver fulfils the tasks in the order of their priority, and each uses only the motions that those before it leave free. A new task is a
/// class that derives from this one and overrides `rows` and `compute`; `FrameTask` is an example.
class Task {
 public:
  virtual ~Task() = default;

  /// Number of rows; the same in every cycle.
  virtual int rows() const = 0;

  /// Looks up the names of its frames and joints. It is called when the task is added. @throws InputError  the robot has no such name
  virtual void attach(RobotNames&) {}

  /// The task starts to act at this instant, and gains its full weight within `blend` [s]. Allocates nothing.
  virtual void begin(const TaskInput&, double /*blend*/) {}

  /// Writes the rows of this instant into `out`, which has the right size. Allocates nothing.
  virtual void compute(const TaskInput& in, TaskRows& out) = 0;

  int priority = 0;     ///< a task with a smaller number comes first; of equal numbers, the task that was added first
  double weight = 1.0;  ///< share of the task's correction that is applied, 0 to 1; what comes after decides the rest

 private:
  friend class TaskStack;
  const TaskStack* stack_ = nullptr;  // a task keeps what it knows of one walk, so that it belongs to one stack
};

}  // namespace zmpwalk
