// The control cycle alone, for tools that want a program: callgrind counts its instructions (benchmarks/instructions.py), and
// two builds of it are timed against each other (benchmarks/native.py).

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "zmpwalk/benchmark.hpp"

using namespace zmpwalk;

namespace {

/// Callgrind collects inside this function alone: --toggle-collect=counted_update*.
__attribute__((noinline)) void counted_update(WalkingController& controller, mjData* d, Terms terms) {
  controller.update(d, terms);
}

/// One whole step of the paper's walk, [1.6, 2.4) s; its cycles of one phase are counted. Prints how many there were.
int count(const mjModel* m, Phase phase, Terms terms, const std::string& kernel) {
  const RobotDescription description = describe(m);
  WalkSettings settings;
  settings.control.kernel = kernel;
  WalkingController controller(m, description, settings);
  MjDataPtr data(mj_makeData(m));
  mjData* d = data.get();
  description.place(m, d);
  controller.reset(d);
  const WalkSettings& used = controller.settings();
  Schedule schedule(used.gait.T_ds_first, used.gait.T_ds,
                    used.gait.T_ss);  // as it is in this walk, whose steps are all slow
  int cycles = 0;
  while (d->time < 2.4) {
    mj_step1(m, d);
    if (schedule.landed(d->time)) schedule.next(schedule.times());
    if (d->time >= 1.6 && schedule.at(d->time).phase == phase) {
      counted_update(controller, d, terms);
      ++cycles;
    } else {
      controller.update(d, terms);
    }
    mj_step2(m, d);
  }
  std::printf("%d\n", cycles);
  return 0;
}

/// Prints min and median of the whole cycle, in the loop and from scratch [us].
int time(const mjModel* m, double duration) {
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
  if (what != "time" && !(what == "count" && argc > 5)) {
    std::fprintf(stderr, "usage: cycle MJCF time | cycle MJCF count single|double in_loop|from_scratch KERNEL\n");
    return 2;
  }
  char error[1000] = "";
  mjModel* m = mj_loadXML(argv[1], nullptr, error, sizeof error);
  if (!m) {
    std::fprintf(stderr, "%s\n", error);
    return 2;
  }
  const int code = what == "time"
                       ? time(m, 8.0)
                       : count(m, std::string(argv[3]) == "single" ? Phase::kSingleSupport : Phase::kDoubleSupport,
                               std::string(argv[4]) == "in_loop" ? Terms::kInData : Terms::kCompute, argv[5]);
  mj_deleteModel(m);
  return code;
}
