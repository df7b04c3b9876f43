#include <mujoco/mujoco.h>

#include <cmath>

#include "testing.hpp"
#include "walk.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/simulation/push.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

Push push(double t, double duration, const std::string& body, const Vec3& force, const Vec3& torque = Vec3::Zero()) {
  Push out{t, duration, body, Vec6::Zero()};
  out.wrench << force, torque;
  return out;
}

int body(const char* name) { return mj_name2id(mahru(), mjOBJ_BODY, name); }
Vec6 applied(const mjData* d, int b) { return Eigen::Map<const Vec6>(d->xfrc_applied + 6 * b); }

}  // namespace

BOOST_AUTO_TEST_CASE(a_push_acts_in_the_steps_that_begin_within_it_and_then_is_gone) {
  const Robot robot(mahru(), describe(mahru()));
  const MjDataPtr d = make_data(mahru());
  Pushes pushes(robot);
  pushes.add(push(0.1, 0.08, "torso", {1, 2, 3}, {4, 5, 6}));
  const double dt = robot.timestep();
  int steps = 0;
  for (double t = 0.0; t < 0.3; t += dt) {  // a clock that adds up its rounding
    pushes.apply(t, d.get());
    const Vec6 wrench = applied(d.get(), body("torso"));
    if (wrench.isZero(0.0)) continue;
    ++steps;
    BOOST_CHECK(t > 0.1 - dt / 2 && t < 0.18 - dt / 2);
    CHECK_NEAR(wrench, (Vec6() << 1, 2, 3, 4, 5, 6).finished(), 0.0);
  }
  BOOST_CHECK_EQUAL(steps, 80);
}

BOOST_AUTO_TEST_CASE(pushes_on_one_body_add_up) {
  const Robot robot(mahru(), describe(mahru()));
  const MjDataPtr d = make_data(mahru());
  Pushes pushes(robot);
  pushes.add(push(0.0, 0.2, "pelvis", {1, 0, 0}));
  pushes.add(push(0.1, 0.2, "pelvis", {0, 1, 0}));
  pushes.apply(0.15, d.get());
  CHECK_NEAR(applied(d.get(), body("pelvis")).head<3>(), Vec3(1, 1, 0), 0.0);
}

BOOST_AUTO_TEST_CASE(without_a_push_nothing_is_written) {
  const Robot robot(mahru(), describe(mahru()));
  const MjDataPtr d = make_data(mahru());
  d->xfrc_applied[6 * body("torso")] = 7.0;
  Pushes(robot).apply(0.0, d.get());
  BOOST_CHECK_EQUAL(d->xfrc_applied[6 * body("torso")], 7.0);
}

BOOST_AUTO_TEST_CASE(the_trunk_is_the_first_body_of_that_name_in_any_case_or_the_root) {
  BOOST_CHECK_EQUAL(trunk_body(Robot(mahru(), describe(mahru()))), body("torso"));
  const ModelPtr named = load_text(replaced(mahru_text(), "\"torso\"", "\"Upper_TRUNK\""));
  BOOST_CHECK_EQUAL(trunk_body(Robot(named.get(), describe(named.get()))),
                    mj_name2id(named.get(), mjOBJ_BODY, "Upper_TRUNK"));
  const ModelPtr without = load_text(replaced(mahru_text(), "\"torso\"", "\"chest\""));
  const Robot robot(without.get(), describe(without.get()));
  BOOST_CHECK_EQUAL(trunk_body(robot), robot.root_body());
}

BOOST_AUTO_TEST_CASE(a_push_that_makes_no_sense_is_refused_and_changes_nothing) {
  const Robot robot(mahru(), describe(mahru()));
  const MjDataPtr d = make_data(mahru());
  Pushes pushes(robot);
  CHECK_THROWS(pushes.add(push(-0.1, 0.1, "", {1, 0, 0})), InputError, "at least 0");
  CHECK_THROWS(pushes.add(push(kNaN, 0.1, "", {1, 0, 0})), InputError, "finite");
  CHECK_THROWS(pushes.add(push(0.0, 0.0005, "", {1, 0, 0})), InputError, "timestep");
  CHECK_THROWS(pushes.add(push(0.0, 0.1, "", {kNaN, 0, 0})), InputError, "finite");
  CHECK_THROWS(pushes.add(push(0.0, 0.1, "tail", {1, 0, 0})), InputError, "l_thigh");
  CHECK_THROWS(pushes.add(push(0.0, 0.1, "world", {1, 0, 0})), InputError, "'world'");
  pushes.apply(0.0, d.get());
  for (int i = 0; i < 6 * mahru()->nbody; ++i) BOOST_REQUIRE_EQUAL(d->xfrc_applied[i], 0.0);
}

BOOST_AUTO_TEST_CASE(an_alarm_is_not_the_end_where_the_walk_goes_on) {
  const auto ends = [](OnFall on_fall) {
    WalkingController controller(mahru(), describe(mahru()));
    Simulation simulation(controller);
    Recorder recorder(controller);
    simulation.push(push(1.0, 0.08, "", {0, 1500, 0}));
    return simulation.run(5.0, recorder, {}, 0.1, {}, 0.0, on_fall);
  };
  const RunResult stops = ends(OnFall::kStop), goes_on = ends(OnFall::kGoOn);
  BOOST_CHECK(stops.alarm == Fall::kLost && stops.alarm == goes_on.alarm);
  BOOST_CHECK_EQUAL(stops.alarm_time, goes_on.alarm_time);
  BOOST_CHECK(goes_on.fell == Fall::kDown);
  BOOST_CHECK_GT(stops.fall_time, goes_on.alarm_time + 0.1);
  BOOST_CHECK_GT(goes_on.fall_time, stops.fall_time);
  BOOST_CHECK_LT(goes_on.fall_time, 3.0);
}

BOOST_AUTO_TEST_CASE(a_walk_in_two_stretches_is_the_walk_in_one) {
  const Walk once(2.0);
  WalkingController controller(mahru(), describe(mahru()));
  Simulation simulation(controller);
  Recorder recorder(controller);
  simulation.run(0.7, recorder);
  simulation.run(1.3, recorder);
  BOOST_CHECK_EQUAL(recorder.rows(), once.recorder.rows());
  for (std::size_t c = 0; c < recorder.columns().size(); ++c) {
    const auto &x = recorder.columns()[c].values, &y = once.recorder.columns()[c].values;
    BOOST_CHECK(std::equal(x.begin(), x.end(), y.begin(), y.end(),
                           [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }));
  }
}
