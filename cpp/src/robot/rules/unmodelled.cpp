#include "zmpwalk/robot/rules/unmodelled.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "zmpwalk/robot/actuation.hpp"
#include "zmpwalk/robot/mujoco_compat.hpp"
#include "zmpwalk/robot/words.hpp"

namespace zmpwalk {
namespace {

/// Largest error of a coupling at the start pose [rad or m].
constexpr double kCouplingTolerance = 1e-3;

/// Largest share of the weight that gravity compensation may carry. It pulls the bodies up, while the pendulum is planned with the whole weight.
constexpr double kMostCompensation = 0.3;

/// The robot in its model, as these rules ask for it.
struct Looked {
  Looked(const mjModel* model, const RobotParts& robot)
      : m(model), root_body(robot.root_body), chain(chain_joints(model, robot)) {
    for (const LegParts& leg : robot.legs) legs.insert(legs.end(), leg.joints.begin(), leg.joints.end());
  }
  bool owns(int body) const { return m->body_rootid[body] == root_body; }
  /// How sentences call a joint between base and foot.
  std::string called(int joint) const {
    const bool of_leg = std::find(legs.begin(), legs.end(), joint) != legs.end();
    return (of_leg ? "leg joint " : "waist joint ") + label(m, mjOBJ_JOINT, joint);
  }

