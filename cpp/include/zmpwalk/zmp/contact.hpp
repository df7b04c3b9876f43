#pragma once

#include <array>

#include "zmpwalk/zmp/plane.hpp"

namespace zmpwalk {

/// A foot on the ground: where its sole is, what it stands on, and how large and how rough it is.
///
/// Size and friction may be NaN, which means unknown; only `can_carry` needs them.
struct Contact {
  Vec3 p_WF = Vec3::Zero();      ///< sole centre in W [m]
  Mat3 R_WF = Mat3::Identity();  ///< sole axes in W: x forward, z out of the ground
  bool standing = true;          ///< false where the foot swings
  Plane ground;                  ///< the ground under it
  double length = kNaN;          ///< of the sole along its x [m]
  double width = kNaN;           ///< of the sole along its y [m]
  double friction = kNaN;        ///< tangential force per normal force that does not slip yet

  /// World x and y of the point of the sole that is `p_F` (2,) from its centre, in the sole's axes [m]. Bounds of the ZMP are given in the
  /// sole's axes and are recorded like this.
  Vec2 to_world(const Vec2& p_F) const;
  /// The inverse: where the point of the sole plane with world x and y `p` is from the sole's centre, in the sole's axes (2,) [m].
  Vec2 to_sole(const Vec2& p) const;
  /// Centre of pressure of a wrench on this sole, from the sole's centre in the sole's axes (2,) [m].
  ///
  /// @param f  force, then moment about the sole's centre (6,), world axes [N, N m]; of the robot on the ground or the reverse
  Vec2 cop(const Vec6& f) const;
  /// True where the sole can give this wrench: it is pressed onto the ground, its centre of pressure is on it, and the force along
  /// it is within its friction.
  ///
  /// @param f  robot **on** ground (6,), force, then moment about the sole's centre, world axes [N, N m]
  bool can_carry(const Vec6& f) const;
};

/// The plane on which the ZMP of these feet is taken. It always contains the support sole's centre.
///
/// One foot: the plane has the normal of the ground under the support foot. Two feet: each sole centre c_i is projected onto the
/// ground under its foot, q_i, and u = q_L - q_R is the line on which the robot stands. With the mean normal n_0 = (n_L + n_R) / 2
/// the normal is n_0 - u (u . n_0) / (u . u), made a unit vector: the plane contains the direction u and otherwise leans as the two
/// grounds do on average. So a ZMP between the feet lies between the soles, at whatever heights they are, and the normal depends
/// continuously on both grounds. Where both feet stand on one plane it is that plane's normal exactly, however deep either sole
/// has sunk: on level ground the ZMP is taken on the horizontal plane through the support sole's centre.
///
/// @param feet     left and right
/// @param support  the foot whose sole centre the plane contains
/// Allocates nothing.
Plane common_plane(const std::array<Contact, 2>& feet, Side support);

}  // namespace zmpwalk
