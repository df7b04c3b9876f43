#include <algorithm>
#include <cmath>
#include <vector>

#include "testing.hpp"
#include "zmpwalk/gait/schedule.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/settings/settings.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

WalkSettings settings() { return resolve(WalkSettings(), {0.747, 9.81, 0.001, 0.22}); }

/// What `at` says fits what the schedule says of the whole step, and goes on as time does.
void is_consistent(const Schedule& schedule, double t) {
  const GaitPhase now = schedule.at(t);
  const bool single = now.phase == Phase::kSingleSupport;
  CHECK_NEAR(now.duration - now.time, (single ? schedule.touch_down() : schedule.lift_off()) - t, 1e-12);
  CHECK_NEAR(now.to_mid_single, 0.5 * (schedule.lift_off() + schedule.touch_down()) - t, 1e-12);
  CHECK_NEAR(now.to_mid_double, schedule.touch_down() + 0.5 * schedule.times().T_ds - t, 1e-12);
  CHECK_NEAR(schedule.touch_down() - schedule.lift_off(), schedule.times().T_ss, 1e-12);
  if (single) CHECK_NEAR(now.duration, schedule.times().T_ss, 1e-15);
  BOOST_CHECK_GE(now.time, -1e-8);
  BOOST_CHECK_LE(now.time, now.duration + 1e-8);
}

}  // namespace

BOOST_AUTO_TEST_CASE(schedule_is_first_double_support_then_single_and_double_in_turn) {
  Schedule schedule(0.18, 0.16, 0.64);
  const auto is = [&](double t, Phase phase, int step, double time, double duration) {
    while (schedule.landed(t)) schedule.next(schedule.times());
    const GaitPhase at = schedule.at(t);
    BOOST_CHECK(at.phase == phase);
    BOOST_CHECK_EQUAL(at.step, step);
    CHECK_NEAR(at.time, time, 3e-9);
    CHECK_NEAR(at.duration, duration, 1e-15);
  };
  is(0.0, Phase::kDoubleSupport, 0, 0.0, 0.18);
  is(0.18 - 2e-9, Phase::kDoubleSupport, 0, 0.18, 0.18);
  is(0.18 - 0.5e-9, Phase::kSingleSupport, 0, 0.0, 0.64);  // a nanosecond early counts as reached
  is(0.82 - 2e-9, Phase::kSingleSupport, 0, 0.64, 0.64);
  is(0.82, Phase::kDoubleSupport, 1, 0.0, 0.16);
  is(0.98, Phase::kSingleSupport, 1, 0.0, 0.64);
  is(0.18 + 10 * 0.8 + 0.1, Phase::kSingleSupport, 10, 0.1, 0.64);
  CHECK_NEAR(schedule.lift_off(), 8.18, 1e-14);
  CHECK_NEAR(schedule.touch_down(), 8.82, 1e-14);
}

BOOST_AUTO_TEST_CASE(schedule_counts_down_to_the_middles_of_the_coming_phases) {
  Schedule schedule(0.18, 0.16, 0.64);
  CHECK_NEAR(schedule.at(0.0).to_mid_single, 0.18 + 0.32, 1e-12);
  CHECK_NEAR(schedule.at(0.0).to_mid_double, 0.18 + 0.64 + 0.08, 1e-12);
  CHECK_NEAR(schedule.at(0.6).to_mid_single, -0.1, 1e-12);
  CHECK_NEAR(schedule.at(0.6).to_mid_double, 0.3, 1e-12);
  schedule.next(schedule.times());
  CHECK_NEAR(schedule.at(0.9).to_mid_double, 0.8, 1e-12);  // in double support: the one after this
}

BOOST_AUTO_TEST_CASE(a_step_ends_with_its_own_double_support_whatever_the_next_one_takes) {
  Schedule schedule(0.18, 0.16, 0.64);
  schedule.next({0.05, 0.45});
  CHECK_NEAR(schedule.at(0.9).duration, 0.16, 1e-15);
  CHECK_NEAR(schedule.lift_off(), 0.98, 1e-12);
  CHECK_NEAR(schedule.touch_down(), 1.43, 1e-12);
  schedule.next({0.1, 0.7});
  CHECK_NEAR(schedule.lift_off(), 1.48, 1e-12);
  CHECK_NEAR(schedule.at(1.5).to_mid_double, 1.48 + 0.7 + 0.05 - 1.5, 1e-12);
  schedule.begin(3, 5.0, 0.2, {0.16, 0.64});  // again, from a stand
  BOOST_CHECK_EQUAL(schedule.at(5.1).step, 3);
  CHECK_NEAR(schedule.at(5.1).time, 0.1, 1e-12);
  CHECK_NEAR(schedule.lift_off(), 5.2, 1e-12);
}

