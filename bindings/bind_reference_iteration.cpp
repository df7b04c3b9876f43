#include "common.hpp"

void bind_reference_iteration(py::module_&) {}
