#pragma once

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// Shares one total wrench between two standing feet so that their wrenches add up to it exactly (an addition to the paper).
///
/// The shares a_L + a_R = 1 follow from where the ZMP P is between the feet. With delta = P - (a_L c_L + a_R c_R) the feet get F_i = a_i F and
/// M_i = delta x F_i + a_i M_P. So both feet carry their load at the same offset delta from their sole centres.
///
/// That holds for soles of any height and tilt. The centre of pressure of foot i is where the line along F through c_i + delta meets
/// its own sole plane, moved by n_i x M_P / (n_i . F), which is zero where M_P is along that sole's normal n_i.
///
/// @param F     total force [N], robot on ground (F_z < 0)
/// @param M_P   total moment about P [N m]
/// @param P     ZMP of the total wrench in W [m]
/// @param c     sole centres in W, left and right [m]
/// @param along direction in which the load is shared, horizontal, not zero: the lateral axis of the support frame
/// @param alone while the ZMP is nearer than this to a sole centre, that foot carries everything, since a foot that just touches the ground
///              chatters under a light load; less than half the distance of the feet along `along` [m]
/// @return      (12,) left force and moment, right force and moment, at the sole centres, world axes. Allocates nothing.
Vec12 distribute_wrench(const Vec3& F, const Vec3& M_P, const Vec3& P, const std::array<Vec3, 2>& c, const Vec3& along,
                        double alone = 0.0);

}  // namespace zmpwalk
