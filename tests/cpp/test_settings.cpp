#include <cctype>
#include <set>

#include "robots.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/walk/walking_controller.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

/// A controller with one setting changed is refused, and the message says `text`.
template <class Change>
void refused(Change&& change, const std::string& text) {
  WalkSettings s;
  change(s);
  CHECK_THROWS(WalkingController(mahru(), describe(mahru()), s), InputError, text);
}

void refused_profile(const VelocityProfile& profile, const std::string& text,
                     const WalkSettings& settings = WalkSettings()) {
  CHECK_THROWS(WalkingController(mahru(), describe(mahru()), settings, profile), InputError, text);
}

}  // namespace

BOOST_AUTO_TEST_CASE(table_has_every_setting_once_with_names_of_its_own) {
  WalkSettings s;
  std::set<std::string> paths, flats, groups;
  visit_groups(s, [&](auto& group) {
    BOOST_CHECK(groups.insert(group.kGroup).second);
    BOOST_CHECK_MESSAGE(std::string(group.kMeaning).back() == '.', group.kGroup);
    // The members lie side by side: two rows for one, or none for a number, would leave an overlap or a gap of a number's size.
    std::map<const char*, std::size_t> size{{reinterpret_cast<const char*>(&group + 1), 0}};
    visit_group(group, [&](auto& member, const Setting& row) {
      BOOST_CHECK_MESSAGE(size.emplace(reinterpret_cast<const char*>(&member), sizeof(member)).second, row.path());
      BOOST_CHECK_MESSAGE(paths.insert(row.path()).second, row.path());
      BOOST_CHECK_MESSAGE(flats.insert(row.flat).second, row.flat);
    });
    const char* end = reinterpret_cast<const char*>(&group);
    for (const auto& [at, bytes] : size) {
      BOOST_CHECK_MESSAGE(at >= end && at - end < 8, group.kGroup);
      end = at + bytes;
    }
  });
  for (const std::string& group : groups) BOOST_CHECK_MESSAGE(!flats.count(group), group);  // both are attributes
}

BOOST_AUTO_TEST_CASE(every_row_says_in_whole_sentences_what_its_setting_is_for) {
  const WalkSettings s;
  visit_settings(s, [](const auto&, const Setting& row) {
    const std::string text = row.meaning;
    BOOST_CHECK_MESSAGE(text.size() > 30 && text.back() == '.' && std::isupper(text.front()), row.path() + ": " + text);
    BOOST_CHECK_MESSAGE(text.find("efault") == text.npos || row.default_value.from_robot(), row.path());
  });
}

BOOST_AUTO_TEST_CASE(a_default_is_a_number_or_a_rule_and_keeps_its_own_range) {
  const WalkSettings given, s = resolve(given, {0.747, 9.81, 0.001, 0.22});
  visit_settings(given, [&](const auto& value, const Setting& row) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>) {
      BOOST_CHECK_EQUAL(std::isnan(value), row.default_value.from_robot());
    } else {
      BOOST_CHECK_MESSAGE(!row.default_value.from_robot(), row.path());
    }
    BOOST_CHECK_EQUAL(row.default_value.from_robot(), !row.default_value.text().empty());
  });
  visit_settings(s, [&](const auto& value, const Setting& row) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>)
      BOOST_CHECK_MESSAGE(std::isfinite(value) && row.range.holds(value), row.path());
  });
  BOOST_CHECK_EQUAL(Default(1.38, of::kPerTimeConstant).text(), "1.38 / T_c");
  BOOST_CHECK_EQUAL(Default(3600.0, of::kStiffness).text(), "3600 (0.276 s / T_c)^2");
}

