#include "zmpwalk/robot/mujoco_compat.hpp"

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

}  // namespace zmpwalk::mujoco_compat
