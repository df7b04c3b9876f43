#include "common.hpp"
#include "zmpwalk/control/momentum.hpp"
#include "zmpwalk/gait/joint_motion.hpp"

using namespace zmpwalk;

void bind_joint_motion(py::module_& m) {
  py::class_<JointMotion>(m, "JointMotion",
                          "Scripted references of joints and trunk: a cubic spline with continuous acceleration.")
      .def(py::init<const VecX&, std::vector<std::string>, const RowMatX&>(), "t"_a, "names"_a, "q"_a,
           "Args:\n    t: knot times (n,) [s], from 0, increasing.\n    names: joint of each column (m,).\n"
           "    q: positions at the knots (n, m) [rad or m].\n\nRaises:\n    InputError, DimensionError.")
      .def(
          "at",
          [](const JointMotion& motion, double t) {
            RowMatX out(3, motion.names().size());
            for (int j = 0; j < out.cols(); ++j) {
              const Motion1 s = motion.at(t, j);
              out.col(j) << s.p, s.v, s.a;
            }
            return out;
          },
          "t"_a, "Position, velocity and acceleration (3, m) at time t [s]; the last position holds.")
      .def_property_readonly("t", &JointMotion::t, "Knot times (n,) [s].")
      .def_property_readonly("names", &JointMotion::names, "Joint of each column.")
      .def_property_readonly("q", &JointMotion::q, "Positions at the knots (n, m) [rad or m].")
      .def_property_readonly("duration", &JointMotion::duration, "Time of the last knot [s].");
  m.def(
      "yaw_momentum",
      [](const Dynamics& dynamics) {
        VecX c(dynamics.nv());
        momentum_row(dynamics, Vec3::UnitZ(), c.transpose());
        return c;
      },
      "dynamics"_a, "Row c (nv,) of the angular momentum about the vertical through the COM, L_z = c dq [kg m^2/s].");
}
