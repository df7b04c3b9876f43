#pragma once

#include "zmpwalk/robot/rules/model_rules.hpp"

namespace zmpwalk {

/// Adds a reason where the tree has no free joint: it names the joints that hold the base, and says what to write in their place. `root_body` is the
/// outermost body of the tree, or -1 in an empty world.
void add_base(const mjModel* m, int root_body, Reasons& out);

/// Joints from the world to the base: of the outermost body and of the light links without branches that follow it.
std::vector<int> base_joints(const mjModel* m, int root_body);

/// The outermost body of the tree with most joints. Of trees with equally many joints it takes the heaviest. -1 in an empty world.
int largest_tree(const mjModel* m);

}  // namespace zmpwalk
