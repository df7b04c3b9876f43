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

/// Actuators of the model, and where their controls and forces stand.
int actuator_count(const mjModel* m);
int control_address(const mjModel* m, int actuator);
int control_count(const mjModel* m, int actuator);
int force_address(const mjModel* m, int actuator);
/// The actuator takes one control and answers at once: no delay, no plugin, no option switches it off.
bool is_immediate(const mjModel* m, int actuator);
/// Why the force of an actuator cannot be foreseen from the state and its control, or "".
std::string unforeseeable(const mjModel* m, int actuator);
/// Limit on all actuators of a joint together [N m]; infinity without.
double joint_force_limit(const mjModel* m, int joint);
/// The joint's gravity compensation counts as a force of its actuators.
bool compensates_gravity_by_actuator(const mjModel* m, int joint);

/// Weight of `body` that its gravity compensation lifts, as a share.
double gravity_compensation(const mjModel* m, int body);

/// The equality constraint holds from the start.
bool is_active(const mjModel* m, int equality);
/// The two bodies that a connect or weld ties.
struct TiedBodies {
  int first, second;
};
TiedBodies tied_bodies(const mjModel* m, int equality);
/// Inertia of a tendon [kg or kg m^2].
double tendon_armature(const mjModel* m, int tendon);
/// What acts on `body` that only newer MuJoCo has and we do not model, in words, or "": plugins, flexes, adhesive geoms.
std::string unmodelled_on(const mjModel* m, int body);

}  // namespace zmpwalk::mujoco_compat
