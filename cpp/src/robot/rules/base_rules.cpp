#include "zmpwalk/robot/rules/base_rules.hpp"

#include <utility>

#include "zmpwalk/robot/tree.hpp"
#include "zmpwalk/robot/words.hpp"

namespace zmpwalk {
namespace {

/// Share of the robot's mass that a link has which only carries a joint of the base.
constexpr double kDummy = 0.05;

}  // namespace

// --- the base

std::vector<int> base_joints(const Model& m, int root_body) {
  std::vector<int> joints;
  for (int body = root_body;;) {
    for (const int j : joints_of(m, body)) joints.push_back(j);
    const std::vector<int> next = children(m, body);
    if (next.size() != 1 || m.body_mass[body] > kDummy * m.body_subtreemass[root_body]) return joints;
    body = next.front();
  }
}

void add_base(const Model& m, int root_body, Reasons& out) {
  if (free_joint_of(m, root_body) >= 0) return;
  const std::string floats = "a walking robot needs a floating base: ", free = "<freejoint name=\"root\"/>";
  if (root_body <= 0) {
    out.push_back({"base", "fixed base: the model has no free joint, everything is fixed to the world; " + floats +
                               "write " + free + " in the body of its trunk"});
    return;
  }
  const std::string body = body_label(m, root_body);
  const std::vector<int> joints = base_joints(m, root_body);
  std::vector<std::string> words;
  for (const int j : joints) words.push_back(label(m, mj::kJoint, j) + " (" + joint_kind(m, j) + ")");
  if (joints.empty())
    out.push_back({"base", "fixed base: " + body + " has no free joint and is fixed to the world; " + floats +
                               "write " + free + " in it"});
  else
    out.push_back({"base", "no floating base: " + body + " hangs from the world by " + listed(words) +
                               " and has no free joint; " + floats + "write " + free + " in " + body + " in place of " +
                               (joints.size() > 1 ? "these joints" : "this joint") +
                               ", whose actuators, sensors and keyframe values go too"});
}

int largest_tree(const Model& m) {
  std::vector<int> joints(m.nbody, 0);
  for (int j = 0; j < m.njnt; ++j) ++joints[m.body_rootid[m.jnt_bodyid[j]]];
  int largest = -1;
  for (const int body : children(m, 0)) {
    const auto size = [&](int b) { return std::make_pair(joints[b], m.body_subtreemass[b]); };
    if (largest < 0 || size(body) > size(largest)) largest = body;
  }
  return largest;
}

}  // namespace zmpwalk
