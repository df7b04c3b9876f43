#pragma once

#include <memory>
#include <string>

#include "zmpwalk/robot/mujoco_adapter.h"

// The core's door to MuJoCo. It includes none of MuJoCo's headers: an adapter does (cpp/adapter/adapter.cpp), which belongs to one version.

struct mjModel_;
struct mjData_;

namespace zmpwalk {

using AdapterEntry = decltype(&zmpwalk_adapter_of);

/// Connects the core with MuJoCo, before anything else is asked of it. Later calls change nothing.
///
/// @param entry    of an adapter that is linked to the program
/// @param library  what dlsym takes for the loaded libmujoco
/// @throws Error  the adapter is made for another core, or libmujoco lacks a function that it needs
void connect(AdapterEntry entry, void* library);
/// The same with an adapter and a libmujoco that lie in files.
void connect(const std::string& adapter, const std::string& libmujoco);

namespace mj {
inline const zmpwalk_adapter* adapter = nullptr;
/// @throws Error  unless the core is connected
const zmpwalk_adapter& connected();
}  // namespace mj

/// An mjModel, seen. A view is cheap to make and to copy; the mjModel must outlive it.
struct Model : zmpwalk_model {
  Model(const mjModel_* m) { mj::connected().see_model(m, this); }
};

/// An mjData, seen; what it points at can be written. The mjData must outlive it.
struct Data : zmpwalk_data {
  Data(mjData_* d) { mj::connected().see_data(d, this); }
  Data(const mjData_* d) : Data(const_cast<mjData_*>(d)) {}

 protected:
  explicit Data(void* d) { mj::connected().see_data(d, this); }
};

/// An mjData of our own. @throws ModelError  MuJoCo could not make one
class OwnData : public Data {
 public:
  explicit OwnData(const Model& m);

