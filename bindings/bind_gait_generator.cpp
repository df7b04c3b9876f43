#include "common.hpp"

void bind_gait_generator(py::module_&) {}
