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

GaitInput input(double t, const Vec2& com, const Vec2& dcom, const std::array<Vec3, 2>& soles,
                const Vec2& contact = Vec2::Constant(kNaN)) {
  GaitInput in;
  in.t = t;
  in.com = com;
  in.dcom = dcom;
  in.p_sole = soles;
  in.contact = contact;
  return in;
}

}  // namespace

void bind_gait_generator(py::module_& m) {
  py::class_<GaitOutput>(m, "GaitOutput", "What the gait asks for in one cycle.")
      .def_property_readonly(
          "phase", [](const GaitOutput& o) { return static_cast<int>(o.phase.phase); }, "0 double, 1 single support")
      .def_property_readonly("step", [](const GaitOutput& o) { return o.phase.step; })
      .def_property_readonly(
          "phase_duration", [](const GaitOutput& o) { return o.phase.duration; },
          "length of the phase [s]; events change it")
      .def_property_readonly(
          "phase_time", [](const GaitOutput& o) { return o.phase.time; }, "time since the phase began [s]")
      .def_property_readonly(
          "support", [](const GaitOutput& o) { return static_cast<int>(side_sign(o.support)); },
          "foot that carries the ZMP: +1 left, -1 right")
      .def_readonly("at_rest", &GaitOutput::at_rest, "whether the robot stands and is not asked to walk")
      .def_readonly("heading", &GaitOutput::heading, "heading of the path in the world [rad]")
      .def_readonly("v_plan", &GaitOutput::v_plan, "planned velocity (v_x, v_y, w_z) in the heading frame")
      .def_readonly("standing", &GaitOutput::standing, "whether each foot stands (left, right)")
      .def_readonly("zmp_lateral", &GaitOutput::zmp_lateral,
                    "reference ZMP from the support sole's centre, along the y axis of the heading frame [m]")
      .def_readonly("w_T", &GaitOutput::w_T, "w(T) of eq. 18 while a switch of the support is awaited, else NaN [m/s]")
      .def_property_readonly(
          "foothold", [](const GaitOutput& o) { return Vec3(o.foothold.p.x(), o.foothold.p.y(), o.foothold.yaw); },
          "where the swing foot is to land (x, y, yaw) [m, m, rad]; NaN in double support")
      .def_property_readonly(
          "swing_position", [](const GaitOutput& o) { return o.swing_target.p; },
          "desired place of the swing sole (3,) [m]")
      .def_property_readonly(
          "swing_velocity", [](const GaitOutput& o) { return o.swing_target.v; },
          "desired velocity of the swing sole (3,) [m/s]")
      .def_property_readonly(
          "swing_acceleration", [](const GaitOutput& o) { return o.swing_target.a; },
          "desired acceleration of the swing sole (3,) [m/s^2]");
  py::class_<PyGait>(m, "GaitGenerator",
                     "The gait: it decides from time and COM which foot stands, when the support switches, where feet "
                     "land and how the "
                     "swing foot moves there.")
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
          [](PyGait& g, double t, const Vec2& com, const Vec2& dcom, const std::array<Vec3, 2>& soles,
             const Vec2& contact) {
            require_finite("t", t);
            return g.gait.update(input(t, com, dcom, soles, contact));
          },
          "t"_a, "com"_a, "dcom"_a, "soles"_a, py::arg_v("contact", Vec2(kNaN, kNaN), "(nan, nan)"),
          "Goes on by one cycle, at time t [s]. `contact` (2,) says whether the left and the right foot touch the "
          "ground: "
          "1 yes, 0 no, NaN unknown; it ends a step where the setting touch_down is 'contact'.")
      .def(
          "retime", [](PyGait& g, double remaining) { g.gait.retime(remaining); }, "remaining"_a,
          "Lets the phase of the last cycle end `remaining` [s] after that cycle, however long it was to take.\n\n"
          "Raises:\n    InputError: `remaining` is not finite and > 0.")
      .def(
          "command", [](PyGait& g, const Vec3& v) { g.gait.command(v); }, "velocity"_a,
          "Commands a velocity: from the next cycle on the plan goes towards (v_x, v_y, w_z), whatever the profile "
          "says.")
      .def_property_readonly("settings", [](const PyGait& g) { return g.settings; }, "settings in force");
}
