#include "zmpwalk/walk/height_plan.hpp"

#include <algorithm>

namespace zmpwalk {
namespace {

// Times in T_c.
constexpr double kLeastLeft = 0.6;  // a height this near its end goes on along its rate: the cubic would become stiff
constexpr double kStands = 1.0;     // time constant with which a robot at rest comes to the middle of its feet

}  // namespace

void HeightPlan::reset(double start) {
  start_ = start;
  h_ = dh_ = ddh_ = 0.0;
}

void HeightPlan::update(const GaitOutput& gait, double period) {
  const GaitPhase& phase = gait.phase;
  const bool single = phase.phase == Phase::kSingleSupport;
  double end, rate = 0.0, left;
  if (gait.at_rest) {
    end = 0.5 * (gait.under[kLeft].height + gait.under[kRight].height) - start_;
    const double time = kStands * Tc_;
    ddh_ = ((end - h_) / time - 2.0 * dh_) / time;
  } else {
    const Side stance = other(gait.swing);
    const double z = gait.under[stance].height;
    // Before the middle of a double support the foot that swings next is the one behind.
    const bool before = !single && phase.time < 0.5 * phase.duration;
    const double z_0 = before ? gait.under[gait.swing].height : z, z_1 = before ? z : gait.place.height;
    end = 0.5 * (z_0 + z_1) - start_;
    rate = (z_1 - z_0) / period;
    left = before ? 0.5 * phase.duration - phase.time : phase.to_mid_double;
    const double least = kLeastLeft * Tc_;
    if (left < least) {
      end += rate * (least - left);
      left = least;
    }
    ddh_ = 6.0 * (end - h_) / (left * left) - (4.0 * dh_ + 2.0 * rate) / left;
  }
  h_ += dh_ * dt_;
  dh_ += ddh_ * dt_;
}

}  // namespace zmpwalk
