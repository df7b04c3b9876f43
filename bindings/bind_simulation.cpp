#include <iterator>
#include <optional>
#include <sstream>

#include "busy.hpp"
#include "common.hpp"
#include "zmpwalk/robot/contact_forces.hpp"
#include "zmpwalk/robot/words.hpp"
#include "zmpwalk/simulation.hpp"

using namespace zmpwalk;

py::dict take_columns(std::vector<Column>&& columns) {
  py::dict out;
  for (Column& column : columns) {
    std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(column.values.size()) / column.width};
    if (column.width > 1) shape.push_back(column.width);
    auto* values = new std::vector<double>(std::move(column.values));
    const py::capsule owner(values, [](void* p) { delete static_cast<std::vector<double>*>(p); });
    out[column.name.c_str()] = py::array_t<double>(shape, values->data(), owner);
  }
  return out;
}

bool PythonProgress::operator()(double t) {
  py::gil_scoped_acquire locked;
  raised_ = PyErr_CheckSignals() != 0;  // Ctrl-C
  if (raised_ || on_progress_.is_none()) return !raised_;
  PyObject* answer = PyObject_CallFunction(on_progress_.ptr(), "dd", t, duration_);
  raised_ = answer == nullptr;
  Py_XDECREF(answer);
  return !raised_;
}

namespace {

/// Asks a Python function for the velocity to walk with. Its StopIteration ends the walk in good order.
class PythonCommand {
 public:
  PythonCommand(WalkingController& controller, py::object f) : controller_(controller), f_(std::move(f)) {}
  bool operator()(const CycleOutput& out) {
    py::gil_scoped_acquire locked;
    const Busy::Pause pause(controller_);
    try {
      const py::object v = f_(out.t, py::cast(out, py::return_value_policy::copy));
      if (!v.is_none()) controller_.command(v.cast<Vec3>());
    } catch (const py::error_already_set& error) {
      if (!error.matches(PyExc_StopIteration)) error_ = std::current_exception();
      return false;
    } catch (...) {
      error_ = std::current_exception();
      return false;
    }
    return true;
  }
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  WalkingController& controller_;
  py::object f_;
  std::exception_ptr error_;
};

OnFall on_fall_of(const std::string& word) {
  if (word == "stop") return OnFall::kStop;
  if (word == "go_on") return OnFall::kGoOn;
  throw InputError("on_fall is '" + word + "'; it must be stop or go_on");
}

py::tuple run(Simulation& simulation, WalkingController& controller, double duration, const py::object& on_progress,
              const py::object& command, double command_interval, OnFall on_fall, bool only_last = false) {
  require_positive("duration", duration);
  const Busy busy(controller, "run");
  Recorder recorder(controller, duration, only_last);
  PythonProgress progress(on_progress, duration);
  PythonCommand steer(controller, command);
  std::function<bool(const CycleOutput&)> after_cycle;
  if (!command.is_none()) after_cycle = std::ref(steer);
  RunResult result;
  {
    py::gil_scoped_release unlocked;
    const auto report = [&](double t) {
      const py::gil_scoped_acquire locked;
      const Busy::Pause pause(controller);
      return progress(t);
    };
    result = simulation.run(duration, recorder, report, 0.05, after_cycle, command_interval, on_fall);
  }
  progress.rethrow();
  steer.rethrow();
  py::dict info;
  info["fell"] = result.fell != Fall::kNone;
  info["fall_time"] = result.fall_time;
  info["fall_cause"] = to_string(result.fell);
  info["alarm_time"] = result.alarm_time;
  info["alarm_cause"] = result.alarm_text;
  info["stopped"] = result.stopped;
  info["wall_time"] = result.wall_time;
  std::vector<Column> times;
  times.push_back({"cycle_us", 1, std::move(result.cycle_us)});
  info.attr("update")(take_columns(std::move(times)));
  return py::make_tuple(take_columns(recorder.take_columns()), info);
}

/// A simulation that keeps the controller it steps, as Python sees it.
struct PySimulation : Simulation {
  PySimulation(WalkingController& c, const Uncertainty& uncertainty, const py::object& model)
      : Simulation(c, uncertainty, model.is_none() ? std::nullopt : std::optional<Model>(model_of(model))),
        controller(c),
        simulated(model) {}
  WalkingController& controller;
  py::object simulated;
};

}  // namespace

