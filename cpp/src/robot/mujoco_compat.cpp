#include "zmpwalk/robot/mujoco_compat.hpp"

#include <algorithm>
#include <limits>

namespace zmpwalk::mujoco_compat {

std::string compiled_version() { return ZMPWALK_MUJOCO_VERSION; }

void compute_inertia(const mjModel* m, mjData* d) {
#if mjVERSION_HEADER < 300  // 2.2.2 counts 222: mj_crb fills qM
  mj_crb(m, d);
#else  // 4.0.0: mj_makeM fills M
  mj_makeM(m, d);
#endif
}

void inertia(const mjModel* m, const mjData* d, int dof, RowMatX& A) {
  for (int i = 0; i < A.rows(); ++i) {
#if mjVERSION_HEADER < 300  // qM: the diagonal, then the ancestors on the way to the root
    const mjtNum* entry = d->qM + m->dof_Madr[dof + i];
    for (int j = dof + i; j >= 0; j = m->dof_parentid[j], ++entry) A(i, j - dof) = A(j - dof, i) = *entry;
#else  // M: rows of the lower triangle
    const int row = dof + i, first = m->M_rowadr[row];
    for (int k = first; k < first + m->M_rownnz[row]; ++k)
      A(i, m->M_colind[k] - dof) = A(m->M_colind[k] - dof, i) = d->M[k];
#endif
  }
}

ContactPair contact_pair(const mjContact& contact) {
#if mjVERSION_HEADER < 300
  return {contact.geom1, contact.geom2};
#else
  return {contact.geom[0], contact.geom[1]};
#endif
}

#if mjVERSION_HEADER < 300

int actuator_count(const mjModel* m) { return m->nu; }
int control_address(const mjModel*, int actuator) { return actuator; }
int control_count(const mjModel*, int) { return 1; }
int force_address(const mjModel*, int actuator) { return actuator; }
bool is_immediate(const mjModel* m, int) { return !(m->opt.disableflags & mjDSBL_ACTUATION); }
std::string unforeseeable(const mjModel*, int) { return ""; }
double joint_force_limit(const mjModel*, int) { return std::numeric_limits<double>::infinity(); }
bool compensates_gravity_by_actuator(const mjModel*, int) { return false; }
double gravity_compensation(const mjModel*, int) { return 0.0; }
bool is_active(const mjModel* m, int equality) {
  return m->eq_active[equality] && !(m->opt.disableflags & mjDSBL_EQUALITY);
}
TiedBodies tied_bodies(const mjModel* m, int equality) { return {m->eq_obj1id[equality], m->eq_obj2id[equality]}; }
double tendon_armature(const mjModel*, int) { return 0.0; }
std::string unmodelled_on(const mjModel*, int) { return ""; }

#else

int actuator_count(const mjModel* m) { return static_cast<int>(m->nactuator); }
int control_address(const mjModel* m, int actuator) { return m->actuator_ctrladr[actuator]; }
int control_count(const mjModel* m, int actuator) { return m->actuator_ctrlnum[actuator]; }
int force_address(const mjModel* m, int actuator) { return m->actuator_outadr[actuator]; }

bool is_immediate(const mjModel* m, int actuator) {
  const int group = m->actuator_group[actuator];
  const bool off = (m->opt.disableflags & mjDSBL_ACTUATION) ||
                   (group >= 0 && group < mjNGROUP && (m->opt.disableactuator & (1 << group)));
  return !off && m->actuator_ctrlnum[actuator] == 1 && unforeseeable(m, actuator).empty();
}

std::string unforeseeable(const mjModel* m, int actuator) {
  if (m->actuator_plugin[actuator] >= 0) return "is a plugin";
  if (m->actuator_delay[actuator] > 0.0) return "delays its control";
  return "";
}

double joint_force_limit(const mjModel* m, int joint) {
  if (!m->jnt_actfrclimited[joint]) return std::numeric_limits<double>::infinity();
  return std::min(-m->jnt_actfrcrange[2 * joint], m->jnt_actfrcrange[2 * joint + 1]);
}

bool compensates_gravity_by_actuator(const mjModel* m, int joint) { return m->jnt_actgravcomp[joint]; }
double gravity_compensation(const mjModel* m, int body) { return m->body_gravcomp[body]; }

bool is_active(const mjModel* m, int equality) {
  return m->eq_active0[equality] && !(m->opt.disableflags & mjDSBL_EQUALITY);
}

TiedBodies tied_bodies(const mjModel* m, int equality) {
  const int first = m->eq_obj1id[equality], second = m->eq_obj2id[equality];
  if (m->eq_objtype[equality] == mjOBJ_SITE) return {m->site_bodyid[first], m->site_bodyid[second]};
  return {first, second};
}

double tendon_armature(const mjModel* m, int tendon) { return m->tendon_armature[tendon]; }

std::string unmodelled_on(const mjModel* m, int body) {
  if (m->body_plugin[body] >= 0) return "a plugin acts on it";
  for (int v = 0; v < m->nflexvert; ++v)
    if (m->flex_vertbodyid[v] == body) return "a flex is attached to it";
  for (int g = 0; m->flg_adhesion && g < m->body_geomnum[body]; ++g)
    if (m->geom_adhesion[m->body_geomadr[body] + g] != 0.0) return "its geoms stick to what they touch";
  return "";
}

#endif

}  // namespace zmpwalk::mujoco_compat
