#include "zmpwalk/walk/leg_reach.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {
namespace {

/// No leg reaches so fast [m/s, rad/s]; the numbers of faster steps overflow.
constexpr double kFastest = 1e3;

void require_velocity(const Vec3& velocity) {
  if (!velocity.allFinite())
    throw InputError("velocity (" + velocity_text(velocity) +
                     ") is not finite; it is (v_x, v_y, w_z) [m/s, m/s, rad/s]");
}

}  // namespace

std::string velocity_text(const Vec3& v) {
  std::array<char, 96> text;
  std::snprintf(text.data(), text.size(), "%.4g m/s, %.4g m/s, %.4g rad/s", v.x(), v.y(), v.z());
  return text.data();
}

LegReach::LegReach(const Robot& robot, const WalkSettings& settings, const Cadence& cadence)
    : leg_{robot.leg_at_stand(kLeft), robot.leg_at_stand(kRight)},
      hip_turn_(robot.hip_turn()),
      least_knee_(settings.com.least_knee),
      crouch_limit_(settings.com.crouch_limit),
      crouch_margin_(settings.com.crouch_margin),
      cadence_(cadence) {}

double LegReach::along_ground(double crouch) const {
  double least = std::numeric_limits<double>::infinity();
  for (const RobotLeg& leg : leg_) {
    const double length_2 =
        leg.thigh * leg.thigh + leg.shank * leg.shank + 2.0 * leg.thigh * leg.shank * std::cos(least_knee_);
    const double height = std::abs(leg.hip_to_ankle.y()) - crouch;
    least = std::min(least, std::sqrt(std::max(length_2 - height * height, 0.0)) - std::abs(leg.hip_to_ankle.x()));
  }
  return std::max(least, 0.0);
}

double LegReach::stride(const Vec3& velocity) const {
  const StepTimes times = cadence_.times(velocity);
  const double along = 0.5 * (times.period() + times.T_ds) * velocity.x(), aside = times.period() * velocity.y();
  return std::hypot(along, aside);
}

double LegReach::crouch_for(double stride, double lift) const {
  const double wanted = crouch_margin_ * stride;
  if (wanted <= along_ground(-lift)) return 0.0;
  double less = 0.0, enough = crouch_limit_;
  for (int i = 0; i < 12; ++i) {
    const double middle = 0.5 * (less + enough);
    (along_ground(middle - lift) >= wanted ? enough : less) = middle;
  }
  return enough;
}

double LegReach::share(const Vec3& velocity) const {
  require_velocity(velocity);
  if (velocity.cwiseAbs().maxCoeff() > kFastest) return std::numeric_limits<double>::infinity();
  const StepTimes times = cadence_.times(velocity);
  const double turn = 0.5 * (times.period() + times.T_ds) * velocity.z();
  return std::max(stride(velocity) / along_ground(crouch_limit_), std::abs(turn) / hip_turn_);
}

Vec3 LegReach::within(const Vec3& velocity) const {
  require_velocity(velocity);
  if (const double most = velocity.cwiseAbs().maxCoeff(); most > kFastest) return within(velocity / most * kFastest);
  if (share(velocity) <= 1.0) return velocity;
  double possible = 0.0, impossible = 1.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (possible + impossible);
    (share(middle * velocity) <= 1.0 ? possible : impossible) = middle;
  }
  return possible * velocity;
}

void LegReach::require_within(const VelocityProfile& profile) const {
  for (const Vec3& v : profile.v())
    if (share(v) > 1.0)
      throw InputError("the profile asks for (v_x, v_y, w_z) = (" + velocity_text(v) +
                       "); this robot's legs reach as far as (" + velocity_text(within(v)) + ") at a step period of " +
                       text_of(cadence_.times(v).period()) + " s, and " + text_of(speed_limit()) +
                       " m/s straight ahead");
}

}  // namespace zmpwalk
