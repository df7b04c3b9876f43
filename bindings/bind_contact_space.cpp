#include "common.hpp"
#include "zmpwalk/control/contact_space.hpp"

using namespace zmpwalk;

void bind_contact_space(py::module_& m) {
  py::class_<ContactSpace>(
      m, "ContactSpace",
      "How joint torques act on the ground through the standing feet: the contact space, eq. 2 and 9-13.")
      .def(py::init([](const Eigen::Ref<const RowMatX>& A, const VecX& b, const VecX& g,
                       const Eigen::Ref<const RowMatX>& J_c, const VecX& drift_c) {
             ContactSpace space(static_cast<int>(J_c.cols()), static_cast<int>(J_c.rows()));
             space.compute(A, b, g, J_c, drift_c);
             return space;
           }),
           "A"_a, "b"_a, "g"_a, "J_c"_a, "drift_c"_a,
           "Args:\n    A: inertia (nv, nv).\n    b, g: velocity and gravity terms (nv,).\n    J_c: (6 k, nv).\n    "
           "drift_c: Jdot_c dq (6 k,).\n\n"
           "Raises:\n    DimensionError.")
      .def_property_readonly("Lambda_c", &ContactSpace::Lambda_c, "contact inertia, eq. 10 (m, m)")
      .def_property_readonly(
          "Jbar_c", [](const ContactSpace& c) { return RowMatX(c.JbarT_c().transpose()); },
          "dynamically consistent inverse of J_c, eq. 13 (nv, m)")
      .def_property_readonly("N_c", &ContactSpace::N_c, "contact null space, eq. 2 (nv, nv)")
      .def_property_readonly("mu_c", &ContactSpace::mu_c, "velocity forces in contact space, eq. 11 (m,)")
      .def_property_readonly("p_c", &ContactSpace::p_c, "gravity in contact space, eq. 12 (m,)")
      .def(
          "wrench",
          [](const ContactSpace& c, const VecX& tau) {
            require_size("tau", tau.size(), c.J_c().cols() - 6);
            VecX f_c(c.J_c().rows());
            c.wrench(tau, f_c);
            return f_c;
          },
          "tau"_a, "Eq. 9: wrench of the robot on the ground (m,) for joint torque (joints,) [N m].");
}
