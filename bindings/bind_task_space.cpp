#include "common.hpp"
#include "zmpwalk/control/task_space.hpp"

using namespace zmpwalk;

void bind_task_space(py::module_& m) {
  py::class_<TaskSpace>(m, "TaskSpace", "Eq. 1 and 3-7 as printed (with the erratum of (7)): the definition.")
      .def(py::init<const ContactSpace&, const VecX&, const VecX&, const Eigen::Ref<const RowMatX>&, const VecX&>(),
           "contact"_a, "b"_a, "g"_a, "J"_a, "drift"_a,
           "Args:\n    contact: ContactSpace of the same instant.\n    b, g: (nv,).\n    J: stacked task Jacobian (m, "
           "nv).\n    drift: Jdot dq (m,).\n\n"
           "Raises:\n    DimensionError; InputError: the tasks conflict.")
      .def_readonly("Lambda", &TaskSpace::Lambda, "eq. 3 (m, m)")
      .def_property_readonly(
          "Jbar", [](const TaskSpace& t) { return RowMatX(t.JbarT.transpose()); }, "eq. 4, transposed (nv, m)")
      .def_readonly("mu", &TaskSpace::mu, "eq. 5 (m,)")
      .def_readonly("p", &TaskSpace::p, "eq. 6 (m,)")
      .def_readonly("J_k", &TaskSpace::J_k, "modified task Jacobian (m, joints)")
      .def_readonly("N_k", &TaskSpace::N_k, "torques through it leave the tasks alone (joints, joints)")
      .def_readonly("V_n", &TaskSpace::V_n, "internal torques (joints, m_c - 6)")
      .def("force", &TaskSpace::force, "f_star"_a, "Eq. 1: task force (m,) for commanded acceleration (m,).")
      .def("torque", &TaskSpace::torque, "F"_a, "Eq. 7: joint torque (joints,) for task force (m,).");
  m.def(
      "pd_acceleration",
      [](double kp, double kd, const VecX& position_error, const VecX& velocity_error) {
        return VecX(pd_acceleration(kp, kd, position_error, velocity_error));
      },
      "kp"_a, "kd"_a, "position_error"_a, "velocity_error"_a, "Eq. 8: f* = kp (x_d - x) + kd (v_d - v).");
}
