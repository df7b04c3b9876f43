#include <pybind11/numpy.h>

#include "common.hpp"
#include "zmpwalk/robot/contact_forces.hpp"
#include "zmpwalk/robot/mujoco_compat.hpp"
#include "zmpwalk/simulation.hpp"

using namespace zmpwalk;

namespace {

py::dict columns_of(const Recorder& recorder) {
  py::dict out;
  const auto rows = static_cast<py::ssize_t>(recorder.rows());
  for (const Column& column : recorder.columns()) {
    std::vector<py::ssize_t> shape{rows};
    if (column.width > 1) shape.push_back(column.width);
    out[column.name.c_str()] = py::array_t<double>(shape, column.values.data());
  }
  return out;
}

py::tuple run(WalkingController& controller, double duration, const py::object& on_progress) {
  require_positive("duration", duration);
  Recorder recorder(controller, duration);
  Simulation simulation(controller);
  bool raised = false;
  RunResult result;
  {
    py::gil_scoped_release unlocked;
    result = simulation.run(
        duration, recorder,
        [&](double t) {
          py::gil_scoped_acquire locked;
          raised = PyErr_CheckSignals() != 0;  // Ctrl-C
          if (raised || on_progress.is_none()) return !raised;
          PyObject* answer = PyObject_CallFunction(on_progress.ptr(), "dd", t, duration);
          raised = answer == nullptr;
          Py_XDECREF(answer);
          return !raised;
        },
        0.05);
  }
  if (raised) throw py::error_already_set();
  py::dict info;
  info["fell"] = result.fell != Fall::kNone;
  info["fall_time"] = result.fall_time;
  info["fall_cause"] = to_string(result.fell);
  info["wall_time"] = result.wall_time;
  info["cycle_us"] = py::array_t<double>(static_cast<py::ssize_t>(result.cycle_us.size()), result.cycle_us.data());
  return py::make_tuple(columns_of(recorder), info);
}

}  // namespace

void bind_simulation(py::module_& m) {
  py::class_<Recorder>(m, "Recorder",
                       "Cycle records as columns; row k is the state before step k and what was decided there.")
      .def(py::init([](const WalkingController& c) { return std::make_unique<Recorder>(c); }), "controller"_a,
           py::keep_alive<1, 2>())
      .def(
          "add", [](Recorder& r, const CycleOutput& out, const py::object& data) { r.add(out, data_of(data)); },
          "out"_a, "data"_a,
          "Adds one row; call right after mj_step, while `data` holds the contact forces of this cycle. Held cycles "
          "add none.")
      .def("columns", &columns_of, "Columns by name, (T,) or (T, n).")
      .def("__len__", &Recorder::rows);

  m.def("simulate", &run, "controller"_a, "duration"_a, "on_progress"_a = py::none(),
        "Closed loop in C++ from the start pose, the interpreter's lock released.\n\n"
        "Args:\n    controller: WalkingController.\n    duration: [s].\n    on_progress: called as f(t, duration) "
        "about 20 times a second; may raise.\n\n"
        "Returns:\n    (columns, info).\n\nRaises:\n    InputError; whatever on_progress raises; KeyboardInterrupt.");
  m.def(
      "measured_zmp",
      [](const py::object& model, const py::object& data, const RobotDescription& description) {
        const Robot robot(model_of(model), description);
        return measured_zmp(measure_contact(robot, data_of(data)));
      },
      "model"_a, "data"_a, "description"_a,
      "ZMP of MuJoCo's contact forces under the feet (2,) [m], W; NaN without contact. After mj_step it belongs to the "
      "state before it.");
  m.def("mujoco_version", &mujoco_compat::compiled_version, "MuJoCo version this module was compiled against.");
}
