#pragma once

namespace zmpwalk {

/// Says when a new torque is due. Its only clock is the time of the states that the walk is given, whatever the rate of the calls.
class ControlClock {
 public:
  /// @param control_dt control period [s]
  explicit ControlClock(double control_dt) : control_dt_(control_dt) {}

  /// The walk starts at `time` [s].
  void reset(double time);
  /// @throws InputError  reset was never called
  void require_started() const;
  /// @throws InputError  a time that is not finite, lies before the last one, or long after it. Changes nothing.
  void require(double time) const;
  /// True where a control period has gone by since the last cycle.
  bool due(double time) const;
  /// Notes that a cycle is computed at `time` [s].
  void tick(double time);
  /// Notes that no cycle is computed at `time` [s]: the last torque is held.
  void hold(double time) { last_ = time; }

  long cycles() const { return cycles_; }                          ///< cycles computed since the walk started
  double since_start(double time) const { return time - start_; }  ///< time since the walk started [s]

 private:
  double control_dt_;
  double start_ = 0.0, last_ = 0.0, next_ = 0.0;
  bool started_ = false;
  long cycles_ = 0;
};

}  // namespace zmpwalk
