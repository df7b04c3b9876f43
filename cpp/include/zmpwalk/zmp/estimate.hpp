#pragma once

#include "zmpwalk/control/contact_space.hpp"
#include "zmpwalk/math/types.hpp"
#include "zmpwalk/zmp/contact.hpp"

namespace zmpwalk {

/// A normal force below this one counts as no contact, and has no ZMP [N].
inline constexpr double kMinNormalForce = 1.0;

/// Force and moment about one point.
struct Wrench {
  Vec3 F = Vec3::Zero();  ///< [N]
  Vec3 M = Vec3::Zero();  ///< [N m]
};

/// Sum of the wrenches of both feet, about the point `s`, world axes. `f_c` (12,) holds force and moment at each sole centre `c`; a foot whose
/// entries are NaN is left out.
Wrench total_wrench(const Vec12& f_c, const std::array<Vec3, 2>& c, const Vec3& s);

/// What a torque will do to the ground.
struct ZmpEstimate {
  Vec2 zmp = Vec2::Constant(kNaN);  ///< world x and y, on the common plane of the standing feet [m]
  Vec12 f_c = Vec12::Constant(
      kNaN);  ///< robot on ground, left then right, at the sole centres; NaN where a foot is not in contact
  bool in_contact = false;  ///< the force along the plane's normal is at least kMinNormalForce
};

/// Estimates the ZMP that a torque will produce, before it is sent (eq. 9-15), with one or two standing feet.
class ZmpEstimator {
 public:
  /// @param nv velocity coordinates
  explicit ZmpEstimator(int nv);

  /// Takes the state of one instant; after that `estimate` works for any number of torques.
  ///
  /// @param A (nv, nv), b, g (nv,)  inertia, velocity and gravity terms
  /// @param J_c (6 k, nv), drift_c (6 k,)  of the k standing feet, left before right, at their sole centres
  /// @param feet      left and right: sole centres, which of them stand, and on what ground
  /// @param support   the foot whose sole centre the plane of the ZMP contains
  /// @throws DimensionError, InputError (no foot stands). Allocates nothing.
  void update(const ConstMatRef& A, const ConstVecRef& b, const ConstVecRef& g, const ConstMatRef& J_c,
              const ConstVecRef& drift_c, const std::array<Contact, 2>& feet, Side support);

  /// @param tau joint torque (joints,) [N m]. @throws DimensionError. Allocates nothing.
  ZmpEstimate estimate(const ConstVecRef& tau) const;

  const ContactSpace& contact_space() const { return both_ ? double_ : single_; }
  /// The plane that the ZMP is taken on: `common_plane` of the feet.
  const Plane& zmp_plane() const { return plane_; }

 private:
  ContactSpace single_, double_;
  bool both_ = false;
  bool left_ = true;  // the left foot stands
  std::array<Vec3, 2> c_;
  Side support_ = kLeft;
  Plane plane_;
};

}  // namespace zmpwalk
