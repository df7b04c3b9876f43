#include "zmpwalk/control/external.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

void apply_external(Dynamics& dynamics, const ExternalWrench& external) {
  if (external.frame < 0 || external.frame >= static_cast<int>(dynamics.frames.size()))
    throw InputError("a force acts at frame " + std::to_string(external.frame) + "; " +
                     std::to_string(dynamics.frames.size()) + " frames are watched");
  const FrameState& frame = dynamics.frames[external.frame];
  const Vec3 F = external.wrench.head<3>();
  dynamics.b.noalias() -= frame.J.transpose() * external.wrench;
  dynamics.F_ext += F;
  dynamics.M_ext += external.wrench.tail<3>() + (frame.p_WF - dynamics.com).cross(F);
}

void apply_disturbance(Dynamics& dynamics, const Disturbance& disturbance) {
  if (disturbance.none()) return;
  if (const double weight = disturbance.weight; weight != 1.0) {
    dynamics.mass *= weight;
    dynamics.A *= weight;
    dynamics.g *= weight;
    dynamics.b += (weight - 1.0) * dynamics.drift_momentum;
    dynamics.drift_momentum *= weight;
  }
  const Vec2 F = dynamics.mass * disturbance.acceleration;
  dynamics.b.noalias() -= dynamics.J_com.topRows<2>().transpose() * F;
  dynamics.F_ext.head<2>() += F;
}

ForcedPendulum forced_pendulum(const Dynamics& dynamics, double ground) {
  const Vec3 &F = dynamics.F_ext, &M = dynamics.M_ext;
  constexpr double kLeastLoad = 0.1;  // of the weight
  const double m = dynamics.mass, g = dynamics.gravity.norm(), F_z = std::min(F.z(), (1.0 - kLeastLoad) * m * g);
  const double N = m * g - F_z, h = dynamics.com.z() - ground;
  return {Vec2(M.y() + h * F.x(), h * F.y() - M.x()) / N, g - F_z / m};
}

}  // namespace zmpwalk
