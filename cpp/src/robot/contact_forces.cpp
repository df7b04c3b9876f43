#include "zmpwalk/robot/contact_forces.hpp"

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <cmath>

#include "zmpwalk/robot/mujoco_compat.hpp"
#include "zmpwalk/zmp/estimate.hpp"

namespace zmpwalk {

MeasuredContact measure_contact(const Robot& robot, const mjData* d) {
  robot.require_data(d);
  const mjModel* m = robot.model();
  MeasuredContact out;
  for (const Side side : kSides) out.sole[side] = robot.sole_centre(side, d);
  for (int i = 0; i < d->ncon; ++i) {
    const mujoco_compat::ContactPair pair = mujoco_compat::contact_pair(d->contact[i]);
    if (pair.first < 0 || pair.second < 0) continue;  // not between two geoms
    const int body_1 = m->geom_bodyid[pair.first], body_2 = m->geom_bodyid[pair.second];
    if (robot.is_robot(body_1) && robot.is_robot(body_2)) {
      ++out.self_contacts;
      continue;
    }
    for (const Side side : kSides) {
      const bool is_first = robot.is_foot(side, body_1), is_second = robot.is_foot(side, body_2);
      if (!is_first && !is_second) continue;
      mjtNum local[6];  // force and torque of the first geom on the second, rows of the contact frame, normal first
      mj_contactForce(m, d, i, local);
      const mjContact& contact = d->contact[i];
      const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> frame(contact.frame);
      const double sign = is_first ? 1.0 : -1.0;  // of the foot on the ground
      const Vec3 F = sign * (frame.transpose() * Eigen::Map<const Vec3>(local));
      const Vec3 M = sign * (frame.transpose() * Eigen::Map<const Vec3>(local + 3));
      auto foot = out.wrench.segment<6>(6 * side);
      if (std::isnan(foot[0])) foot.setZero();
      foot.head<3>() += F;
      foot.tail<3>() += M + (Vec3(Eigen::Map<const Vec3>(contact.pos)) - out.sole[side]).cross(F);
    }
  }
  return out;
}

Sensed felt_by(const MeasuredContact& contact) {
  Sensed felt;
  for (const Side side : kSides) {
    felt.wrench[side] = contact.wrench.segment<6>(6 * side);
    felt.contact[side] = std::isnan(felt.wrench[side].z()) ? 0.0 : 1.0;
  }
  return felt;
}

Vec2 measured_zmp(const MeasuredContact& contact, const Plane& plane) {
  const Vec3 origin = plane.offset * plane.normal;
  const Wrench total = total_wrench(contact.wrench, contact.sole, origin);
  if (!(std::abs(plane.normal.dot(total.F)) >= kMinNormalForce)) return Vec2::Constant(kNaN);
  return zmp_on_plane(total.F, total.M, origin, plane).head<2>();
}

Vec2 measured_zmp(const MeasuredContact& contact) {
  double load = 0.0, height = 0.0;
  for (const Side side : kSides) {
    const double F_z = contact.wrench[6 * side + 2];
    if (std::isnan(F_z)) continue;
    load += F_z;
    height += F_z * contact.sole[side].z();
  }
  return measured_zmp(contact, {Vec3::UnitZ(), height / load});
}

}  // namespace zmpwalk
