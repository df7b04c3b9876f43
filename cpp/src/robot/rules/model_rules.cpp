#include "zmpwalk/robot/rules/model_rules.hpp"

#include <cmath>
#include <set>

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/robot/actuation.hpp"
#include "zmpwalk/robot/mujoco.hpp"
#include "zmpwalk/robot/rules/base_rules.hpp"
#include "zmpwalk/robot/rules/description_rules.hpp"
#include "zmpwalk/robot/rules/leg_rules.hpp"
#include "zmpwalk/robot/rules/unmodelled.hpp"
#include "zmpwalk/robot/tree.hpp"
#include "zmpwalk/robot/words.hpp"

namespace zmpwalk {
namespace {

void add_world(const Model& m, Reasons& out) {
  const double* g = m.gravity;
  const bool off = *m.disableflags & m.no_gravity;
  if (off || !(g[2] < 0.0) || std::hypot(g[0], g[1]) > 1e-6 * std::abs(g[2]))
    out.push_back({"gravity", "gravity is (" + number(g[0]) + ", " + number(g[1]) + ", " + number(g[2]) + ") m/s^2" +
                                  (off ? " and switched off" : "") + "; zmpwalk walks where it points down along z"});
  constexpr double kShortest = 1e-5,
                   kLongest = 0.1;  // shorter makes a start of millions of steps, longer is no walk [s]
  if (!(*m.timestep >= kShortest) || !(*m.timestep <= kLongest))
    out.push_back({"time step", "the model's time step is " + number(*m.timestep) + " s; walking takes one of " +
                                    number(kShortest) + " to " + number(kLongest) + " s"});
  if (*m.disableflags & (m.no_contact | m.no_constraint))
    out.push_back({"contacts", "the model's option flags switch contacts off; walking needs them"});
}

void add_joints(const Model& m, const RobotParts& robot, const std::set<int>& legs, Reasons& out) {
  const std::vector<int> of_base =
      free_joint_of(m, robot.root_body) < 0 ? base_joints(m, robot.root_body) : std::vector<int>{};
  std::vector<std::string> nameless;
  for (const int j : tree_joints(m, robot.root_body)) {
    if (contains(of_base, j)) continue;  // a free joint comes in their place
    if (object_name(m, mj::kJoint, j).empty())
      nameless.push_back("joint " + std::to_string(j) + " at body " + label(m, mj::kBody, m.jnt_bodyid[j]));
    if (m.jnt_type[j] == mj::kBall && !legs.count(j))
      out.push_back({"joint", "joint " + label(m, mj::kJoint, j) +
                                  " is neither hinge nor slide but a ball joint; write it as three hinges"});
    for (int a = 0; a < m.nactuator; ++a) {
      const char* range = turns_joint(m, a, j) ? range_without_rest(m, a) : nullptr;
      if (range)
        out.push_back({"motor", "motor of joint " + label(m, mj::kJoint, j) + " has a " + range +
                                    " range without 0 inside; use " + range + "range=\"-tau tau\""});
    }
  }
  for (const LegParts& leg : robot.legs)
    if (leg.foot >= 0 && object_name(m, mj::kBody, leg.foot).empty())
      nameless.push_back(foot_of(leg) + ", body " + std::to_string(leg.foot) + ",");
  if (!nameless.empty())
    out.push_back({"names", listed(nameless) + (nameless.size() > 1 ? " have no names" : " has no name") +
                                "; descriptions go by names, so give " +
                                (nameless.size() > 1 ? "each one" : "it one")});
}

/// The rules about the tree: legs, soles, joints, and what acts on them.
void add_robot(const Model& m, const RobotParts& robot, const std::optional<Data>& upright, Reasons& out) {
  std::set<int> taken;
  add_legs(m, robot, upright, taken, out);
  add_joints(m, robot, taken, out);
  add_unmodelled(m, robot, out);
}

/// Throws InputError where there are not two legs, or a number is that of nothing in the model.
void require_numbers(const Model& m, const RobotParts& robot) {
  const auto require = [](const char* what, int id, int count) {
    if (id < 0 || id >= count)
      throw InputError(std::string(what) + " " + std::to_string(id) + " does not exist; the model has " +
                       std::to_string(count));
  };
  if (robot.legs.size() != 2)
    throw InputError("the robot has " + std::to_string(robot.legs.size()) + " legs; zmpwalk walks on 2");
  require("body", robot.root_body, m.nbody);
  for (const LegParts& leg : robot.legs) {
    require("body", leg.foot, m.nbody);
    for (const int joint : leg.joints) require("joint", joint, m.njnt);
  }
}

}  // namespace

std::vector<int> chain_joints(const Model& m, const RobotParts& robot) {
  std::set<int> joints;
  for (const LegParts& leg : robot.legs)
    for (const int body : ancestors(m, leg.foot))
      for (const int j : joints_of(m, body))
        if (m.jnt_type[j] != mj::kFree) joints.insert(j);
  return {joints.begin(), joints.end()};
}

Reasons model_reasons(const Model& m) {
  Reasons out;
  add_base(m, largest_tree(m), out);
  add_world(m, out);
  return out;
}

Reasons model_reasons(const Model& m, const RobotParts& robot, const std::optional<Data>& upright) {
  require_numbers(m, robot);
  Reasons out;
  add_base(m, robot.root_body, out);
  add_robot(m, robot, upright, out);
  add_world(m, out);
  return out;
}

Reasons model_reasons(const Model& m, const RobotDescription& description) {
  Reasons out, of_robot;
  Names names(m);
  const RobotParts robot = parts_of(m, description, names);
  if (robot.root_body > 0) {
    add_base(m, robot.root_body, out);
    add_robot(m, robot, std::nullopt, of_robot);
    add_description(m, description, robot.root_body, names, of_robot);
  } else if (!names.is_missing()) {
    out.push_back({"base", "the description's feet are the world and it has no root_joint: it describes no robot"});
  }
  names.add_missing(out);
  out.insert(out.end(), of_robot.begin(), of_robot.end());
  add_world(m, out);
  return out;
}

void require_none(const Reasons& reasons) {
  if (reasons.empty()) return;
  std::vector<std::string> texts;
  for (const Reason& reason : reasons) texts.push_back(reason.text);
  throw ModelError(std::move(texts));
}

}  // namespace zmpwalk
