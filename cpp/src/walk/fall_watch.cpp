#include "zmpwalk/walk/fall_watch.hpp"

#include <algorithm>
#include <cmath>

namespace zmpwalk {

FallWatch::FallWatch(const WalkSettings& settings) : height_share_(settings.fall.height), tilt_(settings.fall.tilt) {}

void FallWatch::reset(const Mat3& R_HB, double com_height) {
  R_HB_ = R_HB;
  com_height_ = com_height;
}

Fall FallWatch::check(const Dynamics& dyn, double floor) const {
  const double height = dyn.com.z() - floor;
  const double tilt = std::acos(std::clamp((dyn.R_WB * R_HB_.transpose())(2, 2), -1.0, 1.0));
  if (height < height_share_ * com_height_) return Fall::kHeight;
  if (tilt > tilt_) return Fall::kTilt;
  return Fall::kNone;
}

}  // namespace zmpwalk
