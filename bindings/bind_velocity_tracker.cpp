#include "common.hpp"
#include "zmpwalk/gait/velocity_tracker.hpp"

using namespace zmpwalk;

void bind_velocity_tracker(py::module_& m) {
  py::class_<VelocityTracker>(m, "VelocityTracker",
                              "Lets the velocity of the COM follow the planned one, along one axis (III-C).")
      .def(py::init([](const std::string& law, double gain, double time, double deadband, double catch_up_speed) {
             TrackerLaw parsed;
             from_string("law", law, parsed);
             return VelocityTracker(parsed, gain, time, deadband, catch_up_speed);
           }),
           "law"_a = "smooth", "gain"_a = 5.0, "time"_a = 0.05, "deadband"_a = 2e-4,
           "catch_up_speed"_a = std::numeric_limits<double>::infinity(),
           "Args:\n    law: 'smooth' or 'bang_bang' (the paper's).\n    gain: [1/s].\n    time: [s].\n    deadband: "
           "[m].\n    catch_up_speed: largest |gain I| [m/s].\n\nRaises:\n    InputError.")
      .def("reset", &VelocityTracker::reset)
      .def("acceleration", &VelocityTracker::acceleration, "v_plan"_a, "v"_a, "ahead"_a = 0.0,
           "Smooth law: (v_plan - gain (I - ahead) - v) / time [m/s^2]; ahead: value that I, the integral, is meant to "
           "have now [m].")
      .def("advance", &VelocityTracker::advance, "v_des"_a, "v_plan"_a, "dt"_a, "Adds one cycle to the integral.")
      .def_property_readonly("integral", &VelocityTracker::integral, "integral of v_des - v_plan [m]")
      .def_property_readonly(
          "drive", [](const VelocityTracker& t) { return static_cast<int>(t.drive()); },
          "what the bang-bang law does: -1 holds the ZMP on the lower bound, +1 on the upper one, 0 follows the plan");
}