BOOST_AUTO_TEST_CASE(the_words_for_a_quantity_are_its_value) {
  const RobotScale robot{1.2, 9.81, 0.002, 0.3};
  const WalkSettings s;
  const Scale scale(robot, s, 0.0);
  const double Tc = std::sqrt(1.2 / 9.81);
  const auto is = [&](const Quantity& q, double value, double tolerance = 1e-12) {
    BOOST_TEST_INFO(q.name);
    CHECK_NEAR(q.times(2.0, scale), 2.0 * value, tolerance);
  };
  is(of::kComHeight, 1.2);
  is(of::kGravity, 9.81);
  is(of::kFroudeSpeed, std::sqrt(9.81 * 1.2));
  is(of::kTimeConstant, Tc);
  is(of::kPerTimeConstant, 1.0 / Tc);
  is(of::kPerTimeConstantSquared, 1.0 / (Tc * Tc), 1e-11);
  is(of::kStepPeriod, 0.8 * std::sqrt(1.2 / 0.747), 2.0 * 0.005);  // it is in hundredths of a second
  is(of::kDamping, 0.276 / Tc, 1e-3);
  is(of::kStiffness, std::pow(0.276 / Tc, 2), 1e-3);
}

BOOST_AUTO_TEST_CASE(a_wrong_name_is_answered_with_the_nearest) {
  const auto answer = [](const std::string& wrong, const std::string& text) {
    BOOST_CHECK_EQUAL(no_such_setting(wrong), "there is no setting '" + wrong + "'; " + text);
  };
  answer("trackr_gain", "did you mean tracking.gain (tracker_gain)?");
  answer("tracking.gian", "did you mean tracking.gain (tracker_gain)?");
  answer("T_sss", "did you mean gait.T_ss?");
  answer("threshold", "did you mean zmp.threshold (zmp_threshold)?");
  answer("trakcing", "did you mean the group tracking?");
  answer("colour_of_the_robot",
         "the groups are gait, steps, swing, com, zmp, tracking, rate, trunk, posture, arms, contact, control, limits, "
         "observer, command and fall");
}

BOOST_AUTO_TEST_CASE(settings_that_break_a_rule_are_refused_with_name_value_and_rule) {
  refused([](auto& s) { s.control.dt = 0.0015; },
          "control.dt (control_dt) = 0.001500 s; it must be a multiple of the model's time step, 0.001000 s");
  refused([](auto& s) { s.control.dt = -0.001; }, "(control_dt) = -0.001");
  refused([](auto& s) { s.gait.T_ds = 0.0; }, "T_ds = 0.000000");
  refused([](auto& s) { s.gait.T_ss = -1.0; }, "T_ss = -1.0");
  refused([](auto& s) { s.com.kp_x = -1.0; }, "com.kp_x (com_x_kp) = -1.000000; it must be finite and not negative");
  refused([](auto& s) { s.swing.kd = INFINITY; }, "swing.kd (swing_kd) = inf");
  refused([](auto& s) { s.zmp.threshold = 0.0; }, "zmp.threshold (zmp_threshold) = 0.000000");
  refused([](auto& s) { s.zmp.max_iterations = 0; }, "zmp.max_iterations = 0; it must be at least 1");
  refused([](auto& s) { s.zmp.sole_fraction = 0.0; }, "sole_fraction = 0.000000");
  refused([](auto& s) { s.steps.mode = Footsteps::kList; }, "needs steps.lengths");
  refused([](auto& s) { s.steps.mode = Footsteps::kList, s.steps.lengths = {0.1, kNaN}; },
          "steps.lengths (step_lengths) = nan");
  refused([](auto& s) { s.control.friction_velocity = 0.0; }, "friction_velocity = 0.000000");
  refused([](auto& s) { s.zmp.lateral_shift = kNaN; }, "zmp.lateral_shift (lateral_reach) = nan");
  refused([](auto& s) { s.steps.capture_distance = -0.01; }, "(capture_reach) = -0.01");
  refused([](auto& s) { s.steps.capture_speed = INFINITY; }, "capture_speed = inf");
  refused([](auto& s) { s.gait.cadence_exponent = -0.4; }, "cadence_exponent = -0.4");
  refused([](auto& s) { s.arms.momentum = 1.5; }, "arms.momentum (momentum_arms) = 1.500000; it must be in 0..1");
  refused([](auto& s) { s.control.singular_task = -0.1; }, "control.singular_task = -0.100000; it must be in 0..1");
}

