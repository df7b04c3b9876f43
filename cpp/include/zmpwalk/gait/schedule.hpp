#pragma once

namespace zmpwalk {

enum class Phase : int { kDoubleSupport = 0, kSingleSupport = 1 };

/// Where a walk is at one time.
struct GaitPhase {
  Phase phase = Phase::kDoubleSupport;
  int step = 0;                ///< number of the step: double support n leads to single support n
  double time = 0.0;           ///< since the phase began [s]
  double duration = 0.0;       ///< of the phase [s]
  double to_mid_single = 0.0;  ///< until the middle of the single support of this step [s]; negative after it
  double to_mid_double =
      0.0;  ///< until the middle of the next double support [s]; in double support, of the one after this
};

/// Times of a walk: first double support, then single and double support in turn. A pure function of time.
class Schedule {
 public:
  /// @throws InputError a duration that is not finite and > 0
  Schedule(double T_ds_first, double T_ds, double T_ss);

  GaitPhase at(double t) const;  ///< t [s] since the walk began
  double period() const { return T_ds_ + T_ss_; }
  double T_ds() const { return T_ds_; }
  double T_ss() const { return T_ss_; }
  /// When the single support of step `n` begins [s].
  double lift_off(int n) const { return T_ds_first_ + n * period(); }

 private:
  double T_ds_first_, T_ds_, T_ss_;
};

}  // namespace zmpwalk
