#pragma once

#include "zmpwalk/gait/footsteps.hpp"
#include "zmpwalk/math/spline.hpp"
#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// Desired motion of the swing sole in W.
struct SwingTarget {
  Vec3 p = Vec3::Zero();      ///< sole centre [m]
  Vec3 v = Vec3::Zero();      ///< [m/s]
  Vec3 a = Vec3::Zero();      ///< [m/s^2]
  Mat3 R = Mat3::Identity();  ///< sole orientation
  Vec3 omega = Vec3::Zero();  ///< [rad/s], world axes
  Vec3 alpha = Vec3::Zero();  ///< [rad/s^2]
};

/// How a swing is shaped to clear known ground. Shares are of the duration of the single support.
struct SwingShape {
  double top = kNaN;         ///< height of the top, W [m]; NaN: `height` over the higher end
  double rise = kNaN;        ///< share after which the foot is at the top; NaN: by the way up and down
  double starts = 0.0;       ///< share until which it only rises
  double arrives = 1.0;      ///< share from which on it is over its place
  Vec2 tilt = Vec2::Zero();  ///< roll and pitch with which it lands, about the axes of its heading [rad]
  bool tilts = false;        ///< it turns from the tilt that it lifts off with to that; else it swings level
};

/// The time that a motion keeps while it is hurried or held back: its own time runs at rate 1 until a new end is set, then, within a
/// blend, at the rate that reaches its end then. Rate and acceleration of the own time never jump.
class OwnTime {
 public:
  /// @param end  own time at which the motion ends [s]
  explicit OwnTime(double end = 0.0) : end_(end), landing_(end) {}
  /// Own time at `t` [s], its rate [1] and the rate's change [1/s].
  Motion1 at(double t) const;
  /// From `t` on [s] the own time is to come to its end `left` [s] > 0 later.
  void retime(double t, double left);
  /// How far the own time goes on in `dt` [s] from `t` on.
  double step(double t, double dt) const { return untouched() ? dt : at(t + dt).p - at(t).p; }
  double landing() const { return landing_; }  ///< when it comes to its end [s]

 private:
  bool untouched() const { return !(blend_ > 0.0); }

  double end_, landing_;
  Motion1 from_{0.0, 1.0, 0.0};                    // at `start_`
  double start_ = 0.0, blend_ = 0.0, rate_ = 1.0;  // after the blend
};

/// Trajectory of the swing foot: cubic splines (section IV), up and down in z, and to a foothold that may move until late in x, y, yaw.
///
/// When the time left changes in flight, the foot goes on along its splines faster or slower (`OwnTime`), so that position, velocity and
/// acceleration go on without a jump. A foot that meets no ground goes on down; the acceleration that it still had fades out (a quintic).
class SwingFoot {
 public:
  /// @param p, R      sole at lift-off   @param duration of the single support [s]
  /// @param z_land    height at which the sole lands [m]   @param height  of the top over the higher of both ends [m]
  /// @param speed     at which it comes down there [m/s]; in proportion faster where the step is cut short
  /// @param steep     the foot rises before it goes ahead, and is over its place before it comes down
  /// @param tilt      roll and pitch to which it turns from the tilt that it lifts off with [rad]; NaN: it swings level
  void begin(const Vec3& p, const Mat3& R, double duration, double z_land, double height, double speed = 0.0,
             bool steep = false, const Vec2& tilt = Vec2::Constant(kNaN));
  /// The same along known ground, which `shape` clears.
  void begin(const Vec3& p, const Mat3& R, double duration, double z_land, const SwingShape& shape, double speed);
  /// The place of landing has moved to another height `z_land` [m] of known ground: from the next `update` on the foot goes there.
  void land_at(double z_land) { z_moved_ = z_land; }
  /// From the next `update` on, at `t` [s] since lift-off, the foot is to land `left` [s] > 0 later.
  void replan(double t, double left) { time_.retime(t, left); }
  /// The foot met no ground: from the next `update` on, at `t` [s], it goes on down for `time` [s], ever slower.
  void sink(double t, double time);

  /// Goes on by one cycle. In x, y and yaw the spline leads from where the foot is to the foothold in the time that is left, and arrives at rest.
  /// @param t since lift-off [s]   @param dt control period [s]
  const SwingTarget& update(double t, double dt, const Foothold& foothold);

  const SwingTarget& target() const { return target_; }
  double duration() const { return sinks_ ? sunk_ : time_.landing(); }  ///< from lift-off to landing [s]

 private:
  Motion1 height(const Motion1& own) const;  // of the splines, in own time
  void fly(const Vec3& p, const Mat3& R, double duration, double z_land, double top, double rise, double speed);
  void tilt(const Motion1& own, const Motion1& yaw);

  OwnTime time_;
  double duration_ = 0.0, z_land_ = 0.0;  // in own time
  double rise_ = 0.0;                     // up for so long, then down
  Cubic up_, down_;
  std::array<double, 3> to_{};   // where the splines in x, y, yaw lead
  std::array<Motion1, 3> next_;  // of the splines in x, y, yaw, in the cycle to come, by own time
  // A foot that met no ground goes on from `since_` until `sunk_`, along cubics in x, y, yaw, z, and with what is left of the
  // accelerations `beside_` that it had beside theirs.
  bool sinks_ = false, tilts_ = false;
  double starts_ = 0.0, arrives_ = 1.0;  // as in the shape, of the duration
  double z_moved_ = 0.0;                 // height of the place of landing now
  Vec2 from_tilt_ = Vec2::Zero(), to_tilt_ = Vec2::Zero();
  double since_ = 0.0, sunk_ = 0.0;
  std::array<Cubic, 4> sinking_;
  std::array<double, 4> beside_{};
  double yaw_ = 0.0;  // of the target
  SwingTarget target_;
};

}  // namespace zmpwalk
