#ifndef ZMPWALK_MUJOCO_ADAPTER_H
#define ZMPWALK_MUJOCO_ADAPTER_H

/* What zmpwalk asks of MuJoCo, in plain C. MuJoCo promises no binary interface between versions, so the core includes none of its headers:
 * an adapter (adapter.cpp) is compiled against the headers of one version, and the core reaches mjModel and mjData through it. */

#define ZMPWALK_ADAPTER_INTERFACE 2 /* counts up with every change of this file */

#ifdef __cplusplus
extern "C" {
#endif

/* clang-format off */
/* Members of mjModel that are copied into a view: X(name). */
#define ZMPWALK_MODEL_COUNTS(X) \
  X(nq) X(nv) X(nu) X(na) X(nbody) X(njnt) X(ngeom) X(nsite) X(npair) X(neq) X(ntendon)

/* Arrays of mjModel: X(type, name). A view points at them, so what the user changes is seen. */
#define ZMPWALK_MODEL_ARRAYS(X)                                                                                  \
  X(double, qpos0) X(double, key_qpos)                                                                           \
  X(int, body_parentid) X(int, body_rootid) X(int, body_weldid) X(int, body_jntnum) X(int, body_jntadr)          \
  X(int, body_dofnum) X(int, body_dofadr) X(double, body_pos) X(double, body_mass) X(double, body_subtreemass)   \
  X(int, jnt_type) X(int, jnt_qposadr) X(int, jnt_dofadr) X(int, jnt_bodyid) X(unsigned char, jnt_limited)       \
  X(double, jnt_range)                                                                                           \
  X(int, dof_bodyid) X(int, dof_jntid) X(int, dof_parentid) X(double, dof_frictionloss) X(double, dof_armature)  \
  X(double, dof_damping)                                                                                         \
  X(int, geom_bodyid) X(int, geom_contype) X(int, geom_conaffinity) X(int, geom_priority) X(double, geom_friction) \
  X(int, geom_type) X(int, geom_dataid) X(double, geom_size) X(double, geom_pos) X(double, geom_quat)            \
  X(int, mesh_vertadr) X(int, mesh_vertnum) X(float, mesh_vert)                                                  \
  X(int, site_type) X(int, site_bodyid) X(double, site_size) X(double, site_pos) X(double, site_quat)            \
  X(int, pair_geom1) X(int, pair_geom2)                                                                          \
  X(int, eq_type) X(int, eq_obj1id) X(int, eq_obj2id) X(double, eq_data)                                         \
  X(int, tendon_adr) X(int, tendon_num) X(unsigned char, tendon_limited) X(double, tendon_range)                 \
  X(double, tendon_stiffness) X(double, tendon_damping) X(double, tendon_frictionloss) X(double, tendon_length0) \
  X(int, wrap_type) X(int, wrap_objid)                                                                           \
  X(int, actuator_trntype) X(int, actuator_dyntype) X(int, actuator_gaintype) X(int, actuator_biastype)          \
  X(int, actuator_trnid) X(unsigned char, actuator_ctrllimited) X(unsigned char, actuator_forcelimited)          \
  X(double, actuator_gainprm) X(double, actuator_biasprm) X(double, actuator_ctrlrange)                          \
  X(double, actuator_forcerange) X(double, actuator_gear)

/* Arrays of mjData: X(name), all of double. */
#define ZMPWALK_DATA_ARRAYS(X)                                                                       \
  X(qpos) X(qvel) X(act) X(ctrl) X(qfrc_applied) X(xfrc_applied) X(xpos) X(xmat) X(xanchor) X(xaxis) \
  X(subtree_com) X(cdof) X(cdof_dot) X(cvel) X(qfrc_bias) X(qfrc_passive) X(qfrc_actuator)           \
  X(ten_length) X(actuator_length) X(actuator_velocity)
/* clang-format on */

#define ZMPWALK_POINTER(type, name) const type* name;
#define ZMPWALK_DOUBLES(name) double* name;
#define ZMPWALK_COUNT(name) int name;

/* An mjModel, seen: counts of its own, pointers into it. */
typedef struct zmpwalk_model {
  const void* handle; /* the mjModel */
  ZMPWALK_MODEL_COUNTS(ZMPWALK_COUNT)
  int nactuator;             /* actuators; in newer versions one may take several controls */
  int neqdata, ngain, nbias; /* lengths of a row of eq_data, actuator_gainprm, actuator_biasprm */
  int muscle_gain;           /* the actuator_gaintype of a muscle */
  int no_constraint, no_equality, no_frictionloss, no_contact, no_gravity; /* bits of *disableflags */
  const double *timestep, *gravity;                                        /* of mjOption */
  const int *disableflags, *integrator;
  ZMPWALK_MODEL_ARRAYS(ZMPWALK_POINTER)
} zmpwalk_model;

/* An mjData, seen. */
typedef struct zmpwalk_data {
  void* handle; /* the mjData */
  long size;    /* bytes of state, the same for all data of a model */
  double* time;
  const int* ncon;
  ZMPWALK_DATA_ARRAYS(ZMPWALK_DOUBLES)
} zmpwalk_data;

#undef ZMPWALK_POINTER
#undef ZMPWALK_DOUBLES
#undef ZMPWALK_COUNT

/* Kinds of named objects. */
enum zmpwalk_object {
  ZMPWALK_BODY,
  ZMPWALK_JOINT,
  ZMPWALK_SITE,
  ZMPWALK_TENDON,
  ZMPWALK_ACTUATOR,
  ZMPWALK_EQUALITY,
  ZMPWALK_KEY
};

/* A contact: its geoms, -1 where a side is none, its place and its axes (rows, the normal first). */
typedef struct zmpwalk_contact {
  int geom[2];
  const double *pos, *frame;
} zmpwalk_contact;

/* What an adapter gives. Arguments m and d are an mjModel and an mjData; functions without a comment are MuJoCo's own of that name. */
typedef struct zmpwalk_adapter {
  int interface; /* ZMPWALK_ADAPTER_INTERFACE */
  void (*see_model)(const void* m, zmpwalk_model* out);
  void (*see_data)(void* d, zmpwalk_data* out);

  void* (*make_data)(const void* m);
  void (*delete_data)(void* d);
  void (*reset_data)(const void* m, void* d);
  void (*kinematics)(const void* m, void* d);
  void (*com_pos)(const void* m, void* d);
  void (*com_vel)(const void* m, void* d);
  void (*tendon)(const void* m, void* d);
  void (*transmission)(const void* m, void* d);
  void (*passive)(const void* m, void* d);
  void (*rne)(const void* m, void* d, int with_acceleration, double* result);
  void (*fwd_velocity)(const void* m, void* d);
  void (*fwd_actuation)(const void* m, void* d);
  void (*forward)(const void* m, void* d);
  void (*step)(const void* m, void* d);
  void (*step1)(const void* m, void* d);
  void (*step2)(const void* m, void* d);
  void (*contact_force)(const void* m, const void* d, int contact, double result[6]);
  int (*name2id)(const void* m, int object, const char* name);
  const char* (*id2name)(const void* m, int object, int id);

  /* computes the inertia matrix in MuJoCo's sparse form, after kinematics and com_pos */
  void (*compute_inertia)(const void* m, void* d);
  /* writes the block (n, n) of the inertia matrix whose first velocity is dof, row by row; what is zero by the tree's shape is not written */
  void (*inertia)(const void* m, const void* d, int dof, int n, double* A);
  void (*contact)(const void* d, int contact, zmpwalk_contact* out);
  /* nonzero once MuJoCo has warned of a position, velocity or acceleration that is not finite or far too large */
  int (*diverged)(const void* d);
  /* nonzero where a passive-force callback is installed */
  int (*has_passive_callback)(void);

  /* where controls and forces of an actuator stand, and how many controls it takes */
  int (*control_address)(const void* m, int actuator);
  int (*control_count)(const void* m, int actuator);
  int (*force_address)(const void* m, int actuator);
  /* nonzero where it takes one control and acts at once: it has no delay and no plugin, and no option switches it off */
  int (*is_immediate)(const void* m, int actuator);
  /* why its force cannot be foreseen from the state and its control, or "" */
  const char* (*unforeseeable)(const void* m, int actuator);
  /* limit on the torque of all actuators of a joint together [N m]; infinity where there is none */
  double (*joint_force_limit)(const void* m, int joint);
  /* nonzero where the joint's gravity compensation counts as a force of its actuators */
  int (*compensates_by_actuator)(const void* m, int joint);
  /* share of the weight of a body that its gravity compensation lifts */
  double (*gravity_compensation)(const void* m, int body);
  /* nonzero where an equality constraint is active from the start, equalities not being switched off */
  int (*is_active)(const void* m, int equality);
  /* the two bodies that a connect or weld ties */
  void (*tied_bodies)(const void* m, int equality, int bodies[2]);
  /* inertia of a tendon [kg or kg m^2] */
  double (*tendon_armature)(const void* m, int tendon);
  /* names in words what acts on a body that only newer versions have and that zmpwalk does not model; "" for nothing */
  const char* (*unmodelled_on)(const void* m, int body);
} zmpwalk_adapter;

/* The one symbol of an adapter. `find` gives the address of a symbol of libmujoco, or NULL. Returns NULL, and in *missing the name, where one is missing. */
const zmpwalk_adapter* zmpwalk_adapter_of(void* (*find)(void* library, const char* name), void* library,
                                          const char** missing);

#ifdef __cplusplus
}
#endif

#endif
