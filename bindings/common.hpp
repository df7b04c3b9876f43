#pragma once

#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/robot/mujoco.hpp"
#include "zmpwalk/simulation/recorder.hpp"

namespace py = pybind11;
using namespace pybind11::literals;

/// The foot of that name.
/// @throws InputError  it is neither left nor right
zmpwalk::Side side_of(const std::string& support);

// MuJoCo's Python objects give their C pointer as `_address`.
zmpwalk::Model model_of(const py::object& model);
zmpwalk::Data data_of(const py::object& data);
/// Joint name -> how its torque reaches MuJoCo.
py::dict torque_path(const zmpwalk::Robot& robot);

/// NumPy arrays that take the columns' memory over, (T,) or (T, width).
py::dict take_columns(std::vector<zmpwalk::Column>&& columns);

/// Calls a Python function from a loop that has let go of the interpreter; lets Ctrl-C through where there is none.
class PythonProgress {
 public:
  PythonProgress(py::object on_progress, double duration) : on_progress_(std::move(on_progress)), duration_(duration) {}
  /// False once Python has raised something.
  bool operator()(double t);
  /// Raises what Python raised.
  void rethrow() const {
    if (raised_) throw py::error_already_set();
  }

 private:
  py::object on_progress_;
  double duration_;
  bool raised_ = false;
};

void bind_errors(py::module_& m);
void bind_mujoco(py::module_& m);
void bind_settings(py::module_& m);
void bind_velocity_profile(py::module_& m);
void bind_joint_motion(py::module_& m);
void bind_description(py::module_& m);
void bind_dynamics(py::module_& m);
void bind_contact_space(py::module_& m);
void bind_task_space(py::module_& m);
void bind_tasks(py::module_& m);
void bind_whole_body(py::module_& m);
void bind_plane(py::module_& m);
void bind_known_ground(py::module_& m);
void bind_estimate(py::module_& m);
void bind_reference_iteration(py::module_& m);
void bind_pendulum(py::module_& m);
void bind_velocity_tracker(py::module_& m);
void bind_gait_generator(py::module_& m);
void bind_state(py::module_& m);
void bind_walking_controller(py::module_& m);
void bind_simulation(py::module_& m);
void bind_kernel(py::module_& m);
void bind_benchmark(py::module_& m);
