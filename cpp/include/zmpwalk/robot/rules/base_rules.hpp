#pragma once

#include "zmpwalk/robot/rules/model_rules.hpp"

namespace zmpwalk {

/// Adds a tree without a free joint, with the joints that hold its base and what to write in their place. `root_body` is its outermost
/// body, or -1 in an empty world.
void add_base(const mjModel* m, int root_body, Reasons& out);

/// Joints from the world to the base: of the outermost body and of the light links without branches that follow it.
std::vector<int> base_joints(const mjModel* m, int root_body);

/// The outermost body of the tree with most joints; of equals, and where no tree has any, the heaviest. -1 in an empty world.
int largest_tree(const mjModel* m);

}  // namespace zmpwalk
