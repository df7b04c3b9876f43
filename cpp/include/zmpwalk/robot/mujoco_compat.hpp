#pragma once

#include <mujoco/mujoco.h>

#include <string>

// Every difference between the MuJoCo versions we build on is in this header's source file.
namespace zmpwalk::mujoco_compat {

/// Version of the headers this library was compiled with, as the Python package writes it ("2.2.2").
std::string compiled_version();

/// Inertia matrix of the whole model, dense row-major (nv, nv), after mj_kinematics and mj_comPos.
void full_inertia(const mjModel* m, mjData* d, mjtNum* dst);

/// Geoms of a contact; -1 where one side is not a geom.
struct ContactPair {
  int first, second;
};
ContactPair contact_pair(const mjContact& contact);

}  // namespace zmpwalk::mujoco_compat
