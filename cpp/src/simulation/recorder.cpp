#include "zmpwalk/simulation/recorder.hpp"

#include <algorithm>
#include <cassert>

namespace zmpwalk {
namespace {

/// Memory is set aside for walks up to this long; longer ones grow as they go [s].
constexpr double kReservedTime = 300.0;

void append(double value, Column& to) { to.values.push_back(value); }
template <class Derived>
void append(const Eigen::MatrixBase<Derived>& values, Column& to) {
  assert(values.size() == to.width);
  for (const double value : values.derived()) to.values.push_back(value);
}

}  // namespace

std::size_t rows_within(double duration, double dt) {
  return static_cast<std::size_t>(std::clamp(duration, 0.0, kReservedTime) / dt) + 2;
}

Recorder::Recorder(const WalkingController& controller, double duration, bool only_last)
    : controller_(&controller), only_last_(only_last) {
  const std::size_t rows = only_last ? 1 : rows_within(duration, controller.settings().control.dt);
  for (const RecordedColumn& column : recorded_columns()) {
    const int width = column.parts.width(controller.robot().nv());
    columns_.push_back({column.name, width, {}});
    columns_.back().values.reserve(rows * static_cast<std::size_t>(width));
  }
}

void Recorder::add(const CycleOutput& out, const Data& data) {
  const Robot& robot = controller_->robot();
  add(out, data, robot, robot.qpos(), robot.qvel());
}

void Recorder::add(const CycleOutput& out, const Data& data, const Robot& robot, const State& state) {
  using ConstMap = Eigen::Map<const VecX>;
  add(out, data, robot, ConstMap(state.q.data(), state.q.size()), ConstMap(state.dq.data(), state.dq.size()));
}

void Recorder::add(const CycleOutput& out, const Data& data, const Robot& robot, const Eigen::Map<const VecX>& q,
                   const Eigen::Map<const VecX>& dq) {
  if (!out.fresh) return;
  contact_ = measure_contact(robot, data);
  // The cycle's plane, through the sole where the contacts found it.
  const Plane plane = Plane::through(contact_.sole[out.support > 0 ? kLeft : kRight], out.zmp_plane.head<3>());
  const RecordedCycle cycle{
      out, measured_zmp(contact_, plane), contact_.wrench, contact_.self_contacts, robot.joint_margin(data), q, dq};
  if (only_last_)
    for (Column& each : columns_) each.values.clear();
  auto column = columns_.begin();
  visit_columns([&](const char*, const auto& get, const auto&...) { append(column_value(get, cycle), *column++); });
  ++rows_;
}

void Recorder::mark_fall() {
  for (Column& column : columns_)
    if (column.name == "fell" && !column.values.empty()) column.values.back() = 1.0;
}

}  // namespace zmpwalk
