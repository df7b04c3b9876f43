#include "zmpwalk/robot/description.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/robot/robot.hpp"
#include "zmpwalk/robot/rules/model_rules.hpp"
#include "zmpwalk/robot/tree.hpp"
#include "zmpwalk/robot/words.hpp"

namespace zmpwalk {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

int find(const Model& m, int type, const std::string& name) { return mj::name2id(m, type, name.c_str()); }

std::vector<std::string> names(const Model& m, int type, const std::vector<int>& ids) {
  std::vector<std::string> out;
  for (const int id : ids) out.push_back(object_name(m, type, id));
  return out;
}

/// Joints between the feet's common ancestor and `foot`, hip to ankle.
std::vector<int> leg_joints(const Model& m, int foot, int other_foot) {
  const std::vector<int> theirs = ancestors(m, other_foot);
  std::vector<int> joints;
  for (const int body : ancestors(m, foot)) {
    if (std::find(theirs.begin(), theirs.end(), body) != theirs.end()) break;
    for (int k = m.body_jntnum[body] - 1; k >= 0; --k) joints.push_back(m.body_jntadr[body] + k);
  }
  std::reverse(joints.begin(), joints.end());
  return joints;
}

/// The two box sites on the soles, left and right; -1 and a reason where there is none.
std::array<int, 2> sole_sites(const Model& m, Reasons& out) {
  std::array<int, 2> sites{};
  for (const Side side : kSides) {
    const std::string name = side == kLeft ? "left_sole" : "right_sole";
    sites[side] = find(m, mj::kSite, name);
    std::vector<int> all(m.nsite);
    std::iota(all.begin(), all.end(), 0);
    if (sites[side] < 0)
      out.push_back({"names", "the model has no site '" + name +
                                  "' and so no known sole; mark each sole with a box site of that name on its plane, "
                                  "or pass a robot.json (it has sites: " +
                                  (all.empty() ? "none" : listed(names(m, mj::kSite, all))) + ")"});
    else if (m.site_type[sites[side]] != mj::kBox)
      out.push_back(
          {"sole", "site '" + name + "' is not a box; the sole's length and width are read from its box size"});
  }
  return sites;
}

/// The robot that stands on two box sites.
RobotParts parts_on(const Model& m, const std::array<int, 2>& sites) {
  RobotParts robot;
  robot.root_body = m.body_rootid[m.site_bodyid[sites[kLeft]]];
  for (const Side side : kSides) {
    const int foot = m.site_bodyid[sites[side]];
    const double* size = m.site_size + 3 * sites[side];
    robot.legs.push_back({side == kLeft ? "left" : "right", foot,
                          leg_joints(m, foot, m.site_bodyid[sites[other(side)]]), Vec2(2.0 * size[0], 2.0 * size[1])});
  }
  return robot;
}

/// Body, sole frame and size, from a box site on the sole.
Foot foot_on(const Model& m, int site, const LegParts& leg) {
  Foot foot;
  foot.body = object_name(m, mj::kBody, leg.foot);
  foot.sole_site = object_name(m, mj::kSite, site);
  for (int i = 0; i < 3; ++i) foot.sole_pos[i] = m.site_pos[3 * site + i];
  for (int i = 0; i < 4; ++i) foot.sole_quat[i] = m.site_quat[4 * site + i];
  foot.length = leg.sole->x();
  foot.width = leg.sole->y();
  foot.leg_joints = names(m, mj::kJoint, leg.joints);
  return foot;
}

/// Name, base and start pose of the robot whose free joint is `root`, from the keyframe 'stand'.
void read_stand(const Model& m, int root, int key, RobotDescription& out) {
  out.root_joint = object_name(m, mj::kJoint, root);
  out.name = object_name(m, mj::kBody, m.jnt_bodyid[root]);
  out.stand_keyframe = object_name(m, mj::kKey, key);
  const double* qpos = m.key_qpos + static_cast<long>(key) * m.nq;
  const double* base = qpos + m.jnt_qposadr[root];
  for (int i = 0; i < 3; ++i) out.stand_base_pos[i] = base[i];
  for (int i = 0; i < 4; ++i) out.stand_base_quat[i] = base[3 + i];
  for (const int j : tree_joints(m, m.jnt_bodyid[root]))
    out.stand_joints[object_name(m, mj::kJoint, j)] = qpos[m.jnt_qposadr[j]];
}

/// How far the soles are in the floor, by the contacts of `d` [m]: MuJoCo puts a contact half way between the two surfaces.
double depth_in_floor(const Model& m, const Data& d, const RobotDescription& description) {
  constexpr double kLevel = 0.9;  // of a contact's normal that points up: others are walls
  double depth = 0.0;
  for (const Foot& foot : description.feet) {
    const int body = find(m, mj::kBody, foot.body);
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> R(d.xmat + 9 * body);
    const double sole = d.xpos[3 * body + 2] + R.row(2).dot(foot.sole_pos);
    double lowest = kInfinity;
    for (int i = 0; i < *d.ncon; ++i) {
      const zmpwalk_contact contact = mj::contact(d, i);
      if (contact.geom[0] < 0 || contact.geom[1] < 0 || std::abs(contact.frame[2]) < kLevel) continue;
      const int one = m.geom_bodyid[contact.geom[0]], two = m.geom_bodyid[contact.geom[1]];
      const bool floor = m.body_weldid[one] == 0 || m.body_weldid[two] == 0;
      if (floor && (contains(ancestors(m, one), body) || contains(ancestors(m, two), body)))
        lowest = std::min(lowest, contact.pos[2]);
    }
    if (std::isfinite(lowest)) depth = std::max(depth, 2.0 * (lowest - sole));
  }
  return depth;
}

}  // namespace

