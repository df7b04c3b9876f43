#include "bind_tasks.hpp"
#include "busy.hpp"
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
  out.def_property_readonly(
      "foreseen_time", [](const CycleOutput& o) { return o.foreseen.time; },
      "Since when a fall is foreseen [s]; it is NaN where none is.");
  out.def_property_readonly(
      "foreseen_cause", [](const CycleOutput& o) { return to_string(o.foreseen); },
      "Why a fall is foreseen; it is empty where none is.");
  out.def("__copy__", [](const CycleOutput& o) { return CycleOutput(o); });
  out.def("__repr__", [](const CycleOutput& o) {
    const Eigen::IOFormat row(4, Eigen::DontAlignCols, ", ", ", ", "", "", "[", "]");
    std::ostringstream text;
    text << "CycleOutput(t=" << o.t << ", phase=" << (o.phase ? "single" : "double")
         << ", support=" << (o.support > 0 ? "left" : "right") << ", com=" << o.com.format(row)
         << ", zmp_est=" << o.zmp_est.format(row) << ", iterations=" << o.iterations << ")";
    return text.str();
  });

  py::class_<WalkingController>(
      m, "WalkingController",
      "The walking controller: update(data) takes the state of the robot and gives the joint torques.\n\n"
      "Each cycle takes eq. (16) for the desired COM state, (1)-(8) for the torque, (9)-(15) for the "
      "ZMP that it will produce, and III-B to correct it.")
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
          "reset",
          [](WalkingController& c, const PyState& state) {
            const Busy busy(c, "reset");
            c.reset(state);
          },
          "state"_a, "Starts a walk from a State, and moves nothing yet.")
      .def(
          "reset",
          [](WalkingController& c, const py::object& data) {
            const Busy busy(c, "reset");
            c.reset(data_of(data));
          },
          "data"_a,
          "Starts a walk from the state in `data`, and moves nothing yet.\n\nRaises:\n    InputError: the state is not "
          "finite.")
      .def(
          "state",
          [](const WalkingController& c, const py::object& data) {
            const Data d = data_of(data);
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
            const Busy busy(c, "update");
            PyState known = state;
            known.external = external_of(c, state.named);
            return c.update(known);
          },
          "state"_a, py::return_value_policy::copy,
          "Computes the torque for a State and returns it as `tau`; nothing outside the controller changes.")
      .def(
          "update",
          [](WalkingController& c, const py::object& data, bool after_step1, const py::object& external,
             const std::optional<Vec2>& contact) -> const CycleOutput& {
            const Busy busy(c, "update");
            Sensed sensed;
            sensed.external = external_of(c, external);
            if (contact) sensed.contact = {(*contact)[kLeft], (*contact)[kRight]};
            return c.update(data_of(data), after_step1 ? Terms::kInData : Terms::kCompute, sensed);
          },
          "data"_a, "after_step1"_a = false, "external"_a = py::none(), "contact"_a = py::none(),
          py::return_value_policy::copy,
          "Computes the torque for the state in `data`, writes the control that gives it into `data`, and returns what "
          "was "
          "decided (a copy).\n\n"
          "Args:\n    data: mujoco.MjData.\n    after_step1: True where mj_step1 (or mj_forward) has just run for this "
          "state, so that `data` holds kinematics,\n        inertia and bias forces already; the torque has the same "
          "bits, in half the time.\n    external: known forces on the robot, {body or site: (6,) force and moment at "
          "its frame's origin, "
          "world axes\n        [N, N m]}; None where there are none.\n    contact: (left, right), 1 where a foot "
          "touches the "
          "ground, 0 where it does not, NaN where it is unknown; None reads\n        the contacts of the last step "
          "from `data`, if the setting `touch_down` needs them.\n\n"
          "Raises:\n    InputError: the state is not finite, its terms belong to another, or reset() was not called; "
          "nothing is\n        changed.")
      .def(
          "command", [](WalkingController& c, double vx, double vy, double wz) { c.command(Vec3(vx, vy, wz)); }, "vx"_a,
          "vy"_a = 0.0, "wz"_a = 0.0, py::call_guard<py::gil_scoped_release>(),
          "Commands a velocity: from the next cycle on the robot walks with (vx, vy, wz) in the heading frame instead "
          "of the "
          "profile's\nvelocity, until reset().\n\n"
          "It may be called from any thread, at any time. A velocity that reach, torques or friction do not allow is "
          "scaled down "
          "(`within_limits`), and the\nrobot takes it up no faster than the settings forward_jump, "
          "forward_acceleration, ... allow.\n\n"
          "Args:\n    vx, vy: [m/s].\n    wz: [rad/s].\n\nRaises:\n    InputError: not finite.")
      .def(
          "reach_share", [](const WalkingController& c, const Vec3& velocity) { return c.reach().share(velocity); },
          "velocity"_a,
          "Share of the legs' reach that walking with velocity (v_x, v_y, w_z) uses; the robot can walk where it is at "
          "most 1.")
      .def(
          "within_reach", [](const WalkingController& c, const Vec3& velocity) { return c.reach().within(velocity); },
          "velocity"_a, "The velocity (v_x, v_y, w_z), made smaller until its reach_share is at most 1.")
      .def_property_readonly(
          "settings", [](const WalkingController& c) { return c.settings(); },
          "the WalkSettings of this walk; every NaN has the robot's value")
      .def(
          "know",
          [](WalkingController& c, const KnownGround& ground) {
            const Busy busy(c, "know");
            c.know(ground);
          },
          "ground"_a,
          "Tells the ground that the robot walks on. It counts from the next reset on, and heights count from those of "
          "the soles there.\n\nArgs:\n    ground: KnownGround; KnownGround() takes back what was told.")
      .def_property_readonly("ground", &WalkingController::ground, "what is known of the ground, a KnownGround")
      .def_property_readonly("profile", &WalkingController::profile)
      .def(
          "retime",
          [](WalkingController& c, double remaining) {
            require_between_cycles(c, "retime");
            c.retime(remaining);
          },
          "remaining"_a,
          "Lets the present phase, single or double support, end `remaining` [s] after the last cycle; the swing foot "
          "goes on "
          "from where\nit is without a jump. Call it between cycles.\n\nRaises:\n    InputError: not finite and > 0. "
          "A robot that stands "
          "stays as it is.")
      .def(
          "move",
          [](WalkingController& c, const JointMotion& motion) {
            require_between_cycles(c, "move");
            c.move(motion);
          },
          "motion"_a,
          "Lets joints outside the legs, and the trunk, follow `motion` from now on; see the package's "
          "WalkingController.")
      .def_property_readonly("motion", &WalkingController::motion)
      .def(
          "add",
          [](WalkingController& c, const std::shared_ptr<Task>& task, double blend) {
            require_between_cycles(c, "add");
            c.add(task, blend);
          },
          "task"_a, "blend"_a = kNaN,
          "Adds a task that the robot fulfils while it walks; see the package's WalkingController.")
      .def(
          "remove",
          [](WalkingController& c, const std::shared_ptr<Task>& task, double blend) {
            require_between_cycles(c, "remove");
            c.remove(*task, blend);
          },
          "task"_a, "blend"_a = kNaN, "Takes a task away; see the package's WalkingController.")
      .def_property_readonly("cycles", &WalkingController::cycles, "control cycles since the last reset")
      .def_property_readonly(
          "task_activations",
          [](const WalkingController& c) {
            std::vector<double> activations;
            for (const TaskStack::Entry& entry : c.added_tasks().entries()) activations.push_back(entry.activation);
            return activations;
          },
          "how far each added task acts now, from 0 to its weight, in the order of their priority")
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
          "joints that count as those of arms: they are outside the legs and carry less than a fifth of the robot's "
          "mass")
      .def_property_readonly(
          "torque_path", [](const WalkingController& c) { return torque_path(c.robot()); },
          "how each joint's torque reaches MuJoCo, by joint name: \"motor 'l_knee'\", \"qfrc_applied: position servo "
          "'l_knee' is silenced\", ...")
      .def_property_readonly(
          "torque_limit", [](const WalkingController& c) { return c.robot().torque_limit(); },
          "torque limit of each joint, infinite without (joints,) [N m]")
      .def_property_readonly(
          "mass", [](const WalkingController& c) { return c.robot().dynamics().mass; },
          "mass of the robot [kg]: that of the model, and as a walk finds it to be (`observer`)")
      .def_property_readonly("com_height", &WalkingController::com_height, "height z_c of the COM over the soles [m]")
      .def_property_readonly("Tc", &WalkingController::Tc, "time constant of the pendulum, sqrt(z_c / g) [s]")
      .def("knee_share", &WalkingController::knee_share, "speed"_a,
           "Share of the knee's torque limit that its own rotor and damping take as the foot lifts, at a walking speed "
           "[m/s].")
      .def_property_readonly(
          "speed_limit", [](const WalkingController& c) { return c.command_limit().axes()[0].most; },
          "largest v_x that reach, torques and friction allow [m/s]")
      .def_property_readonly(
          "speed_limits",
          [](const WalkingController& c) {
            py::dict limits;
            const char* names[] = {"forward", "backward", "sideways", "turning"};
            for (int i = 0; i < 4; ++i) {
              const AxisLimit& axis = c.command_limit().axes()[i];
              limits[names[i]] = py::make_tuple(axis.most, to_string(axis));
            }
            return limits;
          },
          "largest velocity forward, backward, sideways [m/s] and turning [rad/s], and what limits each, by name; "
          "together they bound a velocity: the sum of its |v| / most is at most 1")
      .def(
          "within_limits",
          [](const WalkingController& c, const Vec3& velocity) { return c.command_limit().within(velocity); },
          "velocity"_a,
          "The velocity (v_x, v_y, w_z) as command() takes it: made smaller until reach, torques and friction allow "
          "it.")
      .def("plan_mismatch", &WalkingController::plan_mismatch, "duration"_a,
           "Largest difference between the speed of the footsteps and the planned one within `duration` [s], in m/s; 0 "
           "where "
           "the steps follow the plan.")
      .def(
          "plan",
          [](const WalkingController& c, double duration, double dt) {
            const WalkPlan plan = c.plan(duration, dt);
            const auto rows = [](const std::vector<Vec2>& v) {
              RowMatX matrix(static_cast<Eigen::Index>(v.size()), 2);
              for (std::size_t i = 0; i < v.size(); ++i) matrix.row(static_cast<Eigen::Index>(i)) = v[i];
              return matrix;
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
            py::dict answer;
            answer["t"] = VecX(Eigen::Map<const VecX>(plan.t.data(), static_cast<Eigen::Index>(plan.t.size())));
            answer["com"] = rows(plan.com);
            answer["dcom"] = rows(plan.dcom);
            answer["zmp"] = rows(plan.zmp);
            answer["support"] = py::array(py::cast(plan.support));
            answer["steps"] = steps;
            return answer;
          },
          "duration"_a = 3.2, "dt"_a = 0.01,
          "Computes footsteps, COM and ZMP ahead of time, for a robot that follows them exactly, from the state of the "
          "last "
          "reset.\n\n"
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
          "side"_a, "Bounds of the ZMP (lower, upper), each (2,), in the sole's axes about its centre [m].");
}
