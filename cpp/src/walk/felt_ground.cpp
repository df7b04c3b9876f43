#include "zmpwalk/walk/felt_ground.hpp"

#include <cmath>

namespace zmpwalk {
namespace {

/// How far `p` is over the plane of known ground at `place` [m].
double height_over(const SolePlace& place, const Vec3& p) {
  return p.z() - place.height - place.rise.dot(p.head<2>() - place.at.p);
}

// Shares of z_c by which soles on even ground differ in height.
constexpr double kHigher = 0.005;
constexpr double kLower = 0.010;  // feet with soft contacts sink where they are jumped on
// ZMP against the rotation of a rocking sole, share of z_c T_c: at half of it soles rock twice as fast.
constexpr double kSteady = 0.05;
// The same for the inertia of a foot that turns about its ankle, share of I / (m g T_c): heavy rotors swing further.
constexpr double kHeavy = 3.2;
// Times in T_c.
constexpr double kFollow = 0.36;  // time constant of the height that is followed
constexpr double kCalm = 18.0;    // so long a ground must stay level to count as even

}  // namespace

FeltGround::FeltGround(const WalkSettings& settings, const SoleSize& sole, double z_c, double Tc, double inertia)
    : sole_(sole),
      plan_(settings.control.dt, Tc),
      feels_(settings.gait.touch_down == TouchDown::kFelt),
      dt_(settings.control.dt),
      higher_(kHigher * z_c),
      lower_(kLower * z_c),
      time_(kFollow * Tc),
      calm_time_(kCalm * Tc),
      damping_(kSteady * z_c * Tc + kHeavy * inertia / Tc) {}

void FeltGround::reset(double height) {
  start_ = height;
  uneven_ = false;
  h_ = dh_ = ddh_ = level_ = calm_ = 0.0;
  plan_.reset(height);
}

void FeltGround::update(const GaitOutput& gait, const Dynamics& dynamics, double period) {
  if (gait.known) plan_.update(gait, period);
  if (!feels_) return;
  const auto known = [&](Side side) {
    return side == gait.swing && !gait.standing[side] ? gait.place : gait.under[side];
  };
  // A sole that rocks on its own edge over even ground lifts its middle, but not its lowest corner.
  const auto lowest = [&](Side side) {
    const Mat3& R = dynamics.sole[side].R_WF;
    const Vec3& p = dynamics.sole[side].p_WF;
    if (!gait.known) return p.z() - 0.5 * (std::abs(R(2, 0)) * sole_.length + std::abs(R(2, 1)) * sole_.width);
    const SolePlace ground = known(side);
    const auto over = [&](const Vec3& along) { return std::abs(along.z() - ground.rise.dot(along.head<2>())); };
    return start_ + height_over(ground, p) - 0.5 * (over(R.col(0)) * sole_.length + over(R.col(1)) * sole_.width);
  };
  const auto differs = [&](double rise) { return rise > higher_ || rise < -lower_; };
  const double carries = lowest(gait.support) - start_;
  // A foot that meets even ground early meets it at its height.
  if (differs(carries - level_) || (gait.off_time && differs(lowest(gait.swing) - start_ - level_))) {
    uneven_ = true;
    calm_ = 0.0;
    level_ = carries;
  }
  if (!uneven_) return;
  const Vec3& stands = dynamics.sole[gait.support].p_WF;
  const double off = gait.known ? height_over(known(gait.support), stands) : stands.z() - start_;
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

Vec2 FeltGround::steadying(const GaitOutput& gait, const Dynamics& dynamics) const {
  if (!uneven_ || gait.phase.phase != Phase::kSingleSupport) return Vec2::Zero();
  const Vec6& v = dynamics.sole[gait.support].velocity;
  return {-damping_ * v[4], damping_ * v[3]};
}

}  // namespace zmpwalk
