#include "zmpwalk/simulation.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/robot/actuation.hpp"
#include "zmpwalk/robot/contact_forces.hpp"
#include "zmpwalk/robot/mujoco.hpp"
#include "zmpwalk/robot/words.hpp"

namespace zmpwalk {
namespace {

/// Without any contact for this long, the robot no longer walks [s].
constexpr double kLongestFlight = 0.1;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Lowered by this much from its start pose, a robot's feet touch the floor, if there is one [m].
constexpr double kTouchDepth = 0.002;

/// A COM lower than this over the lower sole, as a share of its height at the start, is that of a robot that lies.
constexpr double kLyingHeight = 0.3;

/// Of the COM over the lower sole [m].
double com_height(const Robot& robot, const Data& d) {
  return d.subtree_com[3 * robot.root_body() + 2] -
         std::min(robot.sole_centre(kLeft, d).z(), robot.sole_centre(kRight, d).z());
}

/// The robot in `simulated`, if there is one: what the controller drives must be there, in the order in which it drives it.
std::unique_ptr<Robot> another_robot(const Robot& known, const std::optional<Model>& simulated) {
  if (!simulated) return nullptr;
  known.description().check(*simulated);
  const int root = simulated->jnt_bodyid[known.description().free_joint(*simulated)];
  std::vector<std::string> names;
  for (const int joint : tree_joints(*simulated, root)) names.push_back(object_name(*simulated, mj::kJoint, joint));
  const std::vector<std::string>& want = known.joint_names();
  if (names.size() != want.size())
    throw ModelError("the simulated robot has " + std::to_string(names.size()) + " joints, the controller's has " +
                     std::to_string(want.size()) + ": they must have the same joints in the same order");
  for (std::size_t j = 0; j < want.size(); ++j)
    if (names[j] != want[j])
      throw ModelError("joint " + std::to_string(j) + " of the simulated robot is '" + names[j] +
                       "', of the controller's '" + want[j] + "': they must have the same joints in the same order");
  return std::make_unique<Robot>(*simulated, known.description());
}

}  // namespace

Simulation::Simulation(WalkingController& controller, const Uncertainty& uncertainty,
                       const std::optional<Model>& simulated)
    : controller_(controller),
      apart_(another_robot(controller.robot(), simulated)),
      data_(robot().model()),
      pushes_(robot()),
      direct_(!apart_ && uncertainty.none()),
      sensors_(uncertainty, robot().nv(), robot().timestep()),
      drives_(uncertainty, robot().joints(), robot().timestep()),
      truth_(robot().nv()),
      told_(robot().nv()) {
  const Model& m = robot().model();
  const RobotDescription& description = robot().description();
  description.place(m, data_, -kTouchDepth);
  const MeasuredContact contact = measure_contact(robot(), data_);
  for (const Side side : kSides)
    if (std::isnan(contact.wrench[6 * side]))
      throw ModelError("at the start pose the foot '" + description.feet[side].body +
                       "' touches nothing: the model needs a floor at z = 0 that its feet collide with");
  mj::reset_data(m, data_);
  description.place(m, data_);
  start_height_ = com_height(robot(), data_);
}

Simulation::~Simulation() = default;

const CycleOutput& Simulation::control(Terms terms) {
  const Data& d = data_;
  if (direct_) return controller_.update(d, terms, felt_);
  told_ = sensors_.measure(truth_);
  robot().observe(d, truth_);  // once more for the record: MuJoCo has normalized its quaternion
  static_cast<Sensed&>(told_) = felt_;
  const CycleOutput& out = controller_.update(told_);
  robot().write_torque(drives_.act(out.tau), d);
  return out;
}

Fall Simulation::lies() const {
  const Model& m = robot().model();
  const Data& d = data_;
  if (com_height(robot(), d) < kLyingHeight * start_height_) return Fall::kDown;
  for (int i = 0; i < *d.ncon; ++i) {
    const zmpwalk_contact contact = mj::contact(d, i);
    if (contact.geom[0] < 0 || contact.geom[1] < 0) continue;  // not between two geoms
    const int body_1 = m.geom_bodyid[contact.geom[0]], body_2 = m.geom_bodyid[contact.geom[1]];
    const bool is_first = robot().is_robot(body_1);
    const int own = is_first ? body_1 : body_2, other = is_first ? body_2 : body_1;
    if (robot().is_robot(own) && m.body_weldid[other] == 0 && !robot().is_leg(own)) return Fall::kDown;
  }
  return Fall::kNone;
}

RunResult Simulation::run(double duration, Recorder& recorder, const std::function<bool(double)>& progress,
                          double progress_interval, const std::function<bool(const CycleOutput&)>& after_cycle,
                          double cycle_interval, OnFall on_fall) {
  require_positive("duration", duration);
  const Model& m = robot().model();
  const Data& d = data_;
  if (!started_) {
    robot().observe(d, truth_);
    controller_.reset(truth_);
  }
  started_ = true;
  const double t_end = *d.time + duration, dt = *m.timestep;
  const bool in_two = *m.integrator != mj::kRungeKutta;  // MuJoCo cannot part a Runge-Kutta step
  RunResult result;
  result.cycle_us.reserve(rows_within(duration, controller_.settings().control.dt));
  const long every = std::max(1L, std::lround(cycle_interval / controller_.settings().control.dt));
  long cycle = 0;
  const auto start = std::chrono::steady_clock::now();
  double reported = 0.0;
  while (*d.time + 0.5 * dt < t_end) {
    if (!robot().is_finite(d) || mj::diverged(d)) {
      result.fell = Fall::kNonFinite;
      break;
    }
    const double t = *d.time;
    pushes_.apply(t, d);
    if (!direct_) robot().observe(d, truth_);
    if (in_two) mj::step1(m, d);
    if (mj::diverged(d)) {  // MuJoCo has reset itself, and with it the clock: what it holds now is no state of the walk
      *d.time = t;
      result.fell = Fall::kNonFinite;
      break;
    }
    const auto before = std::chrono::steady_clock::now();
    const CycleOutput& out = control(in_two ? Terms::kInData : Terms::kCompute);
    if (out.fresh) result.cycle_us.push_back(1e6 * seconds_since(before));
    if (after_cycle && out.fresh && cycle++ % every == 0 && !after_cycle(out)) result.stopped = true;
    if (in_two)
      mj::step2(m, d);
    else
      mj::step(m, d);
    if (mj::diverged(d)) *d.time = t + dt;
    if (direct_)
      recorder.add(out, d);
    else
      recorder.add(out, d, robot(), truth_);
    if (out.fresh) {
      felt_ = felt_by(recorder.contact());
      const bool touches = felt_.contact[kLeft] + felt_.contact[kRight] > 0.0;
      airborne_ = touches ? 0.0 : airborne_ + controller_.settings().control.dt;
    }
    const Fall word = out.fell != Fall::kNone ? out.fell : airborne_ > kLongestFlight ? Fall::kNoContact : Fall::kNone;
    const Fall alarm = out.foreseen ? out.foreseen.cause : word;
    if (result.alarm == Fall::kNone && alarm != Fall::kNone) {
      result.alarm = alarm;
      result.alarm_time = *d.time;
      result.alarm_text = out.foreseen ? to_string(out.foreseen) : to_string(word);
    }
    result.fell = on_fall == OnFall::kStop || word == Fall::kNonFinite ? word : lies();
    if (result.fell != Fall::kNone || result.stopped) break;
    if (!progress) continue;
    const double wall = seconds_since(start);
    if (wall - reported < progress_interval) continue;
    reported = wall;
    if (!progress(*d.time)) {
      result.stopped = true;
      break;
    }
  }
  if (result.fell != Fall::kNone) {
    result.fall_time = *d.time;
    recorder.mark_fall();
  }
  if (result.alarm == Fall::kNone) {
    result.alarm = result.fell;
    result.alarm_time = result.fall_time;
    result.alarm_text = to_string(result.fell);
  }
  result.wall_time = seconds_since(start);
  return result;
}

}  // namespace zmpwalk