BOOST_AUTO_TEST_CASE(the_settings_reach_the_solver_of_the_tasks) {
  WalkSettings s;
  BOOST_CHECK_EQUAL(s.control.singular_task, WholeBodyOptions().singular_task);
  s.control.singular_task = 0.02;
  BOOST_CHECK_EQUAL(WalkingController(mahru(), describe(mahru()), s).whole_body().options().singular_task, 0.02);
}

BOOST_AUTO_TEST_CASE(a_profile_that_torque_or_friction_do_not_allow_is_refused_unless_the_settings_let_it_try) {
  const VelocityProfile fast({0.0, 9.0}, {Vec3::Zero(), Vec3(1.5, 0, 0)});
  refused_profile(fast, "the torque of a hip allows (1.");
  WalkSettings s;
  s.command.limit = false;
  BOOST_CHECK_NO_THROW(WalkingController(mahru(), describe(mahru()), s, fast));
  s.command.limit = true;
  s.command.share = 1.5;
  BOOST_CHECK_NO_THROW(WalkingController(mahru(), describe(mahru()), s, fast));
}

BOOST_AUTO_TEST_CASE(a_profile_that_the_legs_cannot_walk_is_refused_with_their_limit) {
  WalkSettings reach_alone;
  reach_alone.command.limit = false;
  const WalkingController controller(mahru(), describe(mahru()));
  const double limit = controller.reach().speed_limit();
  BOOST_CHECK_GT(limit, 0.25);
  refused_profile(VelocityProfile({0.0, 5.0}, {Vec3(0.1, 0, 0), Vec3(1.01 * limit, 0, 0)}),
                  std::to_string(limit) + " m/s straight ahead", reach_alone);
  refused_profile(VelocityProfile({0.0}, {Vec3(-2.0, 0, 0)}), "(v_x, v_y, w_z) = (-2 m/s, 0 m/s",
                  reach_alone);
  refused_profile(VelocityProfile({0.0}, {Vec3(0, 2.0, 0)}), "this robot's legs reach as far as (0 m/s, ",
                  reach_alone);
  refused_profile(VelocityProfile({0.0}, {Vec3(0, 0, 5.0)}), "5 rad/s", reach_alone);
}

BOOST_AUTO_TEST_CASE(a_fast_start_is_refused_only_where_nothing_limits_its_rate) {
  const auto start = [](bool rate_limit) {
    WalkSettings s;
    s.rate.limit = rate_limit;
    s.command.limit = false;
    const VelocityProfile stand({0.0}, {Vec3::Zero()});
    const double limit = WalkingController(mahru(), describe(mahru()), s, stand).reach().speed_limit();
    return WalkingController(mahru(), describe(mahru()), s, VelocityProfile({0.0}, {Vec3(0.99 * limit, 0, 0)}))
        .reach()
        .speed_limit();
  };
  BOOST_CHECK_NO_THROW(start(true));
  CHECK_THROWS(start(false), InputError, "the profile starts too fast");
}

BOOST_AUTO_TEST_CASE(within_reach_is_itself_or_scaled_down_to_the_whole_reach) {
  const WalkingController controller(mahru(), describe(mahru()));
  Numbers numbers(4);
  int scaled = 0;
  for (int n = 0; n < 300; ++n) {
    const Vec3 v = numbers.vector(3, 2.0), to = controller.reach().within(v);
    CHECK_NEAR(to.cross(v), Vec3::Zero(), 1e-9);
    BOOST_CHECK_GE(to.dot(v), 0.0);
    if (to == v) {
      BOOST_CHECK_LE(controller.reach().share(v), 1.0);
    } else {
      CHECK_NEAR(controller.reach().share(to), 1.0, 1e-9);
      ++scaled;
    }
    BOOST_CHECK_LE(controller.reach().share(0.5 * v), controller.reach().share(v));
  }
  BOOST_CHECK(scaled > 50 && scaled < 300);
}

