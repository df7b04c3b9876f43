#pragma once

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

enum class Phase : int { kDoubleSupport = 0, kSingleSupport = 1 };

/// How far a walk has come in its present step.
struct GaitPhase {
  Phase phase = Phase::kDoubleSupport;
  int step = 0;                ///< number of the step: double support n leads to single support n
  double time = 0.0;           ///< time since the phase began [s]
  double duration = 0.0;       ///< length of the phase [s]
  double to_mid_single = 0.0;  ///< time until the middle of the single support of this step [s]; negative after it
  double to_mid_double =
      0.0;  ///< until the middle of the next double support [s]; in double support, of the one after this
};

/// Durations of a single support and of the double support after it [s].
struct StepTimes {
  double T_ds = 0.0, T_ss = 0.0;
  double period() const { return T_ds + T_ss; }
};

/// How long steps take. Up to the speed `speed` they take the times `slow`. Beyond, times shrink as powers of pace = speed / v. So a faster walk first
/// takes longer steps, and then also faster ones, with ever shorter double supports.
struct Cadence {
  StepTimes slow;
  double speed = 0.0;            ///< up to which steps are slow [m/s]
  double exponent = 0.0;         ///< the period is multiplied by pace^exponent
  double double_exponent = 0.0;  ///< the share of the double support in it is multiplied by pace^double_exponent
  Vec3 weight{1.0, 1.0, 0.0};    ///< how much each of (v_x, v_y, w_z) counts in v = |weight * velocity| [1, 1, m/rad]

  double pace(const Vec3& velocity) const;  ///< speed / v, at most 1
  StepTimes times(const Vec3& velocity) const;
};

/// Says when feet lift and land. It holds the times of one step: a double support, a single support, and the double support after it.
///
/// A step ends by time, unless an event says otherwise: the foot has landed, it has not landed yet, or a phase is to end at another time. An event
/// changes the times of this step alone. What `at`, `times`, `lift_off` and `touch_down` say follows from these times.
class Schedule {
 public:
  /// @throws InputError a duration that is not finite and > 0
  Schedule(double T_ds_first, double T_ds, double T_ss);

  /// Step `n` begins at `t` with a double support of `T_ds_first` [s].
  void begin(int n, double t, double T_ds_first, const StepTimes& times);
  /// True where the swing foot of this step has landed by `t` [s], as far as the schedule knows.
  bool landed(double t) const;
  /// Goes on to the step after this one, whose double support has begun.
  void next(const StepTimes& times);

  /// Notes that the swing foot lands at `t` [s]. If this is before its time, the rest of the single support becomes double support, so that the next
  /// foot lifts when it would have. If it is after its time, the double support keeps its length. Changes nothing while the foot has not lifted.
  void land(double t);
  /// Notes that the swing foot will not land before `t` [s]. The double support after it keeps its length.
  void wait(double t);
  /// Lets the phase at `t` [s] end `remaining` [s] later. The phases after it keep their lengths.
  /// @throws InputError  `remaining` is not finite and > 0
  void retime(double t, double remaining);

  GaitPhase at(double t) const;  ///< t [s] since the walk began; within this step
  const StepTimes& times() const { return times_; }
  double lift_off() const { return lift_off_; }                  ///< of this step [s]
  double touch_down() const { return lift_off_ + times_.T_ss; }  ///< of this step [s]
  double waited() const { return waited_; }                      ///< how long `wait` has put the touch-down off [s]

 private:
  int step_ = 0;
  double lift_off_, T_ds_before_, waited_ = 0.0;
  StepTimes times_;
};

}  // namespace zmpwalk
