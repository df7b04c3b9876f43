#pragma once

#include <string>
#include <vector>

#include "zmpwalk/math/spline.hpp"
#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// A motion of named joints that is known beforehand: a cubic spline through knots, with continuous acceleration. It starts and ends at rest, and keeps
/// its last value.
///
/// A name is a joint of the model [rad or m], or one of `trunk_roll`, `trunk_pitch`, `trunk_yaw` [rad]. These turn the trunk from its orientation
/// at the start by R_z(yaw) R_y(pitch) R_x(roll) in the heading frame H.
class JointMotion {
 public:
  /// An empty motion: everything stays in the start pose.
  JointMotion() = default;
  /// @param t      knot times (n,) [s], from 0, strictly increasing
  /// @param names  one per column (m,), each once
  /// @param q      positions at the knots (n, m)
  /// @throws InputError  there are no knots, a number is not finite, the first time is not 0, a time does not increase, or a name is given twice
  /// @throws DimensionError  q is not (n, m)
  JointMotion(const VecX& t, std::vector<std::string> names, const RowMatX& q);

  /// Position, velocity and acceleration of a column at time t [s]. Allocates nothing.
  Motion1 at(double t, int column) const;

  /// Smallest and largest value of a column, between the knots too, and the times at which it has them.
  struct Extent {
    double t_low = 0.0, low = 0.0, t_high = 0.0, high = 0.0;
  };
  Extent extent(int column) const;

  const VecX& t() const { return t_; }
  const std::vector<std::string>& names() const { return names_; }
  const RowMatX& q() const { return q_; }
  double duration() const { return t_.size() ? t_[t_.size() - 1] : 0.0; }  ///< [s]

 private:
  const Cubic& piece(Eigen::Index i, int column) const { return pieces_[i * names_.size() + column]; }

  VecX t_;
  std::vector<std::string> names_;
  RowMatX q_;
  std::vector<Cubic> pieces_;  // (n - 1, m)
};

/// The reference of a set of coordinates: it follows a motion, and goes over into a new one smoothly.
///
/// The reference is the motion, or the rest where no motion names a coordinate, plus a quintic that leads from the difference at the start to zero
/// within the blend time. So position, velocity and acceleration are continuous.
class MotionReference {
 public:
  /// @param rest  positions of the coordinates while no motion names them (n,)
  explicit MotionReference(const VecX& rest);

  /// Follows `motion` from the time of the last `update` on.
  ///
  /// @param entry  coordinate of each column of the motion (m,)   @param blend [s], > 0
  void start(JointMotion motion, std::vector<int> entry, double blend);
  /// The time is 0 again, every coordinate is at rest, and the motion begins anew.
  void reset();
  /// The reference at time t [s], t >= that of the last update. Allocates nothing.
  void update(double t);

  const VecX& q() const { return q_; }      ///< (n,)
  const VecX& dq() const { return dq_; }    ///< (n,)
  const VecX& ddq() const { return ddq_; }  ///< (n,)
  const JointMotion& motion() const { return motion_; }
  /// True where the motion names this coordinate.
  bool names(int coordinate) const;

 private:
  void blend_from_here();

  VecX rest_, q_, dq_, ddq_;
  JointMotion motion_;
  std::vector<int> entry_;
  std::vector<Motion1> difference_;  // at the start (n,)
  double t_ = 0.0, t_start_ = 0.0, blend_ = 0.0;
  bool rests_ = false;  // nothing moves any more
};

}  // namespace zmpwalk
