#include "common.hpp"

namespace {

/// pybind11 makes the memory of an object without a value by this: it is asked where `__init__` has not run.
void* no_value(std::size_t) {
  throw py::type_error("this object has no value yet: its __init__ was not called; call super().__init__() first");
}

/// How an object goes into another process, under every protocol: by its class and its state, or not at all.
py::object reduced(const py::object& self) {
  const py::type cls = py::type::of(self);
  if (!py::hasattr(cls, "__setstate__"))
    throw py::type_error("cannot pickle or copy '" + std::string(py::str(cls.attr("__name__"))) +
                         "' object: send what it was made from, such as a robot's name, settings and a profile, and "
                         "make it anew there");
  return py::make_tuple(py::module_::import("copyreg").attr("__newobj__"), py::make_tuple(cls),
                        self.attr("__getstate__")());
}

void harden_classes(const py::module_& m) {
  for (const auto& [name, value] : py::reinterpret_borrow<py::dict>(m.attr("__dict__"))) {
    if (!PyType_Check(value.ptr())) continue;
    auto* type = reinterpret_cast<PyTypeObject*>(value.ptr());
    py::detail::type_info* info = py::detail::get_type_info(type);
    if (!info) continue;
    info->operator_new = no_value;
    py::setattr(value, "__reduce__", py::cpp_function(reduced, py::is_method(value), py::name("__reduce__")));
  }
}

}  // namespace

PYBIND11_MODULE(_core, m) {
  m.doc() = "zmpwalk's C++ core: contact-consistent control, ZMP estimate, gait, and the walking loop.";
  bind_errors(m);
  bind_mujoco(m);
  bind_settings(m);
  bind_velocity_profile(m);
  bind_description(m);
  bind_dynamics(m);
  bind_joint_motion(m);
  bind_contact_space(m);
  bind_task_space(m);
  bind_plane(m);
  bind_known_ground(m);
  bind_tasks(m);
  bind_whole_body(m);
  bind_estimate(m);
  bind_reference_iteration(m);
  bind_pendulum(m);
  bind_velocity_tracker(m);
  bind_gait_generator(m);
  bind_state(m);
  bind_walking_controller(m);
  bind_simulation(m);
  bind_kernel(m);
  bind_benchmark(m);
  harden_classes(m);
}
