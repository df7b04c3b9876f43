#pragma once

#include <mujoco/mujoco.h>

#include <string>

#include "zmpwalk/math/types.hpp"

// Every difference between the MuJoCo versions we build on is in this header's source file.
namespace zmpwalk::mujoco_compat {

/// Version of the headers this library was compiled with, as the Python package writes it ("2.2.2").
std::string compiled_version();

/// The inertia matrix in MuJoCo's own sparse form, into `d`; after mj_kinematics and mj_comPos.
void compute_inertia(const mjModel* m, mjData* d);

/// The dense block (n, n) of it that belongs to the n velocities of one tree, the first of which is `dof`. Entries that are
/// zero by the tree's shape are not written: `A` starts as zero. Allocates nothing.
void inertia(const mjModel* m, const mjData* d, int dof, RowMatX& A);

/// Geoms of a contact; -1 where one side is not a geom.
struct ContactPair {
  int first, second;
};
ContactPair contact_pair(const mjContact& contact);

}  // namespace zmpwalk::mujoco_compat
