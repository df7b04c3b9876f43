#pragma once

#include "zmpwalk/control/task.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/robot/robot.hpp"

namespace zmpwalk {

/// Finds frames and joints of a robot by name, for tasks that are added to its walk.
class NamesOfRobot : public RobotNames {
 public:
  explicit NamesOfRobot(Robot& robot) : robot_(robot) {}

  int frame(const std::string& name) override { return robot_.watch(name); }

  int joint(const std::string& name) override {
    std::string known;
    for (int j = 0; j < robot_.joints(); ++j) {
      if (robot_.joint_names()[j] == name) {
        if (!robot_.is_leg_joint(j)) return j;
        throw InputError("the task moves '" + name + "', a joint of a leg: the walk moves those");
      }
      if (!robot_.is_leg_joint(j)) known += (known.empty() ? "" : ", ") + robot_.joint_names()[j];
    }
    throw InputError("the task moves '" + name + "', which this robot does not have; there are: " + known);
  }

  std::pair<double, double> joint_range(int joint) override { return robot_.joint_range(joint); }

  const Dynamics& dynamics() const override { return robot_.dynamics(); }

 private:
  Robot& robot_;
};

}  // namespace zmpwalk
