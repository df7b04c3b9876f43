#include "common.hpp"

namespace {

/// The Python classes live in zmpwalk.errors; C++ errors become them.
py::object error_class(const char* name) { return py::module_::import("zmpwalk.errors").attr(name); }

}  // namespace

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
