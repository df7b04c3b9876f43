#include "zmpwalk/control/limits.hpp"

#include <algorithm>
#include <cmath>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {
namespace {

constexpr double kRounding = 1e-9;    // of a limit: what the closed form may seem to break it by
constexpr double kRangeSize = 100.0;  // acceleration in which the room of a joint's range is measured [rad/s^2]
constexpr double kElastic = 2e-5;   // of a limit: what a sole or range gives counts as much as a whole change of a task
constexpr double kLoadShare = 0.3;  // of the weight, that one foot takes over from the other: its size
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
      slack_(static_cast<int>(limits.torque.size()) + 6) {
  static_assert(LeastChange::kUnknowns == TaskSlack::kColumns + 1);
  static_assert(LeastChange::kRows == 4 * 12 + 2 * kSoleRows);  // two of a torque, two of a range for each joint
  require_positive("range_rate", limits.range_rate);
  require_positive("height", limits.height);
  require_size("range", static_cast<long>(limits.range.size()), limits.torque.size());
  give_.trunk *= kHeight / limits.height;
  give_.swing_angular *= kHeight / limits.height;
  give_.load_force = kLoadShare * limits.weight;
  give_.load_moment = kLoadLever * limits.height * give_.load_force;
  for (auto& [low, high] : limits_.range) {
    const double margin = std::min(limits.range_margin, 0.5 * (high - low));
    low += margin;
    high -= margin;
  }
}

void LimitKeeper::set_friction(Side side, double friction) {
  if (friction == limits_.sole[side].friction) return;
  limits_.sole[side].friction = friction;
  sole_rows_[side] = sole_rows(limits_.sole[side], limits_.weight);
}

bool LimitKeeper::are_kept(const Dynamics& dyn, const Stance& stance, const WholeBodyResult& out) {
  bool kept = true;
  const double k = limits_.range_rate;
  for (const Side side : kSides) {
    for (const int j : whole_body_->legs()[side]) {
      const auto [low, high] = limits_.range[static_cast<std::size_t>(j)];
      const double q = dyn.q[j], dq = dyn.dq[6 + j], ddq = out.ddq[6 + j];
      upper_[j] = k * (0.25 * k * std::max(high - q, 0.0) - dq);
      lower_[j] = k * (0.25 * k * std::min(low - q, 0.0) - dq);
      kept &= std::abs(out.tau[j]) <= limits_.torque[j] && ddq <= upper_[j] && ddq >= lower_[j];
    }
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
  return are_kept(dyn, stance, out) || solve(stance, out);
}

bool LimitKeeper::solve(const Stance& stance, WholeBodyResult& out) {
  whole_body_->slack(give_, out, slack_);
  least_.begin();
  // A row with `room`, in shares of its limit, of which y changes `size * answer`. A torque's limit does not give.
  LeastChange::Row row;
  const auto add = [&](Kind kind, int which, double room, const auto& answer) {
    if (!std::isfinite(room)) return;
    row << answer, kind == Kind::kTorque ? 0.0 : kElastic;
    named_[static_cast<std::size_t>(least_.add(room, row))] = {kind, which};
  };
  for (const Side side : kSides) {
    for (int i = 0; i < 6; ++i) {
      const int j = whole_body_->legs()[side][static_cast<std::size_t>(i)], leg = 6 * side + i;
      const double limit = limits_.torque[j];
      for (const double sign : {1.0, -1.0}) {
        if (std::isfinite(limit))
          add(Kind::kTorque, j, 1.0 - sign * out.tau[j] / limit, -sign / limit * slack_.leg_tau.row(leg));
        const double room = sign * ((sign > 0.0 ? upper_ : lower_)[j] - out.ddq[6 + j]) / kRangeSize;
        add(Kind::kRange, j, room, -sign / kRangeSize * slack_.leg_ddq.row(leg));
      }
    }
    if (!stance.standing[side]) continue;
    const Mat3& R = whole_body_->feet()[side].R_WF;
    SoleRows of_f_c;  // the robot's wrench on the ground, world axes
    of_f_c.leftCols<3>() = -sole_rows_[side].leftCols<3>().lazyProduct(R.transpose());
    of_f_c.rightCols<3>() = -sole_rows_[side].rightCols<3>().lazyProduct(R.transpose());
    const Eigen::Matrix<double, kSoleRows, TaskSlack::kColumns> answers =
        of_f_c.lazyProduct(slack_.f_c.middleRows<6>(6 * side));
    for (int i = 0; i < kSoleRows; ++i) add(Kind::kSole, kSoleRows * side + i, sole_room_[side][i], answers.row(i));
  }
  if (!least_.solve()) return false;

  change_ = least_.y().head<TaskSlack::kColumns>();
  excess_ = kElastic * std::max(least_.y()[TaskSlack::kColumns], 0.0);
  whole_body_->apply(slack_, change_, out);
  for (const auto& leg : whole_body_->legs())
    for (const int j : leg) out.tau[j] = std::clamp(out.tau[j], -limits_.torque[j], limits_.torque[j]);  // rounding
  for (int i = 0; i < least_.rows(); ++i)
    if (least_.is_active(i)) note(named_[static_cast<std::size_t>(i)]);
  return true;
}

void LimitKeeper::note(const Named& row) {
  if (row.kind == Kind::kSole)
    active_.feet |= 1 << (4 * (row.which / kSoleRows) + static_cast<int>(sole_limit(row.which % kSoleRows)));
  else if (row.which < ActiveLimits::kJoints)
    (row.kind == Kind::kTorque ? active_.torques : active_.ranges) |= std::int64_t{1} << row.which;
}

}  // namespace zmpwalk
