#pragma once

#include <mujoco/mujoco.h>

#include <string>

#include "zmpwalk/math/types.hpp"

// Every difference between the MuJoCo versions we build on is in this header's source file.
namespace zmpwalk::mujoco_compat {

/// Version of the headers this library was compiled with, as the Python package writes it ("2.2.2").
std::string compiled_version();

/// Computes the inertia matrix in MuJoCo's own sparse form, into `d`. Call it after mj_kinematics and mj_comPos.
void compute_inertia(const mjModel* m, mjData* d);

/// Writes the dense block (n, n) of the inertia matrix that belongs to the n velocities of one tree, the first of which is `dof`. Entries that
/// are zero by the tree's shape are not written, so `A` has to be zero before the first call. Allocates nothing.
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
/// True where the actuator takes one control and acts at once: it has no delay and no plugin, and no option switches it off.
bool is_immediate(const mjModel* m, int actuator);
/// Why the force of an actuator cannot be foreseen from the state and its control, or "".
std::string unforeseeable(const mjModel* m, int actuator);
/// Limit on the torque of all actuators of a joint together [N m]; infinity where there is none.
double joint_force_limit(const mjModel* m, int joint);
/// True where the joint's gravity compensation counts as a force of its actuators.
bool compensates_gravity_by_actuator(const mjModel* m, int joint);

/// Share of the weight of `body` that its gravity compensation lifts.
double gravity_compensation(const mjModel* m, int body);

/// True where the equality constraint is active from the start.
bool is_active(const mjModel* m, int equality);
/// The two bodies that a connect or weld ties.
struct TiedBodies {
  int first, second;
};
TiedBodies tied_bodies(const mjModel* m, int equality);
/// Inertia of a tendon [kg or kg m^2].
double tendon_armature(const mjModel* m, int tendon);
/// Names in words what acts on `body` that only newer MuJoCo versions have and that we do not model (plugins, flexes, adhesive geoms); "" for nothing.
std::string unmodelled_on(const mjModel* m, int body);

}  // namespace zmpwalk::mujoco_compat
