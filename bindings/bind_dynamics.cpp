#include "common.hpp"

void bind_dynamics(py::module_&) {}
