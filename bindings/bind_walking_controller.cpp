#include "bind_tasks.hpp"
#include "zmpwalk/walk/walking_controller.hpp"

using namespace zmpwalk;

void bind_walking_controller(py::module_& m) {
  py::class_<CycleOutput> out(
      m, "CycleOutput",
      "Everything one control cycle decided.\n\n"
      "Each number is a column of a Trace too: `Trace.columns()` is the table of them. Frames are W, the world; "
      "H, turned into the\nheading of the walk; S, the axes of the support sole.");
  const std::vector<RecordedColumn> columns = recorded_columns();
  auto column = columns.begin();
  visit_columns([&](const char* name, const auto& get, const auto&...) {
    const std::string text = (column++)->text();
    if constexpr (is_decided<std::decay_t<decltype(get)>>)
      out.def_property_readonly(
          name, [get](const CycleOutput& o) -> decltype(auto) { return std::invoke(get, o); }, text.c_str());
  });
  out.def_readonly("fresh", &CycleOutput::fresh,
                   "Whether this call computed the torque and did not hold an earlier one.");
  out.def_property_readonly(
      "fall_cause", [](const CycleOutput& o) { return to_string(o.fell); },
      "Why the robot fell; it is empty where the robot did not.");
  out.def("__copy__", [](const CycleOutput& o) { return CycleOutput(o); });
  out.def("__repr__", [](const CycleOutput& o) {
    const Eigen::IOFormat row(4, Eigen::DontAlignCols, ", ", ", ", "", "", "[", "]");
    std::ostringstream text;
    text << "CycleOutput(t=" << o.t << ", phase=" << (o.phase ? "single" : "double")
         << ", support=" << (o.support > 0 ? "left" : "right") << ", com=" << o.com.format(row)
         << ", zmp_est=" << o.zmp_est.format(row) << ", iterations=" << o.iterations << ")";
    return text.str();
  });

  py::class_<WalkingController>(m, "WalkingController",
                                "One update(data) -> CycleOutput per physics step: state in, torque out.\n\n"
                                "Takes eq. (16) for the desired COM state, (1)-(8) for the torque, (9)-(15) for the "
                                "ZMP it will produce, III-B to correct it.")
      .def(py::init([](const py::object& model, const RobotDescription& description, const WalkSettings& settings,
                       const VelocityProfile& profile) {
             return std::make_unique<WalkingController>(model_of(model), description, settings, profile);
           }),
           "model"_a, "description"_a, py::arg_v("settings", WalkSettings(), "WalkSettings()"),
           py::arg_v("profile", VelocityProfile::paper(), "VelocityProfile.paper()"), py::keep_alive<1, 2>(),
           "Args:\n    model: mujoco.MjModel; kept alive.\n    description: RobotDescription.\n    settings: "
           "WalkSettings.\n"
           "    profile: VelocityProfile; the paper's by default.\n\nRaises:\n    ModelError: the robot cannot be "
           "walked.\n"
           "    InputError: a setting breaks a rule, or the profile is faster than the legs reach.")
      .def(
          "reset", [](WalkingController& c, const PyState& state) { c.reset(state); }, "state"_a,
          "Starts a walk from a State; moves nothing.")
      .def(
          "reset", [](WalkingController& c, const py::object& data) { c.reset(data_of(data)); }, "data"_a,
          "Reads the state and starts a walk there; moves nothing.\n\nRaises:\n    InputError: the state is not "
          "finite.")
      .def(
          "state",
          [](const WalkingController& c, const py::object& data) {
            const mjData* d = data_of(data);
            c.robot().require_data(d);
            PyState state(c.robot().nv());
            c.robot().observe(d, state);
            return state;
          },
          "data"_a,
          "The robot's part of `data` as plain numbers: time, position and velocity. What feet feel is left "
          "unknown.\n\n"
          "Args:\n    data: mujoco.MjData.\n\nReturns:\n    State.\n\nRaises:\n    InputError: data of another model.")
      .def(
          "update",
          [](WalkingController& c, const PyState& state) -> const CycleOutput& {
            PyState known = state;
            known.external = external_of(c, state.named);
            return c.update(known);
          },
          "state"_a, py::return_value_policy::copy,
          "Computes the torque for a State, in the output's `tau`; changes nothing outside the controller.")
      .def(
          "update",
          [](WalkingController& c, const py::object& data, bool after_step1, const py::object& external,
             const std::optional<Vec2>& contact) -> const CycleOutput& {
            Sensed sensed;
            sensed.external = external_of(c, external);
            if (contact) sensed.contact = {(*contact)[kLeft], (*contact)[kRight]};
            return c.update(data_of(data), after_step1 ? Terms::kInData : Terms::kCompute, sensed);
          },
          "data"_a, "after_step1"_a = false, "external"_a = py::none(), "contact"_a = py::none(),
          py::return_value_policy::copy,
          "Computes the torque for the state in `data`, writes data.ctrl, returns a copy of what was decided.\n\n"
          "Args:\n    data: mujoco.MjData.\n    after_step1: mj_step1 (or mj_forward) has just run for this state, so "
          "that "
          "`data` holds kinematics,\n        inertia and bias forces already; the torque has the same bits, in half "
          "the "
          "time.\n    external: known forces on the robot, {body or site: (6,) force and moment at its frame's origin, "
          "world axes\n        [N, N m]}; None where there are none.\n    contact: (left, right), 1 where a foot "
          "touches the "
          "ground, 0 where it does not, NaN where nobody knows; None reads\n        data's own contacts of the last "
          "step, "
          "where the setting `touch_down` asks for them.\n\n"
          "Raises:\n    InputError: the state is not finite, its terms belong to another, or reset() was not called; "
          "nothing is\n        changed.")
      .def(
          "command", [](WalkingController& c, double vx, double vy, double wz) { c.command(Vec3(vx, vy, wz)); }, "vx"_a,
          "vy"_a = 0.0, "wz"_a = 0.0, py::call_guard<py::gil_scoped_release>(),
          "From the next cycle on, walk with (vx, vy, wz) in the heading frame instead of the profile's velocity; "
          "until "
          "reset().\n\n"
          "May be called from any thread, at any time. What the legs cannot reach is scaled down to "
          "`within_reach`; how fast the\nrobot takes a command up is limited (settings forward_jump, "
          "forward_acceleration, ...).\n\n"
          "Args:\n    vx, vy: [m/s].\n    wz: [rad/s].\n\nRaises:\n    InputError: not finite.")
      .def(
          "reach_share", [](const WalkingController& c, const Vec3& velocity) { return c.reach().share(velocity); },
          "velocity"_a,
          "Share of the legs' reach that walking with velocity (v_x, v_y, w_z) takes; at most 1 can be walked.")
      .def(
          "within_reach", [](const WalkingController& c, const Vec3& velocity) { return c.reach().within(velocity); },
          "velocity"_a, "The velocity (v_x, v_y, w_z), made smaller until its reach_share is at most 1.")
      .def_property_readonly(
          "settings", [](const WalkingController& c) { return c.settings(); },
          "WalkSettings in force, every NaN filled in")
      .def_property_readonly("profile", &WalkingController::profile)
      .def("retime", &WalkingController::retime, "remaining"_a,
           "The phase under way, single or double support, ends `remaining` [s] after the last cycle; the swing foot "
           "goes on "
           "from where\nit is without a jump. Call it between cycles.\n\nRaises:\n    InputError: not finite and > 0. "
           "A robot that stands "
           "stays as it is.")
      .def("move", &WalkingController::move, "motion"_a,
           "Joints outside the legs, and the trunk, follow `motion` from now on; see the package's WalkingController.")
      .def_property_readonly("motion", &WalkingController::motion)
      .def("add", &WalkingController::add, "task"_a, "blend"_a = kNaN,
           "The task is met from now on; see the package's WalkingController.")
      .def(
          "remove",
          [](WalkingController& c, const std::shared_ptr<Task>& task, double blend) { c.remove(*task, blend); },
          "task"_a, "blend"_a = kNaN, "The task loses its effect; see the package's WalkingController.")
      .def_property_readonly("cycles", &WalkingController::cycles, "control cycles since the last reset")
      .def_property_readonly(
          "task_activations",
          [](const WalkingController& c) {
            std::vector<double> out;
            for (const TaskStack::Entry& entry : c.added_tasks().entries()) out.push_back(entry.activation);
            return out;
          },
          "how far each added task acts, in the order of their priority: from 0 to its weight")
      .def_property_readonly(
          "active_limits", [](const WalkingController& c) { return c.output().limits.names(c.robot().joint_names()); },
          "the limits that held the last torque back, in words: [\"torque of l_knee\", \"yaw friction of the left "
          "sole\"]; empty where none did")
      .def_property_readonly("description", [](const WalkingController& c) { return c.robot().description(); })
      .def_property_readonly("joint_names", [](const WalkingController& c) { return c.robot().joint_names(); })
      .def_property_readonly(
          "arm_joints",
          [](const WalkingController& c) {
            std::vector<std::string> names;
            for (const int j : c.robot().arm_joints()) names.push_back(c.robot().joint_names()[j]);
            return names;
          },
          "joints outside the legs that carry less than a fifth of the robot's mass: arms, not the waist")
      .def_property_readonly(
          "torque_path", [](const WalkingController& c) { return torque_path(c.robot()); },
          "how each joint's torque reaches MuJoCo, by joint name: \"motor 'l_knee'\", \"qfrc_applied: position servo "
          "'l_knee' is silenced\", ...")
      .def_property_readonly(
          "torque_limit", [](const WalkingController& c) { return c.robot().torque_limit(); }, "(nu,) [N m]")
      .def_property_readonly(
          "mass", [](const WalkingController& c) { return c.robot().dynamics().mass; }, "[kg]")
      .def_property_readonly("com_height", &WalkingController::com_height, "z_c over the soles [m]")
      .def_property_readonly("Tc", &WalkingController::Tc, "sqrt(z_c / g) [s]")
      .def("knee_share", &WalkingController::knee_share, "speed"_a,
           "Share of the knee's torque limit that its own rotor and damping take at lift-off, walking at speed [m/s].")
      .def_property_readonly(
          "speed_limit", [](const WalkingController& c) { return c.reach().speed_limit(); },
          "largest v_x that the legs reach [m/s]")
      .def("plan_mismatch", &WalkingController::plan_mismatch, "duration"_a,
           "Largest speed of the footsteps minus the planned one within `duration` [s]; 0 where steps follow the "
           "profile [m/s].")
      .def(
          "plan",
          [](const WalkingController& c, double duration, double dt) {
            const WalkPlan plan = c.plan(duration, dt);
            const auto rows = [](const std::vector<Vec2>& v) {
              RowMatX out(static_cast<Eigen::Index>(v.size()), 2);
              for (std::size_t i = 0; i < v.size(); ++i) out.row(static_cast<Eigen::Index>(i)) = v[i];
              return out;
            };
            py::list steps;
            for (const WalkPlan::Step& step : plan.steps) {
              py::dict each;
              each["foot"] = step.foot == kLeft ? "left" : "right";
              each["lift_off"] = step.lift_off;
              each["touch_down"] = step.touch_down;
              each["place"] = Vec3(step.place.p.x(), step.place.p.y(), step.place.yaw);
              steps.append(each);
            }
            py::dict out;
            out["t"] = VecX(Eigen::Map<const VecX>(plan.t.data(), static_cast<Eigen::Index>(plan.t.size())));
            out["com"] = rows(plan.com);
            out["dcom"] = rows(plan.dcom);
            out["zmp"] = rows(plan.zmp);
            out["support"] = py::array(py::cast(plan.support));
            out["steps"] = steps;
            return out;
          },
          "duration"_a = 3.2, "dt"_a = 0.01,
          "Footsteps, COM and ZMP ahead of time, for a robot that does as it is told, from where the last reset "
          "was.\n\n"
          "Args:\n    duration: [s].\n    dt: time step of the plan [s].\n\n"
          "Returns:\n    dict: t (T,) [s], com, dcom, zmp (T, 2) [m, m/s], W; support (T,), +1 left, -1 right; steps, "
          "a "
          "list of dicts\n    foot, lift_off, touch_down [s], place (x, y, yaw).\n\nRaises:\n    InputError.")
      .def(
          "zmp_bounds",
          [](const WalkingController& c, const std::string& side) {
            if (side != "left" && side != "right")
              throw InputError("side = '" + side + "' is unknown; there are: left, right");
            const ZmpBounds& b = c.bounds(side == "left" ? kLeft : kRight);
            return std::make_pair(b.lower, b.upper);
          },
          "side"_a, "Designed bounds (lower, upper), each (2,), in the sole's axes about its centre [m].");
}
