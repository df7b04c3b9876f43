#include "zmpwalk/control/limits.hpp"

#include <algorithm>
#include <cmath>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {
namespace {

constexpr double kRounding = 1e-9;    // of a limit: what the closed form may seem to break it by
constexpr double kSolved = 1e-6;      // of a limit: what the method may leave
constexpr double kNear = 1.0;         // of a limit: rows that are further away wait for the second attempt
constexpr double kRangeSize = 100.0;  // acceleration in which the room of a joint's range is measured [rad/s^2]
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kElastic = 1e-4;    // of a limit: by which soles and ranges give where nothing else helps
constexpr double kLoadShare = 0.3;   // of the weight, that one foot takes over from the other: its size
constexpr double kLoadLever = 0.15;  // of the COM's height: of the moment that goes with it
constexpr double kHeight = 0.747;    // for which the sizes of `TaskGive` are meant [m]

constexpr double kOctagon = 0.92387953251128674;  // cos(pi / 8): the sides of an octagon within the circle of radius 1

const char* name_of(SoleLimit limit) {
  switch (limit) {
    case SoleLimit::kLoad:
      return "load";
    case SoleLimit::kFriction:
      return "friction";
    case SoleLimit::kCop:
      return "centre of pressure";
    case SoleLimit::kYaw:
      return "yaw friction";
  }
  return "?";
}

}  // namespace

SoleRows sole_rows(const SoleGrip& grip, double weight) {
  require_positive("sole.length", grip.length);
  require_positive("sole.width", grip.width);
  require_positive("sole.friction", grip.friction);
  require_positive("weight", weight);
  const double X = 0.5 * grip.length, Y = 0.5 * grip.width, mu = grip.friction;
  const double k = mu * std::hypot(X, Y) / (X + Y);
  require_positive("sole.twist", grip.twist);
  SoleRows rows = SoleRows::Zero();
  int i = 0;
  rows(i++, 2) = 1.0;
  for (int side = 0; side < 8; ++side, ++i)
    rows.row(i).head<3>() << -std::cos(side * M_PI / 4.0), -std::sin(side * M_PI / 4.0), mu * kOctagon;
  for (const double sign : {1.0, -1.0}) {
    rows.row(i)[2] = 1.0, rows.row(i++)[4] = sign / X;
    rows.row(i)[2] = 1.0, rows.row(i++)[3] = sign / Y;
  }
  for (const double z : {1.0, -1.0})
    for (const double a : {1.0, -1.0})
      for (const double b : {1.0, -1.0})
        rows.row(i++) << a * Y, b * X, grip.twist * k * (X + Y), -a * z * k, -b * z * k, z;
  rows.bottomRows<8>() /= k * (X + Y);
  return rows / weight;
}

SoleLimit sole_limit(int row) {
  if (row < 1) return SoleLimit::kLoad;
  if (row < 9) return SoleLimit::kFriction;
  return row < 13 ? SoleLimit::kCop : SoleLimit::kYaw;
}

std::vector<std::string> ActiveLimits::names(const std::vector<std::string>& joints) const {
  std::vector<std::string> out;
  for (std::size_t j = 0; j < joints.size() && j < kJoints; ++j) {
    if (torques >> j & 1) out.push_back("torque of " + joints[j]);
    if (ranges >> j & 1) out.push_back("range of " + joints[j]);
  }
  for (const Side side : kSides)
    for (int limit = 0; limit < 4; ++limit)
      if (feet >> (4 * side + limit) & 1)
        out.push_back(std::string(name_of(static_cast<SoleLimit>(limit))) + " of the " +
                      (side == kLeft ? "left" : "right") + " sole");
  return out;
}

LimitKeeper::LimitKeeper(const RobotLimits& limits, const WholeBodyController& whole_body)
    : limits_(limits),
      whole_body_(&whole_body),
      sole_rows_{sole_rows(limits.sole[kLeft], limits.weight), sole_rows(limits.sole[kRight], limits.weight)},
      upper_(VecX::Zero(limits.torque.size())),
      lower_(upper_),
      in_leg_(static_cast<std::size_t>(limits.torque.size()), true),
      slack_(static_cast<int>(limits.torque.size()) + 6),
      least_(4 * static_cast<int>(limits.torque.size()) + 2 * kSoleRows),
      change_(VecX::Zero(TaskSlack::kMost)),
      changed_(whole_body.result()) {
  for (const int j : whole_body.posture_joints()) in_leg_[static_cast<std::size_t>(j)] = false;
  require_positive("range_rate", limits.range_rate);
  require_positive("height", limits.height);
  require_size("range", static_cast<long>(limits.range.size()), limits.torque.size());
  give_.trunk *= kHeight / limits.height;
  give_.swing_angular *= kHeight / limits.height;
  give_.load_force = kLoadShare * limits.weight;
  give_.load_moment = kLoadLever * limits.height * give_.load_force;
  rows_.reserve(4 * limits.range.size() + 2 * kSoleRows);
  for (auto& [low, high] : limits_.range) {
    const double margin = std::min(limits.range_margin, 0.5 * (high - low));
    low += margin;
    high -= margin;
  }
}

bool LimitKeeper::are_kept(const Dynamics& dyn, const Stance& stance, const WholeBodyResult& out) {
  bool kept = true;
  for (Eigen::Index j = 0; j < upper_.size(); ++j) {
    const auto [low, high] = limits_.range[static_cast<std::size_t>(j)];
    const double k = limits_.range_rate, q = dyn.q[j], dq = dyn.dq[6 + j], ddq = out.ddq[6 + j];
    upper_[j] = k * (0.25 * k * std::max(high - q, 0.0) - dq);
    lower_[j] = k * (0.25 * k * std::min(low - q, 0.0) - dq);
    if (in_leg_[static_cast<std::size_t>(j)])
      kept &= std::abs(out.tau[j]) <= limits_.torque[j] && ddq <= upper_[j] && ddq >= lower_[j];
  }
  for (const Side side : kSides) {
    if (!stance.standing[side]) continue;
    sole_room_[side] = sole_room(side, out);
    kept &= sole_room_[side].minCoeff() >= -kRounding;
  }
  return kept;
}

