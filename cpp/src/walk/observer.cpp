#include "zmpwalk/walk/observer.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace zmpwalk {
namespace {

constexpr double kSlowest = 4.0;    // most by which noise lengthens the observer's time
constexpr double kHold = 6.0;       // times of the observer for which a push is waited for to pass
constexpr double kCalm = 4.0;       // times of the observer over which what has been found counts as steady
constexpr double kNoiseTime = 4.0;  // over which the mean square of the noise is taken, in times of the observer

/// What is left of `x` beyond `tolerance`, at most `most`.
double beyond(double x, double tolerance, double most) {
  return std::copysign(std::clamp(std::abs(x) - tolerance, 0.0, most), x);
}

Mat3 rotation(const Vec3& turn) {
  const double angle = turn.norm();
  if (angle == 0.0) return Mat3::Identity();
  return Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
}

}  // namespace

DisturbanceObserver::DisturbanceObserver(const WalkSettings& settings, double gravity)
    : on_(settings.observer.on),
      dt_(settings.control.dt),
      time_(settings.observer.time),
      speed_noise_(settings.observer.speed_noise),
      tolerance_(settings.observer.tolerance),
      force_most_(settings.observer.force_most),
      weight_most_(settings.observer.weight_most),
      push_(settings.observer.push),
      gravity_(gravity) {}

void DisturbanceObserver::reset(const Vec3& dcom) {
  last_ = dcom;
  commanded_.setZero();
  passing_.setZero();
  found_.setZero();
  calm_.setZero();
  held_ = 0.0;
  made_up_for_.setZero();
  square_ = 0.0;
}

double DisturbanceObserver::noise() const {
  return std::sqrt(square_ / 6.0);
}  // of three axes, and of two measurements

void DisturbanceObserver::update(const Vec3& dcom, bool frozen) {
  if (!on_) return;
  const Vec3 unexplained = dcom - last_ - (commanded_ + passing_) * dt_;
  last_ = dcom;
  square_ += (unexplained.squaredNorm() - square_) * std::min(dt_ / (kNoiseTime * time_), 1.0);
  const double time = time_ * std::clamp(std::sqrt(square_ / 3.0) / speed_noise_, 1.0, kSlowest);
  passing_ += unexplained / std::max(time, dt_);
  if (passing_.head<2>().norm() > push_ * time / time_) {  // what passes is more even where it is averaged for longer
    found_ = calm_;  // what the push's beginning has added is no steady disturbance
    held_ = kHold * time_;
  } else if (held_ > 0.0) {
    held_ -= dt_;
  } else if (!frozen) {
    found_ += (passing_ - found_) * std::min(dt_ / time, 1.0);
    calm_ += (found_ - calm_) * std::min(dt_ / (kCalm * time), 1.0);
  }
  if (frozen) return;
  for (int i = 0; i < 2; ++i) made_up_for_[i] = beyond(found_[i], tolerance_, force_most_);
  made_up_for_.z() = beyond(found_.z(), tolerance_, weight_most_ * gravity_);
}

Vec2 DisturbanceObserver::steady() const {
  return {beyond(calm_.x(), tolerance_, force_most_), beyond(calm_.y(), tolerance_, force_most_)};
}

Disturbance DisturbanceObserver::disturbance() const {
  return {made_up_for_.head<2>(), 1.0 - made_up_for_.z() / gravity_};
}

AttitudeObserver::AttitudeObserver(const WalkSettings& settings, double gravity)
    : on_(settings.observer.on),
      dt_(settings.control.dt),
      time_(settings.observer.attitude_time),
      noise_(settings.observer.attitude_noise),
      tolerance_(settings.observer.tolerance),
      bias_time_(settings.observer.bias_time),
      bias_most_(settings.observer.bias_most),
      sole_tilt_(settings.observer.sole_tilt),
      gravity_(gravity) {}

void AttitudeObserver::reset(const Mat3& R_WB) {
  R_WB_ = R_WB;
  square_ = 0.0;
  tilt_.setZero();
  bias_.setZero();
}

bool AttitudeObserver::correct(Eigen::Ref<Vec4> quaternion, const Vec3& omega) {
  if (!on_) return false;
  const Mat3 measured =
      Eigen::Quaterniond(quaternion[0], quaternion[1], quaternion[2], quaternion[3]).normalized().toRotationMatrix();
  const Mat3 predicted = R_WB_ * rotation(omega * dt_);
  const Eigen::AngleAxisd off(Mat3(predicted.transpose() * measured));
  square_ += (off.angle() * off.angle() - square_) * std::min(dt_ / time_, 1.0);
  const bool noisy = square_ > noise_ * noise_;
  R_WB_ = noisy ? Mat3(predicted * rotation(std::min(dt_ / time_, 1.0) * off.angle() * off.axis())) : measured;
  if (!noisy && bias_.isZero(0.0)) return false;
  const Eigen::Quaterniond believed(Mat3(R_WB_ * rotation(-bias_)));
  quaternion << believed.w(), believed.x(), believed.y(), believed.z();
  return true;
}

void AttitudeObserver::look_for_bias(const Mat3& R_WB, const Vec3& sole_normal, const Vec2& acceleration) {
  if (!on_) return;
  tilt_ += (sole_normal.head<2>() - tilt_) * std::min(dt_ / bias_time_, 1.0);
  Vec2 agreed = Vec2::Zero();
  for (int i = 0; i < 2; ++i) {
    const double felt = beyond(-acceleration[i], tolerance_, gravity_) / gravity_,
                 seen = beyond(tilt_[i], sole_tilt_, 1.0);
    if (felt * seen > 0.0) agreed[i] = std::copysign(std::min(std::abs(felt), std::abs(seen)), felt);
  }
  if (agreed.isZero(0.0)) return;
  bias_ += dt_ / bias_time_ * (R_WB.transpose() * Vec3(-agreed.y(), agreed.x(), 0.0));
  if (const double angle = bias_.norm(); angle > bias_most_) bias_ *= bias_most_ / angle;
}

}  // namespace zmpwalk
