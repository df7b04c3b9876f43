#pragma once

#include "zmpwalk/robot/rules/model_rules.hpp"

namespace zmpwalk {

/// Looks up names in a model, and remembers those that the model does not have.
class Names {
 public:
  explicit Names(const mjModel* m) : m_(m) {}

  int joint(const std::string& name) { return look_up(mjOBJ_JOINT, name, joints_); }
  int body(const std::string& name) { return look_up(mjOBJ_BODY, name, bodies_); }
  int site(const std::string& name) { return look_up(mjOBJ_SITE, name, sites_); }
  bool is_missing() const { return !joints_.empty() || !bodies_.empty() || !sites_.empty(); }
  /// Adds the names that were looked up and do not exist: a reason for joints, bodies and sites each.
  void add_missing(Reasons& out) const;

 private:
  int look_up(mjtObj type, const std::string& name, std::vector<std::string>& missing) const;
  void add(const char* kind, mjtObj type, int count, const std::vector<std::string>& missing, Reasons& out) const;

  const mjModel* m_;
  std::vector<std::string> joints_, bodies_, sites_;
};

/// The description's robot by MuJoCo's numbers; `root_body` is -1 where neither its root joint nor its feet are in the model.
RobotParts parts_of(const mjModel* m, const RobotDescription& description, Names& names);

/// Adds what is wrong with what a description says of base, start pose and torque limits.
void add_description(const mjModel* m, const RobotDescription& description, int root_body, Names& names, Reasons& out);

}  // namespace zmpwalk
