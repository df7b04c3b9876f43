#include "common.hpp"
#include "zmpwalk/gait/gait_generator.hpp"

using namespace zmpwalk;

namespace {

/// A gait with the pendulum and the settings of its robot.
struct PyGait {
  PyGait(double com_height, double gravity, double timestep, double foot_distance, double sole_width,
         double sole_length, const VelocityProfile& p, const WalkSettings& s)
      : sole(sole_length, sole_width),
        pendulum(com_height, gravity),
        settings(resolve(s, scale(com_height, gravity, timestep, foot_distance))),
        gait(settings, p, {sole_length, sole_width}, {bounds(), bounds()}) {}
  ZmpBounds bounds() const {
    const Vec2 half = 0.5 * settings.zmp.sole_fraction * sole;
    return {-half, half};
  }
  static RobotScale scale(double com_height, double gravity, double timestep, double foot_distance) {
    RobotScale out;
    out.com_height = com_height;
    out.gravity = gravity;
    out.timestep = timestep;
    out.foot_distance = foot_distance;
    return out;
  }
  Vec2 sole;
  LinearInvertedPendulum pendulum;
  WalkSettings settings;
  GaitGenerator gait;
};

GaitInput input(double t, const Vec2& com, const Vec2& dcom, const std::array<Vec3, 2>& soles) {
  GaitInput in;
  in.t = t;
  in.com = com;
  in.dcom = dcom;
  in.p_sole = soles;
  return in;
}

}  // namespace

void bind_gait_generator(py::module_& m) {
  py::class_<GaitOutput>(m, "GaitOutput", "What the gait asks for in one cycle.")
      .def_property_readonly(
          "phase", [](const GaitOutput& o) { return static_cast<int>(o.phase.phase); }, "0 double, 1 single support")
      .def_property_readonly("step", [](const GaitOutput& o) { return o.phase.step; })
      .def_property_readonly(
          "phase_time", [](const GaitOutput& o) { return o.phase.time; }, "[s]")
      .def_property_readonly(
          "support", [](const GaitOutput& o) { return static_cast<int>(side_sign(o.support)); }, "+1 left, -1 right")
      .def_readonly("at_rest", &GaitOutput::at_rest, "stands, and is not asked to walk")
      .def_readonly("heading", &GaitOutput::heading, "of the walk, in the world [rad]")
      .def_readonly("v_plan", &GaitOutput::v_plan, "planned velocity (v_x, v_y, w_z)")
      .def_readonly("standing", &GaitOutput::standing, "(left, right)")
      .def_readonly("zmp_lateral", &GaitOutput::zmp_lateral, "reference ZMP along the support frame's y [m]")
      .def_readonly("w_T", &GaitOutput::w_T, "eq. 18 [m/s]")
      .def_property_readonly(
          "foothold", [](const GaitOutput& o) { return Vec3(o.foothold.p.x(), o.foothold.p.y(), o.foothold.yaw); },
          "(x, y, yaw)")
      .def_property_readonly(
          "swing_position", [](const GaitOutput& o) { return o.swing_target.p; }, "(3,) [m]")
      .def_property_readonly(
          "swing_velocity", [](const GaitOutput& o) { return o.swing_target.v; }, "(3,) [m/s]")
      .def_property_readonly(
          "swing_acceleration", [](const GaitOutput& o) { return o.swing_target.a; }, "(3,) [m/s^2]");
  py::class_<PyGait>(m, "GaitGenerator",
                     "Phases, support switch, footholds and swing foot, from time and the COM alone.")
      .def(py::init<double, double, double, double, double, double, const VelocityProfile&, const WalkSettings&>(),
           py::kw_only(), "com_height"_a, "gravity"_a = 9.81, "timestep"_a = 0.001, "foot_distance"_a, "sole_width"_a,
           "sole_length"_a = 0.25, "profile"_a, py::arg_v("settings", WalkSettings(), "WalkSettings()"),
           "Args:\n    com_height: z_c [m].\n    gravity: [m/s^2].\n    timestep: control period [s].\n    "
           "foot_distance, sole_width, sole_length: [m].\n"
           "    profile: VelocityProfile.\n    settings: WalkSettings.\n\nRaises:\n    InputError.")
      .def(
          "reset",
          [](PyGait& g, const Vec2& com, const Vec2& dcom, const std::array<Vec3, 2>& soles) {
            g.gait.reset(input(0.0, com, dcom, soles), g.pendulum);
          },
          "com"_a, "dcom"_a, "soles"_a,
          "Starts a walk from two standing feet: COM (2,), its velocity (2,), sole centres (2, 3).")
      .def(
          "update",
          [](PyGait& g, double t, const Vec2& com, const Vec2& dcom, const std::array<Vec3, 2>& soles) {
            require_finite("t", t);
            return g.gait.update(input(t, com, dcom, soles));
          },
          "t"_a, "com"_a, "dcom"_a, "soles"_a, "One cycle at time t [s].")
      .def(
          "command", [](PyGait& g, const Vec3& v) { g.gait.command(v); }, "velocity"_a,
          "From the next cycle on towards (v_x, v_y, w_z), whatever the profile says.")
      .def_property_readonly("settings", [](const PyGait& g) { return g.settings; }, "settings in force");
}
