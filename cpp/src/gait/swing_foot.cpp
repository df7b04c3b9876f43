#include "zmpwalk/gait/swing_foot.hpp"

#include <algorithm>

#include "zmpwalk/math/rotation.hpp"

namespace zmpwalk {

void SwingFoot::begin(const Vec3& p, const Mat3& R, double duration, double z_land, double height) {
  duration_ = duration;
  top_ = std::max(p.z(), z_land) + height;
  z_lift_ = p.z();
  z_land_ = z_land;
  const double from[3] = {p.x(), p.y(), yaw_of(R)};
  for (int i = 0; i < 3; ++i) now_[i] = {from[i], 0.0, 0.0};
  target_ = SwingTarget{};
  target_.p = p;
  target_.R = rotation_z(from[2]);
}

Motion1 SwingFoot::rest_to_rest(double from, double to, double duration, double t) const {
  return smooth_ ? Quintic({from, 0.0, 0.0}, to, duration).at(t) : Cubic(from, 0.0, to, 0.0, duration).at(t);
}

const SwingTarget& SwingFoot::update(double t, double dt, const Foothold& foothold) {
  const double left = duration_ - t, half = 0.5 * duration_;
  const double to[3] = {foothold.p.x(), foothold.p.y(), now_[2].p + wrap_angle(foothold.yaw - now_[2].p)};
  std::array<Motion1, 3> m;  // x, y, yaw
  for (int i = 0; i < 3; ++i) {
    if (smooth_) {
      const Quintic spline(now_[i], to[i], left);
      m[i] = spline.at(0.0);
      now_[i] = spline.at(dt);
    } else {
      const Cubic spline(now_[i].p, now_[i].v, to[i], 0.0, left);
      m[i] = spline.at(0.0);
      now_[i] = spline.at(dt);
    }
  }
  const Motion1 z =
      t < half ? rest_to_rest(z_lift_, top_, half, t) : rest_to_rest(top_, z_land_, half, std::min(t, duration_) - half);
  target_.p << m[0].p, m[1].p, z.p;
  target_.v << m[0].v, m[1].v, z.v;
  target_.a << m[0].a, m[1].a, z.a;
  target_.R = rotation_z(m[2].p);
  target_.omega.z() = m[2].v;
  target_.alpha.z() = m[2].a;
  return target_;
}

}  // namespace zmpwalk
