#pragma once

#include "zmpwalk/control/dynamics.hpp"

namespace zmpwalk {

/// Row c (nv,) of the robot's angular momentum about the vertical through its COM, L_z = c dq [kg m^2/s].
///
/// Rows 1-3 of A dq are the linear momentum P, rows 4-6 the angular one about the base in base axes:
/// L = R_WB (A dq)_4..6 + (p_WB - com) x P. `c` is (nv,) already. Allocates nothing.
void yaw_momentum_row(const Dynamics& dynamics, VecX& c);

}  // namespace zmpwalk
