#include "common.hpp"

namespace {

/// The Python classes live in zmpwalk.errors; C++ errors become them.
py::object error_class(const char* name) { return py::module_::import("zmpwalk.errors").attr(name); }

template <class MuJoCoStruct>
MuJoCoStruct* pointer_of(const py::object& object, const char* type) {
  const py::object wanted = py::module_::import("mujoco").attr(type);
  if (!py::isinstance(object, wanted))
    throw py::type_error(std::string("expected a mujoco.") + type + ", got " +
                         std::string(py::str(py::type::of(object).attr("__name__"))));
  return reinterpret_cast<MuJoCoStruct*>(object.attr("_address").cast<std::uintptr_t>());
}

}  // namespace

const mjModel* model_of(const py::object& model) { return pointer_of<mjModel>(model, "MjModel"); }
mjData* data_of(const py::object& data) { return pointer_of<mjData>(data, "MjData"); }

void bind_errors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr pointer) {
    if (!pointer) return;
    try {
      std::rethrow_exception(pointer);
    } catch (const zmpwalk::DimensionError& e) {
      PyErr_SetString(error_class("DimensionError").ptr(), e.what());
    } catch (const zmpwalk::InputError& e) {
      PyErr_SetString(error_class("InputError").ptr(), e.what());
    } catch (const zmpwalk::ModelError& e) {
      PyErr_SetString(error_class("ModelError").ptr(), e.what());
    } catch (const zmpwalk::Error& e) {
      PyErr_SetString(error_class("Error").ptr(), e.what());
    }
  });
}
