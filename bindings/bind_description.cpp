#include "common.hpp"
#include "zmpwalk/robot/description.hpp"
#include "zmpwalk/robot/robot.hpp"
#include "zmpwalk/robot/rules/model_rules.hpp"
#include "zmpwalk/robot/tree.hpp"
#include "zmpwalk/robot/words.hpp"
#include "zmpwalk/settings/settings.hpp"
#include "zmpwalk/walk/proportions.hpp"

using namespace zmpwalk;

namespace {

/// (rule, sentence) pairs.
py::list pairs(const Reasons& reasons) {
  py::list out;
  for (const Reason& reason : reasons) out.append(py::make_tuple(reason.rule, reason.text));
  return out;
}

}  // namespace

void bind_description(py::module_& m) {
  py::class_<Foot>(m, "Foot", "One flat foot: body, sole frame and size, and the six joints of its leg, hip to ankle.")
      .def(py::init([](std::string body, std::string sole_site, const Vec3& sole_pos, const Eigen::Vector4d& sole_quat,
                       double length, double width, std::vector<std::string> leg_joints) {
             return Foot{std::move(body), std::move(sole_site), sole_pos, sole_quat, length,
                         width,           std::move(leg_joints)};
           }),
           py::kw_only(), "body"_a, "sole_site"_a = "", "sole_pos"_a, "sole_quat"_a = Eigen::Vector4d(1, 0, 0, 0),
           "length"_a, "width"_a, "leg_joints"_a)
      .def_readonly("body", &Foot::body, "body that carries the sole")
      .def_readonly("sole_site", &Foot::sole_site, "site at the sole's centre, or ''")
      .def_readonly("sole_pos", &Foot::sole_pos, "sole centre in the body's frame (3,) [m]")
      .def_readonly("sole_quat", &Foot::sole_quat, "sole axes in the body's frame (w, x, y, z)")
      .def_readonly("length", &Foot::length, "of the sole [m]")
      .def_readonly("width", &Foot::width, "of the sole [m]")
      .def_readonly("leg_joints", &Foot::leg_joints, "six joint names, hip to ankle")
      .def(py::pickle(
          [](const Foot& f) {
            return py::make_tuple(f.body, f.sole_site, f.sole_pos, f.sole_quat, f.length, f.width, f.leg_joints);
          },
          [](const py::tuple& s) {
            require_size("the state of a Foot", static_cast<long>(s.size()), 7);
            return Foot{s[0].cast<std::string>(),
                        s[1].cast<std::string>(),
                        s[2].cast<Vec3>(),
                        s[3].cast<Eigen::Vector4d>(),
                        s[4].cast<double>(),
                        s[5].cast<double>(),
                        s[6].cast<std::vector<std::string>>()};
          }));

  py::class_<RobotDescription>(
      m, "RobotDescription",
      "Everything that the controller has to be told about a robot in a model. Bodies, joints and sites are named.")
      .def(py::init([](std::string name, std::string root_joint, const Foot& left, const Foot& right,
                       std::map<std::string, double> stand_joints, const Vec3& stand_base_pos,
                       const Eigen::Vector4d& stand_base_quat, std::string stand_keyframe,
                       std::map<std::string, double> torque_limits) {
             RobotDescription d;
             d.name = std::move(name);
             d.root_joint = std::move(root_joint);
             d.feet = {left, right};
             d.stand_joints = std::move(stand_joints);
             d.stand_base_pos = stand_base_pos;
             d.stand_base_quat = stand_base_quat;
             d.stand_keyframe = std::move(stand_keyframe);
             d.torque_limits = std::move(torque_limits);
             return d;
           }),
           py::kw_only(), "name"_a, "root_joint"_a, "left"_a, "right"_a, "stand_joints"_a, "stand_base_pos"_a,
           "stand_base_quat"_a = Eigen::Vector4d(1, 0, 0, 0), "stand_keyframe"_a = "",
           "torque_limits"_a = std::map<std::string, double>())
      .def_readonly("name", &RobotDescription::name, "what the robot is called in figures and traces")
      .def_readonly("root_joint", &RobotDescription::root_joint,
                    "the free joint; empty where the model does not name it")
      .def_property_readonly(
          "left", [](const RobotDescription& d) { return d.feet[kLeft]; }, "the left foot, a `Foot`")
      .def_property_readonly(
          "right", [](const RobotDescription& d) { return d.feet[kRight]; }, "the right foot, a `Foot`")
      .def_readonly("stand_joints", &RobotDescription::stand_joints, "start posture by joint name [rad or m]")
      .def_readonly("stand_base_pos", &RobotDescription::stand_base_pos, "base position, soles on z = 0 (3,) [m]")
      .def_readonly("stand_base_quat", &RobotDescription::stand_base_quat, "base orientation (w, x, y, z)")
      .def_readonly("stand_keyframe", &RobotDescription::stand_keyframe,
                    "keyframe of the model that the start posture was read from; empty where it was given in numbers")
      .def_readonly("torque_limits", &RobotDescription::torque_limits, "by joint name, in place of the model's [N m]")
      .def(py::pickle(
          [](const RobotDescription& d) {
            return py::make_tuple(d.name, d.root_joint, d.feet[kLeft], d.feet[kRight], d.stand_joints, d.stand_base_pos,
                                  d.stand_base_quat, d.stand_keyframe, d.torque_limits);
          },
          [](const py::tuple& s) {
            require_size("the state of a RobotDescription", static_cast<long>(s.size()), 9);
            RobotDescription d;
            d.name = s[0].cast<std::string>();
            d.root_joint = s[1].cast<std::string>();
            d.feet = {s[2].cast<Foot>(), s[3].cast<Foot>()};
            d.stand_joints = s[4].cast<std::map<std::string, double>>();
            d.stand_base_pos = s[5].cast<Vec3>();
            d.stand_base_quat = s[6].cast<Eigen::Vector4d>();
            d.stand_keyframe = s[7].cast<std::string>();
            d.torque_limits = s[8].cast<std::map<std::string, double>>();
            return d;
          }))
      .def(
          "check", [](const RobotDescription& d, const py::object& model) { d.check(model_of(model)); }, "model"_a,
          "Raises ModelError unless this robot is in `model` and can walk.")
      .def(
          "drives",
          [](const RobotDescription& d, const py::object& model) {
            const Model mujoco = model_of(model);
            d.check(mujoco);
            const std::vector<int> joints = tree_joints(mujoco, mujoco.jnt_bodyid[d.free_joint(mujoco)]);
            const Actuation actuation(mujoco, joints, d.torque_limits);
            py::dict out;
            for (std::size_t j = 0; j < joints.size(); ++j)
              out[py::str(object_name(mujoco, mj::kJoint, joints[j]))] =
                  py::make_tuple(actuation.drives()[j].limit, actuation.drives()[j].path);
            return out;
          },
          "model"_a,
          "By joint name: torque limit [N m], infinite without, and the way that the torque takes into MuJoCo (see "
          "WalkingController.torque_path).\n\n"
          "Raises:\n    ModelError: as check().")
      .def(
          "stand_ahead",
          [](const RobotDescription& d, const py::object& model) {
            const Robot robot(model_of(model), d);
            const WalkSettings settings = resolve(WalkSettings{}, scale_of(robot), 0.0);
            const double share = settings.zmp.sole_fraction;
            return place_with_room(
                {bounds_of(robot, kLeft, settings, share), bounds_of(robot, kRight, settings, share)},
                common_sole(robot).length, 0.0);
          },
          "model"_a,
          "How far ahead of the middle between the soles' centres the COM stands with the default settings, so that "
          "the "
          "ZMP has room ahead and behind [m]; 0 where the soles alone bound it.\n\n"
          "Raises:\n    ModelError: as check().\n    InputError: soles and ankles leave no room for the ZMP.")
      .def(
          "place",
          [](const RobotDescription& d, const py::object& model, const py::object& data, std::optional<double> ground) {
            d.place(model_of(model), data_of(data), ground);
          },
          "model"_a, "data"_a, "ground"_a = std::nullopt,
          "Puts the robot into its start pose, at rest; only its own qpos and qvel change.\n\n"
          "Args:\n    ground: height of the soles [m]; None has them where the description does (z = 0), or on the "
          "floor "
          "where that is higher.\n\n"
          "Raises:\n    ModelError: as check().");

  py::class_<LegParts>(m, "LegParts", "A leg by MuJoCo's numbers: its foot's body, and its joints from hip to ankle.")
      .def(py::init([](int foot, std::vector<int> joints, std::string side, std::optional<Vec2> sole) {
             return LegParts{std::move(side), foot, std::move(joints), sole};
           }),
           py::kw_only(), "foot"_a, "joints"_a, "side"_a = "", "sole"_a = std::nullopt)
      .def_readonly("side", &LegParts::side, "'left', 'right', or '' where it is not known yet")
      .def_readonly("foot", &LegParts::foot, "body that carries the sole")
      .def_readonly("joints", &LegParts::joints, "joints, hip to ankle")
      .def_readonly("sole", &LegParts::sole,
                    "length and width of the sole (2,) [m], or None where they are not known yet");

  py::class_<RobotParts>(m, "RobotParts", "A robot by MuJoCo's numbers: what the rules about its tree look at.")
      .def(py::init([](int root_body, std::vector<LegParts> legs, const Vec3& forward) {
             return RobotParts{root_body, std::move(legs), forward};
           }),
           py::kw_only(), "root_body"_a, "legs"_a, "forward"_a = Vec3(Vec3::Zero()))
      .def_readonly("root_body", &RobotParts::root_body, "outermost body of its tree")
      .def_readonly("legs", &RobotParts::legs, "two LegParts")
      .def_readonly("forward", &RobotParts::forward, "its level direction (3,), world; zero where it is not known yet");

  m.def(
      "model_reasons",
      [](const py::object& model, const std::optional<RobotDescription>& description) {
        const Model of = model_of(model);
        return pairs(description ? model_reasons(of, *description) : model_reasons(of));
      },
      "model"_a, "description"_a = std::nullopt,
      "Every reason why a robot cannot walk, as (rule, sentence) pairs; the list is empty where it can.\n\n"
      "Args:\n    description: the robot to look at; None looks at the world alone: gravity, time step, contacts, and "
      "a tree with most of the joints that is fixed to the world.");
  m.def(
      "model_reasons",
      [](const py::object& model, const RobotParts& robot, const py::object& upright) {
        std::optional<Data> level;
        if (!upright.is_none()) level = data_of(upright);
        return pairs(model_reasons(model_of(model), robot, level));
      },
      "model"_a, "robot"_a, "upright"_a = py::none(),
      "The same for a robot that has no description yet.\n\n"
      "Args:\n    upright: data with the robot on level feet, after mj_kinematics and mj_comPos; with it, and with the "
      "robot's forward direction, the directions of the legs' axes are looked at too.");

  m.def(
      "describe", [](const py::object& model) { return describe(model_of(model)); }, "model"_a,
      "Description of a model with box sites left_sole, right_sole and a keyframe stand.\n\nRaises:\n    ModelError: "
      "says what is missing.");
}
