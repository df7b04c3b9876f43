#include "zmpwalk/control/tasks/momentum.hpp"

#include "zmpwalk/control/momentum.hpp"
#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

MomentumTask::MomentumTask(Axes axes, double kd) : axes_(axes), kd_(kd) { require_gain("kd", kd); }

void MomentumTask::compute(const TaskInput& in, TaskRows& out) {
  const Dynamics& dyn = in.dynamics;
  const int first = 3 - rows();
  for (int i = 0; i < rows(); ++i) {
    const Vec3 axis = Vec3::Unit(first + i);
    momentum_row(dyn, axis, out.J.row(i));
    out.drift[i] = momentum_drift(dyn, axis);
    // The columns of the base's rotation are the inertia of the whole body, in base axes.
    const double L_ref = in.heading_rate * out.J.row(i).segment<3>(3).dot(dyn.R_WB.row(2));
    out.f_star[i] = kd_ * (L_ref - out.J.row(i).dot(dyn.dq));
  }
}

}  // namespace zmpwalk
