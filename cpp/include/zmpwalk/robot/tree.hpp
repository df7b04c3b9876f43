#pragma once

#include <mujoco/mujoco.h>

#include <vector>

// The tree of bodies and joints in a model, by MuJoCo's numbers.

namespace zmpwalk {

/// Bodies from `body` up to the root of its tree, `body` first.
std::vector<int> ancestors(const mjModel* m, int body);

/// Bodies that hang from `body` directly.
std::vector<int> children(const mjModel* m, int body);

/// Joints of one body.
std::vector<int> joints_of(const mjModel* m, int body);

/// The free joint of the tree that `body` hangs in, or -1.
int free_joint_of(const mjModel* m, int body);

inline bool contains(const std::vector<int>& numbers, int number) {
  for (const int one : numbers)
    if (one == number) return true;
  return false;
}

}  // namespace zmpwalk
