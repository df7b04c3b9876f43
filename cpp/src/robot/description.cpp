#include "zmpwalk/robot/description.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <set>

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/robot/robot.hpp"
#include "zmpwalk/robot/unmodelled.hpp"

namespace zmpwalk {
namespace {

int find(const mjModel* m, mjtObj type, const std::string& name) { return mj_name2id(m, type, name.c_str()); }

/// The names of a kind that the model does have, for error messages.
std::string names(const mjModel* m, mjtObj type, int count) {
  std::string list;
  for (int i = 0; i < count && i < 12; ++i) list += (i ? ", " : "") + object_name(m, type, i);
  return count > 12 ? list + ", ..." : list.empty() ? "none" : list;
}

int require(const mjModel* m, mjtObj type, int count, const char* kind, const std::string& name) {
  const int id = find(m, type, name);
  if (id < 0)
    throw ModelError(std::string("the model has no ") + kind + " named '" + name +
                     "'; it has: " + names(m, type, count));
  return id;
}

/// Bodies from `body` up to the root of its tree, itself first.
std::vector<int> ancestors(const mjModel* m, int body) {
  std::vector<int> chain;
  for (; body > 0; body = m->body_parentid[body]) chain.push_back(body);
  return chain;
}

/// Free joint of the tree that `body` hangs in, or -1.
int free_joint_of(const mjModel* m, int body) {
  const int root = m->body_rootid[body];
  if (m->body_jntnum[root] == 0) return -1;
  const int joint = m->body_jntadr[root];
  return m->jnt_type[joint] == mjJNT_FREE ? joint : -1;
}

/// Joint names between the feet's common ancestor and `foot`, hip to ankle.
std::vector<std::string> leg_joints(const mjModel* m, int foot, int other_foot) {
  const std::vector<int> theirs = ancestors(m, other_foot);
  std::vector<std::string> joints;
  for (const int body : ancestors(m, foot)) {
    if (std::find(theirs.begin(), theirs.end(), body) != theirs.end()) break;
    for (int k = m->body_jntnum[body] - 1; k >= 0; --k)
      joints.push_back(object_name(m, mjOBJ_JOINT, m->body_jntadr[body] + k));
  }
  std::reverse(joints.begin(), joints.end());
  return joints;
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

// Smaller soles are point feet: shares of the leg, hip to ankle along its bones.
constexpr double kLeastLength = 0.1, kLeastWidth = 0.04;

}  // namespace

RobotDescription describe(const mjModel* m) {
  const std::array<std::string, 2> sites{"left_sole", "right_sole"};
  RobotDescription out;
  std::array<int, 2> bodies{};
  for (const Side side : kSides) {
    const int site = find(m, mjOBJ_SITE, sites[side]);
    if (site < 0)
      throw ModelError("the model has no site '" + sites[side] +
                       "' and so no known sole; add box sites left_sole and "
                       "right_sole on the sole planes, or pass a robot.json (it has sites: " +
                       names(m, mjOBJ_SITE, m->nsite) + ")");
    if (m->site_type[site] != mjGEOM_BOX)
      throw ModelError("site '" + sites[side] +
                       "' is not a box; the sole's length and width are read from its box size");
    Foot& foot = out.feet[side];
    bodies[side] = m->site_bodyid[site];
    foot.body = object_name(m, mjOBJ_BODY, bodies[side]);
    foot.sole_site = sites[side];
    for (int i = 0; i < 3; ++i) foot.sole_pos[i] = m->site_pos[3 * site + i];
    for (int i = 0; i < 4; ++i) foot.sole_quat[i] = m->site_quat[4 * site + i];
    foot.length = 2.0 * m->site_size[3 * site];
    foot.width = 2.0 * m->site_size[3 * site + 1];
  }
  const int root = free_joint_of(m, bodies[kLeft]);
  if (root < 0)
    throw ModelError("the feet hang from body '" + object_name(m, mjOBJ_BODY, m->body_rootid[bodies[kLeft]]) +
                     "', which has no free joint; a walking robot needs a floating base (<freejoint/>)");
  out.root_joint = object_name(m, mjOBJ_JOINT, root);
  out.name = object_name(m, mjOBJ_BODY, m->jnt_bodyid[root]);
  for (const Side side : kSides) out.feet[side].leg_joints = leg_joints(m, bodies[side], bodies[other(side)]);

  const int key = find(m, mjOBJ_KEY, "stand");
  if (key < 0)
    throw ModelError("the model has no keyframe 'stand'; add one with bent knees and flat feet, or pass a robot.json");
  out.stand_keyframe = "stand";
  const mjtNum* qpos = m->key_qpos + static_cast<long>(key) * m->nq;
  const mjtNum* base = qpos + m->jnt_qposadr[root];
  for (int i = 0; i < 3; ++i) out.stand_base_pos[i] = base[i];
  for (int i = 0; i < 4; ++i) out.stand_base_quat[i] = base[3 + i];
  const int root_body = m->jnt_bodyid[root];
  for (int j = 0; j < m->njnt; ++j)
    if (m->body_rootid[m->jnt_bodyid[j]] == root_body && j != root)
      out.stand_joints[object_name(m, mjOBJ_JOINT, j)] = qpos[m->jnt_qposadr[j]];
  out.check(m);
  return out;
}

int RobotDescription::free_joint(const mjModel* m) const {
  return root_joint.empty() ? free_joint_of(m, find(m, mjOBJ_BODY, feet[kLeft].body))
                            : find(m, mjOBJ_JOINT, root_joint);
}

void RobotDescription::check(const mjModel* m) const {
  if (root_joint.empty())
    require(m, mjOBJ_BODY, m->nbody, "body", feet[kLeft].body);
  else
    require(m, mjOBJ_JOINT, m->njnt, "joint", root_joint);
  const int root = free_joint(m);
  if (root < 0 || m->jnt_type[root] != mjJNT_FREE)
    throw ModelError("joint '" + root_joint +
                     "' is not a free joint; a walking robot needs a floating base (<freejoint/>)");
  const int root_body = m->jnt_bodyid[root];
  std::set<std::string> in_legs;
  RobotTree tree{root_body, {}};
  for (const Side side : kSides) {
    const Foot& foot = feet[side];
    const std::string which = side == kLeft ? "left" : "right";
    const int body = require(m, mjOBJ_BODY, m->nbody, "body", foot.body);
    if (m->body_rootid[body] != root_body)
      throw ModelError("the " + which + " foot '" + foot.body + "' does not hang from the free joint '" + root_joint +
                       "'");
    if (!foot.sole_site.empty()) require(m, mjOBJ_SITE, m->nsite, "site", foot.sole_site);
    if (!(foot.length > 0.0) || !(foot.width > 0.0))
      throw ModelError("the " + which + " sole is " + std::to_string(foot.length) + " x " + std::to_string(foot.width) +
                       " m; both must be greater than 0");
    if (foot.leg_joints.size() != 6)
      throw ModelError("the " + which + " leg has " + std::to_string(foot.leg_joints.size()) +
                       " joints between hip and foot; placing a flat foot anywhere takes 6");
    const std::vector<int> chain = ancestors(m, body);
    for (const int link : chain)
      for (int k = 0; k < m->body_jntnum[link]; ++k)
        if (m->body_jntadr[link] + k != root) tree.chain_joints.push_back(m->body_jntadr[link] + k);
    int previous = root;
    for (const std::string& leg_joint : foot.leg_joints) {
      const int joint = require(m, mjOBJ_JOINT, m->njnt, "joint", leg_joint);
      if (std::find(chain.begin(), chain.end(), m->jnt_bodyid[joint]) == chain.end())
        throw ModelError("joint '" + leg_joint + "' is listed for the " + which + " leg but does not move the foot '" +
                         foot.body + "'");
      if (!in_legs.insert(leg_joint).second)
        throw ModelError("joint '" + leg_joint + "' is listed twice among the leg joints");
      if (m->jnt_type[joint] != mjJNT_HINGE)
        throw ModelError("leg joint '" + leg_joint +
                         "' is no hinge; a leg is six hinges (write a ball joint as three)");
      if (joint < previous)
        throw ModelError("the " + which + " leg's joints are not listed from hip to ankle: '" + leg_joint +
                         "' comes before '" + object_name(m, mjOBJ_JOINT, previous) + "' in the model");
      previous = joint;
    }
    double bones = 0.0;  // hip to foot, along the bodies
    for (const int link : chain) {
      if (link == m->jnt_bodyid[require(m, mjOBJ_JOINT, m->njnt, "joint", foot.leg_joints.front())]) break;
      bones += Eigen::Map<const Vec3>(m->body_pos + 3 * link).norm();
    }
    if (foot.length < kLeastLength * bones || foot.width < kLeastWidth * bones)
      throw ModelError("point foot: the " + which + " sole is " + std::to_string(foot.length) + " x " +
                       std::to_string(foot.width) + " m, too small for a leg of " + std::to_string(bones) +
                       " m, which takes at least " + std::to_string(kLeastLength * bones) + " x " +
                       std::to_string(kLeastWidth * bones) + " m");
    if (!can_touch_ground(m, body, root_body))
      throw ModelError("the " + which + " foot '" + foot.body +
                       "' has no geom that can collide with anything but the robot; see contype and conaffinity");
  }
  for (int j = 0; j < m->njnt; ++j) {
    if (m->body_rootid[m->jnt_bodyid[j]] != root_body || j == root) continue;
    const std::string joint = object_name(m, mjOBJ_JOINT, j);
    if (joint.empty())
      throw ModelError("joint " + std::to_string(j) + " at body '" + object_name(m, mjOBJ_BODY, m->jnt_bodyid[j]) +
                       "' has no name; descriptions go by names, so give it one");
    if (m->jnt_type[j] != mjJNT_HINGE && m->jnt_type[j] != mjJNT_SLIDE)
      throw ModelError("joint '" + joint + "' is neither hinge nor slide; zmpwalk drives those only");
    const auto stand = stand_joints.find(joint);
    if (stand == stand_joints.end()) throw ModelError("the start pose has no value for joint '" + joint + "'");
    if (!std::isfinite(stand->second))
      throw ModelError("the start pose's value for joint '" + joint + "' is not finite");
  }
  for (const auto* table : {&stand_joints, &torque_limits})
    for (const auto& entry : *table) {
      const int j = require(m, mjOBJ_JOINT, m->njnt, "joint", entry.first);
      if (m->body_rootid[m->jnt_bodyid[j]] != root_body || j == root)
        throw ModelError("joint '" + entry.first + "' is none of this robot's");
    }
  require_modelled(m, tree);
  if (!stand_base_pos.allFinite() || !(std::abs(stand_base_quat.norm() - 1.0) < 1e-3))
    throw ModelError("the start pose's base is not a position and a unit quaternion (w, x, y, z)");
}

void require_same_model(const mjData* of_model, const mjData* d) {
  if (d->nbuffer != of_model->nbuffer)
    throw InputError("data was made for another model (" + std::to_string(d->nbuffer) +
                     " bytes of state, this model has " + std::to_string(of_model->nbuffer) +
                     "); use mujoco.MjData(model)");
}

void RobotDescription::place(const mjModel* m, mjData* d, double ground) const {
  check(m);
  require_same_model(MjDataPtr(mj_makeData(m)).get(), d);
  require_finite("ground", ground);
  const int root = free_joint(m);
  mjtNum* base = d->qpos + m->jnt_qposadr[root];
  for (int i = 0; i < 3; ++i) base[i] = stand_base_pos[i];
  base[2] += ground;
  for (int i = 0; i < 4; ++i) base[3 + i] = stand_base_quat[i];
  for (int i = 0; i < 6; ++i) d->qvel[m->jnt_dofadr[root] + i] = 0.0;
  for (const auto& [joint_name, value] : stand_joints) {
    const int joint = find(m, mjOBJ_JOINT, joint_name);
    d->qpos[m->jnt_qposadr[joint]] = value;
    d->qvel[m->jnt_dofadr[joint]] = 0.0;
  }
  mj_forward(m, d);
}

}  // namespace zmpwalk
