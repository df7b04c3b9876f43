#include "zmpwalk/simulation/push.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/robot/words.hpp"

namespace zmpwalk {

int trunk_body(const Robot& robot) {
  const mjModel* m = robot.model();
  for (int body = 1; body < m->nbody; ++body) {
    if (!robot.is_robot(body)) continue;
    std::string name = object_name(m, mjOBJ_BODY, body);
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    if (name.find("torso") != std::string::npos || name.find("trunk") != std::string::npos) return body;
  }
  return robot.root_body();
}

void Pushes::add(const Push& push) {
  const mjModel* m = robot_->model();
  if (!std::isfinite(push.t) || push.t < 0.0)
    throw InputError("a push begins at " + number(push.t) + " s; it must begin at a finite time of at least 0");
  if (!std::isfinite(push.duration) || push.duration < m->opt.timestep)
    throw InputError("a push lasts " + number(push.duration) +
                     " s; it must last a finite time of at least a timestep, " + number(m->opt.timestep) + " s");
  for (const double value : push.wrench)
    if (!std::isfinite(value))
      throw InputError("a force or torque of a push is " + number(value) + "; it must be finite");
  int body = trunk_body(*robot_);
  if (!push.body.empty()) {
    body = mj_name2id(m, mjOBJ_BODY, push.body.c_str());
    if (body <= 0 || !robot_->is_robot(body)) {
      std::vector<std::string> known;
      for (int b = 1; b < m->nbody; ++b)
        if (robot_->is_robot(b)) known.push_back(object_name(m, mjOBJ_BODY, b));
      throw InputError("a push is given to the body '" + push.body +
                       "', which the robot does not have; there are: " + listed(known, known.size()));
    }
  }
  pushes_.push_back({push, body});
}

void Pushes::apply(double t, mjData* d) const {
  const double half = 0.5 * robot_->timestep();
  for (const Acting& each : pushes_) std::fill_n(d->xfrc_applied + 6 * each.body, 6, 0.0);
  for (const auto& [push, body] : pushes_)
    if (t >= push.t - half && t < push.t + push.duration - half)
      for (int i = 0; i < 6; ++i) d->xfrc_applied[6 * body + i] += push.wrench[i];
}

}  // namespace zmpwalk
