#include "common.hpp"
#include "zmpwalk/gait/pendulum.hpp"

using namespace zmpwalk;

void bind_pendulum(py::module_& m) {
  const auto pair = [](const PendulumState& s) { return std::make_pair(s.x, s.v); };
  py::class_<LinearInvertedPendulum>(
      m, "LinearInvertedPendulum",
      "The linear inverted pendulum: a point mass at height z_c over a ZMP at r, x'' = (x - r) / T_c^2 with "
      "T_c = sqrt(z_c / g).\n\nUsage:\n    >>> "
      "LinearInvertedPendulum(0.747).step(0.001, 0.0, 0.25, -0.09)")
      .def(py::init<double, double>(), "z_c"_a, "gravity"_a = 9.81,
           "Args:\n    z_c: COM height [m].\n    gravity: [m/s^2].\n\nRaises:\n    InputError.")
      .def_property_readonly("Tc", &LinearInvertedPendulum::Tc, "time constant T_c [s]")
      .def_property_readonly("omega", &LinearInvertedPendulum::omega, "1 / T_c [rad/s]")
      .def(
          "step",
          [pair](const LinearInvertedPendulum& p, double dt, double x, double v, double r) {
            return pair(p.step(dt, {x, v}, r));
          },
          "dt"_a, "x"_a, "v"_a, "r"_a, "Eq. 16 (corrected): (x_d, v_d) after dt [s] under reference ZMP r [m].")
      .def(
          "step_lateral",
          [pair](const LinearInvertedPendulum& p, double dt, double y, double w) {
            return pair(p.step_lateral(dt, {y, w}));
          },
          "dt"_a, "y"_a, "w"_a, "Eq. 17: (y_d, w_d) after dt [s] under a reference ZMP at zero.")
      .def(
          "velocity_after",
          [](const LinearInvertedPendulum& p, double T, double y, double w) { return p.velocity_after(T, {y, w}); },
          "T"_a, "y"_a, "w"_a, "Eq. 18: velocity w(T) after T [s] under a reference ZMP at zero [m/s].")
      .def("acceleration", &LinearInvertedPendulum::acceleration, "x"_a, "r"_a,
           "Acceleration of the mass: (x - r) / T_c^2 [m/s^2].")
      .def("reference_for", &LinearInvertedPendulum::reference_for, "x"_a, "a"_a,
           "Reference ZMP that gives the acceleration a: r = x - T_c^2 a [m].")
      .def(
          "dcm", [](const LinearInvertedPendulum& p, double x, double v) { return p.dcm({x, v}); }, "x"_a, "v"_a,
          "Divergent component of motion (DCM), x + T_c v [m]: put the ZMP there, and the mass comes to rest over it.")
      .def("reference_to_reach",
           py::overload_cast<double, double, double>(&LinearInvertedPendulum::reference_to_reach, py::const_), "xi"_a,
           "xi_end"_a, "time"_a, "Constant reference ZMP that brings the DCM from xi to xi_end in time [s].")
      .def("orbit_inset", py::overload_cast<double, double>(&LinearInvertedPendulum::orbit_inset, py::const_),
           "width"_a, "period"_a,
           "How far inside the foot that takes over next the DCM of the lateral orbit is, when the COM is half way "
           "between the "
           "feet [m].")
      .def("orbit_offset", py::overload_cast<double, double>(&LinearInvertedPendulum::orbit_offset, py::const_),
           "drift"_a, "period"_a,
           "How much further along that DCM is, where the middle between the feet moves sideways by `drift` in a step "
           "[m].")
      .def("orbit_velocity", &LinearInvertedPendulum::orbit_velocity, "drift"_a, "period"_a,
           "Lateral velocity of that orbit in the middle of a single support [m/s].")
      .def("first_double_support", &LinearInvertedPendulum::first_double_support, "period"_a, "T_ss"_a,
           "Length of the first double support with which a COM at rest between the feet gets onto the lateral orbit "
           "[s].");
}
