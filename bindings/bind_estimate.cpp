#include "common.hpp"

void bind_estimate(py::module_&) {}
