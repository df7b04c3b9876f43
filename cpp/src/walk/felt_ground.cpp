#include "zmpwalk/walk/felt_ground.hpp"

#include <cmath>

namespace zmpwalk {
namespace {

constexpr double kBand = 0.005;    // share of z_c by which soles on even ground differ in height
constexpr double kFlat = 0.99995;  // cosine of the tilt up to which a sole stands flat: 0.01 rad
// Times in T_c.
constexpr double kFollow = 0.36;  // time constant of the height that is followed
constexpr double kCalm = 18.0;    // so long a ground must stay level to count as even

}  // namespace

FeltGround::FeltGround(const WalkSettings& settings, double z_c, double Tc)
    : feels_(settings.gait.touch_down == TouchDown::kFelt),
      dt_(settings.control.dt),
      band_(kBand * z_c),
      time_(kFollow * Tc),
      calm_time_(kCalm * Tc) {}

void FeltGround::reset(double height) {
  start_ = height;
  uneven_ = false;
  h_ = dh_ = ddh_ = level_ = calm_ = 0.0;
}

void FeltGround::update(const GaitOutput& gait, const Dynamics& dynamics) {
  if (!feels_) return;
  const FrameState& sole = dynamics.sole[gait.support];
  const double off = sole.p_WF.z() - start_;
  const auto differs = [&](Side side) { return std::abs(dynamics.sole[side].p_WF.z() - start_ - level_) > band_; };
  // A sole that rocks on an edge of its own lifts its middle, and a foot that meets even ground early meets it at its height.
  const bool flat = sole.R_WF(2, 2) > kFlat;
  if ((gait.off_time && (differs(kLeft) || differs(kRight))) || (flat && differs(gait.support))) {
    uneven_ = true;
    calm_ = 0.0;
    level_ = off;
  }
  if (!uneven_) return;
  ddh_ = ((off - h_) / time_ - 2.0 * dh_) / time_;
  h_ += dh_ * dt_;
  dh_ += ddh_ * dt_;
  calm_ += dt_;
  if (calm_ < calm_time_) return;
  // Level ground at this height: it is what an even walk starts from.
  uneven_ = false;
  start_ += h_;
  level_ = h_ = dh_ = ddh_ = 0.0;
}

}  // namespace zmpwalk
