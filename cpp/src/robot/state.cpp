#include "zmpwalk/robot/state.hpp"

#include <cmath>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

void require_state(const State& state, int nv) {
  constexpr double kLeastLength = 1e-6;  // shorter, a quaternion says nothing about the direction of the base
  require_size("state.q", state.q.size(), nv + 1);
  require_size("state.dq", state.dq.size(), nv);
  if (!state.q.allFinite() || !state.dq.allFinite() || !std::isfinite(state.time))
    throw InputError("the state holds a time, position or velocity that is not finite");
  if (const double length = state.q.segment<4>(3).norm(); !(length > kLeastLength))
    throw InputError("the base's quaternion, state.q[3:7], has the length " + std::to_string(length) +
                     "; it must have the length 1, as (w, x, y, z) = (1, 0, 0, 0) of an upright base has");
}

}  // namespace zmpwalk
