#pragma once

#include <mujoco/mujoco.h>
#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>

#include "zmpwalk/math/error.hpp"

namespace py = pybind11;
using namespace pybind11::literals;

// MuJoCo's Python objects give their C pointer as `_address`.
const mjModel* model_of(const py::object& model);
mjData* data_of(const py::object& data);

void bind_errors(py::module_& m);
void bind_settings(py::module_& m);
void bind_velocity_profile(py::module_& m);
void bind_description(py::module_& m);
void bind_dynamics(py::module_& m);
void bind_contact_space(py::module_& m);
void bind_task_space(py::module_& m);
void bind_whole_body(py::module_& m);
void bind_estimate(py::module_& m);
void bind_reference_iteration(py::module_& m);
void bind_pendulum(py::module_& m);
void bind_velocity_tracker(py::module_& m);
void bind_gait_generator(py::module_& m);
void bind_walking_controller(py::module_& m);
void bind_simulation(py::module_& m);
