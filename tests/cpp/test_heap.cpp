#include <dlfcn.h>
#include <pthread.h>

#include <cstddef>
#include <mutex>
#include <new>

#include "robots.hpp"
#include "zmpwalk/control/tasks/frame.hpp"
#include "zmpwalk/control/tasks/joint.hpp"
#include "zmpwalk/control/tasks/momentum.hpp"
#include "zmpwalk/simulation.hpp"
#include "zmpwalk/simulation/uncertainty.hpp"
#include "zmpwalk/walk/walking_controller.hpp"

// The control cycle does not touch the heap: Eigen's own watch aborts with a line number, and every malloc of this program,
// MuJoCo's and the standard library's too, and every mutex taken, is counted while a cycle runs.

namespace {

thread_local bool watching = false;
thread_local long allocations = 0, locks = 0;

}  // namespace

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
#define ZMPWALK_COUNTS_MALLOC 1
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

__attribute__((visibility("default"))) void* malloc(std::size_t size) noexcept {
  allocations += watching;
  return __libc_malloc(size);
}
__attribute__((visibility("default"))) void* calloc(std::size_t count, std::size_t size) noexcept {
  allocations += watching;
  return __libc_calloc(count, size);
}
__attribute__((visibility("default"))) void* realloc(void* old, std::size_t size) noexcept {
  allocations += watching;
  return __libc_realloc(old, size);
}
__attribute__((visibility("default"))) void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  allocations += watching;
  return __libc_memalign(alignment, size);
}
}

// Locks too: the one a mutex takes, under the name that the C library itself uses.
__attribute__((visibility("default"))) int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  static const auto next = reinterpret_cast<int (*)(pthread_mutex_t*)>(dlsym(RTLD_NEXT, "pthread_mutex_lock"));
  locks += watching;
  return next(mutex);
}
#else
#define ZMPWALK_COUNTS_MALLOC 0
#endif

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

/// Allocations while `body` runs.
template <class Body>
long allocated(Body&& body) {
  allocations = locks = 0;
  Eigen::internal::set_is_malloc_allowed(false);
  watching = true;
  body();
  watching = false;
  Eigen::internal::set_is_malloc_allowed(true);
  return allocations;
}

/// What a walk went through, and how often its cycles and its recording allocated.
struct Seen {
  long cycles = 0, recording = 0, locks = 0;
  bool single = false, both = false, left = false, right = false, modified = false, saturated = false, held = false;
  int steps = 0;
  std::size_t rows = 0;
};

Seen walk(double duration, const WalkSettings& s, const mjModel* m = mahru(), Terms terms = Terms::kCompute,
          const JointMotion& motion = JointMotion(), const std::vector<Vec3>& commands = {},
          const KnownGround& ground = KnownGround()) {
  WalkingController controller(m, describe(mahru()), s);
  controller.move(motion);
  controller.know(ground);
  Recorder recorder(controller, duration);
  const MjDataPtr d = make_data(m);
  controller.robot().description().place(m, d.get());
  controller.reset(d.get());
  Seen seen;
  while (d->time < duration) {
    const CycleOutput* out = nullptr;
    if (seen.rows % 400 == 200 && seen.rows / 400 < commands.size()) controller.command(commands[seen.rows / 400]);
    ++seen.rows;
    if (terms == Terms::kInData) mj_step1(m, d.get());
    seen.cycles += allocated([&] { out = &controller.update(d.get(), terms); });
    seen.locks += locks;
    if (terms == Terms::kInData)
      mj_step2(m, d.get());
    else
      mj_step(m, d.get());
    seen.recording += allocated([&] { recorder.add(*out, d.get()); });
    (out->phase ? seen.single : seen.both) = true;
    (out->support > 0 ? seen.left : seen.right) = true;
    seen.modified |= out->iterations > 0;
    seen.saturated |= out->saturated;
    seen.held |= out->limits.any();
    seen.steps = out->step;
  }
  return seen;
}

