#include "common.hpp"
#include "zmpwalk/gait/velocity_tracker.hpp"

using namespace zmpwalk;

void bind_velocity_tracker(py::module_& m) {
  py::class_<VelocityTracker>(m, "VelocityTracker",
                              "Lets the velocity of the COM follow the planned one, along one axis (III-C).")
      .def(py::init([](const std::string& law, double gain, double time, double deadband, double catch_up_speed) {
             TrackingSettings settings;
             settings.law = chosen<TrackerLawName>("law", law);
             settings.gain = gain;
             settings.time = time;
             settings.deadband = deadband;
             settings.catch_up_speed = catch_up_speed;
             return VelocityTracker(settings);
           }),
           "law"_a = "smooth", "gain"_a = 5.0, "time"_a = 0.05, "deadband"_a = 2e-4,
           "catch_up_speed"_a = std::numeric_limits<double>::infinity(),
           "Args:\n    law: a value of the setting tracking.law: 'smooth', or 'bang_bang' as the paper has it.\n    "
           "gain: [1/s].\n    time: [s].\n    deadband: "
           "[m].\n    catch_up_speed: largest |gain I| [m/s].\n\nRaises:\n    InputError.")
      .def("reset", &VelocityTracker::reset)
      .def("acceleration", &VelocityTracker::acceleration, "v_plan"_a, "v"_a, "ahead"_a = 0.0,
           "Acceleration that the law asks of the pendulum [m/s^2]: (v_plan - gain (I - ahead) - v) / time in the "
           "smooth "
           "law.\n\n"
           "Args:\n    v_plan, v: planned and current velocity [m/s].\n    ahead: value that the integral I is meant "
           "to have "
           "now [m].")
      .def("advance", &VelocityTracker::advance, "v_des"_a, "v_plan"_a, "dt"_a, "Adds one cycle to the integral.")
      .def_property_readonly("integral", &VelocityTracker::integral, "integral of v_des - v_plan [m]")
      .def_property_readonly(
          "drive", [](const VelocityTracker& t) { return static_cast<int>(t.drive()); },
          "where the law holds the ZMP: -1 on its lower bound, +1 on its upper one, 0 on neither");
}
