#include "zmpwalk/walk/cycle.hpp"

namespace zmpwalk {

Cycle cycle_of(double t, const Dynamics& dynamics, const GaitOutput& gait, const LinearInvertedPendulum& pendulum,
               const Vec2& com, const Vec2& dcom, const Vec2& shift) {
  Cycle c;
  c.t = t;
  c.dynamics = &dynamics;
  c.gait = &gait;
  c.pendulum = &pendulum;
  c.R_WS = axes_of(gait.ahead_S);
  c.R_WH = axes_of(gait.ahead);
  c.shift = shift;
  c.com_S = c.to_S(com + shift);
  c.dcom_S = c.R_WS.transpose() * dcom;
  c.com_meas_S = c.to_S(dynamics.com.head<2>() + shift);
  c.dcom_meas_S = c.R_WS.transpose() * dynamics.dcom.head<2>();
  return c;
}

}  // namespace zmpwalk
