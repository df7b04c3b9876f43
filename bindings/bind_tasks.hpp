#pragma once

#include <map>
#include <string>

#include "common.hpp"
#include "zmpwalk/robot/state.hpp"

/// A State whose known forces are told by the names of the bodies or sites that they act on.
struct PyState : zmpwalk::State {
  using State::State;
  py::object named = py::none();
};

/// Known forces by the names of the bodies or sites that they act on: {name: (6,)}, or None.
std::vector<zmpwalk::ExternalWrench> external_of(zmpwalk::WalkingController& controller, const py::object& external);