 private:
  std::unique_ptr<void, void (*)(void*)> owned_;
};

/// MuJoCo's functions, and its numbers for kinds of things.
namespace mj {

enum : int {
  kBody = ZMPWALK_BODY,
  kJoint = ZMPWALK_JOINT,
  kSite = ZMPWALK_SITE,
  kTendon = ZMPWALK_TENDON,
  kActuator = ZMPWALK_ACTUATOR,
  kEquality = ZMPWALK_EQUALITY,
  kKey = ZMPWALK_KEY
};  // named objects
enum : int { kFree = 0, kBall = 1, kSlide = 2, kHinge = 3 };                      // jnt_type
enum : int { kConnect = 0, kWeld = 1, kCoupledJoints = 2, kCoupledTendons = 3 };  // eq_type
enum : int {
  kByJoint = 0,
  kByJointInParent = 1,
  kBySliderCrank = 2,
  kByTendon = 3,
  kBySite = 4,
  kByBody = 5
};  // actuator_trntype
enum : int { kOverJoint = 1, kOverSite = 3, kOverSphere = 4, kOverCylinder = 5 };              // wrap_type
enum : int { kNoDynamics = 0, kFixedGain = 0, kNoBias = 0, kAffineBias = 1 };                  // of actuators
enum : int { kSphere = 2, kCapsule = 3, kEllipsoid = 4, kCylinder = 5, kBox = 6, kMesh = 7 };  // geom_type, site_type
enum : int { kRungeKutta = 1 };                                                                // integrator

inline void reset_data(const Model& m, const Data& d) { adapter->reset_data(m.handle, d.handle); }
inline void kinematics(const Model& m, const Data& d) { adapter->kinematics(m.handle, d.handle); }
inline void com_pos(const Model& m, const Data& d) { adapter->com_pos(m.handle, d.handle); }
inline void com_vel(const Model& m, const Data& d) { adapter->com_vel(m.handle, d.handle); }
inline void tendon(const Model& m, const Data& d) { adapter->tendon(m.handle, d.handle); }
inline void transmission(const Model& m, const Data& d) { adapter->transmission(m.handle, d.handle); }
inline void passive(const Model& m, const Data& d) { adapter->passive(m.handle, d.handle); }
inline void rne(const Model& m, const Data& d, int with_acceleration, double* result) {
  adapter->rne(m.handle, d.handle, with_acceleration, result);
}
inline void fwd_velocity(const Model& m, const Data& d) { adapter->fwd_velocity(m.handle, d.handle); }
inline void fwd_actuation(const Model& m, const Data& d) { adapter->fwd_actuation(m.handle, d.handle); }
inline void forward(const Model& m, const Data& d) { adapter->forward(m.handle, d.handle); }
inline void step(const Model& m, const Data& d) { adapter->step(m.handle, d.handle); }
inline void step1(const Model& m, const Data& d) { adapter->step1(m.handle, d.handle); }
inline void step2(const Model& m, const Data& d) { adapter->step2(m.handle, d.handle); }
inline void contact_force(const Model& m, const Data& d, int contact, double result[6]) {
  adapter->contact_force(m.handle, d.handle, contact, result);
}
inline int name2id(const Model& m, int object, const char* name) { return adapter->name2id(m.handle, object, name); }
inline const char* id2name(const Model& m, int object, int id) { return adapter->id2name(m.handle, object, id); }

/// Computes the inertia matrix in MuJoCo's own sparse form, into `d`. Call it after kinematics and com_pos.
inline void compute_inertia(const Model& m, const Data& d) { adapter->compute_inertia(m.handle, d.handle); }
/// Writes the dense block (n, n) of the inertia matrix that belongs to the n velocities of one tree, the first of which is `dof`, row by row. Entries
/// that are zero by the tree's shape are not written, so `A` has to be zero before the first call. Allocates nothing.
inline void inertia(const Model& m, const Data& d, int dof, int n, double* A) {
  adapter->inertia(m.handle, d.handle, dof, n, A);
}

inline zmpwalk_contact contact(const Data& d, int i) {
  zmpwalk_contact out;
  adapter->contact(d.handle, i, &out);
  return out;
}
/// True once MuJoCo has warned of a state that is not finite or far too large.
inline bool diverged(const Data& d) { return adapter->diverged(d.handle) != 0; }
/// True where a passive-force callback is installed.
inline bool has_passive_callback() { return adapter->has_passive_callback() != 0; }

/// Where controls and forces of an actuator stand, and how many controls it takes.
inline int control_address(const Model& m, int actuator) { return adapter->control_address(m.handle, actuator); }
inline int control_count(const Model& m, int actuator) { return adapter->control_count(m.handle, actuator); }
inline int force_address(const Model& m, int actuator) { return adapter->force_address(m.handle, actuator); }
/// True where the actuator takes one control and acts at once: it has no delay and no plugin, and no option switches it off.
inline bool is_immediate(const Model& m, int actuator) { return adapter->is_immediate(m.handle, actuator) != 0; }
/// Why the force of an actuator cannot be foreseen from the state and its control, or "".
inline std::string unforeseeable(const Model& m, int actuator) { return adapter->unforeseeable(m.handle, actuator); }
/// Limit on the torque of all actuators of a joint together [N m]; infinity where there is none.
inline double joint_force_limit(const Model& m, int joint) { return adapter->joint_force_limit(m.handle, joint); }
/// True where the joint's gravity compensation counts as a force of its actuators.
inline bool compensates_gravity_by_actuator(const Model& m, int joint) {
  return adapter->compensates_by_actuator(m.handle, joint) != 0;
}
/// Share of the weight of `body` that its gravity compensation lifts.
inline double gravity_compensation(const Model& m, int body) { return adapter->gravity_compensation(m.handle, body); }
/// True where the equality constraint is active from the start.
inline bool is_active(const Model& m, int equality) { return adapter->is_active(m.handle, equality) != 0; }
/// The two bodies that a connect or weld ties.
struct TiedBodies {
  int first, second;
};
inline TiedBodies tied_bodies(const Model& m, int equality) {
  int bodies[2];
  adapter->tied_bodies(m.handle, equality, bodies);
  return {bodies[0], bodies[1]};
}
/// Inertia of a tendon [kg or kg m^2].
inline double tendon_armature(const Model& m, int tendon) { return adapter->tendon_armature(m.handle, tendon); }
/// Names in words what acts on `body` that only newer MuJoCo versions have and that we do not model (plugins, flexes, adhesive geoms); "" for nothing.
inline std::string unmodelled_on(const Model& m, int body) { return adapter->unmodelled_on(m.handle, body); }

}  // namespace mj
}  // namespace zmpwalk
