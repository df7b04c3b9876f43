#include "zmpwalk/robot/unmodelled.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/robot/actuation.hpp"
#include "zmpwalk/robot/mujoco_compat.hpp"
#include "zmpwalk/robot/robot.hpp"

namespace zmpwalk {
namespace {

/// By how much a coupling may be off at the start pose [rad or m].
constexpr double kCouplingTolerance = 1e-3;

/// Share of the weight that gravity compensation, which pulls the bodies up, may take: the pendulum is planned with all of it.
constexpr double kMostCompensation = 0.3;

std::string label(const mjModel* m, mjtObj type, int id) {
  const std::string name = object_name(m, type, id);
  return "'" + (name.empty() ? std::to_string(id) : name) + "'";
}

bool is_robot(const mjModel* m, const RobotTree& robot, int body) { return m->body_rootid[body] == robot.root_body; }

/// What a set of joints is to the robot.
struct Touch {
  bool robot = false, outside = false, base = false;
  int leg = -1;  // a joint below the base, or -1
};

Touch touch(const mjModel* m, const RobotTree& robot, const std::vector<int>& joints) {
  Touch out;
  for (const int j : joints) {
    if (j < 0) continue;
    const bool mine = is_robot(m, robot, m->jnt_bodyid[j]);
    (mine ? out.robot : out.outside) = true;
    if (mine && m->jnt_type[j] == mjJNT_FREE) out.base = true;
    if (std::find(robot.chain_joints.begin(), robot.chain_joints.end(), j) != robot.chain_joints.end()) out.leg = j;
  }
  return out;
}

std::string leg_joint(const mjModel* m, int joint) { return "leg joint " + label(m, mjOBJ_JOINT, joint); }

void check_world(const mjModel* m) {
  const mjtNum* g = m->opt.gravity;
  if ((m->opt.disableflags & mjDSBL_GRAVITY) || !(g[2] < 0.0) || std::hypot(g[0], g[1]) > 1e-6 * std::abs(g[2]))
    throw ModelError("gravity is (" + std::to_string(g[0]) + ", " + std::to_string(g[1]) + ", " + std::to_string(g[2]) +
                     ") m/s^2" + (m->opt.disableflags & mjDSBL_GRAVITY ? " and switched off" : "") +
                     "; zmpwalk walks where it points down along z");
  if (!(m->opt.timestep > 0.0) || !std::isfinite(m->opt.timestep))
    throw ModelError("the model's time step is " + std::to_string(m->opt.timestep) + " s; it must be greater than 0");
  if (mjcb_passive)
    throw ModelError("a passive-force callback (mjcb_passive) is installed; its forces are not modelled");
}

void check_equalities(const mjModel* m, const RobotTree& robot) {
  for (int e = 0; e < m->neq; ++e) {
    if (!mujoco_compat::is_active(m, e)) continue;
    const std::string name = "equality " + label(m, mjOBJ_EQUALITY, e);
    const int kind = m->eq_type[e], first = m->eq_obj1id[e], second = m->eq_obj2id[e];
    if (kind == mjEQ_CONNECT || kind == mjEQ_WELD) {
      const auto [one, two] = mujoco_compat::tied_bodies(m, e);
      if (is_robot(m, robot, one) && is_robot(m, robot, two))
        throw ModelError("closed loop: " + name + " ties body " + label(m, mjOBJ_BODY, one) + " to body " +
                         label(m, mjOBJ_BODY, two) + "; zmpwalk needs a tree of joints");
      if (is_robot(m, robot, one) || is_robot(m, robot, two))
        throw ModelError(name + " ties body " + label(m, mjOBJ_BODY, is_robot(m, robot, one) ? one : two) +
                         " to what is not the robot; remove it to walk");
    } else if (kind == mjEQ_JOINT || kind == mjEQ_TENDON) {
      std::vector<int> joints{first, second};
      if (kind == mjEQ_TENDON) {
        joints = tendon_joints(m, first);
        if (second >= 0)
          for (const int j : tendon_joints(m, second)) joints.push_back(j);
      }
      const Touch on = touch(m, robot, joints);
      if (on.leg >= 0) throw ModelError(name + " couples " + leg_joint(m, on.leg) + "; six free hinges are needed");
      if (on.robot && (on.outside || on.base))
        throw ModelError(name + " couples the robot to what is not the robot; remove it to walk");
    }
  }
}

void check_tendons(const mjModel* m, const RobotTree& robot) {
  for (int t = 0; t < m->ntendon; ++t) {
    const Touch on = touch(m, robot, tendon_joints(m, t));
    if (!on.robot) continue;
    const std::string name = "tendon " + label(m, mjOBJ_TENDON, t);
    const bool pulls = m->tendon_stiffness[t] != 0.0 || m->tendon_damping[t] != 0.0 || m->tendon_limited[t] ||
                       m->tendon_frictionloss[t] != 0.0;
    if (pulls && (on.outside || on.base))
      throw ModelError(name + " pulls the robot to what is not the robot; remove it to walk");
    if (m->tendon_frictionloss[t] != 0.0 || mujoco_compat::tendon_armature(m, t) != 0.0)
      throw ModelError(name + " of the robot has " + (m->tendon_frictionloss[t] != 0.0 ? "dry friction" : "armature") +
                       ", which is not modelled; give it to the joints");
    if (m->tendon_limited[t] && on.leg >= 0)
      throw ModelError(name + " limits " + leg_joint(m, on.leg) + "; give the joint a range instead");
  }
}

void check_actuators(const mjModel* m, const RobotTree& robot) {
  for (int a = 0; a < mujoco_compat::actuator_count(m); ++a) {
    const int kind = m->actuator_trntype[a], object = m->actuator_trnid[2 * a];
    const std::string name = "actuator " + label(m, mjOBJ_ACTUATOR, a);
    Touch on;
    if (kind == mjTRN_JOINT || kind == mjTRN_JOINTINPARENT) {
      on = touch(m, robot, {object});
      if (on.base) throw ModelError(name + " pushes the floating base; remove it: a robot walks by its joints");
    } else if (kind == mjTRN_TENDON) {
      on = touch(m, robot, tendon_joints(m, object));
      if (on.robot && (on.base || on.outside))
        throw ModelError(name + " pulls the robot to what is not the robot through a tendon; remove it to walk");
      if (on.leg >= 0)
        throw ModelError(name + " drives " + leg_joint(m, on.leg) +
                         " through a tendon; each leg joint needs a motor of its own");
    } else {
      const int second = m->actuator_trnid[2 * a + 1];
      const auto of_site = [&](int site) { return site >= 0 && is_robot(m, robot, m->site_bodyid[site]); };
      on.robot = kind == mjTRN_BODY ? is_robot(m, robot, object) : of_site(object) || of_site(second);
      if (on.robot)
        throw ModelError(name + " acts on the robot through a " +
                         (kind == mjTRN_BODY          ? "body"
                          : kind == mjTRN_SLIDERCRANK ? "slider-crank"
                                                      : "site") +
                         ", which is not modelled; drive joints instead");
    }
    const std::string why = mujoco_compat::unforeseeable(m, a);
    if (on.robot && !why.empty()) throw ModelError(name + " of the robot " + why + ", which is not modelled");
  }
}

/// Off by: y - y0 - polynomial(x - x0), as MuJoCo couples two joints or tendons.
double coupling_error(const mjtNum* poly, double y, double x) {
  return y - (poly[0] + x * (poly[1] + x * (poly[2] + x * (poly[3] + x * poly[4]))));
}

}  // namespace

void require_modelled(const mjModel* m, const RobotTree& robot) {
  check_world(m);
  double lifted = 0.0;
  for (int body = 1; body < m->nbody; ++body) {
    if (!is_robot(m, robot, body)) continue;
    lifted += mujoco_compat::gravity_compensation(m, body) * m->body_mass[body] / m->body_subtreemass[robot.root_body];
    const std::string what = mujoco_compat::unmodelled_on(m, body);
    if (!what.empty()) throw ModelError("body " + label(m, mjOBJ_BODY, body) + ": " + what + "; it is not modelled");
  }
  if (std::abs(lifted) > kMostCompensation)
    throw ModelError("gravity compensation (gravcomp) lifts " + std::to_string(100.0 * lifted) +
                     " % of the robot's weight; more than " + std::to_string(100.0 * kMostCompensation) +
                     " % is no walk on feet");
  check_equalities(m, robot);
  check_tendons(m, robot);
  check_actuators(m, robot);
}

void require_coupled_stand(const mjModel* m, const RobotTree& robot, const mjData* d) {
  const auto off_by = [](double error) { return std::to_string(std::abs(error)) + " off at the start pose"; };
  for (int e = 0; e < m->neq; ++e) {
    const int kind = m->eq_type[e], first = m->eq_obj1id[e], second = m->eq_obj2id[e];
    if (!mujoco_compat::is_active(m, e) || (kind != mjEQ_JOINT && kind != mjEQ_TENDON)) continue;
    const bool joints = kind == mjEQ_JOINT;
    if (!touch(m, robot, joints ? std::vector<int>{first} : tendon_joints(m, first)).robot) continue;
    const auto moved = [&](int id) {
      if (id < 0) return 0.0;
      const int q = joints ? m->jnt_qposadr[id] : 0;
      return joints ? d->qpos[q] - m->qpos0[q] : d->ten_length[id] - m->tendon_length0[id];
    };
    const double error = coupling_error(m->eq_data + mjNEQDATA * e, moved(first), moved(second));
    if (std::abs(error) > kCouplingTolerance)
      throw ModelError("equality " + label(m, mjOBJ_EQUALITY, e) + " is " + off_by(error) +
                       "; choose a pose that satisfies it");
  }
  for (int t = 0; t < m->ntendon; ++t) {
    if (!m->tendon_limited[t] || !touch(m, robot, tendon_joints(m, t)).robot) continue;
    const double length = d->ten_length[t];
    const double error = std::max(m->tendon_range[2 * t] - length, length - m->tendon_range[2 * t + 1]);
    if (error > kCouplingTolerance)
      throw ModelError("the limit of tendon " + label(m, mjOBJ_TENDON, t) + " is " + off_by(error));
  }
}

}  // namespace zmpwalk
