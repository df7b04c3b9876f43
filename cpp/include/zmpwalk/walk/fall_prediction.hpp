#pragma once

#include "zmpwalk/gait/capture_region.hpp"
#include "zmpwalk/gait/gait_generator.hpp"
#include "zmpwalk/settings/settings.hpp"
#include "zmpwalk/walk/record.hpp"
#include "zmpwalk/zmp/bounds.hpp"

namespace zmpwalk {

/// Foresees a fall: it is certain once the DCM is outside the capture region of all steps within reach, by a margin and for some time; or
/// once the only foot that stands has tipped or spun too far.
///
/// What counts is what the leg can do, not what the gait has decided: the foot in the air may land anywhere within reach, at any time that the
/// settings of the group `steps` allow, and carries the robot at once. Where the gait keeps the planned times (`steps.timing` off), so does this.
class FallPrediction {
 public:
  /// @param settings resolved   @param sole size that both soles are taken to have   @param bounds of the ZMP in the whole of each sole
  FallPrediction(const WalkSettings& settings, const SoleSize& sole, const std::array<ZmpBounds, 2>& bounds);

  /// A walk begins on soles with the orientations `R_sole`, which count as level.
  void reset(const std::array<Mat3, 2>& R_sole);
  /// Goes on by one cycle: what the gait has decided for `in`. Returns the fall that is foreseen, the first one until `reset`.
  /// @param t in the simulation [s]. Allocates nothing.
  const ForeseenFall& update(double t, const GaitGenerator& gait, const GaitInput& in,
                             const LinearInvertedPendulum& pendulum);

  bool on() const { return on_; }
  double gap() const { return gap_; }  ///< of the DCM from the capture region [m]; NaN where nothing is foreseen

 private:
  double gap_of(const GaitGenerator& gait, const GaitInput& in) const;
  double step_gap(const GaitGenerator& gait, const GaitInput& in, Side stance) const;
  double stand_gap(const GaitInput& in, const Vec2& ahead, const Vec2& xi) const;
  /// Where the ZMP may be in the sole of `side`, in the axes of H, from `origin` [m].
  std::array<Interval, 2> room(const GaitInput& in, Side side, const Vec2& ahead, const Vec2& origin) const;
  void watch_foot(const GaitOutput& gait, const GaitInput& in, double touch_down);

  bool on_, steps_;
  double margin_, confirm_time_, cos_foot_tilt_, dt_, wait_time_;
  std::array<ZmpBounds, 2> bounds_;
  CaptureRegion region_;
  double Tc_ = 0.0, gap_ = kNaN;
  std::array<Vec3, 2> up_{Vec3::UnitZ(), Vec3::UnitZ()};  // normals of the soles at the start
  Side support_ = kLeft;
  bool alone_ = false;                             // one foot stands alone
  Vec2 forward_ = Vec2::UnitX();                   // its x axis when it began to
  double cos_tip_ = 1.0, cos_turn_ = 1.0;          // of how far it has tipped and turned since
  double lost_ = 0.0, tipped_ = 0.0, spun_ = 0.0;  // for how long [s]
  ForeseenFall fall_;
};

}  // namespace zmpwalk
