#pragma once

#include <string>
#include <vector>

#include "zmpwalk/control/kernel.hpp"

namespace zmpwalk {

/// The builds that this processor runs, the plainest first, the best last. Made at load; never empty.
const std::vector<const Kernel*>& kernels();

/// The build of that name, or the best for "auto".
/// @throws InputError  an unknown name, or one that this processor does not run; says which it does.
const Kernel& kernel(const std::string& name = "auto");

}  // namespace zmpwalk
