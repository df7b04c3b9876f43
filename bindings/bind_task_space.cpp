#include "common.hpp"

void bind_task_space(py::module_&) {}
