#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "walk.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

/// Sorted |values|, at share `p`.
double percentile(const VecX& values, double p) {
  std::vector<double> sorted;
  for (const double v : values)
    if (!std::isnan(v)) sorted.push_back(std::abs(v));
  std::sort(sorted.begin(), sorted.end());
  return sorted.at(static_cast<std::size_t>(p * (sorted.size() - 1)));
}

const Walk& default_walk() {
  static const Walk walk(10.0);
  return walk;
}

const Walk& paper_walk() {
  static const Walk walk(10.0, WalkSettings("paper"));
  return walk;
}

/// A walk at 0.25 m/s in a loop of its own, step by step.
struct Stepped {
  Fall fell = Fall::kNone;
  int steps = 0, switches = 0;
  std::vector<double> landings, singles, doubles;  ///< when feet land, how long finished supports took [s]
  // Largest, from cycle to cycle: what the swing target's velocity and position gain beside what acceleration and velocity have them gain;
  // and how far the sole is from its target.
  double v = 0.0, p = 0.0, off = 0.0;
};

/// @param between  called after each cycle
Stepped walk_steps(const mjModel* m, const WalkSettings& s, double duration,
                   const std::function<void(WalkingController&)>& between) {
  WalkingController controller(m, describe(m), s, VelocityProfile({0.0}, {Vec3(0.25, 0, 0)}));
  const MjDataPtr d = make_data(m);
  controller.robot().description().place(m, d.get());
  controller.reset(d.get());
  Stepped out;
  GaitPhase last;
  Side support = kRight;
  SwingTarget before;
  const double dt = controller.settings().control.dt;
  while (d->time < duration && out.fell == Fall::kNone) {
    out.fell = controller.update(d.get()).fell;
    mj_step(m, d.get());
    const GaitOutput& gait = controller.gait();
    const bool single = gait.phase.phase == Phase::kSingleSupport, was_single = last.phase == Phase::kSingleSupport;
    if (single != was_single) (was_single ? out.singles : out.doubles).push_back(last.time + dt);
    if (was_single && !single) out.landings.push_back(d->time);
    out.switches += gait.support != support;
    support = gait.support;
    out.steps = gait.phase.step;
    const SwingTarget& target = gait.swing_target;
    if (single) out.off = std::max(out.off, gap(controller.robot().dynamics().sole[gait.swing].p_WF, target.p));
    if (single && was_single) {
      out.v = std::max(out.v, gap(target.v - before.v, 0.5 * dt * (target.a + before.a)));
      out.p = std::max(out.p, gap(target.p - before.p, 0.5 * dt * (target.v + before.v)));
    }
    before = target;
    last = gait.phase;
    between(controller);
  }
  return out;
}