  const mjModel* m;
  int root_body;
  std::vector<int> chain, legs;  // joints between base and feet; those of the legs
};

/// What a set of joints is to the robot.
struct Touch {
  bool robot = false, outside = false, base = false;
  int leg = -1;  // a joint below the base, or -1
};

Touch touch(const Looked& at, const std::vector<int>& joints) {
  Touch out;
  for (const int j : joints) {
    if (j < 0) continue;
    const bool mine = at.owns(at.m->jnt_bodyid[j]);
    (mine ? out.robot : out.outside) = true;
    if (mine && at.m->jnt_type[j] == mjJNT_FREE) out.base = true;
    if (std::find(at.chain.begin(), at.chain.end(), j) != at.chain.end()) out.leg = j;
  }
  return out;
}

/// The joints that an equality of two joints or of two tendons couples.
std::vector<int> coupled_joints(const mjModel* m, int equality) {
  const int first = m->eq_obj1id[equality], second = m->eq_obj2id[equality];
  if (m->eq_type[equality] == mjEQ_JOINT) return {first, second};
  std::vector<int> joints = tendon_joints(m, first);
  if (second >= 0)
    for (const int j : tendon_joints(m, second)) joints.push_back(j);
  return joints;
}

void add_tie(const Looked& at, int e, const std::string& name, Reasons& out) {
  const auto [one, two] = mujoco_compat::tied_bodies(at.m, e);
  if (at.owns(one) && at.owns(two))
    out.push_back({"equality", "closed loop: " + name + " ties body " + label(at.m, mjOBJ_BODY, one) + " to body " +
                                   label(at.m, mjOBJ_BODY, two) + "; zmpwalk needs a tree of joints"});
  else if (at.owns(one) || at.owns(two))
    out.push_back({"equality", name + " ties body " + label(at.m, mjOBJ_BODY, at.owns(one) ? one : two) +
                                   " to what is not the robot; remove it to walk"});
}

void add_equalities(const Looked& at, Reasons& out) {
  for (int e = 0; e < at.m->neq; ++e) {
    if (!mujoco_compat::is_active(at.m, e)) continue;
    const std::string name = "equality " + label(at.m, mjOBJ_EQUALITY, e);
    const int kind = at.m->eq_type[e];
    if (kind == mjEQ_CONNECT || kind == mjEQ_WELD) add_tie(at, e, name, out);
    if (kind != mjEQ_JOINT && kind != mjEQ_TENDON) continue;
    const Touch on = touch(at, coupled_joints(at.m, e));
    if (on.leg >= 0)
      out.push_back({"equality", name + " couples " + at.called(on.leg) + "; six free hinges are needed"});
    else if (on.robot && (on.outside || on.base))
      out.push_back({"equality", name + " couples the robot to what is not the robot; remove it to walk"});
  }
}

void add_tendons(const Looked& at, Reasons& out) {
  const mjModel* m = at.m;
  for (int t = 0; t < m->ntendon; ++t) {
    const Touch on = touch(at, tendon_joints(m, t));
    if (!on.robot) continue;
    const std::string name = "tendon " + label(m, mjOBJ_TENDON, t);
    const bool rubs = m->tendon_frictionloss[t] != 0.0, turns = mujoco_compat::tendon_armature(m, t) != 0.0;
    const bool pulls = m->tendon_stiffness[t] != 0.0 || m->tendon_damping[t] != 0.0 || m->tendon_limited[t] || rubs;
    if (pulls && (on.outside || on.base)) {
      out.push_back({"tendon", name + " pulls the robot to what is not the robot; remove it to walk"});
      continue;
    }
    if (rubs || turns)
      out.push_back({"tendon", name + " of the robot has " + (rubs ? "dry friction" : "armature") +
                                   ", which is not modelled; give it to the joints"});
    if (m->tendon_limited[t] && on.leg >= 0)
      out.push_back({"tendon", name + " limits " + at.called(on.leg) + "; give the joint a range instead"});
  }
}

/// What the actuator is to the robot, and why it cannot stay, or "".
std::pair<Touch, std::string> look_at_actuator(const Looked& at, int a) {
  const mjModel* m = at.m;
  const int kind = m->actuator_trntype[a], object = m->actuator_trnid[2 * a], second = m->actuator_trnid[2 * a + 1];
  Touch on;
  if (kind == mjTRN_JOINT || kind == mjTRN_JOINTINPARENT) {
    on = touch(at, {object});
    return {on, on.base ? "pushes the floating base; remove it: a robot walks by its joints" : ""};
  }
  if (kind == mjTRN_TENDON) {
    on = touch(at, tendon_joints(m, object));
    if (on.robot && (on.base || on.outside))
      return {on, "pulls the robot to what is not the robot through a tendon; remove it to walk"};
    return {on, on.leg < 0
                    ? ""
                    : "drives " + at.called(on.leg) + " through a tendon; each leg joint needs a motor of its own"};
  }
  const auto of_site = [&](int site) { return site >= 0 && at.owns(m->site_bodyid[site]); };
  on.robot = kind == mjTRN_BODY ? at.owns(object) : of_site(object) || of_site(second);
  const std::string by = kind == mjTRN_BODY ? "body" : kind == mjTRN_SLIDERCRANK ? "slider-crank" : "site";
  return {on, on.robot ? "acts on the robot through a " + by + ", which is not modelled; drive joints instead" : ""};
}

void add_actuators(const Looked& at, Reasons& out) {
  for (int a = 0; a < mujoco_compat::actuator_count(at.m); ++a) {
    const std::string name = "actuator " + label(at.m, mjOBJ_ACTUATOR, a);
    const auto [on, why] = look_at_actuator(at, a);
    if (!why.empty()) out.push_back({"actuator", name + " " + why});
    const std::string late = mujoco_compat::unforeseeable(at.m, a);
    if (on.robot && !late.empty())
      out.push_back({"actuator", name + " of the robot " + late + ", which is not modelled"});
  }
}

void add_bodies(const Looked& at, Reasons& out) {
  double lifted = 0.0;
  for (int body = 1; body < at.m->nbody; ++body) {
    if (!at.owns(body)) continue;
    lifted +=
        mujoco_compat::gravity_compensation(at.m, body) * at.m->body_mass[body] / at.m->body_subtreemass[at.root_body];
    const std::string what = mujoco_compat::unmodelled_on(at.m, body);
    if (!what.empty())
      out.push_back({"body", "body " + label(at.m, mjOBJ_BODY, body) + ": " + what + "; it is not modelled"});
  }
  if (std::abs(lifted) > kMostCompensation)
    out.push_back({"body", "gravity compensation (gravcomp) lifts " + number(100.0 * lifted) +
                               " % of the robot's weight; more than " + number(100.0 * kMostCompensation) +
                               " % leaves the feet too little to walk on"});
}

/// Error of a coupling, y - y0 - polynomial(x - x0), as MuJoCo couples two joints or tendons.
double coupling_error(const mjtNum* poly, double y, double x) {
  return y - (poly[0] + x * (poly[1] + x * (poly[2] + x * (poly[3] + x * poly[4]))));
}

/// How far the first of two coupled joints or tendons is from what the second asks of it at the pose in `d` [rad or m].
double coupling_error(const mjModel* m, const mjData* d, int equality) {
  const auto moved = [&](int id) {
    if (id < 0) return 0.0;
    if (m->eq_type[equality] == mjEQ_TENDON) return d->ten_length[id] - m->tendon_length0[id];
    return d->qpos[m->jnt_qposadr[id]] - m->qpos0[m->jnt_qposadr[id]];
  };
  return coupling_error(m->eq_data + mjNEQDATA * equality, moved(m->eq_obj1id[equality]),
                        moved(m->eq_obj2id[equality]));
}

}  // namespace

void add_unmodelled(const mjModel* m, const RobotParts& robot, Reasons& out) {
  const Looked at(m, robot);
  if (mjcb_passive)
    out.push_back({"callback", "a passive-force callback (mjcb_passive) is installed; its forces are not modelled"});
  add_bodies(at, out);
  add_equalities(at, out);
  add_tendons(at, out);
  add_actuators(at, out);
}

void add_uncoupled(const mjModel* m, int root_body, const mjData* d, Reasons& out) {
  const Looked at(m, {root_body, {}, Vec3::Zero()});
  const auto off_by = [](double error) { return number(std::abs(error)) + " off at the start pose"; };
  for (int e = 0; e < m->neq; ++e) {
    const int kind = m->eq_type[e], first = m->eq_obj1id[e];
    if (!mujoco_compat::is_active(m, e) || (kind != mjEQ_JOINT && kind != mjEQ_TENDON)) continue;
    if (!touch(at, kind == mjEQ_JOINT ? std::vector<int>{first} : tendon_joints(m, first)).robot) continue;
    const double error = coupling_error(m, d, e);
    if (std::abs(error) > kCouplingTolerance)
      out.push_back({"equality", "equality " + label(m, mjOBJ_EQUALITY, e) + " is " + off_by(error) +
                                     "; choose a pose that satisfies it"});
  }
  for (int t = 0; t < m->ntendon; ++t) {
    if (!m->tendon_limited[t] || !touch(at, tendon_joints(m, t)).robot) continue;
    const double length = d->ten_length[t];
    const double error = std::max(m->tendon_range[2 * t] - length, length - m->tendon_range[2 * t + 1]);
    if (error > kCouplingTolerance)
      out.push_back({"tendon", "the limit of tendon " + label(m, mjOBJ_TENDON, t) + " is " + off_by(error) +
                                   "; choose a pose that keeps it"});
  }
}

}  // namespace zmpwalk
