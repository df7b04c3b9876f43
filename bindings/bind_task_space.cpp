#include "common.hpp"
#include "zmpwalk/control/task_space.hpp"

using namespace zmpwalk;

void bind_task_space(py::module_& m) {
  py::class_<TaskSpace>(m, "TaskSpace",
                        "Equations 1 and 3-7 as they are printed, (7) corrected: their definition, which is slow.")
      .def(py::init<const ContactSpace&, const VecX&, const VecX&, const Eigen::Ref<const RowMatX>&, const VecX&>(),
           "contact"_a, "b"_a, "g"_a, "J"_a, "drift"_a,
           "Args:\n    contact: ContactSpace of the same instant.\n    b, g: (nv,).\n    J: stacked task Jacobian (m, "
           "nv).\n    drift: Jdot dq (m,).\n\n"
           "Raises:\n    DimensionError; InputError: the tasks conflict.")
      .def_readonly("Lambda", &TaskSpace::Lambda, "task inertia under contact, eq. 3 (m, m)")
      .def_property_readonly(
          "Jbar", [](const TaskSpace& t) { return RowMatX(t.JbarT.transpose()); },
          "dynamically consistent inverse of J, eq. 4 (nv, m)")
      .def_readonly("mu", &TaskSpace::mu, "velocity forces in task space, eq. 5 (m,)")
      .def_readonly("p", &TaskSpace::p, "gravity in task space, eq. 6 (m,)")
      .def_readonly("J_k", &TaskSpace::J_k, "modified task Jacobian (m, joints)")
      .def_readonly("N_k", &TaskSpace::N_k,
                    "a joint torque that is multiplied by it leaves the tasks alone (joints, joints)")
      .def_readonly("V_n", &TaskSpace::V_n, "torques that change nothing but the contact wrenches (joints, m_c - 6)")
      .def("force", &TaskSpace::force, "f_star"_a, "Eq. 1: task force (m,) for commanded acceleration (m,).")
      .def("torque", &TaskSpace::torque, "F"_a, "Eq. 7: joint torque (joints,) for task force (m,).");
  m.def(
      "pd_acceleration",
      [](double kp, double kd, const VecX& position_error, const VecX& velocity_error) {
        return VecX(pd_acceleration(kp, kd, position_error, velocity_error));
      },
      "kp"_a, "kd"_a, "position_error"_a, "velocity_error"_a, "Eq. 8: f* = kp (x_d - x) + kd (v_d - v).");
}
