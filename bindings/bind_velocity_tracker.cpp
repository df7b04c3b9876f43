#include "common.hpp"

void bind_velocity_tracker(py::module_&) {}