RobotDescription describe(const Model& m) {
  Reasons reasons;
  const std::array<int, 2> sites = sole_sites(m, reasons);
  RobotParts robot;
  if (reasons.empty()) reasons = model_reasons(m, robot = parts_on(m, sites));
  const int key = find(m, mj::kKey, "stand");
  if (key < 0)
    reasons.push_back({"stand",
                       "the model has no keyframe 'stand'; add one with bent knees and flat feet, or pass a "
                       "robot.json"});
  require_none(reasons);
  RobotDescription out;
  for (const Side side : kSides) out.feet[side] = foot_on(m, sites[side], robot.legs[side]);
  read_stand(m, free_joint_of(m, robot.root_body), key, out);
  out.check(m);
  return out;
}

int RobotDescription::free_joint(const Model& m) const {
  return root_joint.empty() ? free_joint_of(m, find(m, mj::kBody, feet[kLeft].body)) : find(m, mj::kJoint, root_joint);
}

void RobotDescription::check(const Model& m) const { require_none(model_reasons(m, *this)); }

void require_same_model(const Data& of_model, const Data& d) {
  if (d.size != of_model.size)
    throw InputError("data was made for another model (" + std::to_string(d.size) + " bytes of state, this model has " +
                     std::to_string(of_model.size) + "); use mujoco.MjData(model)");
}

void RobotDescription::place(const Model& m, const Data& d, std::optional<double> ground) const {
  check(m);
  require_same_model(OwnData(m), d);
  require_finite("ground", ground.value_or(0.0));
  const int root = free_joint(m);
  double* base = d.qpos + m.jnt_qposadr[root];
  for (int i = 0; i < 3; ++i) base[i] = stand_base_pos[i];
  base[2] += ground.value_or(0.0);
  for (int i = 0; i < 4; ++i) base[3 + i] = stand_base_quat[i];
  for (int i = 0; i < 6; ++i) d.qvel[m.jnt_dofadr[root] + i] = 0.0;
  for (const auto& [joint_name, value] : stand_joints) {
    const int joint = find(m, mj::kJoint, joint_name);
    d.qpos[m.jnt_qposadr[joint]] = value;
    d.qvel[m.jnt_dofadr[joint]] = 0.0;
  }
  mj::forward(m, d);
  constexpr double kRests = 1e-3;  // a robot that stands has sunk into the contact by about as much [m]
  const double depth = ground ? 0.0 : depth_in_floor(m, d, *this);
  if (depth < kRests) return;
  base[2] += depth;
  mj::forward(m, d);
}

}  // namespace zmpwalk
