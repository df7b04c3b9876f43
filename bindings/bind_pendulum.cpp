#include "common.hpp"

void bind_pendulum(py::module_&) {}
