#include "zmpwalk/robot/words.hpp"

#include <cstdio>

namespace zmpwalk {

std::string object_name(const Model& m, int type, int id) {
  const char* name = id < 0 ? nullptr : mj::id2name(m, type, id);
  return name ? name : "";
}

std::string label(const Model& m, int type, int id) {
  const std::string name = object_name(m, type, id);
  return "'" + (name.empty() ? std::to_string(id) : name) + "'";
}

std::string body_label(const Model& m, int body) { return "body " + label(m, mj::kBody, body); }

std::string joint_labels(const Model& m, const std::vector<int>& joints) {
  std::vector<std::string> words;
  for (const int j : joints) words.push_back(label(m, mj::kJoint, j));
  return joints.empty() ? "none" : listed(words);
}

std::string joint_kind(const Model& m, int joint) {
  const int type = m.jnt_type[joint];
  return type == mj::kBall ? "ball" : type == mj::kSlide ? "slide" : type == mj::kHinge ? "hinge" : "free";
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string listed(const std::vector<std::string>& words, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < words.size() && i <= most; ++i)
    text += (i ? ", " : "") + (i < most ? words[i] : std::string("..."));
  return text;
}

}  // namespace zmpwalk
