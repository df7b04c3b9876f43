#include "zmpwalk/robot/rules/leg_rules.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "zmpwalk/robot/tree.hpp"
#include "zmpwalk/robot/words.hpp"

namespace zmpwalk {
namespace {

// A sole that is smaller than these shares of the leg (from hip to foot along its bones) is a point foot.
constexpr double kLeastLength = 0.1, kLeastWidth = 0.04;

/// A joint pitches the foot where its axis has at least this much along the robot's left, and rolls it where along its forward.
constexpr double kAlong = 0.5;

std::string leg_of(const LegParts& leg) { return "the " + leg.side + (leg.side.empty() ? "leg" : " leg"); }
std::string sole_of(const LegParts& leg) { return "the " + leg.side + (leg.side.empty() ? "sole" : " sole"); }

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

/// Hip to foot along the bodies, from the outermost joint of the leg [m]; 0 where the other foot does not tell legs from trunk.
double bones(const mjModel* m, const LegParts& leg, const LegParts& other) {
  if (other.foot < 0) return 0.0;
  double length = 0.0, below_joint = 0.0;
  for (const int body : leg_bodies(m, leg, other)) {
    if (m->body_jntnum[body] > 0) below_joint = length;
    length += Eigen::Map<const Vec3>(m->body_pos + 3 * body).norm();
  }
  return below_joint;
}

/// Says where the joints may be that a leg lacks: above the foot, where the description lists them for no leg, or below the body of the sole.
std::string lacking(const mjModel* m, const LegParts& leg, const LegParts& other) {
  if (other.foot < 0) return "";
  std::vector<int> above;
  for (const int body : leg_bodies(m, leg, other))
    for (const int j : joints_of(m, body))
      if (!contains(leg.joints, j) && m->jnt_type[j] != mjJNT_FREE) above.push_back(j);
  std::reverse(above.begin(), above.end());
  if (!above.empty()) return "; of the joints that move this foot these are not listed: " + joint_labels(m, above);
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
         joint_labels(m, below) + ": if the ankle goes on there, the sole's geoms and site belong to " +
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
      out.push_back({"leg", "joint " + label(m, mjOBJ_JOINT, joint) + " is listed twice among the leg joints"});
    if (m->jnt_type[joint] != mjJNT_HINGE)
      out.push_back({"leg", "leg joint " + label(m, mjOBJ_JOINT, joint) + " is a " + joint_kind(m, joint) +
                                " joint; a leg is six hinges (write a ball joint as three)"});
    if (ordered && joint < previous)
      out.push_back({"leg", leg_of(leg) +
                                "'s joints are not listed from hip to ankle: " + label(m, mjOBJ_JOINT, joint) +
                                " comes before " + label(m, mjOBJ_JOINT, previous) + " in the model"});
    ordered = ordered && joint >= previous;
    previous = joint;
  }
  if (leg.joints.size() != 6)
    out.push_back({"leg", leg_of(leg) + " that ends at " + body_label(m, leg.foot) + " has " +
                              std::to_string(leg.joints.size()) + " joints (" + joint_labels(m, leg.joints) +
                              "); placing a flat foot anywhere takes 6: hip 3, knee 1, ankle 2" +
                              (leg.joints.size() < 6 ? lacking(m, leg, other) : "")});
  if (!strangers.empty())
    out.push_back({"leg", leg_of(leg) + " lists joints that do not move its foot " + label(m, mjOBJ_BODY, leg.foot) +
                              ": " + joint_labels(m, strangers)});
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
  const std::string who = leg_of(leg) + " (" + joint_labels(m, leg.joints) + ")";
  add_leg_axes(who, axes, forward, Vec3::UnitZ().cross(forward), out);
}

/// The leg has all its parts in the model, and six hinges.
bool is_whole(const mjModel* m, const LegParts& leg) {
  const auto is_hinge = [&](int j) { return j >= 0 && m->jnt_type[j] == mjJNT_HINGE; };
  return leg.foot >= 0 && leg.joints.size() == 6 && std::all_of(leg.joints.begin(), leg.joints.end(), is_hinge);
}

}  // namespace

std::string foot_of(const LegParts& leg) { return "the " + leg.side + (leg.side.empty() ? "foot" : " foot"); }

void add_leg_axes(const std::string& leg, const LegAxes& axes, const Vec3& forward, const Vec3& left, Reasons& out) {
  const Eigen::Array<double, 1, 6> pitch = (left.transpose() * axes).array().abs(),
                                   roll = (forward.transpose() * axes).array().abs();
  if (!(pitch[3] > kAlong) || !(pitch.head<3>().maxCoeff() > kAlong))
    out.push_back({"leg axes", leg +
                                   " is not hip 3 joints, knee, ankle 2: the fourth must bend the knee, and one of the "
                                   "first three pitch the hip"});
  for (const auto& [what, turns] : {std::make_pair("pitch", pitch), std::make_pair("roll", roll)})
    if (!(turns.tail<2>().maxCoeff() > kAlong))
      out.push_back({"leg axes", leg + " has no ankle " + what + ": the last two joints must pitch and roll the foot"});
}

void add_legs(const mjModel* m, const RobotParts& robot, const mjData* upright, std::set<int>& taken, Reasons& out) {
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
}

}  // namespace zmpwalk
