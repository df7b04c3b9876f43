// Steps on ground that the user knows: the parts of GaitGenerator that fit speed, places and swings to it.

#include <algorithm>
#include <cmath>
#include <limits>

#include "zmpwalk/gait/gait_generator.hpp"
#include "zmpwalk/math/rotation.hpp"

namespace zmpwalk {
namespace {

constexpr int kSteps = 4;           // that are looked at ahead
constexpr double kLeastStep = 0.5;  // least and most lengths of steps, as shares of the wanted one
constexpr double kMostStep = 1.7;
constexpr int kLengths = 24;      // lengths between them that are looked at
constexpr double kSpeed = 0.3;    // what a step that is longer or shorter than wanted costs, beside one that misses
constexpr double kStands = 0.02;  // slower than this the robot steps on the spot [share of the cadence's speed]
constexpr double kLevel = 1e-3;   // ground that rises by less is level [share of the sole's length]
constexpr int kWay = 48;          // places along a swing at which the ground is looked at
constexpr double kReach = 0.02;   // and how much longer than it is the sole is taken to be [share of its length]
constexpr double kNear = 0.5;     // the DCM is led to a step as if that were at least this far ahead [T_c]
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMissing = 1e6;  // what the first step costs that has no place, and more the sooner that is
constexpr double kClear = 0.08;   // by how much a swinging sole clears the ground [share of its length]

}  // namespace

double GaitGenerator::misfit(const GaitInput& in, double speed, double wanted, bool& plane,
                             std::array<SolePlace, 2>& first) const {
  const double T = cadence_.slow.period(), length = speed * T, planned = wanted * T;
  const Side stance = other(out_.swing);
  const Vec2 left = left_of(out_.ahead);
  const double width = footsteps_.width(0.0);
  double missed = kSpeed * (length - planned) * (length - planned);
  Vec2 middle = in.p_sole[stance].head<2>() - 0.5 * side_sign(stance) * width * left;
  const SolePlace& from = out_.under[stance];
  plane = from.good;
  for (int k = 0; k < kSteps; ++k) {
    const Side side = k % 2 ? stance : out_.swing;
    const Vec2 beside = 0.5 * side_sign(side) * width * left;
    const double lead = k == 0 && starting_ ? 0.5 * length : length;
    const Foothold there{middle + lead * out_.ahead + beside, out_.heading};
    const SolePlace place = footsteps_.nearest(there);
    if (!place.good) {
      plane = false;
      return kMissing * (kSteps - k);
    }
    const Vec2 off = place.at.p - there.p, way = place.at.p - from.at.p;
    missed += off.squaredNorm();
    plane = plane && off.isZero(0.0) &&
            std::abs(place.height - from.height - from.rise.dot(way)) < 10.0 * kLevel * sole_.length;
    if (k < 2) first[k] = place;
    middle = place.at.p - beside;
  }
  return missed;
}

double GaitGenerator::fitting_speed(const GaitInput& in, double wanted) {
  bool plane = false;
  std::array<SolePlace, 2> next, first;
  double least = misfit(in, wanted, wanted, plane, next), best = wanted;
  fits_ = !plane;
  if (plane || std::abs(wanted) < kStands * cadence_.speed) {
    out_.place = next[0];
    return wanted;
  }
  for (int i = 0; i <= kLengths; ++i) {
    const double speed = wanted * (kLeastStep + (kMostStep - kLeastStep) * i / kLengths);
    const double missed = misfit(in, speed, wanted, plane, first);
    if (missed >= least) continue;
    least = missed;
    best = speed;
    next = first;
  }
  out_.place = next[0];
  after_ = (next[1].at.p - next[0].at.p).dot(out_.ahead);
  // Where there is no place for the next two steps, it stops.
  return least > kMissing * (kSteps - 2) ? 0.0 : best;
}

void GaitGenerator::look_at_ground(const GaitInput& in) {
  const auto look = [&](Side side) {
    out_.under[side] = ground_->under(foothold_of(in.p_sole[side], in.R_sole[side]), sole_, 0.0);
  };
  if (out_.at_rest || began_ == Began::kStand) {
    if (began_ == Began::kStand || std::isnan(out_.under[kLeft].height))
      for (const Side side : kSides) look(side);
    return;
  }
  if (began_ != Began::kDoubleSupport) return;
  for (const Side side : kSides) look(side);
}

void GaitGenerator::fit_plan(const GaitInput& in) {
  Vec3 wanted = told_ ? wanted_ : profile_.velocity(in.t);
  slowed_ = in.pace < 1.0;
  if (slowed_) wanted *= in.pace;
  const double fits = ground_ ? fitting_speed(in, wanted.x()) : wanted.x();
  if (!steered_ && !slowed_ && fits == wanted.x()) return;
  wanted.x() = fits;
  if (!steered_ || wanted != steered_to_) steer(in.t, wanted);
  steered_ = true;
  steered_to_ = wanted;
}

void GaitGenerator::meet_place(const GaitInput& in, double time) {
  const double Tc = pendulum_.Tc();
  // The whole sole is on its place, and the next one is where it is: the ZMP may go as far as when pushed.
  const ZmpBounds whole = room(in, whole_, whole_[out_.support]);
  out_.room.lower.x() = whole.lower.x();
  out_.room.upper.x() = whole.upper.x();
  const Vec2 foot = before_switch() ? Vec2(in.p_sole[other(out_.support)].head<2>()) : out_.place.at.p;
  // Over the next foot the DCM begins where a ZMP under its middle takes it to the foot after that.
  const double L = before_switch() ? (out_.place.at.p - foot).dot(out_.ahead) : after_;
  const double xi_start = settings_.com.lead + L / pendulum_.growth(schedule_.times().period()).excess;
  const double xi_end = (foot - out_.origin).dot(out_.ahead_M) + xi_start;
  const double xi = (in.com + Tc * in.dcom - out_.origin).dot(out_.ahead_M);
  out_.zmp_ahead = pendulum_.reference_to_reach(xi, xi_end, std::max(time, kNear * Tc));
}

SwingShape GaitGenerator::clearing_shape(const GaitInput& in) const {
  SwingShape out;
  const Vec3& from = in.p_sole[out_.swing];
  const SolePlace &lifts = out_.under[out_.swing], &lands = out_.place;
  const double yaw = yaw_of(in.R_sole[out_.swing]), z_0 = from.z(), z_1 = lands.height + in.felt;
  const double level = kLevel * sole_.length;
  const Vec2 way = lands.at.p - from.head<2>();
  const auto leans = [&](const SolePlace& place) { return place.rise.norm() > kLevel; };
  out.tilt = tilt_on(lands.rise, lands.at.yaw);
  out.tilts = leans(lifts) || leans(lands);
  // Height of the sole's centre at which it touches the ground, along the way.
  std::array<double, kWay + 1> touch;
  bool even = !out.tilts && std::abs(z_1 - z_0) < level;
  for (int i = 0; i <= kWay; ++i) {
    const double s = static_cast<double>(i) / kWay;
    const Vec2 p = from.head<2>() + s * way, ahead = ahead_of(yaw + s * wrap_angle(lands.at.yaw - yaw)),
               left = left_of(ahead);
    const Vec2 rise = lifts.rise + s * (lands.rise - lifts.rise);
    touch[i] = -kInfinity;
    for (int k = 0; k < 15; ++k) {
      const Vec2 off =
          (0.5 + kReach) * sole_.length * (0.5 * (k / 3) - 1.0) * ahead + 0.5 * sole_.width * (k % 3 - 1.0) * left;
      const double height = ground_->at(p + off).height + in.felt;
      if (height - rise.dot(off) > touch[i]) touch[i] = height - rise.dot(off);
    }
    even = even && std::abs(touch[i] - z_0) < level;
  }
  if (even) return out;

  const double clear = kClear * sole_.length, height = settings_.swing.height;
  double highest = std::max(z_0, z_1);
  for (const double each : touch) highest = std::max(highest, each);
  // Of the shapes that clear it, the one with the smallest accelerations.
  double least = kInfinity;
  const auto consider = [&](const SwingShape& shape, bool any) {
    const double up = shape.top - z_0, down = shape.top - z_1, across = shape.arrives - shape.starts;
    const double vertical = std::max(up / (shape.rise * shape.rise), down / ((1.0 - shape.rise) * (1.0 - shape.rise)));
    const double effort = vertical * vertical + way.squaredNorm() / std::pow(across, 4);
    if (effort >= least) return;
    constexpr int kTimes = 24;
    for (int j = 1; j < kTimes && !any; ++j) {
      const double t = static_cast<double>(j) / kTimes;
      const Motion1 z = t < shape.rise ? Cubic(z_0, 0.0, shape.top, 0.0, shape.rise).at(t)
                                       : Cubic(shape.top, 0.0, z_1, 0.0, 1.0 - shape.rise).at(t - shape.rise);
      const double u = Cubic(0.0, 0.0, 1.0, 0.0, across).at(std::clamp(t - shape.starts, 0.0, across)).p * kWay;
      const int i = std::min(static_cast<int>(u), kWay - 1);
      const bool over_lift = u < 0.02 * kWay, over_place = u > 0.98 * kWay;
      const double free = clear * std::min({1.0, 6.0 * t, 6.0 * (1.0 - t)});
      const double ground = over_lift    ? touch[0] - level
                            : over_place ? touch[kWay] - level
                                         : std::max(touch[i], touch[i + 1]) + free;
      if (z.p < ground) return;
    }
    least = effort;
    out.top = shape.top;
    out.rise = shape.rise;
    out.starts = shape.starts;
    out.arrives = shape.arrives;
  };
  SwingShape shape;
  for (const double higher : {0.0, 0.5, 1.0})
    for (const double rise : {0.3, 0.4, 0.5, 0.6, 0.7})
      for (const double starts : {0.0, 0.1, 0.2, 0.3, 0.4})
        for (const double arrives : {1.0, 0.9, 0.8, 0.7}) {
          shape.top = highest + std::max(clear, (0.5 + higher) * height);
          shape.rise = rise;
          shape.starts = starts;
          shape.arrives = arrives;
          consider(shape, false);
        }
  if (std::isnan(out.top)) {
    shape.starts = 0.3;
    shape.arrives = 0.7;
    shape.rise = z_1 > z_0 ? 0.3 : 0.7;
    consider(shape, true);
  }
  return out;
}

}  // namespace zmpwalk
