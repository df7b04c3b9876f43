#include "zmpwalk/control/dynamics.hpp"

namespace zmpwalk {

Dynamics::Dynamics(int nv)
    : q(VecX::Zero(nv - 6)),
      dq(VecX::Zero(nv)),
      A(RowMatX::Zero(nv, nv)),
      A_sparsity(nv),
      b(VecX::Zero(nv)),
      g(VecX::Zero(nv)),
      drift_momentum(VecX::Zero(nv)),
      J_com(Mat3X::Zero(3, nv)) {
  for (FrameState& s : sole) s.J = Mat6X::Zero(6, nv);
}

}  // namespace zmpwalk
