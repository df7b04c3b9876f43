#pragma once

#include "common.hpp"

/// Known forces by the names of the bodies or sites that they act on: {name: (6,)}, or None.
std::vector<zmpwalk::ExternalWrench> external_of(zmpwalk::WalkingController& controller, const py::object& external);
