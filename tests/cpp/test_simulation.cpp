#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "instant.hpp"
#include "walk.hpp"
#include "zmpwalk/math/error.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

/// Largest difference of two records in every column, NaN against NaN counting as none.
double record_gap(const Walk& a, const Walk& b) {
  double worst = a.rows() == b.rows() ? 0.0 : std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < a.recorder.columns().size(); ++c) {
    const auto &x = a.recorder.columns()[c].values, &y = b.recorder.columns()[c].values;
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
      if (!(std::isnan(x[i]) && std::isnan(y[i]))) worst = std::max(worst, gap(x[i], y[i]));
  }
  return worst;
}

}  // namespace

BOOST_AUTO_TEST_CASE(same_inputs_give_the_same_bits) {
  const Walk a(3.0), b(3.0);
  BOOST_CHECK_EQUAL(record_gap(a, b), 0.0);
}

BOOST_AUTO_TEST_CASE(record_has_the_columns_of_the_table_in_its_order_and_each_is_full) {
  const Walk walk(0.05);
  const std::vector<RecordedColumn> table = recorded_columns();
  const std::vector<Column>& record = walk.recorder.columns();
  BOOST_REQUIRE_EQUAL(record.size(), table.size());
  for (std::size_t c = 0; c < table.size(); ++c) {
    BOOST_CHECK_EQUAL(record[c].name, table[c].name);
    BOOST_CHECK_EQUAL(record[c].width, table[c].parts.width(walk.controller.robot().nv()));
    BOOST_CHECK_EQUAL(record[c].values.size(), record[c].width * walk.recorder.rows());
  }
}

BOOST_AUTO_TEST_CASE(last_row_holds_what_the_last_cycle_decided) {
  const Walk walk(0.3);
  const CycleOutput& out = walk.controller.output();
  const long last = walk.rows() - 1;
  BOOST_CHECK_EQUAL(walk.column("t")(last, 0), out.t);
  CHECK_NEAR(walk.column("com").row(last).transpose(), out.com, 0.0);
  CHECK_NEAR(walk.column("tau").row(last).transpose(), out.tau, 0.0);
  CHECK_NEAR(walk.column("foot_right").row(last).transpose(), out.foot[kRight], 0.0);
  CHECK_NEAR(walk.column("qpos").row(last).transpose(), walk.controller.robot().qpos(), 0.0);
}

BOOST_AUTO_TEST_CASE(a_controller_that_is_reset_walks_as_a_new_one) {
  Walk walk(1.5);
  const Walk once(1.0);
  Simulation simulation(walk.controller);
  walk.recorder = Recorder(walk.controller);
  simulation.run(1.0, walk.recorder);
  BOOST_CHECK_EQUAL(record_gap(walk, once), 0.0);
}

BOOST_AUTO_TEST_CASE(a_box_and_a_pendulum_in_the_scene_change_nothing) {
  const ModelPtr scene = mahru_in_a_scene();
  const Walk alone(3.0), third(3.0, WalkSettings(), VelocityProfile::paper(), scene.get());
  CHECK_NEAR(alone.column("com"), third.column("com"), 1e-5);
  CHECK_NEAR(alone.column("support"), third.column("support"), 0.0);
}

BOOST_AUTO_TEST_CASE(control_period_of_four_steps_holds_the_torque) {
  WalkingController controller(mahru(), describe(mahru()), with([](WalkSettings& s) { s.control.dt = 0.004; }));
  const MjDataPtr d = make_data(mahru());
  controller.robot().description().place(mahru(), d.get());
  controller.reset(d.get());
  VecX held;
  for (int k = 0; k < 3000; ++k) {
    const CycleOutput& out = controller.update(d.get());
    BOOST_REQUIRE_EQUAL(out.fresh, k % 4 == 0);
    const Eigen::Map<const VecX> ctrl(d->ctrl, mahru()->nu);
    if (out.fresh) held = ctrl;
    BOOST_REQUIRE_EQUAL(gap(ctrl, held), 0.0);
    mj_step(mahru(), d.get());
  }
  BOOST_CHECK(controller.output().fell == Fall::kNone);
  BOOST_CHECK_EQUAL(controller.output().step, 3);
}

BOOST_AUTO_TEST_CASE(a_state_with_nan_is_refused_and_changes_nothing) {
  WalkingController disturbed(mahru(), describe(mahru())), steady(mahru(), describe(mahru()));
  const MjDataPtr a = make_data(mahru()), b = make_data(mahru());
  for (auto [controller, d] : {std::pair{&disturbed, a.get()}, {&steady, b.get()}}) {
    CHECK_THROWS(controller->update(d), InputError, "before reset");
    controller->robot().description().place(mahru(), d);
    controller->reset(d);
  }
  for (int k = 0; k < 1000; ++k) {
    if (k % 100 == 50) {
      const double good = a->qvel[k % 31];
      const VecX ctrl = Eigen::Map<const VecX>(a->ctrl, mahru()->nu);
      a->qvel[k % 31] = kNaN;
      CHECK_THROWS(disturbed.update(a.get()), InputError, "not finite");
      BOOST_CHECK_EQUAL(disturbed.output().t, steady.output().t);
      CHECK_NEAR(Eigen::Map<const VecX>(a->ctrl, mahru()->nu), ctrl, 0.0);
      a->qvel[k % 31] = good;
    }
    disturbed.update(a.get());
    steady.update(b.get());
    mj_step(mahru(), a.get());
    mj_step(mahru(), b.get());
  }
  CHECK_NEAR(Eigen::Map<const VecX>(a->qpos, 32), Eigen::Map<const VecX>(b->qpos, 32), 0.0);
  a->qpos[3] = kNaN;
  CHECK_THROWS(disturbed.reset(a.get()), InputError, "not finite");
}

