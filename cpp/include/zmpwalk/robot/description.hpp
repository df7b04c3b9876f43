#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "zmpwalk/math/types.hpp"
#include "zmpwalk/robot/mujoco.hpp"

namespace zmpwalk {

/// One flat foot: the body it belongs to, its sole, and the joints of its leg from hip to ankle.
struct Foot {
  std::string body;                       ///< body that carries the sole
  std::string sole_site;                  ///< site at the sole's centre; may be empty
  Vec3 sole_pos = Vec3::Zero();           ///< sole centre in the body's frame, on the sole plane [m]
  Eigen::Vector4d sole_quat{1, 0, 0, 0};  ///< sole axes in the body's frame (w, x, y, z): x forward, z up
  double length = 0.0;                    ///< of the sole along its x [m]
  double width = 0.0;                     ///< of the sole along its y [m]
  std::vector<std::string> leg_joints;    ///< six joint names, hip to ankle
};

/// Everything that the controller has to be told about a robot in a model. Bodies, joints and sites are named, never numbered.
struct RobotDescription {
  std::string name;
  std::string root_joint;                       ///< the free joint; empty where the model does not name it
  std::array<Foot, 2> feet;                     ///< left, right
  std::map<std::string, double> stand_joints;   ///< start posture by joint name [rad or m]
  Vec3 stand_base_pos = Vec3::Zero();           ///< base position of the start pose, soles on z = 0 [m]
  Eigen::Vector4d stand_base_quat{1, 0, 0, 0};  ///< base orientation of the start pose (w, x, y, z)
  std::string stand_keyframe;                   ///< the keyframe the pose came from; may be empty
  std::map<std::string, double> torque_limits;  ///< by joint name, in place of the model's [N m]; may be empty

  /// Throws ModelError, with every reason of `model_reasons`, unless every name exists in `m` and the robot can walk. Changes nothing.
  void check(const Model& m) const;

  /// Number of the free joint: that of `root_joint`, or if this is empty, of the tree to which the left foot belongs. The names must be right.
  int free_joint(const Model& m) const;

  /// Puts the robot into its start pose, at rest, with flat soles at the height `ground` in W [m]. Without one they are where the description has them,
  /// or on the floor, where that is higher: in it, contacts would throw the robot out.
  ///
  /// Only the robot's own qpos and qvel change, so that it may be any tree of a scene. Then it calls mj_forward.
  /// @throws ModelError as check()
  void place(const Model& m, const Data& d, std::optional<double> ground = std::nullopt) const;
};

/// Throws InputError unless both mjData have the same layout, that is, come from the same model.
void require_same_model(const Data& of_model, const Data& d);

/// Description of a model that carries box sites `left_sole` and `right_sole` and a keyframe `stand`.
///
/// Body, sole frame and size come from the sites, legs from the tree between the feet and their common ancestor, the pose
/// from the keyframe.
/// @throws ModelError  names what is missing and what would have worked
RobotDescription describe(const Model& m);

}  // namespace zmpwalk
