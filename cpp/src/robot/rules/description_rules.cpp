#include "zmpwalk/robot/rules/description_rules.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "zmpwalk/robot/actuation.hpp"
#include "zmpwalk/robot/tree.hpp"
#include "zmpwalk/robot/words.hpp"

namespace zmpwalk {
namespace {

/// Of the quaternions and lengths in a description. Larger or other numbers are mistakes, with which sums overflow.
constexpr double kFarthest = 1e3;      // from the origin [m], and of an angle [rad]
constexpr double kLargestSole = 10.0;  // [m]

bool is_unit(const Eigen::Vector4d& quaternion) { return std::abs(quaternion.norm() - 1.0) < 1e-3; }

template <class Vector>
bool is_near(const Vector& position, double most) {
  return position.allFinite() && position.cwiseAbs().maxCoeff() <= most;
}

void add_foot(const Foot& foot, Reasons& out) {
  if (!is_unit(foot.sole_quat))
    out.push_back({"sole", "the sole of '" + foot.body + "' has no unit quaternion (w, x, y, z), but one of length " +
                               number(foot.sole_quat.norm())});
  if (!is_near(foot.sole_pos, kLargestSole) || !(foot.length > 0.0 && foot.length <= kLargestSole) ||
      !(foot.width > 0.0 && foot.width <= kLargestSole))
    out.push_back({"sole", "the sole of '" + foot.body + "' is " + number(foot.length) + " x " + number(foot.width) +
                               " m; length and width must be greater than 0 and, as its centre's distance from the "
                               "body, at most " +
                               number(kLargestSole) + " m"});
}

}  // namespace

void Names::add_missing(Reasons& out) const {
  add("joint", mj::kJoint, m_.njnt, joints_, out);
  add("body", mj::kBody, m_.nbody, bodies_, out);
  add("site", mj::kSite, m_.nsite, sites_, out);
}

int Names::look_up(int type, const std::string& name, std::vector<std::string>& missing) const {
  const int id = mj::name2id(m_, type, name.c_str());
  const std::string quoted = "'" + name + "'";
  if (id < 0 && std::find(missing.begin(), missing.end(), quoted) == missing.end()) missing.push_back(quoted);
  return id;
}

void Names::add(const char* kind, int type, int count, const std::vector<std::string>& missing, Reasons& out) const {
  if (missing.empty()) return;
  std::vector<std::string> has;
  for (int i = 0; i < count; ++i) has.push_back(object_name(m_, type, i));
  out.push_back({"names", std::string("the model has no ") + kind + " named " + listed(missing) +
                              "; it has: " + (has.empty() ? "none" : listed(has))});
}

RobotParts parts_of(const Model& m, const RobotDescription& description, Names& names) {
  RobotParts robot;
  const int root = description.root_joint.empty() ? -1 : names.joint(description.root_joint);
  for (const Side side : kSides) {
    const Foot& foot = description.feet[side];
    LegParts leg{side == kLeft ? "left" : "right", names.body(foot.body), {}, Vec2(foot.length, foot.width)};
    if (!foot.sole_site.empty()) names.site(foot.sole_site);
    for (const std::string& joint : foot.leg_joints) leg.joints.push_back(names.joint(joint));
    if (robot.root_body < 0 && leg.foot > 0) robot.root_body = m.body_rootid[leg.foot];
    robot.legs.push_back(std::move(leg));
  }
  if (root >= 0) robot.root_body = m.body_rootid[m.jnt_bodyid[root]];
  return robot;
}

void add_description(const Model& m, const RobotDescription& description, int root_body, Names& names, Reasons& out) {
  const int named = mj::name2id(m, mj::kJoint, description.root_joint.c_str()), root = free_joint_of(m, root_body);
  if (named >= 0 && root >= 0 && named != root)
    out.push_back({"base", "joint " + label(m, mj::kJoint, named) + " is not a free joint, but a " +
                               joint_kind(m, named) + "; the free joint of this robot's base is " +
                               label(m, mj::kJoint, root)});
  std::vector<std::string> valueless;
  if (root >= 0)
    for (const int j : tree_joints(m, root_body)) {
      const std::string name = object_name(m, mj::kJoint, j);
      if (!name.empty() && !description.stand_joints.count(name)) valueless.push_back("'" + name + "'");
    }
  if (!valueless.empty()) out.push_back({"stand", "the start pose has no value for joint " + listed(valueless)});
  for (const Side side : kSides) add_foot(description.feet[side], out);
  for (const auto& [name, value] : description.stand_joints)
    if (!(std::abs(value) <= kFarthest))
      out.push_back({"stand", "the start pose's value for joint '" + name + "' is " + number(value) +
                                  "; it must be finite and at most " + number(kFarthest)});
  for (const auto& [name, limit] : description.torque_limits)
    if (!(limit > 0.0))
      out.push_back({"motor", "the torque limit of joint '" + name + "' is " + number(limit) +
                                  " N m; it must be greater than 0"});
  std::set<int> strangers;
  for (const auto* table : {&description.stand_joints, &description.torque_limits})
    for (const auto& entry : *table) {
      const int j = names.joint(entry.first);
      if (j >= 0 && (m.body_rootid[m.jnt_bodyid[j]] != root_body || j == root)) strangers.insert(j);
    }
  for (const int j : strangers)
    out.push_back({"names", "joint " + label(m, mj::kJoint, j) +
                                " does not belong to this robot; take it out of start pose and torque limits"});
  if (!is_near(description.stand_base_pos, kFarthest) || !is_unit(description.stand_base_quat))
    out.push_back({"stand", "the start pose's base is not a position and a unit quaternion (w, x, y, z)"});
}

}  // namespace zmpwalk