BOOST_AUTO_TEST_CASE(slower_steps_reach_less_speed) {
  WalkSettings s;
  s.gait.cadence_exponent = s.gait.cadence_double = 0.0;  // every step takes the same time: the reach is a length
  const VelocityProfile stand({0.0}, {Vec3::Zero()});
  const WalkingController usual(mahru(), describe(mahru()), s, stand);
  s.gait.T_ss = 1.28;
  s.gait.T_ds = 0.32;
  CHECK_NEAR(WalkingController(mahru(), describe(mahru()), s, stand).reach().speed_limit(),
             usual.reach().speed_limit() * usual.settings().gait.T_ss / 1.28, 1e-9);
}

BOOST_AUTO_TEST_CASE(a_command_that_is_not_finite_is_refused_and_nothing_changes) {
  WalkingController controller(mahru(), describe(mahru()));
  for (const double bad : {kNaN, std::numeric_limits<double>::infinity()})
    CHECK_THROWS(controller.command({0.1, bad, 0}), InputError, "is not finite");
  const MjDataPtr d = make_data(mahru());
  controller.robot().description().place(mahru(), d.get());
  controller.reset(d.get());
  BOOST_CHECK(std::isnan(controller.update(d.get()).command.x()));
}

BOOST_AUTO_TEST_CASE(printed_footsteps_are_reported_as_a_mismatch_before_they_are_walked) {
  WalkSettings printed("paper");
  printed.steps.mode = Footsteps::kPrinted;
  CHECK_NEAR(WalkingController(mahru(), describe(mahru()), printed).plan_mismatch(8.0), 0.0625, 1e-9);
  CHECK_NEAR(WalkingController(mahru(), describe(mahru()), WalkSettings("paper")).plan_mismatch(8.0), 0.0, 1e-3);
  BOOST_CHECK_EQUAL(WalkingController(mahru(), describe(mahru())).plan_mismatch(8.0), 0.0);
}

BOOST_AUTO_TEST_CASE(controller_takes_scale_and_bounds_from_the_robot) {
  const WalkingController controller(mahru(), describe(mahru()));
  const WalkSettings& s = controller.settings();
  CHECK_NEAR(s.gait.T_ss + s.gait.T_ds, 0.8, 0.02);
  CHECK_NEAR(controller.Tc(), std::sqrt(controller.com_height() / 9.81), 1e-12);
  BOOST_CHECK_EQUAL(s.control.dt, mahru()->opt.timestep);
  CHECK_NEAR(s.steps.width, 0.22, 1e-9);
  for (const Side side : kSides) {
    CHECK_NEAR(controller.bounds(side).upper.x(), 0.5 * s.zmp.sole_fraction * 0.25,
               1e-12);  // strong ankles: the sole decides
    CHECK_NEAR(controller.bounds(side).lower.y(), -0.5 * s.zmp.sole_fraction * 0.14, 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(weak_ankles_narrow_the_bounds_and_weaker_ones_leave_no_room) {
  const auto with_ankle = [](double limit) {
    const std::string range = std::to_string(limit);
    return load_text(
        replaced(mahru_text(), "<motor class=\"ankle_pitch\" name=\"l_ankle_pitch\"",
                 "<motor class=\"ankle_pitch\" ctrlrange=\"-" + range + " " + range + "\" name=\"l_ankle_pitch\""));
  };
  const ModelPtr weak = with_ankle(40.0);
  const WalkingController controller(weak.get(), describe(weak.get()));
  const double weight = controller.robot().dynamics().mass * 9.81;
  CHECK_NEAR(controller.bounds(kLeft).upper.x(), controller.robot().ankle_in_sole(kLeft).x() + 0.9 * 40.0 / weight,
             1e-9);
  BOOST_CHECK_LT(controller.bounds(kLeft).upper.x(), controller.bounds(kRight).upper.x());
}