BOOST_AUTO_TEST_CASE(phases_last_the_same_number_of_cycles_however_times_are_summed) {
  Schedule schedule(0.18, 0.16, 0.64);
  double t = 0.0;
  std::vector<int> cycles{0};
  Phase phase = Phase::kDoubleSupport;
  for (int k = 0; k < 60000; ++k, t += 0.001) {
    if (schedule.landed(t)) schedule.next(schedule.times());
    const GaitPhase now = schedule.at(t);
    if (now.phase != phase) cycles.push_back(0);
    phase = now.phase;
    ++cycles.back();
  }
  BOOST_CHECK_EQUAL(cycles[0], 180);
  for (std::size_t i = 1; i + 1 < cycles.size(); ++i) BOOST_CHECK_EQUAL(cycles[i], i % 2 ? 640 : 160);
}

BOOST_AUTO_TEST_CASE(faster_walks_take_longer_steps_then_faster_ones_with_shorter_double_supports_without_a_jump) {
  const WalkSettings s = settings();
  const Cadence cadence{{s.gait.T_ds, s.gait.T_ss},
                        s.gait.cadence_speed,
                        s.gait.cadence_exponent,
                        s.gait.cadence_double,
                        {1.0, 3.0, 0.4}};
  const double eps = 1e-9;
  for (const Vec3& along : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1.0 / 3, 0), Vec3(0, 0, -2.5)}) {
    StepTimes before = cadence.times(Vec3::Zero());
    BOOST_CHECK_EQUAL(before.period(), s.gait.T_ds + s.gait.T_ss);
    for (double v = 0.01; v < 1.5; v += 0.01) {
      const StepTimes now = cadence.times(v * along);
      if (v <= s.gait.cadence_speed) {
        BOOST_CHECK_EQUAL(now.T_ss, s.gait.T_ss);
        BOOST_CHECK_EQUAL(now.T_ds, s.gait.T_ds);
      } else {
        BOOST_CHECK_LT(now.period(), before.period());
        BOOST_CHECK_LT(now.T_ds / now.period(), before.T_ds / before.period());
      }
      BOOST_CHECK_GT(v * now.period(), (v - 0.01) * before.period());  // steps still grow longer
      before = now;
    }
    CHECK_NEAR(cadence.times((1 + eps) * s.gait.cadence_speed * along).T_ds, s.gait.T_ds, eps);
    CHECK_NEAR(cadence.times((1 + eps) * s.gait.cadence_speed * along).T_ss, s.gait.T_ss, eps);
  }
}

BOOST_AUTO_TEST_CASE(schedule_refuses_phases_without_length) {
  CHECK_THROWS(Schedule(0.0, 0.16, 0.64), InputError, "T_ds_first = 0.000000");
  CHECK_THROWS(Schedule(0.18, -1, 0.64), InputError, "T_ds = -1");
  CHECK_THROWS(Schedule(0.18, 0.16, kNaN), InputError, "T_ss = nan");
}

BOOST_AUTO_TEST_CASE(an_early_landing_makes_the_rest_of_the_swing_double_support_and_keeps_the_next_lift_off) {
  Schedule schedule(0.18, 0.16, 0.64);
  const double t = 0.82 - 0.06;
  BOOST_CHECK(!schedule.landed(t));
  schedule.land(t);
  BOOST_CHECK(schedule.landed(t));
  is_consistent(schedule, t);
  schedule.next({0.16, 0.64});
  const GaitPhase now = schedule.at(t);
  BOOST_CHECK(now.phase == Phase::kDoubleSupport);
  CHECK_NEAR(now.time, 0.0, 1e-12);
  CHECK_NEAR(now.duration, 0.16 + 0.06, 1e-12);
  CHECK_NEAR(schedule.lift_off(), 0.98, 1e-12);
  CHECK_NEAR(now.to_mid_single, 0.98 + 0.32 - t, 1e-12);
  CHECK_NEAR(schedule.times().T_ds, 0.16, 1e-15);  // of the step after this: nothing is left of the event
  CHECK_NEAR(schedule.touch_down(), 0.98 + 0.64, 1e-12);
}

