#include "zmpwalk/benchmark.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/zmp/reference_iteration.hpp"

namespace zmpwalk {
namespace {

using Clock = std::chrono::steady_clock;

template <class Body>
double microseconds(Body&& body) {
  const auto start = Clock::now();
  body();
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

WholeBodyOptions options_of(const WalkingController& controller, bool textbook) {
  WholeBodyOptions options = controller.whole_body().options();
  options.textbook = textbook;
  return options;
}

/// A walk is timed in parts of a step, or beside a loop of whole ones.
void require_halves(const mjModel* model) {
  if (model->opt.integrator == mjINT_RK4)
    throw InputError("the model integrates by Runge-Kutta (RK4), whose step MuJoCo cannot part; use Euler or implicit");
}

double relative(const ConstVecRef& a, const ConstVecRef& b) { return (a - b).norm() / std::max(b.norm(), 1e-12); }

constexpr double kPiece =
    0.02;  // length of the piece of a walk that is timed at once [s]; short beside the time that a busy machine gives to others

/// The controls that a walk writes into MuJoCo's data, step by step.
struct Commands {
  int nu, nv;
  std::vector<double> ctrl, applied;

  void take(const mjData* d) {
    ctrl.insert(ctrl.end(), d->ctrl, d->ctrl + nu);
    applied.insert(applied.end(), d->qfrc_applied, d->qfrc_applied + nv);
  }
  std::size_t steps() const { return applied.size() / static_cast<std::size_t>(nv); }
  void give(std::size_t step, mjData* d) const {
    std::copy_n(ctrl.begin() + static_cast<long>(step) * nu, nu, d->ctrl);
    std::copy_n(applied.begin() + static_cast<long>(step) * nv, nv, d->qfrc_applied);
  }
};

Commands commands_of(WalkingController& controller, double duration) {
  const mjModel* m = controller.robot().model();
  const MjDataPtr data(mj_makeData(m));
  mjData* d = data.get();
  controller.robot().description().place(m, d);
  controller.reset(d);
  Commands out{static_cast<int>(m->nu), static_cast<int>(m->nv), {}, {}};
  while (d->time < duration && controller.output().fell == Fall::kNone) {
    mj_step1(m, d);
    controller.update(d, Terms::kInData);
    out.take(d);
    mj_step2(m, d);
  }
  return out;
}

}  // namespace

CycleBenchmark::CycleBenchmark(const mjModel* model, const RobotDescription& description, const WalkSettings& settings,
                               const VelocityProfile& profile)
    : controller_(model, description, settings, profile),
      from_state_(model, description, settings, profile),
      robot_(model, description),
      robot_from_state_(model, description),
      direct_(robot_.nv(), robot_.leg_joints(), options_of(controller_, false)),
      textbook_(robot_.nv(), robot_.leg_joints(), options_of(controller_, true)),
      data_(mj_makeData(model)) {
  require_halves(model);
  description.place(model, data_.get());
}

std::vector<Column> CycleBenchmark::run(double duration, int textbook_every,
                                        const std::function<bool(double)>& progress) {
  require_positive("duration", duration);
  const mjModel* m = robot_.model();
  mjData* d = data_.get();
  std::vector<Column> columns;
  for (const char* name : {"phase", "in_loop", "from_scratch", "step", "terms", "terms_from_scratch", "algebra",
                           "iteration", "other", "textbook", "difference"})
    columns.push_back({name, 1, {}});
  controller_.reset(d);
  from_state_.reset(d);
  WholeBodyResult fast = direct_.result(), printed = textbook_.result();
  const double t_end = d->time + duration;
  auto reported = Clock::now();
  for (long k = 0; d->time + 0.5 * m->opt.timestep < t_end; ++k) {
    const double from_scratch = microseconds([&] { from_state_.update(d); });
    const double terms_from_scratch = microseconds([&] { robot_from_state_.read(d); });
    double step = microseconds([&] { mj_step1(m, d); });
    const double terms = microseconds([&] { robot_.read_computed(d); });
    const double in_loop = microseconds([&] { controller_.update(d, Terms::kInData); });
    const CycleOutput& out = controller_.output();
    const Dynamics& dyn = robot_.dynamics();
    const Vec2& f_xy = controller_.com_acceleration();
    const double algebra = microseconds([&] {
      direct_.prepare(dyn, controller_.stance(), controller_.tasks());
      direct_.zmp(f_xy);
      direct_.solve(f_xy, fast);
    });
    // The loop as the controller runs it: reference to COM acceleration to estimate, one axis, 20 mm to go.
    const double df_dr = -1.0 / (controller_.Tc() * controller_.Tc());
    const Vec2 start = direct_.zmp(f_xy), wanted = start + Vec2(0.02, 0.0);
    ReferenceResult found;
    const double iteration = microseconds([&] {
      found = iterate_reference([&](const Vec2& r) { return direct_.zmp(f_xy + df_dr * (r - start)); }, wanted, start,
                                Vec2(1.0, 0.0), controller_.settings().zmp.threshold,
                                controller_.settings().zmp.max_iterations);
    });
    double textbook = kNaN, difference = kNaN;
    if (textbook_every > 0 && k % textbook_every == 0 && !fast.damped) {
      textbook = microseconds([&] {
        textbook_.prepare(dyn, controller_.stance(), controller_.tasks());
        textbook_.zmp(f_xy);
        textbook_.solve(f_xy, printed);
      });
      difference = std::max(relative(fast.tau, printed.tau), relative(direct_.zmp(f_xy), textbook_.zmp(f_xy)));
      for (const Side side : kSides)
        if (controller_.stance().standing[side])
          difference = std::max(difference, relative(fast.f_c.segment<6>(6 * side), printed.f_c.segment<6>(6 * side)));
    }
    step += microseconds([&] { mj_step2(m, d); });
    if (out.fresh) {
      const double row[] = {
          double(out.phase),         in_loop,  from_scratch, step, terms, terms_from_scratch, algebra, iteration,
          in_loop - terms - algebra, textbook, difference};
      for (std::size_t i = 0; i < columns.size(); ++i) columns[i].values.push_back(row[i]);
    }
    if (out.fell != Fall::kNone) break;
    if (!progress || Clock::now() - reported < std::chrono::milliseconds(50)) continue;
    reported = Clock::now();
    if (!progress(d->time)) break;
  }
  return columns;
}

std::vector<Column> benchmark_walk(const mjModel* model, const RobotDescription& description,
                                   const WalkSettings& settings, const VelocityProfile& profile, double duration,
                                   const std::function<bool(double)>& progress) {
  require_positive("duration", duration);
  require_halves(model);
  WalkingController controller(model, description, settings, profile);
  const Commands commands = commands_of(controller, duration);
  Simulation simulation(controller);
  Recorder recorder(controller, duration);
  const mjData* walking = simulation.data();
  const MjDataPtr data(mj_makeData(model));
  mjData* d = data.get();
  description.place(model, d);
  std::vector<Column> columns{{"walk", 1, {}}, {"bare", 1, {}}, {"difference", 1, {}}};
  std::size_t done = 0;
  Clock::time_point start;
  const auto after_piece = [&](const CycleOutput&) {
    const double walked = std::chrono::duration<double, std::micro>(Clock::now() - start).count();
    const auto steps = static_cast<std::size_t>(std::lround((walking->time - d->time) / model->opt.timestep));
    const std::size_t end = std::min(done + steps, commands.steps());
    const double bare = microseconds([&] {
      for (; done < end; ++done) {
        commands.give(done, d);
        mj_step(model, d);
      }
    });
    if (steps > 0) {
      const double count = static_cast<double>(steps);
      // Velocities are compared: the walk is half way into its next step, where MuJoCo has normalised the quaternions of qpos.
      const Eigen::Map<const VecX> qvel(walking->qvel, model->nv), of_bare(d->qvel, model->nv);
      columns[0].values.push_back(walked / count);
      columns[1].values.push_back(bare / count);
      columns[2].values.push_back((qvel - of_bare).cwiseAbs().maxCoeff());
    }
    start = Clock::now();
    return true;
  };
  simulation.run(duration, recorder, progress, 0.1, after_piece, kPiece);
  return columns;
}

}  // namespace zmpwalk
