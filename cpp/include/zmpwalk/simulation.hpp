#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "zmpwalk/robot/state.hpp"
#include "zmpwalk/simulation/push.hpp"
#include "zmpwalk/simulation/recorder.hpp"
#include "zmpwalk/simulation/uncertainty.hpp"
#include "zmpwalk/walk/walking_controller.hpp"

namespace zmpwalk {

/// What a run does when the robot has fallen by the controller's own word, or has lost the ground for long. A fall that is only foreseen ends no run.
enum class OnFall {
  kStop,  ///< ends: that is a fall
  kGoOn  ///< takes it for an alarm and goes on until the robot lies on the ground, or is not finite: only these are falls then
};

/// How a run ended.
struct RunResult {
  Fall fell = Fall::kNone;
  double fall_time = kNaN;       ///< [s]
  Fall alarm = Fall::kNone;      ///< the first word of a fall: one that is foreseen, or else the fall itself
  double alarm_time = kNaN;      ///< [s]
  std::string alarm_text;        ///< in words
  bool stopped = false;          ///< a callback asked for it
  double wall_time = 0.0;        ///< [s]
  std::vector<double> cycle_us;  ///< time of each control cycle [us]
};

/// The closed loop in C++: in each time step the controller gives torques, MuJoCo moves the robot, and the recorder takes a row.
class Simulation {
 public:
  /// Places the robot at its start pose on z = 0 in an mjData of its own. `controller` must outlive the simulation.
  ///
  /// @param uncertainty  lies between robot and controller; without any, the controller reads MuJoCo's state as it is
  /// @param simulated    the model that is simulated, where it is not the controller's; it must outlive the simulation
  /// @throws ModelError  a foot that touches nothing there; a simulated model that lacks what the controller's description names, or
  ///         whose joints are others, or stand in another order. InputError  as `Uncertainty::checked`
  explicit Simulation(WalkingController& controller, const Uncertainty& uncertainty = Uncertainty(),
                      const std::optional<Model>& simulated = std::nullopt);
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

  const Data& data() const { return data_; }
  /// The robot that is simulated.
  const Robot& robot() const { return apart_ ? *apart_ : controller_.robot(); }

 private:
  const CycleOutput& control(Terms terms);  // the controller's, and its torque into the data
  Fall lies() const;                        // kDown where the robot lies on the ground

  WalkingController& controller_;
  std::unique_ptr<Robot> apart_;  // where it is not the controller's
  OwnData data_;
  Pushes pushes_;
  bool direct_;  // the controller reads the data themselves
  Sensors sensors_;
  Drives drives_;
  State truth_;  // of the robot, before the step
  State told_;   // to the controller
  bool started_ = false;
  double start_height_ = 0.0;  // of the COM over the lower sole [m]
  double airborne_ = 0.0;      // [s]
  Sensed felt_;                // by the feet, in the step before
};

}  // namespace zmpwalk
