#include "common.hpp"
#include "zmpwalk/robot/robot.hpp"

using namespace zmpwalk;

namespace {

/// A Robot together with the Python model it points into.
struct PyRobot {
  PyRobot(const py::object& m, const RobotDescription& description) : model(m), robot(model_of(m), description) {}
  py::object model;
  Robot robot;
};

template <class Member>
auto array(Member Dynamics::* member, const char* name) {
  return std::make_pair(py::cpp_function([member](const Dynamics& d) -> const Member& { return d.*member; },
                                         py::return_value_policy::reference_internal),
                        py::cpp_function([member, name](Dynamics& d, const Member& value) {
                          require_shape(name, value.rows(), value.cols(), (d.*member).rows(), (d.*member).cols());
                          d.*member = value;
                          if constexpr (std::is_same_v<Member, RowMatX>)  // A: a matrix of one's own may have no zeros
                            d.A_sparsity = Sparsity(d.nv());
                        }));
}

}  // namespace

py::dict torque_path(const Robot& robot) {
  py::dict out;
  for (int j = 0; j < robot.joints(); ++j) out[py::str(robot.joint_names()[j])] = robot.drives()[j].path;
  return out;
}

void bind_dynamics(py::module_& m) {
  py::class_<FrameState>(m, "FrameState",
                         "A frame on the robot, such as a sole's: origin at its centre, x forward, z up. World axes.")
      .def_readwrite("p_WF", &FrameState::p_WF, "position (3,) [m]")
      .def_readwrite("R_WF", &FrameState::R_WF, "rotation (3, 3)")
      .def_readwrite("velocity", &FrameState::velocity, "linear, angular (6,) = J dq")
      .def_property(
          "J", [](const FrameState& s) -> const Mat6X& { return s.J; },
          [](FrameState& s, const Mat6X& J) {
            require_shape("J", J.rows(), J.cols(), s.J.rows(), s.J.cols());
            s.J = J;
          },
          "(6, nv), linear rows first")
      .def_readwrite("drift", &FrameState::drift, "Jdot dq (6,)");

  py::class_<Dynamics> dynamics(
      m, "Dynamics",
      "All that equations 1-15 need to know of a robot at one instant; plain arrays, no simulator.\n\n"
      "A ddq + b + g + J_c' f_c = S' tau, f_c the wrench of the robot on the ground.");
  dynamics.def(py::init<int>(), "nv"_a)
      .def_property_readonly("nv", &Dynamics::nv, "velocities: 6 of the base, and one of each joint")
      .def_property_readonly("joints", &Dynamics::joints, "joints, nv - 6");
  dynamics.def_readwrite("mass", &Dynamics::mass, "[kg]");
#define ARRAY(name, doc)                                   \
  {                                                        \
    const auto [get, set] = array(&Dynamics::name, #name); \
    dynamics.def_property(#name, get, set, doc);           \
  }
  ARRAY(gravity, "acceleration of gravity (3,) [m/s^2]")
  ARRAY(q, "joint positions (joints,)")
  ARRAY(dq, "velocities (nv,)")
  ARRAY(A, "inertia (nv, nv), row-major view")
  ARRAY(b, "velocity terms and passive forces (nv,)")
  ARRAY(g, "gravity (nv,)")
  ARRAY(com, "(3,) [m]")
  ARRAY(dcom, "(3,) [m/s]")
  ARRAY(J_com, "(3, nv)")
  ARRAY(drift_com, "Jdot dq of the COM (3,)")
  ARRAY(p_WB, "base position (3,)")
  ARRAY(R_WB, "base rotation (3, 3)")
  ARRAY(omega_WB, "base angular velocity, world axes (3,)")
#undef ARRAY
  dynamics.def_property_readonly(
      "left", [](Dynamics& d) -> FrameState& { return d.sole[kLeft]; }, py::return_value_policy::reference_internal,
      "left sole");
  dynamics.def_property_readonly(
      "right", [](Dynamics& d) -> FrameState& { return d.sole[kRight]; }, py::return_value_policy::reference_internal,
      "right sole");
  dynamics.def_property_readonly(
      "frames", [](const Dynamics& d) -> const std::vector<FrameState>& { return d.frames; },
      "a list of FrameState: the frames that are watched (a copy)");
  dynamics.def("__copy__", [](const Dynamics& d) { return Dynamics(d); });

  py::class_<PyRobot>(m, "Robot", "One robot in a MuJoCo model; it reads mjData into Dynamics.")
      .def(py::init<const py::object&, const RobotDescription&>(), "model"_a, "description"_a,
           "Raises:\n    ModelError: the robot cannot walk.")
      .def(
          "read",
          [](PyRobot& r, const py::object& data) {
            const Data d = data_of(data);
            r.robot.require_data(d);
            if (!r.robot.is_finite(d)) throw InputError("data holds a position or velocity that is not finite");
            r.robot.read(d);
            return r.robot.dynamics();
          },
          "data"_a, "Dynamics of the state in `data` (a copy).\n\nRaises:\n    InputError: the state is not finite.")
      .def_property_readonly(
          "joint_names", [](const PyRobot& r) { return r.robot.joint_names(); },
          "names of the joints, in the order of torques and joint velocities")
      .def_property_readonly(
          "leg_joints", [](const PyRobot& r) { return r.robot.leg_joints(); },
          "joint indices of the two legs, hip to ankle")
      .def_property_readonly(
          "torque_path", [](const PyRobot& r) { return torque_path(r.robot); },
          "how each joint's torque reaches MuJoCo, by joint name: \"motor 'l_knee'\", \"qfrc_applied: position servo "
          "'l_knee' is silenced\", ...")
      .def_property_readonly(
          "torque_limit", [](const PyRobot& r) { return r.robot.torque_limit(); }, "(joints,) [N m]")
      .def_property_readonly(
          "qpos_address", [](const PyRobot& r) { return r.robot.qpos_address(); }, "of the free joint in qpos")
      .def_property_readonly(
          "dof_address", [](const PyRobot& r) { return r.robot.dof_address(); }, "of the free joint in qvel");
}
