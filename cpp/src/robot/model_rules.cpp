#include "zmpwalk/robot/model_rules.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/robot/actuation.hpp"
#include "zmpwalk/robot/mujoco_compat.hpp"
#include "zmpwalk/robot/stand_rules.hpp"
#include "zmpwalk/robot/unmodelled.hpp"
#include "zmpwalk/robot/words.hpp"

namespace zmpwalk {
namespace {

// Smaller soles are point feet: shares of the leg, hip to foot along its bones.
constexpr double kLeastLength = 0.1, kLeastWidth = 0.04;

/// Share of the robot's mass that a link has which only carries a joint of the base.
constexpr double kDummy = 0.05;

std::string body_label(const mjModel* m, int body) { return "body " + label(m, mjOBJ_BODY, body); }
std::string joint_label(const mjModel* m, int joint) { return label(m, mjOBJ_JOINT, joint); }

template <class Labels>
std::string labels(const Labels& ids, const mjModel* m, std::string (*of)(const mjModel*, int)) {
  std::vector<std::string> words;
  for (const int id : ids) words.push_back(of(m, id));
  return listed(words);
}

std::string kind_of(const mjModel* m, int joint) {
  const int type = m->jnt_type[joint];
  return type == mjJNT_BALL ? "ball" : type == mjJNT_SLIDE ? "slide" : type == mjJNT_HINGE ? "hinge" : "free";
}

bool contains(const std::vector<int>& numbers, int number) {
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

std::vector<int> joints_of(const mjModel* m, int body) {
  std::vector<int> joints;
  for (int k = 0; k < m->body_jntnum[body]; ++k) joints.push_back(m->body_jntadr[body] + k);
  return joints;
}

std::vector<int> children(const mjModel* m, int body) {
  std::vector<int> out;
  for (int b = body + 1; b < m->nbody; ++b)
    if (m->body_parentid[b] == body) out.push_back(b);
  return out;
}

// --- the world

void add_world(const mjModel* m, Reasons& out) {
  const mjtNum* g = m->opt.gravity;
  const bool off = m->opt.disableflags & mjDSBL_GRAVITY;
  if (off || !(g[2] < 0.0) || std::hypot(g[0], g[1]) > 1e-6 * std::abs(g[2]))
    out.push_back({"gravity", "gravity is (" + number(g[0]) + ", " + number(g[1]) + ", " + number(g[2]) + ") m/s^2" +
                                  (off ? " and switched off" : "") + "; zmpwalk walks where it points down along z"});
  if (!(m->opt.timestep > 0.0) || !std::isfinite(m->opt.timestep))
    out.push_back({"time step", "the model's time step is " + number(m->opt.timestep) +
                                    " s; walking takes one that is finite and greater than 0"});
  if (m->opt.disableflags & (mjDSBL_CONTACT | mjDSBL_CONSTRAINT))
    out.push_back({"contacts", "the model's option flags switch contacts off; walking needs them"});
}

// --- the base

/// Joints from the world to the base: of the outermost body and of the light links without branches that follow it.
std::vector<int> base_joints(const mjModel* m, int root_body) {
  std::vector<int> joints;
  for (int body = root_body;;) {
    for (const int j : joints_of(m, body)) joints.push_back(j);
    const std::vector<int> next = children(m, body);
    if (next.size() != 1 || m->body_mass[body] > kDummy * m->body_subtreemass[root_body]) return joints;
    body = next.front();
  }
}

void add_base(const mjModel* m, int root_body, Reasons& out) {
  const std::string floats = "a walking robot needs a floating base: ", free = "<freejoint name=\"root\"/>";
  if (root_body <= 0) {
    out.push_back({"base", "fixed base: the model has no free joint, everything is fixed to the world; " + floats +
                               "write " + free + " in the body of its trunk"});
    return;
  }
  const std::string body = body_label(m, root_body);
  const std::vector<int> joints = base_joints(m, root_body);
  std::vector<std::string> words;
  for (const int j : joints) words.push_back(joint_label(m, j) + " (" + kind_of(m, j) + ")");
  if (joints.empty())
    out.push_back({"base", "fixed base: " + body + " has no free joint and is fixed to the world; " + floats +
                               "write " + free + " in it"});
  else
    out.push_back({"base", "no floating base: " + body + " hangs from the world by " + listed(words) +
                               " and has no free joint; " + floats + "write " + free + " in " + body + " in place of " +
                               (joints.size() > 1 ? "these joints" : "this joint") +
                               ", whose actuators, sensors and keyframe values go too"});
}

/// The outermost body of the tree with most joints; of equals, and where no tree has any, the heaviest. -1 in an empty world.
int largest_tree(const mjModel* m) {
  std::vector<int> joints(m->nbody, 0);
  for (int j = 0; j < m->njnt; ++j) ++joints[m->body_rootid[m->jnt_bodyid[j]]];
  int largest = -1;
  for (const int body : children(m, 0)) {
    const auto size = [&](int b) { return std::make_pair(joints[b], m->body_subtreemass[b]); };
    if (largest < 0 || size(body) > size(largest)) largest = body;
  }
  return largest;
}

// --- the legs

std::string leg_of(const LegParts& leg) { return "the " + leg.side + (leg.side.empty() ? "leg" : " leg"); }
std::string sole_of(const LegParts& leg) { return "the " + leg.side + (leg.side.empty() ? "sole" : " sole"); }
std::string foot_of(const LegParts& leg) { return "the " + leg.side + (leg.side.empty() ? "foot" : " foot"); }

/// Bodies of a leg, foot first: those that do not carry the other foot too.
std::vector<int> leg_bodies(const mjModel* m, const LegParts& leg, const LegParts& other) {
  std::vector<int> bodies;
  const std::vector<int> theirs = other.foot < 0 ? std::vector<int>{} : ancestors(m, other.foot);
  for (const int body : ancestors(m, leg.foot)) {
    if (contains(theirs, body)) break;
    bodies.push_back(body);
  }
  return bodies;
}

/// Hip to foot along the bodies, from the outermost joint of the leg [m].
double bones(const mjModel* m, const LegParts& leg, const LegParts& other) {
  double length = 0.0, below_joint = 0.0;
  for (const int body : leg_bodies(m, leg, other)) {
    if (m->body_jntnum[body] > 0) below_joint = length;
    length += Eigen::Map<const Vec3>(m->body_pos + 3 * body).norm();
  }
  return below_joint;
}

/// Where the joints are that a leg lacks: listed by nobody above the foot, or below the body that the sole was found on.
std::string lacking(const mjModel* m, const LegParts& leg, const LegParts& other) {
  std::vector<int> above;
  for (const int body : leg_bodies(m, leg, other))
    for (const int j : joints_of(m, body))
      if (!contains(leg.joints, j) && m->jnt_type[j] != mjJNT_FREE) above.push_back(j);
  std::reverse(above.begin(), above.end());
  if (!above.empty())
    return "; of the joints that move this foot these are not listed: " + labels(above, m, joint_label);
  const std::size_t missing = 6 - leg.joints.size();
  std::vector<int> below;
  int last = leg.foot;
  for (int j = 0; j < m->njnt && below.size() < missing; ++j) {
    const int body = m->jnt_bodyid[j];
    if (body == leg.foot || !contains(ancestors(m, body), last)) continue;
    below.push_back(j);
    last = body;
  }
  if (below.size() < missing) return "";
  return "; below " + body_label(m, leg.foot) + (below.size() > 1 ? " hang joints " : " hangs joint ") +
         labels(below, m, joint_label) + ": if the ankle goes on there, the sole's geoms and site belong to " +
         body_label(m, last);
}

void add_leg(const mjModel* m, const LegParts& leg, const LegParts& other, std::set<int>& taken, Reasons& out) {
  const std::vector<int> chain = ancestors(m, leg.foot);
  std::vector<int> strangers;
  int previous = -1;
  bool ordered = true;
  for (const int joint : leg.joints) {
    if (joint < 0) continue;
    if (!contains(chain, m->jnt_bodyid[joint])) {
      strangers.push_back(joint);
      continue;
    }
    if (!taken.insert(joint).second)
      out.push_back({"leg", "joint " + joint_label(m, joint) + " is listed twice among the leg joints"});
    if (m->jnt_type[joint] != mjJNT_HINGE)
      out.push_back({"leg", "leg joint " + joint_label(m, joint) + " is a " + kind_of(m, joint) +
                                " joint; a leg is six hinges (write a ball joint as three)"});
    if (ordered && joint < previous)
      out.push_back({"leg", leg_of(leg) + "'s joints are not listed from hip to ankle: " + joint_label(m, joint) +
                                " comes before " + joint_label(m, previous) + " in the model"});
    ordered = ordered && joint >= previous;
    previous = joint;
  }
  if (leg.joints.size() != 6)
    out.push_back({"leg", leg_of(leg) + " that ends at " + body_label(m, leg.foot) + " has " +
                              std::to_string(leg.joints.size()) + " joints (" + labels(leg.joints, m, joint_label) +
                              "); placing a flat foot anywhere takes 6: hip 3, knee 1, ankle 2" +
                              (leg.joints.size() < 6 ? lacking(m, leg, other) : "")});
  if (!strangers.empty())
    out.push_back({"leg", leg_of(leg) + " lists joints that do not move its foot " + label(m, mjOBJ_BODY, leg.foot) +
                              ": " + labels(strangers, m, joint_label)});
}

/// A geom that moves with `body` can collide with what is not the robot; true where the model holds nothing else yet.
bool can_touch_ground(const mjModel* m, int body, int root_body) {
  const auto belongs = [&](int geom, int to) {
    for (int b = m->geom_bodyid[geom]; b > 0; b = m->body_parentid[b])
      if (b == to) return true;
    return false;
  };
  bool others = false, collides = false;
  for (int g = 0; g < m->ngeom; ++g) {
    if (belongs(g, root_body)) continue;
    others = others || m->geom_contype[g] || m->geom_conaffinity[g];
    for (int s = 0; s < m->ngeom && !collides; ++s)
      collides = belongs(s, body) &&
                 ((m->geom_contype[s] & m->geom_conaffinity[g]) || (m->geom_contype[g] & m->geom_conaffinity[s]));
  }
  for (int p = 0; p < m->npair && !collides; ++p) {
    const int one = m->pair_geom1[p], two = m->pair_geom2[p];
    collides = belongs(one, body) != belongs(two, body) && belongs(one, root_body) != belongs(two, root_body);
  }
  return collides || (!others && m->npair == 0);
}

void add_sole(const mjModel* m, const LegParts& leg, const LegParts& other, int root_body, Reasons& out) {
  const double length = bones(m, leg, other), least_length = kLeastLength * length, least_width = kLeastWidth * length;
  const bool long_enough = !leg.sole || (leg.sole->x() > 0.0 && leg.sole->x() >= least_length);
  const bool wide_enough = !leg.sole || (leg.sole->y() > 0.0 && leg.sole->y() >= least_width);
  if (!long_enough || !wide_enough)
    out.push_back({"sole", "point foot: " + sole_of(leg) + ", of " + body_label(m, leg.foot) + ", is " +
                               number(leg.sole->x()) + " x " + number(leg.sole->y()) + " m, too small for a leg of " +
                               number(length) + " m, which takes at least " + number(least_length) + " x " +
                               number(least_width) + " m"});
  if (!can_touch_ground(m, leg.foot, root_body))
    out.push_back({"sole", foot_of(leg) + " " + label(m, mjOBJ_BODY, leg.foot) +
                               " has no geom that can collide with anything but the robot; see contype and "
                               "conaffinity"});
}

void add_axes(const mjModel* m, const LegParts& leg, const Vec3& forward, const mjData* d, Reasons& out) {
  LegAxes axes;
  for (int i = 0; i < 6; ++i) axes.col(i) = Eigen::Map<const Vec3>(d->xaxis + 3 * leg.joints[i]);
  const std::string who = leg_of(leg) + " (" + labels(leg.joints, m, joint_label) + ")";
  add_leg_axes(who, axes, forward, Vec3::UnitZ().cross(forward), out);
}

/// The leg has all its parts in the model, and six hinges.
bool is_whole(const mjModel* m, const LegParts& leg) {
  const auto is_hinge = [&](int j) { return j >= 0 && m->jnt_type[j] == mjJNT_HINGE; };
  return leg.foot >= 0 && leg.joints.size() == 6 && std::all_of(leg.joints.begin(), leg.joints.end(), is_hinge);
}

// --- all joints

void add_joints(const mjModel* m, const RobotParts& robot, const std::set<int>& legs, Reasons& out) {
  const std::vector<int> of_base =
      free_joint_of(m, robot.root_body) < 0 ? base_joints(m, robot.root_body) : std::vector<int>{};
  std::vector<std::string> nameless;
  for (const int j : tree_joints(m, robot.root_body)) {
    if (contains(of_base, j)) continue;  // a free joint comes in their place
    if (object_name(m, mjOBJ_JOINT, j).empty())
      nameless.push_back("joint " + std::to_string(j) + " at body " + label(m, mjOBJ_BODY, m->jnt_bodyid[j]));
    if (m->jnt_type[j] == mjJNT_BALL && !legs.count(j))
      out.push_back({"joint", "joint " + joint_label(m, j) +
                                  " is neither hinge nor slide but a ball joint; write it as three hinges"});
    for (int a = 0; a < mujoco_compat::actuator_count(m); ++a) {
      const char* range = turns_joint(m, a, j) ? range_without_rest(m, a) : nullptr;
      if (range)
        out.push_back({"motor", "motor of joint " + joint_label(m, j) + " has a " + range +
                                    " range without 0 inside; use " + range + "range=\"-tau tau\""});
    }
  }
  for (const LegParts& leg : robot.legs)
    if (leg.foot >= 0 && object_name(m, mjOBJ_BODY, leg.foot).empty())
      nameless.push_back(foot_of(leg) + ", body " + std::to_string(leg.foot) + ",");
  if (!nameless.empty())
    out.push_back({"names", listed(nameless) + (nameless.size() > 1 ? " have no names" : " has no name") +
                                "; descriptions go by names, so give " + (nameless.size() > 1 ? "each one" : "it one")});
}

// --- what a description names

/// Looks names up, and keeps those that the model does not have.
class Names {
 public:
  explicit Names(const mjModel* m) : m_(m) {}

  int joint(const std::string& name) { return look_up(mjOBJ_JOINT, name, joints_); }
  int body(const std::string& name) { return look_up(mjOBJ_BODY, name, bodies_); }
  int site(const std::string& name) { return look_up(mjOBJ_SITE, name, sites_); }
  void add_missing(Reasons& out) const {
    add("joint", mjOBJ_JOINT, m_->njnt, joints_, out);
    add("body", mjOBJ_BODY, m_->nbody, bodies_, out);
    add("site", mjOBJ_SITE, m_->nsite, sites_, out);
  }

 private:
  int look_up(mjtObj type, const std::string& name, std::vector<std::string>& missing) {
    const int id = mj_name2id(m_, type, name.c_str());
    const std::string quoted = "'" + name + "'";
    if (id < 0 && std::find(missing.begin(), missing.end(), quoted) == missing.end()) missing.push_back(quoted);
    return id;
  }
  void add(const char* kind, mjtObj type, int count, const std::vector<std::string>& missing, Reasons& out) const {
    if (missing.empty()) return;
    std::vector<std::string> has;
    for (int i = 0; i < count; ++i) has.push_back(object_name(m_, type, i));
    out.push_back({"names", std::string("the model has no ") + kind + " named " + listed(missing) +
                                "; it has: " + (has.empty() ? "none" : listed(has))});
  }

  const mjModel* m_;
  std::vector<std::string> joints_, bodies_, sites_;
};

/// The description's robot by MuJoCo's numbers.
RobotParts parts_of(const mjModel* m, const RobotDescription& description, Names& names) {
  RobotParts robot;
  const int root = description.root_joint.empty() ? -1 : names.joint(description.root_joint);
  for (const Side side : kSides) {
    const Foot& foot = description.feet[side];
    LegParts leg{side == kLeft ? "left" : "right", names.body(foot.body), {}, Vec2(foot.length, foot.width)};
    if (!foot.sole_site.empty()) names.site(foot.sole_site);
    for (const std::string& joint : foot.leg_joints) leg.joints.push_back(names.joint(joint));
    if (root < 0 && robot.root_body < 0 && leg.foot >= 0) robot.root_body = m->body_rootid[leg.foot];
    robot.legs.push_back(std::move(leg));
  }
  if (root >= 0) robot.root_body = m->body_rootid[m->jnt_bodyid[root]];
  return robot;
}

/// The description's own words on base, start pose and limits.
void add_description(const mjModel* m, const RobotDescription& description, int root_body, Names& names, Reasons& out) {
  const int named = mj_name2id(m, mjOBJ_JOINT, description.root_joint.c_str()), root = free_joint_of(m, root_body);
  if (named >= 0 && root >= 0 && named != root)
    out.push_back({"base", "joint " + joint_label(m, named) + " is not a free joint, but a " + kind_of(m, named) +
                               "; the free joint of this robot's base is " + joint_label(m, root)});
  std::vector<std::string> valueless;
  if (root >= 0)
    for (const int j : tree_joints(m, root_body)) {
      const std::string name = object_name(m, mjOBJ_JOINT, j);
      if (!name.empty() && !description.stand_joints.count(name)) valueless.push_back("'" + name + "'");
    }
  if (!valueless.empty()) out.push_back({"stand", "the start pose has no value for joint " + listed(valueless)});
  for (const auto& [name, value] : description.stand_joints)
    if (!std::isfinite(value))
      out.push_back({"stand", "the start pose's value for joint '" + name + "' is not finite"});
  for (const auto& [name, limit] : description.torque_limits)
    if (!(limit > 0.0))
      out.push_back({"motor", "the torque limit of joint '" + name + "' is " + number(limit) +
                                  " N m; it must be greater than 0"});
  std::set<int> strangers;
  for (const auto* table : {&description.stand_joints, &description.torque_limits})
    for (const auto& entry : *table) {
      const int j = names.joint(entry.first);
      if (j >= 0 && (m->body_rootid[m->jnt_bodyid[j]] != root_body || j == root)) strangers.insert(j);
    }
  for (const int j : strangers)
    out.push_back({"names", "joint " + joint_label(m, j) +
                                " is none of this robot's; take it out of start pose and "
                                "torque limits"});
  if (!description.stand_base_pos.allFinite() || !(std::abs(description.stand_base_quat.norm() - 1.0) < 1e-3))
    out.push_back({"stand", "the start pose's base is not a position and a unit quaternion (w, x, y, z)"});
}

/// The rules about the tree: base, legs, soles, joints, and what acts on them.
void add_robot(const mjModel* m, const RobotParts& robot, const mjData* upright, Reasons& out) {
  if (free_joint_of(m, robot.root_body) < 0) add_base(m, robot.root_body, out);
  std::set<int> taken;
  for (std::size_t i = 0; i < robot.legs.size(); ++i) {
    const LegParts &leg = robot.legs[i], &other = robot.legs[robot.legs.size() - 1 - i];
    if (leg.foot < 0) continue;
    if (m->body_rootid[leg.foot] != robot.root_body) {
      out.push_back({"leg", foot_of(leg) + " " + label(m, mjOBJ_BODY, leg.foot) + " does not hang from the base " +
                                label(m, mjOBJ_BODY, robot.root_body)});
      continue;
    }
    add_leg(m, leg, other, taken, out);
    add_sole(m, leg, other, robot.root_body, out);
    if (upright && robot.forward.norm() > 0.0 && is_whole(m, leg)) add_axes(m, leg, robot.forward, upright, out);
  }
  add_joints(m, robot, taken, out);
  add_unmodelled(m, robot, out);
}

}  // namespace

int free_joint_of(const mjModel* m, int body) {
  if (body < 0) return -1;
  const int root = m->body_rootid[body];
  if (m->body_jntnum[root] == 0) return -1;
  const int joint = m->body_jntadr[root];
  return m->jnt_type[joint] == mjJNT_FREE ? joint : -1;
}

std::vector<int> ancestors(const mjModel* m, int body) {
  std::vector<int> chain;
  for (; body > 0; body = m->body_parentid[body]) chain.push_back(body);
  return chain;
}

std::vector<int> chain_joints(const mjModel* m, const RobotParts& robot) {
  std::set<int> joints;
  for (const LegParts& leg : robot.legs)
    for (const int body : ancestors(m, leg.foot))
      for (const int j : joints_of(m, body))
        if (m->jnt_type[j] != mjJNT_FREE) joints.insert(j);
  return {joints.begin(), joints.end()};
}

Reasons model_reasons(const mjModel* m) {
  Reasons out;
  const int tree = largest_tree(m);
  if (free_joint_of(m, tree) < 0) add_base(m, tree, out);
  add_world(m, out);
  return out;
}

Reasons model_reasons(const mjModel* m, const RobotParts& robot, const mjData* upright) {
  Reasons out;
  add_robot(m, robot, upright, out);
  add_world(m, out);
  return out;
}

Reasons model_reasons(const mjModel* m, const RobotDescription& description) {
  Reasons out, of_robot;
  Names names(m);
  const RobotParts robot = parts_of(m, description, names);
  if (robot.root_body > 0) {
    add_robot(m, robot, nullptr, of_robot);
    add_description(m, description, robot.root_body, names, of_robot);
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
