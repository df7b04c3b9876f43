#include "zmpwalk/robot/mujoco_compat.hpp"

namespace zmpwalk::mujoco_compat {

std::string compiled_version() { return ZMPWALK_MUJOCO_VERSION; }

void full_inertia(const mjModel* m, mjData* d, mjtNum* dst) {
#if mjVERSION_HEADER < 300  // 2.2.2 counts 222: mj_crb fills qM
  mj_crb(m, d);
  mj_fullM(m, dst, d->qM);
#else  // 4.0.0: mj_makeM fills M, and mj_fullM reads it from mjData
  mj_makeM(m, d);
  mj_fullM(m, d, dst);
#endif
}

ContactPair contact_pair(const mjContact& contact) {
#if mjVERSION_HEADER < 300
  return {contact.geom1, contact.geom2};
#else
  return {contact.geom[0], contact.geom[1]};
#endif
}

}  // namespace zmpwalk::mujoco_compat