BOOST_AUTO_TEST_CASE(a_late_landing_prolongs_the_single_support_and_keeps_the_length_of_the_double_support) {
  Schedule schedule(0.18, 0.16, 0.64);
  double t = 0.82;
  for (; t < 0.88 - 1e-9; t += 0.001) {
    BOOST_CHECK(schedule.landed(t));
    schedule.wait(t + 0.001);
    BOOST_CHECK(!schedule.landed(t));
    is_consistent(schedule, t);
  }
  CHECK_NEAR(schedule.waited(), 0.06, 1e-9);
  schedule.land(t);
  BOOST_CHECK(schedule.landed(t));
  schedule.next({0.16, 0.64});
  CHECK_NEAR(schedule.at(t).duration, 0.16, 1e-9);
  CHECK_NEAR(schedule.lift_off(), 0.98 + 0.06, 1e-9);
  BOOST_CHECK_EQUAL(schedule.waited(), 0.0);
  schedule.wait(0.5);  // before the touch-down that is planned anyway
  CHECK_NEAR(schedule.touch_down(), 0.98 + 0.06 + 0.64, 1e-9);
}

BOOST_AUTO_TEST_CASE(a_phase_takes_another_time_and_what_comes_after_it_keeps_its_length) {
  for (const double factor : {0.7, 1.0, 1.3}) {
    Schedule single(0.18, 0.16, 0.64), both(0.18, 0.16, 0.64);
    single.retime(0.5, factor * 0.64 - 0.32);
    is_consistent(single, 0.5);
    CHECK_NEAR(single.at(0.5).duration, factor * 0.64, 1e-12);
    CHECK_NEAR(single.at(0.5).time, 0.32, 1e-12);
    CHECK_NEAR(single.touch_down(), 0.18 + factor * 0.64, 1e-12);
    single.next({0.16, 0.64});
    CHECK_NEAR(single.lift_off(), 0.18 + factor * 0.64 + 0.16, 1e-12);
    both.next({0.16, 0.64});
    both.retime(0.9, factor * 0.16 - 0.08);
    is_consistent(both, 0.9);
    CHECK_NEAR(both.at(0.9).duration, factor * 0.16, 1e-12);
    CHECK_NEAR(both.lift_off(), 0.82 + factor * 0.16, 1e-12);
    CHECK_NEAR(both.touch_down(), both.lift_off() + 0.64, 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(a_time_that_stays_what_it_was_changes_no_bit) {
  Schedule schedule(0.18, 0.16, 0.64);
  const double lift_off = schedule.lift_off(), touch_down = schedule.touch_down();
  for (double t = 0.0; t < 0.8; t += 0.013) schedule.retime(t, (t < lift_off ? lift_off : touch_down) - t + 1e-12);
  BOOST_CHECK_EQUAL(schedule.lift_off(), lift_off);
  BOOST_CHECK_EQUAL(schedule.touch_down(), touch_down);
}

BOOST_AUTO_TEST_CASE(times_stay_consistent_through_any_run_of_events) {
  Numbers numbers(11);
  Schedule schedule(0.18, 0.16, 0.64);
  int landings = 0;
  for (double t = 0.0; t < 60.0; t += 0.002) {
    if (schedule.landed(t)) {
      if (numbers.uniform(0, 1) < 0.5 && schedule.waited() < 0.05) {
        schedule.wait(t + 0.002);
      } else {
        schedule.next({numbers.uniform(0.05, 0.2), numbers.uniform(0.3, 0.7)});
        ++landings;
      }
    }
    const GaitPhase now = schedule.at(t);
    is_consistent(schedule, t);
    const double remaining = now.duration - now.time;
    if (remaining > 0.01 && numbers.uniform(0, 1) < 0.01) schedule.retime(t, numbers.uniform(0.7, 1.3) * remaining);
    if (now.phase == Phase::kSingleSupport && now.time > 0.2 && numbers.uniform(0, 1) < 0.002) {
      const double lift_off_after = schedule.touch_down() + schedule.times().T_ds;
      schedule.land(t);
      CHECK_NEAR(schedule.touch_down() + schedule.times().T_ds, lift_off_after, 1e-12);
    }
    is_consistent(schedule, t);
  }
  BOOST_CHECK_GT(landings, 40);
}

BOOST_AUTO_TEST_CASE(a_foot_that_has_not_lifted_does_not_land_and_a_phase_takes_a_time) {
  Schedule schedule(0.18, 0.16, 0.64);
  schedule.land(0.1);
  CHECK_NEAR(schedule.touch_down(), 0.82, 1e-15);
  CHECK_THROWS(schedule.retime(0.1, 0.0), InputError, "remaining = 0.000000");
  CHECK_THROWS(schedule.retime(0.1, kNaN), InputError, "remaining = nan");
  CHECK_NEAR(schedule.lift_off(), 0.18, 1e-15);
}