LimitKeeper::SoleRoom LimitKeeper::sole_room(Side side, const WholeBodyResult& out) const {
  const Mat3& R = whole_body_->feet()[side].R_WF;
  Vec6 f;
  f.head<3>().noalias() = -R.transpose() * out.f_c.segment<3>(6 * side);
  f.tail<3>().noalias() = -R.transpose() * out.f_c.segment<3>(6 * side + 3);
  return sole_rows_[side].lazyProduct(f);
}

bool LimitKeeper::keep(const Dynamics& dyn, const Stance& stance, WholeBodyResult& out) {
  if (active_.any()) {
    active_ = {};
    change_.setZero();
    excess_ = 0.0;
  }
  if (are_kept(dyn, stance, out)) return true;
  return solve(stance, out, kNear) || solve(stance, out, kInfinity);
}

bool LimitKeeper::has_kept(const Stance& stance, const WholeBodyResult& out, double excess) const {
  for (int j = 0; j < static_cast<int>(upper_.size()); ++j) {
    if (!in_leg_[static_cast<std::size_t>(j)]) continue;
    if (!(std::abs(out.tau[j]) <= (1.0 + kSolved) * limits_.torque[j])) return false;
    const double ddq = out.ddq[6 + j], beyond = (excess + kSolved) * kRangeSize;
    if (!(ddq <= upper_[j] + beyond && ddq >= lower_[j] - beyond)) return false;
  }
  for (const Side side : kSides)
    if (stance.standing[side] && !(sole_room(side, out).minCoeff() >= -excess - kSolved)) return false;
  return true;
}

bool LimitKeeper::solve(const Stance& stance, WholeBodyResult& out, double near) {
  whole_body_->slack(give_, out, {}, slack_);
  const bool elastic = std::isinf(near);
  const int columns = slack_.columns;
  least_.begin(columns + elastic);
  rows_.clear();
  // A row that has `room`, in shares of its limit; its entries are the caller's.
  const auto add = [&](Kind kind, int which, double room) {
    rows_.push_back({kind, which});
    auto entries = least_.row(least_.add(room));
    if (elastic) entries[columns] = kind == Kind::kTorque ? 0.0 : kElastic;
    return entries.data();
  };
  const auto entries_at = [&](double* entries) { return Eigen::Map<Eigen::RowVectorXd>(entries, columns); };

  for (int j = 0; j < static_cast<int>(upper_.size()); ++j) {
    if (!in_leg_[static_cast<std::size_t>(j)]) continue;
    const double limit = limits_.torque[j];
    for (const double sign : {1.0, -1.0}) {
      const double room = 1.0 - sign * out.tau[j] / limit;
      if (std::isfinite(limit) && room < near) {
        auto entries = entries_at(add(Kind::kTorque, j, room));
        slack_.row(slack_.w, 6 + j, entries);
        entries *= -sign / limit;
      }
      const double stop = sign * ((sign > 0.0 ? upper_ : lower_)[j] - out.ddq[6 + j]) / kRangeSize;
      if (stop < near && std::isfinite(stop)) {
        auto entries = entries_at(add(Kind::kRange, j, stop));
        slack_.row(slack_.ddq, 6 + j, entries);
        entries *= -sign / kRangeSize;
      }
    }
  }
  for (const Side side : kSides) {
    if (!stance.standing[side]) continue;
    const Mat3& R = whole_body_->feet()[side].R_WF;
    SoleRows rows;  // for the robot's wrench on the ground, world axes
    rows.leftCols<3>().noalias() = -sole_rows_[side].leftCols<3>() * R.transpose();
    rows.rightCols<3>().noalias() = -sole_rows_[side].rightCols<3>() * R.transpose();
    for (int i = 0; i < kSoleRows; ++i)
      if (sole_room_[side][i] < near)
        entries_at(add(Kind::kSole, kSoleRows * side + i, sole_room_[side][i])) =
            rows.row(i).lazyProduct(slack_.f_c.middleRows<6>(6 * side).leftCols(columns));
  }
  if (!least_.solve()) return false;

  changed_ = out;
  whole_body_->apply(slack_, least_.y(), changed_);
  const double excess = elastic ? std::max(kElastic * least_.y()[columns], 0.0) : 0.0;
  if (!has_kept(stance, changed_, excess)) return false;
  out.ddq = changed_.ddq;
  out.f_c = changed_.f_c;
  out.tau = changed_.tau;
  for (Eigen::Index j = 0; j < out.tau.size(); ++j)
    if (in_leg_[static_cast<std::size_t>(j)])  // what rounding left
      out.tau[j] = std::clamp(out.tau[j], -limits_.torque[j], limits_.torque[j]);
  change_.head(columns) = least_.y().head(columns);
  excess_ = excess;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (least_.is_active(static_cast<int>(i))) note(rows_[i]);
  return true;
}

void LimitKeeper::note(const Row& row) {
  if (row.kind == Kind::kSole)
    active_.feet |= 1 << (4 * (row.which / kSoleRows) + static_cast<int>(sole_limit(row.which % kSoleRows)));
  else if (row.which < ActiveLimits::kJoints)
    (row.kind == Kind::kTorque ? active_.torques : active_.ranges) |= std::int64_t{1} << row.which;
}

}  // namespace zmpwalk