void bind_simulation(py::module_& m) {
  py::class_<RecordedColumn>(m, "RecordedColumn", "What a recorded column is: one row of `recorded_columns`.")
      .def_readonly("name", &RecordedColumn::name, "Name of the column in a Trace, and of the property of CycleOutput.")
      .def_property_readonly(
          "width",
          [](const RecordedColumn& c) { return c.parts.and_nv ? std::nullopt : std::optional<int>(c.parts.count); },
          "How many numbers a row holds; None where the robot says how many.")
      .def_property_readonly(
          "size",
          [](const RecordedColumn& c) { return c.parts.and_nv ? c.parts.names : std::to_string(c.parts.count); },
          "The same in words: \"3\", \"joints\", \"nv + 1\".")
      .def_property_readonly(
          "parts",
          [](const RecordedColumn& c) {
            std::istringstream words(c.parts.and_nv ? "" : c.parts.names);
            return std::vector<std::string>(std::istream_iterator<std::string>(words), {});
          },
          "Names of the numbers in a row; empty where there is one, or where the robot says how many.")
      .def_readonly("unit", &RecordedColumn::unit, "SI unit of the numbers; empty where they have none.")
      .def_readonly("frame", &RecordedColumn::frame,
                    "Frame in which the numbers are given: W, the world; H, turned into the planned heading; S, the "
                    "axes of the\nsupport sole. It is empty where they have none.")
      .def_readonly("meaning", &RecordedColumn::meaning, "What the numbers mean, in a sentence.")
      .def_readonly("decided", &RecordedColumn::decided,
                    "Whether the cycle decides it, so that it is a property of CycleOutput too; else it is known only "
                    "after the step.")
      .def("__repr__", [](const RecordedColumn& c) { return "RecordedColumn(" + c.name + ": " + c.meaning + ")"; });
  m.def("recorded_columns", &recorded_columns, "The table of everything that is recorded, in the order of the record.");
  py::class_<Recorder>(
      m, "Recorder",
      "Keeps what cycles record as columns. Row k holds the state before step k and what was decided for it.")
      .def(py::init([](const WalkingController& c) { return std::make_unique<Recorder>(c); }), "controller"_a,
           py::keep_alive<1, 2>())
      .def(
          "add", [](Recorder& r, const CycleOutput& out, const py::object& data) { r.add(out, data_of(data)); },
          "out"_a, "data"_a,
          "Adds one row. Call it right after mj_step, while `data` holds the contact forces of this cycle. A cycle "
          "that held "
          "an earlier torque adds none.")
      .def(
          "columns", [](const Recorder& r) { return take_columns(std::vector<Column>(r.columns())); },
          "Columns by name, (T,) or (T, n): a copy.")
      .def("__len__", &Recorder::rows);

  py::class_<SensorNoise>(m, "SensorNoise", "Standard deviations of what is measured; white and Gaussian.")
      .def(py::init<>())
      .def_readwrite("joint", &SensorNoise::joint, "Joint positions [rad].")
      .def_readwrite("joint_speed", &SensorNoise::joint_speed, "[rad/s]")
      .def_readwrite("gyro", &SensorNoise::gyro, "Angular velocity of the base [rad/s].")
      .def_readwrite("attitude", &SensorNoise::attitude, "Of the base, about each of its axes [rad].")
      .def_readwrite("base_speed", &SensorNoise::base_speed, "Along each axis [m/s].");
  py::class_<Uncertainty>(
      m, "SignalUncertainty",
      "What lies between a robot and its controller: noise, bias, delays, lag. `zmpwalk.Uncertainty` "
      "makes it.")
      .def(py::init<>())
      .def_readwrite("noise", &Uncertainty::noise, "Of the sensors.")
      .def_readwrite("roll_bias", &Uncertainty::roll_bias, "Of the measured attitude, about the base's x [rad].")
      .def_readwrite("pitch_bias", &Uncertainty::pitch_bias, "The same about its y [rad].")
      .def_readwrite("state_delay", &Uncertainty::state_delay, "Age of what is measured [s].")
      .def_readwrite("torque_delay", &Uncertainty::torque_delay, "From a torque's decision to its effect [s].")
      .def_readwrite("lag", &Uncertainty::lag, "Time constant with which a drive takes a torque up [s].")
      .def_readwrite("seed", &Uncertainty::seed, "Of the noise.");
  py::class_<PySimulation>(m, "Simulation",
                           "The closed loop in C++ from the start pose, the interpreter's lock released. It may be run "
                           "in several stretches.")
      .def(py::init<WalkingController&, const Uncertainty&, const py::object&>(), "controller"_a,
           "uncertainty"_a = Uncertainty(), "simulated"_a = py::none(), py::keep_alive<1, 2>(),
           "Args:\n    uncertainty: what lies between robot and controller.\n    simulated: the model that is "
           "simulated, None where it is the controller's.\n\nRaises:\n    ModelError, InputError.")
      .def(
          "push",
          [](PySimulation& s, double t, double duration, const std::string& body, const Vec6& wrench) {
            s.push({t, duration, body, wrench});
          },
          "t"_a, "duration"_a, "body"_a, "wrench"_a,
          "A constant force and torque on a body, at its centre of mass, in [t, t + duration).\n\nArgs:\n    t, "
          "duration: [s].\n"
          "    body: a name; \"\" takes the trunk.\n    wrench: force, then torque, world axes (6,) [N, N "
          "m].\n\nRaises:\n    InputError.")
      .def(
          "run",
          [](PySimulation& s, double duration, const py::object& on_progress, const py::object& command,
             double command_interval, const std::string& on_fall, bool only_last) {
            return run(s, s.controller, duration, on_progress, command, command_interval, on_fall_of(on_fall),
                       only_last);
          },
          "duration"_a, "on_progress"_a = py::none(), "command"_a = py::none(), "command_interval"_a = 0.02,
          "on_fall"_a = "stop", "only_last"_a = false,
          "Walks on for `duration`.\n\n"
          "Args:\n    duration: [s].\n    on_progress: called as f(t, duration) about 20 times a second; may raise.\n"
          "    command: called as f(t, out) after the first cycle and then every `command_interval` [s]; returns\n"
          "        (vx, vy, wz) or None, which leaves the command as it is; StopIteration ends the run.\n"
          "    on_fall: \"stop\" ends where the controller says that the robot has fallen, \"go_on\" only where it "
          "lies on the ground.\n"
          "    only_last: return the last row of the columns alone, for a caller who looks at the walk now and "
          "then.\n\n"
          "Returns:\n    (columns, info) of this stretch.\n\nRaises:\n    InputError; whatever a callback raises; "
          "KeyboardInterrupt.")
      .def_property_readonly("time", [](PySimulation& s) { return *s.data().time; }, "Simulated time [s].");
  m.def(
      "simulate",
      [](WalkingController& controller, double duration, const py::object& on_progress, const py::object& command,
         double command_interval) {
        require_positive("duration", duration);
        Simulation simulation(controller);
        return run(simulation, controller, duration, on_progress, command, command_interval, OnFall::kStop);
      },
      "controller"_a, "duration"_a, "on_progress"_a = py::none(), "command"_a = py::none(), "command_interval"_a = 0.02,
      "A whole walk: `Simulation(controller).run(duration, ...)`.\n\nRaises:\n    as there.");
  m.def(
      "trunk_body",
      [](const WalkingController& controller) {
        return object_name(controller.robot().model(), mj::kBody, trunk_body(controller.robot()));
      },
      "controller"_a, "Name of the body that a push is given to where none is named.");
  m.def(
      "measured_zmp",
      [](const py::object& model, const py::object& data, const RobotDescription& description,
         const std::optional<Plane>& plane) {
        const Robot robot(model_of(model), description);
        const MeasuredContact contact = measure_contact(robot, data_of(data));
        return plane ? measured_zmp(contact, *plane) : measured_zmp(contact);
      },
      "model"_a, "data"_a, "description"_a, "plane"_a = py::none(),
      "World x and y of the ZMP of MuJoCo's contact forces under the feet (2,) [m]; NaN without contact.\n\n"
      "After mj_step it belongs to the state before it.\n\nArgs:\n    plane: Plane that it is taken on. None: the "
      "level "
      "plane at the height of the soles, weighted by their loads.");
}
