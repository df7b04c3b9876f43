#include "zmpwalk/simulation.hpp"

#include <algorithm>
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

}  // namespace

Recorder::Recorder(const WalkingController& controller, double duration) : controller_(&controller) {
  const auto rows =
      static_cast<std::size_t>(std::clamp(duration, 0.0, kReservedTime) / controller.settings().control.dt) + 2;
  const int nv = controller.robot().nv(), joints = nv - 6;
  const std::vector<std::pair<const char*, int>> layout{{"t", 1},
                                                        {"com", 3},
                                                        {"dcom", 3},
                                                        {"com_des", 3},
                                                        {"dcom_des", 3},
                                                        {"heading", 1},
                                                        {"command", 3},
                                                        {"v_plan", 3},
                                                        {"v_des", 3},
                                                        {"v_error_integral", 3},
                                                        {"zmp_des", 2},
                                                        {"zmp_ref", 2},
                                                        {"zmp_est", 2},
                                                        {"zmp_meas", 2},
                                                        {"zmp_lower", 2},
                                                        {"zmp_upper", 2},
                                                        {"zmp_first", 2},
                                                        {"zmp_slope", 2},
                                                        {"zmp_modified", 2},
                                                        {"phase", 1},
                                                        {"support", 1},
                                                        {"step", 1},
                                                        {"at_rest", 1},
                                                        {"phase_time", 1},
                                                        {"w_T", 1},
                                                        {"iterations", 1},
                                                        {"foothold", 3},
                                                        {"foot_left", 7},
                                                        {"foot_right", 7},
                                                        {"tau", joints},
                                                        {"f_c", 12},
                                                        {"contact_wrench", 12},
                                                        {"torque_ratio", 1},
                                                        {"saturated", 1},
                                                        {"damped", 1},
                                                        {"self_contacts", 1},
                                                        {"joint_margin", 1},
                                                        {"fell", 1},
                                                        {"qpos", nv + 1},
                                                        {"qvel", nv}};
  for (const auto& [name, width] : layout) {
    columns_.push_back({name, width, {}});
    columns_.back().values.reserve(rows * static_cast<std::size_t>(width));
  }
}

template <class Derived>
void Recorder::push(const Eigen::DenseBase<Derived>& values) {
  Column& column = columns_[next_++];
  for (Eigen::Index i = 0; i < values.size(); ++i) column.values.push_back(values(i));
}

void Recorder::push(double value) { columns_[next_++].values.push_back(value); }

void Recorder::add(const CycleOutput& out, const mjData* data) {
  if (!out.fresh) return;
  const Robot& robot = controller_->robot();
  contact_ = measure_contact(robot, data);
  const double plane = contact_.sole[out.support > 0 ? kLeft : kRight].z();
  next_ = 0;
  push(out.t);
  push(out.com);
  push(out.dcom);
  push(out.com_des);
  push(out.dcom_des);
  push(out.heading);
  push(out.command);
  push(out.v_plan);
  push(out.v_des);
  push(out.v_error_integral);
  push(out.zmp_des);
  push(out.zmp_ref);
  push(out.zmp_est);
  push(measured_zmp(contact_, plane));
  push(out.zmp_lower);
  push(out.zmp_upper);
  push(out.zmp_first);
  push(out.zmp_slope);
  push(out.zmp_modified);
  push(out.phase);
  push(out.support);
  push(out.step);
  push(out.at_rest);
  push(out.phase_time);
  push(out.w_T);
  push(out.iterations);
  push(out.foothold);
  push(out.foot[kLeft]);
  push(out.foot[kRight]);
  push(out.tau);
  push(out.f_c);
  push(contact_.wrench);
  push(out.torque_ratio);
  push(out.saturated);
  push(out.damped);
  push(contact_.self_contacts);
  push(robot.joint_margin(data));
  push(out.fell != Fall::kNone);
  push(robot.qpos());
  push(robot.qvel());
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
    const auto before = std::chrono::steady_clock::now();
    const CycleOutput& out = controller_.update(d, in_two ? Terms::kInData : Terms::kCompute);
    if (out.fresh) result.cycle_us.push_back(1e6 * seconds_since(before));
    if (after_cycle && out.fresh && cycle++ % every == 0 && !after_cycle(out)) result.stopped = true;
    if (in_two)
      mj_step2(m, d);
    else
      mj_step(m, d);
    if (diverged(d)) d->time = t + dt;  // MuJoCo has reset itself, and with it the clock
    recorder.add(out, d);
    if (out.fresh) {
      const bool touches = !std::isnan(recorder.contact().wrench[2]) || !std::isnan(recorder.contact().wrench[8]);
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