void stays_off_the_heap(const Seen& seen) {
  BOOST_CHECK_EQUAL(seen.cycles, 0);
  BOOST_CHECK_EQUAL(seen.recording, 0);
  BOOST_CHECK_EQUAL(seen.locks, 0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_watch_sees_allocations_of_every_kind) {
#if ZMPWALK_COUNTS_MALLOC
  void* volatile memory = nullptr;  // volatile, or the compiler does without the allocation
  BOOST_CHECK_GE(allocated([&] { memory = ::operator new(100); }), 1);
  ::operator delete(memory);
  BOOST_CHECK_GE(allocated([] { mj_deleteData(mj_makeData(mahru())); }), 1);  // in another library
#endif
  std::mutex mutex;
  allocated([&] { const std::lock_guard<std::mutex> lock(mutex); });
  BOOST_CHECK_EQUAL(locks, ZMPWALK_COUNTS_MALLOC);
  BOOST_CHECK_EQUAL(allocated([] {}), 0);
  BOOST_CHECK_EQUAL(locks, 0);
}

BOOST_AUTO_TEST_CASE(cycle_of_the_default_law_allocates_nothing) {
  const Seen seen = walk(3.0, WalkSettings());
  stays_off_the_heap(seen);
  BOOST_CHECK(seen.single && seen.both && seen.left && seen.right && seen.modified);
  BOOST_CHECK_GE(seen.steps, 3);
}

BOOST_AUTO_TEST_CASE(cycle_on_known_ground_allocates_nothing) {
  // Low treads that are not there: places are searched, swings shaped and heights followed all the same.
  std::vector<GroundPatch> patches{{Vec2(-3, -2), Vec2(0.4, 2), 0.0, Vec2::Zero()}};
  for (int k = 0; k < 10; ++k)
    patches.push_back({Vec2(0.4 + 0.28 * k, -2), Vec2(0.68 + 0.28 * k, 2), k % 2 ? 0.0 : 0.002, Vec2(0.0, 0.01)});
  const Seen seen = walk(3.0, WalkSettings(), mahru(), Terms::kCompute, JointMotion(), {}, KnownGround(patches));
  stays_off_the_heap(seen);
  BOOST_CHECK(seen.single && seen.both && seen.left && seen.right);
}

BOOST_AUTO_TEST_CASE(cycle_on_mujocos_terms_allocates_nothing) {
  const Seen seen = walk(3.0, WalkSettings(), mahru(), Terms::kInData);
  stays_off_the_heap(seen);
  BOOST_CHECK(seen.single && seen.both && seen.left && seen.right && seen.modified);
}

BOOST_AUTO_TEST_CASE(cycle_of_the_paper_law_allocates_nothing) {
  const Seen seen = walk(3.0, WalkSettings("paper"));
  stays_off_the_heap(seen);
  BOOST_CHECK(seen.single && seen.both && seen.left && seen.right && seen.modified);
}

BOOST_AUTO_TEST_CASE(cycle_with_absolute_footholds_and_held_torque_allocates_nothing) {
  WalkSettings s;
  s.steps.mode = Footsteps::kAbsolute;
  s.control.dt = 0.004;
  stays_off_the_heap(walk(2.0, s));
}

BOOST_AUTO_TEST_CASE(cycle_that_cuts_a_torque_allocates_nothing) {
  // Knees that cannot quite hold the body: the estimate is then that of the cut torque.
  const ModelPtr weak =
      load_text(replaced(mahru_text(), "<motor ctrlrange=\"-160 160\"/>", "<motor ctrlrange=\"-40 40\"/>"));
  WalkSettings s;
  s.limits.keep = false;
  const Seen seen = walk(0.4, s, weak.get());
  stays_off_the_heap(seen);
  BOOST_CHECK(seen.saturated && seen.single && seen.both);
}

BOOST_AUTO_TEST_CASE(cycle_that_keeps_limits_allocates_nothing) {
  WalkSettings s;
  s.control.torque_limits = {{"l_knee", 60.0}, {"r_knee", 60.0}};
  const Seen few = walk(2.0, s);
  stays_off_the_heap(few);
  BOOST_CHECK(few.held && !few.saturated && few.single && few.both);
  // Weak hips too: the soles' limits give.
  for (const char* joint : {"l_hip_roll", "r_hip_roll"}) s.control.torque_limits[joint] = 10.0;
  const Seen many = walk(0.6, s);
  stays_off_the_heap(many);
  BOOST_CHECK(many.held);
}

BOOST_AUTO_TEST_CASE(cycle_with_tasks_that_come_and_go_and_a_known_force_allocates_nothing) {
  WalkSettings s;
  s.arms.momentum = 1.0;
  WalkingController controller(mahru(), describe(mahru()), s);
  const MjDataPtr d = make_data(mahru());
  controller.robot().description().place(mahru(), d.get());
  const auto hand = std::make_shared<FrameTask>("left_hand");
  const auto other = std::make_shared<FrameTask>("right_hand", FramePart::kOrientation, RelativeTo::kWalk);
  const auto elbow = std::make_shared<JointTask>(std::vector<std::string>{"r_elbow"});
  const auto momentum = std::make_shared<MomentumTask>(MomentumTask::Axes::kAll);
  for (const std::shared_ptr<Task>& task : std::vector<std::shared_ptr<Task>>{hand, other, elbow, momentum})
    controller.add(task);
  controller.reset(d.get());
  Sensed carried;
  carried.external = {{controller.watch("right_hand"), (Vec6() << 0, 0, -5, 0, 0, 0).finished()}};
  long cycles = 0;
  for (int k = 0; k < 2000; ++k) {
    if (k == 600) controller.remove(*hand);
    if (k == 900) controller.remove(*elbow);
    if (k == 1000) controller.add(elbow);
    cycles += allocated([&] { controller.update(d.get(), Terms::kCompute, carried); });
    mj_step(mahru(), d.get());
  }
  BOOST_CHECK_EQUAL(cycles, 0);
  BOOST_CHECK(controller.output().fell == Fall::kNone);
}

BOOST_AUTO_TEST_CASE(cycle_that_moves_waist_trunk_and_arms_allocates_nothing) {
  WalkSettings s;
  s.arms.momentum = 1.0;
  const RowMatX q = (RowMatX(2, 3) << 0, 0, -0.5, 0.3, 0.1, -1.0).finished();
  const JointMotion motion(Vec2(0, 0.7), {"waist_yaw", "trunk_pitch", "l_elbow"}, q);
  stays_off_the_heap(walk(1.5, s, mahru(), Terms::kCompute, motion));
}

BOOST_AUTO_TEST_CASE(cycle_that_takes_commands_allocates_nothing_and_takes_no_lock) {
  const std::vector<Vec3> commands{{0.3, 0, 0}, {0.1, 0.1, 0.3}, {-0.2, 0, -0.2}, {0, 0, 0}};
  stays_off_the_heap(walk(2.5, WalkSettings(), mahru(), Terms::kCompute, JointMotion(), commands));
}

BOOST_AUTO_TEST_CASE(cycle_that_feels_the_ground_allocates_nothing) {
  WalkSettings s;
  s.gait.touch_down = TouchDown::kContact;
  stays_off_the_heap(walk(2.0, s));
}

BOOST_AUTO_TEST_CASE(cycle_that_makes_up_for_a_force_and_a_noisy_attitude_allocates_nothing) {
  WalkingController controller(mahru(), describe(mahru()));
  const MjDataPtr d = make_data(mahru());
  controller.robot().description().place(mahru(), d.get());
  controller.reset(d.get());
  Uncertainty unsure;
  unsure.noise.attitude = 0.005;
  Sensors sensors(unsure, controller.robot().nv(), 0.001);
  State truth(controller.robot().nv());
  long cycles = 0;
  double least = 1.0;
  for (int k = 0; k < 1500; ++k) {
    d->xfrc_applied[6 * controller.robot().root_body() + 1] = 20.0;
    controller.robot().observe(d.get(), truth);
    const State& told = sensors.measure(truth);
    const CycleOutput* out = nullptr;
    cycles += allocated([&] { out = &controller.update(told); });
    controller.robot().write_torque(out->tau, d.get());
    mj_step(mahru(), d.get());
    if (k >= 1000) least = std::min(least, out->disturbance.y());
  }
  BOOST_CHECK_EQUAL(cycles, 0);
  BOOST_CHECK_GT(least, 0.1);
  BOOST_CHECK(controller.output().fell == Fall::kNone);
}

BOOST_AUTO_TEST_CASE(cycle_in_a_scene_allocates_nothing) {
  const ModelPtr scene = mahru_in_a_scene();
  stays_off_the_heap(walk(1.0, WalkSettings(), scene.get()));
}

BOOST_AUTO_TEST_CASE(cycle_that_silences_servos_allocates_nothing) {
  std::string text = mahru_text();
  for (std::size_t at = text.find("<actuator>"); (at = text.find("<motor class=", at)) < text.find("</actuator>");)
    text.replace(at, text.find(" name=", at) - at, "<position kp=\"300\"");
  const ModelPtr servos = load_text(text);
  stays_off_the_heap(walk(1.0, WalkSettings(), servos.get()));
}
