#include "zmpwalk/robot/words.hpp"

#include <cstdio>

namespace zmpwalk {

std::string object_name(const mjModel* m, mjtObj type, int id) {
  const char* name = id < 0 ? nullptr : mj_id2name(m, type, id);
  return name ? name : "";
}

std::string label(const mjModel* m, mjtObj type, int id) {
  const std::string name = object_name(m, type, id);
  return "'" + (name.empty() ? std::to_string(id) : name) + "'";
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
