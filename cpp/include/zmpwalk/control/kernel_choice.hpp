#pragma once

#include <string>
#include <vector>

#include "zmpwalk/control/kernel.hpp"

namespace zmpwalk {

/// The builds of the inner loops that this processor runs: the plainest first, the best last. The list is made at load and is never empty.
const std::vector<const Kernel*>& kernels();

/// The build of that name, or the best for "auto".
/// @throws InputError  the name is unknown, or this processor does not run that build; the message names those that it runs
const Kernel& kernel(const std::string& name = "auto");

}  // namespace zmpwalk
