// The control cycle and a plan alone, for tools that want a program: callgrind counts their instructions
// (benchmarks/instructions.py), and two builds of the cycle are timed against each other (benchmarks/native.py).

#include <dlfcn.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "zmpwalk/benchmark.hpp"

using namespace zmpwalk;

namespace {

/// Callgrind collects inside the functions whose names begin with `counted`: --toggle-collect=*counted_*.
__attribute__((noinline)) void counted_update(WalkingController& controller, const Data& d, Terms terms) {
  controller.update(d, terms);
}

__attribute__((noinline)) std::size_t counted_plan(const WalkingController& controller) {
  return controller.plan(3.2, 0.01).t.size();
}

WalkSettings with_kernel(const std::string& name) {
  WalkSettings settings;
  settings.control.kernel = name;
  return settings;
}

/// One whole step of the paper's walk, [1.6, 2.4) s; its cycles of one phase are counted. Prints how many there were.
int count(const Model& m, Phase phase, Terms terms, const std::string& kernel) {
  const RobotDescription description = describe(m);
  WalkingController controller(m, description, with_kernel(kernel));
  const OwnData d(m);
  description.place(m, d);
  controller.reset(d);
  const WalkSettings& used = controller.settings();
  Schedule schedule(used.gait.T_ds_first, used.gait.T_ds,
                    used.gait.T_ss);  // as it is in this walk, whose steps are all slow
  int cycles = 0;
  while (*d.time < 2.4) {
    mj::step1(m, d);
    if (schedule.landed(*d.time)) schedule.next(schedule.times());
    if (*d.time >= 1.6 && schedule.at(*d.time).phase == phase) {
      counted_update(controller, d, terms);
      ++cycles;
    } else {
      controller.update(d, terms);
    }
    mj::step2(m, d);
  }
  std::printf("%d\n", cycles);
  return 0;
}

/// The plan that `make bench` times: 3.2 s of footsteps, COM and ZMP of the paper's walk, every 10 ms. Prints that it was one.
int count_plan(const Model& m, const std::string& kernel) {
  const WalkingController controller(m, describe(m), with_kernel(kernel));
  if (counted_plan(controller) == 0) return 2;
  std::printf("1\n");
  return 0;
}

/// Prints min and median of the whole cycle, in the loop and from scratch [us].
int time(const Model& m, double duration) {
  CycleBenchmark benchmark(m, describe(m), WalkSettings(), VelocityProfile::paper());
  for (Column& column : benchmark.run(duration, 0)) {
    if (column.name != "in_loop" && column.name != "from_scratch") continue;
    std::sort(column.values.begin(), column.values.end());
    std::printf("%s %.4f %.4f\n", column.name.c_str(), column.values.front(), column.values[column.values.size() / 2]);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 2 ? argv[2] : "";
  if (what != "time" && !(what == "count" && argc > 5) && !(what == "plan" && argc > 3)) {
    std::fprintf(stderr,
                 "usage: cycle MJCF time\n"
                 "       cycle MJCF count single|double in_loop|from_scratch KERNEL\n"
                 "       cycle MJCF plan KERNEL\n");
    return 2;
  }
  connect(zmpwalk_adapter_of, RTLD_DEFAULT);
  char error[1000] = "";
  mjModel* m = mj_loadXML(argv[1], nullptr, error, sizeof error);
  if (!m) {
    std::fprintf(stderr, "%s\n", error);
    return 2;
  }
  int code = 2;
  if (what == "time")
    code = time(m, 8.0);
  else if (what == "plan")
    code = count_plan(m, argv[3]);
  else
    code = count(m, std::string(argv[3]) == "single" ? Phase::kSingleSupport : Phase::kDoubleSupport,
                 std::string(argv[4]) == "in_loop" ? Terms::kInData : Terms::kCompute, argv[5]);
  mj_deleteModel(m);
  return code;
}
