// The adapter between zmpwalk's core and one version of MuJoCo: the only file of the core that includes MuJoCo's headers. It is compiled alone, and
// it links nothing: the functions of libmujoco are asked for by name, so that one adapter serves every version whose layout is the same.
// Every difference between versions is here, and MuJoCo's headers are asked what they have, not which version they are.

#include <mujoco/mujoco.h>

#include <limits>
#include <type_traits>

#include "zmpwalk/robot/mujoco_adapter.h"

namespace {

// ---- what the headers have

/// What `get` makes of `s`, or `otherwise` where that does not compile.
template <class S, class Get, class Otherwise>
auto got(S& s, Get get, Otherwise otherwise) {
  if constexpr (std::is_invocable_v<Get, S&>)
    return get(s);
  else
    return otherwise;
}

/// The same for one entry of what `get` makes of `s`.
template <class S, class Get, class Otherwise>
auto got(S& s, Get get, long index, Otherwise otherwise) {
  if constexpr (std::is_invocable_v<Get, S&>)
    return get(s)[index];
  else
    return otherwise;
}

// `s.member`, or `otherwise` where this MuJoCo has no such member.
#define MEMBER(s, member, otherwise) got(s, [](auto& has) -> decltype(+has.member) { return has.member; }, otherwise)
// `s.member[index]`, or `otherwise` where this MuJoCo has no such member.
#define ENTRY(s, member, index, otherwise) \
  got(s, [](auto& has) -> decltype(&has.member[0]) { return has.member; }, index, otherwise)

// The core knows these numbers (robot/mujoco.hpp); they never changed.
static_assert(mjJNT_FREE == 0 && mjJNT_BALL == 1 && mjJNT_SLIDE == 2 && mjJNT_HINGE == 3, "joint types");
static_assert(mjEQ_CONNECT == 0 && mjEQ_WELD == 1 && mjEQ_JOINT == 2 && mjEQ_TENDON == 3, "equality types");
static_assert(mjTRN_JOINT == 0 && mjTRN_JOINTINPARENT == 1 && mjTRN_SLIDERCRANK == 2 && mjTRN_TENDON == 3 &&
                  mjTRN_SITE == 4,
              "transmissions");
static_assert(mjWRAP_JOINT == 1 && mjWRAP_SITE == 3 && mjWRAP_SPHERE == 4 && mjWRAP_CYLINDER == 5, "tendon paths");
static_assert(mjDYN_NONE == 0 && mjGAIN_FIXED == 0 && mjBIAS_NONE == 0 && mjBIAS_AFFINE == 1, "actuators");
static_assert(mjGEOM_SPHERE == 2 && mjGEOM_CAPSULE == 3 && mjGEOM_ELLIPSOID == 4 && mjGEOM_CYLINDER == 5 &&
                  mjGEOM_BOX == 6 && mjGEOM_MESH == 7 && mjINT_RK4 == 1,
              "shapes and integrators");
static_assert(std::is_same_v<mjtNum, double>, "MuJoCo of double precision");

// ---- the functions of libmujoco

struct Functions {
#define FUNCTION(name) decltype(&::name) name;
  // clang-format off
#define FUNCTIONS(X)                                                                                       \
  X(mj_makeData) X(mj_deleteData) X(mj_resetData) X(mj_kinematics) X(mj_comPos) X(mj_comVel) X(mj_tendon)  \
  X(mj_transmission) X(mj_passive) X(mj_rne) X(mj_fwdVelocity) X(mj_fwdActuation) X(mj_forward) X(mj_step) \
  X(mj_step1) X(mj_step2) X(mj_contactForce) X(mj_name2id) X(mj_id2name) X(mj_crb)
  // clang-format on
  FUNCTIONS(FUNCTION)
#undef FUNCTION
  void (*mj_makeM)(const mjModel*, mjData*);  // null in versions that have none
  mjfGeneric* passive_callback;
} mj;

const mjModel* model(const void* m) { return static_cast<const mjModel*>(m); }
mjData* data(void* d) { return static_cast<mjData*>(d); }
const mjData* data(const void* d) { return static_cast<const mjData*>(d); }

// ---- views

template <class To, class From>
const To* as(const From* array) {
  static_assert(sizeof(To) == sizeof(From) && std::is_floating_point_v<To> == std::is_floating_point_v<From>,
                "MuJoCo keeps this array as zmpwalk reads it");
  return reinterpret_cast<const To*>(array);
}

void see_model(const void* handle, zmpwalk_model* out) {
  const mjModel* m = model(handle);
  out->handle = handle;
#define COUNT(name) out->name = static_cast<int>(m->name);
#define ARRAY(type, name) out->name = as<type>(m->name);
  ZMPWALK_MODEL_COUNTS(COUNT)
  ZMPWALK_MODEL_ARRAYS(ARRAY)
  out->nactuator = static_cast<int>(MEMBER(*m, nactuator, m->nu));
  out->neqdata = mjNEQDATA;
  out->ngain = mjNGAIN;
  out->nbias = mjNBIAS;
  out->muscle_gain = mjGAIN_MUSCLE;
  out->no_constraint = mjDSBL_CONSTRAINT;
  out->no_equality = mjDSBL_EQUALITY;
  out->no_frictionloss = mjDSBL_FRICTIONLOSS;
  out->no_contact = mjDSBL_CONTACT;
  out->no_gravity = mjDSBL_GRAVITY;
  out->timestep = &m->opt.timestep;
  out->gravity = m->opt.gravity;
  out->disableflags = as<int>(&m->opt.disableflags);
  out->integrator = as<int>(&m->opt.integrator);
}

void see_data(void* handle, zmpwalk_data* out) {
  mjData* d = data(handle);
  out->handle = handle;
  if (!d) return;
  out->size = static_cast<long>(d->nbuffer);
  out->time = &d->time;
  out->ncon = as<int>(&d->ncon);
#define DOUBLES(name) out->name = d->name;
  ZMPWALK_DATA_ARRAYS(DOUBLES)
}

int code(int object) {
  switch (object) {
    case ZMPWALK_BODY:
      return mjOBJ_BODY;
    case ZMPWALK_JOINT:
      return mjOBJ_JOINT;
    case ZMPWALK_SITE:
      return mjOBJ_SITE;
    case ZMPWALK_TENDON:
      return mjOBJ_TENDON;
    case ZMPWALK_ACTUATOR:
      return mjOBJ_ACTUATOR;
    case ZMPWALK_EQUALITY:
      return mjOBJ_EQUALITY;
    case ZMPWALK_KEY:
      return mjOBJ_KEY;
    default:
      return mjOBJ_UNKNOWN;
  }
}

// ---- differences between versions

/// mj_makeM fills M, in versions that have it; before, mj_crb fills qM.
void compute_inertia(const void* m, void* d) { (mj.mj_makeM ? mj.mj_makeM : mj.mj_crb)(model(m), data(d)); }

void inertia(const void* of, const void* from, int dof, int n, double* A) {
  const mjModel* m = model(of);
  const mjData* d = data(from);
  A -= (n + 1L) * dof;  // so that rows and columns count as MuJoCo's velocities do
  for (long i = dof; i < dof + n; ++i) {
    double *row = A + i * n, *column = A + i;
    if (const mjtNum* qM = MEMBER(*d, qM, nullptr)) {  // the diagonal, then the ancestors on the way to the root
      const mjtNum* entry = qM + m->dof_Madr[i];
      for (long j = i; j >= 0; j = m->dof_parentid[j]) row[j] = column[j * n] = *entry++;
    } else {  // a row of the lower triangle
      const mjtNum* M = MEMBER(*d, M, nullptr);
      const int* columns = MEMBER(*m, M_colind, nullptr);
      const long first = ENTRY(*m, M_rowadr, i, 0), end = first + ENTRY(*m, M_rownnz, i, 0);
      for (long k = first; k < end; ++k) row[columns[k]] = column[columns[k] * n] = M[k];
    }
  }
}

void contact(const void* d, int i, zmpwalk_contact* out) {
  const mjContact& c = data(d)->contact[i];
  out->geom[0] = ENTRY(c, geom, 0, MEMBER(c, geom1, -1));
  out->geom[1] = ENTRY(c, geom, 1, MEMBER(c, geom2, -1));
  out->pos = c.pos;
  out->frame = c.frame;
}

int diverged(const void* d) {
  const auto* warning = data(d)->warning;
  return warning[mjWARN_BADQPOS].number + warning[mjWARN_BADQVEL].number + warning[mjWARN_BADQACC].number > 0;
}

int control_address(const void* m, int a) { return ENTRY(*model(m), actuator_ctrladr, a, a); }
int control_count(const void* m, int a) { return ENTRY(*model(m), actuator_ctrlnum, a, 1); }
int force_address(const void* m, int a) { return ENTRY(*model(m), actuator_outadr, a, a); }

const char* unforeseeable(const void* m, int a) {
  if (ENTRY(*model(m), actuator_plugin, a, -1) >= 0) return "is a plugin";
  if (ENTRY(*model(m), actuator_delay, a, 0.0) > 0.0) return "delays its control";
  return "";
}

int is_immediate(const void* m, int a) {
  const auto& option = model(m)->opt;
  const int group = model(m)->actuator_group[a];
  const bool off = (option.disableflags & mjDSBL_ACTUATION) ||
                   (group >= 0 && group < mjNGROUP && (MEMBER(option, disableactuator, 0) & (1 << group)));
  return !off && control_count(m, a) == 1 && !*unforeseeable(m, a);
}

double joint_force_limit(const void* m, int joint) {
  if (!ENTRY(*model(m), jnt_actfrclimited, joint, false)) return std::numeric_limits<double>::infinity();
  const double low = ENTRY(*model(m), jnt_actfrcrange, 2 * joint, 0.0),
               high = ENTRY(*model(m), jnt_actfrcrange, 2 * joint + 1, 0.0);
  return high < -low ? high : -low;
}

int compensates_by_actuator(const void* m, int joint) { return ENTRY(*model(m), jnt_actgravcomp, joint, false); }
double gravity_compensation(const void* m, int body) { return ENTRY(*model(m), body_gravcomp, body, 0.0); }

int is_active(const void* m, int e) {
  const bool from_the_start = ENTRY(*model(m), eq_active0, e, ENTRY(*model(m), eq_active, e, true));
  return from_the_start && !(model(m)->opt.disableflags & mjDSBL_EQUALITY);
}

void tied_bodies(const void* of, int e, int bodies[2]) {
  const mjModel* m = model(of);
  const bool by_sites = ENTRY(*m, eq_objtype, e, int{mjOBJ_BODY}) == mjOBJ_SITE;
  bodies[0] = by_sites ? m->site_bodyid[m->eq_obj1id[e]] : m->eq_obj1id[e];
  bodies[1] = by_sites ? m->site_bodyid[m->eq_obj2id[e]] : m->eq_obj2id[e];
}

double tendon_armature(const void* m, int tendon) { return ENTRY(*model(m), tendon_armature, tendon, 0.0); }

const char* unmodelled_on(const void* of, int body) {
  const mjModel* m = model(of);
  if (ENTRY(*m, body_plugin, body, -1) >= 0) return "a plugin acts on it";
  for (int v = 0; v < static_cast<int>(MEMBER(*m, nflexvert, 0)); ++v)
    if (ENTRY(*m, flex_vertbodyid, v, -1) == body) return "a flex is attached to it";
  for (int g = 0; MEMBER(*m, flg_adhesion, false) && g < m->body_geomnum[body]; ++g)
    if (ENTRY(*m, geom_adhesion, m->body_geomadr[body] + g, 0.0) != 0.0) return "its geoms stick to what they touch";
  return "";
}

// ---- the table

// A function of libmujoco on mjModel and mjData, as the core calls it.
#define FORWARDED(name) [](const void* m, void* d) { mj.name(model(m), data(d)); }

zmpwalk_adapter make_table() {
  zmpwalk_adapter t{};
  t.interface = ZMPWALK_ADAPTER_INTERFACE;
  t.see_model = see_model;
  t.see_data = see_data;
  t.make_data = [](const void* m) -> void* { return mj.mj_makeData(model(m)); };
  t.delete_data = [](void* d) { mj.mj_deleteData(data(d)); };
  t.reset_data = FORWARDED(mj_resetData);
  t.kinematics = FORWARDED(mj_kinematics);
  t.com_pos = FORWARDED(mj_comPos);
  t.com_vel = FORWARDED(mj_comVel);
  t.tendon = FORWARDED(mj_tendon);
  t.transmission = FORWARDED(mj_transmission);
  t.passive = FORWARDED(mj_passive);
  t.rne = [](const void* m, void* d, int with_acceleration, double* result) {
    mj.mj_rne(model(m), data(d), static_cast<mjtByte>(with_acceleration), result);
  };
  t.fwd_velocity = FORWARDED(mj_fwdVelocity);
  t.fwd_actuation = FORWARDED(mj_fwdActuation);
  t.forward = FORWARDED(mj_forward);
  t.step = FORWARDED(mj_step);
  t.step1 = FORWARDED(mj_step1);
  t.step2 = FORWARDED(mj_step2);
  t.contact_force = [](const void* m, const void* d, int i, double* result) {
    mj.mj_contactForce(model(m), data(d), i, result);
  };
  t.name2id = [](const void* m, int object, const char* name) { return mj.mj_name2id(model(m), code(object), name); };
  t.id2name = [](const void* m, int object, int id) { return mj.mj_id2name(model(m), code(object), id); };
  t.compute_inertia = compute_inertia;
  t.inertia = inertia;
  t.contact = contact;
  t.diverged = diverged;
  t.has_passive_callback = [] { return int{*mj.passive_callback != nullptr}; };
  t.control_address = control_address;
  t.control_count = control_count;
  t.force_address = force_address;
  t.is_immediate = is_immediate;
  t.unforeseeable = unforeseeable;
  t.joint_force_limit = joint_force_limit;
  t.compensates_by_actuator = compensates_by_actuator;
  t.gravity_compensation = gravity_compensation;
  t.is_active = is_active;
  t.tied_bodies = tied_bodies;
  t.tendon_armature = tendon_armature;
  t.unmodelled_on = unmodelled_on;
  return t;
}

}  // namespace

#define VISIBLE __attribute__((visibility("default")))

extern "C" VISIBLE const zmpwalk_adapter* zmpwalk_adapter_of(void* (*find)(void* library, const char* name),
                                                             void* library, const char** missing) {
#define FIND(name)                                                                \
  mj.name = reinterpret_cast<decltype(mj.name)>(find(library, *missing = #name)); \
  if (!mj.name) return nullptr;
  FUNCTIONS(FIND)
  mj.mj_makeM = reinterpret_cast<decltype(mj.mj_makeM)>(find(library, "mj_makeM"));
  mj.passive_callback = static_cast<mjfGeneric*>(find(library, *missing = "mjcb_passive"));
  if (!mj.passive_callback) return nullptr;
  *missing = nullptr;
  static const zmpwalk_adapter table = make_table();
  return &table;
}
