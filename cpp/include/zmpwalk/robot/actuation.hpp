#pragma once

#include <map>
#include <string>
#include <vector>

#include "zmpwalk/math/types.hpp"
#include "zmpwalk/robot/mujoco_types.hpp"

namespace zmpwalk {

/// How the torque of one joint reaches MuJoCo.
struct JointDrive {
  int control = -1;    ///< entry of ctrl that takes it, ctrl = tau / scale; -1: it goes through qfrc_applied
  double scale = 1.0;  ///< torque per unit of control, gear times gain [N m]
  double limit = 0.0;  ///< torque limit [N m]; infinity where nothing limits it
  std::string path;    ///< the same in words: "motor 'l_knee'", "qfrc_applied: position servo 'l_knee' is silenced"
};

/// Puts joint torques into an mjData, whatever drives the joints.
///
/// A joint with one plain torque motor (no dynamics, no bias, any gear and gain) takes ctrl = tau / (gear gain). The torque of any other
/// joint (with servos, several actuators, actuators with dynamics, tendons, or no actuator) goes through qfrc_applied, exactly. Its actuators are
/// set to give no force where a control can do that. What they still give, as MuJoCo's own mj_fwdActuation says and clipped as the model
/// clips it, is subtracted. So qfrc_actuator + qfrc_applied = tau at the state for which the torque was written.
class Actuation {
 public:
  /// @param joints  MuJoCo numbers of the robot's joints, hinges and slides, in the order of its dofs
  /// @param limits  torque limits by joint name that replace the model's [N m]; a motor still gives no more than the model lets through
  /// The rules for limits and ranges are checked by `model_reasons`, not here.
  Actuation(const mjModel* m, const std::vector<int>& joints, const std::map<std::string, double>& limits);

  const std::vector<JointDrive>& drives() const { return drives_; }

  /// Writes `tau` (joints,) [N m] for the state in `d`. `own` is another mjData of the same model with the robot's state, used as scratch memory.
  ///
  /// Only ctrl of the actuators that act on the robot changes, and qfrc_applied of the joints that are driven through it. Allocates nothing.
  void write(const ConstVecRef& tau, mjData* d, mjData* own) const;

 private:
  void silence(mjData* d, mjData* own) const;

  const mjModel* m_;
  std::vector<JointDrive> drives_;
  std::vector<int> dofs_;                       // of each joint
  std::vector<int> silenced_;                   // actuators
  bool subtracts_ = false;                      // something acts beside qfrc_applied
  int qpos0_ = 0, nq_ = 0, dof0_ = 0, nv_ = 0;  // of the robot's tree
};

/// The range, "ctrl" or "force", that does not contain zero, so that the actuator always pulls at the joint that it turns; nullptr where
/// both ranges contain it.
const char* range_without_rest(const mjModel* m, int actuator);

/// True where the actuator turns `joint` directly, not through a tendon.
bool turns_joint(const mjModel* m, int actuator, int joint);

/// Hinges and slides of the tree whose root body is `root`, in the order of their dofs.
std::vector<int> tree_joints(const mjModel* m, int root);

/// Joints whose positions the length of a tendon depends on: those that a fixed tendon names, or those between the sites and geoms of a spatial one.
std::vector<int> tendon_joints(const mjModel* m, int tendon);

}  // namespace zmpwalk