BOOST_AUTO_TEST_CASE(without_wrench_distribution_the_paper_law_falls_and_says_when_and_why) {
  const Walk walk(3.0, with([](WalkSettings& s) { s.contact.wrench_distribution = false; }, "paper"));
  BOOST_CHECK(walk.result.fell != Fall::kNone);
  BOOST_CHECK_LT(walk.result.fall_time, 1.5);
  BOOST_CHECK(!to_string(walk.result.fell).empty());
  BOOST_CHECK_EQUAL(walk.column("fell")(walk.rows() - 1, 0), 1.0);
  BOOST_CHECK_EQUAL(walk.column("fell").sum(), 1.0);
  BOOST_CHECK_LT(walk.rows(), 3000);
}

BOOST_AUTO_TEST_CASE(every_end_of_a_walk_has_its_time_and_cause_and_keeps_the_record) {
  const auto ends = [&](const std::function<void(mjData*)>& disturb, const std::vector<Fall>& causes, double longest) {
    WalkSettings s;
    if (causes.front() == Fall::kNoContact) s.fall.height = 1e-3, s.fall.tilt = 4.0;  // nothing else may end it
    WalkingController controller(mahru(), describe(mahru()), s);
    Simulation simulation(controller);
    Recorder recorder(controller);
    bool done = false;
    const RunResult result = simulation.run(
        3.0, recorder,
        [&](double t) {
          if (t > 0.8495 && !std::exchange(done, true)) disturb(static_cast<mjData*>(simulation.data().handle));
          return true;
        },
        0.0);
    BOOST_CHECK_MESSAGE(std::count(causes.begin(), causes.end(), result.fell), to_string(result.fell));
    BOOST_CHECK_GE(result.fall_time, 0.85);
    BOOST_CHECK_LE(result.fall_time, 0.85 + longest);
    BOOST_CHECK_EQUAL(recorder.columns().back().values.size(), 31 * recorder.rows());
    BOOST_CHECK_LE(std::abs(static_cast<double>(recorder.rows()) - 1000.0 * result.fall_time), 1.0);
  };
  mju_user_warning = [](const char*) {};  // no MUJOCO_LOG.TXT
  ends([&](mjData* d) { d->qvel[0] = kNaN; }, {Fall::kNonFinite}, 0.001);
  ends([&](mjData* d) { d->qvel[0] = 1e12; }, {Fall::kNonFinite}, 0.002);  // MuJoCo resets itself
  ends([&](mjData* d) { d->qpos[2] += 0.2; }, {Fall::kNoContact}, 0.11);
  ends([&](mjData* d) { d->qvel[1] = 2.0; }, {Fall::kHeight, Fall::kTilt}, 2.0);  // a shove
}

BOOST_AUTO_TEST_CASE(estimate_is_that_of_the_torque_that_is_sent_when_a_motor_saturates) {
  const ModelPtr weak =
      load_text(replaced(mahru_text(), "<motor ctrlrange=\"-160 160\"/>", "<motor ctrlrange=\"-2 2\"/>"));
  WalkSettings cut;
  cut.limits.keep = false;
  WalkingController controller(weak.get(), describe(weak.get()), cut);
  Instant at(Standing::kBoth, 0);
  at.robot.description().place(mahru(), at.data.get());
  controller.reset(at.data.get());
  const CycleOutput& out = controller.update(at.data.get());
  BOOST_CHECK(out.saturated);
  BOOST_CHECK_GT(out.torque_ratio, 1.0);
  for (const Side side : kSides) CHECK_NEAR(std::abs(out.tau[at.robot.leg_joints()[side][3]]), 2.0, 0.0);
  // What that torque does to the feet, by one linear system.
  at.update();
  const VecX f_c = at.motion(out.tau).second;
  CHECK_NEAR(out.f_c, f_c, 1e-8);
  const Vec3 s = at.dyn().sole[out.support > 0 ? kLeft : kRight].p_WF;
  const Wrench total = total_wrench(f_c, {at.dyn().sole[0].p_WF, at.dyn().sole[1].p_WF}, s);
  CHECK_NEAR(out.zmp_est, s.head<2>() + zmp_of_wrench(total.F, total.M), 1e-10);
}

BOOST_AUTO_TEST_CASE(progress_is_reported_and_can_stop_the_walk) {
  WalkingController controller(mahru(), describe(mahru()));
  Simulation simulation(controller);
  Recorder recorder(controller);
  int calls = 0;
  const RunResult result = simulation.run(5.0, recorder, [&](double t) { return ++calls < 3 || t < 0; }, 1e-4);
  BOOST_CHECK(result.stopped && result.fell == Fall::kNone);
  BOOST_CHECK_EQUAL(calls, 3);
  BOOST_CHECK_GE(recorder.rows(), 3U);
  BOOST_CHECK_LT(recorder.rows(), 5000U);
  CHECK_THROWS(simulation.run(-1.0, recorder), InputError, "duration = -1");
  CHECK_THROWS(simulation.run(kNaN, recorder), InputError, "duration = nan");
}
