#include "common.hpp"

void bind_whole_body(py::module_&) {}
