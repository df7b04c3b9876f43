#include "zmpwalk/simulation.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/robot/contact_forces.hpp"

namespace zmpwalk {
namespace {

/// Without any contact for this long, the robot no longer walks [s].
constexpr double kLongestFlight = 0.1;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Memory is set aside for walks up to this long; longer ones grow as they go [s].
constexpr double kReservedTime = 300.0;

/// Lowered by this much from its start pose, a robot's feet touch the floor, if there is one [m].
constexpr double kTouchDepth = 0.002;

/// MuJoCo warns and resets itself where a state is not finite or far too large.
bool diverged(const mjData* d) {
  return d->warning[mjWARN_BADQPOS].number + d->warning[mjWARN_BADQVEL].number + d->warning[mjWARN_BADQACC].number > 0;
}

void append(double value, Column& to) { to.values.push_back(value); }
template <class Derived>
void append(const Eigen::MatrixBase<Derived>& values, Column& to) {
  assert(values.size() == to.width);
  for (const double value : values.derived()) to.values.push_back(value);
}

}  // namespace

Recorder::Recorder(const WalkingController& controller, double duration) : controller_(&controller) {
  const auto rows =
      static_cast<std::size_t>(std::clamp(duration, 0.0, kReservedTime) / controller.settings().control.dt) + 2;
  for (const RecordedColumn& column : recorded_columns()) {
    const int width = column.parts.width(controller.robot().nv());
    columns_.push_back({column.name, width, {}});
    columns_.back().values.reserve(rows * static_cast<std::size_t>(width));
  }
}

void Recorder::add(const CycleOutput& out, const mjData* data) {
  if (!out.fresh) return;
  const Robot& robot = controller_->robot();
  contact_ = measure_contact(robot, data);
  // The cycle's plane, through the sole where the contacts found it.
  const Plane plane = Plane::through(contact_.sole[out.support > 0 ? kLeft : kRight], out.zmp_plane.head<3>());
  const RecordedCycle cycle{out,
                            measured_zmp(contact_, plane),
                            contact_.wrench,
                            contact_.self_contacts,
                            robot.joint_margin(data),
                            robot.qpos(),
                            robot.qvel()};
  auto column = columns_.begin();
  visit_columns([&](const char*, const auto& get, const auto&...) { append(column_value(get, cycle), *column++); });
  ++rows_;
}

void Recorder::mark_fall() {
  for (Column& column : columns_)
    if (column.name == "fell" && !column.values.empty()) column.values.back() = 1.0;
}

Simulation::Simulation(WalkingController& controller)
    : controller_(controller), data_(mj_makeData(controller.robot().model())) {
  const Robot& robot = controller.robot();
  robot.description().place(robot.model(), data_.get(), -kTouchDepth);
  const MeasuredContact contact = measure_contact(robot, data_.get());
  for (const Side side : kSides)
    if (std::isnan(contact.wrench[6 * side]))
      throw ModelError("at the start pose the foot '" + robot.description().feet[side].body +
                       "' touches nothing: the model needs a floor at z = 0 that its feet collide with");
  mj_resetData(robot.model(), data_.get());
  robot.description().place(robot.model(), data_.get());
}

Simulation::~Simulation() = default;

RunResult Simulation::run(double duration, Recorder& recorder, const std::function<bool(double)>& progress,
                          double progress_interval, const std::function<bool(const CycleOutput&)>& after_cycle,
                          double cycle_interval) {
  require_positive("duration", duration);
  const Robot& robot = controller_.robot();
  const mjModel* m = robot.model();
  mjData* d = data_.get();
  controller_.reset(d);
  const double t_end = d->time + duration, dt = m->opt.timestep;
  const bool in_two = m->opt.integrator != mjINT_RK4;  // MuJoCo cannot part a Runge-Kutta step
  RunResult result;
  result.cycle_us.reserve(
      static_cast<std::size_t>(std::min(duration, kReservedTime) / controller_.settings().control.dt) + 2);
  double airborne = 0.0;
  Sensed felt;  // by the feet, in the step before
  const long every = std::max(1L, std::lround(cycle_interval / controller_.settings().control.dt));
  long cycle = 0;
  const auto start = std::chrono::steady_clock::now();
  double reported = 0.0;
  while (d->time + 0.5 * dt < t_end) {
    if (!robot.is_finite(d) || diverged(d)) {
      result.fell = Fall::kNonFinite;
      break;
    }
    const double t = d->time;
    if (in_two) mj_step1(m, d);
    if (diverged(d)) {  // MuJoCo has reset itself, and with it the clock: what it holds now is no state of the walk
      d->time = t;
      result.fell = Fall::kNonFinite;
      break;
    }
    const auto before = std::chrono::steady_clock::now();
    const CycleOutput& out = controller_.update(d, in_two ? Terms::kInData : Terms::kCompute, felt);
    if (out.fresh) result.cycle_us.push_back(1e6 * seconds_since(before));
    if (after_cycle && out.fresh && cycle++ % every == 0 && !after_cycle(out)) result.stopped = true;
    if (in_two)
      mj_step2(m, d);
    else
      mj_step(m, d);
    if (diverged(d)) d->time = t + dt;
    recorder.add(out, d);
    if (out.fresh) {
      felt = felt_by(recorder.contact());
      const bool touches = felt.contact[kLeft] + felt.contact[kRight] > 0.0;
      airborne = touches ? 0.0 : airborne + controller_.settings().control.dt;
    }
    result.fell = out.fell != Fall::kNone ? out.fell : airborne > kLongestFlight ? Fall::kNoContact : Fall::kNone;
    if (result.fell != Fall::kNone || result.stopped) break;
    if (!progress) continue;
    const double wall = seconds_since(start);
    if (wall - reported < progress_interval) continue;
    reported = wall;
    if (!progress(d->time)) {
      result.stopped = true;
      break;
    }
  }
  if (result.fell != Fall::kNone) {
    result.fall_time = d->time;
    recorder.mark_fall();
  }
  result.wall_time = seconds_since(start);
  return result;
}

}  // namespace zmpwalk
