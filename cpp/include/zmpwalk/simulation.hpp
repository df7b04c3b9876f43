#pragma once

#include <functional>
#include <vector>

#include "zmpwalk/robot/state.hpp"
#include "zmpwalk/simulation/push.hpp"
#include "zmpwalk/simulation/recorder.hpp"
#include "zmpwalk/walk/walking_controller.hpp"

namespace zmpwalk {

/// What a run does when the robot has fallen by the controller's own word, or has lost the ground for long.
enum class OnFall {
  kStop,  ///< ends: that is a fall
  kGoOn  ///< takes it for an alarm and goes on until the robot lies on the ground, or is not finite: only these are falls then
};

/// How a run ended.
struct RunResult {
  Fall fell = Fall::kNone;
  double fall_time = kNaN;       ///< [s]
  Fall alarm = Fall::kNone;      ///< the first word of a fall; with OnFall::kStop the fall itself
  double alarm_time = kNaN;      ///< [s]
  bool stopped = false;          ///< a callback asked for it
  double wall_time = 0.0;        ///< [s]
  std::vector<double> cycle_us;  ///< time of each control cycle [us]
};

/// The closed loop in C++: controller, physics, recording. Knows nothing of Python.
class Simulation {
 public:
  /// Places the robot at its start pose on z = 0 in an mjData of its own. `controller` must outlive the simulation.
  /// @throws ModelError  a foot that touches nothing there
  explicit Simulation(WalkingController& controller);
  ~Simulation();

  /// Pushes the robot, from the next step on or later. @throws InputError  as `Pushes::add`
  void push(const Push& push) { pushes_.add(push); }

  /// Walks for `duration` [s], until a fall, or a stop. The first run starts the walk, every later one goes on where the last has ended.
  ///
  /// @param recorder  gets one row per control cycle
  /// @param progress  called about every `progress_interval` [s of wall time] with the simulation time; returns false to stop
  /// @param after_cycle  called after the run's first cycle's `update` and then every `cycle_interval` [s], before the step; false to stop
  /// @throws InputError duration is not finite and > 0
  RunResult run(double duration, Recorder& recorder, const std::function<bool(double)>& progress = {},
                double progress_interval = 0.1, const std::function<bool(const CycleOutput&)>& after_cycle = {},
                double cycle_interval = 0.0, OnFall on_fall = OnFall::kStop);

  mjData* data() { return data_.get(); }

 private:
  Fall lies() const;  // kDown where the robot lies on the ground

  WalkingController& controller_;
  MjDataPtr data_;
  Pushes pushes_;
  bool started_ = false;
  double start_height_ = 0.0;  // of the COM over the lower sole [m]
  double airborne_ = 0.0;      // [s]
  Sensed felt_;                // by the feet, in the step before
};

}  // namespace zmpwalk
