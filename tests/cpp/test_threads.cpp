#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

#include "walk.hpp"
#include "zmpwalk/gait/joint_motion.hpp"

// Several threads at once, for a sanitizer to watch (make sanitize-threads): commands come from another thread than the one that walks; several
// controllers walk with one model; a motion is taken up between two cycles.

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

constexpr double kDuration = 0.5;  // of each walk [s]

VelocityProfile steady(double v) { return {{0.0}, {Vec3(v, 0.0, 0.0)}}; }

VecX last_tau(const Recorder& recorder) {
  for (const Column& column : recorder.columns())
    if (column.name == "tau")
      return Eigen::Map<const VecX>(column.values.data() + column.width * (recorder.rows() - 1), column.width);
  return {};
}

}  // namespace

BOOST_AUTO_TEST_CASE(commands_from_another_thread_reach_a_walk_that_runs) {
  WalkingController controller(mahru(), describe(mahru()), WalkSettings(), steady(0.1));
  Recorder recorder(controller);
  Simulation simulation(controller);
  std::atomic<bool> over{false};
  std::atomic<int> given{0};
  std::vector<std::thread> callers;
  for (int k = 0; k < 2; ++k)
    callers.emplace_back([&, k] {
      while (!over) {
        controller.command({0.1 + 0.01 * k, 0.0, 0.05});
        ++given;
        std::this_thread::yield();
      }
    });
  const RunResult result = simulation.run(kDuration, recorder);
  over = true;
  for (std::thread& caller : callers) caller.join();
  BOOST_CHECK(result.fell == Fall::kNone);
  BOOST_CHECK_GT(given.load(), 0);
  BOOST_CHECK(controller.output().command.allFinite());
}

BOOST_AUTO_TEST_CASE(walks_of_one_model_in_many_threads_are_the_walk_of_one) {
  constexpr int kThreads = 3;
  std::vector<VecX> tau(kThreads + 1);
  const auto walk = [&](int k) {
    WalkingController controller(mahru(), describe(mahru()), WalkSettings(), steady(0.2));
    Recorder recorder(controller);
    Simulation simulation(controller);
    simulation.run(kDuration, recorder);
    tau[k] = last_tau(recorder);
  };
  walk(kThreads);
  std::vector<std::thread> threads;
  for (int k = 0; k < kThreads; ++k) threads.emplace_back(walk, k);
  for (std::thread& thread : threads) thread.join();
  BOOST_REQUIRE_GT(tau[kThreads].size(), 0);
  for (int k = 0; k < kThreads; ++k) CHECK_NEAR(tau[k], tau[kThreads], 0.0);
}

BOOST_AUTO_TEST_CASE(a_motion_is_taken_up_between_two_cycles_while_commands_come) {
  WalkingController controller(mahru(), describe(mahru()), WalkSettings(), steady(0.1));
  Recorder recorder(controller);
  Simulation simulation(controller);
  std::atomic<bool> over{false};
  std::thread caller([&] {
    while (!over) {
      controller.command({0.1, 0.0, 0.0});
      std::this_thread::yield();
    }
  });
  int moved = 0;
  const auto after = [&](const CycleOutput&) {
    controller.move(JointMotion(Vec2(0.0, 1.0), {"l_elbow"}, Vec2(-0.55, -0.8 - 0.01 * (moved % 5))));
    return ++moved > 0;
  };
  const RunResult result = simulation.run(kDuration, recorder, {}, 0.1, after, 0.05);
  over = true;
  caller.join();
  BOOST_CHECK(result.fell == Fall::kNone);
  BOOST_CHECK_EQUAL(moved, 10);
}
