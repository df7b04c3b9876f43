#include "zmpwalk/gait/swing_foot.hpp"

#include <algorithm>

#include "zmpwalk/math/rotation.hpp"

namespace zmpwalk {

void SwingFoot::begin(const Vec3& p, const Mat3& R, double duration, double z_land, double height) {
  duration_ = duration;
  const double top = std::max(p.z(), z_land) + height;
  up_ = Cubic(p.z(), 0.0, top, 0.0, 0.5 * duration);
  down_ = Cubic(top, 0.0, z_land, 0.0, 0.5 * duration);
  from_ << p.head<2>(), yaw_of(R);
  velocity_.setZero();
  target_ = SwingTarget{};
  target_.p = p;
  target_.R = rotation_z(yaw_ = from_.z());
}

const SwingTarget& SwingFoot::update(double t, double dt, const Foothold& foothold) {
  const double left = duration_ - t;
  const Vec3 to(foothold.p.x(), foothold.p.y(), from_.z() + wrap_angle(foothold.yaw - from_.z()));
  Vec3 p, v, a;  // x, y, yaw
  for (int i = 0; i < 3; ++i) {
    const Cubic spline(from_[i], velocity_[i], to[i], 0.0, left);
    const Motion1 next = spline.at(dt);
    p[i] = from_[i];
    v[i] = velocity_[i];
    a[i] = spline.at(0.0).a;
    from_[i] = next.p;
    velocity_[i] = next.v;
  }
  const double half = 0.5 * duration_;
  const Motion1 z = t < half ? up_.at(t) : down_.at(t - half);
  target_.p << p.head<2>(), z.p;
  target_.v << v.head<2>(), z.v;
  target_.a << a.head<2>(), z.a;
  if (p.z() != yaw_) target_.R = rotation_z(yaw_ = p.z());
  target_.omega.z() = v.z();
  target_.alpha.z() = a.z();
  return target_;
}

}  // namespace zmpwalk
