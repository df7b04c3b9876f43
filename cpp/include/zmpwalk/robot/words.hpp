#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

// Names and numbers as messages about a model write them.

namespace zmpwalk {

/// Name of a MuJoCo object, or "" where it has none.
std::string object_name(const mjModel* m, mjtObj type, int id);

/// The object's name, or its number where it has none, in quotes: 'l_knee', '7'.
std::string label(const mjModel* m, mjtObj type, int id);

/// The label of a body with the word before it: body 'l_foot'.
std::string body_label(const mjModel* m, int body);

/// The joints' labels one after another: 'l_knee', 'l_ankle_pitch'; "none" where there is none.
std::string joint_labels(const mjModel* m, const std::vector<int>& joints);

/// "hinge", "slide", "ball" or "free".
std::string joint_kind(const mjModel* m, int joint);

/// The number with four digits: 0.14, 9.81, 1e+155.
std::string number(double value);

/// The words one after another, with commas between them; after `most` words "..." stands for the rest.
std::string listed(const std::vector<std::string>& words, std::size_t most = 12);

}  // namespace zmpwalk
