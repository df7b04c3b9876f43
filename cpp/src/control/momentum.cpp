#include "zmpwalk/control/momentum.hpp"

#include <Eigen/Geometry>

namespace zmpwalk {

void momentum_row(const Dynamics& dynamics, const Vec3& axis, Eigen::Ref<Eigen::RowVectorXd> c) {
  const Vec3 axis_B = dynamics.R_WB.transpose() * axis, across = axis.cross(dynamics.p_WB - dynamics.com);
  c.transpose().noalias() = dynamics.A.middleRows<3>(3).transpose() * axis_B;
  c += across.y() * dynamics.A.row(1) + across.x() * dynamics.A.row(0) + across.z() * dynamics.A.row(2);
}

double momentum_drift(const Dynamics& dynamics, const Vec3& axis) {
  const Vec3 arm = dynamics.p_WB - dynamics.com, force = dynamics.drift_momentum.head<3>();
  return axis.dot(dynamics.R_WB * dynamics.drift_momentum.segment<3>(3) + arm.cross(force));
}

}  // namespace zmpwalk
