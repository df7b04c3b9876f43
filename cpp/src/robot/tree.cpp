#include "zmpwalk/robot/tree.hpp"

namespace zmpwalk {

std::vector<int> ancestors(const Model& m, int body) {
  std::vector<int> chain;
  for (; body > 0; body = m.body_parentid[body]) chain.push_back(body);
  return chain;
}

std::vector<int> children(const Model& m, int body) {
  std::vector<int> out;
  for (int b = body + 1; b < m.nbody; ++b)
    if (m.body_parentid[b] == body) out.push_back(b);
  return out;
}

std::vector<int> joints_of(const Model& m, int body) {
  std::vector<int> joints;
  for (int k = 0; k < m.body_jntnum[body]; ++k) joints.push_back(m.body_jntadr[body] + k);
  return joints;
}

int free_joint_of(const Model& m, int body) {
  if (body < 0) return -1;
  const int root = m.body_rootid[body];
  if (m.body_jntnum[root] == 0) return -1;
  const int joint = m.body_jntadr[root];
  return m.jnt_type[joint] == mj::kFree ? joint : -1;
}

}  // namespace zmpwalk
