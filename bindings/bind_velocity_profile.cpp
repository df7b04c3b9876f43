#include "common.hpp"
#include "zmpwalk/gait/velocity_profile.hpp"

using namespace zmpwalk;

namespace {

VelocityProfile make(const std::vector<double>& t, const Eigen::Ref<const RowMatX>& v,
                     const std::string& interpolation) {
  if (interpolation != "hold" && interpolation != "linear")
    throw InputError("interpolation = '" + interpolation + "' is unknown; there are: hold, linear");
  require_shape("v", v.rows(), v.cols(), static_cast<long>(t.size()), 3);
  std::vector<Vec3> rows;
  for (Eigen::Index i = 0; i < v.rows(); ++i) rows.emplace_back(v.row(i));
  return VelocityProfile(t, rows, interpolation == "hold" ? Interpolation::kHold : Interpolation::kLinear);
}

RowMatX velocities(const VelocityProfile& p) {
  RowMatX v(p.v().size(), 3);
  for (std::size_t i = 0; i < p.v().size(); ++i) v.row(i) = p.v()[i];
  return v;
}

}  // namespace

void bind_velocity_profile(py::module_& m) {
  py::class_<VelocityProfile>(
      m, "VelocityProfile",
      "Planned velocity of the COM over time, (v_x, v_y, w_z) in the heading frame [m/s, m/s, rad/s].")
      .def(py::init(&make), "t"_a, "v"_a, "interpolation"_a = "hold",
           "Args:\n    t: knot times (n,) [s], from 0, increasing.\n    v: velocities (n, 3).\n"
           "    interpolation: 'hold' or 'linear'.\n\nRaises:\n    InputError, DimensionError.")
      .def("velocity", &VelocityProfile::velocity, "t"_a,
           "Velocity (3,) at time t [s]; after the last knot it stays as there.")
      .def("displacement", &VelocityProfile::displacement, "t0"_a, "t1"_a,
           "Integral of the velocity from t0 to t1 (3,) [m, m, rad].")
      .def("travel", py::overload_cast<double, double>(&VelocityProfile::travel, py::const_), "t0"_a, "t1"_a,
           "Where a frame that moves with this velocity is at t1, seen from where it is at t0: (x, y, yaw) (3,).")
      .def_property_readonly("max_speed", &VelocityProfile::max_speed, "Largest |(v_x, v_y)| [m/s].")
      .def_property_readonly("t", &VelocityProfile::t, "Knot times [s].")
      .def_property_readonly("v", &velocities, "Knot velocities (n, 3).")
      .def_property_readonly("interpolation", [](const VelocityProfile& p) {
        return p.interpolation() == Interpolation::kHold ? "hold" : "linear";
      });
}
