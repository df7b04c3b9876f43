#include "zmpwalk/control/momentum.hpp"

namespace zmpwalk {

void yaw_momentum_row(const Dynamics& dynamics, VecX& c) {
  const Vec3 axis = dynamics.R_WB.row(2), arm = dynamics.p_WB - dynamics.com;
  c.noalias() = dynamics.A.middleRows<3>(3).transpose() * axis;
  c += arm.x() * dynamics.A.row(1).transpose() - arm.y() * dynamics.A.row(0).transpose();
}

}  // namespace zmpwalk
