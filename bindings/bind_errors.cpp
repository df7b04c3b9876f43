#include "common.hpp"

namespace {

/// The Python classes live in zmpwalk.errors; C++ errors become them.
py::object error_class(const char* name) { return py::module_::import("zmpwalk.errors").attr(name); }

/// `wanted` keeps a class of the mujoco package, found at first use: an update from Python has no time for an import.
template <class MuJoCoStruct>
MuJoCoStruct* pointer_of(const py::object& object, const char* type, PyObject*& wanted) {
  if (!wanted) wanted = py::object(py::module_::import("mujoco").attr(type)).release().ptr();
  if (Py_TYPE(object.ptr()) != reinterpret_cast<PyTypeObject*>(wanted) && !py::isinstance(object, wanted))
    throw py::type_error(std::string("expected a mujoco.") + type + ", got " +
                         std::string(py::str(py::type::of(object).attr("__name__"))));
  static PyObject* const address = PyUnicode_InternFromString("_address");
  const auto number = py::reinterpret_steal<py::object>(PyObject_GetAttr(object.ptr(), address));
  if (!number) throw py::error_already_set();
  return reinterpret_cast<MuJoCoStruct*>(number.cast<std::uintptr_t>());
}

PyObject *model_class = nullptr, *data_class = nullptr;

}  // namespace

const mjModel* model_of(const py::object& model) { return pointer_of<mjModel>(model, "MjModel", model_class); }
mjData* data_of(const py::object& data) { return pointer_of<mjData>(data, "MjData", data_class); }

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
      const py::object type = error_class("ModelError");
      const py::object error = type(*py::cast(e.reasons));
      PyErr_SetObject(type.ptr(), error.ptr());
    } catch (const zmpwalk::Error& e) {
      PyErr_SetString(error_class("Error").ptr(), e.what());
    }
  });
}