/// One phase of step 5 takes `duration` of what it was to take, from its middle on.
Stepped retimed(Phase phase, const std::function<double(double)>& duration) {
  bool done = false;
  return walk_steps(mahru(), WalkSettings(), 8.0, [&](WalkingController& controller) {
    const GaitPhase& now = controller.gait().phase;
    if (done || now.step != 5 || now.phase != phase || now.time < 0.5 * now.duration) return;
    controller.retime(duration(now.duration) - now.time);
    done = true;
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(default_law_stands_for_ten_seconds_without_torque_or_joint_limits) {
  const Walk& walk = default_walk();
  BOOST_REQUIRE_MESSAGE(walk.result.fell == Fall::kNone,
                        to_string(walk.result.fell) + " at " + std::to_string(walk.result.fall_time));
  BOOST_CHECK_EQUAL(walk.rows(), 10000);
  BOOST_CHECK_EQUAL(walk.result.cycle_us.size(), 10000U);
  CHECK_NEAR(walk.column("saturated"), RowMatX::Zero(walk.rows(), 1), 0.0);
  CHECK_NEAR(walk.column("damped"), RowMatX::Zero(walk.rows(), 1), 0.0);
  CHECK_NEAR(walk.column("self_contacts"), RowMatX::Zero(walk.rows(), 1), 0.0);
  BOOST_CHECK_LT(walk.column("torque_ratio").maxCoeff(), 1.0);
  BOOST_CHECK_GT(walk.column("joint_margin").minCoeff(), 0.05);
  BOOST_CHECK_EQUAL(walk.column("step")(walk.rows() - 1, 0), 12);
}

BOOST_AUTO_TEST_CASE(com_advances_by_the_plan_in_every_period) {
  const Walk& walk = default_walk();
  for (int k = 0; k < 12; ++k) {
    const double plan = walk.controller.profile().displacement(0.8 * k, 0.8 * (k + 1)).x();
    CHECK_NEAR(walk.com_x(0.8 * (k + 1)) - walk.com_x(0.8 * k), plan, 0.002 * plan);
  }
}

BOOST_AUTO_TEST_CASE(estimated_zmp_is_the_measured_one) {
  const Walk& walk = default_walk();
  const RowMatX error = walk.column("zmp_est") - walk.column("zmp_meas");
  const VecX single = walk.column("phase");
  for (int i = 0; i < 2; ++i) {
    BOOST_CHECK_LE(percentile(error.col(i), 0.5), 1e-5);
    BOOST_CHECK_LE(percentile((single.array() > 0).select(error.col(i), kNaN), 0.95), 5e-5);
  }
}

BOOST_AUTO_TEST_CASE(expected_contact_wrench_is_the_measured_one_in_single_support) {
  const Walk& walk = default_walk();
  const VecX single = walk.column("phase"), support = walk.column("support");
  const RowMatX error = walk.column("f_c") - walk.column("contact_wrench");
  for (const Side side : kSides)
    for (int i = 0; i < 6; ++i) {
      const VecX column = error.col(6 * side + i);
      BOOST_CHECK_LE(percentile((single.array() * support.array() * side_sign(side) > 0).select(column, kNaN), 0.5),
                     0.05);
    }
}

BOOST_AUTO_TEST_CASE(estimate_stays_inside_its_bounds_to_the_threshold_in_single_support) {
  const Walk& walk = default_walk();
  const auto est = walk.column("zmp_est"), lower = walk.column("zmp_lower"), upper = walk.column("zmp_upper");
  const VecX single = walk.column("phase");
  for (int i = 0; i < 2; ++i) {
    const VecX beyond = (lower.col(i) - est.col(i)).cwiseMax(est.col(i) - upper.col(i));
    BOOST_CHECK_LE((single.array() > 0).select(beyond, -1.0).maxCoeff(), walk.controller.settings().zmp.threshold);
  }
}

BOOST_AUTO_TEST_CASE(com_height_and_trunk_keep_still) {
  const VecX z = default_walk().column("com").col(2);
  BOOST_CHECK_LE(z.maxCoeff() - z.minCoeff(), 2e-3);
}

BOOST_AUTO_TEST_CASE(paper_law_walks_its_experiment) {
  const Walk& walk = paper_walk();
  BOOST_REQUIRE_MESSAGE(walk.result.fell == Fall::kNone,
                        to_string(walk.result.fell) + " at " + std::to_string(walk.result.fall_time));
  for (int k = 0; k < 12; ++k) {
    const double plan = walk.controller.profile().displacement(0.8 * k, 0.8 * (k + 1)).x();
    CHECK_NEAR(walk.com_x(0.8 * (k + 1)) - walk.com_x(0.8 * k), plan, 0.01 * plan);
  }
}

BOOST_AUTO_TEST_CASE(estimate_is_the_desired_zmp_wherever_the_reference_was_found) {
  const RowMatX exact = default_walk().column("zmp_est") - default_walk().column("zmp_des");
  CHECK_NEAR(exact, RowMatX::Zero(10000, 2), 1e-9);  // closed form
  BOOST_CHECK_GT(default_walk().column("zmp_modified").cwiseAbs().sum(), 500.0);
  const RowMatX loop = paper_walk().column("zmp_est") - paper_walk().column("zmp_des");
  CHECK_NEAR(loop, RowMatX::Zero(10000, 2), paper_walk().controller.settings().zmp.threshold);
}

BOOST_AUTO_TEST_CASE(loop_of_a_walk_takes_as_many_passes_as_its_slope_says) {
  const Walk& walk = paper_walk();
  const auto passes = walk.column("iterations"), des = walk.column("zmp_des"), first = walk.column("zmp_first"),
             slope = walk.column("zmp_slope");
  BOOST_CHECK_GT(passes.maxCoeff(), 20.0);  // k_d dt = 0.04: each pass takes a few per cent of the error
  for (long k = 0; k < walk.rows(); ++k) {
    if (passes(k, 0) == 0.0) continue;
    const double e_0 = std::abs(des(k, 0) - first(k, 0)), rate = std::log(std::abs(1.0 - slope(k, 0)));
    const double expected =
        1.0 + std::max(0.0, std::ceil(std::log(walk.controller.settings().zmp.threshold / e_0) / rate));
    BOOST_REQUIRE_LE(std::abs(passes(k, 0) - expected), 1.0);
  }
}

BOOST_AUTO_TEST_CASE(textbook_equations_walk_the_same_walk) {
  const Walk direct(1.2), textbook(1.2, with([](WalkSettings& s) { s.control.textbook = true; }));
  CHECK_NEAR(direct.column("com"), textbook.column("com"), 1e-6);
  CHECK_NEAR(direct.column("zmp_est"), textbook.column("zmp_est"), 1e-4);
}

BOOST_AUTO_TEST_CASE(a_phase_that_takes_another_time_leaves_the_swing_foot_smooth_and_the_robot_walking) {
  const auto times = [](double factor) { return [factor](double T) { return factor * T; }; };
  const auto plus = [](double later) { return [later](double T) { return T + later; }; };
  struct Event {
    const char* what;
    Phase phase;
    std::function<double(double)> duration;
  };
  for (const Event& event : {Event{"single support - 30 %", Phase::kSingleSupport, times(0.7)},
                             Event{"single support + 30 %", Phase::kSingleSupport, times(1.3)},
                             Event{"landing 60 ms early", Phase::kSingleSupport, plus(-0.06)},
                             Event{"landing 60 ms late", Phase::kSingleSupport, plus(0.06)},
                             Event{"double support - 30 %", Phase::kDoubleSupport, times(0.7)},
                             Event{"double support + 30 %", Phase::kDoubleSupport, times(1.3)}})
    BOOST_TEST_CONTEXT(event.what) {
      const Stepped walk = retimed(event.phase, event.duration);
      const bool single = event.phase == Phase::kSingleSupport;
      BOOST_CHECK(walk.fell == Fall::kNone);
      BOOST_CHECK_GE(walk.steps, 9);
      BOOST_CHECK_LE(std::abs(walk.switches - walk.steps), 1);
      CHECK_NEAR((single ? walk.singles : walk.doubles).at(5), event.duration(single ? 0.64 : 0.16), 2e-3);
      BOOST_CHECK_LE(walk.v, 5e-5);  // an acceleration that jumps by 0.1 m/s^2 shows here
      BOOST_CHECK_LE(walk.p, 5e-7);
      BOOST_CHECK_LE(walk.off, 0.01);
    }
}

BOOST_AUTO_TEST_CASE(steps_that_end_by_measured_contact_are_those_that_end_by_time_on_ground_that_is_as_planned) {
  const auto landings = [](TouchDown touch_down) {
    const Stepped walk = walk_steps(mahru(), with([&](WalkSettings& w) { w.gait.touch_down = touch_down; }), 8.0,
                                    [](WalkingController&) {});
    BOOST_CHECK_EQUAL(walk.landings.size(), 9U);
    return walk.landings;
  };
  const std::vector<double> by_time = landings(TouchDown::kTime), by_contact = landings(TouchDown::kContact);
  for (std::size_t n = 0; n < std::min(by_time.size(), by_contact.size()); ++n)
    CHECK_NEAR(by_contact[n], by_time[n], 0.02);
}

BOOST_AUTO_TEST_CASE(feet_that_feel_the_ground_walk_up_and_down_a_step_of_5_mm_and_their_swing_stays_smooth) {
  const std::string box = "<worldbody><geom type=\"box\" size=\"1 1 0.1\" pos=\"", floor = "type=\"plane\"";
  const auto up = load_text(replaced(mahru_text(), "<worldbody>", box + "1.68 0 -0.095\"/>"));
  const auto down = load_text(
      replaced(replaced(mahru_text(), floor, floor + " pos=\"0 0 -0.005\""), "<worldbody>", box + "-0.32 0 -0.1\"/>"));
  for (const mjModel* m : {up.get(), down.get()}) {
    const WalkSettings s = with([](WalkSettings& w) { w.gait.touch_down = TouchDown::kContact; });
    const Stepped walk = walk_steps(m, s, 9.0, [](WalkingController&) {});
    BOOST_CHECK(walk.fell == Fall::kNone);
    const double shortest = *std::min_element(walk.singles.begin(), walk.singles.end()),
                 longest = *std::max_element(walk.singles.begin(), walk.singles.end());
    if (m == up.get())
      BOOST_CHECK_LE(shortest, 0.62);  // it lands early on the step
    else
      BOOST_CHECK_GE(longest, 0.66);  // and late beyond its edge
    BOOST_CHECK_LE(walk.v, 5e-5);
    BOOST_CHECK_LE(walk.p, 5e-7);
  }
}
