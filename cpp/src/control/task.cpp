#include "zmpwalk/control/task.hpp"

#include <cmath>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

void require_gain(const char* name, double gain) {
  if (!(std::isfinite(gain) && gain >= 0.0))
    throw InputError(std::string(name) + " = " + std::to_string(gain) + "; a gain is finite and not negative");
}

}  // namespace zmpwalk
