#pragma once

#include "zmpwalk/control/contact_space.hpp"
#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// Below this normal force there is no contact and no ZMP [N].
inline constexpr double kMinNormalForce = 1.0;

/// Eq. 14, 15: ZMP in the frame that force and moment are given in; x = -M_y / F_z, y = M_x / F_z, (2,) [m].
///
/// The ratios do not depend on whether the wrench is the robot's on the ground or the ground's on the robot.
Vec2 zmp_of_wrench(const Vec3& F, const Vec3& M);

/// Force and moment about one point.
struct Wrench {
  Vec3 F = Vec3::Zero();  ///< [N]
  Vec3 M = Vec3::Zero();  ///< [N m]
};

/// Total of the feet's wrenches about the point `s`, world axes. `c` are the sole centres; NaN feet are left out.
Wrench total_wrench(const Vec12& f_c, const std::array<Vec3, 2>& c, const Vec3& s);

struct ZmpEstimate {
  Vec2 zmp = Vec2::Constant(kNaN);  ///< in W, on the horizontal plane through the support sole's centre [m]
  Vec12 f_c = Vec12::Constant(
      kNaN);  ///< robot on ground, left then right, at the sole centres; NaN where a foot is not in contact
  bool in_contact = false;  ///< |F_z| >= kMinNormalForce
};

/// Eq. 9-15: the ZMP that a torque will produce, before it is sent. One or two standing feet.
class ZmpEstimator {
 public:
  /// @param nv velocity coordinates
  explicit ZmpEstimator(int nv);

  /// Takes the state of one instant; nothing else is needed for any number of torques.
  ///
  /// @param A (nv, nv), b, g (nv,)  inertia, velocity and gravity terms
  /// @param J_c (6 k, nv), drift_c (6 k,)  of the k standing feet, left before right, at their sole centres
  /// @param standing  which feet stand
  /// @param c         sole centres in W, left and right [m]
  /// @param support   the foot whose sole plane carries the ZMP
  /// @throws DimensionError, InputError (no foot stands). Allocates nothing.
  void update(const ConstMatRef& A, const ConstVecRef& b, const ConstVecRef& g, const ConstMatRef& J_c,
              const ConstVecRef& drift_c, const std::array<bool, 2>& standing, const std::array<Vec3, 2>& c,
              Side support);

  /// @param tau joint torque (joints,) [N m]. @throws DimensionError. Allocates nothing.
  ZmpEstimate estimate(const ConstVecRef& tau) const;

  const ContactSpace& contact_space() const { return both_ ? double_ : single_; }

 private:
  ContactSpace single_, double_;
  bool both_ = false;
  std::array<bool, 2> standing_{};
  std::array<Vec3, 2> c_;
  Side support_ = kLeft;
};

}  // namespace zmpwalk
