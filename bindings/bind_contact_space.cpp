#include "common.hpp"

void bind_contact_space(py::module_&) {}
