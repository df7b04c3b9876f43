#pragma once

#include "zmpwalk/control/dynamics.hpp"

namespace zmpwalk {

/// Row c (nv,) of the robot's angular momentum about the axis `axis` (3,), W, through its COM, L = c dq [kg m^2/s].
///
/// Rows 1-3 of A dq are the linear momentum P, rows 4-6 the angular one about the base in base axes:
/// L = axis . (R_WB (A dq)_4..6 + (p_WB - com) x P). Allocates nothing.
void momentum_row(const Dynamics& dynamics, const Vec3& axis, Eigen::Ref<Eigen::RowVectorXd> c);

/// cdot dq: what of d/dt L does not come from ddq, so that d/dt L = c ddq + cdot dq [N m]. Allocates nothing.
///
/// d/dt L is to A ddq + b (without passive forces) what L is to A dq; gravity has no moment about the COM.
double momentum_drift(const Dynamics& dynamics, const Vec3& axis);

}  // namespace zmpwalk
